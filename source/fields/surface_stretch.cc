// SPDX-License-Identifier: Apache-2.0
#include "fields/recovery_steps.h"
#include "geometry/face_functions.h"

namespace Signorini
{
  using namespace dealii;

  // The pressure of each node is multiplied by the quotient of reference and current area of the
  // node, 1/j of doc/theory, 6.5.
  template <int dim>
  void
  to_present_areas(const Snapshot<dim> &s, const unsigned int pair, LA::Vector &pressure)
  {
    if (!s.elasticity.is_finite_strain())
      return;
    const ContactSurface<dim> &surface = s.surfaces[pair];
    LA::Vector                 rest = s.elasticity.zero_vector(), now = rest;
    for (const ContactPoint<dim> &point : surface.points)
      {
        const SlaveFace<dim>    &face = surface.slave_faces[point.face];
        const FaceFunctions<dim> shape(face.reference_cell(), face.degree, point.xi);
        for (unsigned int i = 0; i < shape.size(); ++i)
          {
            // Shape functions of degree 2 change sign: absolute values keep the areas positive.
            const double area = std::abs(shape.value(i)) * point.weight;
            rest(face.nodes[i]) += area;
            now(face.nodes[i]) += area * point.stretch;
          }
      }
    for (LA::Vector *v : {&rest, &now})
      v->compress(VectorOperation::add);
    for (const auto i : pressure.locally_owned_elements())
      if (now(i) > 0)
        pressure(i) *= rest(i) / now(i);
    pressure.compress(VectorOperation::insert);
    s.elasticity.hanging_nodes().distribute(pressure);
  }



  template void
  to_present_areas(const Snapshot<2> &, unsigned int, LA::Vector &);
  template void
  to_present_areas(const Snapshot<3> &, unsigned int, LA::Vector &);
} // namespace Signorini
