#pragma once

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// The coarse mesh of one body, before the bodies are put into one forest.
  template <int dim>
  struct CoarseMesh
  {
    std::vector<dealii::Point<dim>>    vertices;
    std::vector<dealii::CellData<dim>> cells; ///< with manifold ids; material ids are free
    /// All boundary faces (2D: lines, 3D: quads) with boundary id = index into `boundaries`, and
    /// all other faces, and lines in 3D, that have a manifold id; these carry the boundary id
    /// numbers::internal_face_boundary_id, which create_triangulation() takes for "none": do not
    /// renumber it.
    dealii::SubCellData      faces;
    std::vector<std::string> boundaries; ///< name of each boundary id; every boundary face has one

    /// Exact geometry: the manifold of each manifold id that cells, faces or lines carry; ids that
    /// are absent here are flat. Ids count from 0.
    std::map<dealii::types::manifold_id, std::shared_ptr<dealii::Manifold<dim>>> manifolds;

    /// Take cells, vertices, boundary ids, manifold ids and manifolds from a serial unrefined
    /// triangulation. The manifold ids are numbered anew.
    static CoarseMesh
    from_triangulation(const dealii::Triangulation<dim> &triangulation,
                       const std::vector<std::string>   &boundaries);

    /// Replace the manifold id of every cell, face and line in the lists by f(id).
    template <typename F>
    void
    map_manifold_ids(const F &f)
    {
      for (auto &cell : cells)
        cell.manifold_id = f(cell.manifold_id);
      for (auto &line : faces.boundary_lines)
        line.manifold_id = f(line.manifold_id);
      for (auto &quad : faces.boundary_quads)
        quad.manifold_id = f(quad.manifold_id);
    }
  };

  /// A way to make the mesh of a body: one file pair under mesh/generators and one line in the
  /// registry.
  template <int dim>
  class MeshGenerator
  {
  public:
    virtual ~MeshGenerator() = default;

    /// The keys of this generator, beside `Mesh`, in the body's section.
    virtual void
    declare(Section &section) = 0;

    /// Names of the boundaries, known before any mesh is made.
    virtual std::vector<std::string>
    boundaries() const = 0;

    virtual CoarseMesh<dim>
    generate() const = 0;

    /// True if the scene should be run with curved cells (a geometry of degree two or more).
    virtual bool
    curved() const = 0;

    /// `name` is one of generator_names<dim>().
    static std::unique_ptr<MeshGenerator<dim>>
    create(const std::string &name);
  };

  template <int dim>
  std::vector<std::string>
  generator_names();
} // namespace Signorini
