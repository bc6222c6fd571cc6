// SPDX-License-Identifier: Apache-2.0
// Laws with tangential tractions and with a history, through all that acts on contact points.

#include "solver/contact_system.h"

#include <deal.II/base/mpi.h>

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include "contact_cases.h"
#include "stepped_scene.h"
#include "tangential_laws.h"

using namespace TestScene;

namespace
{
  using Kind = TangentialMethod::Kind;

  std::string
  text(const double x)
  {
    std::ostringstream stream;
    stream.precision(17);
    stream << x;
    return stream.str();
  }

  template <int dim>
  void
  use(SmallScene<dim>               &scene,
      std::shared_ptr<ContactMethod> method,
      const unsigned int             quadrature_points = 0)
  {
    ContactSettings settings;
    settings.quadrature_points = quadrature_points;
    settings.method            = "of the test";
    settings.methods.emplace_back(settings.method, std::move(method));
    settings.integration = Rule::segments;
    settings.geometry    = ContactGeometry::reference;
    scene.contact.reset();
    scene.scene.contact = settings;
    scene.contact       = std::make_unique<ContactInterfaces<dim>>(scene.decisions,
                                                             *scene.elasticity,
                                                             scene.timer,
                                                             scene.silence);
    scene.contact->build(Configuration<dim>(*scene.elasticity));
  }

  /// Numbers without any pattern, the same on any number of ranks.
  LA::Vector
  rough(const GapOperator &contact, const double seed)
  {
    LA::Vector result = contact.zero();
    for (const auto i : result.locally_owned_elements())
      result(i) = std::sin(seed + 2.1 * i * i);
    result.compress(VectorOperation::insert);
    return result;
  }

  InternalFields
  rough_variables(const ContactLaw &law)
  {
    InternalFields result = law.initial_fields();
    double         seed   = 0.4;
    for (PointVectors &variable : result.vectors)
      for (LA::Vector &component : variable)
        component = rough(law.gap_operator(), seed += 0.7);
    return result;
  }

  /// Gaps, stresses and tractions at (u, q), by the free degrees of freedom alone, which the system
  /// is about.
  struct Inputs
  {
    Inputs(const ContactSystem &system, const LA::BlockVector &x)
      : gaps(system.gap_operator().zeros())
      , stress(gaps)
      , traction(gaps)
    {
      const GapOperator &contact = system.gap_operator();
      for (unsigned int a = 0; a < contact.n_components(); ++a)
        {
          contact.free_rows(a).vmult(gaps[a], x.block(0));
          if (contact.has_stress())
            contact.S_free[a].vmult(stress[a], x.block(0));
          if (!system.is_saddle_point())
            continue;
          traction[a] = x.block(1 + a);
          traction[a].scale(contact.coefficients.stiffness);
        }
    }

    PointVectors gaps, stress, traction;
  };

  /// Forces and constraint residuals at (u, q): what ContactSystem is the derivative of, but for
  /// the sign.
  LA::BlockVector
  residual(const ContactLaw      &law,
           const ContactSystem   &system,
           const LA::BlockVector &x,
           const InternalFields  &internal,
           const LA::Vector      &status)
  {
    const GapOperator &contact = system.gap_operator();
    LA::BlockVector    result  = system.zero();
    const Inputs       at(system, x);
    const LawInputs    in{at.gaps, at.stress, at.traction, internal};
    result.block(0) = contact.force(law.traction(in, status), at.stress);
    if (system.is_saddle_point())
      {
        // Tractions of open points are zero: their rows are W k q = 0.
        PointVectors r = law.residual(in, status);
        for (unsigned int a = 0; a < r.size(); ++a)
          {
            for (const auto i : status.locally_owned_elements())
              if (!is_closed(status(i)))
                r[a](i) = contact.weight(i) * at.traction[a](i);
            r[a].compress(VectorOperation::insert);
            result.block(1 + a) = r[a];
          }
      }
    return result;
  }

