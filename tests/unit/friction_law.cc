// SPDX-License-Identifier: Apache-2.0
// The law of Coulomb at a point: its values against the conditions of friction, its derivatives
// against finite differences, for all choices of t^ and near the corners of the cone.
#include "contact/laws/coulomb_friction.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "small_scene.h"

using namespace TestScene;

namespace
{
  /// A method that only chooses p^ and whether tractions are unknowns.
  class Choice : public ContactMethod
  {
  public:
    Choice(const PressureShift shift, const bool multipliers)
      : shift(shift)
      , multipliers(multipliers)
    {
      has_friction = true;
    }

    void
    declare(Section &) override
    {}

    Sampling
    sampling() const override
    {
      return Sampling::nodes;
    }

    PressureShift
    pressure_shift() const override
    {
      return shift;
    }

    bool
    has_multipliers() const override
    {
      return multipliers;
    }

    double
    penalty(const PenaltyScale &) const override
    {
      return 1;
    }

  private:
    const PressureShift shift;
    const bool          multipliers;
  };

  const std::vector<std::pair<PressureShift, bool>> choices = {
    {PressureShift::none, false},
    {PressureShift::none, true},
    {PressureShift::multiplier, true},
    {PressureShift::last_pressure, false},
    {PressureShift::normal_stress, false}};

  LA::Vector
  one_value(const double value)
  {
    LA::Vector result(complete_index_set(1), MPI_COMM_SELF);
    result = value;
    return result;
  }

  /// The gap operator of a single point in space.
  GapOperator
  single_point(const double epsilon, const double friction)
  {
    GapOperator contact;
    contact.weight                    = one_value(1);
    contact.coefficients.least_status = one_value(0);
    contact.coefficients.stiffness    = one_value(epsilon / 20);
    contact.coefficients.epsilon      = one_value(epsilon);
    contact.coefficients.friction     = one_value(friction);
    contact.coefficients.area_ratio   = one_value(1);
    contact.tangential.B.resize(2);
    return contact;
  }

  /// Tractions of about the size of epsilon times gaps, so that all statuses occur.
  LawInput
  random_input(std::mt19937 &numbers, const double epsilon)
  {
    std::uniform_real_distribution<double> any(-1, 1);
    LawInput                               in;
    in.internal = {std::vector<LawVector>(3), {0., 0.}};
    for (unsigned int a = 0; a < 3; ++a)
      {
        in.gap[a]      = any(numbers) / epsilon;
        in.stress[a]   = any(numbers);
        in.traction[a] = any(numbers);
        if (a > 0)
          {
            in.internal.vectors[0][a] = any(numbers);
            in.internal.vectors[2][a] = any(numbers);
          }
      }
    return in;
  }

} // namespace



TEST_CASE("law of Coulomb: derivatives against finite differences, for all choices of t^")
{
  constexpr double epsilon = 7, friction = 0.6, step = 1e-6;
  GapOperator      contact = single_point(epsilon, friction);
  std::mt19937     numbers(1);
  unsigned int     count[3] = {0, 0, 0};
  // A linear relation of pressure and overclosure, and elastic slip.
  ContactCompliance soft;
  soft.kind                 = PressureOverclosure::linear;
  soft.normal_stiffness     = 5;
  soft.tangential_stiffness = 3;
  for (const auto &[shift, multipliers] : choices)
    for (unsigned int sample = 0; sample < 800; ++sample)
      {
        if (sample % 2 == 0)
          contact.coefficients.compliance_of = nullptr;
        else
          contact.coefficients.compliance_of = [&](const auto) -> const ContactCompliance & {
            return soft;
          };
        // Half of the samples have a coefficient that depends on the pressure.
        if (sample >= 400)
          contact.coefficients.bound_of = [](unsigned int, const double p) {
            return friction * p / (1 + 2 * p);
          };
        else
          contact.coefficients.bound_of = nullptr;
        CAPTURE(sample);
        CAPTURE(multipliers);
        CoulombFriction law(Choice(shift, multipliers), contact);
        law.augment({one_value(0.3), one_value(-0.2), one_value(0.4)});
        const LawInput      in     = random_input(numbers, epsilon);
        const ContactStatus status = law.status(0, law.trial(0, in));
        ++count[static_cast<int>(status)];
        const LawResponse at = law.response(0, in, status);
        // A derivative of traction and residual by one number of the input.
        const auto check =
          [&](LawVector LawInput::*member, unsigned int b, auto by_b, auto r_by_b) {
            LawInput     right = in, left = in;
            const double h = step * (member == &LawInput::gap ? 1 / epsilon : 1);
            (right.*member)[b] += h;
            (left.*member)[b] -= h;
            const LawResponse r = law.response(0, right, status), l = law.response(0, left, status);
            for (unsigned int a = 0; a < 3; ++a)
              {
                CAPTURE(a);
                CAPTURE(b);
                if (!multipliers)
                  CHECK((r.traction[a] - l.traction[a]) / (2 * h) ==
                        doctest::Approx(by_b(a)).epsilon(1e-5).scale(epsilon));
                else
                  CHECK((r.residual[a] - l.residual[a]) / (2 * h) ==
                        doctest::Approx(r_by_b(a)).epsilon(1e-5));
              }
          };
        for (unsigned int b = 0; b < 3; ++b)
          {
            check(
              &LawInput::gap,
              b,
              [&](unsigned int a) { return at.by_gap[a][b]; },
              [&](unsigned int a) { return at.residual_by_gap[a][b]; });
            if (shift == PressureShift::normal_stress)
              check(
                &LawInput::stress,
                b,
                [&](unsigned int a) { return at.by_stress[a][b]; },
                [](unsigned int) { return 0.; });
            if (multipliers)
              check(
                &LawInput::traction,
                b,
                [](unsigned int) { return 0.; },
                [&](unsigned int a) { return at.residual_by_traction[a][b]; });
          }
      }
  for (const unsigned int n : count)
    CHECK(n > 50); // all statuses have occurred
}



