#include <signorini/mesh/generators/cell_checks.h>
#include <signorini/mesh/generators/cells.h>
#include <signorini/parameters/raw.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    struct Corners
    {
      unsigned int n_positive = 0;
      /// The last corner where the cell is folded, as the other corners see it.
      unsigned int last_positive = 0, last_other = 0;
    };



    template <int dim>
    Corners<dim>
    corners_of(const CellData<dim> &cell, const std::vector<Point<dim>> &vertices)
    {
      Point<dim>     corners[GeometryInfo<dim>::vertices_per_cell];
      Tensor<0, dim> volumes[GeometryInfo<dim>::vertices_per_cell];
      for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
        corners[v] = vertices[cell.vertices[v]];
      GeometryInfo<dim>::alternating_form_at_vertices(corners, volumes);

      // Rounding makes nothing of a volume, relative to the edges at the corner.
      Corners<dim> result;
      for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
        {
          double edges = 1;
          for (unsigned int d = 0; d < dim; ++d)
            edges *= corners[v].distance(corners[v ^ (1u << d)]);
          if (std::abs(volumes[v]) <= 1e-10 * edges)
            {
              result.n_positive = numbers::invalid_unsigned_int; // degenerate
              result.last_other = v;
              return result;
            }
          if (volumes[v] > 0)
            {
              ++result.n_positive;
              result.last_positive = v;
            }
          else
            result.last_other = v;
        }
      return result;
    }



    template <int dim>
    void
    turn(CellData<dim> &cell)
    {
      if (dim == 2)
        std::swap(cell.vertices[1], cell.vertices[2]);
      else
        for (unsigned int v = 0; v < 4; ++v)
          std::swap(cell.vertices[v], cell.vertices[v + 4]);
    }
  } // namespace



  template <int dim>
  void
  orient(std::vector<CellData<dim>>                   &cells,
         const std::vector<Point<dim>>                &vertices,
         const std::vector<const MeshFile::Element *> &elements)
  {
    constexpr unsigned int all      = GeometryInfo<dim>::vertices_per_cell;
    unsigned int           n_folded = 0;
    std::string            first;
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        const Corners<dim> corners = corners_of(cells[c], vertices);
        if (corners.n_positive == 0)
          turn(cells[c]);
        else if (corners.n_positive != all && ++n_folded == 1)
          {
            const bool         mostly_turned = corners.n_positive < all / 2;
            const unsigned int v = mostly_turned ? corners.last_positive : corners.last_other;
            first = "element " + std::to_string(elements[c]->number) + " at its corner " +
                    text_of(vertices[cells[c].vertices[v]]);
          }
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