  template <int dim>
  void
  check_tangent(const Case &which, const std::string &degree, const Sampling sampling)
  {
    SmallScene<dim> scene(which.lines +
                          Lines{"Dimension=" + std::to_string(dim), "Mesh/Degree=" + degree});
    for (const Kind kind : {Kind::springs, Kind::drag, Kind::drag_multiplier})
      {
        CAPTURE(which.name);
        CAPTURE(degree);
        CAPTURE(kind);
        use(scene, std::make_shared<TangentialMethod>(kind, sampling, 30., 0.4));
        const auto               law = scene.method().make_law(scene.gap_operator());
        const AssembledStiffness K(scene.elasticity->stiffness());
        ContactSystem            system(K, *law, scene.unconstrained_modes());
        CHECK(law->n_components() == dim);
        CHECK(system.is_saddle_point() == (kind == Kind::drag_multiplier));
        CHECK(system.is_symmetric() == (kind == Kind::springs));
        const InternalFields internal = rough_variables(*law);
        LA::Vector           status   = scene.gap_operator().zero();
        status                        = static_cast<double>(ContactStatus::stick);

        LA::BlockVector x = system.zero(), dx = x, change = x;
        x.block(0)  = scene.rough_field(0.01, 0.3);
        dx.block(0) = scene.rough_field(0.01, 1.7);
        for (unsigned int a = 0; a < dim && system.is_saddle_point(); ++a)
          {
            x.block(1 + a)  = rough(scene.gap_operator(), 0.2 + a);
            dx.block(1 + a) = rough(scene.gap_operator(), 1.2 + a);
          }
        LA::BlockVector after = x;
        after += dx;
        const LA::BlockVector before     = residual(*law, system, x, internal, status);
        LA::BlockVector       difference = residual(*law, system, after, internal, status);
        difference -= before;
        const PointVectors none = scene.gap_operator().zeros();
        system.linearise({none, none, none, internal}, status);
        system.contact_terms(change, dx);
        CHECK(difference.l2_norm() > 0);
        difference += change; // the laws are linear: no error of a difference quotient
        CHECK(difference.l2_norm() < 1e-11 * change.l2_norm());

        // The transposed matrix: y.A x = x.A^T y.
        if (kind == Kind::springs)
          continue;
        LA::BlockVector other = change;
        system.transpose(true);
        REQUIRE(system.is_transposed());
        system.contact_terms(other, x);
        system.transpose(false);
        CHECK(std::abs(x * change - dx * other) < 1e-11 * x.l2_norm() * change.l2_norm());
      }
  }
} // namespace

namespace
{
  /// The tangent of Coulomb friction, of all methods, where open, sticking and slipping points are
  /// next to each other.
  template <int dim>
  void
  check_friction_tangent(const Case &which, const std::string &degree)
  {
    CAPTURE(which.name);
    CAPTURE(degree);
    SmallScene<dim> scene(which.lines + Lines{"Dimension=" + std::to_string(dim),
                                              "Mesh/Degree=" + degree,
                                              "Contact pairs/pair/Friction=0.4"});
    for (const Lines &method : all_methods())
      {
        if (method[0] == "Method=direct elimination" && which.name != "flat, matching")
          continue;
        std::string name;
        for (const std::string &line : method)
          name += line + "; ";
        CAPTURE(name);
        scene.use(method + Lines{"Contact geometry=reference"});
        const GapOperator &contact = scene.gap_operator();
        const auto         law     = scene.method().make_law(contact);
        REQUIRE(law->n_components() == dim);
        const InternalFields internal = rough_variables(*law);
        scene.contact->set_time(1, internal);
        const AssembledStiffness K(scene.elasticity->stiffness());
        ContactSystem            system(K, *law, scene.unconstrained_modes());
        LA::BlockVector          x = system.zero(), dx = x, change = x;
        x.block(0)  = scene.rough_field(0.01, 0.3);
        dx.block(0) = scene.rough_field(0.01, 1.7);
        for (unsigned int a = 0; a < dim && system.is_saddle_point(); ++a)
          {
            x.block(1 + a)  = rough(contact, 0.2 + a);
            dx.block(1 + a) = rough(contact, 1.2 + a);
          }
        LA::Vector status = contact.zero();
        for (const auto i : status.locally_owned_elements())
          status(i) = static_cast<double>(std::array<ContactStatus, 3>{
            {ContactStatus::open, ContactStatus::stick, ContactStatus::slip}}[i % 3]);
        status.compress(VectorOperation::insert);
        const Inputs at(system, x);
        system.linearise({at.gaps, at.stress, at.traction, internal}, status);
        system.contact_terms(change, dx);

        constexpr double step  = 1e-6;
        LA::BlockVector  right = x, left = x;
        right.add(step, dx);
        left.add(-step, dx);
        LA::BlockVector difference = residual(*law, system, right, internal, status);
        difference -= residual(*law, system, left, internal, status);
        difference /= 2 * step;
        CHECK(difference.l2_norm() > 0);
        difference += change;
        CHECK(difference.l2_norm() < 1e-6 * change.l2_norm());

        LA::BlockVector other = change;
        system.transpose(true);
        system.contact_terms(other, x);
        CHECK(std::abs(x * change - dx * other) < 1e-11 * x.l2_norm() * change.l2_norm());
      }
  }
} // namespace

