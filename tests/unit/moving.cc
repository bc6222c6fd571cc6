// SPDX-License-Identifier: Apache-2.0
// Contact on surfaces that have moved: gaps and their first and second derivatives by the
// displacement against differences, for projections on curved faces, beside hanging nodes and
// inclined supports, and on obstacles that turn.

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "contact_cases.h"

using namespace TestScene;

namespace
{
  constexpr double step = 1e-6;

  template <int dim>
  Values
  coordinates(const Point<dim - 1> &xi)
  {
    return {std::round(1e9 * xi[0]), dim == 3 ? std::round(1e9 * xi[dim - 2]) : 0.};
  }

  /// Of each point of integration, by its face and place there.
  template <int dim>
  using Points = std::map<std::pair<unsigned int, Values>, ContactPoint<dim>>;

  /// The points laid at the first call, with their projections at u. Frames stay, as those of rows
  /// do.
  template <int dim>
  Points<dim>
  points_at(SmallScene<dim>  &scene,
            const LA::Vector &u,
            const LA::Vector &of_frames,
            const bool        keeps_integration_points)
  {
    scene.contact->build(Configuration<dim>(*scene.elasticity, u, of_frames),
                         false,
                         keeps_integration_points);
    Points<dim> result;
    for (const ContactPoint<dim> &point : scene.contact->surfaces()[0].points)
      result[{point.face, coordinates<dim>(point.xi)}] = point;
    return result;
  }

  /// T_i.u, see GapSecondVariation.
  template <int dim>
  std::vector<double>
  second_variation_rows(const ContactPoint<dim> &point, const Values &u)
  {
    const auto sum = [&](const FaceShapeFunctions<dim> &functions, const auto &factor) {
      Tensor<1, dim> result;
      for (const NodeShapeFunction<dim> &function : functions)
        for (unsigned int d = 0; d < dim; ++d)
          result[d] += factor(function) * u[function.node + d];
      return result;
    };
    const auto           value = [](const auto &function) { return function.value; };
    const Tensor<1, dim> jump  = sum(point.slave, value) - sum(point.master, value);
    std::vector<double>  T;
    for (const Tensor<1, dim> &direction : point.second_variation.directions)
      T.push_back(direction * jump);
    if (point.second_variation.rigid.empty())
      for (unsigned int a = 0; a < dim - 1; ++a)
        T.push_back(point.direction *
                    sum(point.master, [a](const auto &function) { return function.slopes[a]; }));
    T.resize(point.second_variation.n_rows());
    for (unsigned int i = 0; i < point.second_variation.rigid.size(); ++i)
      T[i] += at(point.second_variation.rigid[i], u);
    return T;
  }

  template <int dim>
  double
  second_variation_at(const ContactPoint<dim> &point, const Values &v, const Values &w)
  {
    const unsigned int        m    = point.second_variation.n_rows();
    const std::vector<double> of_v = second_variation_rows(point, v),
                              of_w = second_variation_rows(point, w);
    double sum                     = 0;
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        sum += point.second_variation.factors[i * m + j] * of_v[i] * of_w[j];
    return sum;
  }

