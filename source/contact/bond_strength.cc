// SPDX-License-Identifier: Apache-2.0
#include <signorini/base/scene_error.h>
#include <signorini/contact/bond_strength.h>
#include <signorini/parameters/section.h>

#include <cmath>
#include <tuple>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  BondStrength<dim>::declare(Section &section)
  {
    section.add(
      "Strength",
      tensile,
      "tensile strength of the bond of tied surfaces: where (tension/Strength)^2 + (tangential traction/Shear "
      "strength)^2 reaches 1, the bond fails for good, and the surfaces are in contact, with the Friction of "
      "the pair; a formula in x,y,z, zero where there is no bond; empty: it does not fail [force/length^2]");
    section.add("Shear strength",
                shear,
                "see Strength; a formula in x,y,z; empty: that of Strength [force/length^2]");
  }



  template <int dim>
  void
  BondStrength<dim>::check_keys(Section &section, const bool is_tied, const bool has_pretension)
  {
    if (!given() && !shear.empty())
      section.fail("Shear strength", "requires a Strength; set that, or remove it");
    if (!given())
      return;
    if (!is_tied)
      section.fail("Strength", "requires surfaces that are bonded; set Law = tied, or remove it");
    if (has_pretension)
      section.fail("Strength", "does not go with a pretension; remove one of them");
    for (const auto &[key, formula, function] :
         {std::make_tuple("Strength", &tensile, &S),
          std::make_tuple("Shear strength", shear.empty() ? &tensile : &shear, &T)})
      {
        try
          {
            function->emplace(*formula);
          }
        catch (const SceneError &error)
          {
            section.fail(key, error.what());
          }
        if ((*function)->depends_on_time())
          section.fail(key, "depends on t, but a bond keeps its strength; use x, y and z");
      }
  }



  template <int dim>
  double
  BondStrength<dim>::utilisation(const Point<dim> &x,
                                 const double      pressure,
                                 const double      shear) const
  {
    const auto share = [&](const double traction, const Expression<dim> &strength) {
      return traction > 0 ? traction / strength.value(x) : 0.;
    };
    return std::hypot(share(-pressure, *S), share(shear, *T));
  }



  template <int dim>
  bool
  BondStrength<dim>::is_absent(const Point<dim> &x) const
  {
    const double tensile_strength = S->value(x), shear_strength = T->value(x);
    if (!(tensile_strength >= 0 && shear_strength >= 0))
      throw SceneError("is negative, or no number, at some points");
    return tensile_strength == 0 || shear_strength == 0;
  }



  template struct BondStrength<2>;
  template struct BondStrength<3>;
} // namespace Signorini