TEST_CASE("tangents of Coulomb friction against finite differences, for all methods")
{
  for (const unsigned int i : {0, 1, 2, 3})
    for (const std::string degree : {"1", "2"})
      check_friction_tangent<2>(cases_2d()[i], degree);
  for (const unsigned int i : {0, 1})
    check_friction_tangent<3>(cases_3d()[i], "1");
}



TEST_CASE("tangents of laws with slip: curved, hanging, tied to supports, at nodes and points")
{
  for (const unsigned int i : {0, 1, 2, 3, 6})
    for (const std::string degree : {"1", "2"})
      for (const Sampling sampling : {Sampling::nodes, Sampling::quadrature_points})
        check_tangent<2>(cases_2d()[i], degree, sampling);
  for (const unsigned int i : {1, 2, 3})
    {
      check_tangent<3>(cases_3d()[i], "1", Sampling::quadrature_points);
      check_tangent<3>(cases_3d()[i], i == 1 ? "2" : "1", Sampling::nodes);
    }
}



namespace
{
  /// The slip of a motion, at all points, in the directions of space: by the tangents at rest.
  template <int dim>
  std::vector<LA::Vector>
  slip_in_space(const GapOperator &contact, const LA::Vector &u)
  {
    const PointVectors      gaps = contact.gaps(u);
    std::vector<LA::Vector> result(dim, contact.zero());
    for (unsigned int a = 0; a < dim - 1; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        {
          LA::Vector part = gaps[a + 1];
          part.scale(contact.tangential.at_rest[a][d]);
          result[d] += part;
        }
    return result;
  }

  /// Points at slave nodes that supports hold, whose rows may have no slip across a plane of
  /// symmetry: 1, else 0.
  template <int dim>
  LA::Vector
  held_points(const SmallScene<dim> &scene)
  {
    LA::Vector result = scene.gap_operator().zero();
    auto       node   = scene.gap_operator().origin.node.begin();
    if (!scene.gap_operator().origin.node.empty())
      for (const auto i : result.locally_owned_elements())
        result(i) = scene.elasticity->constrained_nodes().count(*node++);
    result.compress(VectorOperation::insert);
    return result;
  }

  template <int dim>
  void
  check_kinematics(const Case &which, const Sampling sampling)
  {
    CAPTURE(which.name);
    SmallScene<dim> scene(which.lines + Lines{"Dimension=" + std::to_string(dim)});
    use(scene, std::make_shared<TangentialMethod>(Kind::springs, sampling, 30., 0.4));
    const GapOperator &contact = scene.gap_operator();
    // The slave is moved as a whole: the slip is what is across the normal.
    Tensor<1, dim> motion;
    for (unsigned int d = 0; d < dim; ++d)
      motion[d] = 0.3 - 0.2 * d;
    const std::string &name  = scene.decisions.pairs[0].slave;
    unsigned int       slave = 0;
    while (name.find(scene.scene.bodies[slave].name + ".") != 0)
      ++slave;
    const LA::Vector u    = interpolant<dim>(scene, [&](const auto &, const auto body) {
      return body == slave ? motion : Tensor<1, dim>();
    });
    const auto       slip = slip_in_space<dim>(contact, u);
    const LA::Vector gap = contact.gap(u), rest = contact.initial_gap;
    const LA::Vector held     = held_points(scene);
    double           slip_off = 0, gap_off = 0;
    for (const auto i : gap.locally_owned_elements())
      {
        if (held(i) > 0)
          continue;
        Tensor<1, dim> n, s;
        for (unsigned int d = 0; d < dim; ++d)
          {
            n[d] = contact.geometry.normal[d](i);
            s[d] = slip[d](i);
          }
        // On flat surfaces to rounding; on curved ones normals are means over faces.
        const Tensor<1, dim> expected = motion - (motion * n) / n.norm_square() * n;
        slip_off                      = std::max(slip_off, (s - expected).norm());
        gap_off                       = std::max(gap_off, std::abs(gap(i) - rest(i) - motion * n));
      }
    const bool is_flat = which.name.find("curved") == std::string::npos;
    CHECK(slip_off < (is_flat ? 1e-12 : 0.15));
    CHECK(gap_off < 1e-12);
    // Of both bodies together there is none, and tractions are in balance.
    const LA::Vector all = interpolant<dim>(scene, [&](const auto &, auto) { return motion; });
    for (const LA::Vector &component : slip_in_space<dim>(contact, all))
      CHECK(component.linfty_norm() < 1e-12);
    PointVectors traction;
    for (unsigned int a = 0; a < dim; ++a)
      traction.push_back(rough(contact, 0.3 + a));
    const LA::Vector force = contact.total_force(traction, contact.zeros());
    CHECK(std::abs(force * all) < 1e-12 * force.l1_norm());
  }
} // namespace

TEST_CASE("slip is the motion across the normal; rigid motions have none, tractions are in balance")
{
  for (const Sampling sampling : {Sampling::nodes, Sampling::quadrature_points})
    {
      for (const unsigned int i : {0, 1, 2})
        check_kinematics<2>(cases_2d()[i], sampling);
      for (const unsigned int i : {0, 1, 2})
        check_kinematics<3>(cases_3d()[i], sampling);
    }
}



namespace
{
  constexpr double pressure = 0.2;

