// SPDX-License-Identifier: Apache-2.0
// Cell matrices and load vectors against an assembly with all indices, and against closed forms.

#include "solid/kernel.h"

#include "solid/stress.h"

#include <deal.II/base/quadrature_lib.h>

#include <doctest/doctest.h>

#include <cmath>

#include "reference.h"

using namespace TestScene;

namespace
{
  template <int dim>
  Lines
  body(const std::string &mesh,
       const Lines       &keys,
       const std::string &model,
       const std::string &degree)
  {
    Lines lines = {"Dimension=" + std::to_string(dim),
                   "Model=" + model,
                   "Mesh/Degree=" + degree,
                   "Bodies/Names=body",
                   "Bodies/body/Mesh=" + mesh,
                   "Bodies/body/Young's modulus=7",
                   "Bodies/body/Poisson's ratio=0.3"};
    for (const std::string &key : keys)
      lines.push_back("Bodies/body/" + key);
    return lines;
  }

  /// Cells of these shapes. No cell reaches the axis, where 1/r would need ever more points.
  template <int dim>
  Lines
  shape(const std::string &name)
  {
    const bool  plane = dim == 2;
    const Lines box   = {plane ? "Corners=1,0 : 3,1" : "Corners=1,0,0 : 3,1,2",
                       plane ? "Subdivisions=2,1" : "Subdivisions=2,1,1"};
    if (name == "sheared")
      return box + Lines{plane ? "Transformation=x+0.3*y; y-0.2*x" :
                                 "Transformation=x+0.3*y; y-0.2*z; z+0.1*x"};
    if (name == "distorted")
      return box + Lines{plane ? "Transformation=x+0.2*x*y; y+0.1*x*y" :
                                 "Transformation=x+0.2*x*y+0.1*y*z; y+0.1*x*z; z+0.1*x*y"};
    return {"Inner radius=1",
            "Outer radius=2",
            plane ? "Part=quarter" : "Part=quarter",
            "Cells around=2"};
  }

  template <int dim>
  FEValues<dim>
  values_on(const SmallScene<dim> &scene, const unsigned int n_points)
  {
    return FEValues<dim>(scene.mesh->mapping(),
                         scene.elasticity->finite_elements()[0],
                         QGauss<dim>(n_points),
                         update_values | update_gradients | update_quadrature_points |
                           update_JxW_values);
  }

  /// Calls check(matrix of the program, cell, scene) for each cell.
  template <int dim, typename Check>
  void
  on_cells(const SmallScene<dim> &scene, const Check &check)
  {
    StiffnessKernel<dim> kernel(*scene.mesh,
                                scene.elasticity->finite_elements(),
                                model_of(scene.scene.model));
    FullMatrix<double>   K;
    for (const auto &cell : scene.elasticity->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          kernel.assemble(cell, scene.elasticity->material(0), K);
          check(K, cell);
        }
  }

  /// @param n_points beyond those that the program takes
  /// @return the largest difference, relative to the norm of the matrix
  template <int dim>
  double
  difference(const Lines &lines, const unsigned int beyond)
  {
    const SmallScene<dim> scene(lines);
    FEValues<dim>         values  = values_on(scene, scene.elasticity->degree() + 1 + beyond);
    double                largest = 0;
    on_cells(scene, [&](const FullMatrix<double> &K, const auto &cell) {
      values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell));
      FullMatrix<double> error =
        reference_matrix(values, model_of(scene.scene.model), scene.elasticity->material(0));
      const double norm = error.frobenius_norm();
      error.add(-1, K);
      largest = std::max(largest, error.frobenius_norm() / norm);
    });
    return Utilities::MPI::max(largest, MPI_COMM_WORLD);
  }

  template <int dim>
  std::vector<std::string>
  models()
  {
    return model_names<dim>();
  }

  template <int dim>
  void
  check_matrices()
  {
    for (const std::string &model : models<dim>())
      for (const std::string degree : {"1", "2"})
        for (const std::string name : {"sheared", "distorted", "curved"})
          {
            CAPTURE(model);
            CAPTURE(degree);
            CAPTURE(name);
            const std::string mesh  = name == "curved" ? "ring" : "box";
            const Lines       lines = body<dim>(mesh, shape<dim>(name), model, degree);
            CHECK(difference<dim>(lines, 0) < 1e-13);
            // On parallelograms the rule of the program integrates exactly what has no 1/r.
            if (name == "sheared" && model != "axisymmetric")
              CHECK(difference<dim>(lines, 2) < 1e-13);
          }
  }
} // namespace



TEST_CASE("cell matrices equal those of the elasticity tensor, index by index")
{
  check_matrices<2>();
  check_matrices<3>();
}



namespace
{
  /// Nodal values of a displacement, cell by cell.
  template <int dim, typename U>
  Vector<double>
  nodal_values(const FEValues<dim> &at_nodes, const U &u)
  {
    const auto    &fe = at_nodes.get_fe();
    Vector<double> v(fe.n_dofs_per_cell());
    for (unsigned int i = 0; i < v.size(); ++i)
      v[i] = u(at_nodes.quadrature_point(i))[fe.system_to_component_index(i).first];
    return v;
  }

