#pragma once

#include "solid/volume_kernel.h"
#include "solver/bulk_equations.h"

#include <functional>
#include <memory>
#include <string>

namespace Signorini
{
  /// The equations of Elasticity's bulk stress, of small and large deformation.
  template <int dim>
  class BulkBalance : public BulkEquations
  {
  public:
    /// Null if no body is mixed. Refers to elasticity. Collective.
    static std::unique_ptr<BulkBalance<dim>>
    create(Elasticity<dim> &elasticity);

    explicit BulkBalance(Elasticity<dim> &elasticity);

    void
    start_from(const LA::Vector &u) override;
    LA::Vector
    residual(const LA::Vector &u) const override;
    /// The first time, throws SceneError where nothing determines the pressure of a body.
    void
    linearise(const LA::Vector &u) override;
    LA::Vector
    coefficients() const override
    {
      return elasticity.bulk_stress().coefficients();
    }

    void
    add(double factor, const LA::Vector &dm) override;
    void
    subtract_forces(LA::Vector &r) const override;

    const BulkCoupling &
    coupling() const override
    {
      return my_coupling;
    }

    unsigned int
    version() const override
    {
      return my_version;
    }

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Calls visit(cell) for the locally owned cells of mixed bodies, which tells whether it is
    /// folded. Throws SolverFailure then. Collective.
    void
    for_cells(const std::function<bool(const Cell &cell)> &visit) const;
    void
    make_pattern();
    /// The pressure of an incompressible body is known up to a constant only where supports leave
    /// its surface nowhere free to move outwards.
    void
    check_determined() const;

    Elasticity<dim>                        &elasticity;
    const dealii::AffineConstraints<double> free; ///< of coefficients: none
    BulkCoupling                            my_coupling;
    LA::Vector                              origin; ///< see start_from(); empty: none
    bool                                    is_linearised = false;
    unsigned int                            my_version    = 0;
    mutable VolumeKernel<dim>               kernel;
  };
} // namespace Signorini