  /// Two layers of which the upper one is pressed onto the lower one, and moved along it by
  /// `motion` times t; shear stresses `shear` times max(0, t - start) act at the sides, so that
  /// strains are the same everywhere in a layer.
  /// @param jump of the displacement between them, an expression in t a component
  template <int dim>
  Lines
  layers(const std::array<double, dim - 1>  &shear,
         const std::string                  &of_time,
         const std::array<std::string, dim> &jump)
  {
    const double E[2] = {10, 20}, nu[2] = {0.3, 0.2};
    const char  *names[2] = {"lower", "upper"};
    Lines        lines =
      materials("lower", "upper") + pair("upper.bottom", "lower.top") +
      Lines{"Dimension=" + std::to_string(dim),
            "Contact pairs/pair/Search distance=0.5",
            "Contact pairs/pair/Slave choice=as named",
            "Bodies/lower/Corners=" + std::string(dim == 2 ? "0,0 : 1,1" : "0,0,0 : 1,1,1"),
            "Bodies/upper/Corners=" + std::string(dim == 2 ? "0,1 : 1,2" : "0,0,1 : 1,1,2"),
            "Bodies/lower/Subdivisions=" + std::string(dim == 2 ? "3,2" : "2,3,1"),
            "Bodies/upper/Subdivisions=" + std::string(dim == 2 ? "2,2" : "3,2,1"),
            "Supports/Names=base, head",
            "Supports/base/Boundaries=lower.bottom",
            "Supports/head/Boundaries=upper.top"};
    std::string base, head;
    double      approach   = 0; // by the strains
    double      compliance = 0;
    for (unsigned int k = 0; k < 2; ++k)
      {
        approach += pressure * (1 + nu[k]) * (1 - 2 * nu[k]) / (E[k] * (1 - nu[k]));
        compliance += 2 * (1 + nu[k]) / E[k];
      }
    for (unsigned int d = 0; d < dim; ++d)
      {
        base += (d > 0 ? "; 0" : "0");
        head += (d > 0 ? "; " : "");
        head += d + 1 < dim ? jump[d] + " + " + text(shear[d] * compliance) + "*" + of_time :
                              jump[d] + " - " + text(approach);
      }
    lines =
      lines + Lines{"Supports/base/Displacement=" + base, "Supports/head/Displacement=" + head};
    std::string loads;
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int d = 0; d + 1 < dim; ++d)
        for (const bool high : {false, true})
          {
            const std::string side = d == 0 ? (high ? "right" : "left") : (high ? "back" : "front"),
                              name = std::string(names[k]) + side;
            loads += (loads.empty() ? "" : ", ") + name;
            const double sign = high ? 1 : -1;
            std::string  traction;
            for (unsigned int e = 0; e < dim; ++e)
              {
                traction += e > 0 ? "; " : "";
                traction += e == d       ? text(-sign * pressure * nu[k] / (1 - nu[k])) :
                            e + 1 == dim ? text(sign * shear[d]) + "*" + of_time :
                                           "0";
              }
            lines = lines + Lines{"Loads/" + name + "/Boundaries=" + names[k] + "." + side,
                                  "Loads/" + name + "/Traction=" + traction};
          }
    return lines + Lines{"Loads/Names=" + loads};
  }

