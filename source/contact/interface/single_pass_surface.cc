// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/gap_increments.h"
#include "contact/constraints/pressure_functions.h"
#include "contact/constraints/tangents.h"
#include "contact/interface/contact_points.h"
#include "contact/interface/surface_steps.h"
#include "contact/search/deep_penetration.h"
#include "contact/search/search_radius.h"
#include "contact/search/self_contact.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>
#include <signorini/contact/methods/method.h>
#include <signorini/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// True if a point on this rank has a multiplier shape function.
    template <int dim>
    bool
    has_shapes(const std::vector<ContactPoint<dim>> &points)
    {
      return std::any_of(points.begin(), points.end(), [](const auto &point) {
        return !point.multiplier_shape.empty();
      });
    }

    /// The largest penetration of all points of all ranks [length], at least zero. Collective.
    template <int dim>
    double
    deepest_overlap(const std::vector<ContactPoint<dim>> &points, const MPI_Comm comm)
    {
      double deepest = 0;
      for (const ContactPoint<dim> &point : points)
        deepest = std::max(deepest, -point.current_gap());
      return Utilities::MPI::max(deepest, comm);
    }

    /// Set the offset delta of the linearised gap g = B u + g_ref + delta, so that it is exact at
    /// the displacement u of the configuration (doc/theory, (5.2)): delta = (g_true - g_ref) - B u.
    /// Collective.
    template <int dim>
    void
    set_gap_offset(const LA::Vector &u, std::vector<ContactPoint<dim>> &points)
    {
      std::vector<const ContactPoint<dim> *> pointers;
      for (const ContactPoint<dim> &point : points)
        pointers.push_back(&point);
      const std::vector<double> opened = gap_increments(pointers, u);
      for (std::size_t i = 0; i < points.size(); ++i)
        points[i].gap_offset = -points[i].gap_decrease - opened[i];
    }

    /// The construction of a ContactSurface, in the order of make(): search radius, skipping of
    /// distant pairs, partition of self-contact surfaces, projections, contact points, candidates,
    /// linearisation, multiplier shape functions. Refers to its arguments; make() is called once.
    template <int dim>
    class SinglePassSurface
    {
    public:
      SinglePassSurface(const Configuration<dim>                      &configuration,
                        const ContactPair<dim>                        &pair,
                        const Obstacle<dim>                           *obstacle,
                        const ContactMethod                           &method,
                        const Integration                             &integration,
                        const SearchTolerance                         &range,
                        const std::vector<FixedIntegrationPoint<dim>> &fixed_points)
        : configuration(configuration)
        , elasticity(configuration.elasticity())
        , comm(elasticity.mesh().communicator())
        , at_rest(configuration.is_reference())
        , pair(pair)
        , obstacle(obstacle)
        , method(method)
        , integration(integration)
        , slave(configuration, pair.slave)
        , fixed_points(fixed_points)
        , has_fixed_points(Utilities::MPI::max(fixed_points.size(), comm) > 0)
        , limit(find_limit(range))
      {
        surface.faces = surface.own_faces = slave.faces.size();
        surface.can_separate              = pair.can_separate;
        surface.is_tied                   = pair.is_tied;
        surface.candidate_gap             = at_rest && pair.search_distance > 0 ?
                                              std::min(limit, pair.search_distance) :
                                              range.candidate_gap;
      }

      /// Build the surface. Collective: each of the decisions below is the same on all ranks.
      ContactSurface<dim>
      make()
      {
        is_far = at_rest && is_apart(elasticity, pair, obstacle, slave, limit);
        // Boxes of overlapping surfaces may be as far apart as the overlap is deep.
        if (is_far && (obstacle || !may_overlap(elasticity.mesh(), pair)))
          {
            surface.is_apart = true;
            return std::move(surface);
          }
        if (obstacle)
          check_obstacle(configuration, pair, *obstacle, slave);
        if (pair.is_self())
          self = split();
        find_master_projections();
        make_points();
        // From here on the candidates only: points of faces whose gap is small enough.
        choose_points();
        if (!at_rest && !self && pair.can_separate)
          forget_other_integration_points();
        if (!at_rest)
          set_gap_offset(configuration.displacement(), surface.points);
        if (method.uses_slip())
          surface.frames = surface_frames(slave, paired);
        // Mesh sizes and moduli of both sides, for the choice of the slave.
        compare(elasticity, slave, paired, obstacle, surface);
        surface.is_apart = Utilities::MPI::sum(surface.points.size(), comm) == 0;
        const std::vector<PressureNodes> functions = set_shapes();
        surface.full_face_shapes                   = full_face_shape_functions(elasticity, slave);
        surface.slave_faces = slave_faces(elasticity, slave, surface.points, functions);
        surface.has_dirichlet_nodes =
          Utilities::MPI::max(any_dirichlet_node(surface.slave_faces) ? 1 : 0, comm) > 0;
        return std::move(surface);
      }

    private:
      /// The search radius [length]. In displaced configurations, and where motions are known from
      /// an earlier solution (SearchTolerance::is_final), it is the larger of the two given
      /// tolerances. Otherwise it is the candidate gap, at most the search radius of the pair; if
      /// the surfaces penetrate each other deeper than that, 1.1 times the deepest penetration.
      double
      find_limit(const SearchTolerance &range) const
      {
        if (!at_rest || range.is_final)
          return std::max(range.candidate_gap, range.limit);
        // The points of pairs without separation have to be found at any distance up to the search
        // distance, and so do those of pairs whose gap is given by a formula, since it does not
        // depend on the distance of the surfaces.
        const double farthest = search_radius_of_pair(elasticity, pair, range.candidate_gap),
                     first    = pair.can_separate && !pair.gap_is_given() ?
                                  std::min(range.candidate_gap, farthest) :
                                  farthest;
        const double overlap  = penetration_beyond(first, elasticity, pair, obstacle, slave);
        check_search_distance(overlap, pair);
        return overlap > 0 ? 1.1 * overlap : first;
      }

      /// The master faces on this rank, with inner sides where segment edges contribute to the
      /// geometric stiffness.
      MasterFaces<dim>
      master() const
      {
        const BoundaryFaces<dim> boundary =
          self ? self->masters(slave) : BoundaryFaces<dim>::of_master(configuration, pair);
        MasterFaces<dim> faces = master_faces(configuration, boundary, pair.image, method);
        if (!at_rest && !pair.image.turns() && !has_fixed_points &&
            integration.rule == Rule::segments)
          faces.inner_sides = inner_sides(elasticity.mesh(), pair.master, boundary);
        if (self)
          faces.rest = boundary.rest;
        return faces;
      }

      /// The partition of a self-contact surface; fixed integration points determine which faces
      /// are slaves.
      SelfContact<dim>
      split() const
      {
        if (!has_fixed_points)
          // The radius must not be the limit of this search, which depends on earlier solutions:
          // the partition would then depend on the history.
          return {slave, elasticity.rotation_length_scale() / 5, pair.self_side, comm};
        std::vector<bool> has_points(slave.faces.size(), false);
        for (const auto &point : fixed_points)
          has_points[point.face] = true;
        return SelfContact<dim>(has_points);
      }

      /// Project all points, with the search distance of the pair as radius if the smaller one
      /// yields no projection at all: the pair then has candidates anyway, for messages and checks.
      void
      find_master_projections()
      {
        pair_within_limit();
        // Collective decision: no rank has found any projection within the limit.
        if (at_rest && !is_far && pair.search_distance > limit &&
            Utilities::MPI::sum(paired.size(), comm) == 0)
          {
            limit = pair.search_distance;
            pair_within_limit();
          }
      }

      /// Pair slave points with the obstacle, with the integration points of an earlier search, or
      /// with the master by new ones, and drop points of negligible weight. Collective.
      void
      pair_within_limit()
      {
        const SlaveSide<dim> side(slave.patches, self ? &slave.rest : nullptr);
        if (obstacle)
          paired = obstacle_points(
            configuration, slave, *obstacle, integration, limit, method.uses_slip());
        else if (has_fixed_points)
          paired = reproject_points(side, fixed_points, master(), limit, comm, surface.statistics);
        else
          {
            auto pairing =
              self ? make_self_pair() :
                     pair_points(side, master(), integration, limit, comm, surface.statistics);
            paired = std::move(pairing.points);
            weigh_by_reference_area(slave, edge_points = std::move(pairing.edge_points));
          }
        drop_empty_points(slave.patches, paired);
        if (pair.pretension.given())
          shift_with_pretension();
      }

      /// Let the master of all paired points move with the shortening by a pretension.
      void
      shift_with_pretension()
      {
        const auto            dof = elasticity.first_dof(pair.pretension.body_name(pair.name));
        const Tensor<1, dim> &d   = pair.pretension.direction;
        for (PairedPoint<dim> &point : paired)
          {
            point.master_point.rigid = {{dof, point.master_point.normal * d}};
            for (unsigned int c = 0; c < dim && method.uses_slip(); ++c)
              point.master_point.rigid_motion[c] = {{dof, d[c]}};
          }
      }

      /// Pair the slave faces of a self-contact surface with its master faces; faces are numbered
      /// as those of the whole surface.
      Pairing<dim>
      make_self_pair()
      {
        std::vector<bool>         is_slave;
        std::vector<unsigned int> numbers;
        for (unsigned int i = 0; i < slave.faces.size(); ++i)
          {
            is_slave.push_back(self->is_slave(i));
            if (is_slave[i])
              numbers.push_back(i);
          }
        const BoundaryFaces<dim> slaves = slave.among(is_slave);
        Pairing<dim>             result = pair_points(SlaveSide<dim>(slaves.patches, &slaves.rest),
                                          master(),
                                          integration,
                                          limit,
                                          comm,
                                          surface.statistics);
        for (auto *points : {&result.points, &result.edge_points})
          for (PairedPoint<dim> &point : *points)
            point.face = numbers[point.face];
        return result;
      }

      /// Make the contact points of all paired points and check them. In displaced configurations
      /// weights become those of reference areas, and pairs whose settings refer to the reference
      /// gap get it by a second search in the reference configuration.
      void
      make_points()
      {
        // The order matters: integration points are stored before points without a reference gap
        // are dropped.
        std::vector<double> gaps;
        if (!at_rest)
          {
            make_integration_points();
            if (needs_reference_gaps(pair))
              gaps = reference_gaps(elasticity, pair, obstacle, slave, limit, paired);
          }
        surface.points =
          contact_points(configuration, pair, method, slave, integration, paired, gaps);
        check_gaps(pair, surface.points, comm);
        check_stresses(surface.points, comm);
        surface.has_no_projection = !is_far && Utilities::MPI::sum(paired.size(), comm) == 0;
      }

      /// Store the integration points, to be projected again after an update of the configuration.
      void
      make_integration_points()
      {
        // Weights of points kept from an earlier search refer to reference areas already; those on
        // obstacles are computed anew each time.
        if (!has_fixed_points || obstacle)
          weigh_by_reference_area(slave, paired);
        surface.fixed_points = fixed_points;
        if (!has_fixed_points)
          for (const PairedPoint<dim> &point : paired)
            surface.fixed_points.push_back(
              {point.face,
               point.xi,
               point.weight,
               {point.master_point.face_center, point.master_point.size}});
      }

      /// Reduce the points to candidates. The candidate gap is at least twice the deepest
      /// penetration, so that points around a penetration that the solution resolves remain.
      void
      choose_points()
      {
        surface.overlap = deepest_overlap(surface.points, comm);
        if (at_rest && !pair.gap_is_given())
          check_search_distance(surface.overlap, pair);
        // Integration points of an earlier search are those of its candidates, and tell nothing of
        // other faces.
        const bool has_candidates = has_fixed_points && !self && !obstacle;
        if (!has_candidates)
          surface.candidate_gap = std::max(surface.candidate_gap, 2 * surface.overlap);
        if (!pair.can_separate)
          keep_zero_gap_points(pair, slave, paired, surface.points);
        else if (surface.candidate_gap < limit && !has_candidates)
          keep_candidates(surface.candidate_gap, slave, paired, surface.points);
      }

      /// Keep the integration points of faces that are candidates only: others will not be, as long
      /// as integration points are kept. (On a self-contact surface they tell slaves from masters.)
      void
      forget_other_integration_points()
      {
        std::vector<bool> is_candidate(slave.faces.size(), false);
        for (const ContactPoint<dim> &point : surface.points)
          is_candidate[point.face] = true;
        auto &fixed = surface.fixed_points;
        fixed.erase(std::remove_if(fixed.begin(),
                                   fixed.end(),
                                   [&](const auto &point) { return !is_candidate[point.face]; }),
                    fixed.end());
      }

      /// Set the multiplier shape functions of points and segment edge points. Throws SceneError if
      /// all nodes of a face have a prescribed normal displacement, so that no multiplier can act
      /// there. Collective.
      std::vector<PressureNodes>
      set_shapes()
      {
        surface.edge_points = make_edge_points(elasticity, slave, edge_points);
        if (method.uses_slip())
          surface.edge_point_frames = surface_frames(slave, edge_points);
        const auto functions =
          set_pressure_functions(elasticity,
                                 method,
                                 integration.basis,
                                 slave,
                                 elasticity.mesh().boundary_ids(pair.slave),
                                 nodes_of_boundaries(elasticity, pair.contact_slaves),
                                 paired,
                                 edge_points,
                                 surface.points,
                                 surface.edge_points);
        const unsigned int n_prescribed =
          std::count_if(functions.begin(), functions.end(), [](const PressureNodes &face) {
            return face.covered > 0 && face.own.empty();
          });
        // Against an obstacle, faces without any multiplier are admissible as long as other faces
        // have some.
        const bool some_prescribed = Utilities::MPI::max(n_prescribed, comm) > 0,
                   some_free = Utilities::MPI::max(has_shapes(surface.points) ? 1 : 0, comm) > 0;
        if (some_prescribed && (!obstacle || !some_free))
          throw SceneError(
            pair.slave_location + ": the displacement of faces of '" + pair.slave +
            "' is prescribed in normal direction at all nodes (over-constrained), so that they "
            "cannot carry a multiplier; exchange Slave and Master, or set Contact method/Method = "
            "penalty");
        return functions;
      }

      const Configuration<dim>                      &configuration;
      const Elasticity<dim>                         &elasticity;
      const MPI_Comm                                 comm;
      const bool                                     at_rest;
      const ContactPair<dim>                        &pair;
      const Obstacle<dim>                           *obstacle;
      const ContactMethod                           &method;
      const Integration                             &integration;
      const BoundaryFaces<dim>                       slave;
      const std::vector<FixedIntegrationPoint<dim>> &fixed_points;
      const bool                                     has_fixed_points;
      double                                         limit;
      bool                            is_far = false; ///< by boxes, farther than the limit
      std::optional<SelfContact<dim>> self;           ///< where slave and master are one surface
      std::vector<PairedPoint<dim>>   paired;         ///< as long as surface.points
      std::vector<PairedPoint<dim>>   edge_points;    ///< as long as surface.edge_points
      ContactSurface<dim>             surface;
    };
  } // namespace



  template <int dim>
  ContactSurface<dim>
  single_pass_surface(const Configuration<dim>                      &configuration,
                      const ContactPair<dim>                        &pair,
                      const Obstacle<dim>                           *obstacle,
                      const ContactMethod                           &method,
                      const Integration                             &integration,
                      const SearchTolerance                         &range,
                      const std::vector<FixedIntegrationPoint<dim>> &fixed_points)
  {
    return SinglePassSurface<dim>(
             configuration, pair, obstacle, method, integration, range, fixed_points)
      .make();
  }



#define INSTANTIATE(dim)                                                                           \
  template ContactSurface<dim> single_pass_surface(                                                \
    const Configuration<dim> &,                                                                    \
    const ContactPair<dim> &,                                                                      \
    const Obstacle<dim> *,                                                                         \
    const ContactMethod &,                                                                         \
    const Integration &,                                                                           \
    const SearchTolerance &,                                                                       \
    const std::vector<FixedIntegrationPoint<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
