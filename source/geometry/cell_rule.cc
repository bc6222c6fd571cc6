// SPDX-License-Identifier: Apache-2.0
#include "geometry/cell_rule.h"

#include <deal.II/base/quadrature_lib.h>

#include <vector>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    Quadrature<dim>
    rule_of(const ReferenceCell &cell, const unsigned int n)
    {
      if (cell.is_hyper_cube())
        return QGauss<dim>(n);
      // Beyond the tables, the rule of a square mapped to the triangle, with its Jacobian.
      if constexpr (dim == 2)
        if (constexpr unsigned int most = 7; n > most)
          return QDuffy(n + 1, 1.);
      return QWitherdenVincentSimplex<dim>(n);
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
