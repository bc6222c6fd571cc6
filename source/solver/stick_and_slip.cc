// SPDX-License-Identifier: Apache-2.0
// The part of the active set that decides between stick and slip.
#include "solver/active_set.h"
#include "solver/trial_friction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  void
  ActiveSet::stick_where_traction_turns(const PointVectors &trial, const PointVectors &traction)
  {
    const TrialFriction friction{contact, trial};
    for (const auto i : now.locally_owned_elements())
      if (status_of(now(i)) == ContactStatus::slip && contact.coefficients.friction(i) > 0)
        {
          const double n      = turns(i) + friction.is_against(i, traction);
          const bool   sticks = n >= 2;
          turns(i)            = sticks ? 0 : n;
          if (sticks)
            now(i) = static_cast<double>(ContactStatus::stick);
        }
    now.compress(VectorOperation::insert);
    turns.compress(VectorOperation::insert);
  }



  namespace
  {
    /// How much slipping points hold the bodies: the trial traction relative to its bound. Where
    /// tractions act mainly in one direction, only their component along it counts, which is
    /// negative at points that push the body instead of holding it.
    class HoldingLoad
    {
    public:
      /// Determine the direction. Collective.
      /// @param trial to which the object refers
      /// @param status of the points, to which the object refers
      HoldingLoad(const TrialFriction &trial, const LA::Vector &status)
        : trial(trial)
        , status(status)
        , direction(trial.contact.geometry.position.size(), 0.)
      {
        const MPI_Comm comm = status.get_mpi_communicator();
        double         all  = 0;
        for (const auto i : status.locally_owned_elements())
          if (slips(i))
            {
              for (unsigned int d = 0; d < direction.size(); ++d)
                direction[d] += trial.contact.weight(i) * trial.in_space(i, d);
              all += trial.contact.weight(i) * trial.size(i);
            }
        Utilities::MPI::sum(direction, comm, direction);
        all              = Utilities::MPI::sum(all, comm);
        double resultant = 0;
        for (const double component : direction)
          resultant = std::hypot(resultant, component);
        if (resultant <= 0.5 * all)
          direction.clear();
        for (double &component : direction)
          component /= resultant;
      }

      bool
      slips(const types::global_dof_index i) const
      {
        return status_of(status(i)) == ContactStatus::slip && trial.bound(i) > 0;
      }

      /// @return the load of a point that slips.
      double
      operator()(const types::global_dof_index i) const
      {
        return (direction.empty() ? trial.size(i) : trial.along(i, direction)) / trial.bound(i);
      }

    private:
      const TrialFriction &trial;
      const LA::Vector    &status;
      /// Unit vector of the sum of all tractions; empty if they have no common direction.
      std::vector<double> direction;
    };
  } // namespace



  unsigned int
  ActiveSet::stick_least_loaded(const PointVectors &trial, const double share)
  {
    const MPI_Comm      comm = now.get_mpi_communicator();
    const LA::Vector    status(now);
    const TrialFriction friction{contact, trial};
    const HoldingLoad   load(friction, status);
    // Each pair may have to hold another body.
    const unsigned int  n_pairs = contact.n_pairs();
    std::vector<double> sum(n_pairs, 0.), n(n_pairs, 0.),
      least(n_pairs, std::numeric_limits<double>::max());
    const auto for_slipping_points = [&](const auto &act) {
      contact.for_each_point([&](const auto i, const unsigned int pair) {
        if (load.slips(i))
          act(i, pair);
      });
    };
    for_slipping_points([&](const auto i, const unsigned int p) {
      sum[p] += load(i);
      ++n[p];
      least[p] = std::min(least[p], load(i));
    });
    Utilities::MPI::sum(sum, comm, sum);
    Utilities::MPI::sum(n, comm, n);
    Utilities::MPI::min(least, comm, least);
    unsigned int result = 0;
    for_slipping_points([&](const auto i, const unsigned int p) {
      // Equal loads differ by rounding.
      if (load(i) <= least[p] + share * (sum[p] / n[p] - least[p]) + 1e-9 * std::abs(least[p]))
        {
          now(i) = static_cast<double>(ContactStatus::stick);
          ++result;
        }
    });
    now.compress(VectorOperation::insert);
    return Utilities::MPI::sum(result, comm);
  }



  void
  ActiveSet::slip_most_loaded(const PointVectors &trial)
  {
    const MPI_Comm      comm    = now.get_mpi_communicator();
    const unsigned int  n_pairs = contact.n_pairs();
    std::vector<double> sum(n_pairs, 0.), n(n_pairs, 0.);
    const TrialFriction friction{contact, trial};
    const auto          load = [&](const auto i) { return friction.size(i) / friction.bound(i); };
    const auto          for_releases = [&](const auto &act) {
      contact.for_each_point([&](const auto i, const unsigned int pair) {
        if (status_of(now(i)) == ContactStatus::slip &&
            status_of(last(i)) == ContactStatus::stick && friction.bound(i) > 0)
          act(i, pair);
      });
    };
    for_releases([&](const auto i, const unsigned int p) {
      sum[p] += load(i);
      ++n[p];
    });
    Utilities::MPI::sum(sum, comm, sum);
    Utilities::MPI::sum(n, comm, n);
    for_releases([&](const auto i, const unsigned int p) {
      if (load(i) < (1 - 1e-9) * sum[p] / n[p])
        now(i) = static_cast<double>(ContactStatus::stick);
    });
    now.compress(VectorOperation::insert);
  }



  void
  ActiveSet::stick_where_closing()
  {
    for (const auto i : now.locally_owned_elements())
      if (status_of(now(i)) == ContactStatus::slip && !is_closed(last(i)) &&
          contact.coefficients.friction(i) > 0)
        now(i) = static_cast<double>(ContactStatus::stick);
    now.compress(VectorOperation::insert);
  }



  // A point in a corner of two pairs may be in tension where it sticks, and penetrate where it is
  // open: it can only slip, while the law, which knows no traction of an open point, lets it stick.
  void
  ActiveSet::alternate_kinds_of_chattering_points()
  {
    constexpr unsigned int often = 4;
    for (const auto i : now.locally_owned_elements())
      if (is_closed(now(i)) && !is_closed(last(i)) && contact.coefficients.friction(i) > 0 &&
          changes(i) >= often && static_cast<unsigned int>(changes(i)) / 2 % 2 == 0)
        now(i) = static_cast<double>(
          status_of(now(i)) == ContactStatus::stick ? ContactStatus::slip : ContactStatus::stick);
    now.compress(VectorOperation::insert);
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
