// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "contact/interface/geometry_change.h"
#include "contact/interface/surface.h"
#include "scene/decisions.h"

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <set>

namespace Signorini
{
  /// The contact pairs of a scene on the present mesh: how far projections are looked for, the
  /// surfaces that were found, and the gap operator that the solver sees. How far surfaces may come
  /// closer is guessed before the first solution and checked after each. Keeps references to its
  /// arguments.
  template <int dim>
  class ContactInterfaces
  {
  public:
    /// @param decisions whose pairs may be exchanged by build()
    ContactInterfaces(Decisions<dim>             &decisions,
                      const Elasticity<dim>      &elasticity,
                      dealii::TimerOutput        &timer,
                      dealii::ConditionalOStream &out);

    /// Search, and assemble the gap operator, which ends all references to the former one and to
    /// the surfaces. Slave and master of pairs are exchanged where their stiffness and their meshes
    /// ask for it, while they are at rest. Throws SceneError where a pair that has to see its
    /// projection does not.
    /// @param is_near surfaces are about where they will be: few candidates are enough
    /// @param keeps_integration_points the points of integration are those of the last build(),
    /// which was on this mesh and not at rest, and stay with the master's faces as long as these
    /// are as good
    void
    build(const Configuration<dim> &configuration,
          bool                      is_near                  = false,
          bool                      keeps_integration_points = false);

    /// Before the mesh changes: what was built belongs to it.
    void
    invalidate();

    /// What was learnt of the pairs, for a checkpoint: how far to look, which sides are exchanged.
    nlohmann::ordered_json
    save() const;

    /// Before the first build(). Throws SceneError if the pairs are others. The pairs are those of
    /// the scene, and exchanged as they were. Without `reach`, `nearby`, `known`, how far to look
    /// is guessed as at first.
    void
    load(const nlohmann::ordered_json &save);

    // After build():

    const std::vector<ContactSurface<dim>> &
    surfaces() const
    {
      return my_surfaces;
    }

    GapOperator &
    gap_operator()
    {
      return *contact;
    }

    const GapOperator &
    gap_operator() const
    {
      return *contact;
    }

    /// Throws SolverFailure if obstacles would go through slaves on their way from one place to
    /// another. @param from, to displacements. Collective.
    void
    check_tunnelling(const LA::Vector &from, const LA::Vector &to) const;

    /// Throws SolverFailure if a slave is in the obstacle of its pair, which has no pressure.
    /// @param u displacement. Collective.
    void
    check_missed_penetration(const LA::Vector &u, const LA::Vector &pressure) const;

    /// Where surfaces have moved: let forces of such tractions turn with them, by
    /// geometric_stiffness(). Collective.
    void
    build_geometric_stiffness(const PointVectors &traction);

    /// An obstacle of which nobody knows where it is beside surfaces that have moved, see
    /// ObstacleShape::has_closest_point(); empty if there is none. Collective.
    std::string
    obstacle_without_projection() const;

    /// What contact at rest neglects with displacement u: the pair where that is most. Collective.
    GeometryChange
    neglected(const LA::Vector &u, const LA::Vector &pressure) const;

    /// True if no surface has moved by more than a small part of its faces since build(), so that
    /// the points of integration may stay. Collective.
    bool
    is_geometry_current(const LA::Vector &u) const;

    /// True if surfaces have moved so far with displacement u, from where they were for build(),
    /// that others than the candidates may touch: then more are, with the next build().
    bool
    search_radius_exceeded(const LA::Vector &u);

    /// Look farther, with the next build(), for what may stop loose bodies. False if that is far
    /// enough.
    bool
    enlarge_search_radius();

    /// The share of initial overlaps that counts at time t, and the stress of the temperatures that
    /// the bodies have now.
    void
    set_time(double t);

    /// Two pairs that press the same nodes, as a cause of singular systems, in words; may be empty.
    /// Collective.
    std::string
    overconstrained_nodes(const LA::Vector &active) const;

    /// What build() found was of another time, and is not the same now: gaps by formulas, and loads
    /// on surfaces of which a method asks for the stress.
    bool
    is_outdated() const;

    /// What was left out, for the results.
    std::vector<std::string>
    skipped_items() const;

  private:
    /// Does the gap at rest depend on time?
    bool
    has_time_dependent_gap(const ContactPair<dim> &pair) const;

    /// The change of displacements since build().
    LA::Vector
    displacement_since_build(const LA::Vector &u) const;

    ContactSurface<dim>
    surface_of(const Configuration<dim>  &configuration,
               const ContactPair<dim>    &pair,
               const SearchTolerance     &range,
               const ContactSurface<dim> *former = nullptr) const;

    /// How far to look for each pair in a configuration that it has moved to since build().
    std::vector<SearchTolerance>
    search_tolerances(const Configuration<dim> &configuration);

    SearchTolerance
    reference_tolerance(unsigned int i) const;

    /// What the solution tells of the ranges on finer meshes.
    SearchTolerance
    tolerance_from_solution(unsigned int i) const;

    /// By how much the surfaces of each pair may have come closer with a displacement.
    std::vector<double>
    approach_distances(const LA::Vector &since) const;

    /// If the mesh asks for it, and if the other side can be slave.
    void
    exchange_sides(const Configuration<dim> &configuration, unsigned int i);

    Decisions<dim>             &decisions;
    const Scene<dim>           &scene;
    const Elasticity<dim>      &elasticity;
    dealii::TimerOutput        &timer;
    dealii::ConditionalOStream &out;

    std::vector<double> candidate_gap;               ///< of each pair: gaps of candidates
    std::vector<double> candidate_gap_near_solution; ///< the same where surfaces are about in place
    std::vector<SearchTolerance> known_tolerances;   ///< at rest, from coarser meshes
    std::vector<double> last_approach; ///< since rest, by the last solution; empty: there is none
    bool                built_near_solution = false;
    std::vector<ContactSurface<dim>> my_surfaces;
    std::unique_ptr<ContactRows>     rows;
    std::unique_ptr<GapOperator>     contact;
    LA::Vector                       build_displacement; ///< displacement; empty: at rest
    double                           build_time = 0;     ///< time
    std::set<std::string>            unexchangeable;     ///< pairs whose master cannot be the slave
    bool                             noted_theta = false;
  };

  /// How far surfaces of a scene may come closer: sound guesses save a second solution.
  template <int dim>
  double
  largest_expected_approach(const Scene<dim> &scene, const Mesh<dim> &mesh);
} // namespace Signorini
