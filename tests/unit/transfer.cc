// SPDX-License-Identifier: Apache-2.0
// What is carried over from mesh to mesh and from run to run, and where meshes are refined.

#include "accuracy/error_parts.h"
#include "accuracy/p_refinement.h"
#include "accuracy/refinement.h"
#include "checkpoint/cells.h"
#include "driver/scene_setup.h"
#include "driver/state.h"
#include "solid/cell_nodes.h"

#include <doctest/doctest.h>

#include <cmath>

#include "contact_cases.h"

using namespace TestScene;

namespace
{
  template <int dim>
  double
  difference(LA::Vector a, const LA::Vector &b)
  {
    a -= b;
    return a.linfty_norm();
  }

  /// Cells whose level is lower or higher than that of all cells before.
  template <int dim>
  std::vector<unsigned int>
  coarsened_and_refined(const Mesh<dim> &mesh, const int level)
  {
    std::vector<unsigned int> n = {0, 0};
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          n[0] += cell->level() < level;
          n[1] += cell->level() > level;
        }
    Utilities::MPI::sum(n, MPI_COMM_WORLD, n);
    return n;
  }

  template <int dim>
  void
  mark_by_estimate(Mesh<dim> &mesh, const Elasticity<dim> &elasticity, const LA::Vector &u)
  {
    RefinementSettings settings;
    settings.refine_fraction  = 0.2;
    settings.coarsen_fraction = 0.7;
    mark_cells(settings, mesh, cell_errors(elasticity, u, {}).energy);
  }

  /// On parallelograms, elements contain the polynomials of their degree: linear ones in the lower
  /// body, of degree 1, and quadratic ones in the upper body.
  template <int dim>
  Tensor<1, dim>
  polynomial(const Point<dim> &x, const unsigned int body)
  {
    Tensor<1, dim> u;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = 1 + d - 2 * x[0] + (d + 1) * x[dim - 1] +
             (body == 1 ? x[0] * x[dim - 1] - (d + 2) * x[1] * x[1] : 0);
    return u;
  }

  template <int dim>
  void
  check_transfer()
  {
    CAPTURE(dim);
    const bool        plane = dim == 2;
    const std::string shear = plane ? "x+0.2*y; y+0.1*x" : "x+0.2*y; y+0.1*z; z+0.1*x";
    SmallScene<dim>   scene(
      boxes(plane ? "0,0 : 1,1" : "0,0,0 : 1,1,1",
            plane ? "2,2" : "1,1,1",
            plane ? "0,1 : 1,2" : "0,0,1 : 1,1,2",
            plane ? "2,2" : "1,1,1") +
      fixed("lower.bottom",
            plane ? "1 - 2*x + y; 2 - 2*x + 2*y" : "1 - 2*x + z; 2 - 2*x + 2*z; 3 - 2*x + 3*z") +
      Lines{"Dimension=" + std::to_string(dim),
            "Bodies/lower/Transformation=" + shear,
            "Bodies/upper/Transformation=" + shear,
            "Bodies/upper/Degree=2",
            "Mesh/Refinements=2",
            "Obstacles/Names=lid",
            "Obstacles/lid/Shape=plane",
            plane ? "Obstacles/lid/Point=0,3" : "Obstacles/lid/Point=0,0,3",
            plane ? "Obstacles/lid/Normal=0,-1" : "Obstacles/lid/Normal=0,0,-1",
            plane ? "Obstacles/lid/Displacement=0; free" :
                      "Obstacles/lid/Displacement=0; 0; free"});
    Elasticity<dim> &elasticity = *scene.elasticity;
    LA::Vector       constant   = interpolant(scene, [](auto, auto) {
      Tensor<1, dim> one;
      for (unsigned int d = 0; d < dim; ++d)
        one[d] = 1 + d;
      return one;
    });
    LA::Vector       field      = interpolant(scene, polynomial<dim>);
    Values           lid(RigidBody<dim>::n_dofs);
    for (unsigned int i = 0; i < lid.size(); ++i)
      lid[i] = 0.5 + i;
    elasticity.set_rigid_motion(lid, field);

    // Where to refine: a displacement with a kink.
    const LA::Vector bent = interpolant(scene, [](const Point<dim> &x, auto) {
      Tensor<1, dim> u;
      u[0] = std::abs(x[0] + x[1] - 0.3);
      u[1] = 0.01 * std::sin(3 * (x[0] + 2 * x[1] + x[dim - 1]));
      return u;
    });
    for (unsigned int cycle = 0; cycle < 2; ++cycle)
      {
        mark_by_estimate(*scene.mesh, elasticity, cycle == 0 ? bent : field);
        refine(*scene.mesh, elasticity, {&field, &constant});
        if (cycle == 0)
          {
            const auto n = coarsened_and_refined(*scene.mesh, 2);
            CHECK(n[0] > 0);
            CHECK(n[1] > 0);
            CHECK(Utilities::MPI::sum(elasticity.hanging_nodes().n_constraints(), MPI_COMM_WORLD) >
                  0);
          }
        LA::Vector expected = interpolant(scene, polynomial<dim>);
        elasticity.set_rigid_motion(lid, expected);
        CHECK(difference<dim>(field, expected) < 1e-13);
        const LA::Vector one = interpolant(scene, [](auto, auto) {
          Tensor<1, dim> one;
          for (unsigned int d = 0; d < dim; ++d)
            one[d] = 1 + d;
          return one;
        });
        CHECK(difference<dim>(constant, one) < 1e-13);
        // It satisfies the constraints of the new mesh: but for the lid, whose motion is
        // prescribed.
        elasticity.hanging_nodes().distribute(field);
        CHECK(difference<dim>(field, expected) < 1e-13);
        elasticity.distribute(field);
        elasticity.set_rigid_motion(lid, field);
        CHECK(difference<dim>(field, expected) < 1e-12);
      }
  }
} // namespace



