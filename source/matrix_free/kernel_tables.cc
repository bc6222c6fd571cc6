// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/kernel_tables.h"

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



  template struct KernelTables<float, 1>;
  template struct KernelTables<float, 2>;
  template struct KernelTables<double, 1>;
  template struct KernelTables<double, 2>;
} // namespace Signorini