  /// @param amplitude of the displacement that the surfaces have
  template <int dim>
  void
  check_points(SmallScene<dim> &scene, const double amplitude)
  {
    const Elasticity<dim> &elasticity = *scene.elasticity;
    LA::Vector             u          = scene.rough_field(amplitude, 0.3);
    const LA::Vector       v = scene.rough_field(1, 1.1), w = scene.rough_field(1, 2.3);
    const Values           all_v = distributed_change(elasticity, v),
                 all_w           = distributed_change(elasticity, w);
    elasticity.distribute(u);
    const auto moved = [&](const double a) {
      LA::Vector result = u;
      result.add(a, v);
      elasticity.distribute(result);
      return result;
    };
    points_at(scene, u, u, false);
    const Points<dim> here  = points_at(scene, u, u, true),
                      back  = points_at(scene, moved(-step), u, true),
                      forth = points_at(scene, moved(step), u, true);
    unsigned int counts[2]  = {0, 0}; // compared, on rims
    for (const auto &[name, point] : here)
      {
        if (back.count(name) == 0 || forth.count(name) == 0)
          continue;
        const ContactPoint<dim> &before = back.at(name), &after = forth.at(name);
        if (point.second_variation.factors.empty() || before.second_variation.factors.empty() ||
            after.second_variation.factors.empty())
          {
            ++counts[1];
            continue;
          }
        const double slope = (after.current_gap() - before.current_gap()) / (2 * step),
                     second_variation =
                       (at(after.row(), all_w) - at(before.row(), all_w)) / (2 * step),
                     half = (at(after.row(), all_w) - at(point.row(), all_w)) / step;
        // Displaced faces have kinks between them, over which projections change.
        if (std::abs(second_variation - half) > 0.1 * (std::abs(second_variation) + 1))
          {
            ++counts[1];
            continue;
          }
        ++counts[0];
        // Third derivatives times step^2, and the rounding of gaps over step; rough displacements
        // have slopes of some 20.
        CHECK(slope == doctest::Approx(at(point.row(), all_v)).epsilon(1e-5).scale(1));
        CHECK(second_variation ==
              doctest::Approx(second_variation_at(point, all_v, all_w)).epsilon(2e-5).scale(20));
      }
    Utilities::MPI::sum(counts, MPI_COMM_WORLD, counts);
    CHECK(counts[0] > 4 * counts[1]);
    CHECK(counts[0] >= 4);
  }

  template <int dim>
  void
  check_obstacle(const Lines &obstacle)
  {
    const std::string name = join(obstacle), coordinates = dim == 2 ? "0.3,0.4" : "0.3,-0.2,0.4",
                      all = dim == 2 ? "free; free" : "free; free; free";
    CAPTURE(name);
    Lines lines = {"Dimension=" + std::to_string(dim),
                   "Bodies/Names=block",
                   dim == 2 ? "Bodies/block/Corners=-1,-1 : 1,0" :
                              "Bodies/block/Corners=-1,-1,-1 : 1,1,0",
                   dim == 2 ? "Bodies/block/Subdivisions=3,1" : "Bodies/block/Subdivisions=3,2,1",
                   "Bodies/block/Young's modulus=10",
                   "Bodies/block/Poisson's ratio=0.3",
                   "Obstacles/Names=tool",
                   "Obstacles/tool/Reference point=" + coordinates,
                   "Obstacles/tool/Displacement=" + all,
                   dim == 2 ? "Obstacles/tool/Rotation=free" : "Obstacles/tool/Rotation=0; free; 0",
                   "Contact pairs/pair/Search distance=2"};
    for (const std::string &key : obstacle)
      lines.push_back("Obstacles/tool/" + key);
    SmallScene<dim> scene(lines + pair("block.top", "tool") +
                          fixed("block.bottom", dim == 2 ? "0; 0" : "0; 0; 0"));
    scene.use({"Method=penalty", "penalty/Weighting=pointwise"});
    check_points(scene, 0.05);
  }

  template <int dim>
  std::vector<Lines>
  obstacles()
  {
    const std::string zero = dim == 2 ? "" : "0,", down = dim == 2 ? "0,-1" : "0,0,-1",
                      up      = dim == 2 ? "y" : "z";
    std::vector<Lines> result = {
      {"Shape=plane", "Point=" + zero + "0.1,0.2", "Normal=" + zero + "0.3,-1"},
      {"Shape=sphere", "Center=" + zero + "0.1,2.1", "Radius=2"},
      {"Shape=sphere", "Center=" + zero + "0.1,-3", "Radius=3.2", "Hollow=yes"},
      {"Shape=cylinder", "Center=" + zero + "0.1,2.1", "Radius=2"},
      {"Shape=cone", "Apex=" + zero + "-1.5,-0.1", "Normal=" + down, "Angle=10"},
      {"Shape=paraboloid", "Apex=" + zero + "0.1,0.1", "Normal=" + down, "Radius=2"},
      {"Shape=gap function", "Gap=0.1 - " + up + " + 0.2*x^2", "Normal=" + down},
      {"Shape=punch",
       "Center=" + zero + "-1.3,0.02",
       "Normal=" + down,
       "Radius=0.2",
       "Edge radius=8"}};
    if (dim == 3)
      result[3].push_back("Axis=1,0.2,0.1");
    return result;
  }
} // namespace



