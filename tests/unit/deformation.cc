// SPDX-License-Identifier: Apache-2.0
// Bodies that deform by any amount: forces of cells, their tangents, small ones as a limit.

#include "base/solver_failure.h"
#include "materials/material_law.h"
#include "solid/deformation_kernel.h"
#include "solid/kernel.h"
#include "solid/pressure_kernel.h"
#include "solid/rigid_body_modes.h"
#include "solver/nonlinear_solid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "small_scene.h"

using namespace TestScene;

namespace
{
  template <int dim>
  Lines
  one_cell(const std::string &model, const unsigned int degree, const std::string &law)
  {
    const bool plane = dim == 2;
    return {"Dimension=" + std::to_string(dim),
            "Model=" + model,
            "Deformation=finite",
            "Bodies/Names=body",
            "Bodies/body/Mesh=box",
            plane ? "Bodies/body/Corners=1,0 : 2,1.5" : "Bodies/body/Corners=1,0,0 : 2,1.5,1.2",
            "Bodies/body/Law=" + law,
            law == "Mooney-Rivlin" ? "Bodies/body/Coefficients=1,0.3" :
                                     "Bodies/body/Young's modulus=3",
            "Bodies/body/Poisson's ratio=0.35",
            "Bodies/body/Degree=" + std::to_string(degree)};
  }

  template <int dim>
  struct OneCell
  {
    SmallScene<dim>        scene;
    DeformationKernel<dim> kernel;
    Vector<double>         u;

    OneCell(const std::string &model, const unsigned int degree, const std::string &law)
      : scene(one_cell<dim>(model, degree, law))
      , kernel(*scene.mesh, scene.elasticity->finite_elements(), scene.elasticity->model())
      , u(cell()->get_fe().n_dofs_per_cell())
    {
      for (unsigned int i = 0; i < u.size(); ++i)
        u(i) = 0.07 * std::sin(7. * i + 3);
    }

    typename DoFHandler<dim>::active_cell_iterator
    cell() const
    {
      return scene.elasticity->dof_handler().begin_active();
    }

    const Material &
    material() const
    {
      return scene.elasticity->material(0);
    }

    Vector<double>
    forces(const Vector<double> &at, FullMatrix<double> *tangent = nullptr)
    {
      Vector<double> result;
      REQUIRE(kernel.assemble(cell(), material(), at, result, tangent));
      return result;
    }
  };

  template <int dim>
  void
  check_tangent(const std::string &model, const unsigned int degree, const std::string &law)
  {
    CAPTURE(model);
    CAPTURE(degree);
    CAPTURE(law);
    constexpr double   h = 1e-6;
    OneCell<dim>       one(model, degree, law);
    FullMatrix<double> tangent;
    one.forces(one.u, &tangent);
    for (unsigned int j = 0; j < one.u.size(); ++j)
      {
        Vector<double> more = one.u, less = one.u;
        more(j) += h;
        less(j) -= h;
        Vector<double> change = one.forces(more);
        change -= one.forces(less);
        for (unsigned int i = 0; i < one.u.size(); ++i)
          {
            CHECK(std::abs(change(i) / (2 * h) - tangent(i, j)) < 1e-8 * tangent.linfty_norm());
            CHECK(tangent(i, j) == doctest::Approx(tangent(j, i)).epsilon(1e-12));
          }
      }
  }

  /// F = K u + O(u^2), with the K of linear elasticity.
  template <int dim>
  void
  check_limit(const std::string &model, const std::string &law)
  {
    CAPTURE(model);
    CAPTURE(law);
    constexpr double     small = 1e-6;
    OneCell<dim>         one(model, 2, law);
    StiffnessKernel<dim> linear(*one.scene.mesh,
                                one.scene.elasticity->finite_elements(),
                                one.scene.elasticity->model());
    FullMatrix<double>   K;
    linear.assemble(one.cell(), one.material(), K);
    one.u *= small;
    Vector<double> expected(one.u.size()), found = one.forces(one.u);
    K.vmult(expected, one.u);
    found -= expected;
    CHECK(found.linfty_norm() < 100 * small * expected.linfty_norm());
  }

