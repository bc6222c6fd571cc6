#include <signorini/parameters/expression.h>
#include <signorini/parameters/raw.h>
#include <signorini/parameters/table.h>

#include <cctype>
#include <sstream>
#include <vector>

namespace Signorini
{
  namespace
  {
    /// Where the word `table(` begins at or after `from`; npos if nowhere.
    std::size_t
    find_table(const std::string &formula, const std::size_t from)
    {
      for (std::size_t at = formula.find("table", from); at != std::string::npos;
           at             = formula.find("table", at + 1))
        {
                      const bool is_word =
                        at == 0 ||
                        !(std::isalnum(static_cast<unsigned char>(formula[at - 1])) || formula[at - 1] == '_');
                      const auto bracket = formula.find_first_not_of(' ', at + 5);
                      if (is_word && bracket != std::string::npos && formula[bracket] == '(')
            return at;
        }
      return std::string::npos;
    }

    /// The arguments between the bracket at `open` and the one that belongs to it, where `close`
    /// points to then.
    std::vector<std::string>
    arguments(const std::string &formula, const std::size_t open, std::size_t &close)
    {
      std::vector<std::string> list(1);
      unsigned int             depth = 0;
      for (close = open; close < formula.size(); ++close)
        {
          const char c = formula[close];
          depth += c == '(';
          depth -= c == ')';
          if (depth == 0)
            return list;
          if (c == ',' && depth == 1)
            list.emplace_back();
          else if (close != open)
            list.back() += c;
        }
      throw SceneError("'" + formula + "': a bracket of table(...) is not closed");
    }

    std::string
    to_formula(const double x)
    {
      std::ostringstream text;
      text.precision(17);
      text << '(' << x << ')';
      return text.str();
    }

    std::string
    piecewise_linear(const std::string         &x,
                     const std::vector<double> &xs,
                     const std::vector<double> &ys)
    {
      std::string result = to_formula(ys.back());
      for (std::size_t i = xs.size() - 1; i-- > 0;)
        {
          const double slope = (ys[i + 1] - ys[i]) / (xs[i + 1] - xs[i]);
          result = "if((" + x + ") < " + to_formula(xs[i + 1]) + ", " + to_formula(ys[i]) + " + " +
                   to_formula(slope) + "*((" + x + ") - " + to_formula(xs[i]) + "), " + result +
                   ")";
        }
      return "if((" + x + ") < " + to_formula(xs.front()) + ", " + to_formula(ys.front()) + ", " +
             result + ")";
    }
  } // namespace



  std::string
  expand_tables(const std::string &formula)
  {
    const std::size_t start = find_table(formula, 0);
    if (start == std::string::npos)
      return formula;
    std::size_t                    close = 0;
    const std::vector<std::string> all   = arguments(formula, formula.find('(', start), close);
    if (all.size() < 5 || all.size() % 2 == 0)
      throw SceneError("'" + formula.substr(start, close + 1 - start) +
                       "' is not table(x, x1, y1, x2, y2, ...) with at least two points");
    std::vector<double> xs, ys;
    for (std::size_t i = 1; i < all.size(); i += 2)
      {
        xs.push_back(evaluate(all[i], {}));
        ys.push_back(evaluate(all[i + 1], {}));
        if (xs.size() > 1 && !(xs[xs.size() - 2] < xs.back()))
          throw SceneError("'" + formula.substr(start, close + 1 - start) +
                           "': the points of a table must be in increasing order");
      }
    return formula.substr(0, start) + piecewise_linear(expand_tables(all[0]), xs, ys) +
           expand_tables(formula.substr(close + 1));
  }
} // namespace Signorini
