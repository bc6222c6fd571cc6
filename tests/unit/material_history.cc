// SPDX-License-Identifier: Apache-2.0
// Constitutive laws with internal variables: strain measures, load steps, refinement, restarts.

#include "solid/deformation_kernel.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include "contact_cases.h"
#include "stepped_scene.h"

using namespace TestScene;

namespace
{
  /// Linear elasticity of the strain E = (C - 1)/2, and a spring k in series with a dashpot against
  /// changes of volume: with its strain a, an internal variable,
  ///
  ///   S = lambda tr E I + 2 mu E + k (tr E - a) I,   da/dt = (tr E - a)/tau,
  ///
  /// by backward Euler steps.
  class Relaxing : public ConstitutiveLaw
  {
  public:
    Relaxing(const Material &material, const double k, const double tau)
      : elastic(material.lambda(), material.mu())
      , k(k)
      , tau(tau)
    {}

    unsigned int
    n_internal() const override
    {
      return 1;
    }

    ConstitutiveResponse
    response(const ConstitutiveInput &in, const ResponseOrder wanted) const override
    {
      const double         trace_E = trace(in.C - unit_symmetric_tensor<3>()) / 2;
      const double         r       = in.duration / tau;
      const double         a       = (*in.internal + r * trace_E) / (1 + r);
      ConstitutiveResponse result  = elastic.at(in.C, wanted);
      result.stress += k * (trace_E - a) * unit_symmetric_tensor<3>();
      if (wanted == ResponseOrder::tangent)
        result.tangent +=
          k / (1 + r) * outer_product(unit_symmetric_tensor<3>(), unit_symmetric_tensor<3>());
      result.internal = {a};
      return result;
    }

  private:
    const SaintVenantKirchhoff elastic;
    const double               k, tau;
  };

  /// Two layers between walls that guide them, pressed together by 0.04 t.
  template <int dim>
  Lines
  column(const std::string &degree)
  {
    const bool plane = dim == 2;
    return materials("lower", "upper") + pair("upper.bottom", "lower.top") +
           Lines{"Dimension=" + std::to_string(dim),
                 "Mesh/Degree=" + degree,
                 "Contact pairs/pair/Slave choice=as named",
                 plane ? "Bodies/lower/Corners=0,0 : 1,1" : "Bodies/lower/Corners=0,0,0 : 1,1,1",
                 plane ? "Bodies/upper/Corners=0,1 : 1,2" : "Bodies/upper/Corners=0,0,1 : 1,1,2",
                 plane ? "Bodies/lower/Subdivisions=3,2" : "Bodies/lower/Subdivisions=2,3,1",
                 plane ? "Bodies/upper/Subdivisions=2,2" : "Bodies/upper/Subdivisions=3,2,1",
                 "Supports/Names=walls, base, head",
                 "Supports/walls/Type=symmetry",
                 std::string("Supports/walls/Boundaries=lower.left, lower.right, upper.left, "
                             "upper.right") +
                   (plane ? "" : ", lower.front, lower.back, upper.front, upper.back"),
                 "Supports/base/Boundaries=lower.bottom",
                 plane ? "Supports/base/Displacement=free; 0" :
                         "Supports/base/Displacement=free; free; 0",
                 "Supports/head/Boundaries=upper.top",
                 plane ? "Supports/head/Displacement=free; -0.04*t" :
                         "Supports/head/Displacement=free; free; -0.04*t"};
  }

  constexpr double k = 12, tau = 0.7;

  /// @param measure of the lower layer, which relaxes; the upper one is linear
  template <int dim>
  struct Column : public SteppedScene<dim>
  {
    using SteppedScene<dim>::scene, SteppedScene<dim>::state, SteppedScene<dim>::log,
      SteppedScene<dim>::equilibrium;

