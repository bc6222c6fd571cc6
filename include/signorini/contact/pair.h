#pragma once

#include <signorini/parameters/expression.h>

#include <string>

namespace Signorini
{
  class Section;

  /// Two surfaces that may touch: the slave, where contact is integrated, and the master, which is
  /// the boundary of another body or an obstacle.
  template <int dim>
  struct ContactPair
  {
    std::string     name, slave, master;
    std::string     slave_place, master_place;     ///< in the scene file
    Formula         initial_gap = "from geometry"; ///< or "closed", or a formula of the coordinates
    bool            separates   = true;  ///< no: the law is g = 0, whatever the pressure's sign
    Expression<dim> interference{"1"};   ///< share of initial overlaps that counts at time t
    double          search_distance = 0; ///< 0: automatic
    bool            found = false; ///< by the program: the scene does not say that it will act

    void
    declare(Section &section);
  };
} // namespace Signorini
