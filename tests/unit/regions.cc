// SPDX-License-Identifier: Apache-2.0
// Regions of contact points that hang together, against a search over all pairs of points; and what
// the active set makes of them.

#include "contact/laws/normal_contact.h"
#include "solver/active_set.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "two_blocks.h"

using namespace TestScene;

namespace
{
  constexpr unsigned int n_cells = 9; // of the slave, a side

  template <int dim>
  struct Surface
  {
    explicit Surface(const std::string &method_name)
      : method(make_method(method_name))
      , mesh({{"lower", unit_box(0, 4)}, {"upper", unit_box(1, n_cells)}},
             MeshSettings<dim>(),
             {{"upper.bottom", "lower.top"}},
             MPI_COMM_WORLD)
      , elasticity(mesh, {{1, 0.3}, {1, 0.3}}, {}, {}, {1})
    {
      elasticity.setup();
      elasticity.assemble();
      ContactPair<dim> pair;
      pair.slave  = "upper.bottom";
      pair.master = "lower.top";
      surfaces    = {make_contact_surface<dim>(
        elasticity, pair, nullptr, *method, {Rule::quadrature, 2, Basis::dual})};
      contact     = make_gap_operator<dim>(elasticity, surfaces, *method);
    }

    static BodyMesh<dim>
    unit_box(const int bottom, const unsigned int cells)
    {
      const std::string n = std::to_string(cells), low = std::to_string(bottom),
                        high = std::to_string(bottom + 1);
      return dim == 2 ? box<dim>("0," + low + " : 1," + high, n + "," + n) :
                        box<dim>("0,0," + low + " : 1,1," + high, n + "," + n + ",2");
    }

    LA::Vector
    vector(const std::function<double(double, double)> &of_place) const
    {
      LA::Vector v = contact->zero();
      for (const auto i : v.locally_owned_elements())
        v(i) = of_place(contact->geometry.position[0](i),
                        dim == 3 ? contact->geometry.position[1](i) : 0.5);
      v.compress(VectorOperation::insert);
      return v;
    }

    std::shared_ptr<ContactMethod>   method;
    Mesh<dim>                        mesh;
    Elasticity<dim>                  elasticity;
    std::vector<ContactSurface<dim>> surfaces;
    std::unique_ptr<GapOperator>     contact;
  };

  using Place = std::array<double, 4>; // x, y, in, value