  /// The tractions in the directions of space along the surface, the mean and how far any is off.
  template <int dim>
  std::pair<Tensor<1, dim>, double>
  tractions(const GapOperator &contact, const PointVectors &traction)
  {
    Tensor<1, dim>          mean;
    std::vector<LA::Vector> all;
    for (unsigned int d = 0; d < dim; ++d)
      {
        LA::Vector sum = contact.zero();
        for (unsigned int a = 0; a < dim - 1; ++a)
          {
            LA::Vector part = traction[a + 1];
            part.scale(contact.tangential.at_rest[a][d]);
            sum += part;
          }
        mean[d] = (sum * contact.weight) / contact.weight.l1_norm();
        all.push_back(sum);
      }
    double off = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        all[d].add(-mean[d]);
        off = std::max(off, double(all[d].linfty_norm()));
      }
    return {mean, off};
  }

  template <int dim>
  void
  check_patch(const std::string &preconditioner, const std::string &degree, const Sampling sampling)
  {
    CAPTURE(dim);
    CAPTURE(preconditioner);
    CAPTURE(degree);
    constexpr double             normal = 40, tangential = 15;
    std::array<double, dim - 1>  shear;
    std::array<std::string, dim> jump;
    for (unsigned int d = 0; d + 1 < dim; ++d)
      {
        shear[d] = 0.05 + 0.07 * d;
        jump[d]  = text(shear[d] / tangential);
      }
    jump[dim - 1] = text(-pressure / normal);
    SteppedScene<dim> steps(
      layers<dim>(shear, "1", jump) +
      Lines{"Mesh/Degree=" + degree, "Solver/Preconditioner=" + preconditioner});
    use(steps.scene,
        std::make_shared<TangentialMethod>(Kind::springs, sampling, normal, tangential));
    steps.start();
    const bool is_solved = steps.solve(1);
    CAPTURE(steps.log.str());
    REQUIRE(is_solved);
    const Snapshot<dim> solution = steps.equilibrium->snapshot(0);
    // The slave is above: its traction is against its slip.
    const auto [mean, off] =
      tractions<dim>(steps.scene.gap_operator(), solution.contact_state.traction);
    for (unsigned int d = 0; d + 1 < dim; ++d)
      CHECK(mean[d] == doctest::Approx(-shear[d]).epsilon(1e-8));
    CHECK(off < 1e-8);
    LA::Vector p = solution.pressure;
    p.add(-pressure);
    CHECK(p.linfty_norm() < 1e-8);
  }
} // namespace

TEST_CASE("a patch with tangential springs, by all that solves linear systems")
{
  for (const Sampling sampling : {Sampling::nodes, Sampling::quadrature_points})
    {
      for (const char *preconditioner : {"interface multigrid", "direct"})
        for (const char *degree : {"1", "2"})
          check_patch<2>(preconditioner, degree, sampling);
      check_patch<3>("interface multigrid", "1", sampling);
    }
}



namespace
{
  /// Two load steps of the layers: in the first one the upper one is pressed and moved, without
  /// friction; in the second one it is dragged along what was the slip of the first.
  template <int dim>
  struct Dragged : public SteppedScene<dim>
  {
    using SteppedScene<dim>::scene, SteppedScene<dim>::log, SteppedScene<dim>::equilibrium;

    static constexpr double normal = 40, friction = 0.3;

    Dragged(const Kind kind, const Sampling sampling, const std::string &degree)
      : SteppedScene<dim>(layers<dim>(shear(), "max(0, t - 1)", jump(kind)) +
                          Lines{"Mesh/Degree=" + degree})
    {
      use(scene, std::make_shared<TangentialMethod>(kind, sampling, normal, friction));
      this->start();
    }

    /// Tractions of the second step, -friction times the pressure along the slip of the first one.
    static std::array<double, dim - 1>
    shear()
    {
      std::array<double, dim - 1> result;
      double                      square = 0;
      for (unsigned int d = 0; d + 1 < dim; ++d)
        square += speed(d) * speed(d);
      for (unsigned int d = 0; d + 1 < dim; ++d)
        result[d] = friction * pressure * speed(d) / std::sqrt(square);
      return result;
    }

