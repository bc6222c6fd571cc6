// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/file_nodes.h"
#include "mesh_import/mesh_file.h"

#include <deal.II/grid/tria_description.h>

namespace Signorini
{
  /// What is done with several nodes at one position, where cells are not connected.
  enum class CoincidingPoints
  {
    /// An error (a crack), except between cells that are not connected anywhere, which are kept
    /// separate.
    refuse,
    /// One node replaces them, so that the cells are connected.
    merge,
    /// They are kept separate, as a crack or a slit.
    keep
  };

  /// What is read from a mesh file, and how.
  struct FileSelection
  {
    /// Name of the group of cells; empty: all cells.
    std::string part;
    /// Names of the groups that are boundaries; the first that contains a face names it. Empty: all
    /// groups.
    std::vector<std::string> boundaries;
    CoincidingPoints         coinciding_nodes = CoincidingPoints::refuse;
    /// Distance [length] up to which nodes coincide; 0: 1e-3 of the shortest edge.
    double node_distance = 0;
    /// Angle [degrees] at which boundaries without names are divided; 0: one boundary `unnamed`.
    double feature_angle = 0;
  };

  /// One part of a mesh file in the form that deal.II needs to create a triangulation, with
  /// vertices of its own.
  template <int dim>
  struct FilePart
  {
    /// In the order of `elements`, with positive orientation.
    std::vector<dealii::CellData<dim>> cells;
    std::vector<dealii::Point<dim>>    vertices;
    /// All boundary faces, with their boundary ids.
    dealii::SubCellData faces;
    /// Names of the boundaries that have faces; those that the file does not name are last.
    std::vector<std::string> boundaries;
    /// For each boundary id the indices of its names in `boundaries`.
    std::vector<std::vector<unsigned int>> names_of_ids;
    FileNodes<dim>                         nodes;
    /// For each vertex the index of the node of the file.
    std::vector<unsigned int> file_nodes;
    /// For each vertex whether it is not in the file, but was inserted by dividing cells.
    std::vector<bool> inserted;
    /// The element of each cell.
    std::vector<const MeshFile::Element *> elements;
    /// Messages for the user: nodes that are ignored, pieces that are not connected, and where the
    /// unnamed boundaries are that the feature angle created.
    std::vector<std::string> notes;
    /// A message on where pieces that are not connected touch with separate nodes, and what to do
    /// about it; empty if they do not.
    std::string touching_pieces;

    /// Read a part. Throws SceneError, without the file's name, if the cells cannot be used.
    /// @param file the mesh, of quadrilaterals or hexahedra after divide_cells(); the part refers
    /// to it
    /// @param selection what is read
    FilePart(const MeshFile &file, const FileSelection &selection);
  };
} // namespace Signorini
