// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Signorini
{
  /// A place in a coarse cell: its corners, and the middles of its edges and faces.
  template <int dim>
  struct NodeLocation
  {
    unsigned int       cell;                ///< coarse
    dealii::Point<dim> unit;                ///< in the unit cell
    bool               is_inserted = false; ///< by the division of cells; no node of the file
  };

  /// The nodes of a set, each with its places in all coarse cells that have it.
  template <int dim>
  using NodeSet = std::vector<std::vector<NodeLocation<dim>>>;

  /// A facet of a coarse mesh that stands for a curved surface.
  struct FacetHeight
  {
    double height = 0; ///< how far it is from the surface, about
    double length = 1; ///< of the facet

    double
    slope() const
    {
      return height / length;
    }
  };

  /// The coarse mesh of one body, before the bodies are put into one forest.
  template <int dim>
  struct CoarseMesh
  {
    std::vector<dealii::Point<dim>>    vertices;
    std::vector<dealii::CellData<dim>> cells; ///< with manifold ids; material ids are free
    /// All boundary faces (2D: lines, 3D: quads) with their boundary ids, and all other faces, and
    /// lines in 3D, that have a manifold id; these carry the boundary id
    /// numbers::internal_face_boundary_id, which create_triangulation() takes for "none": do not
    /// renumber it.
    dealii::SubCellData      faces;
    std::vector<std::string> boundaries; ///< names; every boundary face has at least one
    /// The names of each boundary id, as indices into `boundaries`. Empty: id i has the name i.
    std::vector<std::vector<unsigned int>> names_of_ids;

    /// The steepest facets that may stand for a curved surface, by names. Empty: none are.
    std::vector<FacetHeight> facets;

    /// Number of boundary ids, which count from 0.
    unsigned int
    n_boundary_ids() const
    {
      return names_of_ids.empty() ? boundaries.size() : names_of_ids.size();
    }

    /// The boundary ids that have a name.
    std::set<dealii::types::boundary_id>
    ids_of(unsigned int name) const;

    /// Exact geometry: the manifold of each manifold id that cells, faces or lines carry; ids that
    /// are absent here are flat. Ids count from 0.
    std::map<dealii::types::manifold_id, std::shared_ptr<dealii::Manifold<dim>>> manifolds;

    /// Take cells, vertices, boundary ids, manifold ids and manifolds from a serial unrefined
    /// triangulation. The manifold ids are numbered anew.
    static CoarseMesh
    from_triangulation(const dealii::Triangulation<dim>             &triangulation,
                       const std::vector<std::string>               &boundaries,
                       const std::vector<std::vector<unsigned int>> &names_of_ids = {});

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
} // namespace Signorini
