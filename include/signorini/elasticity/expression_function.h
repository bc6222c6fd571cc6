#pragma once

#include <signorini/parameters/expression.h>

#include <deal.II/base/function.h>

namespace Signorini
{
  /// A VectorExpression at a fixed time, as deal.II wants a function of displacements.
  template <int dim>
  class DisplacementFunction : public dealii::Function<dim>
  {
  public:
    DisplacementFunction(const VectorExpression<dim> &expression, const double t)
      : dealii::Function<dim>(dim)
      , expression(expression)
      , t(t)
    {}

    double
    value(const dealii::Point<dim> &p, const unsigned int component) const override
    {
      return expression.value(p, t)[component];
    }

    void
    vector_value(const dealii::Point<dim> &p, dealii::Vector<double> &values) const override
    {
      const dealii::Tensor<1, dim> u = expression.value(p, t);
      for (unsigned int d = 0; d < dim; ++d)
        values[d] = u[d];
    }

  private:
    const VectorExpression<dim> expression;
    const double                t;
  };
} // namespace Signorini
