// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// A part of space in which cells are refined before the first solution.
  template <int dim>
  struct RefinementRegion
  {
    std::string     name;
    Expression<dim> where{"1"}; ///< refined where positive (at a vertex or the center of the cell)
    std::vector<std::string> bodies; ///< empty: all
    std::string              place;  ///< of the bodies in the scene file
    unsigned int             times = 1;

    void
    declare(Section &section);
  };

  /// Who distributes the cells.
  enum class Distribution
  {
    p4est,
    METIS ///< once: the mesh stays as it is
  };

  template <int dim>
  struct MeshSettings
  {
    std::optional<Distribution>        distribution; ///< none: chosen
    unsigned int                       refinements         = 0;
    unsigned int                       contact_refinements = 0;
    unsigned int                       geometry_degree     = 0; ///< 0: chosen
    double                             slave_face_weight   = 2;
    std::vector<RefinementRegion<dim>> refinement_regions;

    void
    declare(Section &section);

    /// By p4est, which puts coarse cells into an order in seconds that grow with the square of
    /// their number (300,000 cells: 70 s); or else by METIS, for which each rank has all cells in
    /// the beginning.
    bool
    by_p4est(std::size_t n_coarse_cells) const;
  };
} // namespace Signorini
