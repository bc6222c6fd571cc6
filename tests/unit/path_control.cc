// SPDX-License-Identifier: Apache-2.0
// The choice of load steps with friction.
#include "driver/path_control.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace Signorini;
using namespace dealii;

namespace
{
  /// A solution with one traction.
  PathControl::Solution
  solution(const double traction, const double work = 0)
  {
    LA::Vector t(complete_index_set(1), MPI_COMM_SELF);
    t(0) = traction;
    t.compress(VectorOperation::insert);
    return {{t}, work};
  }

  /// A traction that grows from zero to one, followed by a rule that errs by the square of the
  /// length of a step: the error at the end, the sum of the estimates, the number of load steps.
  struct Path
  {
    double       error = 0, estimated = 0;
    unsigned int n = 0;
  };

  Path
  follow(const double tolerance, const double curvature)
  {
    PathControl control(tolerance);
    control.set_budget({{1, 0}, {}});
    // Each step of length h errs by curvature h^2.
    const auto after = [&](const double from, const double h) {
      return from + h - curvature * h * h;
    };
    Path   path;
    double t = 0, value = 0, length = 0.125;
    while (t < 1 - 1e-12)
      {
        const double h      = std::min(length, 1 - t);
        const double coarse = after(value, h), fine = after(after(value, h / 2), h / 2);
        if (!control.judge(solution(value), solution(coarse), solution(fine)))
          {
            length = h / 2;
            continue;
          }
        control.accept();
        t += h;
        value  = fine;
        length = control.growth() * h;
        path.estimated += control.error();
        ++path.n;
      }
    path.error = std::abs(value - 1);
    return path;
  }
} // namespace



TEST_CASE("the error of a monotone path is within the tolerance, and is the sum of the estimates")
{
  for (const double tolerance : {1e-1, 1e-2, 1e-3})
    {
      const Path path = follow(tolerance, 0.5);
      CHECK(path.error <= tolerance);
      CHECK(path.estimated == doctest::Approx(path.error).epsilon(1e-10));
      // The halves of n equal steps err by 0.25/n in all.
      CHECK(path.n <= 8 + 0.25 / (0.25 * tolerance));
    }
}



TEST_CASE("an exact path is followed in steps that double")
{
  const Path path = follow(1e-2, 0);
  CHECK(path.error == 0);
  CHECK(path.n == 4); // 1/8, 1/4, 1/2 and the rest
}



TEST_CASE("the work decides as well as the tractions")
{
  PathControl control(1e-2);
  control.set_budget({{1, 1}, {}});
  // Tractions are exact; the work changes by 2 % of the largest, more than half of the tolerance.
  CHECK(!control.judge(solution(1, 0), solution(1, 0.98), solution(1, 1)));
  CHECK(control.error() == doctest::Approx(0.02));
  CHECK(control.growth() == 1);
  CHECK(control.judge(solution(1, 0), solution(1, 0.999), solution(1, 1)));
  // The largest sizes are those of any load step.
  CHECK(control.judge(solution(1, 1), solution(2, 3), solution(2, 3)));
  CHECK(control.budget().largest.tractions == 2);
  CHECK(control.budget().largest.work == 3);
}



TEST_CASE("work that is rounding does not decide")
{
  PathControl           control(1e-2);
  PathControl::Solution coarse = solution(1, 1e-12), fine = solution(1, 3e-12);
  CHECK(!control.judge(solution(0), coarse, fine));
  fine.negligible_work = 1e-6;
  CHECK(control.judge(solution(0), coarse, fine));
  CHECK(control.error() <= 1e-5);
}



TEST_CASE("a coefficient that the slip of the halves changes makes load steps shorter")
{
  PathControl           control(1e-2);
  PathControl::Solution fine = solution(1);
  fine.change_of_friction    = 0.02;
  CHECK(!control.judge(solution(0), solution(1), fine));
  CHECK(control.growth() == 1);
  fine.change_of_friction = 0.006;
  CHECK(control.judge(solution(0), solution(1), fine));
  CHECK(control.growth() == doctest::Approx(1.5));
}



TEST_CASE("small errors at the start of a history are small beside its largest tractions")
{
  PathControl control(1e-2);
  control.set_budget({{1, 0}, {}});
  // A third of the traction, which a scale of its own would never allow.
  CHECK(control.judge(solution(0), solution(2e-4), solution(3e-4)));
  CHECK(!control.judge(solution(0), solution(2e-3), solution(3e-3)));
}
