// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

/// What a reader may take, and what happens if it takes more, or crashes.
namespace Fuzz
{
  /// Sanitizers have allocators of their own, which are not counted.
  constexpr bool with_sanitizers =
#if defined(__SANITIZE_ADDRESS__)
    true;
#else
    false;
#endif

  /// Bytes that operator new has given and nobody has given back.
  std::size_t
  live_bytes();

  /// From here on operator new throws where more than `limit` would be added to what is there. 0:
  /// no limit.
  void
  limit_allocations(std::size_t limit);

  /// Most bytes at one time since limit_allocations(), without what was there.
  std::size_t
  largest_allocation();

  /// True if more was asked for since limit_allocations().
  bool
  too_much_was_asked();

  /// What all of the process may take on top of what it has: bounds what operator new does not see.
  void
  limit_addresses(std::size_t more);

  /// Seconds of the processor, which other processes do not prolong.
  double
  processor_seconds();

  /// Crashes, and hangs of more than `seconds`, write the text that is being read to a file, and
  /// end the process with exit code 1.
  class Watch
  {
  public:
    Watch(double seconds);

    /// The text must stay where it is.
    /// @param file for the text @param how words for the report
    void
    begin(const std::string &text, const std::string &file, const std::string &how);

    void
    end();

  private:
    const double seconds;
  };
} // namespace Fuzz
