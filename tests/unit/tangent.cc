// SPDX-License-Identifier: Apache-2.0
// The residual and the linearised systems of all methods, in all their forms, against the weak
// forms once more from their definitions.
//
// Away from where points open or close the law is linear, so that differences of the residual are
// exact up to rounding, whatever the step: half of the distance to the first point that changes,
// and an eighth of that.

#include "contact/laws/normal_contact.h"
#include "solver/contact_system.h"

#include <doctest/doctest.h>

#include <cmath>

#include "contact_cases.h"
#include "reference.h"

using namespace TestScene;

namespace
{
  /// The law of a method at displacement u, from its definition.
  struct Law
  {
    Values gap, stress, predicted, argument, pressure;
  };

  template <int dim>
  Law
  law(const SmallScene<dim>       &scene,
      const ReferenceContact<dim> &reference,
      const Values                &u,
      const Values                &given)
  {
    Law result{reference.gap(u), reference.stress(u), given, {}, {}};
    if (scene.method().pressure_shift() == PressureShift::normal_stress)
      result.predicted = result.stress;
    if (scene.method().pressure_shift() == PressureShift::none)
      result.predicted.assign(given.size(), 0.);
    result.argument = result.predicted;
    for (unsigned int i = 0; i < given.size(); ++i)
      result.argument[i] -= reference.epsilon[i] * result.gap[i];
    return result;
  }

  /// As far as one may go from u along du before any point changes, and as far as it goes at all.
  double
  first_change(const Law &at_start, const Law &at_end)
  {
    double first = 1;
    for (unsigned int i = 0; i < at_start.argument.size(); ++i)
      if (const double change = at_end.argument[i] - at_start.argument[i]; change != 0)
        if (const double a = -at_start.argument[i] / change; a > 0)
          first = std::min(first, a);
    return first;
  }

  /// Largest entry.
  double
  size_of(const Values &v)
  {
    double largest = 0;
    for (const double x : v)
      largest = std::max(largest, std::abs(x));
    return largest;
  }

  /// What the tests of a scene share: a state, a direction and a virtual displacement, as the
  /// program holds them and with all constrained degrees of freedom.
  template <int dim>
  struct Sample
  {
    Sample(const SmallScene<dim> &scene)
      : u(scene.rough_field(0.004, 0.3))
      , du(scene.rough_field(0.004, 1.1))
      , w(scene.rough_field(1, 2.3))
      , all_u(distributed(*scene.elasticity, u))
      , all_du(distributed_change(*scene.elasticity, du))
      , all_w(distributed_change(*scene.elasticity, w))
    {
      scene.elasticity->distribute(u);
    }

    LA::Vector u, du, w;
    Values     all_u, all_du, all_w;
  };

  template <int dim>
  LA::Vector
  on_points(const SmallScene<dim> &scene, const double amplitude, const double seed)
  {
    LA::Vector v = scene.gap_operator().zero();
    for (const auto i : v.locally_owned_elements())
      v(i) = amplitude * (1 + std::sin(seed + 2.1 * i));
    v.compress(VectorOperation::insert);
    return v;
  }

  /// f - K u, with hanging nodes, supports in any direction, prescribed displacements and loads.
  template <int dim>
  void
  check_bodies(const SmallScene<dim> &scene, const Sample<dim> &state, const double t)
  {
    const Elasticity<dim> &elasticity = *scene.elasticity;
    LA::Vector             r = elasticity.zero_vector(), Ku = r;
    const Values           none(state.all_w.size(), 0.);
    elasticity.stiffness().vmult(Ku, state.u);
    if (elasticity.has_unsupported_modes())
      scene.unconstrained_modes().subtract_stabilisation(Ku, state.u);
    r = elasticity.load();
    r -= Ku;
    // What drives rigid bodies is no part of the mesh.
    double of_rigid_bodies = 0;
    for (unsigned int b = 0; b < elasticity.rigid_bodies().size(); ++b)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        of_rigid_bodies +=
          elasticity.rigid_bodies()[b].load(i, t, elasticity.rotation_length_scale()) *
          state.all_w[elasticity.first_dof(b) + i];
    const double work = of_rigid_bodies - reference_work(scene, state.all_u, state.all_w, t);
    // Rough displacements: the terms that cancel are about as large as K u times w.
    CHECK(std::abs(r * state.w - work) < 1e-12 * Ku.l2_norm() * state.w.l2_norm());
  }

