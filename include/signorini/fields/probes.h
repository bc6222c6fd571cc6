#pragma once

#include <signorini/elasticity/elasticity.h>
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

  /// Throws SceneError for a probe that lies outside of its body by more than that share of a cell
  /// (on a mesh that is to be refined, curved surfaces move). Collective.
  template <int dim>
  void
  check_probes(const Elasticity<dim>         &elasticity,
               const std::vector<Probe<dim>> &probes,
               double                         tolerance);

  /// What is allowed for a probe on the final mesh.
  constexpr double probe_tolerance = 0.02;

  /// Displacement and stress at each probe, the same on all ranks and independent of their number.
  /// Cells that share the point give their mean; where bodies do, it is that of the first body. As
  /// meshes of curved bodies leave out points near their true surface, a point may lie outside its
  /// cell by 2 % of the cell. Throws SceneError for one that lies farther outside. Collective.
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
