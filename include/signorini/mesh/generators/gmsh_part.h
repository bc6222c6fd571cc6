#pragma once

#include <signorini/mesh/gmsh.h>

#include <deal.II/grid/tria_description.h>

namespace Signorini
{
  /// One part of a mesh file as deal.II wants it.
  template <int dim>
  struct GmshPart
  {
    std::vector<dealii::CellData<dim>> cells;
    std::vector<dealii::Point<dim>>    vertices;
    /// All boundary faces; the boundary id is the index of the name into `names`, or `unnamed`.
    dealii::SubCellData faces;

    /// An empty name of the part stands for all cells. Throws SceneError, without the file's name,
    /// if the cells cannot be used.
    GmshPart(const GmshFile                 &file,
             const std::string              &part,
             const std::vector<std::string> &names,
             dealii::types::boundary_id      unnamed);
  };
} // namespace Signorini
