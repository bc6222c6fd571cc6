// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/any_cell_mapping.h"

#include <deal.II/fe/fe_q.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// The mapping of the cells of all bodies of a mesh, which are identified by the material ids of
  /// their cells. Cells of bodies of degree 1 are multilinear, whatever the manifolds of their
  /// boundaries; those of other bodies follow the manifolds.
  ///
  /// A displacement of degree k contains the rigid-body modes of a cell of degree k at most: on
  /// cells of higher degree, rotations would cause strains of the order of the size of the cell. It
  /// does not contain those of a cell either that hangs on a larger one with nodes on the manifold:
  /// there it is constrained to the shape functions of the larger cell on its edge or face. Hanging
  /// nodes are therefore placed on this edge or face, so that neighbouring cells neither overlap
  /// nor leave gaps.
  template <int dim>
  class CellMapping : public AnyCellMapping<dim>
  {
  public:
    /// Create the mapping of a mesh as it is refined at present. Throws SceneError if cells are
    /// inverted. Collective.
    /// @param degree the largest degree; bodies of other degrees have degree 1
    /// @param degree_of_material the degree of the body of each material id
    /// @param triangulation the mesh
    /// @param has_simplices whether it has triangles or tetrahedra, whose cells are of degree 2 at
    /// most and do not hang
    CellMapping(unsigned int                      degree,
                std::vector<unsigned int>         degree_of_material,
                const dealii::Triangulation<dim> &triangulation,
                bool                              has_simplices);

    std::unique_ptr<dealii::Mapping<dim>>
    clone() const override;

    boost::container::small_vector<dealii::Point<dim>, dealii::GeometryInfo<dim>::vertices_per_cell>
    get_vertices(const typename dealii::Triangulation<dim>::cell_iterator &cell) const override;

  protected:
    std::vector<dealii::Point<dim>>
    compute_mapping_support_points(
      const typename dealii::Triangulation<dim>::cell_iterator &cell) const override;

    /// Cells whose vertices are translations of those of others may have other hanging nodes: no
    /// similarity is assumed where nodes were moved.
    dealii::CellSimilarity::Similarity
    fill_fe_values(
      const typename dealii::Triangulation<dim>::cell_iterator          &cell,
      dealii::CellSimilarity::Similarity                                 similarity,
      const dealii::Quadrature<dim>                                     &quadrature,
      const typename dealii::Mapping<dim>::InternalDataBase             &data,
      dealii::internal::FEValuesImplementation::MappingRelatedData<dim> &output) const override;

  private:
    using Cell  = typename dealii::Triangulation<dim>::cell_iterator;
    using Nodes = std::vector<dealii::Point<dim>>;

    /// The hanging vertices, lines and quadrilaterals, by their numbers in the triangulation.
    struct Hanging;

    /// Throw SceneError if a simplex is inverted. Collective.
    void
    check_simplices(const dealii::Triangulation<dim> &triangulation) const;

    /// Compute `moved`. Collective.
    void
    place_hanging_nodes(const dealii::Triangulation<dim> &triangulation);

    /// @return the nodes of a cell on the manifolds, as many as the degree of its body requires.
    Nodes
    nodes_on_manifolds(const Cell &cell) const;

    /// @return the nodes of a cell, with hanging ones on the edge or face that it shares with the
    /// larger cell.
    Nodes
    nodes(const Cell &cell, const Hanging &hanging) const;

    /// @return the support points of the mapping, interpolated from the nodes of the degree of the
    /// body.
    Nodes
    support_points(Nodes nodes) const;

    const std::vector<unsigned int>          degree_of_material;
    std::shared_ptr<const dealii::FE_Q<dim>> shapes;
    /// Reference coordinates of the support points, in their order.
    const Nodes unit_nodes;

    /// The support points of the active cells of which some are not on the manifold.
    struct Moved
    {
      /// For each active cell the index into `points`, or invalid; empty if there are no such
      /// cells.
      std::vector<unsigned int> places;
      std::vector<Nodes>        points;
    };
    /// Shared by clones.
    std::shared_ptr<const Moved> moved;
  };
} // namespace Signorini