namespace
{
  template <int dim>
  Lines
  degrees_one_and_two()
  {
    const bool plane = dim == 2;
    return boxes(plane ? "0,0 : 1,1" : "0,0,0 : 1,1,1",
                 plane ? "2,2" : "1,1,1",
                 plane ? "0,1 : 1,2" : "0,0,1 : 1,1,2",
                 plane ? "3,2" : "1,2,1") +
           Lines{"Dimension=" + std::to_string(dim),
                 "Bodies/upper/Degree=2",
                 "Mesh/Refinements=2",
                 "Mesh/Distribution=p4est"};
  }

  /// What the next rank has told.
  std::vector<CellValues>
  of_the_next_rank(const std::vector<CellValues> &cells)
  {
    const unsigned int n    = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                       next = (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) + 1) % n;
    return Utilities::MPI::all_gather(MPI_COMM_WORLD, cells)[next];
  }

  template <int dim>
  void
  check_restart()
  {
    CAPTURE(dim);
    SmallScene<dim> before(degrees_one_and_two<dim>());
    LA::Vector      bent = interpolant(before, [](const Point<dim> &x, auto) {
      Tensor<1, dim> u;
      u[0] = std::abs(x[0] + x[1] - 0.3);
      return u;
    });
    for (unsigned int cycle = 0; cycle < 2; ++cycle)
      {
        mark_by_estimate(*before.mesh, *before.elasticity, bent);
        refine(*before.mesh, *before.elasticity, {&bent});
      }
    const LA::Vector field = interpolant(before, polynomial<dim>);
    const auto       cells = of_the_next_rank(values_of_cells(*before.elasticity, field));

    SmallScene<dim> after(degrees_one_and_two<dim>());
    const auto      mark = mark_of_mesh(*before.mesh);
    CHECK_THROWS_AS(check_mark(*after.mesh, mark), SceneError);
    CHECK_THROWS_AS(vector_of_cells(*after.elasticity, cells), SceneError);
    after.elasticity.reset();
    restore_cells(*after.mesh, cells);
    CHECK_NOTHROW(check_mark(*after.mesh, mark));
    after.elasticity = make_elasticity(after.decisions, *after.mesh);
    after.elasticity->setup();
    CHECK(after.elasticity->dof_handler().n_dofs() == before.elasticity->dof_handler().n_dofs());
    CHECK(difference<dim>(vector_of_cells(*after.elasticity, cells),
                          interpolant(after, polynomial<dim>)) == 0);
  }
} // namespace



namespace
{
  /// Bodies of degree 1 and 2 on an adaptive mesh: both get degree 2.
  template <int dim>
  void
  check_p_refinement()
  {
    CAPTURE(dim);
    SmallScene<dim> scene(degrees_one_and_two<dim>());
    LA::Vector      bent = scene.rough_field(1, 0.4);
    mark_by_estimate(*scene.mesh, *scene.elasticity, bent);
    refine(*scene.mesh, *scene.elasticity, {&bent});
    const LA::Vector poor = interpolant(scene, polynomial<dim>);
    CHECK(growth_of_p_refinement(*scene.mesh, {}) == 1);
    CHECK(growth_of_p_refinement(*scene.mesh, {0, 1}) == std::pow(2, dim));

    const auto before = std::move(scene.elasticity);
    scene.decisions.raise_degree(0);
    scene.mesh->set_degrees(scene.decisions.degrees);
    scene.elasticity = make_elasticity(scene.decisions, *scene.mesh);
    scene.elasticity->setup();
    CHECK(scene.elasticity->dof_handler().n_dofs() > before->dof_handler().n_dofs());
    CHECK(difference<dim>(p_refined(*before, poor, *scene.elasticity),
                          interpolant(scene, polynomial<dim>)) < 1e-14);
  }

