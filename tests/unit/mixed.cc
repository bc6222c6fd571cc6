// SPDX-License-Identifier: Apache-2.0
// Bodies with a volumetric stress of their own: its functions, the derivatives of its equations,
// and that the pair is stable.

#include "driver/scene_setup.h"
#include "linear_algebra/direct_solver.h"
#include "solid/rigid_body_modes.h"
#include "solver/nonlinear_solid.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <sstream>

#include "mesh_helpers.h"
#include "small_scene.h"
#include <Eigen/Dense>

using namespace TestScene;

namespace
{
  /// A mixed body with hanging nodes beside one that is not; cells of the first are no
  /// parallelograms.
  template <int dim>
  Lines
  two_bodies(const std::string &deformation)
  {
    const bool plane = dim == 2;
    return {"Dimension=" + std::to_string(dim),
            "Deformation=" + deformation,
            "Bodies/Names=body,other",
            "Bodies/body/Mesh=box",
            plane ? "Bodies/body/Corners=0,0 : 2,1" : "Bodies/body/Corners=0,0,0 : 2,1,1",
            plane ? "Bodies/body/Subdivisions=4,2" : "Bodies/body/Subdivisions=2,1,1",
            plane ? "Bodies/body/Transformation=x + 0.1*x*y; y + 0.1*x*y" :
                    "Bodies/body/Transformation=x + 0.1*x*y; y + 0.1*x*z; z",
            "Bodies/body/Young's modulus=3",
            "Bodies/body/Poisson's ratio=0.499",
            "Bodies/other/Mesh=box",
            plane ? "Bodies/other/Corners=3,0 : 4,1" : "Bodies/other/Corners=3,0,0 : 4,1,1",
            "Bodies/other/Young's modulus=3",
            "Bodies/other/Poisson's ratio=0.3",
            "Supports/Names=base",
            "Supports/base/Boundaries=body.bottom, other.bottom",
            plane ? "Supports/base/Displacement=0; 0.01" : "Supports/base/Displacement=0; 0; 0.01",
            "Mesh/Distribution=p4est",
            "Mesh/Refinement regions/Names=corner",
            "Mesh/Refinement regions/corner/Bodies=body",
            "Mesh/Refinement regions/corner/Inside=0.8 - x"};
  }

  /// A mixed body of tetrahedra beside a cube that is not.
  Lines
  tetrahedra_beside_cube(const std::string &deformation)
  {
    return {"Dimension=3",
            "Deformation=" + deformation,
            "Bodies/Names=body,other",
            "Bodies/body/Mesh=file",
            "Bodies/body/File=" + MeshTests::stored_mesh("tetrahedra.inp"),
            "Bodies/body/Part=upper",
            "Bodies/body/Cells=as in file",
            "Bodies/body/Young's modulus=3",
            "Bodies/body/Poisson's ratio=0.499",
            "Bodies/other/Mesh=box",
            "Bodies/other/Corners=30,0,0 : 40,10,10",
            "Bodies/other/Young's modulus=3",
            "Bodies/other/Poisson's ratio=0.3",
            "Supports/Names=base",
            "Supports/base/Boundaries=body.press, other.bottom",
            "Supports/base/Displacement=0; 0; 0.01"};
  }

  Lines
  square_cells(const unsigned int n)
  {
    return {"Bodies/body/Mesh=box",
            "Bodies/body/Corners=1,0 : 2,1",
            "Bodies/body/Subdivisions=" + std::to_string(n) + "," + std::to_string(n)};
  }

  /// The deck of the same square of triangles of six nodes, two in each of n x n squares.
  std::string
  triangle_deck(const unsigned int n)
  {
    std::ostringstream nodes, elements;
    const unsigned int row = 2 * n + 1; // of nodes, numbered from 1
    for (unsigned int j = 0; j < row; ++j)
      for (unsigned int i = 0; i < row; ++i)
        nodes << j * row + i + 1 << ", " << 1 + 0.5 * i / n << ", " << 0.5 * j / n << "\n";
    unsigned int number = 0;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        for (const auto &way :
             {std::array<unsigned int, 6>{{0, 2, 2 * row + 2, 1, row + 2, row + 1}},
              std::array<unsigned int, 6>{{0, 2 * row + 2, 2 * row, row + 1, 2 * row + 1, row}}})
          {
            elements << ++number;
            for (const unsigned int k : way)
              elements << ", " << 2 * j * row + 2 * i + 1 + k;
            elements << "\n";
          }
    return "*NODE\n" + nodes.str() + "*NSET, NSET=bottom, GENERATE\n1, " + std::to_string(row) +
           "\n*ELEMENT, TYPE=CPE6, ELSET=ALL\n" + elements.str();
  }

