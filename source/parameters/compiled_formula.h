// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/definitions.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /// A formula of muParser, ready to be evaluated again and again. Beyond what muParser knows there
  /// are the constant pi, if(condition, a, b), int (nearest integer), ceil, floor, cot, csc, sec,
  /// log (natural), pow, erf, erfc, the operators & and |, and table(x, x1, y1, x2, y2, ...), which
  /// is linear between the points x1 < x2 < ... and constant beyond them.
  class CompiledFormula
  {
  public:
    /// @param variables names of what the formula may depend on, beside its definitions
    /// Throws SceneError, with the reason alone, if it cannot be read.
    CompiledFormula(const Formula &formula, const std::vector<std::string> &variables);
    ~CompiledFormula();

    /// @param values of the variables, in their order; null for a constant. Not a number where the
    /// formula cannot be evaluated, as a table whose points are not in order.
    double
    value(const double *values) const;

    /// True if the formula, or what it refers to, contains variable i.
    bool
    depends_on(const std::size_t i) const
    {
      return depends[i];
    }

    /// True if it contains none of the variables.
    bool
    is_constant() const;

    /// True if formulas know a function or a constant of that name.
    static bool
    is_known(const std::string &name);

  private:
    struct Program;
    std::vector<bool>        depends;
    std::unique_ptr<Program> program;
  };
} // namespace Signorini
