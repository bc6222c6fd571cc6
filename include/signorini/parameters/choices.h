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
  /// What a key of the scene file may be: words, each with the value that it stands for, mostly one
  /// of an enum, in the order in which the help shows them.
  template <typename Value>
  using Choices = std::vector<std::pair<std::string, Value>>;

  /// The word for a value.
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

  /// The value of a word that is one of the choices.
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

  template <typename Value>
  std::vector<std::string>
  words_of(const Choices<Value> &choices)
  {
    std::vector<std::string> words;
    for (const auto &choice : choices)
      words.push_back(choice.first);
    return words;
  }

  /// The same after the word `auto`, which stands for none of them: the program chooses.
  template <typename Value>
  Choices<std::optional<Value>>
  or_auto(const Choices<Value> &choices)
  {
    Choices<std::optional<Value>> result = {{"auto", std::nullopt}};
    result.insert(result.end(), choices.begin(), choices.end());
    return result;
  }
} // namespace Signorini
