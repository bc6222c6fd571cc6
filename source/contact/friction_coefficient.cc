// SPDX-License-Identifier: Apache-2.0
#include "parameters/compiled_formula.h"
#include <signorini/base/text.h>
#include <signorini/contact/pair.h>
#include <signorini/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The names of the variables of the formula, in the order of the arguments of value().
    template <int dim>
    std::vector<std::string>
    variables()
    {
      return dim == 2 ? std::vector<std::string>{"x", "y", "t", "pressure", "slip"} :
                        std::vector<std::string>{"x", "y", "z", "t", "pressure", "slip"};
    }
  } // namespace



  template <int dim>
  void
  FrictionCoefficient<dim>::declare(Section &section)
  {
    section.add(
      "Friction",
      mu,
      "coefficient of Coulomb friction: a number, or a formula in x,y,z (reference configuration), "
      "t, `pressure`, and `slip`, the length of the path of slip before the load step; 0: none. "
      "The solution then depends on the load steps: compare with twice their Number");
    section.add("Friction limit",
                limit,
                "largest tangential traction that friction transmits [force/area]",
                positive);
    if (!section.reading())
      return;
    for (const char *name : {"pressure", "slip"})
      if (section.defines(name))
        section.fail("Friction",
                     std::string("'") + name +
                       "' is a variable here, and one of the Definitions; rename that one");
    try
      {
        compiled = std::make_shared<CompiledFormula>(mu, variables<dim>());
      }
    catch (const SceneError &error)
      {
        section.fail("Friction",
                     "is not a formula in " + join(variables<dim>(), ",") + ": " + error.what());
      }
    if (is_zero())
      {
        if (std::isfinite(limit))
          section.fail("Friction limit", "has no effect without Friction; remove it");
      }
    else if (compiled->is_constant() && !(compiled->value(nullptr) >= 0))
      section.fail("Friction", "must not be negative");
  }



  template <int dim>
  bool
  FrictionCoefficient<dim>::is_zero() const
  {
    return !compiled || (compiled->is_constant() && compiled->value(nullptr) == 0);
  }



  template <int dim>
  bool
  FrictionCoefficient<dim>::is_nonlinear() const
  {
    return std::isfinite(limit) ||
           (compiled && (compiled->depends_on(dim + 1) || compiled->depends_on(dim + 2)));
  }



  template <int dim>
  bool
  FrictionCoefficient<dim>::depends_on_time() const
  {
    return compiled && compiled->depends_on(dim);
  }



  template <int dim>
  bool
  FrictionCoefficient<dim>::depends_on_slip() const
  {
    return compiled && compiled->depends_on(dim + 2);
  }



  template <int dim>
  bool
  FrictionCoefficient<dim>::depends_on_points() const
  {
    bool result = depends_on_slip();
    for (unsigned int d = 0; d < dim && compiled; ++d)
      result = result || compiled->depends_on(d);
    return result;
  }



  template <int dim>
  double
  FrictionCoefficient<dim>::value(const Point<dim> &x,
                                  const double      t,
                                  const double      pressure,
                                  const double      slip) const
  {
    if (!compiled)
      return 0;
    double values[dim + 3];
    for (unsigned int d = 0; d < dim; ++d)
      values[d] = x[d];
    values[dim]         = t;
    values[dim + 1]     = pressure;
    values[dim + 2]     = slip;
    const double result = compiled->value(values);
    return result >= 0 ? result : std::numeric_limits<double>::quiet_NaN();
  }



  template <int dim>
  double
  FrictionCoefficient<dim>::bound(const Point<dim> &x,
                                  const double      t,
                                  const double      pressure,
                                  const double      slip) const
  {
    if (pressure <= 0)
      return 0;
    // The coefficient may be none at pressures that only iterates have; see
    // ContactInterfaces::check_friction() for those of solutions.
    const double mu = value(x, t, pressure, slip);
    return std::isnan(mu) ? 0. : std::min(mu * pressure, limit);
  }



  template struct FrictionCoefficient<2>;
  template struct FrictionCoefficient<3>;
} // namespace Signorini
