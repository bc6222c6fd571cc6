// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

#include <memory>
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

  /// One mapping for meshes of hypercubes and simplices: MappingQ for the former, SimplexMapping
  /// for the latter. Collections of mappings would have to have one entry for each finite element
  /// wherever they are used; with this class all of them have one.
  template <int dim>
  class AnyCellMapping : public dealii::MappingQ<dim>
  {
  public:
    using Cell         = typename dealii::Triangulation<dim>::cell_iterator;
    using InternalData = typename dealii::Mapping<dim>::InternalDataBase;
    using Output       = dealii::internal::FEValuesImplementation::MappingRelatedData<dim>;

    /// @param degree of hypercubes
    /// @param simplices the mapping of simplices; null: the mesh has none
    AnyCellMapping(unsigned int degree, std::shared_ptr<const SimplexMapping<dim>> simplices);

    std::unique_ptr<dealii::Mapping<dim>>
    clone() const override;

    bool
    is_compatible_with(const dealii::ReferenceCell &reference_cell) const override;

    boost::container::small_vector<dealii::Point<dim>, dealii::GeometryInfo<dim>::vertices_per_cell>
    get_vertices(const Cell &cell) const override;

    dealii::BoundingBox<dim>
    get_bounding_box(const Cell &cell) const override;

    dealii::Point<dim>
    transform_unit_to_real_cell(const Cell &cell, const dealii::Point<dim> &p) const override;

    dealii::Point<dim>
    transform_real_to_unit_cell(const Cell &cell, const dealii::Point<dim> &p) const override;

    void
    transform_points_real_to_unit_cell(
      const Cell                                        &cell,
      const dealii::ArrayView<const dealii::Point<dim>> &real_points,
      const dealii::ArrayView<dealii::Point<dim>>       &unit_points) const override;

    // Tensors of all kinds are transformed alike, by the mapping of the present cell.

    void
    transform(const dealii::ArrayView<const dealii::Tensor<1, dim>> &input,
              const dealii::MappingKind                              kind,
              const InternalData                                    &internal,
              const dealii::ArrayView<dealii::Tensor<1, dim>>       &output) const override
    {
      transform_by_cell(input, kind, internal, output);
    }

    void
    transform(const dealii::ArrayView<const dealii::DerivativeForm<1, dim, dim>> &input,
              const dealii::MappingKind                                           kind,
              const InternalData                                                 &internal,
              const dealii::ArrayView<dealii::Tensor<2, dim>> &output) const override
    {
      transform_by_cell(input, kind, internal, output);
    }

    void
    transform(const dealii::ArrayView<const dealii::Tensor<2, dim>> &input,
              const dealii::MappingKind                              kind,
              const InternalData                                    &internal,
              const dealii::ArrayView<dealii::Tensor<2, dim>>       &output) const override
    {
      transform_by_cell(input, kind, internal, output);
    }

    void
    transform(const dealii::ArrayView<const dealii::DerivativeForm<2, dim, dim>> &input,
              const dealii::MappingKind                                           kind,
              const InternalData                                                 &internal,
              const dealii::ArrayView<dealii::Tensor<3, dim>> &output) const override
    {
      transform_by_cell(input, kind, internal, output);
    }

    void
    transform(const dealii::ArrayView<const dealii::Tensor<3, dim>> &input,
              const dealii::MappingKind                              kind,
              const InternalData                                    &internal,
              const dealii::ArrayView<dealii::Tensor<3, dim>>       &output) const override
    {
      transform_by_cell(input, kind, internal, output);
    }

  protected:
    std::unique_ptr<InternalData>
    get_data(dealii::UpdateFlags flags, const dealii::Quadrature<dim> &rule) const override;

    std::unique_ptr<InternalData>
    get_face_data(dealii::UpdateFlags                     flags,
                  const dealii::hp::QCollection<dim - 1> &rules) const override;

    std::unique_ptr<InternalData>
    get_subface_data(dealii::UpdateFlags                flags,
                     const dealii::Quadrature<dim - 1> &rule) const override;

    dealii::CellSimilarity::Similarity
    fill_fe_values(const Cell                        &cell,
                   dealii::CellSimilarity::Similarity similarity,
                   const dealii::Quadrature<dim>     &rule,
                   const InternalData                &data,
                   Output                            &output) const override;

    void
    fill_fe_face_values(const Cell                             &cell,
                        unsigned int                            face,
                        const dealii::hp::QCollection<dim - 1> &rules,
                        const InternalData                     &data,
                        Output                                 &output) const override;

    void
    fill_fe_subface_values(const Cell                        &cell,
                           unsigned int                       face,
                           unsigned int                       subface,
                           const dealii::Quadrature<dim - 1> &rule,
                           const InternalData                &data,
                           Output                            &output) const override;

    /// Null if the mesh has no simplices.
    std::shared_ptr<const SimplexMapping<dim>> simplices;

  private:
    /// The data of both mappings, and that of the present cell.
    struct BothData;

    /// @return the data of both.
    static std::unique_ptr<InternalData>
    both(std::unique_ptr<InternalData> of_hypercubes, std::unique_ptr<InternalData> of_simplices);

    template <typename Input, typename Result>
    void
    transform_by_cell(const Input        &input,
                      dealii::MappingKind kind,
                      const InternalData &internal,
                      const Result       &output) const;
  };
} // namespace Signorini
