// SPDX-License-Identifier: Apache-2.0
#include "contact/traction/normal_stress.h"
#include "linear_algebra/diagonal.h"
#include "linear_algebra/sparsity_pattern.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Call add(row, a, stress, factor) for the terms of component a of the stress that the points
    /// contribute to each row, factor being times the share of the area.
    template <int dim, typename Add>
    void
    for_each_share(const ContactRows                      &rows,
                   const std::vector<ContactSurface<dim>> &surfaces,
                   const Tangents<dim>                    *tangents,
                   const Add                              &add)
    {
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        for (unsigned int q = 0; q < surfaces[p].points.size(); ++q)
          for (const auto &[row, weight] : rows.shares[p][q])
            for_each_stress(surfaces[p],
                            q,
                            tangents,
                            row,
                            [&, row = row, weight = weight](const unsigned int a,
                                                            const StressRow   &stress,
                                                            const double       factor) {
                              add(row, a, stress, weight * factor);
                            });
    }

    /// Assemble matrices of means over points for each component of the stress, rows times degrees
    /// of freedom of another field: sum of share times row of the point, over the area. Collective.
    /// @param part the member of a component that is its row of the field
    /// @param columns degrees of freedom of the field owned by this rank
    template <int dim>
    std::vector<LA::SparseMatrix>
    assemble(SparseRow StressRow::                  *part,
             const IndexSet                         &columns,
             const ContactRows                      &rows,
             const std::vector<ContactSurface<dim>> &surfaces,
             const Tangents<dim>                    *tangents,
             const GapOperator                      &contact)
    {
      LA::Vector inverse = contact.zero();
      for (const auto i : inverse.locally_owned_elements())
        inverse(i) = 1 / contact.weight(i);
      inverse.compress(VectorOperation::insert);
      std::vector<LA::SparseMatrix> result(contact.n_components());
      for (unsigned int component = 0; component < result.size(); ++component)
        {
          // The same loop is used twice: for the pattern, and for the values.
          const auto for_entries = [&](const auto &visit) {
            for_each_share(
              rows,
              surfaces,
              tangents,
              [&](const auto row, const auto a, const auto &stress, const double factor) {
                if (a == component)
                  for (const auto &[column, value] : stress.*part)
                    visit(row, column, factor * value);
              });
          };
          LA::SparsityPattern pattern(
            rows.owned, columns, rows.writable, contact.weight.get_mpi_communicator(), 0u);
          for_entries([&](const auto row, const auto column, double) { pattern.add(row, column); });
          pattern.compress();
          LA::SparseMatrix &S = result[component];
          S.reinit(pattern);
          for_entries([&](const auto row, const auto column, const double value) {
            S.add(row, column, value);
          });
          S.compress(VectorOperation::add);
          LA::scale_rows(S, inverse);
        }
      return result;
    }

    /// The part of each component of the stress that depends on no unknown, as a mean over the
    /// points of each row. Collective.
    template <int dim>
    PointVectors
    offsets(const ContactRows                      &rows,
            const std::vector<ContactSurface<dim>> &surfaces,
            const Tangents<dim>                    *tangents,
            const GapOperator                      &contact)
    {
      PointVectors result = contact.zeros(), sums(result.size());
      for (LA::Vector &sum : sums)
        sum.reinit(rows.owned, rows.writable, contact.weight.get_mpi_communicator(), true);
      for_each_share(rows,
                     surfaces,
                     tangents,
                     [&](const auto row, const auto a, const auto &stress, const double factor) {
                       sums[a](row) += factor * stress.offset;
                     });
      for (unsigned int a = 0; a < result.size(); ++a)
        {
          sums[a].compress(VectorOperation::add);
          for (const auto i : result[a].locally_owned_elements())
            result[a](i) = sums[a](i) / contact.weight(i);
          result[a].compress(VectorOperation::insert);
        }
      return result;
    }
  } // namespace



  // Columns are not displacements but the coefficients of temperature and of the volumetric stress.
  // S and S_thermal are assembled apart, because the latter have numberings of their own.
  template <int dim>
  void
  assemble_field_stress(const Elasticity<dim>                  &elasticity,
                        const ContactRows                      &rows,
                        const std::vector<ContactSurface<dim>> &surfaces,
                        const Tangents<dim>                    *tangents,
                        GapOperator                            &contact)
  {
    if (elasticity.thermal().any())
      contact.S_thermal = assemble(
        &StressRow::thermal, elasticity.thermal().owned(), rows, surfaces, tangents, contact);
    contact.fixed_stress = offsets(rows, surfaces, tangents, contact);
    if (!elasticity.volumetric_stress().empty())
      contact.S_volumetric = assemble(&StressRow::volumetric,
                                      elasticity.volumetric_stress().owned(),
                                      rows,
                                      surfaces,
                                      tangents,
                                      contact);
  }



  template void
  assemble_field_stress(const Elasticity<2> &,
                        const ContactRows &,
                        const std::vector<ContactSurface<2>> &,
                        const Tangents<2> *,
                        GapOperator &);
  template void
  assemble_field_stress(const Elasticity<3> &,
                        const ContactRows &,
                        const std::vector<ContactSurface<3>> &,
                        const Tangents<3> *,
                        GapOperator &);
} // namespace Signorini
