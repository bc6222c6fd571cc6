// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/fe/mapping_fe.h>

#include <vector>

namespace Signorini
{
  /// The mapping of triangles and tetrahedra of degree 1 or 2: corners, and with degree 2 the
  /// middles of lines on the manifolds of these lines. The class of deal.II uses the manifold of
  /// the cell alone, has no inverse, and knows no degrees by body.
  template <int dim>
  class SimplexMapping : public dealii::MappingFE<dim>
  {
  public:
    /// @param degree 1 or 2
    /// @param degree_of_material the degree of the body of each material id: cells of bodies of
    /// degree 1 are straight; empty: all follow the manifolds
    SimplexMapping(unsigned int degree, const std::vector<unsigned int> &degree_of_material);

    std::unique_ptr<dealii::Mapping<dim>>
    clone() const override;

    /// @return the reference coordinates of a point, by Newton's method. Throws
    /// ExcTransformationFailed if there are none near the cell.
    dealii::Point<dim>
    transform_real_to_unit_cell(const typename dealii::Triangulation<dim>::cell_iterator &cell,
                                const dealii::Point<dim> &x) const override;

    /// @return the corners and middles of lines of a cell.
    std::vector<dealii::Point<dim>>
    compute_mapping_support_points(
      const typename dealii::Triangulation<dim>::cell_iterator &cell) const override;

  private:
    const std::vector<unsigned int> degree_of_material;
  };
} // namespace Signorini
