// SPDX-License-Identifier: Apache-2.0
#include "parameters/compiled_formula.h"
#include <signorini/parameters/expression.h>
#include <signorini/parameters/raw.h>

#include <doctest/doctest.h>

#include <cmath>

using namespace Signorini;

namespace
{
  std::shared_ptr<const Definitions>
  definitions(const std::vector<std::pair<std::string, std::string>> &list)
  {
    auto result = std::make_shared<Definitions>();
    for (const auto &[name, formula] : list)
      result->add(name, formula);
    return result;
  }
} // namespace



TEST_CASE("definitions are evaluated in their order, where they vary again and again")
{
  const auto names =
    definitions({{"R", "8"}, {"r", "sqrt(x^2 + y^2)"}, {"gap", "r^2/(2*R)"}, {"unused", "1/0"}});
  const Expression<2> expression(Formula("gap*t + R", names));
  for (const double x : {0., 1., -3.})
    for (const double t : {0.5, 2.})
      CHECK(expression.value({x, 2.}, t) == doctest::Approx((x * x + 4) / 16 * t + 8));
  CHECK(expression.formula() == "gap*t + R");
  // Copies share their values, but set all of them before each use.
  const Expression<2> copy = expression;
  CHECK(copy.value({1, 0}, 16) == doctest::Approx(9));
  CHECK(expression.value({0, 0}, 16) == doctest::Approx(8));
  CHECK(evaluate(Formula("R*k", names), {{"k", 3}}) == doctest::Approx(24));
}



TEST_CASE("each name is defined once, before it is used, and means nothing else")
{
  CHECK_THROWS_AS(definitions({{"a", "2*b"}, {"b", "1"}}), SceneError);
  CHECK_THROWS_AS(definitions({{"a", "2*a"}}), SceneError);
  CHECK_THROWS_AS(definitions({{"a", "1"}, {"a", "2"}}), SceneError);
  CHECK_THROWS_AS(definitions({{"t", "1"}}), SceneError);
  CHECK_THROWS_AS(definitions({{"pi", "3"}}), SceneError);
  CHECK_THROWS_AS(definitions({{"_e", "3"}}), SceneError);
  CHECK_THROWS_AS(definitions({{"sin", "1"}}), SceneError);
  CHECK_THROWS_AS(definitions({{"2a", "1"}}), SceneError);
  CHECK_THROWS_AS(definitions({{"a b", "1"}}), SceneError);
  CHECK_THROWS_AS(definitions({{"a", ""}}), SceneError);
  CHECK_THROWS_AS(definitions({{"a", "1; 2"}}), SceneError);
  CHECK_THROWS_AS(evaluate(Formula("a", definitions({{"a", "x"}})), {}), SceneError);
}



TEST_CASE("many definitions, each of which uses the one before, take no time")
{
  std::vector<std::pair<std::string, std::string>> list{{"a0", "x"}};
  for (unsigned int i = 1; i < 50; ++i)
    list.push_back(
      {"a" + std::to_string(i), "a" + std::to_string(i - 1) + " + " + (i % 2 == 0 ? "1" : "y")});
  const Expression<2> last(Formula("a49 - a4", definitions(list)));
  CHECK(last.value({3, 2}) == doctest::Approx(23 * 2 + 22));
}



TEST_CASE("what a formula depends on is known, through its definitions too")
{
  const auto names = definitions({{"zero", "0"}, {"r", "sqrt(x^2 + y^2)"}, {"ramp", "t/2"}});
  CHECK(Expression<2>(Formula("zero", names)).is_zero());
  CHECK(Expression<2>("0.0").is_zero());
  CHECK(!Expression<2>(Formula("zero*x", names)).is_zero());
  CHECK(Expression<2>(Formula("1 + r", names)).depends_on_place());
  CHECK(!Expression<2>(Formula("2*ramp", names)).depends_on_place());
  CHECK(Expression<2>("if(x > 10, 0.5, 1)").depends_on_place());
}



TEST_CASE("a table is linear between its points and constant beyond")
{
  const Expression<2> load("table(t, 0, 1, 2, 5, 3, -1)");
  for (const auto &[t, value] : std::vector<std::pair<double, double>>{
         {-1, 1}, {0, 1}, {1, 3}, {2, 5}, {2.5, 2}, {3, -1}, {9, -1}})
    CHECK(load.value({}, t) == doctest::Approx(value));
  CHECK_THROWS_AS(Expression<2>("table(t, 0, 1, 0, 5)"), SceneError);
  CHECK_THROWS_AS(Expression<2>("table(t, 0, 1)"), SceneError);
  // Where its points are in order depends on the place: no exception, which others would not see.
  CHECK(std::isnan(Expression<2>("table(x, 0, 0, 2 - x, 1)").value({3, 0})));
}



TEST_CASE("slips are refused that muParser would take for something else")
{
  CHECK_THROWS_AS(Expression<2>("if(t = 0.5, 1, 2)"), SceneError);
  CHECK(Expression<2>("if(t == 0.5, 1, 2) + if(t >= 1, 10, 20)").value({}, 0.5) ==
        doctest::Approx(21));
  CHECK_THROWS_AS(evaluate("1,5", {}), SceneError);
  CHECK_THROWS_AS(definitions({{"a", "1,5"}}), SceneError);
}



TEST_CASE("functions beyond those of muParser")
{
  CHECK(evaluate("if(1 < 2, 3, 4) + if(1 > 2, 30, 40)", {}) == doctest::Approx(43));
  CHECK(evaluate("if(0, 1/0, 2)", {}) == doctest::Approx(2));
  CHECK(evaluate("pow(2, 3) + floor(1.7) + ceil(1.2) + int(1.5)", {}) == doctest::Approx(13));
  CHECK(evaluate("log(exp(2)) + log10(100)", {}) == doctest::Approx(4));
  CHECK(evaluate("(1 < 2 & 2 < 1) + 2*(1 < 2 | 2 < 1)", {}) == doctest::Approx(2));
  CHECK(evaluate("cos(pi)", {}) == doctest::Approx(-1));
}
