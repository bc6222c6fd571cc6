// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"

#include <map>
#include <vector>

namespace Signorini
{
  /// The part of the mesh that a set of coarse nodes stands for: the nodes themselves, and the
  /// edges, faces and cells all of whose nodes in the file are in the set, however they are
  /// refined.
  template <int dim>
  class ListedNodes
  {
  public:
    /// Refers to the mesh.
    ListedNodes(const Mesh<dim> &mesh, const NodeSet<dim> &nodes);

    /// True if a coarse cell has a node of the set.
    bool
    has_some(const unsigned int coarse_cell) const
    {
      return by_cell.count(coarse_cell) > 0;
    }

    /// True if a point of an active cell belongs to that part. @param unit point in reference
    /// coordinates of the cell
    bool
    contains(const dealii::CellId &cell, const dealii::Point<dim> &unit);

    /// The number of nodes of the set that are neither corners of the mesh, nor between corners of
    /// the set, nor were found by contains(): they do not exist in the mesh. Collective.
    unsigned int
    n_missing(MPI_Comm comm) const;

  private:
    /// A node of the set in a coarse cell.
    struct Listed
    {
      dealii::Point<dim> unit; ///< in the coarse cell
      unsigned int       node;
    };

    /// True if all nodes of the edge, face or cell inside of which the point lies are in the set.
    bool
    has_all_around(unsigned int coarse_cell, const dealii::Point<dim> &unit) const;

    const Mesh<dim> &mesh;

    /// The nodes of the set by the coarse cells that have them.
    std::map<unsigned int, std::vector<Listed>> by_cell;
    /// Nodes that are not in the set, see NodeSet::left_out, by coarse cells.
    std::map<unsigned int, std::vector<dealii::Point<dim>>> left_out;
    /// Flags of the nodes of the set: 1 if the node has been found to exist in the mesh on this
    /// rank.
    std::vector<unsigned int> is_there;
  };

  /// A point of an active cell in reference coordinates of its coarse cell. @param unit in those of
  /// the cell
  template <int dim>
  dealii::Point<dim>
  in_coarse_cell(const dealii::CellId &cell, const dealii::Point<dim> &unit);

  /// Transform a point from a coarse cell to one of its descendants. Returns false if the point
  /// belongs to another descendant: each point belongs to exactly one of the cells that touch it.
  /// @param unit in: reference coordinates in the coarse cell; out: those in the cell
  template <int dim>
  bool
  descend(const dealii::CellId &cell, dealii::Point<dim> &unit);

  /// The active cell that contains a point.
  template <int dim>
  struct PointLocation
  {
    bool               is_on_this_rank = false; ///< exactly one rank has the cell
    unsigned int       active_cell;             ///< its index
    dealii::Point<dim> unit;
  };

  /// Find the cell that contains a point. Of several cells that share it, the result does not
  /// depend on the number of ranks. Since meshes do not contain all points near the true surface of
  /// a curved body, the point may lie outside of the cell by 2 % of its size. Throws SceneError if
  /// no cell has the point, or cells of two bodies have it. Collective.
  /// @param body name of the body; empty: any
  /// @param what beginning of the message
  template <int dim>
  PointLocation<dim>
  locate(const Mesh<dim>          &mesh,
         const dealii::Point<dim> &x,
         const std::string        &body,
         const std::string        &what);
} // namespace Signorini