  /// Twice the energy of a displacement that the elements contain, over all cells.
  template <int dim, typename U>
  double
  energy(const SmallScene<dim> &scene, const U &u)
  {
    FEValues<dim> nodes(scene.mesh->mapping(),
                        scene.elasticity->finite_elements()[0],
                        Quadrature<dim>(
                          scene.elasticity->finite_elements()[0].get_unit_support_points()),
                        update_quadrature_points);
    double        sum = 0;
    on_cells(scene, [&](const FullMatrix<double> &K, const auto &cell) {
      nodes.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell));
      sum += K.matrix_norm_square(nodal_values(nodes, u));
    });
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  /// As large as the motions below, so that its energy is what theirs is rounded by.
  template <int dim>
  Tensor<1, dim>
  stretch(const Point<dim> &x)
  {
    return 3. * x;
  }

  /// Young's modulus 7, Poisson's ratio 0.3.
  constexpr double E = 7, nu = 0.3;
} // namespace

TEST_CASE("rigid motions have no energy, on any cells")
{
  for (const std::string degree : {"1", "2"})
    for (const std::string name : {"sheared", "distorted", "curved"})
      {
        CAPTURE(degree);
        CAPTURE(name);
        const std::string mesh = name == "curved" ? "ring" : "box";
        // With degree 1, curved cells do not contain the rotations.
        const double        turns = name == "curved" && degree[0] == '1' ? 0 : 1;
        const SmallScene<2> plane(body<2>(mesh, shape<2>(name), "plane strain", degree));
        CHECK(energy(plane, [&](const Point<2> &x) {
                return Tensor<1, 2>({0.3 - turns * x[1], turns * x[0] - 2});
              }) < 1e-13 * energy(plane, stretch<2>));
        const SmallScene<2> axial(body<2>(mesh, shape<2>(name), "axisymmetric", degree));
        CHECK(energy(axial, [](const Point<2> &) {
                return Tensor<1, 2>({0., 3.});
              }) < 1e-13 * energy(axial, stretch<2>));
        const SmallScene<3> solid(body<3>(mesh, shape<3>(name), "solid", degree));
        CHECK(energy(solid, [&](const Point<3> &x) {
                return Tensor<1, 3>({1 + turns * (x[2] - 2 * x[1]),
                                     turns * (2 * x[0] - 3 * x[2]),
                                     turns * (3 * x[1] - x[0]) - 1});
              }) < 1e-13 * energy(solid, stretch<3>));
      }
}



TEST_CASE("the energy of uniform strain is that of the closed form")
{
  // A box of 2 by 1 (by 2) under u = eps x, v = gamma x: sigma : eps times its volume.
  constexpr double eps = 0.3, gamma = 0.2, G = E / 2 / (1 + nu);
  for (const std::string degree : {"1", "2"})
    {
      const auto u   = [](const Point<2> &x) { return Tensor<1, 2>({eps * x[0], gamma * x[0]}); };
      const auto box = [&](const char *model) {
        return body<2>("box", {"Corners=1,0 : 3,1", "Subdivisions=3,2"}, model, degree);
      };
      const double shear  = G * gamma * gamma;
      const double strain = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) * eps * eps + shear;
      CHECK(energy(SmallScene<2>(box("plane strain")), u) ==
            doctest::Approx(2 * strain).epsilon(1e-13));
      CHECK(energy(SmallScene<2>(box("plane stress")), u) ==
            doctest::Approx(2 * (E / (1 - nu * nu) * eps * eps + shear)).epsilon(1e-13));
      const SmallScene<3> solid(
        body<3>("box", {"Corners=1,0,0 : 3,1,2", "Subdivisions=2,1,2"}, "solid", degree));
      CHECK(energy(solid, [](const Point<3> &x) {
              return Tensor<1, 3>({eps * x[0], gamma * x[0], 0.});
            }) == doctest::Approx(4 * strain).epsilon(1e-13));
      // u_r = eps r: eps_r = eps_hoop = eps, sigma of both E eps/((1 + nu)(1 - 2 nu)); volume pi (9
      // - 1).
      CHECK(energy(SmallScene<2>(box("axisymmetric")),
                   [](const Point<2> &x) {
                     return Tensor<1, 2>({eps * x[0], 0.});
                   }) ==
            doctest::Approx(8 * numbers::PI * 2 * E * eps * eps / ((1 + nu) * (1 - 2 * nu)))
              .epsilon(1e-13));
    }
}



