// SPDX-License-Identifier: Apache-2.0
#include "mesh/any_cell_mapping.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  struct AnyCellMapping<dim>::BothData : public InternalData
  {
    std::unique_ptr<InternalData> of_hypercubes, of_simplices;
    mutable bool                  is_simplex = false; // of the present cell

    std::size_t
    memory_consumption() const override
    {
      return of_hypercubes->memory_consumption() + of_simplices->memory_consumption();
    }

    /// Set the present cell.
    /// @return its data
    const InternalData &
    of(const Cell &cell) const
    {
      is_simplex = cell->reference_cell().is_simplex();
      return is_simplex ? *of_simplices : *of_hypercubes;
    }
  };



  template <int dim>
  AnyCellMapping<dim>::AnyCellMapping(const unsigned int                         degree,
                                      std::shared_ptr<const SimplexMapping<dim>> simplices)
    : MappingQ<dim>(degree)
    , simplices(std::move(simplices))
  {}



  template <int dim>
  std::unique_ptr<Mapping<dim>>
  AnyCellMapping<dim>::clone() const
  {
    return std::make_unique<AnyCellMapping<dim>>(*this);
  }



  template <int dim>
  bool
  AnyCellMapping<dim>::is_compatible_with(const ReferenceCell &reference_cell) const
  {
    return reference_cell.is_hyper_cube() || (simplices && reference_cell.is_simplex());
  }



  template <int dim>
  boost::container::small_vector<Point<dim>, GeometryInfo<dim>::vertices_per_cell>
  AnyCellMapping<dim>::get_vertices(const Cell &cell) const
  {
    return cell->reference_cell().is_simplex() ? simplices->get_vertices(cell) :
                                                 MappingQ<dim>::get_vertices(cell);
  }



  template <int dim>
  BoundingBox<dim>
  AnyCellMapping<dim>::get_bounding_box(const Cell &cell) const
  {
    return cell->reference_cell().is_simplex() ? simplices->get_bounding_box(cell) :
                                                 MappingQ<dim>::get_bounding_box(cell);
  }



  template <int dim>
  Point<dim>
  AnyCellMapping<dim>::transform_unit_to_real_cell(const Cell &cell, const Point<dim> &p) const
  {
    return cell->reference_cell().is_simplex() ?
             simplices->transform_unit_to_real_cell(cell, p) :
             MappingQ<dim>::transform_unit_to_real_cell(cell, p);
  }



  template <int dim>
  Point<dim>
  AnyCellMapping<dim>::transform_real_to_unit_cell(const Cell &cell, const Point<dim> &p) const
  {
    return cell->reference_cell().is_simplex() ?
             simplices->transform_real_to_unit_cell(cell, p) :
             MappingQ<dim>::transform_real_to_unit_cell(cell, p);
  }



  template <int dim>
  void
  AnyCellMapping<dim>::transform_points_real_to_unit_cell(
    const Cell                        &cell,
    const ArrayView<const Point<dim>> &real_points,
    const ArrayView<Point<dim>>       &unit_points) const
  {
    if (cell->reference_cell().is_simplex())
      simplices->transform_points_real_to_unit_cell(cell, real_points, unit_points);
    else
      MappingQ<dim>::transform_points_real_to_unit_cell(cell, real_points, unit_points);
  }



  // The tensors of the cell whose data were filled last.
  template <int dim>
  template <typename Input, typename Result>
  void
  AnyCellMapping<dim>::transform_by_cell(const Input        &input,
                                         const MappingKind   kind,
                                         const InternalData &internal,
                                         const Result       &output) const
  {
    // MappingQ calls this function too, with its own data.
    const auto *const data = simplices ? dynamic_cast<const BothData *>(&internal) : nullptr;
    if (data && data->is_simplex)
      simplices->transform(input, kind, *data->of_simplices, output);
    else
      MappingQ<dim>::transform(input, kind, data ? *data->of_hypercubes : internal, output);
  }



  template <int dim>
  std::unique_ptr<typename AnyCellMapping<dim>::InternalData>
  AnyCellMapping<dim>::both(std::unique_ptr<InternalData> of_hypercubes,
                            std::unique_ptr<InternalData> of_simplices)
  {
    auto data           = std::make_unique<BothData>();
    data->update_each   = of_hypercubes->update_each | of_simplices->update_each;
    data->of_hypercubes = std::move(of_hypercubes);
    data->of_simplices  = std::move(of_simplices);
    return data;
  }



  // The points of a rule for cells of one shape are valid arguments of the shape functions of the
  // other one, whose values are not used.
  template <int dim>
  std::unique_ptr<typename AnyCellMapping<dim>::InternalData>
  AnyCellMapping<dim>::get_data(const UpdateFlags flags, const Quadrature<dim> &rule) const
  {
    auto data = MappingQ<dim>::get_data(flags, rule);
    return simplices ? both(std::move(data), simplices->get_data(flags, rule)) : std::move(data);
  }



  template <int dim>
  std::unique_ptr<typename AnyCellMapping<dim>::InternalData>
  AnyCellMapping<dim>::get_face_data(const UpdateFlags               flags,
                                     const hp::QCollection<dim - 1> &rules) const
  {
    auto data = MappingQ<dim>::get_face_data(flags, rules);
    return simplices ? both(std::move(data), simplices->get_face_data(flags, rules)) :
                       std::move(data);
  }



  // Simplices have no subfaces here: they are not refined.
  template <int dim>
  std::unique_ptr<typename AnyCellMapping<dim>::InternalData>
  AnyCellMapping<dim>::get_subface_data(const UpdateFlags          flags,
                                        const Quadrature<dim - 1> &rule) const
  {
    auto data = MappingQ<dim>::get_subface_data(flags, rule);
    return simplices ? both(std::move(data), simplices->get_data(flags, Quadrature<dim>(1))) :
                       std::move(data);
  }



  template <int dim>
  CellSimilarity::Similarity
  AnyCellMapping<dim>::fill_fe_values(const Cell                      &cell,
                                      const CellSimilarity::Similarity similarity,
                                      const Quadrature<dim>           &rule,
                                      const InternalData              &data,
                                      Output                          &output) const
  {
    if (!simplices)
      return MappingQ<dim>::fill_fe_values(cell, similarity, rule, data, output);
    const InternalData &of_cell = static_cast<const BothData &>(data).of(cell);
    return cell->reference_cell().is_simplex() ?
             simplices->fill_fe_values(cell, CellSimilarity::none, rule, of_cell, output) :
             MappingQ<dim>::fill_fe_values(cell, similarity, rule, of_cell, output);
  }



  template <int dim>
  void
  AnyCellMapping<dim>::fill_fe_face_values(const Cell                     &cell,
                                           const unsigned int              face,
                                           const hp::QCollection<dim - 1> &rules,
                                           const InternalData             &data,
                                           Output                         &output) const
  {
    if (!simplices)
      return MappingQ<dim>::fill_fe_face_values(cell, face, rules, data, output);
    const InternalData &of_cell = static_cast<const BothData &>(data).of(cell);
    if (cell->reference_cell().is_simplex())
      simplices->fill_fe_face_values(cell, face, rules, of_cell, output);
    else
      MappingQ<dim>::fill_fe_face_values(cell, face, rules, of_cell, output);
  }



  template <int dim>
  void
  AnyCellMapping<dim>::fill_fe_subface_values(const Cell                &cell,
                                              const unsigned int         face,
                                              const unsigned int         subface,
                                              const Quadrature<dim - 1> &rule,
                                              const InternalData        &data,
                                              Output                    &output) const
  {
    MappingQ<dim>::fill_fe_subface_values(cell,
                                          face,
                                          subface,
                                          rule,
                                          simplices ? static_cast<const BothData &>(data).of(cell) :
                                                      data,
                                          output);
  }



  template class AnyCellMapping<2>;
  template class AnyCellMapping<3>;
} // namespace Signorini
