// SPDX-License-Identifier: Apache-2.0
#include "parameters/values.h"

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  std::string
  number_text(const double x)
  {
    // The shortest text that reads back as the same number.
    for (int digits = 6; digits <= 17; ++digits)
      {
        std::ostringstream text;
        text << std::setprecision(digits) << x;
        // std::stod() would reject texts that are rounded to infinity, and numbers below 2e-308.
        if (std::strtod(text.str().c_str(), nullptr) == x)
          return text.str();
      }
    return "nan";
  }



  std::string
  to_text(const double value)
  {
    return std::isfinite(value) ? number_text(value) : (value > 0 ? "infinity" : "-infinity");
  }



  std::string
  to_text(const unsigned int value)
  {
    return std::to_string(value);
  }



  std::string
  to_text(const bool value)
  {
    return value ? "yes" : "no";
  }



  std::string
  to_text(const std::string &value)
  {
    return value;
  }



  std::string
  to_text(const Formula &value)
  {
    return value.text;
  }



  template <typename T>
  std::string
  to_text(const std::vector<T> &values)
  {
    std::vector<std::string> words;
    for (const T &value : values)
      words.push_back(to_text(value));
    return join(words);
  }



  template <int dim>
  std::string
  to_text(const Point<dim> &p)
  {
    std::vector<double> coordinates(dim);
    for (unsigned int d = 0; d < dim; ++d)
      coordinates[d] = p[d];
    return to_text(coordinates);
  }



  template <int dim>
  std::string
  to_text(const std::vector<Point<dim>> &values)
  {
    std::vector<std::string> words;
    for (const Point<dim> &value : values)
      words.push_back(to_text(value));
    return join(words, "; ");
  }



  template <int dim>
  std::string
  to_text(const Expression<dim> &value)
  {
    return value.formula();
  }



  template <int dim, int n_components>
  std::string
  to_text(const VectorExpression<dim, n_components> &value)
  {
    return value.text();
  }



  std::string
  type_name(const double)
  {
    return "number";
  }



  std::string
  type_name(const unsigned int)
  {
    return "whole number";
  }



  std::string
  type_name(const bool)
  {
    return "yes or no";
  }



  std::string
  type_name(const std::string &)
  {
    return "text";
  }



  std::string
  type_name(const Formula &)
  {
    return "text or formula";
  }



  std::string
  type_name(const std::vector<std::string> &)
  {
    return "names";
  }



  template <typename T>
  std::string
  type_name(const std::vector<T> &)
  {
    return type_name(T()) + "s";
  }



  template <int dim>
  std::string
  type_name(const Point<dim> &)
  {
    return std::to_string(dim) + " numbers";
  }



  template <int dim>
  std::string
  type_name(const std::vector<Point<dim>> &)
  {
    return "vectors";
  }



  template <int dim>
  std::string
  type_name(const Expression<dim> &)
  {
    return "formula";
  }



  template <int dim, int n_components>
  std::string
  type_name(const VectorExpression<dim, n_components> &)
  {
    return n_components == 1 ? "formula" : std::to_string(n_components) + " formulas";
  }



  void
  from_text(const Formula &text, double &value)
  {
    if (text.text == "infinity" || text.text == "-infinity")
      value = (text.text[0] == '-' ? -1 : 1) * std::numeric_limits<double>::infinity();
    else
      value = evaluate(text, {});
    if (!std::isfinite(value) && text.text != "infinity" && text.text != "-infinity")
      throw SceneError("is not a finite number");
  }



  // Formulas such as b/0.1 may deviate slightly from a whole number.
  void
  from_text(const Formula &text, unsigned int &value)
  {
    double number;
    from_text(text, number);
    const double whole = std::round(number); // b/0.1 may be a little beside it
    if (whole < 0 || std::abs(number - whole) > 1e-9 * std::max(1., whole) || whole > 4e9)
      throw SceneError("is " + number_text(number) +
                       ", but must be a whole number that is not negative");
    value = static_cast<unsigned int>(whole);
  }



  void
  from_text(const Formula &text, bool &value)
  {
    if (text.text != "yes" && text.text != "no")
      throw SceneError("must be yes or no");
    value = text.text == "yes";
  }



  void
  from_text(const Formula &text, std::string &value)
  {
    value = text.text;
  }



  void
  from_text(const Formula &text, Formula &value)
  {
    value = text;
  }



  void
  from_text(const Formula &text, std::vector<std::string> &value)
  {
    value = split(text.text, ',');
  }



  namespace
  {
    /// Read a list of values that are separated by commas.
    template <typename T>
    void
    list_from_text(const Formula &text, std::vector<T> &value)
    {
      value.clear();
      for (const std::string &part : split(text.text, ','))
        {
          value.emplace_back();
          from_text({part, text.definitions}, value.back());
        }
    }
  } // namespace



  void
  from_text(const Formula &text, std::vector<double> &value)
  {
    list_from_text(text, value);
  }



  void
  from_text(const Formula &text, std::vector<unsigned int> &value)
  {
    list_from_text(text, value);
  }



  template <int dim>
  void
  from_text(const Formula &text, Point<dim> &value)
  {
    std::vector<double> coordinates;
    from_text(text, coordinates);
    if (coordinates.size() != dim)
      throw SceneError("must have " + std::to_string(dim) + " coordinates, separated by commas");
    for (unsigned int d = 0; d < dim; ++d)
      value[d] = coordinates[d];
  }



  template <int dim>
  void
  from_text(const Formula &text, std::vector<Point<dim>> &value)
  {
    value.clear();
    for (const std::string &part : split(text.text, ';'))
      {
        value.emplace_back();
        from_text({part, text.definitions}, value.back());
      }
  }



  template <int dim>
  void
  from_text(const Formula &text, Expression<dim> &value)
  {
    value = Expression<dim>(text);
  }



  template <int dim, int n_components>
  void
  from_text(const Formula &text, VectorExpression<dim, n_components> &value)
  {
    value = VectorExpression<dim, n_components>(text);
  }



#define INSTANTIATE(T)                                                                             \
  template std::string to_text(const T &);                                                         \
  template std::string type_name(const T &);                                                       \
  template void        from_text(const Formula &, T &);
  INSTANTIATE(Point<2>)
  INSTANTIATE(Point<3>)
  INSTANTIATE(std::vector<Point<2>>)
  INSTANTIATE(std::vector<Point<3>>)
  INSTANTIATE(Expression<2>)
  INSTANTIATE(Expression<3>)
  INSTANTIATE(VectorExpression<2>)
  using OneComponent = VectorExpression<2, 1>;
  INSTANTIATE(OneComponent)
  INSTANTIATE(VectorExpression<3>)
#undef INSTANTIATE
  template std::string
  to_text(const std::vector<double> &);
  template std::string
  to_text(const std::vector<unsigned int> &);
  template std::string
  to_text(const std::vector<std::string> &);
  template std::string
  type_name(const std::vector<double> &);
  template std::string
  type_name(const std::vector<unsigned int> &);
} // namespace Signorini
