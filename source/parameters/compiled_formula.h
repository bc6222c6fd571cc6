// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/definitions.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /// A formula, compiled for repeated evaluation by muParser. Beyond the functions of muParser
  /// there are the constant pi, if(condition, a, b), int (nearest integer), ceil, floor, cot, csc,
  /// sec, log (natural), pow, erf, erfc, the operators & and |, and table(x, x1, y1, x2, y2, ...),
  /// which is linear between the points x1 < x2 < ... and constant beyond them. Not thread-safe.
  class CompiledFormula
  {
  public:
    /// Throws SceneError, with the reason only, if the formula is not valid.
    /// @param formula with its definitions
    /// @param variables names of the quantities on which it may depend, in addition to its
    /// definitions
    CompiledFormula(const Formula &formula, const std::vector<std::string> &variables);
    ~CompiledFormula();

    /// @return the value; NaN where the formula cannot be evaluated, such as a table whose points
    /// are not in order.
    /// @param values of the variables, in their order; null for a constant
    double
    value(const double *values) const;

    /// @return whether the formula, or a definition that it uses, contains a variable.
    /// @param i index of the variable
    bool
    depends_on(const std::size_t i) const
    {
      return depends[i];
    }

    /// @return whether the formula contains none of the variables.
    bool
    is_constant() const;

    /// @return whether there is a function or a constant of a name.
    /// @param name the name
    static bool
    is_known(const std::string &name);

  private:
    struct Program;
    std::vector<bool>        depends;
    std::unique_ptr<Program> program;
  };
} // namespace Signorini
