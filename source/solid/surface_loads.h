// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include <signorini/solid/boundary_conditions.h>
#include <signorini/solid/model.h>

#include <deal.II/hp/fe_collection.h>

#include <map>

namespace Signorini
{
  /// What all loads exert together at a place of a boundary.
  template <int dim>
  struct SurfaceLoad
  {
    dealii::Tensor<1, dim> traction;     ///< [force/area at rest], which does not turn
    double                 pressure = 0; ///< [force/area], positive pushes into the body

    /// The force per area of a surface with that outward normal.
    dealii::Tensor<1, dim>
    on(const dealii::Tensor<1, dim> &normal) const
    {
      return traction - pressure * normal;
    }
  };

  /// Tractions, pressures and total forces on boundaries at one time. Refers to the loads.
  template <int dim>
  class SurfaceLoads
  {
  public:
    /// Collective.
    SurfaceLoads(const Mesh<dim>                     &mesh,
                 const dealii::hp::FECollection<dim> &elements,
                 Model                                model,
                 const std::vector<Load<dim>>        &loads,
                 double                               t);

    bool
    empty() const
    {
      return by_boundary.empty();
    }

    bool
    act_on(const dealii::types::boundary_id id) const
    {
      return by_boundary.count(id) > 0;
    }

    /// At a place at rest. What is not finite is left out, see fault().
    SurfaceLoad<dim>
    at(dealii::types::boundary_id id, const dealii::Point<dim> &x);

    /// Of the first formula that had no finite value on this rank, in words; empty: none.
    const std::string &
    fault() const
    {
      return error_message;
    }

  private:
    void
    measure_boundaries(const Mesh<dim>                     &mesh,
                       const dealii::hp::FECollection<dim> &elements,
                       Model                                model);
    /// False, and remembered, if that is not a number.
    bool
    check_finite_value(double                    size,
                       const Load<dim>          &load,
                       const std::string        &key,
                       const std::string        &formula,
                       const dealii::Point<dim> &x);

    const double                                                         t;
    std::map<dealii::types::boundary_id, std::vector<const Load<dim> *>> by_boundary;
    std::map<const Load<dim> *, double> areas; ///< of the boundaries of total forces
    std::string                         error_message;
  };

  /// Of these boundaries, do loads act on any, with values that depend on time?
  template <int dim>
  bool
  surface_loads_vary(const Mesh<dim>              &mesh,
                     const std::vector<Load<dim>> &loads,
                     const std::string            &boundary);
} // namespace Signorini
