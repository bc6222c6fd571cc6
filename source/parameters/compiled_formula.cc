// SPDX-License-Identifier: Apache-2.0
#include "parameters/compiled_formula.h"

#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;

    /// The function table(x, x1, y1, ...) of formulas: linear interpolation, constant beyond the
    /// first and last point. Throws mu::ParserError for points that are not in increasing order.
    double
    table(const double *x, const int n)
    {
      if (n < 5 || n % 2 == 0)
        throw mu::ParserError("a table is table(x, x1, y1, x2, y2, ...) with at least two points");
      for (int i = 3; i < n; i += 2)
        if (!(x[i - 2] < x[i]))
          throw mu::ParserError("the points of a table must be in increasing order");
      if (x[0] <= x[1])
        return x[2];
      for (int i = 3; i < n; i += 2)
        if (x[0] <= x[i])
          return x[i - 1] + (x[i + 1] - x[i - 1]) * (x[0] - x[i - 2]) / (x[i] - x[i - 2]);
      return x[n - 1];
    }

    /// @return a parser with the constants, functions and operators that formulas may use beyond
    /// those of muParser.
    mu::Parser
    basic_parser()
    {
      using Number = double; // muParser finds the number of arguments by the type
      mu::Parser parser;
      parser.DefineConst("pi", pi);
      parser.DefineFun("table", table);
      parser.DefineFun(
        "if", +[](Number c, Number a, Number b) { return c != 0 ? a : b; });
      parser.DefineFun(
        "pow", +[](Number a, Number b) { return std::pow(a, b); });
      parser.DefineFun(
        "int", +[](Number a) { return std::round(a); });
      parser.DefineFun(
        "ceil", +[](Number a) { return std::ceil(a); });
      parser.DefineFun(
        "floor", +[](Number a) { return std::floor(a); });
      parser.DefineFun(
        "cot", +[](Number a) { return 1 / std::tan(a); });
      parser.DefineFun(
        "csc", +[](Number a) { return 1 / std::sin(a); });
      parser.DefineFun(
        "sec", +[](Number a) { return 1 / std::cos(a); });
      parser.DefineFun(
        "log", +[](Number a) { return std::log(a); });
      parser.DefineFun(
        "erf", +[](Number a) { return std::erf(a); });
      parser.DefineFun(
        "erfc", +[](Number a) { return std::erfc(a); });
      parser.DefineOprt(
        "|", +[](Number a, Number b) { return a != 0 || b != 0 ? 1. : 0.; }, 1);
      parser.DefineOprt(
        "&", +[](Number a, Number b) { return a != 0 && b != 0 ? 1. : 0.; }, 2);
      return parser;
    }

    /// Throws SceneError for a single "=", which muParser would interpret as an assignment.
    void
    reject_slips(const std::string &formula)
    {
      for (std::size_t i = 0; i < formula.size(); ++i)
        if (formula[i] == '=')
          {
            const char before = i > 0 ? formula[i - 1] : ' ';
            if (formula[i + 1] == '=')
              ++i;
            else if (before != '<' && before != '>' && before != '!')
              throw SceneError("to compare, write == instead of =");
          }
    }

    /// @return the reason of an error, reworded where the message of muParser would not be helpful.
    std::string
    reason(const mu::ParserError &error)
    {
      const std::string token = shortened(trim(error.GetToken()));
      switch (error.GetCode())
        {
          case mu::ecUNASSIGNABLE_TOKEN:
            return "'" + token + "' is neither a number nor a known name";
          case mu::ecEMPTY_EXPRESSION:
            return "there is nothing";
          case mu::ecINTERNAL_ERROR:
            return "the formula is incomplete";
          default:
            return shortened(error.GetMsg());
        }
    }

    /// Throws SceneError if the formula has several results, which is mostly a decimal comma.
    void
    reject_several(const mu::Parser &parser)
    {
      if (parser.GetNumResults() > 1)
        throw SceneError("has a comma outside of brackets; write decimal points: 1.5");
    }
  } // namespace



  /// The parsers of the formula and of the definitions on which it depends, with the values of all
  /// names.
  struct CompiledFormula::Program
  {
    /// Values of the variables, followed by those of all definitions. Parsers refer to them by
    /// pointers.
    std::vector<double> values;

    struct Step
    {
      mu::Parser parser;
      double    *result;
    };

    /// The definitions that are needed and not constant, in their order; they are evaluated before
    /// the formula.
    std::vector<Step> steps;
    mu::Parser        formula;
  };



  // Definitions may refer to earlier ones only. Backwards, it is determined which of them the
  // formula needs; forwards, which of these depend on a variable. Constant ones are evaluated once.
  CompiledFormula::CompiledFormula(const Formula                  &formula,
                                   const std::vector<std::string> &variables)
    : program(std::make_unique<Program>())
  {
    using Definition = std::pair<std::string, std::string>;
    const std::vector<Definition> definitions =
      formula.definitions ? formula.definitions->all() : std::vector<Definition>();
    const std::size_t n = variables.size(), n_all = n + definitions.size();
    program->values.resize(n_all, 0.5);
    const auto name = [&](const std::size_t i) {
      return i < n ? variables[i] : definitions[i - n].first;
    };
    // Compile a formula in the first n_known of all names.
    const auto compile = [&](const std::string &text, const std::size_t n_known) {
      reject_slips(text);
      mu::Parser parser = basic_parser();
      // Defining a name takes longer than finding that the text does not contain it.
      for (std::size_t i = 0; i < n_known; ++i)
        if (text.find(name(i)) != std::string::npos)
          parser.DefineVar(name(i), &program->values[i]);
      parser.SetExpr(text);
      return parser;
    };
    // Determine which of all names a formula uses; muParser parses it for that.
    const auto used_by = [&](const mu::Parser &parser) {
      const auto       &names = parser.GetUsedVar();
      std::vector<bool> used(n_all);
      for (std::size_t i = 0; i < n_all; ++i)
        used[i] = names.count(name(i)) > 0;
      return used;
    };
    std::vector<bool> needed(n_all, false), varies(n_all, false);
    std::string       place; // for messages
    try
      {
        program->formula = compile(formula.text, n_all);
        needed           = used_by(program->formula);
        std::vector<mu::Parser>        parsers(definitions.size());
        std::vector<std::vector<bool>> used(definitions.size());
        for (std::size_t k = definitions.size(); k-- > 0;)
          if (needed[n + k])
            {
              place      = "in the definition of '" + definitions[k].first + "': ";
              parsers[k] = compile(definitions[k].second, n + k);
              used[k]    = used_by(parsers[k]);
              for (std::size_t i = 0; i < n + k; ++i)
                needed[i] = needed[i] || used[k][i];
              place = "";
            }
        depends.assign(needed.begin(), needed.begin() + n);
        for (std::size_t i = 0; i < n; ++i)
          varies[i] = true;
        for (std::size_t k = 0; k < definitions.size(); ++k)
          if (needed[n + k])
            {
              for (std::size_t i = 0; i < n + k; ++i)
                varies[n + k] = varies[n + k] || (varies[i] && used[k][i]);
              place                  = "in the definition of '" + definitions[k].first + "': ";
              program->values[n + k] = parsers[k].Eval();
              place                  = "";
              if (varies[n + k])
                program->steps.push_back({parsers[k], &program->values[n + k]});
            }
        program->formula.Eval(); // which reads it
        reject_several(program->formula);
      }
    catch (const mu::ParserError &error)
      {
        throw SceneError(place + reason(error));
      }
  }



  CompiledFormula::~CompiledFormula() = default;



  double
  CompiledFormula::value(const double *values) const
  {
    if (values)
      for (std::size_t i = 0; i < depends.size(); ++i)
        program->values[i] = values[i];
    try
      {
        for (Program::Step &step : program->steps)
          *step.result = step.parser.Eval();
        return program->formula.Eval();
      }
    catch (const mu::ParserError &)
      {
        // The error may occur on this rank only: NaN is returned, and the caller reports it.
        return std::numeric_limits<double>::quiet_NaN();
      }
  }



  bool
  CompiledFormula::is_constant() const
  {
    return std::none_of(depends.begin(), depends.end(), [](const bool b) { return b; });
  }



  bool
  CompiledFormula::is_known(const std::string &name)
  {
    const mu::Parser parser = basic_parser();
    return parser.GetFunDef().count(name) + parser.GetConst().count(name) > 0;
  }
} // namespace Signorini
