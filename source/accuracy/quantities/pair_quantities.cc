// SPDX-License-Identifier: Apache-2.0
#include "accuracy/quantities/kinds.h"
#include "fields/contact_patch.h"
#include "fields/nodal_fields.h"
#include "fields/peak.h"
#include "fields/probes.h"
#include "fields/recovered_pressure.h"
#include "fields/surface_probes.h"
#include <signorini/solid/model.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  unsigned int
  number_of_pair(const Snapshot<dim> &s, const std::string &name)
  {
    unsigned int pair = 0;
    while (s.pairs[pair].name != name)
      ++pair;
    return pair;
  }



  template <int dim>
  void
  for_rows(const Snapshot<dim>                                &s,
           const unsigned int                                  pair,
           const std::function<void(types::global_dof_index)> &visit)
  {
    auto which = s.contact.origin.pair.begin();
    for (const auto i : s.pressure.locally_owned_elements())
      if (*which++ == pair)
        visit(i);
  }



  namespace
  {
    /// @return the functional that is the sum of weight(i) times pressure over the contact points
    /// of a pair.
    template <int dim>
    Functional
    weighted_pressure(const Snapshot<dim>                                    &s,
                      const unsigned int                                      pair,
                      const std::function<double(types::global_dof_index i)> &weight)
    {
      Functional result = zero_functional(s);
      for_rows<dim>(s, pair, [&](const auto i) { result.of_traction[0](i) = weight(i); });
      result.of_traction[0].compress(VectorOperation::insert);
      result.value = result.of_traction[0] * s.pressure;
      return result;
    }

    /// @return the contact zone of a pair, by its recovered pressure.
    template <int dim>
    ContactPatch
    patch_of(const Snapshot<dim> &s, const unsigned int pair)
    {
      return contact_patch(s, pair, recovered_pressure(s, pair));
    }

    /// @return a quantity that is a power of the contact area (1: area, 1/2: radius) with the given
    /// value. Its derivative is that of int p/(p + c) dA, (8.4), with c a quarter of the mean
    /// pressure, which is largest where pressures are small, at the edge of contact. It is scaled
    /// such that a relative error of the area becomes the corresponding relative error of the
    /// quantity.
    template <int dim>
    Functional
    as_area(const Snapshot<dim> &s,
            const unsigned int   pair,
            const ContactPatch  &patch,
            const double         value,
            const double         power)
    {
      // The uncertainty of the edge of contact, in widths of a face.
      const double sharpness = samples_nodes(s.contact) ? 0.15 : 0.5;
      double       force = 0, area = 0;
      for_rows<dim>(s, pair, [&](const auto i) {
        if (s.pressure(i) > 0)
          {
            force += s.contact.weight(i) * s.pressure(i);
            area += s.contact.weight(i);
          }
      });
      const MPI_Comm comm   = s.elasticity.mesh().communicator();
      force                 = Utilities::MPI::sum(force, comm);
      area                  = Utilities::MPI::sum(area, comm);
      const double c        = area > 0 ? force / (4 * area) : 1;
      double       own      = 0;
      Functional   result   = weighted_pressure<dim>(s, pair, [&](const auto i) {
        const double p = std::max(0., s.pressure(i));
        own += s.contact.weight(i) * p / (p + c);
        return s.contact.weight(i) * c / ((p + c) * (p + c));
      });
      const double smoothed = Utilities::MPI::sum(own, comm);
      result.value          = value;
      result.is_regularised = true;
      if (patch.area > 0)
        result.unresolved = sharpness * power * value * patch.edge / patch.area;
      if (smoothed > 0)
        result.of_traction[0] *= power * value / smoothed;
      return result;
    }
  } // namespace



  template <int dim>
  Functional
  pair_force(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const unsigned int      pair = number_of_pair(s, name.of);
    const double            sign = s.pairs[pair].exchanged ? -1 : 1;
    std::vector<Functional> components;
    for (unsigned int d = 0; d < dim; ++d)
      {
        // Radial forces balance around the axis of an axisymmetric model.
        const bool is_zero = d == 0 && s.elasticity.model() == Model::axisymmetric;
        components.push_back(weighted_pressure<dim>(s, pair, [&](const auto i) {
          return is_zero ? 0. : sign * s.contact.weight(i) * s.contact.geometry.normal[d](i);
        }));
        if (!is_zero)
          add_friction_force(s, pair, d, sign, components.back());
      }
    return size_or_component(name, components);
  }



  template <int dim>
  Functional
  normal_force(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    return weighted_pressure<dim>(s, number_of_pair(s, name.of), [&](const auto i) {
      return s.contact.weight(i);
    });
  }



  // The quotient rule: the force divided by the area, whose derivative is regularised.
  template <int dim>
  Functional
  mean_pressure(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes)
  {
    const unsigned int pair   = number_of_pair(s, name.of);
    const ContactPatch patch  = patch_of(s, pair);
    Functional         result = normal_force(name, s, probes);
    if (patch.area == 0)
      return result;
    const double mean = result.value / patch.area;
    // Where the whole surface is in contact, the area does not change.
    if (patch.edge > 0)
      {
        const Functional area = as_area(s, pair, patch, patch.area, 1.);
        result.of_traction[0].add(-mean, area.of_traction[0]);
        result.unresolved     = mean / patch.area * area.unresolved;
        result.is_regularised = true;
      }
    result.of_traction[0] /= patch.area;
    result.value = mean;
    return result;
  }



  namespace
  {
    /// @return the mean pressure around a point, with weights that decrease linearly to zero at the
    /// distance of the largest face; that is doubled until there are contact points.
    template <int dim>
    Functional
    weighted_pressure_near(const Snapshot<dim>  &s,
                           const unsigned int    pair,
                           const Tensor<1, dim> &place)
    {
      constexpr unsigned int most_doublings = 10; // faces differ in size
      const MPI_Comm         comm           = s.elasticity.mesh().communicator();
      double                 size = Utilities::MPI::max(s.surfaces[pair].face_size, comm), area = 0;
      Functional             result;
      for (unsigned int i = 0; i < most_doublings && area == 0; ++i, size *= 2)
        {
          result = weighted_pressure<dim>(s, pair, [&](const auto row) {
            Tensor<1, dim> x;
            for (unsigned int d = 0; d < dim; ++d)
              x[d] = s.contact.geometry.position[d](row);
            const double share = std::max(0., 1 - (x - place).norm() / size);
            area += share * s.contact.weight(row);
            return share * s.contact.weight(row);
          });
          area   = Utilities::MPI::sum(area, comm);
        }
      if (area > 0)
        result.of_traction[0] /= area;
      result.is_regularised = true;
      return result;
    }

    /// @return whether the node at a point is on a face that has a node without pressure function.
    /// The function of a node then represents both, which a dual solution for this node alone does
    /// not take into account. Collective.
    template <int dim>
    bool
    is_beside_dirichlet_node(const Snapshot<dim>  &s,
                             const unsigned int    pair,
                             const Tensor<1, dim> &place)
    {
      bool is_beside = false;
      for (const SlaveFace<dim> &face : s.surfaces[pair].slave_faces)
        {
          const bool is_near =
            std::any_of(face.positions.begin(), face.positions.end(), [&](const Point<dim> &node) {
              return (node - place).norm() < 1e-10 * s.elasticity.mesh().size();
            });
          is_beside |= is_near && std::find(face.without_pressure.begin(),
                                            face.without_pressure.end(),
                                            true) != face.without_pressure.end();
        }
      return Utilities::MPI::max(is_beside ? 1 : 0, s.elasticity.mesh().communicator()) == 1;
    }

    /// @return the possible relative error of the largest pressure because the mesh does not
    /// resolve its peak. For peaks that are not resolved at all, the neighbours say little about
    /// the height.
    double
    unknown_share(const double sharpness)
    {
      return 0.5 * sharpness + 20 * std::max(0., sharpness - sharp_peak);
    }
  } // namespace



  // With nodal sampling the derivative is that of the pressure of one node, otherwise of the mean
  // around the point; the value is the one in the results.
  template <int dim>
  Functional
  largest_pressure(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const unsigned int pair  = number_of_pair(s, name.of);
    const MPI_Comm     comm  = s.elasticity.mesh().communicator();
    const LA::Vector  &nodal = recovered_pressure(s, pair);
    // The contact point with the largest pressure on all ranks; of equal ones the first.
    double                  largest = -std::numeric_limits<double>::max();
    types::global_dof_index row     = numbers::invalid_dof_index;
    for_rows<dim>(s, pair, [&](const auto i) {
      if (s.contact.weight(i) > 0 && s.pressure(i) > largest)
        {
          largest = s.pressure(i);
          row     = i;
        }
    });
    const double everywhere = Utilities::MPI::max(largest, comm);
    row = Utilities::MPI::min(largest == everywhere ? row : numbers::invalid_dof_index, comm);
    Tensor<1, dim> place;
    if (s.pressure.in_local_range(row))
      for (unsigned int d = 0; d < dim; ++d)
        place[d] = s.contact.geometry.position[d](row);
    place = Utilities::MPI::sum(place, comm);

    const bool is_nodal = samples_nodes(s.contact) && row != numbers::invalid_dof_index &&
                          !is_beside_dirichlet_node(s, pair, place);
    Functional result = is_nodal ? zero_functional(s) : weighted_pressure_near(s, pair, place);
    if (is_nodal)
      {
        result.is_regularised = true;
        if (s.pressure.in_local_range(row))
          result.of_traction[0](row) = 1;
        result.of_traction[0].compress(VectorOperation::insert);
      }
    result.value      = largest_pressure(s, pair, nodal, contact_patch(s, pair, nodal));
    result.unresolved = unknown_share(sharpness_of_peak(s, pair, nodal)) * result.value;
    return result;
  }



  template <int dim>
  Functional
  probe_pressure(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes)
  {
    const Probe<dim>       &probe = probe_named(probes, name.of);
    const unsigned int      pair  = pair_of(probe, s.pairs);
    const SurfaceValue<dim> at = evaluate_on_slave(s, pair, {probe.point}, probe.title()).front();
    Functional              result = weighted_pressure_near(s, pair, Tensor<1, dim>(at.place));
    result.value                   = at.pressure;
    // The dual solution is that of a mean, and says nothing of how the pressure varies about it.
    // The recovered stress of the slave tells another pressure at the point.
    Tensor<1, dim> normal;
    for (unsigned int d = 0; d < dim; ++d)
      normal[d] = result.of_traction[0] * s.contact.geometry.normal[d];
    Probe<dim> in_slave;
    in_slave.body  = s.pairs[pair].slave.substr(0, s.pairs[pair].slave.find('.'));
    in_slave.point = at.place;
    const SymmetricTensor<2, 3> stress = recovered_stress(s, in_slave);
    double                      other  = 0;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        other -= normal[d] * stress[d][e] * normal[e] / std::max(normal.norm_square(), 1e-30);
    // Recovered stresses of open surfaces may be tensile; only those of ties are.
    if (result.value >= 0)
      other = std::max(0., other);
    result.unresolved = 2 * std::abs(other - result.value);
    return result;
  }



  template <int dim>
  Functional
  contact_area(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const unsigned int pair  = number_of_pair(s, name.of);
    const ContactPatch patch = patch_of(s, pair);
    return as_area(s, pair, patch, patch.area, 1.);
  }



  template <int dim>
  Functional
  half_width(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes)
  {
    const unsigned int pair  = number_of_pair(s, name.of);
    const ContactPatch patch = patch_of(s, pair);
    if (patch.semi_axes.empty()) // axisymmetric, or no contact
      return contact_radius(name, s, probes);
    return as_area(s, pair, patch, patch.semi_axes.front(), dim == 2 ? 1. : 0.5);
  }



  template <int dim>
  Functional
  contact_radius(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const unsigned int pair  = number_of_pair(s, name.of);
    const ContactPatch patch = patch_of(s, pair);
    return as_area(s, pair, patch, std::sqrt(patch.area / numbers::PI), 0.5);
  }



#define INSTANTIATE(quantity)                                                                      \
  template Functional quantity(const QuantityName &, const Snapshot<2> &, const Probes<2> &);      \
  template Functional quantity(const QuantityName &, const Snapshot<3> &, const Probes<3> &);
  INSTANTIATE(pair_force)
  INSTANTIATE(normal_force)
  INSTANTIATE(mean_pressure)
  INSTANTIATE(largest_pressure)
  INSTANTIATE(contact_area)
  INSTANTIATE(half_width)
  INSTANTIATE(contact_radius)
  INSTANTIATE(probe_pressure)
#undef INSTANTIATE
#define INSTANTIATE(dim)                                                                           \
  template unsigned int number_of_pair(const Snapshot<dim> &, const std::string &);                \
  template void         for_rows(const Snapshot<dim> &,                                            \
                                 unsigned int,                                                     \
                                 const std::function<void(types::global_dof_index)> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