  /// The same on any number of ranks, but for the numbering.
  LA::Vector
  rough_stress(const LA::Vector &zero, const double amplitude)
  {
    LA::Vector m = zero;
    for (const auto i : m.locally_owned_elements())
      m(i) = amplitude * std::sin(3.7 * i + 0.4);
    m.compress(VectorOperation::insert);
    return m;
  }

  double
  difference(LA::Vector a, const LA::Vector &b)
  {
    a -= b;
    return a.linfty_norm();
  }

  template <int dim>
  void
  check_functions()
  {
    CAPTURE(dim);
    SmallScene<dim>              scene(two_bodies<dim>("small"));
    const VolumetricStress<dim> &volumetric = scene.elasticity->volumetric_stress();
    CHECK(scene.elasticity->degree(0) == 2);
    CHECK(scene.elasticity->degree(1) == 1);
    FEValues<dim> values(scene.mesh->mapping(),
                         scene.elasticity->finite_elements()[0],
                         QGauss<dim>(3),
                         update_quadrature_points | update_JxW_values);
    double        wrong = 0;
    unsigned int  n     = 0;
    for (const auto &cell : scene.mesh->triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          if (cell->material_id() != 0)
            {
              wrong += volumetric.is_on(*cell) + std::abs(volumetric.value(*cell, cell->center()));
              continue;
            }
          ++n;
          values.reinit(cell);
          FullMatrix<double> products(dim + 1, dim + 1);
          for (const unsigned int q : values.quadrature_point_indices())
            {
              const auto phi = volumetric.functions(*cell, values.quadrature_point(q));
              for (unsigned int i = 0; i <= dim; ++i)
                for (unsigned int j = 0; j <= dim; ++j)
                  products(i, j) += values.JxW(q) * phi[i] * phi[j];
            }
          const auto &mass = volumetric.mass(*cell);
          for (unsigned int i = 0; i <= dim; ++i)
            products(i, i) -= mass[i][i];
          wrong = std::max(wrong, products.linfty_norm() / mass[0][0]);
        }
    CHECK(wrong < 1e-13);
    CHECK(volumetric.zero_vector().size() == (dim + 1) * Utilities::MPI::sum(n, MPI_COMM_WORLD));
  }

  /// Newton's method does not know the values of hanging nodes.
  template <int dim>
  void
  check_derivatives(const Lines &lines)
  {
    CAPTURE(lines);
    constexpr double       h = 1e-6;
    SmallScene<dim>        scene(lines);
    const bool             is_finite_strain = scene.elasticity->is_finite_strain();
    VolumeConstraint<dim>  balance(*scene.elasticity);
    VolumetricStress<dim> &volumetric = scene.elasticity->volumetric_stress();
    const LA::Vector       u = scene.rough_field(0.005, 0.3), v = scene.rough_field(0.005, 0.7);
    LA::Vector             more = u, less = u, Bv = volumetric.zero_vector();
    more.add(h, v);
    less.add(-h, v);

    // B is the derivative of int phi theta, and C m that by m.
    balance.linearise(u);
    balance.coupling().B.vmult(Bv, v);
    LA::Vector change = balance.residual(less);
    change -= balance.residual(more);
    change /= 2 * h;
    CHECK(Bv.linfty_norm() > 0);
    CHECK(difference(change, Bv) < 1e-7 * Bv.linfty_norm());
    const LA::Vector m = rough_stress(volumetric.zero_vector(), 0.1), before = balance.residual(u);
    balance.add(1, m);
    change = balance.residual(u);
    change -= before;
    LA::Vector Cm = m;
    balance.coupling().C.vmult(Cm, m);
    CHECK(difference(change, Cm) < 1e-12);

    // From a former solution the linearisation there, once.
    LA::Vector nothing = scene.elasticity->zero_vector();
    scene.elasticity->distribute(nothing);
    balance.linearise(nothing);
    balance.coupling().B.vmult(Bv, v);
    LA::Vector at_rest = balance.residual(nothing);
    balance.extrapolate_from(nothing);
    change = balance.residual(nothing);
    change -= balance.residual(v);
    CHECK(difference(change, Bv) < 1e-12);
    if (!is_finite_strain)
      return;

    // The forces of m, and what it does to the tangent.
    NonlinearSolid<dim> bodies(StiffnessForm::assembled,
                               *scene.elasticity,
                               bodies_of_dofs(*scene.elasticity),
                               scene.timer);
    LA::Vector          force = bodies.residual(u), Bm = scene.elasticity->zero_vector();
    balance.linearise(nothing); // takes the start away
    balance.linearise(u);
    balance.coupling().B.Tvmult(Bm, m);
    balance.add(-1, m);
    force.sadd(-1, 1, bodies.residual(u));
    scene.elasticity->constraints().set_zero(force);
    CHECK(difference(force, Bm) < 1e-12);
    balance.add(1, m);

    LA::Vector Kv = u;
    bodies.linearise(u);
    bodies.stiffness().vmult(Kv, v);
    scene.elasticity->constraints().set_zero(Kv);
    change = bodies.residual(less);
    change -= bodies.residual(more);
    change /= 2 * h;
    scene.elasticity->constraints().set_zero(change);
    CHECK(difference(change, Kv) < 1e-7 * Kv.linfty_norm());

    // A start is taken away where nothing has changed, too.
    bodies.extrapolate_from(u);
    bodies.linearise(u);
    LA::Vector far = u;
    far.add(0.5, v);
    CHECK(difference(bodies.volumetric()->residual(far), balance.residual(far)) == 0);
  }