  /// Only bodies that matter, and only where smaller cells would take more.
  template <int dim>
  void
  check_choice(const double enough)
  {
    CAPTURE(dim);
    const SmallScene<dim> scene(degrees_one_and_two<dim>());
    const auto           &triangulation = scene.mesh->triangulation();
    std::vector<double>   indicators(triangulation.n_active_cells(), 0.);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        indicators[cell->active_cell_index()] = cell->material_id() == 0 ? 1. : 1e-4;
    using Bodies = std::vector<unsigned int>;
    CHECK(bodies_to_p_refine(*scene.mesh, indicators, {true, true}, 1.1 * enough) == Bodies{0});
    CHECK(bodies_to_p_refine(*scene.mesh, indicators, {false, true}, 1.1 * enough) == Bodies{});
    CHECK(bodies_to_p_refine(*scene.mesh, indicators, {true, true}, 0.9 * enough) == Bodies{});
  }
} // namespace



TEST_CASE("displacements are carried over to quadratic elements")
{
  check_p_refinement<2>();
  check_p_refinement<3>();
}



TEST_CASE("bodies become quadratic where the target is far")
{
  check_choice<2>(8);
  check_choice<3>(std::pow(16., 2. / 3));
}



TEST_CASE("mesh and displacement are those that other ranks have written")
{
  check_restart<2>();
  check_restart<3>();
}



TEST_CASE("polynomials of the elements' degree are carried over to other meshes")
{
  check_transfer<2>();
  check_transfer<3>();
}



namespace
{
  /// A pressure at the places of the gap operator, by their positions.
  template <int dim>
  LA::Vector
  linear_pressure(const GapOperator &contact)
  {
    LA::Vector p = contact.zero();
    for (const auto i : p.locally_owned_elements())
      {
        double value = 1;
        for (unsigned int d = 0; d < dim; ++d)
          value += (2 + d) * contact.geometry.position[d](i);
        p(i) = value;
      }
    p.compress(VectorOperation::insert);
    return p;
  }

  template <int dim>
  void
  check_pressure(const Case &which, const std::string &degree, const Lines &method)
  {
    CAPTURE(which.name);
    CAPTURE(degree);
    CAPTURE(method.front());
    SmallScene<dim> scene(which.lines +
                          Lines{"Dimension=" + std::to_string(dim), "Mesh/Degree=" + degree});
    scene.use(method);
    const LA::Vector pressure = linear_pressure<dim>(scene.gap_operator());
    ContactState     state    = open_contact(scene.gap_operator());
    state.traction[0]         = pressure;
    const SurfaceField field  = to_surface_field(scene.gap_operator(), state, dim);
    const auto         n      = scene.mesh->triangulation().n_global_active_cells();

    // What is asked for again is what was given, to the last digit.
    state = from_surface_field(field, scene.gap_operator(), {});
    CHECK(difference<dim>(state.pressure(), pressure) < 1e-15);

    LA::Vector u = scene.rough_field(1, 0.4);
    mark_by_estimate(*scene.mesh, *scene.elasticity, u);
    refine(*scene.mesh, *scene.elasticity, {&u});
    scene.use(method);
    CHECK(scene.mesh->triangulation().n_global_active_cells() != n);
    state = from_surface_field(field, scene.gap_operator(), {});
    CHECK(difference<dim>(state.pressure(), linear_pressure<dim>(scene.gap_operator())) < 1e-8);
    CHECK(state.status.linfty_norm() == 1);
  }
} // namespace

TEST_CASE("linear pressures are carried over to other meshes, from nodes and from points")
{
  const Lines nodes = {"Method=Lagrange multiplier"}, points = {"Method=Nitsche"};
  for (const Lines &method : {nodes, points})
    for (const std::string degree : {"1", "2"})
      {
        check_pressure<2>(cases_2d()[0], degree, method);
        check_pressure<2>(cases_2d()[2], degree, method);
      }
  for (const Lines &method : {nodes, points})
    check_pressure<3>(cases_3d()[0], "1", method);
}
