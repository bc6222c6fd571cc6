// SPDX-License-Identifier: Apache-2.0
// What Newton's method decides: which points are active, which motions are loose, what overlaps
// count; on contact points without bodies.

#include "contact/laws/normal_contact.h"
#include "solver/active_set.h"
#include "solver/unconstrained_modes.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <doctest/doctest.h>

#include <cmath>

#include "small_scene.h"

using namespace TestScene;

namespace
{
  /// Points along a line, two a pair, on the degrees of freedom of the same numbers: g = u + g_0.
  struct Points
  {
    explicit Points(const Values &rest_gaps)
    {
      const MPI_Comm     comm = MPI_COMM_WORLD;
      const unsigned int n    = rest_gaps.size();
      const unsigned int rank = Utilities::MPI::this_mpi_process(comm);
      owned = LA::contiguous_partition(rank == 0 ? n - n / 2 : rank == 1 ? n / 2 : 0, comm);
      if (Utilities::MPI::n_mpi_processes(comm) == 1)
        owned = complete_index_set(n);
      contact.dofs = owned;
      DynamicSparsityPattern diagonal(n, n);
      for (unsigned int i = 0; i < n; ++i)
        diagonal.add(i, i);
      contact.B.reinit(owned, diagonal, comm);
      for (LA::Vector *v : {&contact.weight,
                            &contact.coefficients.stiffness,
                            &contact.coefficients.epsilon,
                            &contact.coefficients.least_status,
                            &contact.reference_gap})
        v->reinit(owned, comm);
      contact.weight                 = 2.;
      contact.coefficients.stiffness = 1.;
      contact.coefficients.epsilon   = 10.;
      contact.geometry.position.assign(2, contact.zero());
      for (const auto i : owned)
        {
          contact.origin.pair.push_back(i / 2);
          contact.B.set(i, i, 1);
          contact.reference_gap(i)        = rest_gaps[i];
          contact.geometry.position[0](i) = i;
        }
      contact.B.compress(VectorOperation::insert);
      contact.reference_gap.compress(VectorOperation::insert);
      contact.geometry.position[0].compress(VectorOperation::insert);
      contact.B_free.copy_from(contact.B);
      contact.initial_gap = contact.reference_gap;
    }

    LA::Vector
    vector(const Values &values) const
    {
      LA::Vector v = contact.zero();
      for (const auto i : owned)
        v(i) = values[i];
      v.compress(VectorOperation::insert);
      return v;
    }

    IndexSet    owned;
    GapOperator contact;
  };

  /// p - eps g
  LA::Vector
  trial(const GapOperator &contact, const LA::Vector &gap, const LA::Vector &p)
  {
    const LA::Vector none = contact.zero();
    return NormalContact(*ContactMethod::create("Lagrange multiplier"), contact)
      .trial({{gap}, {none}, {p}, {}})[0];
  }

  /// The statuses where that presses.
  LA::Vector
  status(const GapOperator &contact, const LA::Vector &gap, const LA::Vector &p)
  {
    return NormalContact(*ContactMethod::create("Lagrange multiplier"), contact)
      .status({trial(contact, gap, p)});
  }

  Values
  values_of(const ActiveSet &set)
  {
    return everywhere(set.values());
  }
} // namespace



TEST_CASE("the law: p^ - eps g where that pushes, at permanent points always")
{
  Points points({0, 0, 0, 0, 0, 0});
  points.contact.coefficients.least_status = points.vector({0, 0, 0, 0, 1, 1});
  const LA::Vector gap                     = points.vector({-1, 1, 1, -1, 1, -1}),
                   p                       = points.vector({0, 0, 11, -11, 5, 5});
  CHECK(everywhere(status(points.contact, gap, p)) == Values({1, 0, 1, 0, 1, 1}));

  // A node without area is never active.
  points.contact.weight = points.vector({0, 2, 2, 2, 2, 2});
  CHECK(everywhere(status(points.contact, gap, p)) == Values({0, 0, 1, 0, 1, 1}));

  const LA::Vector active = points.vector({1, 0, 1, 0, 1, 1}),
                   sevens = points.vector({7, 7, 7, 7, 7, 7}), none = points.contact.zero();
  const LawInputs     in{{gap}, {none}, {sevens}, {}};
  const NormalContact multiplier(*ContactMethod::create("Lagrange multiplier"), points.contact);
  CHECK(everywhere(multiplier.traction(in, active)[0]) == Values({7, 0, 7, 0, 7, 7}));
  NormalContact augmented(*ContactMethod::create("augmented Lagrangian"), points.contact);
  augmented.augment({p});
  CHECK(everywhere(augmented.traction(in, active)[0]) == Values({10, 0, 1, 0, -5, 15}));
}