  /// Eigenvalues of S^-1 (C + B K^-1 B^T), S the diagonal that stands for it. By the serial solver.
  std::pair<double, double>
  extremes_of_schur(const Lines &lines)
  {
    SmallScene<2>       scene(lines);
    VolumeConstraint<2> balance(*scene.elasticity);
    balance.linearise(scene.elasticity->zero_vector());
    const VolumetricCoupling &coupling = balance.coupling();
    LA::DirectSolver          solver(LA::DirectLibrary::KLU);
    REQUIRE(solver.factorise(scene.elasticity->stiffness()) == 0);
    const unsigned int n = coupling.schur.size();
    Eigen::MatrixXd    schur(n, n);
    for (unsigned int j = 0; j < n; ++j)
      {
        LA::Vector one = scene.elasticity->volumetric_stress().zero_vector(), column = one;
        if (one.locally_owned_elements().is_element(j))
          one(j) = 1;
        one.compress(VectorOperation::insert);
        LA::Vector f = scene.elasticity->zero_vector(), u = f;
        coupling.B.Tvmult(f, one);
        solver.solve(u, f);
        coupling.B.vmult(column, u);
        LA::Vector of_one = one;
        coupling.C.vmult(of_one, one);
        column += of_one;
        const Values values = everywhere(column), sizes = everywhere(coupling.schur);
        for (unsigned int i = 0; i < n; ++i)
          schur(i, j) = values[i] / std::sqrt(sizes[i] * sizes[j]);
      }
    const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(schur).eigenvalues();
    return {eigenvalues.minCoeff(), eigenvalues.maxCoeff()};
  }

  Lines
  skewed_block(const Lines &mesh, const std::string &ratio, const std::string &model)
  {
    return Lines{"Dimension=2", "Model=" + model, "Bodies/Names=body"} + mesh +
           Lines{"Bodies/body/Transformation=x + 0.06*sin(14*y); y + 0.06*sin(11*x)",
                 "Bodies/body/Young's modulus=3",
                 "Bodies/body/Poisson's ratio=" + ratio,
                 "Bodies/body/Formulation=mixed",
                 "Supports/Names=base",
                 "Supports/base/Boundaries=body.bottom",
                 "Supports/base/Displacement=0; 0"};
  }
} // namespace



TEST_CASE("functions of the bulk stress are orthogonal, and of mixed bodies alone")
{
  check_functions<2>();
  check_functions<3>();
}



TEST_CASE("equations of the bulk stress are linearised, with hanging nodes and simplices too")
{
  for (const std::string deformation : {"small", "finite"})
    {
      check_derivatives<2>(two_bodies<2>(deformation));
      check_derivatives<2>(two_bodies<2>(deformation) + Lines{"Model=axisymmetric"});
      check_derivatives<3>(two_bodies<3>(deformation));
      check_derivatives<3>(tetrahedra_beside_cube(deformation));
    }
}



TEST_CASE("displacement and bulk stress are a stable pair, whatever Poisson's ratio is")
{
  for (const std::string model : {"plane strain", "axisymmetric"})
    for (const std::string ratio : {"0.3", "0.5"})
      for (const unsigned int cells : {2, 5})
        {
          CAPTURE(model);
          CAPTURE(ratio);
          CAPTURE(cells);
          const double bound = model == "axisymmetric" ? 3 : 2; // of (tr eps)^2 <= n eps : eps
          const auto [least, largest] =
            extremes_of_schur(skewed_block(square_cells(cells), ratio, model));
          CHECK(least > 0.4); // it does not fall with h
          CHECK(largest < bound);

          // The diagonal of the mass matrix of a triangle is 1/2 to 2 times it (A. Wathen, IMA J.
          // Numer. Anal. 7 (1987) 449).
          const MeshTests::TemporaryFile file(triangle_deck(cells), ".inp");
          const auto [low, high] =
            extremes_of_schur(skewed_block(Lines{"Bodies/body/Mesh=file",
                                                 "Bodies/body/File=" + file.path,
                                                 "Bodies/body/Cells=as in file"},
                                           ratio,
                                           model));
          CHECK(low > 0.2);
          CHECK(high < 2 * bound);
        }
}
