// SPDX-License-Identifier: Apache-2.0
#include "accuracy/traction_errors.h"

#include "contact/constraints/gap_increments.h"
#include "fields/friction_fields.h"
#include "fields/nodal_fields.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the derivative by one component of the traction per area, at the rows; zero for
    /// quantities with a lift, which contains it.
    template <int dim>
    LA::Vector
    by_component(const Snapshot<dim> &s, const Functional &functional, const unsigned int component)
    {
      LA::Vector density = functional.of_traction[component];
      if (functional.lift.size() > 0)
        density = 0;
      for (const auto i : density.locally_owned_elements())
        density(i) = s.contact.weight(i) > 0 ? density(i) / s.contact.weight(i) : 0.;
      density.compress(VectorOperation::insert);
      return density;
    }

    /// @return the derivative by the tangential traction per area, component by component in space,
    /// as by_pressure(); empty for laws without tangential components.
    template <int dim>
    std::vector<LA::Vector>
    by_tangential_traction(const Snapshot<dim> &s,
                           const Functional    &functional,
                           const unsigned int   pair)
    {
      std::vector<LA::Vector> result;
      if (s.contact.n_components() == 1)
        return result;
      PointVectors density;
      for (unsigned int a = 1; a < functional.of_traction.size(); ++a)
        density.push_back(by_component(s, functional, a));
      for (const LA::Vector &component : in_space(s, density))
        result.push_back(s.elasticity.with_ghosts(nodal_field(s, component, pair)));
      return result;
    }
  } // namespace



  // Nodes without multiplier have the derivative of their neighbours, whose functions they share.
  template <int dim>
  LA::Vector
  by_pressure(const Snapshot<dim> &s, const Functional &functional, const unsigned int pair)
  {
    return s.elasticity.with_ghosts(nodal_field(s, by_component(s, functional, 0), pair));
  }



  template <int dim>
  std::vector<LA::Vector>
  recovered_traction(const Snapshot<dim> &s, const unsigned int pair)
  {
    std::vector<LA::Vector> result;
    for (const LA::Vector &component : tangential_traction(s, pair))
      result.push_back(s.elasticity.with_ghosts(component));
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  vector_at(const ContactSurface<dim>     &surface,
            const ContactPoint<dim>       &point,
            const std::vector<LA::Vector> &components)
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < components.size(); ++d)
      result[d] = value_at(surface, point, components[d]);
    return result;
  }



  // A force that acts on both sides of the interface does the work (z^S - z^M) . q in the dual
  // displacement, which is what the quantity changes by through the displacements; quantities that
  // are read from the tractions themselves change by dJ/dq in addition. Both are densities per
  // present area, so that weights, which are areas of the reference configuration, are multiplied
  // by the stretch of the surface. Frames exist only for laws with slip, hence the two branches.
  template <int dim>
  void
  add_traction_errors(const Snapshot<dim>       &s,
                      const Functional          &functional,
                      const LA::Vector          &z,
                      const unsigned int         pair,
                      const TractionErrors<dim> &errors,
                      std::vector<double>       &of_cells)
  {
    const ContactSurface<dim>             &surface = s.surfaces[pair];
    std::vector<const ContactPoint<dim> *> points;
    std::vector<const SurfaceFrame<dim> *> frames;
    for (const unsigned int q : errors.points)
      points.push_back(&surface.points[q]);
    const std::vector<double>     opened     = gap_increments(points, z);
    const LA::Vector              density    = by_pressure(s, functional, pair);
    const std::vector<LA::Vector> tangential = by_tangential_traction(s, functional, pair);
    std::vector<Tensor<1, dim>>   displaced;
    if (!tangential.empty())
      {
        for (const unsigned int q : errors.points)
          frames.push_back(&surface.frames[q]);
        displaced = relative_displacements(points, frames, z);
      }
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        double change = errors.pressure[q] * (opened[q] + value_at(surface, *points[q], density));
        for (unsigned int d = 0; d < tangential.size(); ++d)
          change += errors.tangential[q][d] *
                    (displaced[q][d] + value_at(surface, *points[q], tangential[d]));
        const auto cell = s.elasticity.mesh().triangulation().create_cell_iterator(
          surface.slave_faces[points[q]->face].cell);
        of_cells[cell->active_cell_index()] += points[q]->weight * points[q]->stretch * change;
      }
  }



#define INSTANTIATE(dim)                                                                           \
  template LA::Vector by_pressure(const Snapshot<dim> &, const Functional &, unsigned int);        \
  template std::vector<LA::Vector> recovered_traction(const Snapshot<dim> &, unsigned int);        \
  template Tensor<1, dim>          vector_at(const ContactSurface<dim> &,                          \
                                             const ContactPoint<dim> &,                            \
                                             const std::vector<LA::Vector> &);                     \
  template void                    add_traction_errors(const Snapshot<dim> &,                      \
                                                       const Functional &,                         \
                                                       const LA::Vector &,                         \
                                                       unsigned int,                               \
                                                       const TractionErrors<dim> &,                \
                                                       std::vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
