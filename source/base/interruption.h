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
  /// A run that was asked to end, or has to. Not an error; thrown by all ranks.
  class Interrupted : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// Watches, while it lives, for what ends a run from outside: the signals SIGTERM, SIGINT and
  /// SIGUSR1, and a limit on time. A second signal, more than a second after the first, ends the
  /// process at once.
  class Interruption
  {
  public:
    /// @param limit wall time [seconds] on that clock; 0: none
    Interruption(const dealii::Timer &clock, double limit, MPI_Comm comm);
    ~Interruption();

    Interruption(const Interruption &) = delete;
    Interruption &
    operator=(const Interruption &) = delete;

    /// To be called often. Throws Interrupted on all ranks if one of them has got a signal, or if
    /// time would be over before the next call. Collective.
    void
    check();

    /// Seconds that are needed after the end, for a checkpoint; 1 if nothing is said.
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

  /// Interruption::check() of the one that lives, if there is one. Whatever may take long calls
  /// this, on all ranks alike: each search, each step of Newton's method and of a line search, and
  /// products of Krylov methods. Collective.
  void
  check_for_interruption();
} // namespace Signorini
