// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <vector>

namespace Signorini
{
  /// The values of those degrees of freedom of a cell that no cell before it has told, so that each
  /// value is there once. It refers to no numbers of a partition.
  struct CellValues
  {
    dealii::CellId            cell;
    std::vector<std::uint8_t> which; ///< a bit for each degree of freedom of the cell
    std::vector<double>       values;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &cell &which &values;
    }
  };

  /// All cells of this rank, and a vector of the degrees of freedom on them; rigid bodies are not
  /// in it.
  template <int dim>
  std::vector<CellValues>
  values_of_cells(const Elasticity<dim> &elasticity, const LA::Vector &u);

  /// Back again, on any partition of a mesh that has these cells; each cell is known to some rank.
  /// Degrees of freedom of rigid bodies are zero. Collective.
  template <int dim>
  LA::Vector
  vector_of_cells(const Elasticity<dim> &elasticity, const std::vector<CellValues> &cells);

  /// Refine, and coarsen, until the active cells are those that the ranks name together. Throws
  /// SceneError if the distribution of the mesh cannot do that. Collective.
  template <int dim>
  void
  restore_cells(Mesh<dim> &mesh, const std::vector<CellValues> &cells);

  /// What tells meshes apart, whatever the partition: how many cells, a hash of their names, and
  /// where they are. Collective.
  template <int dim>
  nlohmann::ordered_json
  mark_of_mesh(const Mesh<dim> &mesh);

  /// Throws SceneError if a mesh has not that mark. Collective.
  template <int dim>
  void
  check_mark(const Mesh<dim> &mesh, const nlohmann::ordered_json &mark);
} // namespace Signorini
