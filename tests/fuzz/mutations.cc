// SPDX-License-Identifier: Apache-2.0
#include "mutations.h"

#include <algorithm>
#include <cctype>

namespace Fuzz
{
  namespace
  {
    using Range = std::pair<std::size_t, std::size_t>; ///< begin and end in a text

    constexpr std::size_t longest = 1 << 18; ///< of a mutant, in bytes

    const std::vector<std::string> extremes = {
      "0",          "-0",         "-1",         "1",          "2",
      "3",          "7",          "0.5",        "1e9",        "1e300",
      "-1e300",     "1e-300",     "1e400",      "nan",        "inf",
      "-inf",       "127",        "256",        "65536",      "1000000",
      "2147483647", "2147483648", "4294967295", "4294967296", "9223372036854775807",
      "0x10",       "1,5",        "1.",         ".",          "9223372036854775808",
      "+",          "1e",         "--1",        "",           "18446744073709551615",
      "-2147483648"};

    /// No text, or none in UTF-8.
    const std::vector<std::string> odd_bytes = {std::string(1, '\0'),
                                                "\xff",
                                                "\xc3",
                                                "\xc0\x80",
                                                "\xed\xa0\x80",
                                                "\xef\xbb\xbf",
                                                "\xf4\x90\x80\x80",
                                                "\r",
                                                "\r\n",
                                                "\x1a",
                                                "\x1b[31m"};

    bool
    is_in_number(const char c)
    {
      return std::isdigit(static_cast<unsigned char>(c)) || c == '.';
    }

    bool
    is_in_word(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_' || c == '-' ||
             c == '+';
    }

    bool
    is_in_line(const char c)
    {
      return c != '\n';
    }

    /// A run of such characters, at or behind a random place.
    template <typename Is>
    Range
    some_run(const std::string &text, Random &random, const Is is)
    {
      std::size_t begin = random.below(text.size());
      while (begin < text.size() && !is(text[begin]))
        ++begin;
      while (begin > 0 && begin < text.size() && is(text[begin - 1]))
        --begin;
      std::size_t end = begin;
      while (end < text.size() && is(text[end]))
        ++end;
      return {begin, end};
    }

    Range
    some_word(const std::string &text, Random &random)
    {
      return some_run(text, random, is_in_word);
    }

    /// With its end.
    Range
    some_line(const std::string &text, Random &random)
    {
      Range line = some_run(text, random, is_in_line);
      if (line.second < text.size())
        ++line.second;
      return line;
    }

    /// One to many lines.
    Range
    some_lines(const std::string &text, Random &random)
    {
      Range lines = some_line(text, random);
      for (std::size_t n = random.below(std::size_t(1) << random.below(6)); n > 0; --n)
        {
          const auto end = text.find('\n', lines.second);
          lines.second   = end == std::string::npos ? text.size() : end + 1;
        }
      return lines;
    }

    Range
    some_bytes(const std::string &text, Random &random)
    {
      const std::size_t begin = random.below(text.size() + 1);
      const std::size_t n     = random.below(std::size_t(1) << random.below(10));
      return {begin, std::min(text.size(), begin + n)};
    }

    /// Bytes, a word, a line or several.
    Range
    something(const std::string &text, Random &random)
    {
      switch (random.below(4))
        {
          case 0:
            return some_bytes(text, random);
          case 1:
            return some_word(text, random);
          case 2:
            return some_line(text, random);
          default:
            return some_lines(text, random);
        }
    }

    std::string
    part(const std::string &text, const Range &range)
    {
      return text.substr(range.first, range.second - range.first);
    }

    void
    replace(std::string &text, const Range &range, const std::string &by)
    {
      text.replace(range.first, range.second - range.first, by);
    }

    const std::string &
    one_of(const std::vector<std::string> &texts, Random &random)
    {
      static const std::string nothing;
      return texts.empty() ? nothing : texts[random.below(texts.size())];
    }



    void
    flip_bits(std::string &text, const Stock &, Random &random)
    {
      for (std::size_t n = 1 + random.below(4); n > 0 && !text.empty(); --n)
        text[random.below(text.size())] ^= static_cast<char>(1 << random.below(8));
    }

    void
    change_bytes(std::string &text, const Stock &, Random &random)
    {
      for (std::size_t n = 1 + random.below(4); n > 0 && !text.empty(); --n)
        text[random.below(text.size())] = static_cast<char>(random.below(256));
    }

    void
    insert_odd_bytes(std::string &text, const Stock &, Random &random)
    {
      text.insert(random.below(text.size() + 1), one_of(odd_bytes, random));
    }

    void
    remove(std::string &text, const Stock &, Random &random)
    {
      replace(text, something(text, random), "");
    }

    void
    repeat(std::string &text, const Stock &, Random &random)
    {
      const Range range = something(text, random);
      text.insert(range.second, part(text, range));
    }

