// SPDX-License-Identifier: Apache-2.0
// Quantities of pairs with friction. They are zero where there is none.
#include "accuracy/quantities/kinds.h"
#include "fields/contact_patch.h"
#include "fields/friction_fields.h"
#include "fields/nodal_fields.h"
#include <signorini/solid/model.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the slip that a mesh may miss where a point sticks: an elastic displacement over the
    /// size of a face. Meshes that do not resolve partial slip have none at all.
    template <int dim>
    double
    missed_slip(const Snapshot<dim> &s, const types::global_dof_index i)
    {
      return status_of(s.contact_state.status(i)) == ContactStatus::stick ?
               length_at(s.contact_state.traction, i, 1) / s.contact.coefficients.stiffness(i) :
               0.;
    }

    /// @return the share of the zone of stick in which slip may be missed: half of that at its
    /// edge, or one for zones of few faces. Collective.
    template <int dim>
    double
    share_at_edge(const Snapshot<dim> &s, const unsigned int pair)
    {
      const ContactPatch stick = stick_zone(s, pair);
      return stick.edge < stick.area ? 0.5 * stick.edge / stick.area : 1.;
    }

    /// @return the size of the slip between the closed point where it is largest and the place
    /// where it would be larger still. Towards the edge of contact, where slips mostly are largest,
    /// slip grows within a face by about half of its change across the faces about that point;
    /// towards other edges, of a body or a master, by less, but it is singular there. Collective.
    template <int dim>
    double
    slip_beyond(const Snapshot<dim> &s, const unsigned int pair)
    {
      constexpr double        at_edge = 0.5, nearly = 0.999;
      const double            at_points = samples_nodes(s.contact) ? 0.15 : 0.4;
      std::vector<LA::Vector> nodal;
      for (const LA::Vector &component : slip_since_contact(s, pair))
        nodal.push_back(s.elasticity.with_ghosts(component));
      const LA::Vector closed = s.elasticity.with_ghosts(nodal_field(s, s.active, pair));
      const auto       at     = [&](const types::global_dof_index node) {
        Tensor<1, dim> result;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = nodal[d](node);
        return result;
      };
      // Of each node: the changes across its faces, their number, and that of faces at the edge.
      LA::Vector change = s.elasticity.zero_vector(), count = change, open = change;
      double     most = 0;
      for (const SlaveFace<dim> &face : s.surfaces[pair].slave_faces)
        {
          std::vector<types::global_dof_index> inside;
          for (const auto node : face.nodes)
            if (closed(node) > 0.5)
              inside.push_back(node);
          for (const auto node : inside)
            {
              double across = 0;
              for (const auto other : inside)
                across = std::max(across, (at(node) - at(other)).norm());
              most = std::max(most, at(node).norm());
              if (inside.size() > 1)
                {
                  change(node) += across;
                  count(node) += 1;
                }
              if (inside.size() < face.nodes.size())
                open(node) += 1;
            }
        }
      for (LA::Vector *sum : {&change, &count, &open})
        sum->compress(VectorOperation::add);
      const MPI_Comm comm = s.elasticity.mesh().communicator();
      most                = Utilities::MPI::max(most, comm);
      double result       = 0;
      for (const auto i : change.locally_owned_elements())
        if (count(i) > 0 && at(i).norm() >= nearly * most)
          result = std::max(result, (open(i) > 0 ? at_edge : at_points) * change(i) / count(i));
      return Utilities::MPI::max(result, comm);
    }

    /// Finish the assembly of the derivatives by tractions.
    void
    compress(Functional &functional)
    {
      for (LA::Vector &component : functional.of_traction)
        component.compress(VectorOperation::insert);
    }
  } // namespace



  template <int dim>
  void
  add_friction_force(const Snapshot<dim> &s,
                     const unsigned int   pair,
                     const unsigned int   d,
                     const double         sign,
                     Functional          &sum)
  {
    const PointVectors &t = s.contact_state.traction;
    for (unsigned int a = 1; a < s.contact.n_components(); ++a)
      {
        LA::Vector &of_traction = sum.of_traction[a];
        for_rows<dim>(s, pair, [&](const auto i) {
          of_traction(i) = sign * s.contact.weight(i) * s.contact.tangential.direction[a - 1][d](i);
        });
        of_traction.compress(VectorOperation::insert);
        sum.value += of_traction * t[a];
      }
  }



  template <int dim>
  Functional
  friction_force(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const unsigned int      pair = number_of_pair(s, name.of);
    const double            sign = s.pairs[pair].exchanged ? -1 : 1;
    std::vector<Functional> components;
    for (unsigned int d = 0; d < dim; ++d)
      {
        components.push_back(zero_functional(s));
        // Radial forces balance around the axis of an axisymmetric model.
        if (d > 0 || s.elasticity.model() != Model::axisymmetric)
          add_friction_force(s, pair, d, sign, components.back());
      }
    return size_or_component(name, components);
  }



  template <int dim>
  Functional
  stick_area(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    // The uncertainty of the edge of a zone, in widths of a face: twice that of the edge of
    // contact, where a pressure that falls to zero tells the place within the face.
    const double       sharpness = samples_nodes(s.contact) ? 0.35 : 0.5;
    const unsigned int pair      = number_of_pair(s, name.of);
    Functional         result    = zero_functional(s);
    result.is_regularised        = true;
    if (s.contact.n_components() == 1)
      return result;
    const ContactPatch stick = stick_zone(s, pair);
    if (stick.area == 0)
      return result;
    const PointVectors &t     = s.contact_state.traction;
    const auto          bound = [&](const auto i) {
      return s.contact.coefficients.friction_bound(i, t[0](i));
    };
    const auto sticks = [&](const auto i) {
      return status_of(s.contact_state.status(i)) == ContactStatus::stick;
    };
    double sum = 0, area = 0;
    for_rows<dim>(s, pair, [&](const auto i) {
      if (!sticks(i))
        return;
      sum += s.contact.weight(i) * (bound(i).value - length_at(t, i, 1));
      area += s.contact.weight(i);
    });
    const MPI_Comm comm = s.elasticity.mesh().communicator();
    sum                 = Utilities::MPI::sum(sum, comm);
    area                = Utilities::MPI::sum(area, comm);
    const double c      = area > 0 && sum > 0 ? sum / (4 * area) : 1;
    double       own    = 0;
    for_rows<dim>(s, pair, [&](const auto i) {
      if (!sticks(i))
        return;
      const double size = length_at(t, i, 1), m = std::max(0., bound(i).value - size),
                   slope = s.contact.weight(i) * c / ((m + c) * (m + c));
      own += s.contact.weight(i) * m / (m + c);
      result.of_traction[0](i) = slope * bound(i).by_pressure;
      for (unsigned int a = 1; a < t.size() && size > 0; ++a)
        result.of_traction[a](i) = -slope * t[a](i) / size;
    });
    compress(result);
    const double smoothed = Utilities::MPI::sum(own, comm);
    for (LA::Vector &component : result.of_traction)
      component *= smoothed > 0 ? stick.area / smoothed : 0.;
    result.value      = stick.area;
    result.unresolved = sharpness * stick.edge;
    return result;
  }



  // The slip of a point is that before the load step, plus the increment that the rows of its
  // tangents give.
  template <int dim>
  Functional
  largest_slip(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const unsigned int pair   = number_of_pair(s, name.of);
    Functional         result = zero_functional(s);
    if (s.contact.n_components() == 1)
      return result;
    const PointVectors      slip = slip_at_points(s);
    double                  most = 0, missed = 0;
    types::global_dof_index row = numbers::invalid_dof_index;
    for_rows<dim>(s, pair, [&](const auto i) {
      missed = std::max(missed, missed_slip(s, i));
      if (const double size = length_at(slip, i);
          is_closed(s.contact_state.status(i)) && size > most)
        {
          most = size;
          row  = i;
        }
    });
    const MPI_Comm comm = s.elasticity.mesh().communicator();
    result.value        = Utilities::MPI::max(most, comm);
    result.unresolved   = share_at_edge(s, pair) * Utilities::MPI::max(missed, comm);
    if (result.value == 0)
      return result;
    result.unresolved += slip_beyond(s, pair);
    // Of equal slips the first one counts, whatever rank owns it.
    row = Utilities::MPI::min(most == result.value ? row : numbers::invalid_dof_index, comm);
    for (unsigned int a = 0; a < slip.size(); ++a)
      {
        LA::Vector direction = s.contact.zero();
        if (s.pressure.in_local_range(row))
          direction(row) = slip[a](row) / most;
        direction.compress(VectorOperation::insert);
        s.contact.free_rows(a + 1).Tvmult_add(result.of_displacement, direction);
      }
    return result;
  }



  // The work of a load step is m sum W (-t.s), with the areas W of the points, their slip s in that
  // step, and m = (1 + R_n/R)/2 by the bounds R_n and R of the pair before and after it. As R_n is
  // given, dm = -R_n/(2 R^2) dR. Of compliant methods s is taken with its elastic part.
  template <int dim>
  Functional
  friction_work(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const unsigned int pair   = number_of_pair(s, name.of);
    Functional         result = zero_functional(s);
    if (s.contact.n_components() == 1)
      return result;
    const PointVectors &t    = s.contact_state.traction;
    const PointVectors  gaps = s.contact.gaps(s.displacement);
    PointVectors        of_slip(gaps.size(), s.contact.zero());
    const double bound = bound_of_friction(s)[pair], mean = relative_mean_bound(s, pair, bound);
    double       missed = 0, done = 0;
    for_rows<dim>(s, pair, [&](const auto i) {
      const double weight = mean * s.contact.weight(i);
      missed += weight * length_at(t, i, 1) * missed_slip(s, i);
      if (status_of(s.contact_state.status(i)) != ContactStatus::slip)
        return;
      for (unsigned int a = 1; a < gaps.size(); ++a)
        {
          result.of_traction[a](i) = -weight * gaps[a](i);
          of_slip[a](i)            = -weight * t[a](i);
          done -= s.contact.weight(i) * t[a](i) * gaps[a](i);
        }
    });
    done = Utilities::MPI::sum(done, s.elasticity.mesh().communicator());
    if (bound > 0)
      for_rows<dim>(s, pair, [&](const auto i) {
        if (is_closed(s.contact_state.status(i)))
          result.of_traction[0](i) = -(mean - 0.5) * done / bound * s.contact.weight(i) *
                                     s.contact.coefficients.friction_bound(i, t[0](i)).by_pressure;
      });
    compress(result);
    for (unsigned int a = 1; a < gaps.size(); ++a)
      {
        of_slip[a].compress(VectorOperation::insert);
        s.contact.free_rows(a).Tvmult_add(result.of_displacement, of_slip[a]);
      }
    const MPI_Comm comm = s.elasticity.mesh().communicator();
    result.value        = s.friction_work.empty() ? 0. : s.friction_work[pair];
    result.unresolved   = share_at_edge(s, pair) * Utilities::MPI::sum(missed, comm);
    return result;
  }



#define INSTANTIATE(dim)                                                                           \
  template void add_friction_force(                                                                \
    const Snapshot<dim> &, unsigned int, unsigned int, double, Functional &);                      \
  template Functional friction_force(const QuantityName &,                                         \
                                     const Snapshot<dim> &,                                        \
                                     const Probes<dim> &);                                         \
  template Functional stick_area(const QuantityName &,                                             \
                                 const Snapshot<dim> &,                                            \
                                 const Probes<dim> &);                                             \
  template Functional largest_slip(const QuantityName &,                                           \
                                   const Snapshot<dim> &,                                          \
                                   const Probes<dim> &);                                           \
  template Functional friction_work(const QuantityName &,                                          \
                                    const Snapshot<dim> &,                                         \
                                    const Probes<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
