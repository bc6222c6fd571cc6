#include <signorini/accuracy/contact_errors.h>
#include <signorini/fields/nodal_fields.h>
#include <signorini/linear_algebra/row_view.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    bool
    can_move(const LA::SparseMatrix &B_free, const int row)
    {
      const LA::RowView view(B_free, row);
      return std::any_of(view.values, view.values + view.size, [](const double value) {
        return std::abs(value) > 1e-12;
      });
    }

    /// Of each pair, where it presses.
    template <int dim>
    std::vector<double>
    mean_pressures(const Snapshot<dim> &s)
    {
      std::vector<double> sums(2 * s.pairs.size(), 0.);
      auto                pair = s.contact.origin.pair.begin();
      for (const auto i : s.pressure.locally_owned_elements())
        {
          if (s.pressure(i) > 0)
            {
              sums[2 * *pair] += s.contact.weight(i) * s.pressure(i);
              sums[2 * *pair + 1] += s.contact.weight(i);
            }
          ++pair;
        }
      Utilities::MPI::sum(sums, s.elasticity.mesh().communicator(), sums);
      std::vector<double> result;
      for (unsigned int i = 0; i < s.pairs.size(); ++i)
        result.push_back(sums[2 * i + 1] > 0 ? sums[2 * i] / sums[2 * i + 1] : 0.);
      return result;
    }
  } // namespace



  template <int dim>
  double
  undetermined_contact(const Snapshot<dim> &s, const Functional &functional, const LA::Vector &z)
  {
    if (s.contact.empty() || !samples_nodes(s.contact))
      return 0;
    const double              closed = 1e-12 * s.elasticity.mesh().size();
    const std::vector<double> mean   = mean_pressures(s);
    LA::Vector                felt   = s.contact.zero();
    s.contact.B.vmult(felt, z);
    double sum  = 0;
    int    row  = 0;
    auto   pair = s.contact.origin.pair.begin();
    for (const auto i : felt.locally_owned_elements())
      {
        if (s.gap(i) <= closed && !can_move(s.contact.B_free, row))
          {
            // Where nothing is active the quantity's derivative may be zero.
            const double by_pressure =
              std::abs(s.contact.weight(i) * felt(i) + functional.of_pressure(i));
            sum += by_pressure * std::max(mean[*pair], s.pressure(i));
          }
        ++row;
        ++pair;
      }
    return Utilities::MPI::sum(sum, s.elasticity.mesh().communicator());
  }



  template double
  undetermined_contact(const Snapshot<2> &, const Functional &, const LA::Vector &);
  template double
  undetermined_contact(const Snapshot<3> &, const Functional &, const LA::Vector &);
} // namespace Signorini
