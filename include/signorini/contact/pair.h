// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// Which of a pair's surfaces is the slave.
  enum class SideChoice
  {
    automatic, ///< the one that carries a stable pressure, that named where both do
    as_named
  };

  /// Two surfaces that may touch: the slave, where contact is integrated, and the master, which is
  /// the boundary of another body or an obstacle.
  template <int dim>
  struct ContactPair
  {
    std::string name, slave, master;
    std::string slave_location, master_location; ///< in the scene file
    Formula     initial_gap = "from geometry"; ///< or "closed", or a formula of the place and time
    double closes_below = -1; ///< gaps at rest up to this are zero, and so are overlaps; < 0: none
    bool   can_separate = true;          ///< no: the law is g = 0, whatever the pressure's sign
    Expression<dim> interference{"1"};   ///< share of initial overlaps that counts at time t
    double          search_distance = 0; ///< 0: automatic
    /// Along which the extents of its contact area are reported.
    std::vector<dealii::Point<dim>> directions;
    SideChoice                      sides     = SideChoice::automatic;
    bool                            exchanged = false; ///< the scene names the master as slave
    bool found = false; ///< found by the program, so that it need not come into contact
    /// Self-contact: sign of the direction of SelfContact along which the slave faces; the master
    /// faces the other way.
    double self_side = 1;

    void
    declare(Section &section);

    /// True if the reference gap is given by the input, not by the positions of the bodies.
    bool
    gap_is_given() const
    {
      return initial_gap.text != "from geometry";
    }

    /// True if the prescribed gap depends on time.
    bool
    gap_depends_on_time() const;

    /// True if slave and master are the same surface, in self-contact.
    bool
    is_self() const
    {
      return slave == master;
    }

    /// Exchange slave and master.
    void
    exchange();

    /// The slave as the input names it, before any exchange.
    const std::string &
    named_slave() const
    {
      return exchanged ? master : slave;
    }
    const std::string &
    named_master() const
    {
      return exchanged ? slave : master;
    }
  };
} // namespace Signorini