    static double
    speed(const unsigned int d)
    {
      return 0.01 - 0.025 * d;
    }

    static std::array<std::string, dim>
    jump(const Kind kind)
    {
      std::array<std::string, dim> result;
      for (unsigned int d = 0; d + 1 < dim; ++d)
        result[d] = text(speed(d)) + "*t";
      result[dim - 1] = kind == Kind::drag_multiplier ? "0" : text(-pressure / normal);
      return result;
    }

    /// Is that the solution at time 1 + share?
    void
    check(const double share) const
    {
      CAPTURE(log.str());
      const Snapshot<dim> solution = equilibrium->snapshot(0);
      const auto [mean, off] =
        tractions<dim>(scene.gap_operator(), solution.contact_state.traction);
      for (unsigned int d = 0; d + 1 < dim; ++d)
        CHECK(mean[d] == doctest::Approx(-share * shear()[d]).epsilon(1e-7));
      CHECK(off < 1e-7);
      LA::Vector p = solution.pressure;
      p.add(-pressure);
      CHECK(p.linfty_norm() < 1e-7);
    }
  };

  /// Everything that is known of contact, on one rank alone.
  SurfaceField
  on_one_rank(const SurfaceField &field, const unsigned int dim)
  {
    using Entry = std::pair<FaceId, std::vector<SurfacePointValue>>;
    std::vector<Entry> own(field.values().begin(), field.values().end());
    const auto         all = Utilities::MPI::gather(MPI_COMM_WORLD, own, 0);
    SurfaceField       result(dim);
    for (const auto &part : all)
      for (const auto &[face, values] : part)
        result.set(face, values);
    return result;
  }

  template <int dim>
  void
  check_history(const Kind kind, const Sampling sampling, const std::string &degree)
  {
    CAPTURE(dim);
    CAPTURE(kind);
    CAPTURE(degree);
    Dragged<dim> dragged(kind, sampling, degree);
    const bool   is_solved = dragged.solve(1);
    CAPTURE(dragged.log.str());
    REQUIRE(is_solved);
    dragged.check(0); // no slip before
    const State first = dragged.state;
    REQUIRE(dragged.solve(2));
    dragged.check(1);
    const auto scalars = [&](const State &state) { // the last number of the history of places
      std::pair<double, double> range(1e100, -1e100);
      for (const auto &[face, values] : state.contact.values())
        for (const SurfacePointValue &value : values)
          {
            range.first  = std::min(range.first, value.history.back());
            range.second = std::max(range.second, value.history.back());
          }
      return std::make_pair(Utilities::MPI::min(range.first, MPI_COMM_WORLD),
                            Utilities::MPI::max(range.second, MPI_COMM_WORLD));
    };
    CHECK(scalars(first) == std::make_pair(1., 1.));
    CHECK(scalars(dragged.state) == std::make_pair(2., 2.));

    // The step that led there again, and then on finer meshes: not one step more.
    REQUIRE(dragged.solve(2));
    dragged.check(1);
    CHECK(scalars(dragged.state) == std::make_pair(2., 2.));
    dragged.refine_some();
    REQUIRE(dragged.solve(2));
    dragged.check(1);
    const auto [least, most] = scalars(dragged.state);
    CHECK(least == doctest::Approx(2));
    CHECK(most == doctest::Approx(2));

    // Cut back to the end of the first step, which half a step leaves with half of the traction;
    // and a restart with other ranks than before.
    Dragged<dim> again(kind, sampling, degree);
    again.equilibrium->set_state(first, false);
    again.equilibrium->configuration_solver.restore_active_set();
    unsigned int &most_steps = again.scene.scene.newton.maximum_steps;
    const auto    enough     = std::exchange(most_steps, 0);
    REQUIRE(!again.solve(2));
    most_steps = enough;
    again.equilibrium->find_contact(); // and a solver that knows of it
    again.equilibrium->configuration_solver.restore_active_set();
    REQUIRE(again.solve(2));
    again.check(1);
    State elsewhere   = first;
    elsewhere.contact = on_one_rank(first.contact, dim);
    again.equilibrium->set_state(elsewhere, false);
    again.equilibrium->configuration_solver.restore_active_set();
    REQUIRE(again.solve(2));
    again.check(1);

    // Refined between two steps.
    again.equilibrium->set_state(elsewhere, false);
    again.refine_some();
    REQUIRE(again.solve(2));
    again.check(1);
  }
} // namespace

