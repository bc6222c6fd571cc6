// SPDX-License-Identifier: Apache-2.0
#include "solver/active_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The number of points that are not open. Collective.
    unsigned int
    count(const LA::Vector &status)
    {
      unsigned int n = 0;
      for (const double value : status)
        n += is_closed(value);
      return Utilities::MPI::sum(n, status.get_mpi_communicator());
    }
  } // namespace



  ActiveSet::ActiveSet(const GapOperator &contact)
    : contact(contact)
    , now(contact.coefficients.least_status)
    , last(contact.coefficients.least_status)
    , changes(contact.zero())
    , turns(contact.zero())
    , advances(contact.n_pairs(), 0)
    , n_bilateral(count(contact.coefficients.least_status))
  {}



  // The set itself is kept; the hashes of former sets and the counts of changes are deleted.
  void
  ActiveSet::restart()
  {
    history.clear();
    changes = 0.;
    turns   = 0.;
    std::fill(advances.begin(), advances.end(), 0);
  }



  // Points of bilateral pairs are closed, with the status given if that is larger.
  bool
  ActiveSet::set(const LA::Vector &status)
  {
    unsigned int n_changes = 0;
    for (const auto i : now.locally_owned_elements())
      {
        const double value = std::max(contact.coefficients.least_status(i), status(i));
        n_changes += value != now(i);
        now(i) = value;
      }
    now.compress(VectorOperation::insert);
    return Utilities::MPI::max(n_changes, now.get_mpi_communicator()) > 0;
  }



  void
  ActiveSet::update(const LA::Vector &status)
  {
    last = now;
    now  = status;
  }



  unsigned int
  ActiveSet::size() const
  {
    return count(now);
  }



  unsigned int
  ActiveSet::n_active_unilateral() const
  {
    return count(now) - n_bilateral;
  }



  // A changed number of active points, with active points of unilateral pairs before, is undone.
  bool
  ActiveSet::restore_previous_if_active()
  {
    const unsigned int n = count(last);
    if (n <= n_bilateral || n == size())
      return false;
    now = last;
    return true;
  }



  bool
  ActiveSet::replace_if_empty(const LA::Vector &status)
  {
    if (n_active_unilateral() > 0)
      return false;
    now = status;
    return n_active_unilateral() > 0;
  }



  ActiveSet::Changes
  ActiveSet::count_changes()
  {
    std::vector<unsigned int> counts(2, 0);
    for (const auto i : now.locally_owned_elements())
      if (now(i) != last(i))
        {
          changes(i) += 1;
          ++counts[0];
          counts[1] += is_closed(now(i)) != is_closed(last(i));
        }
    changes.compress(VectorOperation::add);
    Utilities::MPI::sum(counts, now.get_mpi_communicator(), counts);
    return {counts[0], counts[1]};
  }



  // Keep among newly active points those with at least a share of the deepest penetration of their
  // pair, half at first (doc/theory, 4.5). With step_by_step the share is raised towards one, at
  // most ten times, until the set of each pair is not larger than four times the last one. Two to
  // twelve reductions over ranks. Collective.
  unsigned int
  ActiveSet::restrict_to_deepest(const LA::Vector &gap, const bool step_by_step)
  {
    // A surface refined once has four times as many points; by that factor, an active set can grow
    // without losing its shape.
    constexpr unsigned int growth   = 4;
    const unsigned int     n        = contact.n_pairs();
    const MPI_Comm         comm     = gap.get_mpi_communicator();
    const double           rounding = coordinate_rounding();
    std::vector<double>    deepest(n, 0.);
    // Share of the deepest penetration from which on points count, by pair.
    std::vector<double> share(n, 0.5);
    contact.for_each_point([&](const auto i, const unsigned int pair) {
      deepest[pair] = std::min(deepest[pair], gap(i));
    });
    Utilities::MPI::min(deepest, comm, deepest);

    // Points that remain: those closed before, bilateral ones, and those of pairs without
    // significant penetration.
    const auto stays = [&](const auto i, const unsigned int pair) {
      return is_closed(last(i)) || contact.coefficients.least_status(i) > 0 ||
             deepest[pair] >= -rounding || gap(i) <= share[pair] * deepest[pair];
    };
    constexpr unsigned int most_trials = 10;
    for (unsigned int trial = 0; step_by_step && trial < most_trials; ++trial)
      {
        std::vector<unsigned int> counts(2 * n, 0); // before and now
        contact.for_each_point([&](const auto i, const unsigned int pair) {
          counts[pair] += is_closed(last(i));
          counts[n + pair] += is_closed(now(i)) && stays(i, pair);
        });
        Utilities::MPI::sum(counts, comm, counts);
        bool is_too_large = false;
        for (unsigned int pair = 0; pair < n; ++pair)
          if (counts[pair] > 0 && counts[n + pair] > growth * counts[pair])
            {
              share[pair]  = (1 + share[pair]) / 2;
              is_too_large = true;
            }
        if (!is_too_large)
          break;
      }
    contact.for_each_point([&](const auto i, const unsigned int pair) {
      if (!stays(i, pair))
        now(i) = 0;
    });
    now.compress(VectorOperation::insert);
    return count(now);
  }



  // Deactivate connected regions whose active points of the last step carry a tensile force in sum
  // (doc/theory, (4.9)). Regions consist of points active now or before. A pair of which no active
  // point would be left is not changed. Collective.
  void
  ActiveSet::deactivate_tensile_regions(const LA::Vector &trial)
  {
    if (contact.origin.regions.empty())
      return;
    LA::Vector either = now, force = contact.zero();
    for (const auto i : now.locally_owned_elements())
      {
        either(i) = std::max(now(i), last(i));
        force(i)  = is_closed(last(i)) ? contact.weight(i) * trial(i) : 0.;
      }
    either.compress(VectorOperation::insert);
    force.compress(VectorOperation::insert);
    const LA::Vector sums    = contact.origin.regions.sums(either, force);
    const auto       is_left = [&](const auto i) {
      return is_closed(now(i)) && (sums(i) >= 0 || contact.coefficients.least_status(i) > 0);
    };
    std::vector<unsigned int> left(contact.n_pairs(), 0);
    contact.for_each_point(
      [&](const auto i, const unsigned int pair) { left[pair] += is_left(i); });
    Utilities::MPI::sum(left, now.get_mpi_communicator(), left);
    contact.for_each_point([&](const auto i, const unsigned int pair) {
      if (left[pair] > 0 && !is_left(i))
        now(i) = 0;
    });
    now.compress(VectorOperation::insert);
  }



  // The rounding of positions relative to each other (1e-10 of the extent of the contact points),
  // and that of the coordinates of which they are differences.
  double
  ActiveSet::coordinate_rounding() const
  {
    const MPI_Comm comm   = contact.weight.get_mpi_communicator();
    double         widest = 0, farthest = 0;
    for (const LA::Vector &x : contact.geometry.position)
      {
        double lower = std::numeric_limits<double>::max(), upper = -lower;
        for (const auto i : x.locally_owned_elements())
          {
            lower = std::min<double>(lower, x(i));
            upper = std::max<double>(upper, x(i));
          }
        lower    = Utilities::MPI::min(lower, comm);
        upper    = Utilities::MPI::max(upper, comm);
        widest   = std::max(widest, upper - lower);
        farthest = std::max({farthest, -lower, upper});
      }
    return 1e-10 * widest + 16 * std::numeric_limits<double>::epsilon() * farthest;
  }



  // Among the points of pairs with separation only significantly penetrating ones remain closed,
  // see restrict_to_deepest(), or none. Collective.
  unsigned int
  ActiveSet::deactivate_zero_gap(const LA::Vector &gap)
  {
    double deepest = 0;
    for (const auto i : gap.locally_owned_elements())
      if (contact.coefficients.least_status(i) == 0)
        deepest = std::max(deepest, -gap(i));
    deepest = Utilities::MPI::max(deepest, gap.get_mpi_communicator());
    // A single penetrating point counts as touching: at the tip of a cone, for example, the gap of
    // a node is the mean over its faces.
    if (deepest > coordinate_rounding() && n_active_unilateral() > 1)
      return restrict_to_deepest(gap);
    now = contact.coefficients.least_status;
    return count(now);
  }



  // Points with a gap of zero to rounding close. With friction they stick: it may be all that holds
  // a body. Collective.
  unsigned int
  ActiveSet::activate_zero_gap(const LA::Vector &gap)
  {
    const double rounding = coordinate_rounding();
    for (const auto i : gap.locally_owned_elements())
      if (gap(i) <= rounding && !is_closed(now(i)))
        now(i) = static_cast<double>(contact.coefficients.friction(i) > 0 ? ContactStatus::stick :
                                                                            ContactStatus::slip);
    now.compress(VectorOperation::insert);
    return count(now);
  }



  // Of all points that would open or close, keep the change of the one with the largest absolute
  // trial traction (several if they are equal). Collective.
  void
  ActiveSet::change_only_most_violated(const LA::Vector &trial)
  {
    const auto violation = [&](const auto i) {
      return is_closed(now(i)) == is_closed(last(i)) ? 0. : std::abs(trial(i));
    };
    double worst = 0;
    for (const auto i : trial.locally_owned_elements())
      worst = std::max(worst, violation(i));
    worst = Utilities::MPI::max(worst, trial.get_mpi_communicator());
    for (const auto i : trial.locally_owned_elements())
      if (const double v = violation(i); v > 0 && v < worst)
        now(i) = last(i);
    now.compress(VectorOperation::insert);
  }



  // True if the set occurred before, but not as the last one. Collective; one reduction of a hash.
  bool
  ActiveSet::is_cycling()
  {
    // The set is identified by a hash: the sum of well-mixed numbers over the closed points with
    // their kinds of status, which does not depend on the order of points nor on ranks.
    uint64_t   hash  = 0;
    const auto n_all = now.size();
    for (const auto i : now.locally_owned_elements())
      if (is_closed(now(i)))
        {
          const auto kind = static_cast<uint64_t>(now(i)) - 1;
          uint64_t   z    = (i + 1 + kind * n_all) * 0x9e3779b97f4a7c15ULL;
          z               = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
          hash += z ^ (z >> 27);
        }
    hash                  = Utilities::MPI::sum(hash, now.get_mpi_communicator());
    LA::Vector difference = now;
    difference -= last;
    // An unchanged set is not a cycle.
    return !history.insert(hash).second && difference.l1_norm() > 0;
  }



  // Points that have changed their status at least three times since restart().
  LA::Vector
  ActiveSet::chattering() const
  {
    LA::Vector result = contact.zero();
    for (const auto i : result.locally_owned_elements())
      result(i) = changes(i) >= 3 ? 1 : 0;
    result.compress(VectorOperation::insert);
    return result;
  }



  // Up to three positions of each rank, and the number of points of all ranks.
  std::string
  ActiveSet::chattering_points() const
  {
    if (contact.empty())
      return "";
    const LA::Vector   often = chattering();
    std::ostringstream text;
    unsigned int       n = 0;
    for (const auto i : changes.locally_owned_elements())
      if (often(i) > 0)
        {
          if (n++ < 3)
            {
              text << " (";
              for (unsigned int d = 0; d < contact.geometry.position.size(); ++d)
                text << (d > 0 ? ", " : "") << contact.geometry.position[d](i);
              text << ")";
            }
        }
    const MPI_Comm comm = changes.get_mpi_communicator();
    std::string    places;
    for (const std::string &part : Utilities::MPI::all_gather(comm, text.str()))
      places += part;
    n = Utilities::MPI::sum(n, comm);
    if (n == 0)
      return "";
    return "; the active set keeps changing at " + std::to_string(n) +
           (n == 1 ? " contact point," : " contact points, among them") + places;
  }
} // namespace Signorini
