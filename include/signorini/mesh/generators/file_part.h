#pragma once

#include <signorini/mesh/mesh_file.h>

#include <deal.II/grid/tria_description.h>

namespace Signorini
{
  /// What is wanted of a mesh file.
  struct FileSelection
  {
    std::string              part;       ///< empty: all cells
    std::vector<std::string> boundaries; ///< the first that contains a face wins; empty: all
    std::string              coinciding_nodes = "refuse"; ///< or merge, keep
    double                   node_distance    = 0; ///< of coinciding nodes; 0: see tolerance_for()
    double                   feature_angle    = 0; ///< [degrees]; 0: one boundary `unnamed`
  };

  /// One part of a mesh file as deal.II wants it, with vertices of its own.
  template <int dim>
  struct FilePart
  {
    std::vector<dealii::CellData<dim>> cells; ///< in the order of `elements`, oriented
    std::vector<dealii::Point<dim>>    vertices;
    /// All boundary faces; the boundary id is the index of the name into `boundaries`.
    dealii::SubCellData      faces;
    std::vector<std::string> boundaries; ///< those that have faces, the unnamed ones last
    /// The element of each cell.
    std::vector<const MeshFile::Element *> elements;
    /// What the user may want to know: nodes that are left out, and where the unnamed boundaries
    /// are that the feature angle made.
    std::vector<std::string> notes;

    /// Throws SceneError, without the file's name, if the cells cannot be used. Refers to the file.
    FilePart(const MeshFile &file, const FileSelection &selection);
  };
} // namespace Signorini