  /// A deformation that is turned has forces that are turned: F(Q x - X) = Q F(x - X).
  template <int dim>
  void
  check_objectivity(const std::string &model, const std::string &law)
  {
    CAPTURE(law);
    OneCell<dim>   one(model, 1, law);
    Tensor<2, dim> Q;
    const double   c = std::cos(2.), s = std::sin(2.);
    for (unsigned int d = 0; d < dim; ++d)
      Q[d][d] = d < 2 ? c : 1.;
    Q[0][1]           = -s;
    Q[1][0]           = s;
    const auto    &fe = one.cell()->get_fe();
    Vector<double> turned(one.u.size());
    const auto     of_node = [&](const Vector<double> &v, const unsigned int node) {
      Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = v(fe.component_to_system_index(d, node));
      return result;
    };
    const auto vertices = one.cell()->n_vertices();
    for (unsigned int node = 0; node < vertices; ++node)
      {
        const Tensor<1, dim> X(one.cell()->vertex(node));
        const Tensor<1, dim> x = Q * (X + of_node(one.u, node)) - X;
        for (unsigned int d = 0; d < dim; ++d)
          turned(fe.component_to_system_index(d, node)) = x[d];
      }
    const Vector<double> before = one.forces(one.u), after = one.forces(turned);
    for (unsigned int node = 0; node < vertices; ++node)
      CHECK((of_node(after, node) - Q * of_node(before, node)).norm() <
            1e-13 * before.linfty_norm() * one.u.size());
  }
} // namespace



TEST_CASE("tangents of deformed cells are the derivatives of their forces")
{
  for (const unsigned int degree : {1, 2})
    {
      for (const std::string law : {"neo-Hooke", "Mooney-Rivlin", "Hencky"})
        {
          check_tangent<2>("plane strain", degree, law);
          check_tangent<2>("plane stress", degree, law);
          check_tangent<2>("axisymmetric", degree, law);
        }
      check_tangent<3>("solid", degree, "neo-Hooke");
    }
  check_tangent<3>("solid", 1, "Hencky");
}



TEST_CASE("small deformations are those of linear elasticity")
{
  for (const MaterialLaw &law : material_laws())
    if (law.name == "Mooney-Rivlin" || law.coefficients.empty())
      {
        check_limit<2>("plane strain", law.name);
        check_limit<2>("plane stress", law.name);
        check_limit<2>("axisymmetric", law.name);
        check_limit<3>("solid", law.name);
      }
}



TEST_CASE("rotations turn the forces of a deformation, and do nothing else")
{
  for (const std::string law : {"neo-Hooke", "Mooney-Rivlin", "Hencky"})
    {
      check_objectivity<2>("plane strain", law);
      check_objectivity<2>("plane stress", law);
      check_objectivity<3>("solid", law);
    }
}



namespace
{
  template <int dim>
  Lines
  adaptive_body()
  {
    const bool plane = dim == 2;
    return {"Dimension=" + std::to_string(dim),
            "Deformation=finite",
            "Bodies/Names=body",
            "Bodies/body/Mesh=box",
            plane ? "Bodies/body/Corners=0,0 : 2,1" : "Bodies/body/Corners=0,0,0 : 2,1,1",
            plane ? "Bodies/body/Subdivisions=4,2" : "Bodies/body/Subdivisions=2,1,1",
            "Bodies/body/Young's modulus=3",
            "Bodies/body/Poisson's ratio=0.35",
            "Supports/Names=base",
            "Supports/base/Boundaries=body.bottom",
            plane ? "Supports/base/Displacement=0; 0.1" : "Supports/base/Displacement=0; 0; 0.1",
            "Mesh/Distribution=p4est",
            "Mesh/Refinement regions/Names=corner",
            "Mesh/Refinement regions/corner/Inside=0.8 - x"};
  }

  double
  difference(LA::Vector a, const LA::Vector &b)
  {
    a -= b;
    return a.linfty_norm();
  }

