// SPDX-License-Identifier: Apache-2.0
// The functions of the pressure on the slave, on faces of all kinds.

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "contact_cases.h"
#include <Eigen/Dense>

using namespace TestScene;

namespace
{
  using Matrix = std::map<std::pair<types::global_dof_index, types::global_dof_index>, double>;

  /// On one face: int psi_i phi_j dA, int phi_j dA and int psi_i dA.
  struct Integrals
  {
    Matrix                                    products;
    std::map<types::global_dof_index, double> phi, psi;
    double                                    area = 0;
  };

  template <int dim>
  std::map<unsigned int, Integrals>
  integrals(const ContactSurface<dim> &surface)
  {
    std::map<unsigned int, Integrals> faces;
    for (const ContactPoint<dim> &point : surface.points)
      {
        Integrals &face = faces[point.face];
        face.area += point.weight;
        const SparseRow &shape =
          point.interpolation.empty() ? point.multiplier_shape : point.interpolation;
        for (const auto &[j, phi] : shape)
          face.phi[j] += point.weight * phi;
        for (const auto &[i, psi] : point.multiplier_shape)
          {
            face.psi[i] += point.weight * psi;
            for (const auto &[j, phi] : shape)
              face.products[{i, j}] += point.weight * psi * phi;
          }
      }
    return faces;
  }

  template <int dim>
  double
  sum_at(const SparseRow &row)
  {
    double sum = 0;
    for (const auto &entry : row)
      sum += entry.second;
    return sum;
  }

  /// @param covered the area of the slave that has a projection
  template <int dim>
  void
  check_basis(const Lines &lines, const std::string &degree, const double covered)
  {
    CAPTURE(dim);
    CAPTURE(degree);
    SmallScene<dim> scene(lines +
                          Lines{"Dimension=" + std::to_string(dim), "Mesh/Degree=" + degree});
    for (const std::string basis : {"dual", "standard"})
      {
        CAPTURE(basis);
        scene.use({"Method=Lagrange multiplier", "Pressure basis=" + basis});
        double       area = 0;
        unsigned int n    = 0;
        for (const auto &point : scene.contact->surfaces()[0].points)
          CHECK(std::abs(sum_at<dim>(point.multiplier_shape) - 1) < 1e-12);
        for (const auto &[number, face] : integrals(scene.contact->surfaces()[0]))
          {
            area += face.area;
            for (const auto &[pair, value] : face.products)
              {
                const auto [i, j]     = pair;
                const double expected = i == j ? face.phi.at(j) : 0;
                if (basis == "dual")
                  CHECK(std::abs(value - expected) < 1e-12 * face.area);
                n += i != j && std::abs(value) > 1e-3 * face.area;
              }
            // Both bases give nodes the same areas.
            for (const auto &[i, value] : face.psi)
              CHECK(value == doctest::Approx(face.phi.at(i)).epsilon(1e-11));
          }
        // The standard one is not diagonal.
        CHECK((Utilities::MPI::sum(n, MPI_COMM_WORLD) > 0) == (basis == "standard"));
        CHECK(Utilities::MPI::sum(area, MPI_COMM_WORLD) == doctest::Approx(covered).epsilon(1e-3));
      }
  }
} // namespace



TEST_CASE("the dual basis is dual on distorted, curved and partly covered faces")
{
  const Lines plane = fixed("lower.bottom, upper.top", "0; 0"),
              space = fixed("lower.bottom, upper.top", "0; 0; 0");
  // A third of the last face hangs over: with degree 2 too much for functions that are bounded.
  check_basis<2>(boxes("0,0 : 1,1", "3,1", "0.5,1 : 1.1,2", "2,1") + plane, "1", 0.5);
  for (const std::string degree : {"1", "2"})
    {
      // A seventh; in space also sideways, and the faces are no parallelograms.
      check_basis<2>(boxes("0,0 : 1,1", "3,1", "0.4,1 : 1.03,2", "3,1") + plane, degree, 0.6);
      check_basis<3>(boxes("0,0,0 : 1,1,1", "2,3,1", "0.4,0,1 : 1.03,1,2", "2,2,1") + space +
                       Lines{"Bodies/upper/Transformation=x; y*(1+0.05*x); z"},
                     degree,
                     0.6);
      // Weights by the circumference: pi (1.95^2 - 1).
      check_basis<2>(boxes("0,0 : 1.95,1", "3,1", "1,1 : 2,2", "2,1") +
                       fixed("lower.bottom, upper.top", "free; 0") + Lines{"Model=axisymmetric"},
                     degree,
                     numbers::PI * (1.95 * 1.95 - 1));
      // Curved.
      const Case ring = cases_2d()[1];
      check_basis<2>(ring.lines, degree, 2 * numbers::PI);
    }
  check_basis<3>(materials("ball", "shell") + pair("ball.sphere", "shell.inner") +
                   fixed("shell.outer", "0; 0; 0") +
                   Lines{"Bodies/ball/Mesh=sphere",
                         "Bodies/ball/Radius=1",
                         "Bodies/ball/Part=lower quarter",
                         "Bodies/shell/Mesh=shell",
                         "Bodies/shell/Inner radius=1.001",
                         "Bodies/shell/Outer radius=2",
                         "Bodies/shell/Part=lower quarter",
                         "Bodies/shell/Cells along 45 degrees=2",
                         "Bodies/shell/Cells through=1"},
                 "1",
                 numbers::PI / 2);
}
