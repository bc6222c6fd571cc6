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

  /// A scalar function of the coordinates x, y (z in 3D) and the time t. A formula that cannot be
  /// read throws SceneError on construction.
  template <int dim>
  class Expression
  {
  public:
    static constexpr int dimension = dim;

    Expression(const Formula &formula = "0");

    double
    value(const dealii::Point<dim> &p, double t = 0) const;

    /// True if it is the number zero, everywhere and at all times.
    bool
    is_zero() const;

    /// True if it is not a function of the time alone.
    bool
    depends_on_place() const;

    bool
    depends_on_time() const;

    /// As the user wrote it.
    const std::string &
    formula() const
    {
      return text;
    }

  private:
    std::string                            text;
    std::shared_ptr<const CompiledFormula> compiled;
  };

  /// One expression a component, separated by `;`. A component may be `free`: then it is not
  /// prescribed.
  template <int dim, int n_components = dim>
  class VectorExpression
  {
  public:
    static constexpr int dimension = dim;

    /// The empty text leaves all components free.
    VectorExpression(const Formula &text = "");

    bool
    prescribed(unsigned int component) const
    {
      return components[component].has_value();
    }

    /// True if no component is prescribed.
    bool
    empty() const;

    /// True if the component is free, or the number zero at all times.
    bool
    is_zero(unsigned int component) const;

    /// True if any component is not a function of the time alone.
    bool
    depends_on_place() const;

    /// True if any component is a function of the time.
    bool
    depends_on_time() const;

    /// False for the empty text.
    bool
    given() const
    {
      return is_given;
    }

    /// The components at p; free ones are zero.
    dealii::Tensor<1, n_components>
    value(const dealii::Point<dim> &p, double t = 0) const;

    std::string
    text() const;

  private:
    std::array<std::optional<Expression<dim>>, n_components> components;
    bool                                                     is_given = false;
  };

  /// Value of a formula in named constants, e.g. evaluate("2*a", {{"a", 3}}). Throws SceneError.
  double
  evaluate(const Formula &formula, const std::map<std::string, double> &constants);
} // namespace Signorini