TEST_CASE("shares of overlaps: gaps stay, at permanent points they count as well")
{
  Points points({-1, 1, -2, 2, -3, 3});
  points.contact.coefficients.least_status = points.vector({0, 0, 0, 0, 1, 1});
  points.contact.set_interference({0.5, 0.25, 0.5});
  CHECK(everywhere(points.contact.initial_gap) == Values({-0.5, 1, -0.5, 2, -1.5, 1.5}));
  points.contact.set_interference({1, 1, 1});
  CHECK(everywhere(points.contact.initial_gap) == Values({-1, 1, -2, 2, -3, 3}));
  CHECK(everywhere(points.contact.gap(points.vector({1, 1, 1, 1, 1, 1}))) ==
        Values({0, 2, -1, 3, -2, 4}));
}



TEST_CASE("of overlapping points the deepest half of each pair comes first")
{
  const Points     points({-1, -0.4, -8, -5, -3, 1});
  ActiveSet        set(points.contact);
  const LA::Vector gap = points.contact.initial_gap;
  set.update(status(points.contact, gap, points.contact.zero()));
  CHECK(set.size() == 5);
  CHECK(set.restrict_to_deepest(gap) == 4);
  CHECK(values_of(set) == Values({1, 0, 1, 1, 1, 0}));
  CHECK(set.count_changes().all == 4);
  // What was active stays.
  set.update(status(points.contact, gap, points.contact.zero()));
  CHECK(set.restrict_to_deepest(gap) == 4);
  CHECK(set.count_changes().all == 0);
}



TEST_CASE("points that only touch do not count at first, those that never separate do")
{
  Points points({0, -1e-13, 3, 0, 0, 0});
  points.contact.coefficients.least_status = points.vector({0, 0, 0, 0, 1, 1});
  ActiveSet set(points.contact);
  set.update(status(points.contact, points.contact.initial_gap, points.contact.zero()));
  CHECK(set.size() == 3);
  CHECK(set.deactivate_zero_gap(points.contact.initial_gap) == 2);
  CHECK(set.n_active_unilateral() == 0);
  CHECK(values_of(set) == Values({0, 0, 0, 0, 1, 1}));
  set.set(points.vector({1, 0, 0, 0, 0, 0}));
  CHECK(values_of(set) == Values({1, 0, 0, 0, 1, 1}));
}



TEST_CASE("one at a time: the point that violates the law most")
{
  const Points points({0, 0, 0, 0, 0, 0});
  ActiveSet    set(points.contact);
  set.set(points.vector({1, 1, 1, 0, 0, 0}));
  // Two pull, one overlaps; the law: p - 10 g.
  const LA::Vector gap = points.vector({0, 0, 0, -0.3, 0.1, 0}),
                   p   = points.vector({-2, -1, 4, 0, 0, 0});
  set.update(status(points.contact, gap, p));
  CHECK(values_of(set) == Values({0, 0, 1, 1, 0, 0}));
  set.change_only_most_violated(trial(points.contact, gap, p));
  CHECK(values_of(set) == Values({1, 1, 1, 1, 0, 0}));
  CHECK(set.count_changes().all == 1);
}



TEST_CASE("sets that come up again are seen, but not those that stay")
{
  const Points points({0, 0, 0, 0, 0, 0});
  ActiveSet    set(points.contact);
  const auto   seen = [&](const Values &gap) {
    set.update(status(points.contact, points.vector(gap), points.contact.zero()));
    return set.is_cycling();
  };
  CHECK(!seen({-1, 1, 1, 1, 1, 1}));
  CHECK(!seen({-1, 1, 1, 1, 1, 1}));
  CHECK(!seen({-1, -1, 1, 1, 1, 1}));
  CHECK(!seen({-1, 1, 1, 1, 1, -1}));
  CHECK(seen({-1, -1, 1, 1, 1, 1}));
  set.restart();
  CHECK(!seen({-1, 1, 1, 1, 1, 1}));
}



