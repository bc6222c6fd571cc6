// SPDX-License-Identifier: Apache-2.0
#include "output/results.h"

#include "fields/contact_force.h"
#include "fields/contact_patch.h"
#include "fields/largest_stress.h"
#include "fields/peak.h"
#include "fields/point_values.h"
#include "fields/recovered_pressure.h"
#include "output/json.h"
#include "solid/reactions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    Json
    list_of_moment(const Tensor<1, 3> &moment)
    {
      return list(std::vector<double>(&moment[0], &moment[0] + (dim == 2 ? 1 : 3)));
    }

    /// The force of a pair on the body that the scene names as slave (also if the sides were
    /// exchanged).
    template <int dim>
    struct PairForce
    {
      /// Force and moment on the slave.
      Resultant<dim> resultant;
      /// Moment on the master.
      Tensor<1, 3> reaction_moment;
      /// Sum of pressure times weight, and of its absolute value, over all points.
      double normal_force = 0, sum_of_sizes = 0;
      /// The part of the force on the slave that is due to tangential tractions.
      Tensor<1, dim> friction_force;
    };

    /// @return the force of a pair. Collective.
    template <int dim>
    PairForce<dim>
    force_of(const Snapshot<dim> &s, const unsigned int pair)
    {
      PairForce<dim> sum;
      // Radial forces and moments of axisymmetric models balance around the axis.
      const bool on_circles = s.elasticity.model() == Model::axisymmetric;
      const bool exchanged  = s.pairs[pair].exchanged;
      auto       which      = s.contact.origin.pair.begin();
      for (const auto i : s.pressure.locally_owned_elements())
        if (*which++ == pair)
          {
            const double force = s.pressure(i) * s.contact.weight(i);
            // If the sides were exchanged, the slave of the computation is the master of the scene,
            // and the force on the body that the scene names as slave has the opposite sign.
            const double on_slave = exchanged ? -force : force;
            // Component 0 is the radial one of axisymmetric models.
            for (unsigned int d = on_circles; d < dim; ++d)
              sum.resultant.force[d] += on_slave * s.contact.geometry.normal[d](i);
            const auto add_moments = [&](const double                   size,
                                         const std::vector<LA::Vector> &of_slave,
                                         const std::vector<LA::Vector> &of_master) {
              for (unsigned int d = 0; !on_circles && d < of_slave.size(); ++d)
                {
                  sum.resultant.moment[d] += size * (exchanged ? of_master : of_slave)[d](i);
                  sum.reaction_moment[d] -= size * (exchanged ? of_slave : of_master)[d](i);
                }
            };
            const bool at_rest = s.contact.at_rest();
            add_moments(on_slave,
                        s.contact.geometry.moment,
                        at_rest ? s.contact.geometry.moment : s.contact.geometry.master_moment);
            sum.normal_force += force;
            sum.sum_of_sizes += std::abs(force);
            const TangentialRows &tangential = s.contact.tangential;
            for (unsigned int a = 0; a < tangential.B.size(); ++a)
              {
                const double along =
                  (exchanged ? -1 : 1) * s.contact_state.traction[a + 1](i) * s.contact.weight(i);
                for (unsigned int d = on_circles; d < dim; ++d)
                  sum.friction_force[d] += along * tangential.direction[a][d](i);
                add_moments(along,
                            tangential.moment[a],
                            at_rest ? tangential.moment[a] : tangential.master_moment[a]);
                sum.sum_of_sizes += std::abs(along);
              }
          }
      const MPI_Comm comm  = s.elasticity.mesh().communicator();
      sum.friction_force   = Utilities::MPI::sum(sum.friction_force, comm);
      sum.resultant.force  = Utilities::MPI::sum(sum.resultant.force, comm) + sum.friction_force;
      sum.resultant.moment = Utilities::MPI::sum(sum.resultant.moment, comm);
      sum.reaction_moment  = Utilities::MPI::sum(sum.reaction_moment, comm);
      sum.normal_force     = Utilities::MPI::sum(sum.normal_force, comm);
      sum.sum_of_sizes     = Utilities::MPI::sum(sum.sum_of_sizes, comm);
      return sum;
    }

    /// @return the shortening of a bolt by its pretension [length]; zero for other pairs.
    /// Collective.
    template <int dim>
    double
    shortening(const Snapshot<dim> &s, const ContactPair<dim> &pair)
    {
      return pair.pretension.given() ?
               s.elasticity.rigid_motion(
                 s.displacement)[s.elasticity.rigid_body(pair.pretension.body_name(pair.name)) *
                                 RigidBody<dim>::n_dofs] :
               0.;
    }

    /// @return where the slave of a pair meets its master, as points of application of forces know
    /// it. Collective.
    template <int dim>
    MasterImage<dim>
    image_of(const Snapshot<dim> &s, const ContactPair<dim> &pair)
    {
      MasterImage<dim> result = pair.image;
      // At small strain forces act on the bodies as they are at rest.
      if (s.elasticity.is_finite_strain() && pair.pretension.given())
        result.shift += shortening(s, pair) * pair.pretension.direction;
      return result;
    }

    /// Sums and extreme values over the points of one pair.
    struct PairSums
    {
      double       active_points = 0, points = 0;
      ContactPatch patch;
      /// Largest pressure.
      double pressure = 0;
      /// sharpness_of_peak().
      double sharpness = 0;
      // Maxima over all points.
      double penetration = 0, minus_gap = -std::numeric_limits<double>::max(), tension = 0,
             complementarity = 0;

      void
      reduce_over_ranks(const MPI_Comm comm)
      {
        for (double *x : {&active_points, &points})
          *x = Utilities::MPI::sum(*x, comm);
        for (double *x : {&penetration, &minus_gap, &tension, &complementarity})
          *x = Utilities::MPI::max(*x, comm);
      }
    };

    /// @return the gap without the overclosure of a compliant interface: zero where the law holds.
    /// @param pressure true pressure
    template <int dim>
    double
    rigid_gap(const ContactPair<dim> &pair, const double gap, const double pressure)
    {
      return gap + pair.compliance.overclosure(pressure).value;
    }

    /// @return by how much a gap violates its condition, if positive: the penetration, or the
    /// distance for pairs without separation.
    /// @param gap rigid_gap()
    template <int dim>
    double
    violation(const ContactPair<dim> &pair, const double gap)
    {
      return pair.can_separate ? -gap : std::abs(gap);
    }

    /// @return the sums of one pair. Collective.
    template <int dim>
    PairSums
    sums_of(const Snapshot<dim> &s, const unsigned int pair)
    {
      PairSums sums;
      auto     which = s.contact.origin.pair.begin();
      for (const auto i : s.pressure.locally_owned_elements())
        if (*which++ == pair)
          {
            const double p     = s.pressure(i),
                         rigid = rigid_gap(s.pairs[pair],
                                           s.gap(i),
                                           p / s.contact.coefficients.area_ratio(i));
            sums.points += 1;
            sums.active_points += s.active(i);
            sums.penetration     = std::max(sums.penetration, violation(s.pairs[pair], rigid));
            sums.minus_gap       = std::max<double>(sums.minus_gap, -s.gap(i));
            sums.complementarity = std::max(sums.complementarity, std::abs(p * rigid));
          }
      // Extreme pressures are those of the recovered pressure, since the nodal pressures of degree
      // 2 are not accurate at points.
      const LA::Vector &nodal = recovered_pressure(s, pair);
      // A negative pressure is tension; entries that are no nodes of the surface are zero and do
      // not matter for the maximum.
      for (const auto i : nodal.locally_owned_elements())
        sums.tension = std::max(sums.tension, -nodal(i));
      sums.patch     = contact_patch(s, pair, nodal);
      sums.pressure  = largest_pressure(s, pair, nodal, sums.patch);
      sums.sharpness = sharpness_of_peak(s, pair, nodal);
      sums.reduce_over_ranks(s.elasticity.mesh().communicator());
      return sums;
    }

    /// @return the extent of the contact zone along the directions of the pair.
    template <int dim>
    Json
    extents(const ContactPair<dim> &pair, const ContactPatch &patch)
    {
      Json result = Json::array();
      for (unsigned int i = 0; i < patch.along.size(); ++i)
        {
          const Tensor<1, dim> direction(pair.directions[i]);
          result.push_back({{"direction", list(direction / direction.norm())},
                            {"from", patch.along[i].first},
                            {"to", patch.along[i].second}});
        }
      return result;
    }

    /// @return the largest violations of the Hertz-Signorini-Moreau conditions (doc/theory, 1.3) at
    /// the contact points, where methods that sample at nodes need not satisfy them. Collective.
    template <int dim>
    Json
    conditions_at_points(const Snapshot<dim> &s, const unsigned int pair)
    {
      const PointValues     values = point_values(s, pair);
      std::array<double, 3> worst{{0, 0, 0}};
      for (unsigned int q = 0; q < values.gap.size(); ++q)
        {
          const double p = values.pressure[q], rigid = rigid_gap(s.pairs[pair], values.gap[q], p);
          worst[0] = std::max(worst[0], violation(s.pairs[pair], rigid));
          worst[1] = std::max(worst[1], -p);
          worst[2] = std::max(worst[2], std::abs(rigid * p));
        }
      for (double &x : worst)
        x = Utilities::MPI::max(x, s.elasticity.mesh().communicator());
      return {{"max_penetration", worst[0]},
              {"max_tension", worst[1]},
              {"complementarity", worst[2]}};
    }
  } // namespace



  // All values are those of the slave that the scene names, see force_of().
  template <int dim>
  Json
  pair_results(const Snapshot<dim> &snapshot)
  {
    Json result = Json::object();
    for (unsigned int pair = 0; pair < snapshot.pairs.size(); ++pair)
      {
        const PairSums       sums         = sums_of(snapshot, pair);
        const PairForce<dim> force        = force_of(snapshot, pair);
        result[snapshot.pairs[pair].name] = {
          {"slave", snapshot.pairs[pair].named_slave()},
          {"force", list(force.resultant.force)},
          {"moment", list_of_moment<dim>(force.resultant.moment)},
          {"normal_force", force.normal_force},
          {"area", sums.patch.area},
          {"semi_axes", list(sums.patch.semi_axes)},
          {"contact_from", list(sums.patch.from)},
          {"contact_to", list(sums.patch.to)},
          {"points", sums.points},
          {"active_points", sums.active_points},
          {"separates", snapshot.pairs[pair].can_separate},
          {"max_pressure", sums.pressure},
          {"sharpness_of_peak", sums.sharpness},
          {"max_penetration", sums.penetration},
          {"min_gap", sums.points > 0 ? Json(-sums.minus_gap) : Json(nullptr)},
          {"max_tension", sums.tension},
          {"complementarity", sums.complementarity},
          {"at_points", conditions_at_points(snapshot, pair)}};
        if (!snapshot.pairs[pair].directions.empty())
          result[snapshot.pairs[pair].name]["contact_extents"] =
            extents(snapshot.pairs[pair], sums.patch);
        if (!snapshot.pairs[pair].friction.is_zero())
          result[snapshot.pairs[pair].name].update(
            friction_results(snapshot, force.friction_force, sums.patch.area, pair));
        if (snapshot.pairs[pair].pretension.given())
          result[snapshot.pairs[pair].name]["pretension"] = {
            {"tension", force.resultant.force * snapshot.pairs[pair].pretension.direction},
            {"shortening", shortening(snapshot, snapshot.pairs[pair])}};
        if (snapshot.pairs[pair].is_tied)
          result[snapshot.pairs[pair].name].update(
            tie_results(snapshot, force.friction_force, pair));
      }
    return result;
  }



  namespace
  {
    /// @return the size of forces that Newton's method may leave for bodies that move without
    /// strain.
    template <int dim>
    double
    rounding_of_forces(const Snapshot<dim> &s, const double tolerance)
    {
      const Mesh<dim> &mesh     = s.elasticity.mesh();
      double           stiffest = 0;
      for (const Material &material : s.elasticity.all_materials())
        stiffest = std::max(stiffest, material.youngs_modulus);
      const bool is_plane = dim == 2 && s.elasticity.model() != Model::axisymmetric;
      // The stiffness of a body is about E times its size (in plane models, per thickness, E
      // alone); times the displacement it is a force, of which Newton's method leaves the share of
      // its tolerance. A body that moves freely has large displacements without forces.
      const double motion = s.displacement.linfty_norm();
      // Bodies that have come back to their places have the rounding of strains alone.
      const double rounding = 1e3 * std::numeric_limits<double>::epsilon() * mesh.size();
      return (motion <= rounding ? rounding : 10 * tolerance * motion) * stiffest *
             (is_plane ? 1. : mesh.size());
    }

    /// @return the moment about the centre of the model: about the origin, unbalanced forces would
    /// have the distance from there as lever. In axisymmetric models it is zero.
    template <int dim>
    Tensor<1, 3>
    moment_about_middle(const Elasticity<dim> &elasticity, const Resultant<dim> &resultant)
    {
      if (elasticity.model() == Model::axisymmetric)
        return resultant.moment;
      const auto &[low, high] = elasticity.mesh().extent().get_boundary_points();
      return resultant.moment - moment_of(low + (high - low) / 2, resultant.force);
    }
  } // namespace



  // Forces on bodies are the sum of supports, loads and pairs; each pair acts on both of its
  // bodies.
  template <int dim>
  Json
  force_results(const Snapshot<dim> &s, const double tolerance)
  {
    const Mesh<dim>     &mesh     = s.elasticity.mesh();
    const Reactions<dim> outer    = reactions(s.elasticity, s.displacement, contact_force(s));
    Json                 supports = Json::object();
    double               largest  = outer.load.force.norm();
    for (unsigned int i = 0; i < s.elasticity.supports().size(); ++i)
      {
        const Tensor<1, dim> &force               = outer.supports[i].force;
        supports[s.elasticity.supports()[i].name] = {{"reaction", list(force)}};
        largest                                   = std::max(largest, force.norm());
      }
    std::vector<Resultant<dim>> on_bodies = outer.bodies;
    for (unsigned int pair = 0; pair < s.pairs.size(); ++pair)
      {
        const ContactPair<dim> &names = s.pairs[pair];
        const PairForce<dim>    force = force_of(s, pair);
        largest = std::max({largest, force.resultant.force.norm(), force.sum_of_sizes});
        on_bodies[*mesh.body_of(names.named_slave())] += force.resultant;
        const MasterImage<dim> image = image_of(s, names);
        if (const auto master = mesh.body_of(names.named_master()))
          on_bodies[*master] +=
            {-image.at_master(force.resultant.force),
             image.moment_at_master(force.reaction_moment, -force.resultant.force)};
      }
    // Forces of the size of rounding count as balanced, whatever their directions are.
    if (largest <= rounding_of_forces(s, tolerance))
      {
        on_bodies.assign(mesh.n_bodies(), {});
        largest = 0;
      }
    // Balance and largest stresses of each body, and the balance of all of them.
    Resultant<dim> sum;
    Json           bodies  = Json::object();
    const auto     balance = [&](const Resultant<dim> &one) {
      const double       scale  = largest > 0 ? largest : 1.;
      const Tensor<1, 3> moment = moment_about_middle(s.elasticity, one);
      return Json{{"force_balance", one.force.norm() / scale},
                  {"moment_balance", moment.norm() / (scale * mesh.size())}};
    };
    const auto stresses = largest_stresses(s.elasticity, s.displacement);
    const auto at_place = [&](const ValueAtPosition<dim> &one) {
      return Json{{"value", one.value}, {"place", list(Tensor<1, dim>(one.position))}};
    };
    // Dividing by the largest force of the model, not by that of the body, avoids large numbers for
    // bodies on which hardly any force acts.
    for (unsigned int body = 0; body < mesh.n_bodies(); ++body)
      {
        Json &of_body      = bodies[mesh.body_name(body)];
        of_body            = balance(on_bodies[body]);
        of_body["largest"] = {{"von_mises", at_place(stresses[body].von_mises)},
                              {"shear", at_place(stresses[body].shear)},
                              {"principal_stress", at_place(stresses[body].principal)}};
        sum += on_bodies[body];
      }
    Json results = {{"supports", supports},
                    {"obstacles", obstacle_results(s)},
                    {"total_load", list(outer.load.force)},
                    {"bodies", bodies},
                    {"largest_force", largest}};
    results.update(balance(sum));
    return results;
  }



  template Json
  pair_results(const Snapshot<2> &);
  template Json
  pair_results(const Snapshot<3> &);
  template Json
  force_results(const Snapshot<2> &, double);
  template Json
  force_results(const Snapshot<3> &, double);
} // namespace Signorini
