// SPDX-License-Identifier: Apache-2.0
#include "parameters/compiled_formula.h"
#include <signorini/base/text.h>
#include <signorini/parameters/definitions.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cctype>

namespace Signorini
{
  namespace
  {
    /// @return whether a text consists of letters, digits and underscores, and does not begin with
    /// a digit.
    bool
    is_name(const std::string &text)
    {
      const auto belongs = [](const unsigned char c) { return std::isalnum(c) || c == '_'; };
      return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
             std::all_of(text.begin(), text.end(), belongs);
    }

    /// @return whether a name is a coordinate, the time, a function, a constant, or a word that may
    /// replace a formula.
    bool
    has_meaning(const std::string &name)
    {
      for (const char *other : {"x", "y", "z", "t", "free", "closed", "infinity"})
        if (name == other)
          return true;
      return CompiledFormula::is_known(name);
    }
  } // namespace



  // The formula is compiled once to check it, with the definitions before it.
  void
  Definitions::add(const std::string &name, const std::string &formula)
  {
    if (!is_name(name))
      throw SceneError("a name consists of letters, digits and _, and does not begin with a digit");
    if (has_meaning(name) || is_defined(name))
      throw SceneError("the name is already in use");
    try
      {
        CompiledFormula({formula, std::make_shared<Definitions>(*this)}, {"x", "y", "z", "t"});
      }
    catch (const SceneError &error)
      {
        std::vector<std::string> names{"x", "y", "z", "t"};
        for (const auto &one : formulas)
          names.push_back(one.first);
        throw SceneError("'" + shortened(formula) + "' is not a formula in " + join(names) +
                         ", the names before it: " + error.what());
      }
    formulas.emplace_back(name, formula);
  }



  bool
  Definitions::is_defined(const std::string &name) const
  {
    return std::any_of(formulas.begin(), formulas.end(), [&](const auto &one) {
      return one.first == name;
    });
  }
} // namespace Signorini
