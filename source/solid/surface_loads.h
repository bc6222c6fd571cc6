// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include <signorini/solid/boundary_conditions.h>
#include <signorini/solid/model.h>

#include <deal.II/hp/fe_collection.h>

#include <map>

namespace Signorini
{
  /// The sum of all surface loads at a point of a boundary.
  template <int dim>
  struct SurfaceLoad
  {
    dealii::Tensor<1, dim> traction;     ///< [force/reference area], of fixed direction
    double                 pressure = 0; ///< [force/area], positive pushes into the body

    /// The force per area of a surface with that outward normal.
    dealii::Tensor<1, dim>
    on(const dealii::Tensor<1, dim> &normal) const
    {
      return traction - pressure * normal;
    }
  };

  /// The boundary ids of a load, each once: boundaries of different names may share faces, which
  /// are loaded once.
  template <int dim>
  BoundaryIds
  boundaries_of(const Mesh<dim> &mesh, const Load<dim> &load);

  /// Tractions, pressures and total forces on boundaries at one time. Refers to the loads.
  template <int dim>
  class SurfaceLoads
  {
  public:
    /// Evaluate the loads at time t. Collective.
    SurfaceLoads(const Mesh<dim>                     &mesh,
                 const dealii::hp::FECollection<dim> &elements,
                 Model                                model,
                 const std::vector<Load<dim>>        &loads,
                 double                               t);

    /// True if there are no surface loads.
    bool
    empty() const
    {
      return by_boundary.empty();
    }

    /// True if a load acts on faces with this boundary id.
    bool
    act_on(const dealii::types::boundary_id id) const
    {
      return by_boundary.count(id) > 0;
    }

    /// The load at a point of a boundary face in the reference configuration. Values that are not
    /// finite are skipped, see fault().
    /// @param cell of the mesh, or of a DoFHandler on it
    SurfaceLoad<dim>
    at(const dealii::CellAccessor<dim> &cell, unsigned int face, const dealii::Point<dim> &x);

    /// A message about the first formula that had no finite value on this rank; empty if there is
    /// none.
    const std::string &
    fault() const
    {
      return error_message;
    }

  private:
    static constexpr unsigned int n_rotations = dim == 2 ? 1 : 3;

    /// The traction with a given resultant that is linear in the place, F/A + w x (x - c).
    struct LinearTraction
    {
      double                         area = 0;
      dealii::Tensor<1, dim>         center;  ///< c; first the integral of x
      dealii::Tensor<2, n_rotations> inertia; ///< integral of |r|^2 - r r, r = x - c, with M = I w
      dealii::Tensor<1, dim>         mean;    ///< F/A
      dealii::Tensor<1, n_rotations> spin;    ///< w [force/length^3]
    };

    /// Call add(resultant, x, dA) for each resultant at the quadrature points x of its boundaries
    /// on this rank, with the area dA of the point.
    template <typename F>
    void
    for_each_point(const Mesh<dim>                     &mesh,
                   const dealii::hp::FECollection<dim> &elements,
                   Model                                model,
                   const F                             &add);
    /// Find the tractions of loads with resultants. Collective.
    void
    distribute_resultants(const Mesh<dim>                     &mesh,
                          const dealii::hp::FECollection<dim> &elements,
                          Model                                model);
    /// Returns false, and stores a message, if the value is not finite.
    bool
    check_finite_value(double                    size,
                       const Load<dim>          &load,
                       const std::string        &key,
                       const std::string        &formula,
                       const dealii::Point<dim> &x);

    const double                                                         t;
    std::map<dealii::types::boundary_id, std::vector<const Load<dim> *>> by_boundary;
    std::map<const Load<dim> *, LinearTraction>                          resultants;
    std::string                                                          error_message;
  };

  /// True if loads with time-dependent values act on any of these boundaries.
  template <int dim>
  bool
  surface_loads_vary(const Mesh<dim>              &mesh,
                     const std::vector<Load<dim>> &loads,
                     const std::string            &boundary);
} // namespace Signorini
