// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"

#include <functional>

namespace Signorini
{
  /// @return the recovered Cauchy stress at a probe, (8.5). Collective.
  template <int dim>
  dealii::SymmetricTensor<2, 3>
  recovered_stress(const Snapshot<dim> &s, const Probe<dim> &probe);

  // Evaluation of all kinds of quantities that quantity.cc lists. Each function returns value and
  // derivative of the quantity with a name at a solution; all are collective.

  /// The contact force of a pair, the sum of pressure times area times normal: its norm or a
  /// component [force].
  template <int dim>
  Functional
  pair_force(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The integral of the pressure of a pair [force].
  template <int dim>
  Functional
  normal_force(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The normal force over the contact area [stress].
  template <int dim>
  Functional
  mean_pressure(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The largest nodal pressure of a pair, as in the results [stress]. Regularised: its derivative
  /// is that of the mean over a face around the node.
  template <int dim>
  Functional
  largest_pressure(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The contact area of a pair [area]. Regularised: its derivative is that of the integral of p/(p
  /// + a quarter of its mean), (8.4).
  template <int dim>
  Functional
  contact_area(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The largest semi-axis of the contact zone, or its radius in axisymmetric models [length].
  template <int dim>
  Functional
  half_width(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The radius of a circle with the area of contact [length].
  template <int dim>
  Functional
  contact_radius(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The force of a support on the bodies, its norm or a component [force].
  template <int dim>
  Functional
  reaction(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The displacement of an obstacle, its norm or a component [length].
  template <int dim>
  Functional
  motion(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The displacement at a point, its norm or a component [length].
  template <int dim>
  Functional
  probe_displacement(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes);

  /// A stress component at a point [stress].
  template <int dim>
  Functional
  probe_stress(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes);

  /// The von Mises stress at a point [stress].
  template <int dim>
  Functional
  probe_von_mises(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes);

  /// The largest von Mises stress of a body, as in the results [stress].
  template <int dim>
  Functional
  largest_von_mises(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The recovered pressure at the point of the slave that is closest to a probe [stress].
  /// Regularised: its derivative is that of the mean over a face around the point.
  template <int dim>
  Functional
  probe_pressure(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes);

  /// The part of the contact force of a pair that is due to tangential tractions: its norm or a
  /// component [force].
  template <int dim>
  Functional
  friction_force(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The area of a pair in which points stick [area]. Regularised: its derivative is that of the
  /// integral of m/(m + a quarter of its mean) with m = mu p - |t|.
  template <int dim>
  Functional
  stick_area(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The largest slip of a pair since its points came into contact [length].
  template <int dim>
  Functional
  largest_slip(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The work that friction of a pair has taken in all load steps [force*length]. Its derivative is
  /// that of the last load step.
  template <int dim>
  Functional
  friction_work(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The elastic energy of all bodies, half of int sigma:eps dV.
  template <int dim>
  Functional
  energy(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  // Functions that several of them use.

  /// @return the index of the pair with a name, which exists.
  template <int dim>
  unsigned int
  number_of_pair(const Snapshot<dim> &s, const std::string &name);

  /// Call visit(row) for all locally owned contact points of a pair.
  template <int dim>
  void
  for_rows(const Snapshot<dim>                                        &s,
           unsigned int                                                pair,
           const std::function<void(dealii::types::global_dof_index)> &visit);

  /// Add a component of the friction force of a pair to a functional, if there is friction.
  /// @param d number of the component
  /// @param sign factor
  template <int dim>
  void
  add_friction_force(
    const Snapshot<dim> &s, unsigned int pair, unsigned int d, double sign, Functional &sum);

  /// @return a functional with the value 0 and zero derivatives of the right size.
  template <int dim>
  Functional
  zero_functional(const Snapshot<dim> &s);

  /// @return the number of a component: x, y, z are 0, 1, 2.
  unsigned int
  component_number(const std::string &component);

  /// @return the functional that a name denotes: a component of a vector, or its norm |F| with the
  /// derivative F/|F| . F'.
  Functional
  size_or_component(const QuantityName &name, const std::vector<Functional> &components);
} // namespace Signorini
