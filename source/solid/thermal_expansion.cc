// SPDX-License-Identifier: Apache-2.0
#include "parameters/compiled_formula.h"
#include <signorini/parameters/section.h>
#include <signorini/solid/thermal_expansion.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The names of the variables of a temperature formula: coordinates, time, and the field of the
    /// mesh file if there is one.
    template <int dim>
    std::vector<std::string>
    variables(const bool with_field)
    {
      std::vector<std::string> names = {"x", "y", "z", "t"};
      if (dim == 2)
        names = {"x", "y", "t"};
      if (with_field)
        names.emplace_back("field");
      return names;
    }
  } // namespace



  // Read the keys, and compile the formula: an empty one with a field of the mesh file stands for
  // that field itself.
  template <int dim>
  void
  ThermalExpansion<dim>::declare(Section &section, const bool mesh_has_field)
  {
    with_field = mesh_has_field;
    section.add("Thermal expansion",
                coefficients,
                "alpha, one number, or three along x, y, z; empty: none [1/temperature]");
    section.add(
      "Temperature",
      temperature,
      "formula in x,y,z,t, and in `field`, the Temperature field of the mesh; empty: that field");
    section.add("Reference temperature",
                reference,
                "temperature of zero thermal strain [temperature]");
    if (!section.reading())
      return;
    place = section.source_of("Temperature");
    // A temperature without an expansion coefficient would be ignored silently, which is an error
    // of the user.
    if (!given())
      {
        if (!temperature.empty())
          section.fail("Temperature", "requires Thermal expansion of the body");
        if (with_field)
          section.fail("Thermal expansion", "is required with a Temperature field");
        return;
      }
    if (coefficients.size() != 1 && coefficients.size() != 3)
      section.fail("Thermal expansion", "needs one number, or three along x, y, z");
    if (temperature.empty() && !with_field)
      section.fail("Thermal expansion", "requires Temperature of the body");
    if (with_field && section.defines("field"))
      section.fail("Temperature",
                   "'field' is the Temperature field of the mesh here, and one of the Definitions; "
                   "rename that one");
    if (temperature.empty())
      return;
    try
      {
        // Shared by the copies of the scene; formulas are evaluated at all quadrature points.
        compiled = std::make_shared<CompiledFormula>(temperature, variables<dim>(with_field));
      }
    catch (const SceneError &error)
      {
        section.fail("Temperature",
                     "is not a formula in " + join(variables<dim>(with_field), ",") + ": " +
                       error.what());
      }
    if (with_field && !depends_on_field())
      section.fail("Temperature",
                   "does not use `field`, so that the Temperature field would have no effect");
  }



  // One number is isotropic. Without expansion: zero.
  template <int dim>
  Tensor<1, 3>
  ThermalExpansion<dim>::alpha() const
  {
    Tensor<1, 3> result;
    for (unsigned int i = 0; i < 3 && given(); ++i)
      result[i] = coefficients.size() == 1 ? coefficients[0] : coefficients[i];
    return result;
  }



  // Arguments are in the order of variables(); the last one is not read without a field.
  template <int dim>
  double
  ThermalExpansion<dim>::value(const Point<dim> &x, const double t, const double field) const
  {
    if (!compiled)
      return field;
    double values[dim + 2];
    for (unsigned int d = 0; d < dim; ++d)
      values[d] = x[d];
    values[dim]     = t;
    values[dim + 1] = field;
    return compiled->value(values);
  }



  template <int dim>
  bool
  ThermalExpansion<dim>::depends_on_time() const
  {
    return compiled && compiled->depends_on(dim);
  }



  // The field of a mesh file varies in space, so that a formula that uses it depends on the
  // position even without x, y or z.
  template <int dim>
  bool
  ThermalExpansion<dim>::depends_on_place() const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (compiled && compiled->depends_on(d))
        return true;
    return depends_on_field();
  }



  template <int dim>
  bool
  ThermalExpansion<dim>::depends_on_field() const
  {
    return with_field && (!compiled || compiled->depends_on(dim + 1));
  }



  template struct ThermalExpansion<2>;
  template struct ThermalExpansion<3>;
} // namespace Signorini
