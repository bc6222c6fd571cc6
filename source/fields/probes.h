// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/point_state.h"
#include <signorini/contact/pair.h>
#include <signorini/fields/probe.h>

#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// The solution at a probe.
  template <int dim>
  struct ProbeValue
  {
    std::string            name;
    dealii::Tensor<1, dim> displacement;
    /// Cauchy stress, positive in tension.
    dealii::SymmetricTensor<2, 3> stress;
    dealii::SymmetricTensor<2, 3> strain; ///< see Elasticity::strain()
    double                        von_mises = 0;
    bool                          found     = false;
  };

  /// Throws SceneError for points outside of their body or beside the slave of their pair, and for
  /// names that do not exist. Collective.
  /// @param elasticity the model
  /// @param pairs of the scene
  /// @param probes of the scene
  /// @param tolerance allowed distance in units of a cell (curved surfaces move when the mesh is
  /// refined)
  template <int dim>
  void
  check_probes(const Elasticity<dim>               &elasticity,
               const std::vector<ContactPair<dim>> &pairs,
               const std::vector<Probe<dim>>       &probes,
               double                               tolerance);

  /// @return the index of the pair of a probe on a slave surface. Throws SceneError if there is
  /// none of that name.
  /// @param probe the probe
  /// @param pairs of the scene
  template <int dim>
  unsigned int
  pair_of(const Probe<dim> &probe, const std::vector<ContactPair<dim>> &pairs);

  /// @return displacement and stress at each probe, a point in a body, the same on all ranks and
  /// independent of their number. The values are means over the cells of one body that share the
  /// point; if several bodies share it, those of the first one. Throws SceneError for a point that
  /// is farther than probe_tolerance outside of the cells. Collective.
  /// @param elasticity the model
  /// @param displacement without ghost values
  /// @param probes points in bodies
  template <int dim>
  std::vector<ProbeValue<dim>>
  evaluate_probes(const Elasticity<dim>         &elasticity,
                  const LA::Vector              &displacement,
                  const std::vector<Probe<dim>> &probes);

  /// @return the derivative of of_displacement . u + of_stress : sigma at a probe, in the sense of
  /// evaluate_probes(). The point must be in its body. Collective.
  /// @param elasticity the model
  /// @param displacement without ghost values
  /// @param probe a point in a body
  /// @param of_displacement weights of the components of the displacement
  /// @param of_stress weights of the stress components
  template <int dim>
  PointDerivative
  probe_functional(const Elasticity<dim>               &elasticity,
                   const LA::Vector                    &displacement,
                   const Probe<dim>                    &probe,
                   const dealii::Tensor<1, dim>        &of_displacement,
                   const dealii::SymmetricTensor<2, 3> &of_stress);
} // namespace Signorini
