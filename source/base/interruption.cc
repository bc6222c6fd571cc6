// SPDX-License-Identifier: Apache-2.0
#include "base/interruption.h"

#include <signorini/base/text.h>

#include <algorithm>
#include <ctime>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A signal that ends a run.
    struct Watched
    {
      int         number;
      const char *name;
    };

    constexpr Watched signals[] = {{SIGTERM, "SIGTERM"}, {SIGINT, "SIGINT"}, {SIGUSR1, "SIGUSR1"}};

    // Signal handlers may access variables of these types only.
    volatile std::sig_atomic_t received    = 0;
    volatile std::time_t       received_at = 0;

    Interruption *living = nullptr;

    /// The signal handler. A second signal, more than a second after the first, terminates the
    /// process at once.
    extern "C" void
    note_signal(const int number)
    {
      // MPI launchers may send the same signal twice.
      const std::time_t now = std::time(nullptr);
      if (received != 0 && now > received_at + 1)
        {
          std::signal(number, SIG_DFL);
          std::raise(number);
        }
      if (received == 0)
        received_at = now;
      received = number;
    }
  } // namespace



  Interruption::Interruption(const Timer &clock, const double limit, const MPI_Comm comm)
    : clock(clock)
    , limit(limit)
    , comm(comm)
  {
    received = 0;
    living   = this;
    for (const Watched &one : signals)
      {
        struct sigaction action = {}, before = {};
        action.sa_handler = note_signal;
        action.sa_flags   = SA_RESTART;
        sigaction(one.number, &action, &before);
        former.push_back(before);
      }
  }



  Interruption::~Interruption()
  {
    living = nullptr;
    for (unsigned int i = 0; i < former.size(); ++i)
      sigaction(signals[i].number, &former[i], nullptr);
  }



  // The time limit accounts for the longest time between two calls, and for the reserve; the
  // decision is the same on all ranks.
  void
  Interruption::check()
  {
    const double now = clock.wall_time();
    longest_pause    = std::max(longest_pause, now - last_call);
    last_call        = now;
    const bool is_late =
      limit > 0 && Utilities::MPI::max(now + longest_pause + reserve, comm) > limit;
    const int signal = Utilities::MPI::max(int(received), comm);
    for (const Watched &one : signals)
      if (one.number == signal)
        throw Interrupted(std::string("interrupted by ") + one.name);
    if (is_late)
      throw Interrupted("interrupted: the next step may not end within Output/Time limit = " +
                        short_text(limit / 60, 4) + " minutes");
  }



  void
  check_for_interruption()
  {
    if (living)
      living->check();
  }
} // namespace Signorini