TEST_CASE("a law that remembers: load steps, refinement, cut-backs, restarts elsewhere")
{
  for (const Kind kind : {Kind::drag, Kind::drag_multiplier})
    for (const Sampling sampling : {Sampling::nodes, Sampling::quadrature_points})
      if (kind == Kind::drag || sampling == Sampling::nodes) // unknowns at points are too many
        {
          check_history<2>(kind, sampling, "1");
          check_history<2>(kind, sampling, "2");
          check_history<3>(kind, sampling, "1");
        }
}



namespace
{
  /// A scene whose surfaces are as they come, and may move.
  template <int dim>
  std::unique_ptr<SmallScene<dim>>
  moving_scene(const Case        &which,
               const Sampling     sampling,
               const std::string &degree            = "1",
               const unsigned int quadrature_points = 0)
  {
    auto scene = std::make_unique<SmallScene<dim>>(
      which.lines + Lines{"Dimension=" + std::to_string(dim),
                          "Mesh/Degree=" + degree,
                          "Contact pairs/pair/Initial gap=from geometry"});
    use(*scene,
        std::make_shared<TangentialMethod>(Kind::springs, sampling, 30., 0.4),
        quadrature_points);
    return scene;
  }

  /// The forces of given tractions: their change is that of the geometric stiffness.
  /// @param keeps_integration_points those of integration; else segments end where the master's
  /// faces do
  template <int dim>
  void
  check_geometric_stiffness(const Case    &which,
                            const Sampling sampling,
                            const bool     keeps_integration_points)
  {
    CAPTURE(which.name);
    CAPTURE(keeps_integration_points);
    // Where the parts of faces change, points enough for the error of integration to change little.
    const auto scene = moving_scene<dim>(which, sampling, "1", keeps_integration_points ? 0 : 3);
    const Elasticity<dim> &elasticity = *scene->elasticity;
    constexpr double       step       = 1e-6;
    LA::Vector             u          = scene->rough_field(0.002, 0.3);
    const LA::Vector       v          = scene->rough_field(1, 1.1);
    elasticity.distribute(u);
    const auto tractions_at_points = [&] {
      PointVectors result   = scene->gap_operator().zeros();
      result[0]             = 0.4;
      const LA::Vector held = held_points(*scene);
      for (unsigned int a = 1; a < dim; ++a)
        {
          for (const auto i : held.locally_owned_elements())
            result[a](i) = held(i) > 0 ? 0. : 2.3 - 1.9 * a;
          result[a].compress(VectorOperation::insert);
        }
      return result;
    };
    const auto force_at = [&](const double a) {
      LA::Vector there = u;
      there.add(a, v);
      elasticity.distribute(there);
      scene->contact->build(Configuration<dim>(elasticity, there, u),
                            false,
                            keeps_integration_points);
      return scene->gap_operator().force(tractions_at_points(), scene->gap_operator().zeros());
    };
    scene->contact->build(Configuration<dim>(elasticity, u));
    LA::Vector expected = force_at(0);
    expected            = 0.;
    scene->contact->build_geometric_stiffness(tractions_at_points());
    scene->gap_operator().subtract_geometric(expected, v);
    expected *= -1;
    LA::Vector difference = force_at(step);
    difference -= force_at(-step);
    difference /= 2 * step;
    const double size = difference.l2_norm();
    difference -= expected;
    CHECK(size > 0);
    CHECK(difference.l2_norm() < (keeps_integration_points ? 1e-3 : 4e-3) * size);
  }
} // namespace

TEST_CASE("the forces of tangential tractions change with the surfaces as the stiffness says")
{
  const Case in_2d{"within the master", boxes("0,0 : 1,1", "7,1", "0.17,1 : 0.83,2", "4,1")},
    in_3d{"within the master",
          boxes("0,0,0 : 1,1,1", "5,4,1", "0.17,0.15,1 : 0.83,0.81,2", "3,2,1")};
  for (const Sampling sampling : {Sampling::nodes, Sampling::quadrature_points})
    {
      check_geometric_stiffness<2>(cases_2d()[1], sampling, true);
      check_geometric_stiffness<2>(cases_2d()[3], sampling, true); // inclined supports
    }
  check_geometric_stiffness<3>(cases_3d()[1], Sampling::nodes, true);
  check_geometric_stiffness<2>(in_2d, Sampling::nodes, false);
  check_geometric_stiffness<3>(in_3d, Sampling::nodes, false);
}



