// SPDX-License-Identifier: Apache-2.0
// The part of the active set that lets fronts advance: of slip, and of contact that opens.
#include "solver/active_set.h"
#include "solver/trial_friction.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // In a thin body the points beside those that begin to slip take over what these lose, one after
  // the other, each up to its own bound. In a bar that a force P pulls along a foundation slip
  // reaches P/b, with the bound b per length (shear-lag theory). It spreads by rings of neighbours:
  // to a ring as long as that cannot bear the rest. Pairs are left alone in which points return to
  // stick or turn, and in which nearly all that sticks would have to slip.
  void
  ActiveSet::spread_slip(const PointVectors &trial, PointVectors &traction)
  {
    constexpr double    nearly_all = 0.75;
    const MPI_Comm      comm       = now.get_mpi_communicator();
    const unsigned int  n_pairs    = contact.n_pairs();
    const TrialFriction friction{contact, trial};
    const auto          has = [&](const LA::Vector &status, const auto i, const ContactStatus one) {
      return status_of(status(i)) == one && contact.coefficients.friction(i) > 0;
    };
    // The force beyond the bounds at the points that begin to slip, a vector for each pair; and how
    // many points of the pair return.
    const unsigned int               dim = contact.geometry.position.size();
    std::vector<std::vector<double>> direction(n_pairs, std::vector<double>(dim, 0.));
    std::vector<double>              returning(n_pairs, 0.);
    LA::Vector                       inside = contact.zero();
    contact.for_each_point([&](const auto i, const unsigned int p) {
      if (has(now, i, ContactStatus::slip) && has(last, i, ContactStatus::stick))
        {
          inside(i)           = 1;
          const double excess = contact.weight(i) * (1 - friction.bound(i) / friction.size(i));
          for (unsigned int d = 0; d < dim; ++d)
            direction[p][d] += excess * friction.in_space(i, d);
        }
      if (!has(last, i, ContactStatus::slip))
        return;
      double turns = 0;
      for (unsigned int a = 1; a < trial.size(); ++a)
        turns += trial[a](i) * traction[a](i);
      returning[p] +=
        has(now, i, ContactStatus::stick) || (has(now, i, ContactStatus::slip) && turns < 0);
    });
    inside.compress(VectorOperation::insert);
    Utilities::MPI::sum(returning, comm, returning);
    std::vector<double> excess(n_pairs, 0.), spare(n_pairs, 0.);
    for (unsigned int p = 0; p < n_pairs; ++p)
      {
        Utilities::MPI::sum(direction[p], comm, direction[p]);
        for (const double component : direction[p])
          excess[p] = std::hypot(excess[p], component);
        for (double &component : direction[p])
          component /= excess[p] > 0 ? excess[p] : 1;
        if (returning[p] > 0)
          excess[p] = 0;
      }
    // What sticking points can bear in addition.
    const auto for_sticking = [&](const auto &act) {
      contact.for_each_point([&](const auto i, const unsigned int p) {
        if (excess[p] > 0 && has(now, i, ContactStatus::stick))
          act(i, p);
      });
    };
    const auto add_spare = [&](const auto i, const unsigned int p) {
      spare[p] += contact.weight(i) * (friction.bound(i) - friction.along(i, direction[p]));
    };
    const auto is_any = [&] {
      return std::any_of(excess.begin(), excess.end(), [](const double one) { return one > 0; });
    };
    for_sticking(add_spare);
    Utilities::MPI::sum(spare, comm, spare);
    for (unsigned int p = 0; p < n_pairs; ++p)
      if (excess[p] > nearly_all * spare[p])
        excess[p] = 0;
    while (is_any())
      {
        const LA::Vector grown    = contact.origin.regions.with_neighbours(inside);
        const auto       for_ring = [&](const auto &act) {
          for_sticking([&](const auto i, const unsigned int p) {
            if (grown(i) > 0 && inside(i) == 0)
              act(i, p);
          });
        };
        spare.assign(n_pairs, 0.);
        for_ring(add_spare);
        Utilities::MPI::sum(spare, comm, spare);
        for (unsigned int p = 0; p < n_pairs; ++p)
          excess[p] = spare[p] > 0 && spare[p] < excess[p] ? excess[p] - spare[p] : 0.;
        for_ring([&](const auto i, const unsigned int p) {
          now(i) = static_cast<double>(ContactStatus::slip);
          for (unsigned int a = 1; a < trial.size(); ++a)
            {
              double along = 0;
              for (unsigned int d = 0; d < dim; ++d)
                along += direction[p][d] * contact.tangential.direction[a - 1][d](i);
              traction[a](i) = friction.bound(i) * along;
            }
        });
        now.compress(VectorOperation::insert);
        for (LA::Vector &component : traction)
          component.compress(VectorOperation::insert);
        inside = grown;
      }
  }
} // namespace Signorini
