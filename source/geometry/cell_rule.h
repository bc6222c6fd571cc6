// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/grid/reference_cell.h>

namespace Signorini
{
  /// @return the rule of a cell or face: Gauss points with n in each direction on hypercubes, which
  /// integrate polynomials of degree 2n - 1 in each coordinate; on simplices points that integrate
  /// all polynomials of total degree 2n - 1 (F. D. Witherden, P. E. Vincent: On the identification
  /// of symmetric quadrature rules for finite element methods, Computers & Mathematics with
  /// Applications 69 (2015) 1232). All weights are positive. Rules are made at the first call and
  /// kept.
  /// @param cell the reference cell, a hypercube or a simplex
  /// @param n at least 1; at most 5 for tetrahedra
  template <int dim>
  const dealii::Quadrature<dim> &
  cell_rule(const dealii::ReferenceCell &cell, unsigned int n);
} // namespace Signorini
