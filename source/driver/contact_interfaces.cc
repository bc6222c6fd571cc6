// SPDX-License-Identifier: Apache-2.0
#include "driver/contact_interfaces.h"

#include "base/solver_failure.h"
#include "contact/constraints/geometric_stiffness.h"
#include "contact/constraints/inactive_pairs.h"
#include "contact/search/obstacle_path.h"
#include "contact/search/search_radius.h"
#include "scene/expected_motion.h"
#include <signorini/base/text.h>
#include <signorini/contact/methods/method.h>
#include <signorini/parameters/raw.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The accuracy of node positions in mesh files, relative to the size of the model.
    constexpr double touching = 1e-6;
  } // namespace



  template <int dim>
  ContactInterfaces<dim>::ContactInterfaces(Decisions<dim>        &decisions,
                                            const Elasticity<dim> &elasticity,
                                            TimerOutput           &timer,
                                            ConditionalOStream    &out)
    : decisions(decisions)
    , scene(decisions.scene)
    , elasticity(elasticity)
    , timer(timer)
    , out(out)
  {
    // The first candidate gap is the expected approach of surfaces; bodies without sufficient
    // supports may move farther before they find contact.
    const double gap_decrease = std::max(largest_expected_approach(scene, elasticity.mesh()),
                                         touching * elasticity.mesh().size());
    candidate_gap.assign(decisions.pairs.size(),
                         elasticity.has_unsupported_modes() ?
                           std::max(gap_decrease, elasticity.mesh().size() / 10) :
                           gap_decrease);
  }



  // The surface of one pair in a configuration, with the choices of the run for its method and
  // integration. Collective.
  template <int dim>
  ContactSurface<dim>
  ContactInterfaces<dim>::surface_of(const Configuration<dim>  &configuration,
                                     const ContactPair<dim>    &pair,
                                     const SearchTolerance     &range,
                                     const ContactSurface<dim> *former) const
  {
    return make_contact_surface(configuration,
                                pair,
                                scene.obstacle_of(pair),
                                scene.contact.chosen(),
                                decisions.integration_of(pair),
                                range,
                                former);
  }



  namespace
  {
    /// The area of the contact points of all ranks. Collective.
    template <int dim>
    double
    area_of(const ContactSurface<dim> &surface, const MPI_Comm comm)
    {
      double area = 0;
      for (const ContactPoint<dim> &point : surface.points)
        area += point.weight;
      return Utilities::MPI::sum(area, comm);
    }
  } // namespace



  // Exchange slave and master of pair i in the reference configuration if Sides requires it
  // (doc/theory, 3.6) and the settings allow it. The pair stays as it is, and is not tried again,
  // if the method is not valid with the other slave, or if the other slave covers less than nine
  // tenths of the area. Collective.
  template <int dim>
  void
  ContactInterfaces<dim>::exchange_sides(const Configuration<dim> &configuration,
                                         const unsigned int        i)
  {
    const MPI_Comm    comm  = elasticity.mesh().communicator();
    ContactPair<dim> &pair  = decisions.pairs[i];
    const Sides       sides = my_surfaces[i].sides;
    if (!configuration.is_reference() || pair.is_self() || pair.sides == SideChoice::as_named ||
        scene.contact.chosen().unbiased() || !sides.should_be_exchanged() ||
        unexchangeable.count(pair.name) > 0)
      return;
    ContactPair<dim> other = pair;
    other.exchange();
    try
      {
        scene.contact.chosen().check(decisions.integration_of(other),
                                     decisions.degree_of(other.slave));
        ContactSurface<dim> surface = surface_of(configuration, other, reference_tolerance(i));
        if (area_of(surface, comm) < 0.9 * area_of(my_surfaces[i], comm))
          throw SceneError("the other side sees less");
        my_surfaces[i] = std::move(surface);
      }
    catch (const SceneError &)
      {
        unexchangeable.insert(pair.name); // the other side cannot carry a pressure
        return;
      }
    out << "  pair " << pair.name << ": slave and master are exchanged, since '" << pair.slave
        << "' is " << short_text(sides.modulus, 2) << " times as stiff, with faces "
        << short_text(sides.size, 2) << " times as large" << std::endl;
    pair = other;
  }



  // The tolerances known from the solution on a coarser mesh, or else the present candidate gap.
  template <int dim>
  SearchTolerance
  ContactInterfaces<dim>::reference_tolerance(const unsigned int i) const
  {
    return known_tolerances[i].is_final ? known_tolerances[i] :
                                          SearchTolerance{candidate_gap[i], 0, false};
  }



  // Search tolerances for the next mesh from the solution on this one: the candidate gap is the
  // largest approach with a margin, and penetrations up to twice the deepest one are found. Pairs
  // whose gap does not result from motions keep the estimate.
  template <int dim>
  SearchTolerance
  ContactInterfaces<dim>::tolerance_from_solution(const unsigned int i) const
  {
    // If surfaces move farther than this, search_radius_exceeded() detects it.
    constexpr double        room = 1.5;
    const ContactPair<dim> &pair = decisions.pairs[i];
    const double            now  = room * last_approach[i],
                 so_far = pair.search_distance > 0 ? pair.search_distance : candidate_gap[i];
    // Gaps given by a formula do not depend on motions, and time-dependent ones change without
    // them.
    if (!pair.can_separate || pair.gap_is_given() || has_time_dependent_gap(pair) || now == 0 ||
        now >= so_far)
      return {};
    return {now, 2 * my_surfaces[i].overlap, true};
  }



  // In the reference configuration the estimated tolerances; in displaced ones they follow from the
  // motion since the last search: the search radius covers the deepest penetration plus the
  // approach since. Close to the solution few candidates suffice: at least half a face.
  template <int dim>
  std::vector<SearchTolerance>
  ContactInterfaces<dim>::search_tolerances(const Configuration<dim> &configuration)
  {
    std::vector<SearchTolerance> result;
    std::vector<double>          approaches;
    if (!configuration.is_reference() && !my_surfaces.empty())
      approaches = approach_distances(displacement_since_build(configuration.displacement()));
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      {
        if (configuration.is_reference())
          {
            result.push_back(reference_tolerance(i));
            continue;
          }
        // Candidates near the solution: enough for half a face, and never fewer than before.
        if (built_near_solution && !my_surfaces.empty())
          candidate_gap_near_solution[i] =
            std::max({candidate_gap_near_solution[i],
                      my_surfaces[i].face_size / 2, // 0 where nothing is in reach
                      touching * elasticity.mesh().size()});
        const ContactPair<dim> &pair = decisions.pairs[i];
        const bool is_other = has_time_dependent_gap(pair) && elasticity.time() != build_time;
        double     limit    = search_radius_of_pair(elasticity, pair, candidate_gap[i]);
        if (!my_surfaces.empty() && !is_other)
          {
            const double now =
              my_surfaces[i].overlap + std::max(0., pair.closes_below) + approaches[i];
            // Pairs that are bilateral, or closed by the input, may be far apart even if nothing
            // moves.
            limit = pair.can_separate && !pair.gap_is_given() ? now : std::max(limit, now);
          }
        result.push_back(
          {built_near_solution ? candidate_gap_near_solution[i] : candidate_gap[i], limit, false});
      }
    return result;
  }



  // A bound of the approach of the surfaces of each pair by the displacement `since` the last
  // search. Collective.
  template <int dim>
  std::vector<double>
  ContactInterfaces<dim>::approach_distances(const LA::Vector &since) const
  {
    const std::vector<double> displacements = largest_displacements(elasticity, since);
    std::vector<double>       result;
    for (const ContactPair<dim> &pair : decisions.pairs)
      result.push_back(
        largest_approach(elasticity, pair, scene.obstacle_of(pair), since, displacements));
    return result;
  }



  // Search all pairs, then number rows and assemble the gap operator. If the search fails (inverted
  // cells), the former surfaces are kept, which belong to the rows that still exist. Collective.
  template <int dim>
  void
  ContactInterfaces<dim>::build(const Configuration<dim> &configuration,
                                const bool                is_near,
                                const bool                keeps_integration_points)
  {
    const ContactMethod &method = scene.contact.chosen();
    built_near_solution         = is_near;
    // Shapes are set to the present time before all searches, since several pairs may share one.
    for (const Obstacle<dim> &obstacle : scene.obstacles)
      obstacle.shape->set_time(elasticity.time());
    candidate_gap_near_solution.resize(decisions.pairs.size(), 0.);
    known_tolerances.resize(decisions.pairs.size());
    {
      TimerOutput::Scope                 scope(timer, "search");
      const std::vector<SearchTolerance> of_pairs = search_tolerances(configuration);
      std::vector<ContactSurface<dim>>   former   = std::move(my_surfaces);
      build_time                                  = elasticity.time();
      my_surfaces.clear();
      // Each pair is searched in turn on all ranks together.
      try
        {
          for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
            {
              my_surfaces.push_back(surface_of(configuration,
                                               decisions.pairs[i],
                                               of_pairs[i],
                                               keeps_integration_points ? &former[i] : nullptr));
              exchange_sides(configuration, i);
            }
        }
      catch (const SolverFailure &)
        {
          my_surfaces = std::move(former);
          throw;
        }
    }
    TimerOutput::Scope scope(timer, "contact");
    // One gap operator for all pairs; each row belongs to one pair.
    rows =
      std::make_unique<ContactRows>(make_contact_rows(elasticity, my_surfaces, method.sampling()));
    contact = make_gap_operator(configuration, my_surfaces, *rows, method);
    // The penalty parameter of the error control applies to all pairs.
    contact->coefficients.epsilon *= decisions.penalty_factor;
    if (contact->has_stress() && contact->theta != method.theta() && !noted_theta)
      {
        out
          << "  several pairs share parts of a surface: Contact method/Nitsche/Theta = 0 is used, "
             "because the consistency terms of other values would count twice there"
          << std::endl;
        noted_theta = true;
      }
    build_displacement = configuration.displacement();
    const auto n_rows  = [&](const unsigned int i) {
      const auto own = std::count(contact->origin.pair.begin(), contact->origin.pair.end(), i);
      return Utilities::MPI::sum(own, elasticity.mesh().communicator());
    };
    // Pairs without any projection, or bilateral ones without any row, are errors of the input.
    for (unsigned int i = 0; i < my_surfaces.size(); ++i)
      {
        const ContactPair<dim> &pair = decisions.pairs[i];
        if (configuration.is_reference() && my_surfaces[i].has_no_projection &&
            pair.search_distance > 0 && !known_tolerances[i].is_final)
          throw SceneError(
            pair.master_location + ": no point of '" + pair.slave +
            "' has a projection onto the master: the surfaces are farther apart than the Search "
            "distance, or do not face each other; set a larger Search distance, or check Slave and "
            "Master");
        if (!pair.can_separate && n_rows(i) == 0)
          throw SceneError(
            pair.master_location + ": no point of '" + pair.slave +
            "' touches the master of this pair with Separation = none; close the gap, or " +
            (pair.search_distance > 0 ? "set a larger" : "set its") + " Search distance");
      }
  }



  // A large step may carry an obstacle through a thin body to its other side, where no point
  // penetrates it. Collective.
  template <int dim>
  void
  ContactInterfaces<dim>::check_tunnelling(const LA::Vector &from, const LA::Vector &to) const
  {
    TimerOutput::Scope       scope(timer, "search");
    const Configuration<dim> start(elasticity, from);
    for (const ContactPair<dim> &pair : decisions.pairs)
      if (const Obstacle<dim> *obstacle = scene.obstacle_of(pair))
        if (obstacle_tunnels(start, to, pair.slave, *obstacle))
          throw SolverFailure("the obstacle '" + obstacle->name + "' would pass through '" +
                              pair.slave +
                              "' in one load step (tunnelling); use smaller load steps");
  }



  // After a solution: obstacles that faces without contact points have passed through, or that a
  // body encloses, are failures of the load step. Collective.
  template <int dim>
  void
  ContactInterfaces<dim>::check_missed_penetration(const LA::Vector &u,
                                                   const LA::Vector &pressure) const
  {
    TimerOutput::Scope       scope(timer, "search");
    const std::vector<bool>  idle = inactive_pairs(*contact, pressure, decisions.pairs.size());
    const Configuration<dim> now(elasticity, u);
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      if (const Obstacle<dim> *obstacle = scene.obstacle_of(decisions.pairs[i]))
        {
          const std::string &slave = decisions.pairs[i].slave;
          std::vector<bool>  seen; // those of the faces with contact points
          if (!idle[i])
            for (const SlaveFace<dim> &face : my_surfaces[i].slave_faces)
              seen.push_back(face.degree > 0);
          if (penetrates_obstacle(now, slave, *obstacle, seen) ||
              encloses_obstacle(now, slave, *obstacle))
            throw SolverFailure("'" + slave + "' has passed through the obstacle '" +
                                obstacle->name +
                                "'; use smaller load steps, or refine the surface");
        }
  }



  // G of (5.9) for given tractions, about the displacement at which the surfaces were placed.
  // Collective.
  template <int dim>
  void
  ContactInterfaces<dim>::build_geometric_stiffness(const PointVectors &traction)
  {
    if (contact->at_rest())
      return;
    TimerOutput::Scope scope(timer, "contact");
    contact->moved.linearisation_point = build_displacement;
    contact->moved.G = geometric_stiffness(elasticity, my_surfaces, *rows, traction);
  }



  // Keep from the old mesh what refers to pairs and not to meshes: search tolerances from the last
  // solution. Faces on the next mesh are half as large.
  template <int dim>
  void
  ContactInterfaces<dim>::invalidate()
  {
    for (unsigned int i = 0; i < my_surfaces.size(); ++i)
      known_tolerances[i] = last_approach.empty() ? SearchTolerance() : tolerance_from_solution(i);
    last_approach.clear();
    my_surfaces.clear();
    rows.reset();
    build_displacement = LA::Vector();
    for (double &of_pair : candidate_gap_near_solution)
      of_pair /= 2;
  }



  // The name of an obstacle whose shape has no closest point for some contact point of any rank;
  // empty: there is none. Collective.
  template <int dim>
  std::string
  ContactInterfaces<dim>::obstacle_without_projection() const
  {
    for (unsigned int i = 0; i < my_surfaces.size(); ++i)
      if (const Obstacle<dim> *obstacle = scene.obstacle_of(decisions.pairs[i]))
        {
          const auto &points  = my_surfaces[i].points;
          const bool  unknown = std::any_of(points.begin(), points.end(), [&](const auto &point) {
            return !obstacle->shape->has_closest_point(point.position,
                                                       elasticity.rotation_length_scale());
          });
          if (Utilities::MPI::max(unknown ? 1 : 0, elasticity.mesh().communicator()) > 0)
            return obstacle->name;
        }
    return "";
  }



  // Contact forces at points from the pressures of rows (ghosted), then the geometry error of each
  // pair (doc/theory, 5.7); the largest estimated change of pressure counts.
  template <int dim>
  GeometryChange
  ContactInterfaces<dim>::neglected(const LA::Vector &u, const LA::Vector &pressure) const
  {
    const Configuration<dim> now(elasticity, u);
    LA::Vector               p(rows->owned, rows->writable, elasticity.mesh().communicator());
    p = pressure;
    GeometryChange largest;
    for (unsigned int i = 0; i < my_surfaces.size(); ++i)
      {
        // The force of each contact point: its shares of the tractions of the rows.
        std::vector<double> forces;
        for (const auto &shares : rows->shares[i])
          {
            forces.push_back(0);
            for (const auto &[row, weight] : shares)
              forces.back() += weight * p(row);
          }
        const ContactPair<dim> &pair = decisions.pairs[i];
        const GeometryChange    change =
          geometry_change(now, pair, scene.obstacle_of(pair), my_surfaces[i], forces);
        if (change.pressure > largest.pressure)
          largest = change;
      }
    return largest;
  }



  // In the reference configuration there is no displacement of the last search.
  template <int dim>
  LA::Vector
  ContactInterfaces<dim>::displacement_since_build(const LA::Vector &u) const
  {
    LA::Vector since = u;
    if (build_displacement.size() > 0)
      since -= build_displacement;
    return since;
  }



  // Surfaces have settled if no pair has approached by more than 2 % of a face since the last
  // search.
  template <int dim>
  bool
  ContactInterfaces<dim>::is_geometry_current(const LA::Vector &u) const
  {
    constexpr double          small      = 0.02; // in face sizes
    const std::vector<double> approaches = approach_distances(displacement_since_build(u));
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      if (approaches[i] > small * my_surfaces[i].face_size)
        return false;
    return true;
  }



  // A bound of the approach of each pair is compared with the candidate gap of the search: faces
  // beyond it were no candidates. Exceeded tolerances are doubled for the next search; tolerances
  // known from coarser meshes are discarded first, without a message. Pairs with a search distance
  // given by the user are not searched beyond it. Collective.
  template <int dim>
  bool
  ContactInterfaces<dim>::search_radius_exceeded(const LA::Vector &u)
  {
    const std::vector<double> approaches = approach_distances(displacement_since_build(u));
    const bool                at_rest    = build_displacement.size() == 0;
    bool                      too_short  = false;
    // Kept for the search tolerances of the next mesh, see tolerance_from_solution().
    if (at_rest)
      last_approach = approaches;
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      {
        const ContactPair<dim> &pair     = decisions.pairs[i];
        const double            approach = approaches[i];
        if (approach <= my_surfaces[i].candidate_gap || !pair.can_separate)
          continue;
        if (at_rest && known_tolerances[i].is_final)
          {
            known_tolerances[i] = {};
            too_short           = true;
            continue;
          }
        out << "  pair " << pair.name << ": its surfaces may have come closer by " << approach
            << ", farther than " << my_surfaces[i].candidate_gap;
        if (pair.search_distance > 0 && at_rest &&
            my_surfaces[i].candidate_gap >= pair.search_distance)
          out
            << ", its Search distance: contact beyond it is not detected; set a larger Search distance"
            << std::endl;
        else
          {
            out << ": searching again" << std::endl;
            (built_near_solution ? candidate_gap_near_solution : candidate_gap)[i] = 2 * approach;
            too_short                                                              = true;
          }
      }
    return too_short;
  }



  // Radii grow by a factor of four up to the size of the model plus the expected motion, so that
  // repeated calls end.
  template <int dim>
  bool
  ContactInterfaces<dim>::enlarge_search_radius()
  {
    const double size     = elasticity.mesh().size();
    const double farthest = size + largest_expected_approach(scene, elasticity.mesh());
    bool         any      = false;
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      {
        const ContactPair<dim> &pair = decisions.pairs[i];
        const double            most = pair.search_distance > 0 ? pair.search_distance : farthest;
        if (!pair.can_separate || candidate_gap[i] >= most)
          continue;
        candidate_gap[i]    = 4 * std::max(candidate_gap[i], size / 10);
        known_tolerances[i] = {};
        any                 = true;
      }
    if (any)
      out << "  bodies without sufficient supports may move farther than the search distance: "
             "searching again with a larger one"
          << std::endl;
    return any;
  }



  // Interference factors and temperatures of the time t enter the gap operator without a new
  // search.
  template <int dim>
  void
  ContactInterfaces<dim>::set_time(const double t)
  {
    std::vector<double> shares;
    for (const ContactPair<dim> &pair : decisions.pairs)
      shares.push_back(pair.interference.value({}, t));
    contact->set_interference(shares);
    if (contact->S_thermal.m() > 0)
      contact->set_temperature_change(elasticity.thermal().coefficients());
  }



  // Gaps that change with time without any displacement: formulas in t, and moving obstacles.
  template <int dim>
  bool
  ContactInterfaces<dim>::has_time_dependent_gap(const ContactPair<dim> &pair) const
  {
    const Obstacle<dim> *obstacle = scene.obstacle_of(pair);
    return pair.gap_depends_on_time() || (obstacle && obstacle->shape->depends_on_time());
  }



  // True if the gap operator of another time is no longer valid: gaps depend on time, or with
  // Nitsche's method loads on the surfaces enter the normal stress.
  template <int dim>
  bool
  ContactInterfaces<dim>::is_outdated() const
  {
    if (elasticity.time() == build_time)
      return false;
    const bool with_stress =
      scene.contact.chosen().pressure_shift() == PressureShift::normal_stress;
    const auto &mesh = elasticity.mesh();
    return std::any_of(
      decisions.pairs.begin(), decisions.pairs.end(), [&](const ContactPair<dim> &pair) {
        if (has_time_dependent_gap(pair))
          return true;
        const bool is_between_bodies = !scene.obstacle_of(pair);
        return with_stress &&
               (surface_loads_vary(mesh, elasticity.loads(), pair.slave) ||
                (is_between_bodies && surface_loads_vary(mesh, elasticity.loads(), pair.master)));
      });
  }



  // A node is over-constrained if rows of two pairs are active there. The numbers of one such pair
  // of pairs are encoded in one integer, so that all ranks agree on the largest code. Collective.
  template <int dim>
  std::string
  ContactInterfaces<dim>::overconstrained_nodes(const LA::Vector &active) const
  {
    std::map<types::global_dof_index, unsigned int> pair_of_node;
    unsigned int                                    both[2] = {0, 0}; // one more than numbers
    const IndexSet                                  rows    = active.locally_owned_elements();
    auto                                            row     = rows.begin();
    for (unsigned int k = 0; k < contact->origin.node.size(); ++k, ++row)
      if (active(*row) > 0)
        if (const auto [at, is_new] =
              pair_of_node.insert({contact->origin.node[k], contact->origin.pair[k]});
            !is_new)
          {
            both[0] = at->second + 1;
            both[1] = contact->origin.pair[k] + 1;
          }
    const unsigned int code = both[0] * decisions.pairs.size() + both[1],
                       most = Utilities::MPI::max(code, elasticity.mesh().communicator());
    if (most == 0)
      return "";
    const unsigned int second = (most - 1) % decisions.pairs.size(),
                       first  = (most - 1) / decisions.pairs.size() - 1;
    return "; pairs '" + decisions.pairs[first].name + "' and '" + decisions.pairs[second].name +
           "' are active at the same nodes (over-constrained): if they act in the same direction, "
           "remove one, or use a penalty method";
  }



  // Pairs that were not searched, since bounds show that they cannot come into contact.
  template <int dim>
  std::vector<std::string>
  ContactInterfaces<dim>::skipped_items() const
  {
    std::vector<std::string> result;
    for (unsigned int i = 0; i < my_surfaces.size(); ++i)
      if (my_surfaces[i].is_apart)
        result.push_back("pair " + decisions.pairs[i].name +
                         ": its surfaces do not come into contact");
    return result;
  }



  // An upper bound of the approach that the scene leads to expect [length], for the first search.
  template <int dim>
  double
  largest_expected_approach(const Scene<dim> &scene, const Mesh<dim> &mesh)
  {
    // Both surfaces may move towards each other, and estimates may be too small.
    return 3 * expected_motion(scene, mesh.extent());
  }



#define INSTANTIATE(dim)                                                                           \
  template class ContactInterfaces<dim>;                                                           \
  template double largest_expected_approach(const Scene<dim> &, const Mesh<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