TEST_CASE("a set that is left at the first step is kept for one more")
{
  const Points points({0, 0, 0, 0, 0, 0});
  ActiveSet    set(points.contact);
  set.set(points.vector({1, 1, 0, 0, 0, 0}));
  set.update(status(points.contact, points.vector({1, 1, 1, 1, 1, 1}), points.contact.zero()));
  CHECK(set.size() == 0);
  CHECK(set.restore_previous_if_active());
  CHECK(values_of(set) == Values({1, 1, 0, 0, 0, 0}));
  CHECK(!set.restore_previous_if_active());
}



namespace
{
  /// Motions of the first and of the last two degrees of freedom.
  UnconstrainedModes
  two_motions(const Points &points, const LA::Vector &stabilisation)
  {
    return {{{"left", points.vector({1, 1, 0, 0, 0, 0})},
             {"right", points.vector({0, 0, 0, 0, 3, 3})}},
            stabilisation,
            points.contact};
  }
} // namespace

TEST_CASE("what active points leave loose has springs, what they stop has none")
{
  const Points       points({2, 6, 1, 1, 4, 5});
  const LA::Vector   stabilisation = points.vector({4, 4, 0, 0, 1, 3});
  UnconstrainedModes motions       = two_motions(points, stabilisation);
  CHECK(motions.unconstrainable().empty());
  motions.set_status(points.vector({0, 1, 0, 0, 0, 0}));
  CHECK(motions.unconstrained() == std::vector<std::string>{"right"});

  // K - S + S z (S z)^T with z.S z = 1: along z it is K again.
  const LA::Vector right = points.vector({0, 0, 0, 0, 1, 1}),
                   left  = points.vector({1, 1, 0, 0, 0, 0});
  LA::Vector f           = points.contact.zero();
  motions.subtract_stabilisation(f, right);
  CHECK(everywhere(f) == Values({0, 0, 0, 0, -1, -3}));
  motions.add_unconstrained_stiffness(f, right);
  CHECK(f.linfty_norm() < 1e-14);
  motions.add_unconstrained_stiffness(f, left);
  CHECK(f.linfty_norm() < 1e-14);

  // Driven by forces along what is loose alone.
  CHECK(motions.loaded(points.vector({-1, -1, 0, 0, 0, 0}), 1e-3).empty());
  CHECK(motions.loaded(points.vector({0, 0, 0, 0, -1, 1}), 1e-3).empty());
  CHECK(motions.loaded(points.vector({0, 0, 0, 0, -1, 0}), 1e-3) ==
        std::vector<std::string>{"right"});

  // Pushed down by 1, z.r = -1/2, so that it moves by -1/4 a unit: 4 to the first contact, and one
  // more such step.
  LA::Vector u = points.contact.zero();
  CHECK(motions.move_into_contact(u, points.vector({0, 0, 0, 0, -1, 0})));
  CHECK(everywhere(u)[4] == doctest::Approx(-4.25));
  CHECK(everywhere(u)[5] == doctest::Approx(-4.25));
  CHECK(everywhere(u)[0] == 0);
  u = 0.;
  CHECK(!motions.move_into_contact(u, points.vector({0, 0, 0, 0, 1, 0})));
}



TEST_CASE("a loose motion is held where that takes little force")
{
  const Points       points({0, 0, 0, 0, 0, 0});
  const LA::Vector   stabilisation = points.vector({4, 4, 0, 0, 1, 3});
  UnconstrainedModes motions       = two_motions(points, stabilisation);
  motions.set_status(points.vector({1, 1, 0, 0, 0, 0}));
  // Contact pushes with 2 times 3 on what moves.
  const LA::Vector p = points.vector({0, 0, 0, 0, 3, 0});
  LA::Vector       r = points.vector({1, 1, 1, 1, 0.02, 0.02});
  CHECK(motions.project_out(r, {p}, {points.contact.zero()}) == doctest::Approx(0.04));
  CHECK(std::abs(everywhere(r)[4] + everywhere(r)[5]) < 1e-15);
  CHECK(everywhere(r)[0] == 1);
  r = points.vector({1, 1, 1, 1, 0.2, 0.2});
  CHECK(motions.project_out(r, {p}, {points.contact.zero()}) == 0);
  CHECK(everywhere(r)[4] == 0.2);
}