TEST_CASE(
  "law of Coulomb: tractions are on the disc, stick has no slip, slip is along the traction")
{
  constexpr double epsilon = 3, friction = 0.4;
  GapOperator      contact = single_point(epsilon, friction);
  std::mt19937     numbers(2);
  for (const auto &[shift, multipliers] : choices)
    for (unsigned int sample = 0; sample < 100 && !multipliers; ++sample)
      {
        const CoulombFriction law(Choice(shift, multipliers), contact);
        const LawInput        in     = random_input(numbers, epsilon);
        const LawVector       trial  = law.trial(0, in);
        const ContactStatus   status = law.status(0, trial);
        const LawResponse     at     = law.response(0, in, status);
        const double          size   = std::hypot(at.traction[1], at.traction[2]);
        CHECK(at.traction[0] == doctest::Approx(std::max(0., trial[0])));
        CHECK(size <= friction * at.traction[0] * (1 + 1e-12));
        if (status == ContactStatus::slip)
          {
            CHECK(size == doctest::Approx(friction * at.traction[0]));
            CHECK(at.traction[1] * trial[1] + at.traction[2] * trial[2] > 0);
          }
        LawVector kept = at.traction;
        kept[0]        = 0;
        CHECK((at.internal.vectors[0] - kept).norm() == 0);
        // Without further slip the traction stays as it is, whatever slip the method has left.
        if (status == ContactStatus::open || shift == PressureShift::last_pressure)
          continue;
        LawInput next = in;
        next.internal = at.internal;
        for (unsigned int a = 1; a < 3; ++a)
          next.gap[a] = 0;
        CHECK((law.response(0, next, ContactStatus::stick).traction - at.traction).norm() <= 1e-12);
      }
}



// In cycles of slip the return mapping loses the work of a parallelogram: 4 mu p times the
// amplitude less the elastic slip mu p/eps.
TEST_CASE("law of Coulomb: the loop of a penalty has the dissipation of the closed form")
{
  constexpr double      epsilon = 50, friction = 0.5, p = 2, amplitude = 0.3;
  GapOperator           contact = single_point(epsilon, friction);
  const CoulombFriction law(Choice(PressureShift::none, false), contact);
  LawInput              in;
  in.gap[0]   = -p / epsilon;
  in.internal = law.initial_variables();
  double work = 0, at = 0;
  for (unsigned int cycle = 0; cycle < 3; ++cycle)
    {
      work = 0;
      for (const double end : {amplitude, -amplitude})
        {
          constexpr unsigned int n    = 400;
          const double           from = at;
          for (unsigned int i = 1; i <= n; ++i)
            {
              const double next     = from + (end - from) * i / n;
              in.gap[1]             = next - at;
              const LawResponse now = law.response(0, in, law.status(0, law.trial(0, in)));
              work -= now.traction[1] * in.gap[1];
              in.internal = now.internal;
              at          = next;
            }
        }
    }
  const double bound = friction * p;
  CHECK(work == doctest::Approx(4 * bound * (amplitude - bound / epsilon)).epsilon(3e-3));
}



// Whatever the method, closed points satisfy g = -d(p), and stick t = t_n - k s, where the law is
// at rest: with p^ and t^ the tractions themselves.
TEST_CASE("law of Coulomb: the solution with a compliant interface does not depend on the method")
{
  constexpr double  epsilon = 7, friction = 0.6, p = 2;
  GapOperator       contact = single_point(epsilon, friction);
  ContactCompliance soft;
  soft.kind                          = PressureOverclosure::exponential;
  soft.clearance                     = 0.3;
  soft.pressure_at_zero_gap          = 0.5;
  soft.tangential_stiffness          = 3;
  contact.coefficients.compliance_of = [&](const auto) -> const ContactCompliance & {
    return soft;
  };
  contact.coefficients.has_nonlinear_compliance = true;
  const LawVector before({0, 0.3, -0.2}), slip({0, 0.1, 0.05});
  for (const auto &[shift, multipliers] : choices)
    {
      CoulombFriction law(Choice(shift, multipliers), contact);
      LawVector       traction = before - soft.tangential_stiffness * slip;
      traction[0]              = p;
      law.augment({one_value(traction[0]), one_value(traction[1]), one_value(traction[2])});
      LawInput in;
      in.gap      = slip;
      in.gap[0]   = -soft.overclosure(p).value;
      in.traction = in.stress = traction;
      in.internal             = {{before, LawVector(), before}, {0., 0.}};
      // Penalties are in series with the interface.
      if (shift == PressureShift::none)
        in.gap -= (traction - before) / epsilon;
      const ContactStatus status = law.status(0, law.trial(0, in));
      CHECK(status == ContactStatus::stick);
      const LawResponse at = law.response(0, in, status);
      CHECK((at.traction - traction).norm() < 1e-12);
      if (multipliers)
        CHECK(at.residual.norm() < 1e-12);
    }
}
