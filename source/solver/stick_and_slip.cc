// SPDX-License-Identifier: Apache-2.0
// The part of the active set that decides between stick and slip.
#include "solver/active_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  void
  ActiveSet::stick_where_traction_turns(const PointVectors &trial, const PointVectors &traction)
  {
    for (const auto i : now.locally_owned_elements())
      if (status_of(now(i)) == ContactStatus::slip && contact.coefficients.friction(i) > 0)
        {
          double along = 0;
          for (unsigned int a = 1; a < trial.size(); ++a)
            along += trial[a](i) * traction[a](i);
          const double n      = turns(i) + (along < 0);
          const bool   sticks = n >= 2;
          turns(i)            = sticks ? 0 : n;
          if (sticks)
            now(i) = static_cast<double>(ContactStatus::stick);
        }
    now.compress(VectorOperation::insert);
    turns.compress(VectorOperation::insert);
  }



  unsigned int
  ActiveSet::stick_least_loaded(const PointVectors &trial, const double share)
  {
    const MPI_Comm comm = now.get_mpi_communicator();
    // The trial traction relative to its bound; zero for all points but slipping ones.
    const auto load = [&](const auto i) {
      const double bound = contact.coefficients.friction_bound(i, trial[0](i)).value;
      if (status_of(now(i)) != ContactStatus::slip || bound <= 0)
        return 0.;
      double square = 0;
      for (unsigned int a = 1; a < trial.size(); ++a)
        square += trial[a](i) * trial[a](i);
      return std::sqrt(square) / bound;
    };
    double sum = 0, n = 0, least = std::numeric_limits<double>::max();
    for (const auto i : now.locally_owned_elements())
      {
        const double l = load(i);
        sum += l;
        n += l > 0;
        if (l > 0)
          least = std::min(least, l);
      }
    sum   = Utilities::MPI::sum(sum, comm);
    n     = Utilities::MPI::sum(n, comm);
    least = Utilities::MPI::min(least, comm);
    if (n == 0)
      return 0;
    // Equal loads differ by rounding.
    const double most   = (1 + 1e-9) * (least + share * (sum / n - least));
    unsigned int result = 0;
    for (const auto i : now.locally_owned_elements())
      if (const double l = load(i); l > 0 && l <= most)
        {
          now(i) = static_cast<double>(ContactStatus::stick);
          ++result;
        }
    now.compress(VectorOperation::insert);
    return Utilities::MPI::sum(result, comm);
  }



  bool
  ActiveSet::keep_kinds()
  {
    unsigned int n = 0;
    for (const auto i : now.locally_owned_elements())
      if (is_closed(now(i)) && is_closed(last(i)) && now(i) != last(i))
        {
          now(i) = last(i);
          ++n;
        }
    now.compress(VectorOperation::insert);
    return Utilities::MPI::max(n, now.get_mpi_communicator()) > 0;
  }
} // namespace Signorini
