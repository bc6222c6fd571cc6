// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/volume_kernel.h"
#include "solver/volumetric_equations.h"

#include <functional>
#include <memory>
#include <string>

namespace Signorini
{
  /// The equations of the volumetric stress in displacement-pressure form, at small and finite
  /// strain (doc/theory, 6.6).
  template <int dim>
  class VolumeConstraint : public VolumetricEquations
  {
  public:
    /// Make the equations; null if no body is in displacement-pressure form. Keeps a reference to
    /// elasticity. Collective.
    static std::unique_ptr<VolumeConstraint<dim>>
    create(Elasticity<dim> &elasticity);

    explicit VolumeConstraint(Elasticity<dim> &elasticity);

    /// Set C_m and the diagonal of the Schur complement, which at finite strain depend on
    /// temperatures; to be called when these have changed. Collective.
    void
    set_compliance();

    void
    extrapolate_from(const LA::Vector &u) override;
    LA::Vector
    residual(const LA::Vector &u) const override;
    /// The first time, throws SceneError where nothing determines the pressure of a body.
    void
    linearise(const LA::Vector &u) override;
    LA::Vector
    coefficients() const override
    {
      return elasticity.volumetric_stress().coefficients();
    }

    void
    add(double factor, const LA::Vector &dm) override;
    void
    subtract_forces(LA::Vector &r) const override;

    const VolumetricCoupling &
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

    /// Call visit(cell) for the locally owned cells of bodies in displacement-pressure form; it
    /// returns whether the cell is inverted. Throws SolverFailure then. Collective.
    void
    for_cells(const std::function<bool(const Cell &cell)> &visit) const;
    /// Whether the displacement of no vertex of a simplex is free, or of no node at all.
    enum class Hold
    {
      none,
      vertices,
      nodes
    };
    Hold
    hold(const Cell &cell) const;
    /// The part of a cell in C_m.
    typename VolumetricStress<dim>::MassMatrix
    compliance(const Cell &cell) const;
    /// Set the sparsity patterns of B_m and C_m.
    void
    make_pattern();
    /// Throws SceneError if an incompressible body is constrained on its whole surface, so that its
    /// pressure is determined only up to a constant.
    void
    check_determined() const;

    Elasticity<dim>                        &elasticity;
    const dealii::AffineConstraints<double> free; ///< of coefficients: none
    VolumetricCoupling                      my_coupling;
    LA::Vector                              origin; ///< see extrapolate_from(); empty: none
    bool                                    is_linearised = false;
    unsigned int                            my_version    = 0;
    mutable VolumeKernel<dim>               kernel;
  };
} // namespace Signorini