  std::vector<Place>
  gather(const GapOperator &contact, const LA::Vector &in, const LA::Vector &values)
  {
    std::vector<Place> own;
    for (const auto i : in.locally_owned_elements())
      own.push_back({{contact.geometry.position[0](i),
                      contact.geometry.position.size() == 3 ? contact.geometry.position[1](i) : 0.,
                      in(i),
                      values(i)}});
    std::vector<Place> all;
    for (const auto &some : Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }

  /// The sum over all that can be reached from x by steps between neighbouring nodes.
  double
  sum_around(const std::vector<Place> &all, const Place &x)
  {
    std::vector<bool>          seen(all.size(), false);
    std::vector<const Place *> ends = {&x};
    double                     sum  = 0;
    while (!ends.empty())
      {
        const Place end = *ends.back();
        ends.pop_back();
        for (unsigned int i = 0; i < all.size(); ++i)
          if (!seen[i] && all[i][2] > 0 && std::abs(all[i][0] - end[0]) < 1.01 / n_cells &&
              std::abs(all[i][1] - end[1]) < 1.01 / n_cells)
            {
              seen[i] = true;
              sum += all[i][3];
              ends.push_back(&all[i]);
            }
      }
    return sum;
  }

  template <int dim>
  void
  check_sums(const std::function<double(double, double)> &in_at)
  {
    const Surface<dim> surface("Lagrange multiplier");
    const LA::Vector   in     = surface.vector(in_at),
                     values   = surface.vector([](double x, double y) { return 1 + x - 2 * y; });
    const LA::Vector sums     = surface.contact->origin.regions.sums(in, values);
    const auto       all      = gather(*surface.contact, in, values);
    unsigned int     n_inside = 0;
    for (const auto i : in.locally_owned_elements())
      {
        const Place x{{surface.contact->geometry.position[0](i),
                       dim == 3 ? surface.contact->geometry.position[1](i) : 0.,
                       in(i),
                       values(i)}};
        CHECK(sums(i) == doctest::Approx(in(i) > 0 ? sum_around(all, x) : 0.));
        n_inside += in(i) > 0;
      }
    CHECK(Utilities::MPI::sum(n_inside, MPI_COMM_WORLD) > 0);
  }
} // namespace



TEST_CASE("sums over regions of nodes, on any number of ranks")
{
  const auto two  = [](double x, double) { return x < 0.35 || x > 0.6 ? 1. : 0.; };
  const auto all  = [](double, double) { return 1.; };
  const auto ring = [](double x, double y) {
    const double r = std::hypot(x - 0.5, y - 0.5);
    return r < 0.16 || (r > 0.3 && r < 0.5) ? 1. : 0.;
  };
  const auto scattered = [](double x, double y) {
    return std::sin(40 * x + 7 * y) * std::sin(23 * y - 5 * x) > 0 ? 1. : 0.;
  };
  for (const std::function<double(double, double)> &in :
       {std::function<double(double, double)>(two), {all}, {ring}, {scattered}})
    {
      check_sums<2>(in);
      check_sums<3>(in);
    }
}



TEST_CASE("regions of points of integration: those on faces that share a node")
{
  const Surface<3> surface("Nitsche");
  const LA::Vector in     = surface.vector([](double x, double) { return x < 0.3 || x > 0.6; }),
                   ones   = surface.vector([](double, double) { return 1.; });
  const LA::Vector sums   = surface.contact->origin.regions.sums(in, ones);
  LA::Vector       left   = surface.vector([](double x, double) { return x < 0.3 ? 1. : 0.; });
  const double     n_left = left.l1_norm(), n_right = in.l1_norm() - n_left;
  for (const auto i : in.locally_owned_elements())
    CHECK(sums(i) == doctest::Approx(in(i) == 0 ? 0. : left(i) > 0 ? n_left : n_right));
}



TEST_CASE("a region that pulls as a whole is opened, with what overlaps beside it")
{
  const Surface<3> surface("penalty");
  const auto       radius = [](double x, double y) { return std::hypot(x - 0.5, y - 0.5); };
  ActiveSet        set(*surface.contact);
  set.set(surface.vector([&](double x, double y) {
    const double r = radius(x, y);
    return r < 0.16 || (r > 0.3 && r < 0.42) ? 1. : 0.;
  }));
  // The ring is turned about its middle: its inner edge pulls more than its outer one presses, and
  // beyond that there is an overlap.
  const LA::Vector    gap = surface.vector([&](double x, double y) {
    const double r = radius(x, y);
    return r < 0.16 ? -1. : r < 0.3 ? 1. : r < 0.36 ? 2. : r < 0.5 ? -0.01 : 0.1;
  });
  const NormalContact law(*ContactMethod::create("penalty"), *surface.contact);
  const LA::Vector    none  = surface.contact->zero();
  const auto          trial = [&](const LA::Vector &gaps) {
    return law.trial({{gaps}, {none}, {none}, {}});
  };
  set.update(law.status(trial(gap)));
  set.deactivate_tensile_regions(trial(gap)[0]);
  const LA::Vector expected =
    surface.vector([&](double x, double y) { return radius(x, y) < 0.16 ? 1. : 0.; });
  for (const auto i : gap.locally_owned_elements())
    CHECK(set.values()(i) == expected(i));

  // Not the last ones of a pair.
  ActiveSet alone(*surface.contact);
  alone.set(surface.vector([&](double x, double y) { return radius(x, y) < 0.3 ? 1. : 0.; }));
  const LA::Vector pulls =
    surface.vector([&](double x, double y) { return radius(x, y) < 0.1 ? -0.1 : 1.; });
  alone.update(law.status(trial(pulls)));
  const unsigned int before = alone.size();
  alone.deactivate_tensile_regions(trial(pulls)[0]);
  CHECK(before > 0);
  CHECK(alone.size() == before);
}
