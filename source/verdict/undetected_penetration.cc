// SPDX-License-Identifier: Apache-2.0
#include "verdict/undetected_penetration.h"

#include "verdict/checks.h"
#include "verdict/overlaps.h"
#include <signorini/base/text.h>

#include <algorithm>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the surfaces of all bodies. Collective.
    template <int dim>
    std::vector<BodySurface<dim>>
    body_surfaces(const Configuration<dim>                        &configuration,
                  const MonitoredSurfaces<dim>                    &watched,
                  const std::optional<PenetrationCandidates<dim>> &near)
    {
      const Mesh<dim> &mesh = configuration.elasticity().mesh();
      // All faces are moved to the current configuration once, and then divided by bodies.
      const BoundaryFaces<dim>      all(configuration,
                                   [&](const CellIterator<dim> &cell, const unsigned int face) {
                                     return !near || near->counts(cell, face);
                                   });
      std::vector<BodySurface<dim>> result;
      for (unsigned int body = 0; body < mesh.n_bodies(); ++body)
        {
          std::vector<bool> is_its(all.faces.size());
          for (unsigned int i = 0; i < is_its.size(); ++i)
            is_its[i] = mesh.body(all.faces[i].first) == body;
          result.emplace_back(all.among(is_its), watched, near, mesh.communicator());
        }
      return result;
    }

    /// @return the most severe penetration of all ranks. Collective.
    Overlap
    largest_of(const Overlap &own, const MPI_Comm comm)
    {
      Overlap largest;
      // Ranks are compared in their order by the same rule as overlaps on one rank, so that all of
      // them get the same result.
      for (const Overlap &of_rank : Utilities::MPI::all_gather(comm, own))
        largest.take(of_rank);
      return largest;
    }

    /// Say that the surfaces have a contact pair, which is inactive where they overlap.
    void
    name_inactive_pair(CheckResult &check_result)
    {
      const std::string words = ", where no pair detects contact";
      // Messages of bodies that penetrate themselves or planes of symmetry have other words.
      if (const auto at = check_result.message.find(words); at != std::string::npos)
        check_result.message.replace(at,
                                     words.size(),
                                     ", and their contact pair did not detect it");
      check_result.advice = "use smaller load steps, or set Search distance of the pair";
    }
  } // namespace



  // At finite strain all surfaces are tested, at small strain the candidates only. The most severe
  // penetration is reported.
  template <int dim>
  CheckResult
  check_undetected_penetration(const Scene<dim> &scene, const Snapshot<dim> &now)
  {
    const Mesh<dim>                          &mesh             = now.elasticity.mesh();
    const bool                                is_finite_strain = now.elasticity.is_finite_strain();
    const Configuration<dim>                  configuration(now.elasticity, now.displacement);
    const MonitoredSurfaces<dim>              watched(scene, now);
    std::optional<PenetrationCandidates<dim>> near;
    if (!is_finite_strain)
      near.emplace(scene, configuration, watched);
    const auto                      bodies = body_surfaces(configuration, watched, near);
    std::vector<SymmetryPlane<dim>> planes;
    if (is_finite_strain)
      planes = symmetry_planes(scene, now.elasticity);
    Overlap largest;
    for (unsigned int body = 0; body < bodies.size(); ++body)
      {
        const BodySurface<dim> &a = bodies[body];
        for (unsigned int other = 0; other < bodies.size(); ++other)
          {
            // Each ordered pair of bodies: overlap from the start, overlap of surfaces, and, at
            // finite strain, points deep inside.
            const BodySurface<dim> &b = bodies[other];
            if (body != other)
              largest.take(initial_depth(configuration, body, other, watched));
            if ((!is_finite_strain && &a == &b) || !a.box || !b.box ||
                a.box->get_neighbor_type(*b.box) == NeighborType::not_neighbors)
              continue;
            largest.take(overlap_of(a, b, watched, mesh.communicator()));
            if (is_finite_strain && &a != &b) // else not all of the other one is there
              largest.take(depth_inside(a, b, other, watched, mesh.communicator()));
          }
        for (unsigned int i = 0; i < scene.obstacles.size(); ++i)
          {
            // An obstacle that supports another body may have a hole for this one.
            const Obstacle<dim> &obstacle = scene.obstacles[i];
            const bool           is_used =
              std::any_of(now.pairs.begin(), now.pairs.end(), [&](const ContactPair<dim> &pair) {
                return scene.obstacle_of(pair) == &obstacle;
              });
            largest.take(overlap_of(configuration, a, obstacle, i, is_used, watched));
          }
        for (unsigned int i = 0; i < planes.size(); ++i)
          if (planes[i].body == body)
            largest.take(overlap_of(configuration, a, planes[i], i, scene, watched));
      }
    largest = largest_of(largest, mesh.communicator());
    CheckResult check_result;
    // The report names the surface and what it penetrates.
    check_result.check      = "undetected contact";
    check_result.value      = largest.share;
    check_result.limit      = Overlap::small;
    check_result.outcome    = largest.fails()                 ? Outcome::failed :
                              largest.share <= Overlap::small ? Outcome::passed :
                                                                Outcome::warned;
    const std::string name  = "'" + watched.name(largest.surface) + "' penetrates ",
                      depth = " by up to " + short_text(largest.depth, 2);
    // The advice names both surfaces, ready to be written into the scene.
    const auto pair = [&](const std::string &master) {
      return "add a pair with Slave = " + watched.name(largest.surface) + ", Master = " + master +
             " to Contact pairs if these surfaces can touch";
    };
    switch (largest.penetration_type)
      {
        case PenetrationType::body:
          check_result.message =
            "'" + watched.name(largest.surface) + "' is inside of '" +
            mesh.body_name(largest.what) + "', by up to " + short_text(largest.depth, 2) +
            (largest.at_start ? ", already at the start, where no pair detects contact" : "");
          check_result.advice =
            largest.at_start ?
              "add a pair of their surfaces to Contact pairs, or move the bodies apart" :
              "use smaller load steps, and add a pair to Contact pairs if there is none";
          break;
        case PenetrationType::other:
          check_result.message = name + "'" + watched.name(largest.what) + "'" + depth +
                                 ", where no pair detects contact";
          check_result.advice = pair(watched.name(largest.what));
          break;
        case PenetrationType::itself:
          check_result.message =
            name + "itself" + depth +
            ": the normals there vary so much that slave and master cannot be assigned";
          check_result.advice = "split the boundary there, and define a contact pair of its parts";
          break;
        case PenetrationType::obstacle:
          check_result.message = name + "the obstacle '" + scene.obstacles[largest.what].name +
                                 "'" + depth + (largest.at_start ? ", from the start" : "") +
                                 ", where no pair detects contact";
          check_result.advice = pair(scene.obstacles[largest.what].name);
          break;
        case PenetrationType::symmetry:
          check_result.message = name + "the plane of symmetry '" + planes[largest.what].boundary +
                                 "'" + depth + ", where it would touch its mirror image";
          check_result.advice =
            "if it is a plane of symmetry, add the plane to Obstacles and a contact pair with it";
          break;
      }
    if (largest.is_inactive)
      name_inactive_pair(check_result);
    return check_result;
  }



  template CheckResult
  check_undetected_penetration(const Scene<2> &, const Snapshot<2> &);
  template CheckResult
  check_undetected_penetration(const Scene<3> &, const Snapshot<3> &);
} // namespace Signorini
