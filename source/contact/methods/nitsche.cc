// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/methods.h"
#include <signorini/contact/methods/method.h>
#include <signorini/parameters/section.h>

#include <sstream>

namespace Signorini
{
  /// Nitsche's method (doc/theory, 2.7) in the form for contact of Chouly and Hild (SIAM J. Numer.
  /// Anal. 51 (2013) 1295-1307): p = max(0, s(u) - eps g) with the normal stress s of the bodies at
  /// the contact points, tested with v and theta s(v):
  ///
  ///   a(u, v) - theta int s(u) s(v)/eps dA + int p (-g'(v) + theta s(v)/eps) dA = f(v).
  ///
  /// Consistent: no penetration but that of the discretisation, and no multipliers. theta = 1: the
  /// system is symmetric; 0: the fewest terms; -1: stable for any eps. eps is a multiple of the
  /// bound of s(v)^2 by the energy of the cells behind the surfaces, so that no input is needed;
  /// see NormalStress::bound(). Unbiased: the surfaces are slaves of each other, with half the
  /// weight (Chouly, Mlika, Renard, Numer. Math. 139 (2018) 593-631).
  class Nitsche : public ContactMethod
  {
  public:
    void
    declare(Section &section) override;

    Sampling
    sampling() const override
    {
      return Sampling::quadrature_points;
    }

    PressureShift
    pressure_shift() const override
    {
      return PressureShift::normal_stress;
    }

    bool
    has_multipliers() const override
    {
      return false;
    }

    double
    penalty(const PenaltyScale &scale) const override
    {
      return safety_factor * scale.bound;
    }

    double
    theta() const override
    {
      return weight_of_stress;
    }

    bool
    unbiased() const override
    {
      return two_sided;
    }

    void
    check(const Integration &integration, unsigned int degree) const override;

  private:
    double safety_factor    = 2;
    int    weight_of_stress = 1; ///< theta
    bool   two_sided        = false;
  };



  void
  Nitsche::declare(Section &section)
  {
    section.add_choice("Theta",
                       weight_of_stress,
                       {{"1", 1}, {"0", 0}, {"-1", -1}},
                       "1: symmetric systems; 0: fewest terms; -1: stable for any Factor");
    section.add(
      "Factor",
      safety_factor,
      "stabilisation parameter, in units of the smallest stable one, which follows from an "
      "eigenvalue problem on each face",
      positive);
    section.add("Unbiased",
                two_sided,
                "unbiased (two-pass) formulation: both surfaces are integrated with weight 1/2");
  }



  void
  Nitsche::check(const Integration &integration, const unsigned int /*degree*/) const
  {
    if (integration.rule == Rule::nodes)
      throw SceneError(
        "Contact method/Integration = nodes cannot be combined with Method = Nitsche, whose "
        "stabilisation bounds the mean stress of faces, not nodal stresses; set Integration = "
        "quadrature");
    // Stability: the quadratic form of the linearisation is bounded from below by (1 - (1 +
    // theta)^2/(4 Factor)) K (doc/theory, (2.18)).
    const double smallest = (1 + theta()) * (1 + theta()) / 4;
    if (safety_factor > smallest || theta() == -1)
      return;
    std::ostringstream text;
    text << "Contact method/Nitsche/Factor = " << safety_factor
         << " with Theta = " << weight_of_stress << " is not stable; set one above " << smallest
         << " (2 is usual), or Theta = -1";
    throw SceneError(text.str());
  }



  std::shared_ptr<ContactMethod>
  make_nitsche()
  {
    return std::make_shared<Nitsche>();
  }
} // namespace Signorini
