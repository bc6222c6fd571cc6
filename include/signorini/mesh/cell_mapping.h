#pragma once

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
  /// higher degree, rotations cause strains of the order of the cell's size.
  template <int dim>
  class CellMapping : public dealii::MappingQ<dim>
  {
  public:
    /// @param degree the largest one; bodies of other degrees than this have degree 1
    CellMapping(unsigned int degree, std::vector<unsigned int> degree_of_material);

    std::unique_ptr<dealii::Mapping<dim>>
    clone() const override;

  protected:
    std::vector<dealii::Point<dim>>
    compute_mapping_support_points(
      const typename dealii::Triangulation<dim>::cell_iterator &cell) const override;

  private:
    const std::vector<unsigned int>       degree_of_material;
    const std::vector<dealii::Point<dim>> unit_nodes; ///< in the order of the support points
  };
} // namespace Signorini