    Column(const StrainMeasure measure, const std::string &degree)
      : SteppedScene<dim>(column<dim>(degree))
      , measure(measure)
    {
      scene.scene.contact.geometry = ContactGeometry::reference;
      std::vector<Material> all    = scene.elasticity->all_materials();
      all[0].constitutive_law      = std::make_shared<Relaxing>(all[0], k, tau);
      all[0].strain_measure        = measure;
      moduli = {{all[0].lambda() + 2 * all[0].mu(), all[1].lambda() + 2 * all[1].mu()}};
      scene.elasticity =
        std::make_unique<Elasticity<dim>>(*scene.mesh,
                                          all,
                                          scene.scene.supports,
                                          scene.scene.loads,
                                          std::vector<unsigned int>{scene.elasticity->degree()},
                                          scene.elasticity->model());
      scene.elasticity->setup();
      CHECK(scene.elasticity->is_nonlinear());
      CHECK(scene.elasticity->is_finite_strain() == (measure == StrainMeasure::finite));
      scene.contact = std::make_unique<ContactInterfaces<dim>>(scene.decisions,
                                                               *scene.elasticity,
                                                               scene.timer,
                                                               scene.silence);
      this->start();
    }

    /// The first Piola-Kirchhoff stress along the column, at the stretch that is strain beyond 1.
    double
    lower_stress(const double strain, const double a, const double duration) const
    {
      const bool   is_finite_strain = measure == StrainMeasure::finite;
      const double E = is_finite_strain ? strain + strain * strain / 2 : strain, r = duration / tau;
      const double S = moduli[0] * E + k * (E - (a + r * E) / (1 + r));
      return is_finite_strain ? (1 + strain) * S : S;
    }

    /// The next load step of the exact solution, which ends at time t.
    void
    advance(const double t)
    {
      const double duration = t - time;
      // Strains of both layers add up to the approach, stresses are the same: by bisection.
      double low = -0.9, high = 0;
      for (unsigned int i = 0; i < 200; ++i)
        {
          const double strain = (low + high) / 2, other = -0.04 * t - strain;
          (lower_stress(strain, a, duration) < moduli[1] * other ? low : high) = strain;
        }
      pressure       = -moduli[1] * (-0.04 * t - low);
      const double E = measure == StrainMeasure::finite ? low + low * low / 2 : low,
                   r = duration / tau;
      a              = (a + r * E) / (1 + r);
      time           = t;
    }

    /// Is that the exact solution, and does each point remember what it has to?
    void
    check() const
    {
      CAPTURE(log.str());
      LA::Vector p = equilibrium->snapshot(0).pressure;
      p.add(-pressure);
      CHECK(pressure > 0.1);
      CHECK(p.linfty_norm() < 1e-7 * pressure);
      double off = 0;
      for (const auto &[id, variables] : state.material)
        for (const double value : variables.values)
          off = std::max(off, std::abs(value - a));
      CHECK(Utilities::MPI::max(off, MPI_COMM_WORLD) < 1e-8);
      CHECK(Utilities::MPI::sum(state.material.size(), MPI_COMM_WORLD) > 0);
    }

    const StrainMeasure   measure;
    std::array<double, 2> moduli;
    double                time = 0, a = 0, pressure = 0; ///< exact
  };