namespace
{
  /// x + u(x) turned about an axis that is none of the frame's.
  template <int dim>
  Tensor<2, dim>
  rotation(const double angle)
  {
    Tensor<2, dim> result = unit_symmetric_tensor<dim>();
    if constexpr (dim == 2)
      {
        result[0][0] = result[1][1] = std::cos(angle);
        result[1][0]                = std::sin(angle);
        result[0][1]                = -result[1][0];
      }
    else
      {
        // Rodrigues
        const Tensor<1, 3> axis({2. / 7, 3. / 7, 6. / 7});
        for (unsigned int j = 0; j < 3; ++j)
          {
            Tensor<1, 3> e;
            e[j]                 = 1;
            const Tensor<1, 3> r = std::cos(angle) * e +
                                   std::sin(angle) * cross_product_3d(axis, e) +
                                   (1 - std::cos(angle)) * (axis * e) * axis;
            for (unsigned int i = 0; i < 3; ++i)
              result[i][j] = r[i];
          }
      }
    return result;
  }

  /// Slip of surfaces that move from u to R (x + u + c) - x, c on the slave alone.
  template <int dim>
  void
  check_rotated_slip(const Case &which, const std::string &degree, const Sampling sampling)
  {
    CAPTURE(which.name);
    CAPTURE(degree);
    const auto             scene      = moving_scene<dim>(which, sampling, degree);
    const Elasticity<dim> &elasticity = *scene->elasticity;
    const std::string     &name       = scene->decisions.pairs[0].slave;
    unsigned int           slave      = 0;
    while (name.find(scene->scene.bodies[slave].name + ".") != 0)
      ++slave;
    const bool     is_flat = which.name.find("curved") == std::string::npos;
    Tensor<1, dim> along; // across the normal where that is the last axis
    for (unsigned int d = 0; d + 1 < dim && is_flat; ++d)
      along[d] = 0.01 - 0.03 * d;
    const LA::Vector start = is_flat ? elasticity.zero_vector() : scene->rough_field(0.002, 0.3);
    const LA::Vector rest =
      interpolant<dim>(*scene, [](const auto &x, auto) { return Tensor<1, dim>(x); });
    for (const double angle : {0.3, 2.})
      {
        CAPTURE(angle);
        const Tensor<2, dim> R     = rotation<dim>(angle);
        const LA::Vector     moved = interpolant<dim>(*scene, [&](const auto &x, const auto body) {
          return R * (x + (body == slave ? along : Tensor<1, dim>())) - x;
        });
        // R u of the start, node by node: all components of a node follow each other.
        LA::Vector now   = moved;
        const auto owned = start.locally_owned_elements();
        for (auto i = owned.begin(); i != owned.end();)
          {
            Tensor<1, dim> u;
            const auto     first = *i;
            for (unsigned int d = 0; d < dim; ++d, ++i)
              u[d] = start(first + d);
            const Tensor<1, dim> turned = R * u;
            for (unsigned int d = 0; d < dim; ++d)
              now(first + d) = now(first + d) + turned[d];
          }
        now.compress(VectorOperation::insert);
        Configuration<dim> configuration(elasticity, now);
        configuration.set_start(start);
        scene->contact->build(configuration);
        const auto slip = slip_in_space<dim>(scene->gap_operator(), now);
        CHECK(scene->gap_operator().weight.size() > 0);
        for (unsigned int d = 0; d < dim; ++d)
          {
            LA::Vector off = slip[d];
            off.add(-along[d]);
            CHECK(off.linfty_norm() < 1e-11);
          }
      }
  }
} // namespace

TEST_CASE("slip of surfaces that turn: that of the slave alone, by the frame at rest")
{
  for (const Sampling sampling : {Sampling::nodes, Sampling::quadrature_points})
    {
      for (const char *degree : {"1", "2"})
        {
          check_rotated_slip<2>(cases_2d()[0], degree, sampling);
          check_rotated_slip<2>(cases_2d()[1], degree, sampling);
        }
      check_rotated_slip<3>(cases_3d()[0], "2", sampling);
      check_rotated_slip<3>(cases_3d()[1], "1", sampling);
    }
}
