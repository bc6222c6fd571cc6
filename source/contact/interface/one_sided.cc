#include "contact/interface/one_sided.h"

#include "base/solver_failure.h"
#include "contact/constraints/openings.h"
#include "contact/constraints/pressure_functions.h"
#include "contact/constraints/tangents.h"
#include "contact/interface/candidates.h"
#include "contact/interface/contact_points.h"
#include "contact/interface/gaps_at_rest.h"
#include "contact/interface/master_faces.h"
#include "contact/interface/obstacle_points.h"
#include "contact/interface/seams.h"
#include "contact/interface/slave_faces.h"
#include "contact/interface/surface_comparison.h"
#include "contact/search/deep_overlap.h"
#include "contact/search/reach.h"
#include "contact/search/self_contact.h"
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
    template <int dim>
    bool
    has_shapes(const std::vector<ContactPoint<dim>> &points)
    {
      return std::any_of(points.begin(), points.end(), [](const auto &point) {
        return !point.shape.empty();
      });
    }

    template <int dim>
    void
    check_gaps(const ContactPair<dim>               &pair,
               const std::vector<ContactPoint<dim>> &points,
               const MPI_Comm                        comm)
    {
      const bool bad = std::any_of(points.begin(), points.end(), [](const auto &point) {
        return !std::isfinite(point.gap);
      });
      if (Utilities::MPI::max(bad ? 1 : 0, comm) > 0)
        throw SceneError(pair.slave_place + ": Initial gap = " + pair.initial_gap.text +
                         " is not a finite number at some points of '" + pair.slave +
                         "'; correct the formula");
    }

    /// Folded cells have no stress. Throws SolverFailure. Collective.
    template <int dim>
    void
    check_stresses(const std::vector<ContactPoint<dim>> &points, const MPI_Comm comm)
    {
      const bool bad = std::any_of(points.begin(), points.end(), [](const auto &point) {
        return std::isnan(point.stress_offset);
      });
      if (Utilities::MPI::max(bad ? 1 : 0, comm) > 0)
        throw SolverFailure("cells at a contact surface are inverted; use smaller load steps");
    }

    template <int dim>
    double
    deepest_overlap(const std::vector<ContactPoint<dim>> &points, const MPI_Comm comm)
    {
      double deepest = 0;
      for (const ContactPoint<dim> &point : points)
        deepest = std::max(deepest, -point.gap_now());
      return Utilities::MPI::max(deepest, comm);
    }

    /// Throws SceneError if surfaces that stand still overlap by more than that.
    template <int dim>
    void
    check_search_distance(const double overlap, const ContactPair<dim> &pair)
    {
      if (pair.search_distance > 0 && overlap > pair.search_distance)
        throw SceneError(pair.slave_place + ": '" + pair.slave + "' lies up to " +
                         short_text(overlap, 4) + " deep in '" + pair.master +
                         "' at the start, deeper than its Search distance of " +
                         short_text(pair.search_distance, 4) +
                         "; set a larger Search distance, or move the bodies apart");
    }

    template <int dim>
    void
    check_obstacle(const Configuration<dim> &configuration,
                   const ContactPair<dim>   &pair,
                   const Obstacle<dim>      &obstacle,
                   const BoundaryFaces<dim> &slave)
    {
      if (configuration.is_rest())
        return;
      const double length = configuration.elasticity().lever();
      const bool   bad =
        std::any_of(slave.rest.begin(), slave.rest.end(), [&](const FacePatch<dim> &face) {
          return !obstacle.shape->has_closest_point(face.center(), length);
        });
      if (Utilities::MPI::max(bad ? 1 : 0, configuration.elasticity().mesh().communicator()) > 0)
        throw SceneError(
          pair.master_place + ": the Gap of '" + obstacle.name +
          "' does not increase by 1 per unit length along its Normal, so that it defines the gap on "
          "the undeformed surface only; use a formula that is valid at all points, such as y - "
          "x^2/20 for Normal = 0, 1, or set Contact method/Contact geometry = reference");
    }

    /// So that the gap is true where the surfaces are: less row() . u.
    template <int dim>
    void
    set_drift(const LA::Vector &u, std::vector<ContactPoint<dim>> &points)
    {
      std::vector<const ContactPoint<dim> *> pointers;
      for (const ContactPoint<dim> &point : points)
        pointers.push_back(&point);
      const std::vector<double> opened = openings(pointers, u);
      for (std::size_t i = 0; i < points.size(); ++i)
        points[i].drift = -points[i].closing - opened[i];
    }

    template <int dim>
    class OneSided
    {
    public:
      OneSided(const Configuration<dim>          &configuration,
               const ContactPair<dim>            &pair,
               const Obstacle<dim>               *obstacle,
               const ContactMethod               &method,
               const Integration                 &integration,
               const SearchRange                 &range,
               const std::vector<LaidPoint<dim>> &laid)
        : configuration(configuration)
        , elasticity(configuration.elasticity())
        , comm(elasticity.mesh().communicator())
        , at_rest(configuration.is_rest())
        , pair(pair)
        , obstacle(obstacle)
        , method(method)
        , integration(integration)
        , slave(configuration, pair.slave)
        , laid(laid)
        , is_laid(Utilities::MPI::max(laid.size(), comm) > 0)
        , limit(find_limit(range))
      {
        surface.faces = surface.own_faces = slave.faces.size();
        surface.separates                 = pair.separates;
        surface.reach =
          at_rest && pair.search_distance > 0 ? std::min(limit, pair.search_distance) : range.reach;
      }

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
        find_partners();
        make_points();
        choose_points();
        if (!at_rest)
          set_drift(configuration.displacement(), surface.points);
        if (method.needs_slip())
          surface.frames = surface_frames(slave, paired);
        compare(elasticity, slave, paired, obstacle, surface);
        surface.is_apart = Utilities::MPI::sum(surface.points.size(), comm) == 0;
        const std::vector<PressureNodes> functions = set_shapes();
        surface.whole                              = whole_faces(elasticity, slave);
        surface.slave_faces = slave_faces(elasticity, slave, surface.points, functions);
        surface.has_held    = Utilities::MPI::max(any_held(surface.slave_faces) ? 1 : 0, comm) > 0;
        return std::move(surface);
      }

    private:
      /// Up to which distance partners are looked for.
      double
      find_limit(const SearchRange &range) const
      {
        if (!at_rest || range.is_known)
          return std::max(range.reach, range.limit);
        // Points of pairs that never separate have to stay together from afar, and those whose gap
        // a formula tells may be anywhere.
        const double farthest = search_limit(elasticity, pair, range.reach),
                     first    = pair.separates && !pair.gap_is_given() ?
                                  std::min(range.reach, farthest) :
                                  farthest;
        const double overlap  = overlap_beyond(first, elasticity, pair, obstacle, slave);
        check_search_distance(overlap, pair);
        return overlap > 0 ? 1.1 * overlap : first;
      }

      MasterFaces<dim>
      master() const
      {
        const BoundaryFaces<dim> boundary =
          self ? self->masters(slave) : BoundaryFaces<dim>(configuration, pair.master);
        MasterFaces<dim> faces =
          master_faces(configuration, boundary, method.predictor() == Predictor::normal_stress);
        if (!at_rest && !is_laid && integration.rule == Rule::segments)
          faces.inner_sides = inner_sides(elasticity.mesh(), pair.master, boundary);
        if (self)
          faces.rest = boundary.rest;
        return faces;
      }

      /// Points that are laid already say which faces are slaves.
      SelfContact<dim>
      split() const
      {
        if (!is_laid)
          // Not the limit, which depends on what was before.
          return {slave, elasticity.lever() / 5, pair.self_side, comm};
        std::vector<bool> has_points(slave.faces.size(), false);
        for (const LaidPoint<dim> &point : laid)
          has_points[point.face] = true;
        return SelfContact<dim>(has_points);
      }

      void
      find_partners()
      {
        pair_within_limit();
        // Is there nothing within the search distance, if what moves does not come so far?
        if (at_rest && !is_far && pair.search_distance > limit &&
            Utilities::MPI::sum(paired.size(), comm) == 0)
          {
            limit = pair.search_distance;
            pair_within_limit();
          }
      }

      void
      pair_within_limit()
      {
        const SlaveSide<dim> side(slave.patches, self ? &slave.rest : nullptr);
        if (obstacle)
          paired = obstacle_points(configuration, slave.patches, *obstacle, integration, limit);
        else if (is_laid)
          paired = pair_laid_points(side, laid, master(), limit, comm, surface.statistics);
        else
          {
            auto pairing =
              self ? pair_of_itself() :
                     pair_points(side, master(), integration, limit, comm, surface.statistics);
            paired = std::move(pairing.points);
            seams  = std::move(pairing.seams);
            weigh_at_rest(slave, seams);
          }
        drop_empty_points(slave.patches, paired);
      }

      /// Slaves alone look for partners; they are numbered as the faces of the whole surface.
      Pairing<dim>
      pair_of_itself()
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
        for (auto *points : {&result.points, &result.seams})
          for (PairedPoint<dim> &point : *points)
            point.face = numbers[point.face];
        return result;
      }

      void
      make_points()
      {
        std::vector<double> gaps;
        if (!at_rest)
          {
            lay_points();
            if (needs_gaps_at_rest(pair))
              gaps = gaps_at_rest(elasticity, pair, obstacle, slave, limit, paired);
          }
        surface.points =
          contact_points(configuration, pair, method, slave, integration, paired, gaps);
        check_gaps(pair, surface.points, comm);
        check_stresses(surface.points, comm);
        surface.sees_nothing = !is_far && Utilities::MPI::sum(paired.size(), comm) == 0;
      }

      /// To be taken again where surfaces move on.
      void
      lay_points()
      {
        if (!is_laid || obstacle)
          weigh_at_rest(slave, paired);
        surface.laid = laid;
        if (!is_laid)
          for (const PairedPoint<dim> &point : paired)
            surface.laid.push_back({point.face,
                                    point.xi,
                                    point.weight,
                                    {point.partner.face_center, point.partner.size}});
      }

      void
      choose_points()
      {
        surface.overlap = deepest_overlap(surface.points, comm);
        if (at_rest && !pair.gap_is_given())
          check_search_distance(surface.overlap, pair);
        surface.reach = std::max(surface.reach, 2 * surface.overlap);
        if (!pair.separates)
          keep_touching(pair, slave, paired, surface.points);
        else if (surface.reach < limit)
          keep_candidates(surface.reach, slave, paired, surface.points);
      }

      std::vector<PressureNodes>
      set_shapes()
      {
        surface.seams = make_seams(elasticity, slave, seams);
        if (method.needs_slip())
          surface.seam_frames = surface_frames(slave, seams);
        const std::vector<PressureNodes> functions = set_pressure_functions(elasticity,
                                                                            method,
                                                                            integration.basis,
                                                                            slave,
                                                                            paired,
                                                                            seams,
                                                                            surface.points,
                                                                            surface.seams);
        const unsigned int               n_prescribed =
          std::count_if(functions.begin(), functions.end(), [](const PressureNodes &face) {
            return face.covered > 0 && face.own.empty();
          });
        const bool some_prescribed = Utilities::MPI::max(n_prescribed, comm) > 0,
                   some_free = Utilities::MPI::max(has_shapes(surface.points) ? 1 : 0, comm) > 0;
        if (some_prescribed && (!obstacle || !some_free))
          throw SceneError(
            pair.slave_place + ": the displacement of faces of '" + pair.slave +
            "' is prescribed in normal direction at all nodes (over-constrained), so that they "
            "cannot carry a multiplier; exchange Slave and Master, or set Contact method/Method = "
            "penalty");
        return functions;
      }

      const Configuration<dim>          &configuration;
      const Elasticity<dim>             &elasticity;
      const MPI_Comm                     comm;
      const bool                         at_rest;
      const ContactPair<dim>            &pair;
      const Obstacle<dim>               *obstacle;
      const ContactMethod               &method;
      const Integration                 &integration;
      const BoundaryFaces<dim>           slave;
      const std::vector<LaidPoint<dim>> &laid;
      const bool                         is_laid;
      double                             limit;
      bool                               is_far = false; ///< by boxes, farther than the limit
      std::optional<SelfContact<dim>>    self;           ///< where slave and master are one surface
      std::vector<PairedPoint<dim>>      paired;         ///< as long as surface.points
      std::vector<PairedPoint<dim>>      seams;          ///< as long as surface.seams
      ContactSurface<dim>                surface;
    };
  } // namespace



  template <int dim>
  ContactSurface<dim>
  one_sided_surface(const Configuration<dim>          &configuration,
                    const ContactPair<dim>            &pair,
                    const Obstacle<dim>               *obstacle,
                    const ContactMethod               &method,
                    const Integration                 &integration,
                    const SearchRange                 &range,
                    const std::vector<LaidPoint<dim>> &laid)
  {
    return OneSided<dim>(configuration, pair, obstacle, method, integration, range, laid).make();
  }



#define INSTANTIATE(dim)                                                                           \
  template ContactSurface<dim> one_sided_surface(const Configuration<dim> &,                       \
                                                 const ContactPair<dim> &,                         \
                                                 const Obstacle<dim> *,                            \
                                                 const ContactMethod &,                            \
                                                 const Integration &,                              \
                                                 const SearchRange &,                              \
                                                 const std::vector<LaidPoint<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
