// SPDX-License-Identifier: Apache-2.0
#include <signorini/contact/pretension.h>
#include <signorini/parameters/expression.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  Pretension<dim>::declare(Section &section)
  {
    section.add("Pretension",
                force,
                "the tied surfaces are the two sides of a section through a bolt, and this is the "
                "tension over it: a formula in t; empty: none [force]");
    section.add("Shortening",
                shortening,
                "instead of Pretension: by how much the bolt is shortened at the section, a "
                "formula in t; empty: not prescribed [length]");
    section.add(
      "Lock time",
      driven.until,
      "the Pretension acts up to this time, at which a load step ends; then the shortening "
      "that it has caused stays; 0: the Pretension acts to the end",
      non_negative);
    section.add("Pretension direction",
                direction,
                "direction of the shortening, out of the slave; 0: the mean normal of the slave");
  }



  template <int dim>
  void
  Pretension<dim>::check_keys(Section &section, const bool is_tied) const
  {
    if (!given())
      {
        if (driven.until > 0)
          section.fail("Lock time", "requires a Pretension; set that, or remove it");
        if (direction.norm() > 0)
          section.fail("Pretension direction",
                       "requires a Pretension or a Shortening; set one of them, or remove it");
        return;
      }
    const std::string key = force.empty() ? "Shortening" : "Pretension";
    if (!is_tied)
      section.fail(key, "requires the two sides of a section that are tied; set Law = tied");
    if (!force.empty() && !shortening.empty())
      section.fail("Shortening", "is determined by the Pretension; remove one of them");
    if (force.empty() && driven.until > 0)
      section.fail("Lock time",
                   "requires a Pretension; let the formula of the Shortening be constant from then "
                   "on");
    // The formula is compiled once for its errors, so that they are reported with the key.
    bool depends_on_place = false;
    try
      {
        depends_on_place = Expression<dim>(force.empty() ? shortening : force).depends_on_place();
      }
    catch (const SceneError &error)
      {
        section.fail(key, error.what());
      }
    if (depends_on_place)
      section.fail(
        key,
        "depends on x, y or z, but is one number for the whole section; use a formula in "
        "t alone");
  }



  template <int dim>
  RigidBody<dim>
  Pretension<dim>::body(const std::string &pair_name) const
  {
    const auto along_first = [](const Formula &formula) {
      Formula all = formula;
      for (unsigned int d = 1; d < dim; ++d)
        all.text += "; 0";
      return VectorExpression<dim>(all);
    };
    RigidBody<dim> result;
    result.name         = body_name(pair_name);
    result.displacement = along_first(force.empty() ? shortening : Formula("free"));
    if (!force.empty())
      result.force = along_first(force);
    result.is_shortening = true;
    result.driven        = driven;
    return result;
  }



  template struct Pretension<2>;
  template struct Pretension<3>;
} // namespace Signorini