    /// So often that what calls itself for each of them may run out of stack.
    void
    repeat_often(std::string &text, const Stock &, Random &random)
    {
      const Range range      = random.one_in(2) ? some_word(text, random) : some_line(text, random);
      const std::string what = part(text, range);
      const std::size_t most = random.one_in(8) ? longest : 4096;
      std::string       many;
      while (!what.empty() && many.size() + what.size() <= most)
        many += what;
      text.insert(range.second, many);
    }

    void
    swap(std::string &text, const Stock &, Random &random)
    {
      const bool words = random.one_in(2);
      Range      a     = words ? some_word(text, random) : some_line(text, random);
      Range      b     = words ? some_word(text, random) : some_line(text, random);
      if (b < a)
        std::swap(a, b);
      if (a.second > b.first)
        return;
      const std::string first = part(text, a), second = part(text, b);
      replace(text, b, first);
      replace(text, a, second);
    }

    void
    move(std::string &text, const Stock &, Random &random)
    {
      const Range       range = something(text, random);
      const std::string what  = part(text, range);
      replace(text, range, "");
      text.insert(random.below(text.size() + 1), what);
    }

    void
    cut_off(std::string &text, const Stock &, Random &random)
    {
      text.resize(random.below(text.size() + 1));
    }

    void
    insert_word(std::string &text, const Stock &stock, Random &random)
    {
      const std::vector<std::string> ends = {"", " ", "\n"};
      const std::string              word = one_of(stock.words, random) + one_of(ends, random);
      text.insert(something(text, random).first, word);
    }

    void
    replace_word(std::string &text, const Stock &stock, Random &random)
    {
      replace(text, some_word(text, random), one_of(stock.words, random));
    }

    void
    replace_number(std::string &text, const Stock &, Random &random)
    {
      replace(text, some_run(text, random, is_in_number), one_of(extremes, random));
    }

    /// To a number that may be right as well: indices, counts and sizes near to what they were.
    void
    change_number(std::string &text, const Stock &, Random &random)
    {
      const Range range  = some_run(text, random, is_in_number);
      std::string digits = part(text, range);
      if (digits.empty())
        return;
      digits[random.below(digits.size())] = static_cast<char>('0' + random.below(10));
      replace(text, range, digits);
    }

    void
    splice(std::string &text, const Stock &stock, Random &random)
    {
      const std::string &other = one_of(stock.seeds, random);
      const std::size_t  end   = some_line(text, random).first;
      text                     = text.substr(0, end) + other.substr(some_line(other, random).first);
    }

    void
    insert_from_other(std::string &text, const Stock &stock, Random &random)
    {
      const std::string &other = one_of(stock.seeds, random);
      const std::string  what  = part(other, something(other, random));
      text.insert(some_line(text, random).first, what);
    }

    void
    make_long_line(std::string &text, const Stock &, Random &random)
    {
      const std::string letters = "a1 (,-*=/.<";
      const std::size_t n       = random.below(std::size_t(1) << (6 + random.below(12)));
      const char        letter  = letters[random.below(letters.size())];
      text.insert(some_word(text, random).first, std::string(n, letter));
    }

    /// In files that are binary.
    void
    overwrite_integer(std::string &text, const Stock &, Random &random)
    {
      static const std::vector<std::uint64_t> values = {
        0, 1, 0x7fffffff, 0xffffffff, 0x80000000, 0x7fffffffffffffff, 0xffffffffffffffff, 1 << 20};
      const std::size_t size = random.one_in(2) ? 4 : 8;
      if (text.size() < size)
        return;
      std::uint64_t     value = values[random.below(values.size())];
      const std::size_t at    = random.below(text.size() - size + 1);
      for (std::size_t i = 0; i < size; ++i, value >>= 8)
        text[at + i] = static_cast<char>(value & 0xff);
    }

    // What is likely to be read further is there several times.
    const std::vector<void (*)(std::string &, const Stock &, Random &)> mutations = {
      flip_bits,
      change_bytes,
      insert_odd_bytes,
      remove,
      remove,
      repeat,
      repeat,
      repeat_often,
      swap,
      swap,
      move,
      cut_off,
      insert_word,
      insert_word,
      replace_word,
      replace_word,
      replace_number,
      replace_number,
      replace_number,
      replace_number,
      change_number,
      change_number,
      change_number,
      splice,
      insert_from_other,
      overwrite_integer,
      make_long_line};
  } // namespace



  std::size_t
  Random::below(const std::size_t n)
  {
    return n == 0 ? 0 : engine() % n;
  }



  std::uint64_t
  hash_of(const std::string &text)
  {
    std::uint64_t hash = 14695981039346656037u; // FNV-1a
    for (const char c : text)
      hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return hash;
  }



  std::string
  mutant(const Stock &stock, const std::uint64_t number)
  {
    Random      random(number);
    std::string text = one_of(stock.seeds, random);
    // Mostly one or two mistakes: files with many are refused for the first.
    std::size_t n = 1;
    while (n < 12 && random.one_in(2))
      ++n;
    for (; n > 0; --n)
      {
        mutations[random.below(mutations.size())](text, stock, random);
        if (text.size() > longest)
          text.resize(longest);
      }
    return text;
  }
} // namespace Fuzz