TEST_CASE("stresses of a strain in space")
{
  const Material material{E, nu};
  // Uniaxial stress: the strains across are -nu times the one along.
  SymmetricTensor<2, 3> strain;
  strain[0][0] = 0.1;
  strain[1][1] = strain[2][2] = -nu * 0.1;
  strain[0][1]                = 0.05;
  const auto sigma            = stress(material, strain);
  CHECK(sigma[0][0] == doctest::Approx(E * 0.1).epsilon(1e-14));
  CHECK(std::abs(sigma[1][1]) + std::abs(sigma[2][2]) < 1e-14);
  CHECK(sigma[0][1] == doctest::Approx(E / (1 + nu) * 0.05).epsilon(1e-14));
  CHECK(
    von_mises(sigma) ==
    doctest::Approx(std::sqrt(std::pow(E * 0.1, 2) + 3 * std::pow(sigma[0][1], 2))).epsilon(1e-14));
  // In plane stress there is none across.
  Tensor<2, 2> gradient;
  gradient[0][0]      = 0.1;
  gradient[1][1]      = 0.03;
  gradient[0][1]      = 0.2;
  const auto in_plane = stress(
    material,
    Signorini::strain(Model::plane_stress, material, gradient, Tensor<1, 2>(), Point<2>(1, 1)));
  CHECK(std::abs(in_plane[2][2]) < 1e-15);
  CHECK(in_plane[0][0] == doctest::Approx(E / (1 - nu * nu) * (0.1 + nu * 0.03)).epsilon(1e-14));
  CHECK(in_plane[0][1] == doctest::Approx(E / (1 + nu) * 0.1).epsilon(1e-14));
  const Point<2> at(2, 5);
  const auto     axial =
    Signorini::strain(Model::axisymmetric, material, gradient, Tensor<1, 2>({0.5, 1.}), at);
  CHECK(axial[2][2] == doctest::Approx(0.25));
}



namespace
{
  /// What loads do along a displacement that the elements contain.
  template <int dim, typename U>
  double
  work_of_loads(const SmallScene<dim> &scene, const double t, const U &u)
  {
    LoadKernel<dim> kernel(*scene.mesh,
                           scene.elasticity->finite_elements(),
                           model_of(scene.scene.model),
                           scene.scene.loads,
                           t);
    FEValues<dim>   nodes(scene.mesh->mapping(),
                        scene.elasticity->finite_elements()[0],
                        Quadrature<dim>(
                          scene.elasticity->finite_elements()[0].get_unit_support_points()),
                        update_quadrature_points);
    Vector<double>  load;
    double          sum = 0;
    for (const auto &cell : scene.elasticity->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && kernel.assemble(cell, load))
        {
          nodes.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell));
          sum += load * nodal_values(nodes, u);
        }
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }
} // namespace

TEST_CASE("loads do the work of closed forms")
{
  // Archimedes: the pressure -y of a liquid on all faces of a body pushes it up by its volume.
  for (const std::string degree : {"1", "2"})
    {
      CAPTURE(degree);
      const SmallScene<2> plane(
        body<2>("box", shape<2>("distorted"), "plane strain", degree) +
        Lines{"Loads/Names=liquid",
              "Loads/liquid/Boundaries=body.left,body.right,body.bottom,body.top",
              "Loads/liquid/Pressure=-y*t"});
      FEValues<2> values = values_on(plane, 4);
      double      area   = 0;
      for (const auto &cell : plane.mesh->triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            values.reinit(cell);
            for (const unsigned int q : values.quadrature_point_indices())
              area += values.JxW(q);
          }
      area = Utilities::MPI::sum(area, MPI_COMM_WORLD);
      CHECK(work_of_loads(plane, 3, [](const Point<2> &) {
              return Tensor<1, 2>({0., 1.});
            }) == doctest::Approx(3 * area).epsilon(1e-13));
      CHECK(std::abs(work_of_loads(plane, 3, [](const Point<2> &) {
              return Tensor<1, 2>({1., 0.});
            })) < 1e-13);

      // A traction (0, 0, x) on the top of 2 by 1 and a body force (0, 0, -2 z) in 2 by 1 by 2.
      const SmallScene<3> solid(
        body<3>("box", {"Corners=1,0,0 : 3,1,2", "Subdivisions=2,1,2"}, "solid", degree) +
        Lines{"Loads/Names=pull, weight",
              "Loads/pull/Boundaries=body.top",
              "Loads/pull/Traction=0; 0; x",
              "Loads/weight/Bodies=body",
              "Loads/weight/Body force=0; 0; -2*z"});
      const auto up = [](const Point<3> &) { return Tensor<1, 3>({0., 0., 1.}); };
      CHECK(work_of_loads(solid, 1, up) == doctest::Approx(4 - 8).epsilon(1e-13));

      // Axisymmetric, on the whole circumference: pressure 1 outwards on r = 1, along u_r = r.
      const SmallScene<2> axial(
        body<2>("box", {"Corners=1,0 : 3,1", "Subdivisions=2,1"}, "axisymmetric", degree) +
        Lines{"Loads/Names=inside",
              "Loads/inside/Boundaries=body.left",
              "Loads/inside/Pressure=1"});
      CHECK(work_of_loads(axial, 1, [](const Point<2> &x) {
              return Tensor<1, 2>({x[0], 0.});
            }) == doctest::Approx(2 * numbers::PI).epsilon(1e-13));
    }
}
