// SPDX-License-Identifier: Apache-2.0
// The part of the active set that lets fronts advance: of slip, and of contact that opens.
#include "solver/active_set.h"
#include "solver/trial_friction.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// How points with friction have changed in a step; refers to the arguments.
    struct SlipChanges
    {
      const GapOperator &contact;
      const LA::Vector  &now, &last;

      bool
      sticks(const types::global_dof_index i) const
      {
        return is(now, i, ContactStatus::stick);
      }

      /// From stick to slip.
      bool
      begins(const types::global_dof_index i) const
      {
        return is(now, i, ContactStatus::slip) && is(last, i, ContactStatus::stick);
      }

      /// From slip to stick, or to slip against the traction.
      bool
      returns(const types::global_dof_index i,
              const TrialFriction          &friction,
              const PointVectors           &traction) const
      {
        return is(last, i, ContactStatus::slip) && is_closed(now(i)) &&
               (sticks(i) || friction.is_against(i, traction));
      }

    private:
      bool
      is(const LA::Vector &status, const types::global_dof_index i, const ContactStatus one) const
      {
        return status_of(status(i)) == one && contact.coefficients.friction(i) > 0;
      }
    };
  } // namespace



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
    const SlipChanges   slip{contact, now, last};
    // The force beyond the bounds at the points that begin to slip, a vector for each pair; and how
    // many points of the pair return.
    const unsigned int               dim = contact.geometry.position.size();
    std::vector<std::vector<double>> direction(n_pairs, std::vector<double>(dim, 0.));
    std::vector<double>              returning(n_pairs, 0.);
    LA::Vector                       inside = contact.zero();
    contact.for_each_point([&](const auto i, const unsigned int p) {
      returning[p] += slip.returns(i, friction, traction);
      if (!slip.begins(i))
        return;
      inside(i)           = 1;
      const double excess = contact.weight(i) * (1 - friction.bound(i) / friction.size(i));
      for (unsigned int d = 0; d < dim; ++d)
        direction[p][d] += excess * friction.in_space(i, d);
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
        if (excess[p] > 0 && slip.sticks(i))
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



  // Where traction has a peak, slip advances by one point a step: only the outermost point that
  // sticks is beyond its bound. After some such steps of a pair the front moves by 1, 2, 4, ...
  // further rings of neighbours in a step, until points of the pair return; what went too far
  // returns by the law.
  void
  ActiveSet::hasten_slip(const PointVectors &trial, PointVectors &traction)
  {
    constexpr unsigned int n_single = 3, most_doublings = 6;
    const unsigned int     n_pairs = contact.n_pairs();
    const TrialFriction    friction{contact, trial};
    const SlipChanges      slip{contact, now, last};
    std::vector<double>    beginning(n_pairs, 0.), returning(n_pairs, 0.);
    LA::Vector             front = contact.zero();
    contact.for_each_point([&](const auto i, const unsigned int p) {
      front(i) = slip.begins(i);
      beginning[p] += slip.begins(i);
      returning[p] += slip.returns(i, friction, traction);
    });
    front.compress(VectorOperation::insert);
    Utilities::MPI::sum(beginning, now.get_mpi_communicator(), beginning);
    Utilities::MPI::sum(returning, now.get_mpi_communicator(), returning);
    std::vector<unsigned int> n_rings(n_pairs, 0);
    unsigned int              most_rings = 0;
    for (unsigned int p = 0; p < n_pairs; ++p)
      {
        advances[p] = beginning[p] > 0 && returning[p] == 0 ? advances[p] + 1 : 0;
        if (advances[p] > n_single)
          n_rings[p] = 1u << std::min(advances[p] - n_single - 1, most_doublings);
        most_rings = std::max(most_rings, n_rings[p]);
      }
    for (unsigned int ring = 0; ring < most_rings; ++ring)
      {
        const LA::Vector grown = contact.origin.regions.with_neighbours(front);
        contact.for_each_point([&](const auto i, const unsigned int p) {
          // Points that bear less than half of their bound are far from slip.
          if (ring < n_rings[p] && grown(i) > 0 && front(i) == 0 && slip.sticks(i) &&
              friction.size(i) > 0.5 * friction.bound(i))
            {
              now(i) = static_cast<double>(ContactStatus::slip);
              for (unsigned int a = 1; a < trial.size(); ++a)
                traction[a](i) = friction.bound(i) / friction.size(i) * trial[a](i);
            }
        });
        now.compress(VectorOperation::insert);
        for (LA::Vector &component : traction)
          component.compress(VectorOperation::insert);
        front = grown;
      }
  }
} // namespace Signorini
