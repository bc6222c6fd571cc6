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
    /// How much slipping points hold the bodies: the trial traction relative to its bound. Where
    /// tractions act mainly in one direction, only their component along it counts, which is
    /// negative at points that push the body instead of holding it.
    class HoldingLoad
    {
    public:
      /// Determine the direction. Collective.
      /// @param contact to which the object refers
      /// @param trial trial traction of the law, to which the object refers
      /// @param status of the points
      HoldingLoad(const GapOperator &contact, const PointVectors &trial, const LA::Vector &status)
        : contact(contact)
        , trial(trial)
        , status(status)
        , direction(contact.geometry.position.size(), 0.)
      {
        const MPI_Comm comm = status.get_mpi_communicator();
        double         all  = 0;
        for (const auto i : status.locally_owned_elements())
          if (slips(i))
            {
              for (unsigned int d = 0; d < direction.size(); ++d)
                direction[d] += contact.weight(i) * in_space(i, d);
              all += contact.weight(i) * length_at(trial, i, 1);
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
        return status_of(status(i)) == ContactStatus::slip && bound(i) > 0;
      }

      /// @return the load of a point that slips.
      double
      operator()(const types::global_dof_index i) const
      {
        if (direction.empty())
          return length_at(trial, i, 1) / bound(i);
        double along = 0;
        for (unsigned int d = 0; d < direction.size(); ++d)
          along += in_space(i, d) * direction[d];
        return along / bound(i);
      }

    private:
      double
      bound(const types::global_dof_index i) const
      {
        return contact.coefficients.friction_bound(i, trial[0](i)).value;
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

      const GapOperator  &contact;
      const PointVectors &trial;
      const LA::Vector   &status;
      /// Unit vector of the sum of all tractions; empty if they have no common direction.
      std::vector<double> direction;
    };
  } // namespace



  unsigned int
  ActiveSet::stick_least_loaded(const PointVectors &trial, const double share)
  {
    const MPI_Comm    comm = now.get_mpi_communicator();
    const LA::Vector  status(now);
    const HoldingLoad load(contact, trial, status);
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
    const auto          bound = [&](const auto i) {
      return contact.coefficients.friction_bound(i, trial[0](i)).value;
    };
    const auto load         = [&](const auto i) { return length_at(trial, i, 1) / bound(i); };
    const auto for_releases = [&](const auto &act) {
      contact.for_each_point([&](const auto i, const unsigned int pair) {
        if (status_of(now(i)) == ContactStatus::slip &&
            status_of(last(i)) == ContactStatus::stick && bound(i) > 0)
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
