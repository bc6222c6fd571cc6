// SPDX-License-Identifier: Apache-2.0
#include "geometry/cell_rule.h"

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <vector>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the image of Gauss points under the map that collapses one side of the square, or
    /// one face and one edge of the cube: x_d = s_d (1 - x_0) ... up to the coordinates before.
    template <int dim>
    Quadrature<dim>
    collapsed_rule(const unsigned int n)
    {
      // The Jacobian is a polynomial of degree dim - 1 in one coordinate: one point more.
      const QGauss<dim>       rule(n + 1);
      std::vector<Point<dim>> points  = rule.get_points();
      std::vector<double>     weights = rule.get_weights();
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          double rest = 1;
          for (unsigned int d = 0; d < dim; ++d)
            {
              points[q][d] = rest * rule.point(q)[d];
              weights[q] *= d + 1 < dim ? std::pow(1 - rule.point(q)[d], dim - 1. - d) : 1.;
              rest *= 1 - rule.point(q)[d];
            }
        }
      return Quadrature<dim>(points, weights);
    }

    template <int dim>
    Quadrature<dim>
    rule_of(const ReferenceCell &cell, const unsigned int n)
    {
      constexpr unsigned int most = 5; // of the tables of deal.II
      if (cell.is_hyper_cube())
        return QGauss<dim>(n);
      if (n <= most)
        return QWitherdenVincentSimplex<dim>(n);
      return collapsed_rule<dim>(n);
    }
  } // namespace



  template <int dim>
  const Quadrature<dim> &
  cell_rule(const ReferenceCell &cell, const unsigned int n)
  {
    static std::vector<Quadrature<dim>> cubes, simplices;
    // The lists do not grow, so that references stay valid.
    constexpr unsigned int most  = 64;
    auto                  &rules = cell.is_hyper_cube() ? cubes : simplices;
    if (rules.empty())
      rules.resize(most);
    AssertIndexRange(n, most);
    if (rules[n].size() == 0)
      rules[n] = rule_of<dim>(cell, n);
    return rules[n];
  }



  template const Quadrature<1> &
  cell_rule(const ReferenceCell &, unsigned int);
  template const Quadrature<2> &
  cell_rule(const ReferenceCell &, unsigned int);
  template const Quadrature<3> &
  cell_rule(const ReferenceCell &, unsigned int);
} // namespace Signorini
