// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include <signorini/contact/pair.h>
#include <signorini/fields/probe.h>

#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

namespace Signorini
{
  template <int dim>
  struct ProbeValue
  {
    std::string                   name;
    dealii::Tensor<1, dim>        displacement;
    dealii::SymmetricTensor<2, 3> stress; ///< tension positive
    double                        von_mises = 0;
    bool                          found     = false;
  };

  /// Throws SceneError for a point that lies outside of its body by more than that share of a cell
  /// (on a mesh that is to be refined, curved surfaces move), or beside the slave of its pair, and
  /// for names that are none. Collective.
  template <int dim>
  void
  check_probes(const Elasticity<dim>               &elasticity,
               const std::vector<ContactPair<dim>> &pairs,
               const std::vector<Probe<dim>>       &probes,
               double                               tolerance);

  /// The pair of a probe that is on one. Throws SceneError if there is none of that name.
  template <int dim>
  unsigned int
  pair_of(const Probe<dim> &probe, const std::vector<ContactPair<dim>> &pairs);

  /// Displacement and stress at each probe, a point in a body, the same on all ranks and
  /// independent of their number. Cells that share the point give their mean; where bodies do, it
  /// is that of the first body. A point may lie outside its cell by probe_tolerance. Throws
  /// SceneError for one that lies farther outside. Collective.
  /// @param displacement without ghosts
  template <int dim>
  std::vector<ProbeValue<dim>>
  evaluate_probes(const Elasticity<dim>         &elasticity,
                  const LA::Vector              &displacement,
                  const std::vector<Probe<dim>> &probes);

  /// The derivative of of_displacement . u + of_stress : sigma at a probe, as evaluate_probes()
  /// says it, by the free degrees of freedom. The point has to lie in its body. Collective.
  template <int dim>
  LA::Vector
  probe_functional(const Elasticity<dim>               &elasticity,
                   const Probe<dim>                    &probe,
                   const dealii::Tensor<1, dim>        &of_displacement,
                   const dealii::SymmetricTensor<2, 3> &of_stress);
} // namespace Signorini