TEST_CASE("gaps to obstacles that have moved and turned bend as their second variation says")
{
  for (const Lines &obstacle : obstacles<2>())
    check_obstacle<2>(obstacle);
  for (const Lines &obstacle : obstacles<3>())
    check_obstacle<3>(obstacle);
}



namespace
{
  template <int dim>
  void
  check_bodies(const Case &which)
  {
    CAPTURE(which.name);
    for (const std::string integration : {"segments", "quadrature"})
      {
        CAPTURE(integration);
        SmallScene<dim> scene(which.lines + Lines{"Dimension=" + std::to_string(dim),
                                                  "Contact pairs/pair/Initial gap=from geometry"});
        if (scene.scene.obstacle_of(scene.decisions.pairs[0]))
          return;
        scene.use({"Method=penalty", "Integration=" + integration});
        check_points(scene, 0.002);
      }
  }
} // namespace

TEST_CASE("gaps between bodies that have moved bend as their second variation says")
{
  for (const Case &which : cases_2d())
    check_bodies<2>(which);
  check_bodies<3>(cases_3d()[1]); // the curved one
}



namespace
{
  /// Of the geometric stiffness: all together they make its products.
  /// @param expected Gv
  void
  check_entries(const GapOperator &contact, const LA::Vector &v, const LA::Vector &expected)
  {
    LA::Vector numbers;
    numbers.reinit(v);
    for (const auto i : v.locally_owned_elements())
      numbers(i) = i;
    numbers.compress(VectorOperation::insert);
    const Values of_v = everywhere(v), exact = everywhere(expected);
    Values       product(of_v.size(), 0.);
    contact.for_each_geometric_entry(
      numbers, [&](const double row, const double column, const double value) {
        product[row] += value * of_v[column];
      });
    Utilities::MPI::sum(product, MPI_COMM_WORLD, product);
    double worst = 0, size = 0;
    for (unsigned int i = 0; i < product.size(); ++i)
      {
        worst = std::max(worst, std::abs(product[i] - exact[i]));
        size  = std::max(size, std::abs(exact[i]));
      }
    CHECK(size > 0);
    CHECK(worst < 1e-12 * size);
  }

  /// The forces of given pressures: their change is that of the geometric stiffness.
  /// @param keeps_integration_points those of integration; else segments end where the master's
  /// faces do
  template <int dim>
  void
  check_forces(const Case &which, const Lines &method, const bool keeps_integration_points = true)
  {
    const std::string name = which.name + ": " + join(method);
    CAPTURE(name);
    SmallScene<dim> scene(which.lines + Lines{"Dimension=" + std::to_string(dim),
                                              "Contact pairs/pair/Initial gap=from geometry"});
    scene.use(method);
    const Elasticity<dim> &elasticity = *scene.elasticity;
    LA::Vector             u          = scene.rough_field(0.002, 0.3);
    const LA::Vector       v          = scene.rough_field(1, 1.1);
    elasticity.distribute(u);
    const auto force_at = [&](const double a) {
      LA::Vector there = u;
      there.add(a, v);
      elasticity.distribute(there);
      scene.contact->build(Configuration<dim>(elasticity, there, u),
                           false,
                           keeps_integration_points);
      LA::Vector p = scene.gap_operator().zero();
      p            = 1.;
      return scene.gap_operator().force({p}, {p});
    };
    scene.contact->build(Configuration<dim>(elasticity, u));
    const LA::Vector force = force_at(0);
    LA::Vector       p     = scene.gap_operator().zero(), expected;
    p                      = 1.;
    expected.reinit(force);
    scene.contact->build_geometric_stiffness({p});
    scene.gap_operator().subtract_geometric(expected, v);
    expected *= -1;
    check_entries(scene.gap_operator(), v, expected);
    LA::Vector difference = force_at(step);
    difference -= force_at(-step);
    difference /= 2 * step;
    const double size = difference.l2_norm();
    difference -= expected;
    CHECK(size > 0);
    // Unbiased: some points of the bore have a kink of the pin for their projection. Where master
    // faces meet, gaps jump a little.
    const double allowed = scene.method().unbiased() ? 0.05 :
                           keeps_integration_points  ? 1e-3 :
                                                       4e-3;
    CHECK(difference.l2_norm() < allowed * size);
  }
} // namespace

