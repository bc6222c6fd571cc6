// SPDX-License-Identifier: Apache-2.0
#include "solid/surface_loads.h"

#include "solid/nan_check.h"
#include "solid/scalar_elements.h"
#include "solid/wet_faces.h"

#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  BoundaryIds
  boundaries_of(const Mesh<dim> &mesh, const Load<dim> &load)
  {
    BoundaryIds ids;
    for (const std::string &boundary : load.boundaries)
      ids.insert(mesh.boundary_ids(boundary).begin(), mesh.boundary_ids(boundary).end());
    return ids;
  }



  // Loads are stored by boundary id, so that a face finds its own without a search. Resultants need
  // integrals over their boundaries first.
  template <int dim>
  SurfaceLoads<dim>::SurfaceLoads(const Mesh<dim>              &mesh,
                                  const hp::FECollection<dim>  &elements,
                                  const Model                   model,
                                  const std::vector<Load<dim>> &loads,
                                  const double                  t)
    : t(t)
  {
    for (const Load<dim> &load : loads)
      {
        for (const types::boundary_id id : boundaries_of(mesh, load))
          by_boundary[id].push_back(&load);
        // A total force at nodes is no surface load; see NodalForces.
        if (load.has_resultant())
          resultants[&load] = {};
      }
    if (!resultants.empty())
      distribute_resultants(mesh, elements, model);
  }



  // The quadrature is that which integrates the traction, so that resultants are exact.
  template <int dim>
  template <typename F>
  void
  SurfaceLoads<dim>::for_each_point(const Mesh<dim>             &mesh,
                                    const hp::FECollection<dim> &elements,
                                    const Model                  model,
                                    const F                     &add)
  {
    const hp::FECollection<dim> scalars = scalar_elements(elements); // the values refer to it
    hp::FEFaceValues<dim>       all_values(mesh.surface_mappings(),
                                     scalars,
                                     gauss_rules_of_faces(elements, 2),
                                     update_quadrature_points | update_JxW_values);
    std::vector<ReferenceCell>  shapes;
    for (const auto &fe : elements)
      shapes.push_back(fe.reference_cell());
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (const auto found = by_boundary.find(cell->face(f)->boundary_id());
              cell->face(f)->at_boundary() && found != by_boundary.end())
            {
              // Elements of one shape differ by their degree, which resultants do not depend on.
              const unsigned int of_shape =
                std::find(shapes.begin(), shapes.end(), cell->reference_cell()) - shapes.begin();
              all_values.reinit(cell, f, of_shape, 0, of_shape);
              const FEFaceValues<dim> &values = all_values.get_present_fe_values();
              for (const unsigned int q : values.quadrature_point_indices())
                for (const Load<dim> *load : found->second)
                  if (const auto of_load = resultants.find(load); of_load != resultants.end())
                    {
                      const Point<dim> &x = values.quadrature_point(q);
                      add(of_load->second, x, values.JxW(q) * measure(model, x));
                    }
            }
  }



  // First areas and centres, then moments of inertia about these. The moment about the centre is M
  // + (x_ref - c) x F.
  template <int dim>
  void
  SurfaceLoads<dim>::distribute_resultants(const Mesh<dim>             &mesh,
                                           const hp::FECollection<dim> &elements,
                                           const Model                  model)
  {
    using Traction = LinearTraction;
    for_each_point(mesh, elements, model, [](Traction &one, const Point<dim> &x, const double dA) {
      one.area += dA;
      one.center += dA * x;
    });
    for (auto &[load, one] : resultants)
      {
        one.area   = Utilities::MPI::sum(one.area, mesh.communicator());
        one.center = Utilities::MPI::sum(one.center, mesh.communicator()) / one.area;
      }
    for_each_point(mesh, elements, model, [](Traction &one, const Point<dim> &x, const double dA) {
      const Tensor<1, dim> r = x - Point<dim>(one.center);
      for (unsigned int a = 0; a < n_rotations; ++a)
        for (unsigned int b = 0; b < n_rotations; ++b)
          one.inertia[a][b] += dA * ((a == b ? r * r : 0.) - (dim == 2 ? 0. : r[a] * r[b]));
    });
    for (auto &[load, one] : resultants)
      {
        const Tensor<1, dim>   force  = load->total_force.value({}, t);
        Tensor<1, n_rotations> moment = load->total_moment.value({}, t);
        Tensor<1, dim>         arm;
        for (unsigned int d = 0; d < dim && !load->reference.empty(); ++d)
          arm[d] = load->reference[d] - one.center[d];
        if constexpr (dim == 2)
          moment[0] += arm[0] * force[1] - arm[1] * force[0];
        else
          moment += cross_product_3d(arm, force);
        one.mean    = force / one.area;
        one.inertia = Utilities::MPI::sum(one.inertia, mesh.communicator());
        // Also where it is no number, which is reported with the load.
        if (moment.norm() != 0)
          one.spin = invert(one.inertia) * moment;
      }
  }



  // Keep a message for the first value that is not finite; such values are not added.
  template <int dim>
  bool
  SurfaceLoads<dim>::check_finite_value(const double       size,
                                        const Load<dim>   &load,
                                        const std::string &key,
                                        const std::string &formula,
                                        const Point<dim>  &x)
  {
    if (std::isfinite(size))
      return true;
    if (error_message.empty())
      error_message = not_finite("Loads/" + load.name + "/" + key, formula, x, t);
    return false;
  }



  // The sum of traction, pressure and distributed total force of all loads at a point of the
  // boundary.
  template <int dim>
  SurfaceLoad<dim>
  SurfaceLoads<dim>::at(const CellAccessor<dim> &cell, const unsigned int face, const Point<dim> &x)
  {
    SurfaceLoad<dim> result;
    const auto       found = by_boundary.find(cell.face(face)->boundary_id());
    if (found == by_boundary.end())
      return result;
    for (const Load<dim> *load : found->second)
      {
        const Tensor<1, dim> traction = load->traction_at(x, t);
        const double pressure = pressure_acts(*load, cell, face) ? load->pressure.value(x, t) : 0.;
        if (check_finite_value(traction.norm(), *load, "Traction", load->traction.text(), x))
          result.traction += traction;
        if (check_finite_value(pressure, *load, "Pressure", load->pressure.formula(), x))
          result.pressure += pressure;
        const auto found_one = resultants.find(load);
        if (found_one == resultants.end())
          continue;
        const LinearTraction &one    = found_one->second;
        const auto           &moment = load->total_moment;
        if (!check_finite_value(
              one.mean.norm(), *load, "Total force", load->total_force.text(), x) ||
            !check_finite_value(one.spin.norm(), *load, "Total moment", moment.text(), x))
          continue;
        const Tensor<1, dim> r = x - Point<dim>(one.center);
        result.traction += one.mean;
        if constexpr (dim == 2)
          result.traction += one.spin[0] * Tensor<1, dim>({-r[1], r[0]});
        else
          result.traction += cross_product_3d(one.spin, r);
      }
    return result;
  }



  // True if any load on a common part of the boundary depends on time.
  template <int dim>
  bool
  surface_loads_vary(const Mesh<dim>              &mesh,
                     const std::vector<Load<dim>> &loads,
                     const std::string            &boundary)
  {
    const BoundaryIds &wanted = mesh.boundary_ids(boundary);
    return std::any_of(loads.begin(), loads.end(), [&](const Load<dim> &load) {
      if (!load.traction.depends_on_time() && !load.pressure.depends_on_time() &&
          !load.total_force.depends_on_time() && !load.total_moment.depends_on_time())
        return false;
      const BoundaryIds loaded = boundaries_of(mesh, load);
      return std::any_of(wanted.begin(), wanted.end(), [&](const auto id) {
        return loaded.count(id) > 0;
      });
    });
  }



#define INSTANTIATE(dim)                                                                           \
  template class SurfaceLoads<dim>;                                                                \
  template BoundaryIds boundaries_of(const Mesh<dim> &, const Load<dim> &);                        \
  template bool        surface_loads_vary(const Mesh<dim> &,                                       \
                                          const std::vector<Load<dim>> &,                          \
                                          const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
