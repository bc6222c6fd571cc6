// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <vector>

namespace Signorini
{
  /// The values of those degrees of freedom of a cell that no earlier cell contains, so that each
  /// value occurs once. Independent of the partition.
  struct CellValues
  {
    dealii::CellId cell;
    /// One bit for each degree of freedom of the cell: whether its value is in `values`.
    std::vector<std::uint8_t> which;
    std::vector<double>       values;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &cell &which &values;
    }
  };

  /// @return the values of a vector on all cells of this rank, without rigid bodies.
  /// @param elasticity the model
  /// @param u the vector, without ghost values
  template <int dim>
  std::vector<CellValues>
  values_of_cells(const Elasticity<dim> &elasticity, const LA::Vector &u);

  /// @return the vector with these values, on any partition of a mesh with the same cells. Degrees
  /// of freedom of rigid bodies are zero. Throws SceneError if cells or degrees of freedom differ.
  /// Collective.
  /// @param elasticity the model
  /// @param cells of which each is given by some rank
  template <int dim>
  LA::Vector
  vector_of_cells(const Elasticity<dim> &elasticity, const std::vector<CellValues> &cells);

  /// Refine and coarsen a mesh until its active cells are given ones. Throws SceneError if the
  /// distribution of the mesh does not permit that. Collective.
  /// @param mesh which is changed
  /// @param cells of which each is given by some rank
  template <int dim>
  void
  restore_cells(Mesh<dim> &mesh, const std::vector<CellValues> &cells);

  /// @return properties by which meshes can be distinguished, independent of the partition: the
  /// number of cells, a hash of their ids, and moments of their centres. Collective.
  /// @param mesh the mesh
  template <int dim>
  nlohmann::ordered_json
  mark_of_mesh(const Mesh<dim> &mesh);

  /// Throws SceneError if a mesh has other properties. Collective.
  /// @param mesh the mesh
  /// @param mark result of mark_of_mesh()
  template <int dim>
  void
  check_mark(const Mesh<dim> &mesh, const nlohmann::ordered_json &mark);
} // namespace Signorini
