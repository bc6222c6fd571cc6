// SPDX-License-Identifier: Apache-2.0
#include <signorini/parameters/section.h>
#include <signorini/solid/local_axes.h>

#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A vector of length 1 in the direction of v; zero if v is, up to a size.
    template <int dim>
    Tensor<1, dim>
    unit(const Tensor<1, dim> &v, const double negligible = 0)
    {
      const double norm = v.norm();
      return norm > negligible ? v / norm : Tensor<1, dim>();
    }

    /// Three unit vectors, of which the third is the cross product of the others; in the plane the
    /// second is the first one turned counterclockwise.
    template <int dim>
    Tensor<2, dim>
    right_handed(const Tensor<1, dim> &first, const Tensor<1, dim> &third)
    {
      Tensor<2, dim> rows;
      rows[0] = first;
      if constexpr (dim == 2)
        {
          rows[1][0] = -first[1];
          rows[1][1] = first[0];
        }
      else
        {
          rows[1] = cross_product_3d(third, first);
          rows[2] = third;
        }
      return rows;
    }
  } // namespace



  template <int dim>
  void
  LocalAxes<dim>::declare(Section &section, const std::string &of)
  {
    section.add_choice(
      "Coordinates",
      coordinates,
      {{"cartesian", Coordinates::cartesian},
       {"rotated", Coordinates::rotated},
       {"cylindrical", Coordinates::cylindrical}},
      "to which the components of " + of +
        " refer: x,y,z; rotated: x',y',z' of the Axes; cylindrical: radial, circumferential and axial, "
        "in the undeformed configuration");
    section.add(
      "Axes",
      definition,
      dim == 3 ?
        "rotated: direction of x'; a vector in the plane of x' and y'; cylindrical: a point "
        "of the axis; its direction" :
        "rotated: direction of x'; cylindrical: the centre");
    if (!section.reading())
      return;
    if (are_global() != definition.empty())
      section.fail(are_global() ? "Axes" : "Coordinates",
                   are_global() ? "has no effect with Coordinates = cartesian; remove it" :
                                  "requires Axes");
    if (are_global())
      return;
    if (definition.size() != dim - 1)
      section.fail("Axes", dim == 3 ? "needs two vectors: x,y,z; x,y,z" : "needs one vector: x,y");
    const bool is_rotated = coordinates == Coordinates::rotated;
    if (is_rotated && definition[0].norm() == 0)
      section.fail("Axes", "the zero vector has no direction");
    if constexpr (dim == 3)
      if (definition[1].norm() == 0 ||
          (is_rotated && cross_product_3d(definition[0], definition[1]).norm() <
                           1e-6 * definition[0].norm() * definition[1].norm()))
        section.fail("Axes", "the second vector is zero or parallel to the first one");
  }



  template <int dim>
  Tensor<2, dim>
  LocalAxes<dim>::at(const Point<dim> &x) const
  {
    Tensor<1, dim> first, third;
    switch (coordinates)
      {
        case Coordinates::cartesian:
          return unit_symmetric_tensor<dim>();
        case Coordinates::rotated:
          first = unit<dim>(definition[0]);
          if constexpr (dim == 3)
            third = unit<dim>(cross_product_3d(definition[0], definition[1]));
          break;
        case Coordinates::cylindrical:
          first = x - definition[0];
          if constexpr (dim == 3)
            {
              third = unit<dim>(definition[1]);
              first -= (first * third) * third;
            }
          // Points whose distance from the axis is rounding are on it.
          first = unit(first, 1e-10 * (x.norm() + definition[0].norm()));
          break;
      }
    return right_handed(first, third);
  }



  template <int dim>
  Tensor<1, dim>
  LocalAxes<dim>::to_global(const Tensor<1, dim> &components, const Point<dim> &x) const
  {
    if (are_global())
      return components;
    const Tensor<2, dim> axes = at(x);
    for (unsigned int d = 0; d < dim; ++d)
      if (components[d] != 0 && axes[d].norm() == 0)
        return components * std::numeric_limits<double>::quiet_NaN();
    return components * axes;
  }



  template struct LocalAxes<2>;
  template struct LocalAxes<3>;
} // namespace Signorini
