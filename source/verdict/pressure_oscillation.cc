// SPDX-License-Identifier: Apache-2.0
#include "verdict/pair_checks.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return 1 at nodes with neighbours on all sides, 0 at those at the edge of the surface:
    /// there the mean of the neighbours is off the node by at least a third of their root mean
    /// square distance (on regular meshes).
    LA::Vector
    within_surface(const GapOperator &contact)
    {
      constexpr double off = 0.3;
      LA::Vector       all = contact.zero(), rest = all, offset = all, distance = all;
      all = 1.;
      // Coordinates are shifted by their mean, since squares of large coordinates would cancel
      // below. By component: the square of the offset of the mean, and the mean square distance of
      // the neighbours, E(y^2) - 2 x E(y) + x^2.
      for (LA::Vector x : contact.geometry.position)
        {
          x.add(-x.mean_value());
          LA::Vector squares = x;
          squares.scale(x);
          const LA::Vector mean = contact.origin.regions.means_of_neighbours(all, x, rest),
                           mean_square =
                             contact.origin.regions.means_of_neighbours(all, squares, rest);
          for (const auto i : x.locally_owned_elements())
            {
              offset(i) += std::pow(mean(i) - x(i), 2);
              distance(i) += mean_square(i) - 2 * mean(i) * x(i) + x(i) * x(i);
            }
        }
      for (const auto i : all.locally_owned_elements())
        all(i) = offset(i) < off * distance(i) ? 1. : 0.;
      all.compress(VectorOperation::insert);
      return all;
    }
  } // namespace



  // Check the pressure for node-to-node oscillation: the share of nodes where it alternates by
  // more than two percent of the largest pressure. Let z be the difference of the pressure at a
  // node from the mean of its neighbours. For an alternating pressure of amplitude a on a
  // regular mesh z = l a, and the neighbours have -r l a in the mean, with l = 2, r = 1 along a
  // line and l = 4/3, r = 1/3 on a surface; hence a^2 = -z z_neighbours/(l^2 r). For smooth
  // pressures z has the same sign at neighbours, irregular meshes give any sign, and at edges,
  // where the pressure is singular, it alternates at a few nodes only. At the edge of the
  // surface all neighbours are on one side, so that z is a gradient: these nodes are excluded.
  // Open nodes between active ones count with their pressure zero. Steep pressures alternate
  // once beside an edge; therefore the neighbours have to alternate as well. Pressures of the
  // size of rounding do not count, tensions of pairs without separation do.
  template <int dim>
  CheckResult
  check_pressure_oscillation(const Snapshot<dim> &s,
                             const unsigned int   pair,
                             const ContactExtent &extent)
  {
    // The factor l^2 r of the comment above: 4 along a line, 16/27 on a surface.
    constexpr double scale = dim == 2 ? 4. : 16. / 27, little = 0.02, few = 5, rounding = 1e-9;
    const bool       counts_at_all =
      extent.pressure >
      rounding * extent.modulus * s.displacement.linfty_norm() / s.elasticity.mesh().size();
    const GapOperator &contact = s.contact;
    // Nodes of other pairs do not count; open nodes all of whose neighbours are active do.
    LA::Vector active = s.active, inner = contact.zero(), innermost = contact.zero();
    auto       which = contact.origin.pair.begin();
    for (const auto i : active.locally_owned_elements())
      if (*which++ != pair)
        active(i) = 0;
    active.compress(VectorOperation::insert);
    inner = 1.; // means are requested at all nodes
    const LA::Vector of_pressed =
      contact.origin.regions.means_of_neighbours(inner, active, innermost);
    for (const auto i : active.locally_owned_elements())
      if (of_pressed(i) > 1 - 1e-9)
        active(i) = 1;
    active.compress(VectorOperation::insert);
    // The excess z of each node, and the product -z z_neighbours in the mean; nodes at the edge
    // of the surface are excluded.
    // means_of_neighbours() sets `inner` to 1 where all neighbours are active, and after the next
    // line also inside of the surface.
    LA::Vector more = contact.origin.regions.means_of_neighbours(active, s.pressure, inner);
    inner.scale(within_surface(contact));
    more.sadd(-1, 1, s.pressure);
    LA::Vector turns   = contact.origin.regions.means_of_neighbours(inner, more, innermost),
               ignored = inner;
    for (const auto i : more.locally_owned_elements())
      turns(i) *= -more(i);
    turns.compress(VectorOperation::insert);
    // The same product at the neighbours, which must alternate as well.
    // It tells isolated changes of sign, as at the end of a steep pressure, from an oscillation
    // that goes on.
    const LA::Vector around = contact.origin.regions.means_of_neighbours(innermost, turns, ignored);
    const double     most   = scale * std::pow(little * extent.pressure, 2);
    double           is_significant[] = {0, 0};
    for (const auto i : more.locally_owned_elements())
      if (innermost(i) > 0)
        {
          is_significant[0] += turns(i) > most && around(i) > 0;
          is_significant[1] += 1;
        }
    Utilities::MPI::sum(is_significant, s.elasticity.mesh().communicator(), is_significant);
    return make_check_result(
      "pressure oscillation",
      s.pairs[pair].name,
      counts_at_all && is_significant[1] >= few ? is_significant[0] / is_significant[1] : 0.,
      1. / 3,
      "the pressure oscillates from node to node by more than 2 % of its "
      "largest value at that fraction of the nodes",
      "exchange Slave and Master, refine the master, or choose another method");
  }



  template CheckResult
  check_pressure_oscillation(const Snapshot<2> &, unsigned int, const ContactExtent &);
  template CheckResult
  check_pressure_oscillation(const Snapshot<3> &, unsigned int, const ContactExtent &);
} // namespace Signorini
