// SPDX-License-Identifier: Apache-2.0
// The weak forms once more, straight from their definitions: all indices of the tensors, points one
// by one, and what the program does for speed left out.
#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include "small_scene.h"

namespace TestScene
{
  /// int sigma(u) : eps(v) dV of a cell, from the elasticity tensor C_ijkl.
  template <int dim>
  FullMatrix<double>
  reference_matrix(const FEValues<dim> &values, Model model, const Material &material);

  /// int sigma(u) : eps(w) dV - int b.w dV - int t.w dA over all bodies at time t.
  /// @param u, w all degrees of freedom, with those that are constrained
  template <int dim>
  double
  reference_work(const SmallScene<dim> &scene, const Values &u, const Values &w, double t);

  /// The contact of a scene, point by point of its surfaces. Places are where the method imposes
  /// contact, and have the number of their row in the gap operator. Values are on all ranks.
  template <int dim>
  class ReferenceContact
  {
  public:
    explicit ReferenceContact(const SmallScene<dim> &scene);

    Values
    gap(const Values &u) const;

    Values
    stress(const Values &u) const;

    /// The virtual work of the pressures p: -int p g'(w) dA, with Nitsche's method
    /// - theta int (s - p)/eps s(w) dA as well.
    double
    work(const Values &p, const Values &s, const Values &w) const;

    Values area, stiffness, epsilon;

  private:
    /// Over the shares of the places.
    template <typename F>
    Values
    mean(const F &f) const;

    const std::vector<ContactSurface<dim>>                                &surfaces;
    const double                                                           theta;
    std::vector<std::vector<std::vector<std::pair<unsigned int, double>>>> shares;
  };
} // namespace TestScene
