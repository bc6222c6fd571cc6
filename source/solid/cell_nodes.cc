// SPDX-License-Identifier: Apache-2.0
#include "solid/cell_nodes.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The support points of each element as quadrature rules.
    template <int dim>
    hp::QCollection<dim>
    nodes_of(const hp::FECollection<dim> &elements)
    {
      hp::QCollection<dim> result;
      for (const auto &fe : elements)
        result.push_back(Quadrature<dim>(fe.get_unit_support_points()));
      return result;
    }
  } // namespace



  template <int dim>
  CellNodes<dim>::CellNodes(const Mesh<dim> &mesh, const hp::FECollection<dim> &elements)
    : values(mesh.mappings(), elements, nodes_of(elements), update_quadrature_points)
  {}



  template <int dim>
  const std::vector<Point<dim>> &
  CellNodes<dim>::operator()(const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    values.reinit(cell);
    return values.get_present_fe_values().get_quadrature_points();
  }



  template class CellNodes<2>;
  template class CellNodes<3>;
} // namespace Signorini
