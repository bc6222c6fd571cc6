// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/file_nodes.h"
#include "mesh_import/mesh_file.h"

#include <deal.II/grid/tria_description.h>

namespace Signorini
{
  /// What is done with nodes at one place, where cells are not connected.
  enum class CoincidingPoints
  {
    refuse, ///< but those of cells that are not connected otherwise, which are kept apart
    merge,
    keep
  };

  /// What is wanted of a mesh file.
  struct FileSelection
  {
    std::string              part;       ///< empty: all cells
    std::vector<std::string> boundaries; ///< the first that contains a face wins; empty: all
    CoincidingPoints         coinciding_nodes = CoincidingPoints::refuse;
    double                   node_distance    = 0; ///< of coinciding nodes; 0: see tolerance_for()
    double                   feature_angle    = 0; ///< [degrees]; 0: one boundary `unnamed`
  };

  /// One part of a mesh file as deal.II wants it, with vertices of its own.
  template <int dim>
  struct FilePart
  {
    std::vector<dealii::CellData<dim>> cells; ///< in the order of `elements`, oriented
    std::vector<dealii::Point<dim>>    vertices;
    dealii::SubCellData                faces;      ///< all boundary faces
    std::vector<std::string>           boundaries; ///< those that have faces, the unnamed ones last
    /// Of each boundary id, indices into `boundaries`.
    std::vector<std::vector<unsigned int>> names_of_ids;
    FileNodes<dim>                         nodes;
    std::vector<unsigned int>              file_nodes; ///< of the vertices
    /// Which vertices are not in the file, but were made by dividing cells.
    std::vector<bool> inserted;
    /// The element of each cell.
    std::vector<const MeshFile::Element *> elements;
    /// What the user may want to know: nodes that are left out, and where the unnamed boundaries
    /// are that the feature angle made.
    std::vector<std::string> notes;
    /// Where pieces that are not connected touch with nodes of their own, and what to do about it;
    /// empty if they do not.
    std::string touching_pieces;

    /// Throws SceneError, without the file's name, if the cells cannot be used. Refers to the file.
    FilePart(const MeshFile &file, const FileSelection &selection);
  };
} // namespace Signorini
