// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/kernel_tables.h"

#include "geometry/cell_rule.h"

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

namespace Signorini
{
  using namespace dealii;

  // Values of the nodal shape functions at the Gauss points of a line, and derivatives there of the
  // polynomials through the Gauss points.
  template <typename Number, int degree>
  KernelTables<Number, degree>::KernelTables()
  {
    const QGauss<1> rule(n);
    const auto      of_nodes  = Polynomials::LagrangeEquidistant::generate_complete_basis(degree);
    const auto      of_points = Polynomials::generate_complete_Lagrange_basis(rule.get_points());
    for (int q = 0; q < n; ++q)
      {
        // Nodes are equidistant, as in elements of degree 1 and 2; the number of Gauss points on a
        // line is that of the nodes.
        const double x = rule.point(q)[0];
        weights[q]     = rule.weight(q);
        for (int i = 0; i < n; ++i)
          {
            values[q][i]      = of_nodes[i].value(x);
            derivatives[q][i] = of_points[i].derivative().value(x);
          }
      }
  }



  template <typename Number, int degree>
  SimplexTables<Number, degree>::SimplexTables()
  {
    if constexpr (degree == 1)
      {
        values[0][0] = 1;
        weights[0]   = Number(1. / 6);
      }
    else
      {
        const Quadrature<3> &rule = cell_rule<3>(ReferenceCells::Tetrahedron, degree + 1);
        AssertThrow(rule.size() == n_points, ExcInternalError());
        for (int q = 0; q < n_points; ++q)
          {
            weights[q]   = rule.weight(q);
            values[q][0] = 1;
            for (int d = 0; d < 3; ++d)
              {
                values[q][d + 1] = rule.point(q)[d];
                values[q][0] -= values[q][d + 1];
              }
          }
      }
  }



  template struct KernelTables<float, 1>;
  template struct KernelTables<float, 2>;
  template struct KernelTables<double, 1>;
  template struct KernelTables<double, 2>;
  template struct SimplexTables<float, 1>;
  template struct SimplexTables<float, 2>;
  template struct SimplexTables<double, 1>;
  template struct SimplexTables<double, 2>;
} // namespace Signorini
