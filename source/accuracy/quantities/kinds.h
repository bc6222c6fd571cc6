// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"

namespace Signorini
{
  // What quantity.cc lists. All collective.

  /// The contact force of a pair: sum of pressure times area times normal, its norm or a component.
  template <int dim>
  Functional
  pair_force(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// Pressure times area.
  template <int dim>
  Functional
  normal_force(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// Normal force over contact area.
  template <int dim>
  Functional
  mean_pressure(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// At nodes, as in the results. Regularised: the mean over a face about it.
  template <int dim>
  Functional
  largest_pressure(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The contact area, regularised: the integral of p/(p + a quarter of its mean).
  template <int dim>
  Functional
  contact_area(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The largest semi-axis of the zone; the radius if it is axisymmetric.
  template <int dim>
  Functional
  half_width(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// The radius of the circle with the area of contact.
  template <int dim>
  Functional
  contact_radius(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// Force of a support on the bodies, its size or a component.
  template <int dim>
  Functional
  reaction(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  /// Displacement of an obstacle, its size or a component.
  template <int dim>
  Functional
  motion(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  template <int dim>
  Functional
  probe_displacement(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes);

  template <int dim>
  Functional
  probe_stress(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes);

  template <int dim>
  Functional
  probe_von_mises(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes);

  /// Recovered, where the slave is closest. Regularised: the mean over a face about it.
  template <int dim>
  Functional
  probe_pressure(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes);

  /// Elastic energy of all bodies: half of int sigma:eps dV.
  template <int dim>
  Functional
  energy(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &);

  // What several of them need.

  /// All derivatives zero.
  template <int dim>
  Functional
  zero_functional(const Snapshot<dim> &s);

  /// x, y, z -> 0, 1, 2
  unsigned int
  component_number(const std::string &component);

  /// What a name means by a vector whose components are functionals: one of them, or its size |F|,
  /// with the derivative F/|F| . F'.
  Functional
  size_or_component(const QuantityName &name, const std::vector<Functional> &components);
} // namespace Signorini
