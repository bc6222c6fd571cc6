// SPDX-License-Identifier: Apache-2.0
#include "geometry/cell_size.h"
#include "mesh_import/cells.h"
#include "mesh_import/file_part_steps.h"
#include <signorini/parameters/raw.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The corners of a cell (of a simplex only the first) by the sign of the volume (2D: area)
    /// that the edges there span: positive, negative, or zero up to 1e-10 of the product of their
    /// lengths.
    struct Corners
    {
      std::vector<unsigned int> positive, negative, flat;
    };



    /// @return the corners of a cell in deal.II's numbering, sorted by sign.
    template <int dim>
    Corners
    corners_of(const CellData<dim> &cell, const std::vector<Point<dim>> &vertices)
    {
      std::vector<Point<dim>> corners;
      for (const unsigned int v : cell.vertices)
        corners.push_back(vertices[v]);
      const bool                is_simplex = corners.size() == dim + 1;
      const std::vector<double> volumes    = determinants_at_corners(corners);

      Corners result;
      for (unsigned int v = 0; v < volumes.size(); ++v)
        {
          double edges = 1;
          for (unsigned int d = 0; d < dim; ++d)
            edges *= corners[v].distance(corners[is_simplex ? d + 1 : v ^ (1u << d)]);
          const double rounding = 1e-10 * edges;
          (std::abs(volumes[v]) <= rounding ? result.flat :
           volumes[v] > 0                   ? result.positive :
                                              result.negative)
            .push_back(v);
        }
      return result;
    }



    /// @return the corner for the message: a flat one, or else one of the sign that fewer corners
    /// have.
    unsigned int
    worst(const Corners &corners)
    {
      if (!corners.flat.empty())
        return corners.flat[0];
      return corners.positive.size() < corners.negative.size() ? corners.positive[0] :
                                                                 corners.negative[0];
    }



    /// Reverse the orientation of a cell: transpose a quadrilateral or simplex, or exchange bottom
    /// and top of a hexahedron.
    template <int dim>
    void
    turn(CellData<dim> &cell)
    {
      if (dim == 2 || cell.vertices.size() == dim + 1)
        std::swap(cell.vertices[1], cell.vertices[2]);
      else
        for (unsigned int v = 0; v < 4; ++v)
          std::swap(cell.vertices[v], cell.vertices[v + 4]);
    }
  } // namespace



  // A cell is valid if the volumes at all corners have one sign, which is reversed where it is
  // negative. Cells of mixed signs are folded; all are counted, and the first is named.
  template <int dim>
  void
  orient(std::vector<CellData<dim>>                   &cells,
         const std::vector<Point<dim>>                &vertices,
         const std::vector<const MeshFile::Element *> &elements)
  {
    unsigned int n_folded = 0;
    std::string  first;
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        const Corners      corners = corners_of(cells[c], vertices);
        const unsigned int all =
          corners.positive.size() + corners.negative.size() + corners.flat.size();
        if (corners.negative.size() == all)
          turn(cells[c]);
        else if (corners.positive.size() != all && ++n_folded == 1)
          first = "element " + std::to_string(elements[c]->number) + " at its corner " +
                  text_of(vertices[cells[c].vertices[worst(corners)]]);
      }
    if (n_folded > 0)
      throw SceneError("has " + std::to_string(n_folded) +
                       (n_folded == 1 ? " cell that is" : " cells that are") + " folded or flat: " +
                       (n_folded == 1 ? "" : "the first is ") + first + "; improve the mesh there");
  }



  template void
  orient(std::vector<CellData<2>> &,
         const std::vector<Point<2>> &,
         const std::vector<const MeshFile::Element *> &);
  template void
  orient(std::vector<CellData<3>> &,
         const std::vector<Point<3>> &,
         const std::vector<const MeshFile::Element *> &);
} // namespace Signorini
