// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The choices of a key: words with the values that they denote, mostly of an enum, in the order
  /// of the help text.
  template <typename Value>
  using Choices = std::vector<std::pair<std::string, Value>>;

  /// @return the word of a value, which must be one of the choices.
  /// @param choices of the key
  /// @param value one of their values
  template <typename Value>
  const std::string &
  word_of(const Choices<Value> &choices, const Value &value)
  {
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const auto &choice) {
      return choice.second == value;
    });
    AssertThrow(found != choices.end(), dealii::ExcInternalError("A value has no word."));
    return found->first;
  }

  /// @return the value of a word.
  /// @param choices of the key
  /// @param word one of their words
  template <typename Value>
  const Value &
  value_of(const Choices<Value> &choices, const std::string &word)
  {
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const auto &choice) {
      return choice.first == word;
    });
    AssertThrow(found != choices.end(), dealii::ExcInternalError("A word has no value: " + word));
    return found->second;
  }

  /// @return all words.
  /// @param choices of the key
  template <typename Value>
  std::vector<std::string>
  words_of(const Choices<Value> &choices)
  {
    std::vector<std::string> words;
    for (const auto &choice : choices)
      words.push_back(choice.first);
    return words;
  }

  /// @return the choices preceded by the word `auto`, which stands for none of them: the program
  /// chooses.
  /// @param choices of the key
  template <typename Value>
  Choices<std::optional<Value>>
  or_auto(const Choices<Value> &choices)
  {
    Choices<std::optional<Value>> result = {{"auto", std::nullopt}};
    result.insert(result.end(), choices.begin(), choices.end());
    return result;
  }
} // namespace Signorini
