#pragma once

#include <deal.II/base/point.h>

#include <string>

namespace Signorini
{
  class Section;

  /// A named point of a body, at its reference position.
  template <int dim>
  struct Probe
  {
    std::string        name;
    std::string        body; ///< empty: any
    dealii::Point<dim> point;

    void
    declare(Section &section);
  };
} // namespace Signorini
