// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

namespace Signorini
{
  /// The run was interrupted by a signal or by its time limit. Not an error; thrown by all ranks.
  class Interrupted : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// Watches for interruptions from outside while the object exists: the signals SIGTERM, SIGINT
  /// and SIGUSR1, and a time limit. A second signal, more than a second after the first, ends the
  /// process at once.
  class Interruption
  {
  public:
    /// Install the signal handlers; the destructor restores the former ones.
    /// @param clock of the run
    /// @param limit wall time [s] on that clock; 0: none
    /// @param comm the ranks
    Interruption(const dealii::Timer &clock, double limit, MPI_Comm comm);
    ~Interruption();

    Interruption(const Interruption &) = delete;
    Interruption &
    operator=(const Interruption &) = delete;

    /// Throws Interrupted on all ranks if one of them has received a signal, or if the time limit
    /// would be exceeded before the next call. To be called often. Collective.
    void
    check();

    /// Set the time that is needed after an interruption.
    /// @param seconds for a checkpoint [s]; 1 by default
    void
    set_reserve(const double seconds)
    {
      reserve = seconds;
    }

  private:
    const dealii::Timer          &clock;
    const double                  limit;
    const MPI_Comm                comm;
    double                        last_call = 0, longest_pause = 0, reserve = 1;
    std::vector<struct sigaction> former;
  };

  /// Call Interruption::check() of the existing object, if there is one. All long computations call
  /// this, on all ranks alike: each search, each step of Newton's method and of a line search, and
  /// products of Krylov methods. Collective.
  void
  check_for_interruption();
} // namespace Signorini
