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
              all += contact.weight(i) * size(i);
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
          return size(i) / bound(i);
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

      double
      size(const types::global_dof_index i) const
      {
        double square = 0;
        for (unsigned int a = 1; a < trial.size(); ++a)
          square += trial[a](i) * trial[a](i);
        return std::sqrt(square);
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
    double            sum = 0, n = 0, least = std::numeric_limits<double>::max();
    for (const auto i : now.locally_owned_elements())
      if (load.slips(i))
        {
          sum += load(i);
          ++n;
          least = std::min(least, load(i));
        }
    sum   = Utilities::MPI::sum(sum, comm);
    n     = Utilities::MPI::sum(n, comm);
    least = Utilities::MPI::min(least, comm);
    if (n == 0)
      return 0;
    // Equal loads differ by rounding.
    const double most   = least + share * (sum / n - least) + 1e-9 * std::abs(least);
    unsigned int result = 0;
    for (const auto i : now.locally_owned_elements())
      if (load.slips(i) && load(i) <= most)
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