  /// The condensed form: pressures follow from the displacement.
  template <int dim>
  void
  check_condensed(const SmallScene<dim>       &scene,
                  const ReferenceContact<dim> &reference,
                  const Sample<dim>           &state,
                  const LA::Vector            &predicted)
  {
    const GapOperator &contact  = scene.gap_operator();
    const Values       given    = everywhere(predicted);
    const auto         residual = [&](const double a) {
      Law result = law(scene, reference, sum(state.all_u, a, state.all_du), given);
      for (unsigned int i = 0; i < given.size(); ++i)
        {
          const bool always = scene.decisions.pairs[0].can_separate == false;
          result.pressure.push_back(always ? result.argument[i] : std::max(0., result.argument[i]));
        }
      return result;
    };
    const Law start = residual(0), end = residual(1);

    // The program's law and force.
    const LA::Vector gap = contact.gap(state.u), stress = contact.stress(state.u)[0];
    const LA::Vector none = contact.zero();
    NormalContact    contact_law(scene.method(), contact);
    contact_law.augment({predicted});
    const LawInputs  in{{gap}, {stress}, {none}, {}};
    const LA::Vector active     = contact_law.status(contact_law.trial(in)),
                     p          = contact_law.traction(in, active)[0];
    const unsigned int n_active = active.l1_norm() + 0.5;
    CHECK(size_of(sum(everywhere(p), -1, start.pressure)) < 1e-12 * size_of(start.pressure));
    if (scene.decisions.pairs[0].can_separate)
      {
        CHECK(n_active > 0);
        CHECK(n_active < start.gap.size());
      }
    const double work  = reference.work(start.pressure, start.stress, state.all_w);
    const auto   force = contact.force({p}, {stress});
    const double size  = force.l2_norm() * state.w.l2_norm();
    CHECK(std::abs(force * state.w + work) < 1e-13 * size);

    // Its derivative.
    const AssembledStiffness K(scene.elasticity->stiffness());
    ContactSystem            system(K, contact_law, scene.unconstrained_modes());
    LA::BlockVector direction = system.zero(), change = system.zero(), whole = system.zero();
    REQUIRE(!system.is_saddle_point());
    system.set_status(active);
    direction.block(0) = state.du;
    system.contact_terms(change, direction);
    const double derivative = change.block(0) * state.w;
    const double longest    = scene.decisions.pairs[0].can_separate ? first_change(start, end) : 1;
    for (const double step : {longest / 2, longest / 16})
      {
        const Law    next = residual(step);
        const double difference =
          (reference.work(next.pressure, next.stress, state.all_w) - work) / step;
        const double rounding = 1e-14 * size / step;
        CHECK(rounding < 1e-6 * std::abs(difference)); // or else this would check nothing
        CHECK(std::abs(derivative - difference) < rounding);
      }

    // Beside it, the whole system has the bodies alone.
    system.vmult(whole, direction);
    LA::Vector of_bodies = whole.block(0);
    system.internal_force(of_bodies, state.du);
    whole.block(0) -= of_bodies;
    change.block(0) -= whole.block(0);
    REQUIRE(system.unconstrained_modes().unconstrained().empty());
    CHECK(change.block(0).l2_norm() < 1e-12 * of_bodies.l2_norm());
  }

