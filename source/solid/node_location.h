// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"

#include <map>
#include <vector>

namespace Signorini
{
  /// Which places of the mesh a set of coarse nodes stands for: the nodes themselves, and the
  /// edges, faces and cells all of whose corners are in it, however they are refined.
  template <int dim>
  class ListedNodes
  {
  public:
    explicit ListedNodes(const NodeSet<dim> &nodes);

    bool
    has_some(const unsigned int coarse_cell) const
    {
      return by_cell.count(coarse_cell) > 0;
    }

    /// @param unit a point of an active cell
    bool
    contains(const dealii::CellId &cell, const dealii::Point<dim> &unit);

    /// How many nodes of the set are neither corners, nor between corners of the set, nor have been
    /// asked for: no places of the mesh. Collective.
    unsigned int
    n_missing(MPI_Comm comm) const;

  private:
    struct Listed
    {
      dealii::Point<dim> unit; ///< in the coarse cell
      unsigned int       node;
    };

    bool
    has_corners_around(const std::vector<Listed> &listed, const dealii::Point<dim> &unit) const;

    std::map<unsigned int, std::vector<Listed>> by_cell; ///< coarse
    std::vector<unsigned int>                   is_there;
  };

  /// From a coarse cell to a cell in it. Returns false if the point belongs to another one: each
  /// point belongs to just one of the cells that touch it. @param unit point of the coarse cell,
  /// and then of the cell
  template <int dim>
  bool
  descend(const dealii::CellId &cell, dealii::Point<dim> &unit);

  /// The cell that a point lies in.
  template <int dim>
  struct PointLocation
  {
    bool               is_on_this_rank = false; ///< on this rank; exactly one has it
    unsigned int       active_cell;             ///< its index
    dealii::Point<dim> unit;
  };

  /// Of several cells that share the point the same one whatever the number of ranks. As meshes
  /// leave out points near the true surface of a curved body, it may lie outside by 2 % of the
  /// cell.
  /// @param body empty: any
  /// @param what the message begins with. Throws SceneError if no cell has the point, or cells of
  /// two bodies. Collective.
  template <int dim>
  PointLocation<dim>
  locate(const Mesh<dim>          &mesh,
         const dealii::Point<dim> &x,
         const std::string        &body,
         const std::string        &what);
} // namespace Signorini
