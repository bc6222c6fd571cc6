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
  /// The contact interfaces of a model: its pairs on the present mesh, with their search
  /// tolerances, the discretised surfaces, and the gap operator that the solver uses. How far
  /// surfaces may approach each other is estimated before the first solution and checked after
  /// each. Keeps references to its arguments.
  template <int dim>
  class ContactInterfaces
  {
  public:
    /// @param decisions slave and master of its pairs may be exchanged by build()
    ContactInterfaces(Decisions<dim>             &decisions,
                      const Elasticity<dim>      &elasticity,
                      dealii::TimerOutput        &timer,
                      dealii::ConditionalOStream &out);

    /// Search for contact and assemble the gap operator. Invalidates all references to the former
    /// one and to the surfaces. In the reference configuration, slave and master of a pair are
    /// exchanged where stiffness and meshes require it and the settings allow it. Throws SceneError
    /// where a pair without alternatives has no projection. Collective.
    /// @param is_near the configuration is close to the solution, so that few candidates suffice
    /// @param keeps_integration_points project the integration points of the last build() again,
    /// which was on this mesh and in a displaced configuration; each keeps its master face as long
    /// as that is as good as the nearest one
    void
    build(const Configuration<dim> &configuration,
          bool                      is_near                  = false,
          bool                      keeps_integration_points = false);

    /// Discard what build() made; to be called before the mesh changes.
    void
    invalidate();

    /// The state of the pairs for a checkpoint: their search tolerances, and which of them are
    /// exchanged.
    nlohmann::ordered_json
    save() const;

    /// Restore what save() has returned; to be called before the first build(). Throws SceneError
    /// if the pairs differ from those of the model. Pairs are exchanged as they were. Without the
    /// entries `reach`, `nearby`, `known`, the search tolerances are estimated as at first.
    void
    load(const nlohmann::ordered_json &save);

    // After build():

    /// The surfaces of the pairs, in the order of the pairs.
    const std::vector<ContactSurface<dim>> &
    surfaces() const
    {
      return my_surfaces;
    }

    /// The gap operator of all pairs together.
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

    /// Throws SolverFailure if an obstacle would tunnel through a slave between two displacements.
    /// Collective.
    /// @param from displacement before the increment @param to after it
    void
    check_tunnelling(const LA::Vector &from, const LA::Vector &to) const;

    /// Throws SolverFailure if a slave penetrates the obstacle of its pair without contact
    /// pressure. Collective.
    /// @param u displacement @param pressure at the contact points
    void
    check_missed_penetration(const LA::Vector &u, const LA::Vector &pressure) const;

    /// Build the contact geometric stiffness of the gap operator for given tractions, see
    /// geometric_stiffness(). No effect in the reference configuration. Collective.
    /// @param traction at the contact points
    void
    build_geometric_stiffness(const PointVectors &traction);

    /// The name of an obstacle without closest-point projection, see
    /// ObstacleShape::has_closest_point(), which therefore cannot be used in displaced
    /// configurations; empty if there is none. Collective.
    std::string
    obstacle_without_projection() const;

    /// The geometry error of small sliding at displacement u, for the pair where it is largest.
    /// Collective.
    /// @param pressure at the contact points
    GeometryChange
    neglected(const LA::Vector &u, const LA::Vector &pressure) const;

    /// True if no surface has moved by more than a small fraction of its faces since build(), so
    /// that the integration points can be kept. Collective.
    bool
    is_geometry_current(const LA::Vector &u) const;

    /// True if, since build(), surfaces have moved so far that faces other than the candidates may
    /// touch. Then the tolerances are enlarged for the next build(). Collective.
    /// @param u displacement of the solution
    bool
    search_radius_exceeded(const LA::Vector &u);

    /// Enlarge the search radius for the next build(), to find surfaces that may constrain
    /// rigid-body modes. Returns false if it is large enough already.
    bool
    enlarge_search_radius();

    /// Let the normal gaps of ties that begin late count from their beginning: at points where it
    /// is not known, it is that of the displacement u. Collective.
    /// @param internal variables of the points, which are changed
    /// @return whether there are any at which it was not known
    bool
    set_gaps_at_start(const LA::Vector &u, InternalFields &internal);

    /// True if the reference gap of a pair depends on time.
    bool
    has_time_dependent_gap(const ContactPair<dim> &pair) const;

    /// Set the time for the gap operator: interference factors of the pairs, and the stress due to
    /// the present temperatures of the bodies, and friction coefficients. Collective.
    /// @param internal variables of the contact points at the start of the load step
    void
    set_time(double t, const InternalFields &internal = InternalFields());

    /// Check the friction coefficients at given pressures. Throws SceneError on all ranks where one
    /// is negative, or no number. Collective.
    /// @param internal variables of the contact points at the start of the load step
    void
    check_friction(double t, const InternalFields &internal, const LA::Vector &pressure) const;

    /// See Signorini::set_bonds(). Collective.
    /// @param intact 1 where the bond of a point is intact, else 0
    void
    set_bonds(LA::Vector &intact);

    /// See Signorini::break_bonds(). Collective.
    bool
    break_bonds(const PointVectors &traction, LA::Vector &intact);

    /// A description of two pairs with active points at the same nodes, which over-constrain them
    /// and may make the system singular; empty if there are none. Collective.
    std::string
    overconstrained_nodes(const LA::Vector &active) const;

    /// True if build() was at another time, and its result depends on time: gaps given by formulas,
    /// pairs that begin or end, and surface loads where the method uses the normal stress.
    bool
    is_outdated() const;

    /// The pairs that were skipped, for the results.
    std::vector<std::string>
    skipped_items() const;

  private:
    /// The accuracy of node positions in mesh files, relative to the size of the model.
    static constexpr double touching = 1e-6;
    /// Close to the solution, the gap of candidates in sizes of a face, if motions do not require
    /// more.
    static constexpr double near_candidates = 0.1;

    /// Let the points have the compliance of their pairs.
    void
    set_compliance();

    /// Set the friction coefficients of all points for a time.
    /// @param internal variables of the points at the start of the load step
    void
    set_friction(double t, const InternalFields &internal);

    /// The position of a point in the reference configuration.
    dealii::Point<dim>
    position_of(dealii::types::global_dof_index point) const;


    /// The change of the displacement since build().
    LA::Vector
    displacement_since_build(const LA::Vector &u) const;

    /// The surface of a pair, see make_contact_surface().
    ContactSurface<dim>
    surface_of(const Configuration<dim>  &configuration,
               const ContactPair<dim>    &pair,
               const SearchTolerance     &range,
               const ContactSurface<dim> *former = nullptr) const;

    /// The search tolerances of the pairs in a displaced configuration, by how far they have moved
    /// since build().
    std::vector<SearchTolerance>
    search_tolerances(const Configuration<dim> &configuration, bool keeps_integration_points);

    /// The search tolerance of pair i in the reference configuration: from a solution on a coarser
    /// mesh, or estimated.
    SearchTolerance
    reference_tolerance(unsigned int i) const;

    /// The search tolerance of pair i on finer meshes, from the last solution.
    SearchTolerance
    tolerance_from_solution(unsigned int i) const;

    /// Upper bounds of the approach of each pair's surfaces due to a displacement increment
    /// [length]. Collective.
    std::vector<double>
    approach_distances(const LA::Vector &since) const;

    void
    set_direction_of_pretension(ContactPair<dim> &pair) const;

    /// Exchange slave and master of pair i if their meshes and stiffness require it and the other
    /// side can be slave.
    void
    exchange_sides(const Configuration<dim> &configuration, unsigned int i);

    Decisions<dim>             &decisions;
    const Scene<dim>           &scene;
    const Elasticity<dim>      &elasticity;
    dealii::TimerOutput        &timer;
    dealii::ConditionalOStream &out;

    /// Gap up to which faces are candidates [length], for each pair.
    std::vector<double> candidate_gap;
    std::vector<double> candidate_gap_near_solution; ///< the same close to the solution
    /// In the reference configuration, from solutions on coarser meshes.
    std::vector<SearchTolerance> known_tolerances;
    /// Approach of each pair since the reference configuration, at the last solution; empty: none
    /// yet.
    std::vector<double> last_approach;
    /// The largest approach of each pair to a solution on this mesh since a search close to it;
    /// empty: none yet.
    std::vector<double> near_approach;
    /// A bound of the overlap of each pair where the last mesh is refined, at the same time and
    /// displacement [length]; empty: unknown.
    std::vector<double>              overlaps_on_finer_mesh;
    bool                             built_near_solution = false;
    std::vector<ContactSurface<dim>> my_surfaces;
    std::unique_ptr<ContactRows>     rows;
    std::unique_ptr<GapOperator>     contact;
    LA::Vector build_displacement; ///< displacement at build(); empty: reference configuration
    double     build_time = 0;     ///< time at build()
    std::set<std::string> unexchangeable; ///< names of pairs whose master cannot be the slave
    bool                  noted_theta = false;
  };

  /// Estimate of how far surfaces of a model may approach each other [length], from its loads and
  /// supports: a good estimate saves a second solution.
  template <int dim>
  double
  largest_expected_approach(const Scene<dim> &scene, const Mesh<dim> &mesh);
} // namespace Signorini