  /// The saddle point: the pressure is an unknown, and the law an equation for it.
  template <int dim>
  void
  check_saddle_point(const SmallScene<dim>       &scene,
                     const ReferenceContact<dim> &reference,
                     const Sample<dim>           &state,
                     const LA::Vector            &p)
  {
    const GapOperator &contact = scene.gap_operator();
    const Law          start   = law(scene, reference, state.all_u, everywhere(p)),
              end = law(scene, reference, sum(state.all_u, 1, state.all_du), everywhere(p));
    const NormalContact      contact_law(scene.method(), contact);
    const AssembledStiffness K(scene.elasticity->stiffness());
    ContactSystem            system(K, contact_law, scene.unconstrained_modes());
    REQUIRE(system.is_saddle_point());
    const LA::Vector gap = contact.gap(state.u), none = contact.zero();
    const LA::Vector active    = contact_law.status(contact_law.trial({{gap}, {none}, {p}, {}}));
    const Values     is_active = everywhere(active);
    for (unsigned int i = 0; i < is_active.size(); ++i)
      CHECK((is_active[i] > 0) ==
            (start.argument[i] > 0 || !scene.decisions.pairs[0].can_separate));
    system.set_status(active);

    LA::BlockVector direction = system.zero(), change = system.zero();
    direction.block(0) = state.du;
    direction.block(1) = on_points(scene, 1e-3, 0.7);
    system.contact_terms(change, direction);
    const Values q = everywhere(direction.block(1)), of_gap = everywhere(change.block(1));
    Values       dp(q.size(), 0.), defect(q.size());
    for (unsigned int i = 0; i < q.size(); ++i)
      {
        const double k = reference.stiffness[i], W = reference.area[i];
        const double change_of_gap = end.gap[i] - start.gap[i];
        const bool   compliant     = scene.method().pressure_shift() == PressureShift::none;
        if (is_active[i] > 0)
          dp[i] = k * q[i];
        defect[i] = is_active[i] > 0 ?
                      -k * W * (change_of_gap + (compliant ? dp[i] / reference.epsilon[i] : 0)) :
                      -k * W * q[i];
      }
    CHECK(size_of(sum(of_gap, -1, defect)) < 1e-12 * size_of(defect));
    const double work = reference.work(dp, dp, state.all_w);
    CHECK(std::abs(change.block(0) * state.w - work) <
          1e-13 * change.block(0).l2_norm() * state.w.l2_norm());
  }

  template <int dim>
  void
  check_all_methods(const Case &which, const std::string &degree)
  {
    const std::string name = which.name + ", degree " + degree;
    CAPTURE(name);
    SmallScene<dim> scene(which.lines +
                          Lines{"Dimension=" + std::to_string(dim), "Mesh/Degree=" + degree});
    scene.elasticity->set_time(2);
    const Sample<dim> state(scene);
    bool              first = true;
    for (const Lines &method : all_methods())
      {
        const std::string how = join(method);
        CAPTURE(how);
        scene.use(method);
        if (first)
          check_bodies(scene, state, 2);
        first = false;
        const ReferenceContact<dim> reference(scene);
        const Values                areas = everywhere(scene.gap_operator().weight);
        CHECK(size_of(sum(areas, -1, reference.area)) < 1e-13 * size_of(areas));
        const Values epsilon = everywhere(scene.gap_operator().coefficients.epsilon);
        CHECK(size_of(sum(epsilon, -1, reference.epsilon)) < 1e-13 * size_of(epsilon));
        const LA::Vector predicted = on_points(scene, 0.01, 0.2);
        if (scene.method().has_multipliers())
          check_saddle_point(scene, reference, state, predicted);
        else
          check_condensed(scene, reference, state, predicted);
      }
  }
} // namespace



TEST_CASE("residual and tangent of all methods in the plane")
{
  for (const Case &which : cases_2d())
    for (const std::string degree : {"1", "2"})
      check_all_methods<2>(which, degree);
}



TEST_CASE("residual and tangent of all methods in space")
{
  for (const Case &which : cases_3d())
    check_all_methods<3>(which, which.name[0] == 'f' || which.name[0] == 'i' ? "2" : "1");
}
