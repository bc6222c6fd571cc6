// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/definitions.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace Signorini
{
  class CompiledFormula;

  /// A scalar function of the coordinates x, y (z in 3D) and the time t. Throws SceneError if the
  /// formula is not valid.
  template <int dim>
  class Expression
  {
  public:
    static constexpr int dimension = dim;

    /// @param formula the formula
    Expression(const Formula &formula = "0");

    /// @return the value; NaN where the formula cannot be evaluated.
    /// @param p coordinates
    /// @param t time
    double
    value(const dealii::Point<dim> &p, double t = 0) const;

    /// @return whether the formula is the constant zero.
    bool
    is_zero() const;

    /// @return whether the value depends on a coordinate.
    bool
    depends_on_place() const;

    /// @return whether the value depends on the time.
    bool
    depends_on_time() const;

    /// @return the formula as the user has written it.
    const std::string &
    formula() const
    {
      return text;
    }

  private:
    std::string                            text;
    std::shared_ptr<const CompiledFormula> compiled;
  };

  /// A vector of expressions, separated by `;` in a text. A component may be `free`: then it is not
  /// prescribed.
  template <int dim, int n_components = dim>
  class VectorExpression
  {
  public:
    static constexpr int dimension = dim;

    /// Throws SceneError if a formula is not valid, or if their number is not n_components.
    /// @param text the components; empty: all are free
    VectorExpression(const Formula &text = "");

    /// @return whether a component is prescribed.
    /// @param component its index
    bool
    prescribed(unsigned int component) const
    {
      return components[component].has_value();
    }

    /// @return whether no component is prescribed.
    bool
    empty() const;

    /// @return whether a component is free, or the constant zero.
    /// @param component its index
    bool
    is_zero(unsigned int component) const;

    /// @return whether any component depends on a coordinate.
    bool
    depends_on_place() const;

    /// @return whether any component depends on the time.
    bool
    depends_on_time() const;

    /// @return whether there is a text.
    bool
    given() const
    {
      return is_given;
    }

    /// @return the components; free ones are zero.
    /// @param p coordinates
    /// @param t time
    dealii::Tensor<1, n_components>
    value(const dealii::Point<dim> &p, double t = 0) const;

    /// @return the text from which the same expression is read.
    std::string
    text() const;

  private:
    std::array<std::optional<Expression<dim>>, n_components> components;
    bool                                                     is_given = false;
  };

  /// @return the value of a formula in named constants, e.g. evaluate("2*a", {{"a", 3}}). Throws
  /// SceneError.
  /// @param formula the formula
  /// @param constants values by name
  double
  evaluate(const Formula &formula, const std::map<std::string, double> &constants);
} // namespace Signorini
