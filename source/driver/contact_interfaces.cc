// SPDX-License-Identifier: Apache-2.0
#include "driver/contact_interfaces.h"

#include "base/solver_failure.h"
#include "contact/constraints/geometric_stiffness.h"
#include "contact/constraints/inactive_pairs.h"
#include "contact/constraints/pressure_functions.h"
#include "contact/search/boundary_faces.h"
#include "contact/search/obstacle_path.h"
#include "contact/search/search_radius.h"
#include "scene/expected_motion.h"
#include <signorini/base/text.h>
#include <signorini/contact/methods/method.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

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
    for (ContactPair<dim> &pair : decisions.pairs)
      if (pair.pretension.given())
        set_direction_of_pretension(pair);
    for (const ContactPair<dim> &pair : decisions.pairs)
      candidate_gap.push_back(pair.compliance.reach() +
                              (elasticity.has_unsupported_modes() ?
                                 std::max(gap_decrease, elasticity.mesh().size() / 10) :
                                 gap_decrease));
  }



  // The direction along which a bolt is shortened, of unit length. The sides of its section must be
  // apart: nodes that belong to both would hold them together. Collective.
  template <int dim>
  void
  ContactInterfaces<dim>::set_direction_of_pretension(ContactPair<dim> &pair) const
  {
    const MPI_Comm       comm      = elasticity.mesh().communicator();
    Point<dim>          &direction = pair.pretension.direction;
    const Tensor<1, dim> normal    = BoundaryFaces<dim>(elasticity, pair.slave).mean_normal(comm);
    if (direction.norm() == 0)
      {
        direction = Point<dim>(normal);
        if (direction.norm() < 0.1)
          throw SceneError(pair.slave_location + ": '" + pair.slave +
                           "' is a section with a pretension, but its normals have all "
                           "directions; set Pretension direction");
      }
    direction /= direction.norm();
    if (direction * normal <= 0)
      throw SceneError(pair.slave_location +
                       ": Pretension direction points into the slave, so that a tension would be a "
                       "pressure; give it the opposite sign");
    const auto slave     = nodes_of_boundaries(elasticity, {pair.slave}),
               master    = nodes_of_boundaries(elasticity, {pair.master});
    const bool is_shared = std::any_of(slave.begin(), slave.end(), [&](const auto node) {
      return master.count(node) > 0;
    });
    if (Utilities::MPI::max(is_shared ? 1 : 0, comm) > 0)
      throw SceneError(
        pair.slave_location + ": '" + pair.slave + "' and '" + pair.master +
        "' are the sides of a section with a pretension, but have common nodes, which "
        "hold them together; let the section end at the surface of the body");
    if (elasticity.model() == Model::axisymmetric && std::abs(direction[0]) > 1e-6)
      throw SceneError(
        pair.slave_location +
        ": with Model = axisymmetric a pretension is along the axis; choose a section "
        "across it, or set Pretension direction = 0,1");
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
    if (!pair.acts(elasticity.time()))
      {
        ContactSurface<dim> without_points;
        without_points.can_separate = pair.can_separate;
        without_points.is_tied      = pair.is_tied;
        without_points.is_apart     = true;
        return without_points;
      }
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
  // tenths of the area. A coefficient of friction by place or slip is that of the slave as named.
  // Collective.
  template <int dim>
  void
  ContactInterfaces<dim>::exchange_sides(const Configuration<dim> &configuration,
                                         const unsigned int        i)
  {
    const MPI_Comm    comm  = elasticity.mesh().communicator();
    ContactPair<dim> &pair  = decisions.pairs[i];
    const Sides       sides = my_surfaces[i].sides;
    if (!configuration.is_reference() || pair.is_self() || pair.sides == SideChoice::as_named ||
        pair.friction.depends_on_points() || scene.contact.chosen().unbiased() ||
        !sides.should_be_exchanged() || unexchangeable.count(pair.name) > 0)
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
      const std::vector<SearchTolerance> of_pairs =
        search_tolerances(configuration, keeps_integration_points);
      std::vector<ContactSurface<dim>> former = std::move(my_surfaces);
      build_time                              = elasticity.time();
      my_surfaces.clear();
      // Each pair is searched in turn on all ranks together.
      try
        {
          // Tied pairs are the last ones, since they leave nodes to the slaves of others.
          my_surfaces.resize(decisions.pairs.size());
          for (const bool is_tied : {false, true})
            {
              std::vector<std::string> contact_slaves;
              for (const ContactPair<dim> &pair : decisions.pairs)
                if (is_tied && !pair.is_tied)
                  contact_slaves.push_back(pair.slave);
              for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
                if (decisions.pairs[i].is_tied == is_tied)
                  {
                    decisions.pairs[i].contact_slaves = contact_slaves;
                    my_surfaces[i]                    = surface_of(configuration,
                                                decisions.pairs[i],
                                                of_pairs[i],
                                                keeps_integration_points ? &former[i] : nullptr);
                    exchange_sides(configuration, i);
                  }
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
    set_compliance();
    if (contact->has_stress() && contact->theta != method.theta() && !noted_theta)
      {
        out
          << "  several pairs share parts of a surface: Contact method/Nitsche/Theta = 0 is used, "
             "because the consistency terms of other values would count twice there"
          << std::endl;
        noted_theta = true;
      }
    build_displacement = configuration.displacement();
    overlaps_on_finer_mesh.clear();
    const auto n_rows = [&](const unsigned int i) {
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
        if (!pair.can_separate && pair.acts(build_time) && n_rows(i) == 0)
          throw SceneError(
            pair.master_location + ": no point of '" + pair.slave +
            "' touches the master of this pair " +
            (pair.is_tied ? "that is tied" : "with Separation = none") + "; " +
            (pair.image.is_master() ? "close the gap, or " :
                                      "correct Master rotation, Master axis or Master shift, or ") +
            (pair.search_distance > 0 ? "set a larger" : "set its") + " Search distance");
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
  // solution. Faces on the next mesh are half as large, and new nodes on curved boundaries move by
  // less than an eighth of an old face where that subtends less than a radian. Motions decrease
  // with the error.
  template <int dim>
  void
  ContactInterfaces<dim>::invalidate()
  {
    for (unsigned int i = 0; i < my_surfaces.size(); ++i)
      known_tolerances[i] = last_approach.empty() ? SearchTolerance() : tolerance_from_solution(i);
    last_approach.clear();
    overlaps_on_finer_mesh.clear();
    for (const ContactSurface<dim> &surface : my_surfaces)
      overlaps_on_finer_mesh.push_back(2 * surface.overlap + surface.face_size / 4);
    for (unsigned int i = 0; i < candidate_gap_near_solution.size(); ++i)
      {
        double &near = candidate_gap_near_solution[i];
        near /= 2;
        if (i < my_surfaces.size() && i < near_approach.size())
          near = std::min(near,
                          std::max({near_candidates / 2 * my_surfaces[i].face_size,
                                    4 * near_approach[i],
                                    touching * elasticity.mesh().size()}));
      }
    near_approach.clear();
    my_surfaces.clear();
    rows.reset();
    build_displacement = LA::Vector();
  }



  // The name of an obstacle whose shape has no closest point for some contact point of any rank;
  // empty: there is none. Collective.
  template <int dim>
  std::string
  ContactInterfaces<dim>::obstacle_without_projection() const
  {
    for (unsigned int i = 0; i < my_surfaces.size(); ++i)
      if (const Obstacle<dim> *obstacle = scene.obstacle_of(decisions.pairs[i]);
          obstacle && !obstacle->shape->is_attached())
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



  // Interference factors and temperatures of the time t enter the gap operator without a new
  // search.
  template <int dim>
  void
  ContactInterfaces<dim>::set_time(const double t, const InternalFields &internal)
  {
    std::vector<double> shares;
    for (const ContactPair<dim> &pair : decisions.pairs)
      shares.push_back(pair.interference.value({}, t));
    contact->set_interference(shares);
    if (scene.contact.chosen().has_friction)
      set_friction(t, internal);
    if (!contact->S_thermal.empty())
      contact->set_temperature_change(elasticity.thermal().coefficients());
  }



  // Gaps that change with time without any displacement: formulas in t, of gaps and of shapes.
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
        if (has_time_dependent_gap(pair) || pair.acts(build_time) != pair.acts(elasticity.time()))
          return true;
        const bool is_between_bodies = !scene.obstacle_of(pair);
        return with_stress &&
               (surface_loads_vary(mesh, elasticity.loads(), pair.slave) ||
                (is_between_bodies && surface_loads_vary(mesh, elasticity.loads(), pair.master)));
      });
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