TEST_CASE("the forces of pressures change with the surfaces as the geometric stiffness says")
{
  // Those whose gap operators differ.
  const Lines              multiplier = {"Method=Lagrange multiplier"};
  const std::vector<Lines> methods    = {multiplier,
                                         {"Method=Lagrange multiplier", "Pressure basis=standard"},
                                         {"Method=penalty",
                                          "penalty/Factor=5",
                                          "penalty/Weighting=pointwise"},
                                         {"Method=Nitsche", "Nitsche/Theta=1"},
                                         {"Method=Nitsche", "Nitsche/Unbiased=yes"},
                                         {"Method=direct elimination"}};
  check_forces<3>(cases_3d()[1], multiplier);
  const Case in_2d{"within the master", boxes("0,0 : 1,1", "7,1", "0.17,1 : 0.83,2", "4,1")},
    in_3d{"within the master",
          boxes("0,0,0 : 1,1,1", "5,4,1", "0.17,0.15,1 : 0.83,0.81,2", "3,2,1")};
  check_forces<2>(in_2d, multiplier, false);
  // Points enough for the error of integration to change little with the parts of faces.
  check_forces<3>(in_3d, multiplier + Lines{"Quadrature points=3"}, false);
  for (const Lines &method : methods)
    check_forces<2>(cases_2d()[1], method);
  check_forces<2>(cases_2d()[3], multiplier); // inclined supports
}



TEST_CASE("a moment does the same work on rotations as on the spin, after any turn")
{
  const double                rotation_length_scale = 3;
  const RigidPose<3>::Moment  moment({1, -2, 0.5});
  const std::array<double, 6> change = {{0, 0, 0, 0.2, -0.7, 1.3}};
  const std::array<double, 6> turned = {{1,
                                         2,
                                         3,
                                         0.7 * rotation_length_scale,
                                         -1.1 * rotation_length_scale,
                                         2 * rotation_length_scale}};
  const RigidPose<3>          pose({1, 0, 2}, turned, rotation_length_scale);
  const RigidPose<3>::Moment  f = pose.on_rotations(moment), back = pose.moment_of(f);
  double                      work = 0;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      work += moment[i] * pose.spin(i)[3 + j] * change[3 + j];
  for (unsigned int j = 0; j < 3; ++j)
    work -= f[j] * change[3 + j];
  CHECK(std::abs(work) < 1e-14);
  CHECK((back - moment).norm() < 1e-14);

  // Two whole turns about z.
  const RigidPose<3>         whole({1, 0, 2},
                           {{0, 0, 0, 0, 0, 4 * numbers::PI * rotation_length_scale}},
                           rotation_length_scale);
  const RigidPose<3>::Moment known = whole.moment_of(whole.on_rotations(moment));
  CHECK(known[2] == doctest::Approx(0.5));
  CHECK(std::isnan(known[0]));
  CHECK(std::isnan(known[1]));

  const RigidPose<2> flat({1, 0}, {{0, 0, 5 * rotation_length_scale, 0}}, rotation_length_scale);
  CHECK(flat.moment_of(flat.on_rotations(RigidPose<2>::Moment({7})))[0] == doctest::Approx(7));
}
