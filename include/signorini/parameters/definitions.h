// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  class Definitions;

  /// A formula as the user has written it, with the definitions that it may use.
  struct Formula
  {
    /// @param text the formula
    /// @param definitions names that it may contain; null: none
    Formula(const std::string                        &text        = "",
            const std::shared_ptr<const Definitions> &definitions = {})
      : text(text)
      , definitions(definitions)
    {}

    /// @param text a formula without definitions
    Formula(const char *text)
      : text(text)
    {}

    /// @return whether there is no formula.
    bool
    empty() const
    {
      return text.empty();
    }

    std::string text;
    /// Names that the formula may contain; null: none.
    std::shared_ptr<const Definitions> definitions;
  };

  /// Names that stand for formulas, for use in later definitions and in all formulas and numbers of
  /// a scene.
  class Definitions
  {
  public:
    /// Append a definition. Throws SceneError if the name is not valid or in use, or if the formula
    /// is not valid.
    /// @param name the name
    /// @param formula which may contain the coordinates, the time and earlier names
    void
    add(const std::string &name, const std::string &formula);

    /// @return all definitions, in their order.
    const std::vector<std::pair<std::string, std::string>> &
    all() const
    {
      return formulas;
    }

    /// @return whether a name has been defined.
    /// @param name the name
    bool
    is_defined(const std::string &name) const;

  private:
    std::vector<std::pair<std::string, std::string>> formulas;
  };
} // namespace Signorini
