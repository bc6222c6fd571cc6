// SPDX-License-Identifier: Apache-2.0
#include "contact/traction/normal_stress.h"
#include "linear_algebra/diagonal.h"
#include "linear_algebra/sparsity_pattern.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Assemble a matrix of means over points, rows times degrees of freedom of another field: sum
    /// of share times row of the point, over the area. Collective.
    /// @param of_point the member of a contact point that is its row of the field
    /// @param columns degrees of freedom of the field owned by this rank
    template <int dim>
    void
    assemble(LA::SparseMatrix &S,
             SparseRow ContactPoint<dim>::          *of_point,
             const IndexSet                         &columns,
             const ContactRows                      &rows,
             const std::vector<ContactSurface<dim>> &surfaces,
             const GapOperator                      &contact)
    {
      // The same loop is used twice: for the pattern, and for the values.
      const auto for_entries = [&](const auto &visit) {
        for (unsigned int p = 0; p < surfaces.size(); ++p)
          for (unsigned int q = 0; q < surfaces[p].points.size(); ++q)
            for (const auto &[row, weight] : rows.shares[p][q])
              for (const auto &[column, value] : surfaces[p].points[q].*of_point)
                visit(row, column, weight * value);
      };
      LA::SparsityPattern pattern(
        rows.owned, columns, rows.writable, contact.weight.get_mpi_communicator(), 0u);
      for_entries([&](const auto row, const auto column, double) { pattern.add(row, column); });
      pattern.compress();
      S.reinit(pattern);
      for_entries(
        [&](const auto row, const auto column, const double value) { S.add(row, column, value); });
      S.compress(VectorOperation::add);
      LA::Vector inverse = contact.zero();
      for (const auto i : inverse.locally_owned_elements())
        inverse(i) = 1 / contact.weight(i);
      inverse.compress(VectorOperation::insert);
      LA::scale_rows(S, inverse);
    }

    /// The part of the normal stress that depends on no unknown, as a mean over the points of each
    /// row. Collective.
    template <int dim>
    LA::Vector
    offsets(const ContactRows                      &rows,
            const std::vector<ContactSurface<dim>> &surfaces,
            const GapOperator                      &contact)
    {
      LA::Vector sum;
      sum.reinit(rows.owned, rows.writable, contact.weight.get_mpi_communicator(), true);
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        for (unsigned int q = 0; q < surfaces[p].points.size(); ++q)
          for (const auto &[row, weight] : rows.shares[p][q])
            sum(row) += weight * surfaces[p].points[q].stress_offset;
      sum.compress(VectorOperation::add);
      LA::Vector result = contact.zero();
      for (const auto i : result.locally_owned_elements())
        result(i) = sum(i) / contact.weight(i);
      result.compress(VectorOperation::insert);
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
                        GapOperator                            &contact)
  {
    if (elasticity.thermal().any())
      assemble(contact.S_thermal,
               &ContactPoint<dim>::thermal_stress,
               elasticity.thermal().owned(),
               rows,
               surfaces,
               contact);
    contact.fixed_stress = offsets(rows, surfaces, contact);
    if (!elasticity.volumetric_stress().empty())
      assemble(contact.S_volumetric,
               &ContactPoint<dim>::volumetric_stress,
               elasticity.volumetric_stress().owned(),
               rows,
               surfaces,
               contact);
  }



  template void
  assemble_field_stress(const Elasticity<2> &,
                        const ContactRows &,
                        const std::vector<ContactSurface<2>> &,
                        GapOperator &);
  template void
  assemble_field_stress(const Elasticity<3> &,
                        const ContactRows &,
                        const std::vector<ContactSurface<3>> &,
                        GapOperator &);
} // namespace Signorini
