// SPDX-License-Identifier: Apache-2.0
// How far contact is searched for, and whether that was far enough.
#include "contact/search/search_radius.h"
#include "driver/contact_interfaces.h"
#include <signorini/base/text.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

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
    const double            now  = room * last_approach[i] + pair.compliance.reach(),
                 so_far = pair.search_distance > 0 ? pair.search_distance : candidate_gap[i];
    // Gaps given by a formula do not depend on motions, and time-dependent ones change without
    // them.
    if (!pair.can_separate || pair.gap_is_given() || has_time_dependent_gap(pair) ||
        pair.is_limited() || now == 0 || now >= so_far)
      return {};
    return {now, 2 * my_surfaces[i].overlap, true};
  }



  // In the reference configuration the estimated tolerances; in displaced ones they follow from the
  // motion since the last search: the search radius covers the deepest penetration plus the
  // approach since, or what a finer mesh may change. Close to the solution few candidates suffice:
  // the motion to come is about as large as the last one, and is checked afterwards. With kept
  // integration points the candidates of the last search stay candidates: open faces contribute to
  // Nitsche's method, so that the sequence of updates converges only if they do not change. How far
  // others are away at least decreases by the approach since.
  template <int dim>
  std::vector<SearchTolerance>
  ContactInterfaces<dim>::search_tolerances(const Configuration<dim> &configuration,
                                            const bool                keeps_integration_points)
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
        const ContactPair<dim> &pair = decisions.pairs[i];
        // Candidates near the solution: never fewer than before; the size of faces is 0 where
        // nothing is in reach.
        if (built_near_solution && !my_surfaces.empty() && !keeps_integration_points)
          candidate_gap_near_solution[i] = std::max(
            {candidate_gap_near_solution[i],
             pair.compliance.reach() + std::clamp(2 * approaches[i],
                                                  near_candidates * my_surfaces[i].face_size,
                                                  my_surfaces[i].face_size / 2),
             touching * elasticity.mesh().size()});
        // Where the gap is another one, or the pair has begun, how near it was is not known.
        const bool is_other =
          (has_time_dependent_gap(pair) || pair.is_limited()) && elasticity.time() != build_time;
        double limit = search_radius_of_pair(elasticity, pair, candidate_gap[i]);
        if (!is_other && (!my_surfaces.empty() || i < overlaps_on_finer_mesh.size()))
          {
            const double now = std::max(0., pair.closes_below) +
                               (my_surfaces.empty() ? overlaps_on_finer_mesh[i] :
                                                      my_surfaces[i].overlap + approaches[i]);
            // Pairs that are bilateral, or closed by the input, may be far apart even if nothing
            // moves.
            limit = pair.can_separate && !pair.gap_is_given() ? now : std::max(limit, now);
          }
        result.push_back({keeps_integration_points ?
                            std::max(0.,
                                     my_surfaces[i].candidate_gap -
                                       (scene.obstacle_of(pair) ? 0. : approaches[i])) :
                          built_near_solution ? candidate_gap_near_solution[i] :
                                                candidate_gap[i],
                          limit,
                          false});
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
    if (!at_rest && built_near_solution)
      {
        near_approach.resize(approaches.size(), 0.);
        for (unsigned int i = 0; i < approaches.size(); ++i)
          near_approach[i] = std::max(near_approach[i], approaches[i]);
      }
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      {
        const ContactPair<dim> &pair     = decisions.pairs[i];
        const double            approach = approaches[i] + pair.compliance.reach();
        if (approach <= my_surfaces[i].candidate_gap || !pair.can_separate ||
            !pair.acts(build_time))
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



#define INSTANTIATE(dim)                                                                           \
  template SearchTolerance ContactInterfaces<dim>::reference_tolerance(unsigned int) const;        \
  template SearchTolerance ContactInterfaces<dim>::tolerance_from_solution(unsigned int) const;    \
  template std::vector<SearchTolerance> ContactInterfaces<dim>::search_tolerances(                 \
    const Configuration<dim> &, bool);                                                             \
  template std::vector<double> ContactInterfaces<dim>::approach_distances(const LA::Vector &)      \
    const;                                                                                         \
  template LA::Vector ContactInterfaces<dim>::displacement_since_build(const LA::Vector &) const;  \
  template bool       ContactInterfaces<dim>::is_geometry_current(const LA::Vector &) const;       \
  template bool       ContactInterfaces<dim>::search_radius_exceeded(const LA::Vector &);          \
  template bool       ContactInterfaces<dim>::enlarge_search_radius();
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