  /// On a mesh with hanging nodes, whose values Newton's method does not know.
  template <int dim>
  void
  check_bodies(const Lines &more_lines = {})
  {
    CAPTURE(dim);
    CAPTURE(more_lines);
    constexpr double    h = 1e-6;
    SmallScene<dim>     scene(adaptive_body<dim>() + more_lines);
    NonlinearSolid<dim> bodies(StiffnessForm::assembled,
                               *scene.elasticity,
                               bodies_of_dofs(*scene.elasticity),
                               scene.timer);
    const LA::Vector    v = scene.rough_field(0.05, 0.7), nothing = scene.elasticity->zero_vector();
    LA::Vector          u = scene.rough_field(0.05, 0.3), more = u, less = u, Kv = u;
    const double        n_hanging = scene.elasticity->hanging_nodes().n_constraints();
    CHECK(Utilities::MPI::sum(n_hanging, MPI_COMM_WORLD) > 0);

    bodies.linearise(u);
    bodies.stiffness().vmult(Kv, v);
    scene.elasticity->constraints().set_zero(Kv);
    more.add(h, v);
    less.add(-h, v);
    LA::Vector change = bodies.residual(less);
    change -= bodies.residual(more);
    change /= 2 * h;
    scene.elasticity->constraints().set_zero(change);
    CHECK(difference(change, Kv) < 1e-7 * Kv.linfty_norm());

    // From a former solution the linearisation there, once.
    const LA::Vector at_rest = bodies.residual(nothing);
    bodies.linearise(nothing);
    bodies.stiffness().vmult(Kv, v);
    bodies.extrapolate_from(nothing);
    CHECK(bodies.largest_admissible_step(nothing, v) == 1);
    LA::Vector extended = bodies.residual(v);
    extended -= at_rest;
    CHECK(extended.linfty_norm() > 0);
    bodies.linearise(v);
    CHECK(difference(bodies.residual(v), at_rest) > 0);
  }
} // namespace



TEST_CASE("tangents of bodies are the derivatives of their forces, with hanging nodes too")
{
  check_bodies<2>();
  check_bodies<3>();
  // Pressures that follow the surface, and differ from place to place.
  const Lines gas = {"Loads/Names=gas",
                     "Loads/gas/Boundaries=body.top, body.right",
                     "Loads/gas/Pressure=0.3 + 0.2*x*y"};
  check_bodies<2>(gas);
  check_bodies<3>(gas);
  check_bodies<2>(gas + Lines{"Model=axisymmetric"});
}



TEST_CASE(
  "pressures follow surfaces: on a closed one they have no resultant, however it is deformed")
{
  const Lines       closed = {"Loads/Names=gas",
                              "Loads/gas/Boundaries=body.left, body.right, body.bottom, body.top",
                              "Loads/gas/Pressure=0.7"};
  SmallScene<2>     scene(adaptive_body<2>() + closed);
  PressureKernel<2> kernel(*scene.elasticity);
  const LA::Vector  u = scene.elasticity->with_ghosts(scene.rough_field(0.05, 0.3));
  Tensor<1, 2>      sum;
  double            largest = 0;
  Vector<double>    values, forces;
  for (const auto &cell : scene.elasticity->dof_handler().active_cell_iterators())
    if (cell->is_locally_owned())
      {
        values.reinit(cell->get_fe().n_dofs_per_cell());
        cell->get_dof_values(u, values);
        if (kernel.assemble(cell, values, forces))
          for (unsigned int i = 0; i < forces.size(); ++i)
            {
              sum[cell->get_fe().system_to_component_index(i).first] += forces(i);
              largest = std::max(largest, std::abs(forces(i)));
            }
      }
  largest = Utilities::MPI::max(largest, MPI_COMM_WORLD);
  CHECK(largest > 0.05);
  CHECK(Utilities::MPI::sum(sum, MPI_COMM_WORLD).norm() < 1e-13);
}



TEST_CASE("steps in which cells would fold are shortened")
{
  SmallScene<2>     scene(adaptive_body<2>());
  NonlinearSolid<2> bodies(StiffnessForm::assembled,
                           *scene.elasticity,
                           bodies_of_dofs(*scene.elasticity),
                           scene.timer);
  LA::Vector        du = scene.rough_field(1, 0.3);
  du *= 0.3 / du.linfty_norm();
  const LA::Vector nothing = scene.elasticity->zero_vector();
  const double     step    = bodies.largest_admissible_step(nothing, du);
  CHECK(step < 1);
  CHECK(step > 0.02);
  LA::Vector there = nothing;
  there.add(step, du);
  CHECK_NOTHROW(bodies.residual(there));
  du *= 1e3;
  CHECK_THROWS_AS(bodies.largest_admissible_step(nothing, du), SolverFailure);
  CHECK_THROWS_AS(bodies.residual(du), SolverFailure);
}



TEST_CASE("folded cells are seen")
{
  OneCell<2>     one("plane strain", 1, "neo-Hooke");
  Vector<double> forces;
  // One corner beyond the opposite edge.
  one.u    = 0;
  one.u(0) = 2;
  CHECK_FALSE(one.kernel.assemble(one.cell(), one.material(), one.u, forces));
  const auto &ratios = one.kernel.volume_ratios(one.cell(), one.u);
  CHECK(*std::min_element(ratios.begin(), ratios.end()) < 0);
}
