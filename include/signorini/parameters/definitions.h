// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  class Definitions;

  /// A formula as the user wrote it, with the names that it may use.
  struct Formula
  {
    Formula(const std::string                        &text        = "",
            const std::shared_ptr<const Definitions> &definitions = {})
      : text(text)
      , definitions(definitions)
    {}

    Formula(const char *text)
      : text(text)
    {}

    bool
    empty() const
    {
      return text.empty();
    }

    std::string                        text;
    std::shared_ptr<const Definitions> definitions; ///< null: none
  };

  /// Names that stand for formulas, for use in later definitions and in all formulas and numbers of
  /// a scene.
  class Definitions
  {
  public:
    /// Throws SceneError if that is not a name, or stands for something else already, or if the
    /// formula cannot be read.
    void
    add(const std::string &name, const std::string &formula);

    /// In their order.
    const std::vector<std::pair<std::string, std::string>> &
    all() const
    {
      return formulas;
    }

    bool
    is_defined(const std::string &name) const;

  private:
    std::vector<std::pair<std::string, std::string>> formulas;
  };
} // namespace Signorini
