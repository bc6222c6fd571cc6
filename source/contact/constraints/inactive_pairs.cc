// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/inactive_pairs.h"

namespace Signorini
{
  using namespace dealii;

  std::vector<bool>
  inactive_pairs(const GapOperator &contact, const LA::Vector &pressure, const unsigned int n_pairs)
  {
    std::vector<unsigned int> n(n_pairs, 0);
    auto                      pair = contact.origin.pair.begin();
    for (const double p : pressure)
      n[*pair++] += p != 0;
    Utilities::MPI::sum(n, pressure.get_mpi_communicator(), n);
    std::vector<bool> result;
    for (unsigned int i = 0; i < n_pairs; ++i)
      result.push_back(n[i] == 0 && (contact.interference.empty() || contact.interference[i] == 1));
    return result;
  }
} // namespace Signorini
