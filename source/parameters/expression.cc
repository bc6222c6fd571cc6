// SPDX-License-Identifier: Apache-2.0
#include "parameters/compiled_formula.h"
#include <signorini/base/text.h>
#include <signorini/parameters/expression.h>
#include <signorini/parameters/raw.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the names of the coordinates and the time.
    template <int dim>
    std::vector<std::string>
    variables()
    {
      if (dim == 2)
        return {"x", "y", "t"};
      return {"x", "y", "z", "t"};
    }
  } // namespace



  template <int dim>
  Expression<dim>::Expression(const Formula &formula)
    : text(formula.text)
  {
    try
      {
        compiled = std::make_shared<CompiledFormula>(formula, variables<dim>());
      }
    catch (const SceneError &error)
      {
        throw SceneError("'" + shortened(text) + "' is not a formula in " +
                         join(variables<dim>(), ",") + ": " + error.what());
      }
  }



  template <int dim>
  double
  Expression<dim>::value(const Point<dim> &p, const double t) const
  {
    double values[dim + 1];
    for (unsigned int d = 0; d < dim; ++d)
      values[d] = p[d];
    values[dim] = t;
    return compiled->value(values);
  }



  template <int dim>
  bool
  Expression<dim>::is_zero() const
  {
    return compiled->is_constant() && value({}) == 0;
  }



  template <int dim>
  bool
  Expression<dim>::depends_on_place() const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (compiled->depends_on(d))
        return true;
    return false;
  }



  template <int dim>
  bool
  Expression<dim>::depends_on_time() const
  {
    return compiled->depends_on(dim);
  }



  template <int dim, int n_components>
  VectorExpression<dim, n_components>::VectorExpression(const Formula &text)
  {
    const std::vector<std::string> parts = split(text.text, ';');
    if (parts.empty())
      return;
    is_given = true;
    if (parts.size() != n_components)
      throw SceneError("'" + shortened(text.text) + "' has " + std::to_string(parts.size()) +
                       " components, separated by ';', but " + std::to_string(n_components) +
                       " are needed (write 'free' for one that is not prescribed)");
    for (unsigned int d = 0; d < n_components; ++d)
      if (parts[d] != "free")
        components[d] = Expression<dim>({parts[d], text.definitions});
  }



  template <int dim, int n_components>
  bool
  VectorExpression<dim, n_components>::empty() const
  {
    for (const auto &component : components)
      if (component)
        return false;
    return true;
  }



  template <int dim, int n_components>
  bool
  VectorExpression<dim, n_components>::is_zero(const unsigned int component) const
  {
    return !components[component] || components[component]->is_zero();
  }



  template <int dim, int n_components>
  bool
  VectorExpression<dim, n_components>::depends_on_place() const
  {
    for (const auto &component : components)
      if (component && component->depends_on_place())
        return true;
    return false;
  }



  template <int dim, int n_components>
  bool
  VectorExpression<dim, n_components>::depends_on_time() const
  {
    for (const auto &component : components)
      if (component && component->depends_on_time())
        return true;
    return false;
  }



  template <int dim, int n_components>
  Tensor<1, n_components>
  VectorExpression<dim, n_components>::value(const Point<dim> &p, const double t) const
  {
    Tensor<1, n_components> result;
    for (unsigned int d = 0; d < n_components; ++d)
      if (components[d])
        result[d] = components[d]->value(p, t);
    return result;
  }



  template <int dim, int n_components>
  std::string
  VectorExpression<dim, n_components>::text() const
  {
    if (!is_given)
      return "";
    std::vector<std::string> parts;
    for (const auto &component : components)
      parts.push_back(component ? component->formula() : "free");
    return join(parts, "; ");
  }



  // The constants are variables of the compiled formula.
  double
  evaluate(const Formula &formula, const std::map<std::string, double> &constants)
  {
    std::vector<std::string> names;
    std::vector<double>      values;
    for (const auto &[name, value] : constants)
      {
        names.push_back(name);
        values.push_back(value);
      }
    try
      {
        return CompiledFormula(formula, names).value(values.data());
      }
    catch (const SceneError &error)
      {
        throw SceneError("'" + shortened(formula.text) + "' cannot be evaluated: " + error.what());
      }
  }



  template class Expression<2>;
  template class Expression<3>;
  template class VectorExpression<2>;
  template class VectorExpression<2, 1>;
  template class VectorExpression<3>;
} // namespace Signorini
