// SPDX-License-Identifier: Apache-2.0
#include "limits.h"

#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <new>

namespace
{
  // Plain data, which allocations before and after main() may use as well.
  std::atomic<std::size_t> live{0}, peak{0}, start{0}, most{0};
  std::atomic<bool>        was_too_much{false};
} // namespace



#if !defined(__SANITIZE_ADDRESS__)
namespace
{
  void *
  give(const std::size_t size, const std::size_t alignment = 0)
  {
    if (most > 0 && (size > most || live + size > start + most))
      {
        was_too_much = true;
        throw std::bad_alloc();
      }
    const std::size_t blocks = alignment > 0 ? (size + alignment - 1) / alignment : 0;
    void *const       place  = alignment > 0 ? std::aligned_alloc(alignment, blocks * alignment) :
                                               std::malloc(std::max<std::size_t>(size, 1));
    if (!place)
      throw std::bad_alloc();
    const std::size_t now = live += malloc_usable_size(place);
    if (now > peak)
      peak = now;
    return place;
  }

  void
  take_back(void *const place)
  {
    if (place)
      live -= malloc_usable_size(place);
    std::free(place);
  }
} // namespace

// All other forms end in these.
void *
operator new(const std::size_t size)
{
  return give(size);
}

void *
operator new(const std::size_t size, const std::align_val_t alignment)
{
  return give(size, static_cast<std::size_t>(alignment));
}

void
operator delete(void *const place) noexcept
{
  take_back(place);
}

void
operator delete(void *const place, std::size_t) noexcept
{
  take_back(place);
}

void
operator delete(void *const place, std::align_val_t) noexcept
{
  take_back(place);
}

void
operator delete(void *const place, std::size_t, std::align_val_t) noexcept
{
  take_back(place);
}
#else
extern "C" void
__sanitizer_set_death_callback(void (*callback)());
#endif



namespace Fuzz
{
  namespace
  {
    // What handlers of signals need, which may neither allocate nor look into strings.
    const char           *text      = nullptr;
    std::size_t           text_size = 0;
    std::array<char, 512> file{}, how{};

    void
    say(const char *words)
    {
      if (write(STDERR_FILENO, words, std::strlen(words)) < 0)
        _exit(1);
    }

    void
    keep_text()
    {
      const int out = open(file.data(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
      for (std::size_t at = 0; out >= 0 && at < text_size;)
        {
          const auto n = write(out, text + at, text_size - at);
          if (n <= 0)
            break;
          at += n;
        }
      say(how.data());
      say("\nkept as ");
      say(file.data());
      say("\n");
    }

    void
    end_by_signal(const int signal)
    {
      say("\nfuzz: DEFECT, ends by ");
      say(signal == SIGALRM ? "SIGALRM: hangs" :
          signal == SIGSEGV ? "SIGSEGV" :
          signal == SIGFPE  ? "SIGFPE" :
          signal == SIGABRT ? "SIGABRT" :
                              "another signal");
      say("\n");
      if (text)
        keep_text();
      _exit(1);
    }

#if defined(__SANITIZE_ADDRESS__)
    void
    end_by_sanitizer()
    {
      say("\nfuzz: DEFECT, ended by a sanitizer\n");
      if (text)
        keep_text();
    }
#endif

    /// On a stack of its own: that of the program may be what is used up.
    void
    handle(const int signal)
    {
      static std::array<char, 1 << 16> stack;
      stack_t                          other{};
      other.ss_sp   = stack.data();
      other.ss_size = stack.size();
      sigaltstack(&other, nullptr);
      struct sigaction action
      {};
      action.sa_handler = end_by_signal;
      action.sa_flags   = SA_ONSTACK;
      sigaction(signal, &action, nullptr);
    }

    void
    set_alarm(const double seconds)
    {
      itimerval timer{};
      timer.it_value.tv_sec = static_cast<time_t>(std::ceil(seconds));
      setitimer(ITIMER_REAL, &timer, nullptr);
    }

    void
    copy(const std::string &from, std::array<char, 512> &to)
    {
      const std::size_t n = std::min(from.size(), to.size() - 1);
      std::copy_n(from.begin(), n, to.begin());
      to[n] = '\0';
    }
  } // namespace



  std::size_t
  live_bytes()
  {
    return live;
  }



  void
  limit_allocations(const std::size_t limit)
  {
    start        = live.load();
    peak         = live.load();
    most         = limit;
    was_too_much = false;
  }



  std::size_t
  largest_allocation()
  {
    return peak - start;
  }



  bool
  too_much_was_asked()
  {
    return was_too_much;
  }



  void
  limit_addresses(const std::size_t more)
  {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, pages * sysconf(_SC_PAGESIZE) + more);
    setrlimit(RLIMIT_AS, &limit);
  }



  double
  processor_seconds()
  {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
  }



  Watch::Watch(const double seconds)
    : seconds(seconds)
  {
    handle(SIGALRM);
#if defined(__SANITIZE_ADDRESS__)
    // It tells all other signals itself, with the place in the sources.
    __sanitizer_set_death_callback(end_by_sanitizer);
#else
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
      handle(signal);
#endif
  }



  void
  Watch::begin(const std::string &what, const std::string &where, const std::string &words)
  {
    copy(where, file);
    copy(words, how);
    text      = what.data();
    text_size = what.size();
    set_alarm(seconds);
  }



  void
  Watch::end()
  {
    set_alarm(0);
    text = nullptr;
  }
} // namespace Fuzz
