// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// Cells of a body of degree 1 are multilinear, whatever the manifolds of their boundaries; those
  /// of the others follow them. One object for all bodies of a mesh, whose cells know them by their
  /// material ids.
  ///
  /// A displacement of degree k has the rigid motions of a cell of degree k at most: on cells of
  /// higher degree, rotations cause strains of the order of the cell's size. Nor has it those of a
  /// cell that hangs on a larger one with nodes on the manifold: it is constrained there to what
  /// the shape functions of the larger one make of its edge or face, so that is where these nodes
  /// are. Then no space is left between the cells, nor do they overlap.
  template <int dim>
  class CellMapping : public dealii::MappingQ<dim>
  {
  public:
    /// The mapping of a mesh as it is refined now. Throws SceneError if cells are inverted.
    /// Collective.
    /// @param degree the largest degree; bodies of other degrees than this have degree 1
    CellMapping(unsigned int                      degree,
                std::vector<unsigned int>         degree_of_material,
                const dealii::Triangulation<dim> &triangulation);

    std::unique_ptr<dealii::Mapping<dim>>
    clone() const override;

    boost::container::small_vector<dealii::Point<dim>, dealii::GeometryInfo<dim>::vertices_per_cell>
    get_vertices(const typename dealii::Triangulation<dim>::cell_iterator &cell) const override;

  protected:
    std::vector<dealii::Point<dim>>
    compute_mapping_support_points(
      const typename dealii::Triangulation<dim>::cell_iterator &cell) const override;

    /// Cells whose vertices are a translation of those of others may have other hanging nodes.
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

    void
    place_hanging_nodes(const dealii::Triangulation<dim> &triangulation);

    /// The nodes of a cell on the manifolds, as many as the degree of its body has.
    Nodes
    nodes_on_manifolds(const Cell &cell) const;

    /// The nodes of a cell, with hanging ones on the edge or face of the larger cell, which is all
    /// that both cells share.
    Nodes
    nodes(const Cell &cell, const Hanging &hanging) const;

    /// The support points of the mapping from the nodes of the body's degree.
    Nodes
    support_points(Nodes nodes) const;

    const std::vector<unsigned int>          degree_of_material;
    std::shared_ptr<const dealii::FE_Q<dim>> shapes;
    const Nodes                              unit_nodes; ///< in the order of the support points

    /// Support points of those active cells of which some hang off the manifold.
    struct Moved
    {
      std::vector<unsigned int> places; ///< in the following, by active cell; empty: nothing there
      std::vector<Nodes>        points;
    };
    std::shared_ptr<const Moved> moved; ///< clones have the same
  };
} // namespace Signorini
