// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// A region of space in which cells are refined before the first solution.
  template <int dim>
  struct RefinementRegion
  {
    std::string name;
    /// Cells are refined where this function is positive at a vertex or at the centre.
    Expression<dim> where{"1"};
    /// Names of the bodies; empty: all.
    std::vector<std::string> bodies;
    /// Position in the scene file, for messages.
    std::string  place;
    unsigned int times = 1;

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section of the region
    void
    declare(Section &section);
  };

  /// The partitioner of the mesh.
  enum class Distribution
  {
    p4est,
    /// The mesh is partitioned once and cannot be refined adaptively.
    METIS
  };

  template <int dim>
  struct MeshSettings
  {
    /// Partitioner; none: chosen by the number of coarse cells.
    std::optional<Distribution> distribution;
    unsigned int                refinements         = 0;
    unsigned int                contact_refinements = 0;
    /// Polynomial degree of cells and surfaces; 0: chosen.
    unsigned int                       geometry_degree   = 0;
    double                             slave_face_weight = 2;
    std::vector<RefinementRegion<dim>> refinement_regions;

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section `Mesh`
    void
    declare(Section &section);

    /// @return whether p4est partitions the mesh. It sorts the coarse cells in a time that grows
    /// with the square of their number (300,000 cells: 70 s); with METIS each rank has all cells at
    /// the beginning.
    /// @param n_coarse_cells number of coarse cells
    bool
    by_p4est(std::size_t n_coarse_cells) const;
  };
} // namespace Signorini