  template <int dim>
  void
  check_column(const StrainMeasure measure, const std::string &degree)
  {
    CAPTURE(dim);
    CAPTURE(degree);
    CAPTURE(measure == StrainMeasure::finite);
    Column<dim> column(measure, degree);
    REQUIRE(column.solve(1));
    column.advance(1);
    column.check();
    const State  first = column.state;
    const double a     = column.a;
    REQUIRE(column.solve(1.5));
    column.advance(1.5);
    column.check();

    // The step again, and again on finer meshes.
    REQUIRE(column.solve(1.5));
    column.check();
    column.refine_some();
    REQUIRE(column.solve(1.5));
    column.check();

    // Cut back: from the end of the first step by two shorter ones; and that state on one rank.
    for (const bool is_elsewhere : {false, true})
      {
        Column<dim> again(measure, degree);
        State       start = first;
        if (is_elsewhere)
          {
            start.material.clear();
            for (const CellVariables &part :
                 Utilities::MPI::gather(MPI_COMM_WORLD, first.material, 0))
              start.material.insert(part.begin(), part.end());
          }
        again.equilibrium->set_state(start, again.scene.elasticity->is_finite_strain());
        again.equilibrium->find_contact();
        again.equilibrium->configuration_solver.restore_active_set();
        again.time               = 1;
        again.a                  = a;
        unsigned int &most_steps = again.scene.scene.newton.maximum_steps;
        const auto    enough     = std::exchange(most_steps, 0);
        REQUIRE(!again.solve(1.5));
        most_steps = enough;
        again.equilibrium->find_contact();
        again.equilibrium->configuration_solver.restore_active_set();
        for (const double t : {1.25, 1.5})
          {
            REQUIRE(again.solve(t));
            again.advance(t);
            again.check();
            again.refine_some(); // between two steps
          }
      }
  }
} // namespace

TEST_CASE("a law that remembers: beside a linear one, at small and at any strain")
{
  for (const StrainMeasure measure : {StrainMeasure::small, StrainMeasure::finite})
    {
      check_column<2>(measure, "1");
      check_column<2>(measure, "2");
      check_column<3>(measure, "1");
    }
}



namespace
{
  /// Of degree k in each coordinate.
  template <int dim>
  double
  polynomial(const Point<dim> &x, const unsigned int k)
  {
    double result = 1;
    for (unsigned int d = 0; d < dim; ++d)
      result *= 0.7 + std::pow(x[d] - 0.3 * d, k);
    return result;
  }

  template <int dim>
  void
  check_transfer(const std::string &degree)
  {
    CAPTURE(dim);
    CAPTURE(degree);
    Column<dim>            column(StrainMeasure::small, degree);
    const Elasticity<dim> &elasticity = *column.scene.elasticity;
    const unsigned int     k          = elasticity.degree();
    const QGauss<dim>      rule(k + 1);
    const auto             values = [&](const auto &cell) {
      PointVariables result;
      result.points_per_line = k + 1;
      for (const Point<dim> &point : rule.get_points())
        result.values.push_back(
          polynomial<dim>(column.scene.mesh->mapping().transform_unit_to_real_cell(cell, point),
                          k));
      return result;
    };
    CellVariables before;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == 0)
        before[cell->id()] = values(cell);
    column.state.start.displacement = elasticity.zero_vector();
    for (const bool is_finer : {false, true})
      {
        if (is_finer)
          column.refine_some();
        MaterialHistory<dim> &history = column.scene.elasticity->material_history();
        const unsigned int    version = history.version();
        history.start(before, 0.1);
        CHECK(history.version() != version);
        double off = 0, off_between = 0;
        for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
          if (!cell->is_artificial() && cell->material_id() == 0)
            {
              const PointVariables expected = values(cell);
              for (unsigned int q = 0; q < rule.size(); ++q)
                off = std::max(off, std::abs(*history.at(*cell, q) - expected.values[q]));
              Point<dim> place;
              for (unsigned int d = 0; d < dim; ++d)
                place[d] = 0.2 + 0.5 * d;
              off_between =
                std::max(off_between,
                         std::abs(history.at(*cell, place)[0] -
                                  polynomial<dim>(column.scene.mesh->mapping()
                                                    .transform_unit_to_real_cell(cell, place),
                                                  k)));
            }
        CHECK(off < (is_finer ? 1e-12 : 1e-15));
        CHECK(off_between < 1e-12);
      }
  }
} // namespace

TEST_CASE("internal variables are carried over to finer cells as polynomials, and kept elsewhere")
{
  check_transfer<2>("1");
  check_transfer<2>("2");
  check_transfer<3>("1");
}
