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



  namespace
  {
    /// The trial traction of a law and its bound of friction; refers to both arguments.
    struct TrialFriction
    {
      const GapOperator  &contact;
      const PointVectors &trial;

      double
      bound(const types::global_dof_index i) const
      {
        return contact.coefficients.friction_bound(i, trial[0](i)).value;
      }

      /// The size of the tangential trial traction.
      double
      size(const types::global_dof_index i) const
      {
        return length_at(trial, i, 1);
      }

      /// A space component of the tangential trial traction.
      double
      in_space(const types::global_dof_index i, const unsigned int d) const
      {
        double sum = 0;
        for (unsigned int a = 1; a < trial.size(); ++a)
          sum += trial[a](i) * contact.tangential.direction[a - 1][d](i);
        return sum;
      }

      /// The component of the tangential trial traction along a direction in space.
      double
      along(const types::global_dof_index i, const std::vector<double> &direction) const
      {
        double sum = 0;
        for (unsigned int d = 0; d < direction.size(); ++d)
          sum += in_space(i, d) * direction[d];
        return sum;
      }
    };

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



  void
  ActiveSet::stick_where_closing()
  {
    for (const auto i : now.locally_owned_elements())
      if (status_of(now(i)) == ContactStatus::slip && !is_closed(last(i)) &&
          contact.coefficients.friction(i) > 0)
        now(i) = static_cast<double>(ContactStatus::stick);
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
