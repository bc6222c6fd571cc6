// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace Fuzz
{
  /// The same numbers on all machines: distributions of the standard library are not.
  class Random
  {
  public:
    explicit Random(std::uint64_t seed)
      : engine(seed)
    {}

    /// 0 to n - 1; 0 if n is 0.
    std::size_t
    below(std::size_t n);

    bool
    one_in(std::size_t n)
    {
      return below(n) == 0;
    }

  private:
    std::mt19937_64 engine;
  };

  /// A number for a text, the same on all machines.
  std::uint64_t
  hash_of(const std::string &text);

  /// What mutants are made of.
  struct Stock
  {
    std::vector<std::string> seeds;
    std::vector<std::string> words; ///< that the format knows
  };

  /// A seed with a few mistakes, always the same one for a number.
  std::string
  mutant(const Stock &stock, std::uint64_t number);
} // namespace Fuzz
