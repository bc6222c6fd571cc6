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
  /// A point of a coarse cell: a corner, or the middle of an edge or face.
  template <int dim>
  struct NodeLocation
  {
    /// Index of the coarse cell.
    unsigned int cell;
    /// Coordinates in the reference cell.
    dealii::Point<dim> unit;
    /// Whether it was inserted by the division of cells, and is not a node of the file.
    bool is_inserted = false;
  };

  /// A set of nodes.
  template <int dim>
  struct NodeSet
  {
    /// The nodes, each with its positions in all coarse cells that have it.
    std::vector<std::vector<NodeLocation<dim>>> nodes;
    /// The positions of nodes that are not in the set although all corners around them are.
    std::vector<NodeLocation<dim>> left_out;
  };

  /// A facet of a coarse mesh that approximates a curved surface.
  struct FacetHeight
  {
    /// Estimated distance [length] from the surface.
    double height = 0;
    /// Length [length] of the facet.
    double length = 1;

    /// @return the ratio of both.
    double
    slope() const
    {
      return height / length;
    }
  };

  /// The coarse mesh of one body, before the meshes of all bodies are merged into one forest.
  template <int dim>
  struct CoarseMesh
  {
    std::vector<dealii::Point<dim>> vertices;
    /// With manifold ids; material ids are not used.
    std::vector<dealii::CellData<dim>> cells;
    /// All boundary faces (2D: lines, 3D: quads) with their boundary ids, and all other faces, and
    /// lines in 3D, that have a manifold id; these carry the boundary id
    /// numbers::internal_face_boundary_id, which create_triangulation() takes for "none": do not
    /// renumber it.
    dealii::SubCellData faces;
    /// Names of boundaries; every boundary face has at least one.
    std::vector<std::string> boundaries;
    /// The names of each boundary id, as indices into `boundaries`. Empty: id i has the name i.
    std::vector<std::vector<unsigned int>> names_of_ids;

    /// The steepest facet of each boundary that may approximate a curved surface. Empty: there are
    /// none.
    std::vector<FacetHeight> facets;

    /// @return the number of boundary ids, which count from 0.
    unsigned int
    n_boundary_ids() const
    {
      return names_of_ids.empty() ? boundaries.size() : names_of_ids.size();
    }

    /// @return the boundary ids that have a name.
    /// @param name index into `boundaries`
    std::set<dealii::types::boundary_id>
    ids_of(unsigned int name) const;

    /// Exact geometry: the manifold of each manifold id that cells, faces or lines carry; ids that
    /// are absent here are flat. Ids count from 0.
    std::map<dealii::types::manifold_id, std::shared_ptr<dealii::Manifold<dim>>> manifolds;

    /// Create a coarse mesh from a serial triangulation without refinement, with new numbers of
    /// manifold ids.
    /// @param triangulation with boundary ids and manifolds
    /// @param boundaries names
    /// @param names_of_ids see the member
    /// @return cells, vertices, boundary ids and manifolds
    static CoarseMesh
    from_triangulation(const dealii::Triangulation<dim>             &triangulation,
                       const std::vector<std::string>               &boundaries,
                       const std::vector<std::vector<unsigned int>> &names_of_ids = {});

    /// Replace the manifold id of every cell, face and line in the lists by f(id).
    /// @param f a function of a manifold id
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
