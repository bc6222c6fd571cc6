// SPDX-License-Identifier: Apache-2.0
// Relations of pressure and overclosure: that the pressure of a trial value solves its equation,
// for penalties of all sizes, and derivatives against finite differences.
#include <signorini/contact/contact_compliance.h>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace Signorini;

namespace
{
  std::vector<ContactCompliance>
  relations()
  {
    std::vector<ContactCompliance> result(4);
    result[1].kind                 = PressureOverclosure::linear;
    result[1].normal_stiffness     = 3e4;
    result[2].kind                 = PressureOverclosure::exponential;
    result[2].clearance            = 0.02;
    result[2].pressure_at_zero_gap = 5;
    result[3].kind                 = PressureOverclosure::tabular;
    result[3].table                = {{0, -0.01}, {2, 0.}, {10, 0.003}, {30, 0.1}};
    return result;
  }
} // namespace



TEST_CASE("contact compliance: the pressure of a trial value solves its equation")
{
  for (const ContactCompliance &one : relations())
    for (const double epsilon : {1e-3, 1e3, 1e9})
      for (const double trial : {1e-8, 0.01, 0.3, 7., 1e3, 1e8})
        {
          CAPTURE(static_cast<int>(one.kind));
          CAPTURE(epsilon);
          CAPTURE(trial);
          const auto   p       = one.pressure(trial, epsilon);
          const double closing = one.overclosure(p.value).value - one.overclosure(0).value;
          CHECK(p.value > 0);
          const double rounding = 1e-17 * epsilon;
          CHECK(std::abs(p.value + epsilon * closing - trial) <= 1e-11 * trial + rounding);
          const double step = 1e-6 * trial;
          CHECK(p.derivative == doctest::Approx((one.pressure(trial + step, epsilon).value -
                                                 one.pressure(trial - step, epsilon).value) /
                                                (2 * step))
                                  .epsilon(1e-4));
        }
}



TEST_CASE("contact compliance: derivatives of the overclosure, and where contact begins")
{
  const std::vector<double> reaches = {0, 0, 0.02, 0.01};
  for (unsigned int i = 0; i < 4; ++i)
    {
      const ContactCompliance one = relations()[i];
      CHECK(one.reach() == doctest::Approx(reaches[i]));
      for (const double p : {0.04, 0.3, 7., 25., 1e3})
        {
          const double step = 1e-6 * p;
          CHECK(one.overclosure(p).derivative == doctest::Approx((one.overclosure(p + step).value -
                                                                  one.overclosure(p - step).value) /
                                                                 (2 * step)));
        }
    }
  // The pressure at zero gap, and a hundredth of it at the clearance.
  const ContactCompliance exponential = relations()[2];
  CHECK(exponential.overclosure(5).value == doctest::Approx(0));
  CHECK(exponential.overclosure(0.05).value == doctest::Approx(-0.02));
  CHECK(exponential.overclosure(500).value == doctest::Approx(0.02));
  // The last line of a table continues.
  CHECK(relations()[3].overclosure(50).value == doctest::Approx(0.197));
}
