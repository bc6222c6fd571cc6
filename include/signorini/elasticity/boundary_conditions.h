#pragma once

#include <signorini/parameters/expression.h>

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// A prescribed displacement on boundaries of bodies: per component, or along one direction.
  template <int dim>
  struct Support
  {
    std::string              name;
    std::vector<std::string> boundaries;            ///< "body.boundary"
    std::string              place;                 ///< of the boundaries in the scene file
    std::string              type = "displacement"; ///< or "symmetry", "roller"
    VectorExpression<dim>    displacement;
    Expression<dim>          normal_displacement; ///< of a roller
    dealii::Point<dim>       direction; ///< in which a roller holds; zero: along the normal

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
