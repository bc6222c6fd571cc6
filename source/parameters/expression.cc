#include <signorini/parameters/expression.h>
#include <signorini/parameters/raw.h>
#include <signorini/parameters/table.h>

#include <deal.II/base/function_parser.h>

#include <cmath>
#include <iostream>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// What muParser has to say goes to std::cerr, on every rank, and not into the exception: catch
    /// it there.
    class Listener
    {
    public:
      Listener()
        : former(std::cerr.rdbuf(heard.rdbuf()))
      {}

      ~Listener()
      {
        std::cerr.rdbuf(former);
      }

      std::string
      reason() const
      {
        const std::string text  = heard.str();
        const auto        start = text.find("Message:");
        if (start == std::string::npos)
          return "it cannot be evaluated";
        return trim(text.substr(start + 8, text.find('\n', start) - start - 8));
      }

    private:
      std::ostringstream heard;
      std::streambuf    *former;
    };

    template <int dim>
    std::shared_ptr<FunctionParser<dim>>
    compile(const std::string &formula)
    {
      const Listener listener;
      auto           parser = std::make_shared<FunctionParser<dim>>(1);
      try
        {
          parser->initialize(FunctionParser<dim>::default_variable_names() + ",t",
                             expand_tables(formula),
                             {{"pi", numbers::PI}},
                             true);
          // muParser reads the formula at the first evaluation.
          parser->set_time(0.5);
          parser->value(Point<dim>());
        }
      catch (const std::exception &)
        {
          throw SceneError("'" + formula + "' is not a formula in " +
                           FunctionParser<dim>::default_variable_names() +
                           ",t: " + listener.reason());
        }
      return parser;
    }
  } // namespace



  template <int dim>
  Expression<dim>::Expression(const std::string &formula)
    : text(formula)
    , parser(compile<dim>(formula))
  {}



  template <int dim>
  double
  Expression<dim>::value(const Point<dim> &p, const double t) const
  {
    if (parser->get_time() != t)
      parser->set_time(t);
    return parser->value(p);
  }



  template <int dim, int n_components>
  VectorExpression<dim, n_components>::VectorExpression(const std::string &text)
  {
    const std::vector<std::string> parts = split(text, ';');
    if (parts.empty())
      return;
    is_given = true;
    if (parts.size() != n_components)
      throw SceneError("'" + text + "' has " + std::to_string(parts.size()) +
                       " components, separated by ';', but " + std::to_string(n_components) +
                       " are needed (write 'free' for one that is not prescribed)");
    for (unsigned int d = 0; d < n_components; ++d)
      if (parts[d] != "free")
        components[d] = Expression<dim>(parts[d]);
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
    if (!components[component])
      return true;
    std::istringstream text(components[component]->formula());
    double             number;
    return text >> number && text.eof() && number == 0;
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



  double
  evaluate(const std::string &formula, const std::map<std::string, double> &constants)
  {
    const Listener listener;
    try
      {
        std::map<std::string, double> all = constants;
        all.emplace("pi", numbers::PI);
        FunctionParser<1> parser(1);
        parser.initialize("unused_variable", formula, all);
        return parser.value(Point<1>());
      }
    catch (const std::exception &)
      {
        throw SceneError("'" + formula + "' cannot be evaluated: " + listener.reason());
      }
  }



  template class Expression<2>;
  template class Expression<3>;
  template class VectorExpression<2>;
  template class VectorExpression<2, 1>;
  template class VectorExpression<3>;
} // namespace Signorini
