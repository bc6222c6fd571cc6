#include <signorini/mesh/cell_mapping.h>

#include <deal.II/fe/fe_q.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  CellMapping<dim>::CellMapping(const unsigned int        degree,
                                std::vector<unsigned int> degree_of_material)
    : MappingQ<dim>(degree)
    , degree_of_material(std::move(degree_of_material))
    , unit_nodes(FE_Q<dim>(degree).get_unit_support_points())
  {}



  template <int dim>
  std::unique_ptr<Mapping<dim>>
  CellMapping<dim>::clone() const
  {
    return std::make_unique<CellMapping>(*this);
  }



  template <int dim>
  std::vector<Point<dim>>
  CellMapping<dim>::compute_mapping_support_points(
    const typename Triangulation<dim>::cell_iterator &cell) const
  {
    if (degree_of_material.at(cell->material_id()) == this->get_degree())
      return MappingQ<dim>::compute_mapping_support_points(cell);
    std::vector<Point<dim>> points(unit_nodes.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      for (const unsigned int v : cell->vertex_indices())
        points[i] += GeometryInfo<dim>::d_linear_shape_function(unit_nodes[i], v) * cell->vertex(v);
    return points;
  }



  template class CellMapping<2>;
  template class CellMapping<3>;
} // namespace Signorini
