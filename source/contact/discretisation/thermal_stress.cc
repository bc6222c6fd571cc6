#include <signorini/contact/discretisation/thermal_stress.h>
#include <signorini/linear_algebra/diagonal.h>
#include <signorini/linear_algebra/sparsity_pattern.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  assemble_thermal_stress(const ThermalStrain<dim>               &thermal,
                          const ContactRows                      &rows,
                          const std::vector<ContactSurface<dim>> &surfaces,
                          GapOperator                            &contact)
  {
    if (!thermal.any())
      return;
    const auto for_entries = [&](const auto &visit) {
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        for (unsigned int q = 0; q < surfaces[p].points.size(); ++q)
          for (const auto &[row, weight] : rows.shares[p][q])
            for (const auto &[column, value] : surfaces[p].points[q].thermal_stress)
              visit(row, column, weight * value);
    };
    LA::SparsityPattern pattern(
      rows.owned, thermal.owned(), rows.writable, contact.weight.get_mpi_communicator(), 0u);
    for_entries([&](const auto row, const auto column, double) { pattern.add(row, column); });
    pattern.compress();
    contact.S_thermal.reinit(pattern);
    for_entries([&](const auto row, const auto column, const double value) {
      contact.S_thermal.add(row, column, value);
    });
    contact.S_thermal.compress(VectorOperation::add);
    LA::Vector inverse = contact.zero();
    for (const auto i : inverse.locally_owned_elements())
      inverse(i) = 1 / contact.weight(i);
    inverse.compress(VectorOperation::insert);
    LA::scale_rows(contact.S_thermal, inverse);
  }



  template void
  assemble_thermal_stress(const ThermalStrain<2> &,
                          const ContactRows &,
                          const std::vector<ContactSurface<2>> &,
                          GapOperator &);
  template void
  assemble_thermal_stress(const ThermalStrain<3> &,
                          const ContactRows &,
                          const std::vector<ContactSurface<3>> &,
                          GapOperator &);
} // namespace Signorini
