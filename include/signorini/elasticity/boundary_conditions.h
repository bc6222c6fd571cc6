#pragma once

#include <signorini/parameters/expression.h>

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// A prescribed displacement, per component, on boundaries of bodies.
  template <int dim>
  struct Support
  {
    std::string              name;
    std::vector<std::string> boundaries; ///< "body.boundary"
    std::string              place;      ///< of the boundaries in the scene file
    VectorExpression<dim>    displacement;

    void
    declare(Section &section);
  };

  /// A load on boundaries (traction, pressure) or in bodies (body force).
  template <int dim>
  struct Load
  {
    std::string              name;
    std::vector<std::string> boundaries;
    std::string              place, bodies_place; ///< of the names in the scene file
    VectorExpression<dim>    traction;            ///< [force/area]
    Expression<dim>          pressure;            ///< [force/area], positive pushes into the body
    std::vector<std::string> bodies;
    VectorExpression<dim>    body_force; ///< [force/volume]

    void
    declare(Section &section);
  };
} // namespace Signorini
