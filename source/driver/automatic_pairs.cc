// SPDX-License-Identifier: Apache-2.0
#include "contact/search/deep_penetration.h"
#include "contact/search/find_pairs.h"
#include "driver/contact_interfaces.h"
#include "driver/scene_setup.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Warn about pairs of bodies without contact pair whose bounding boxes overlap deeper than the
    /// distance within which pairs were searched.
    template <int dim>
    void
    warn_about_penetrations(const Mesh<dim>                     &mesh,
                            const std::vector<ContactPair<dim>> &pairs,
                            const double                         distance,
                            ConditionalOStream                  &out)
    {
      const auto is_of = [&](const std::string &boundary, const unsigned int body) {
        return boundary.rfind(mesh.body_name(body) + ".", 0) == 0;
      };
      for (unsigned int a = 0; a < mesh.n_bodies(); ++a)
        for (unsigned int b = 0; b < a; ++b)
          {
            const double depth = common_depth(mesh.extent(a), mesh.extent(b));
            const bool   any   = std::any_of(pairs.begin(), pairs.end(), [&](const auto &pair) {
              return (is_of(pair.slave, a) && is_of(pair.master, b)) ||
                     (is_of(pair.slave, b) && is_of(pair.master, a));
            });
            if (depth > distance && !any)
              out
                << "  WARNING: " << mesh.body_name(b) << " and " << mesh.body_name(a)
                << ": one may lie up to " << depth << " deep in the other, but no surfaces of "
                << "these bodies face each other within " << distance
                << "; if they are in contact, define the pair explicitly, or set Contact pairs/auto/Search distance"
                << std::endl;
          }
    }

    /// True if the surface does not move along its normal at any time: a supported boundary, or an
    /// obstacle at rest.
    template <int dim>
    bool
    is_held(const Scene<dim> &scene, const std::string &surface)
    {
      for (const Obstacle<dim> &obstacle : scene.obstacles)
        if (obstacle.name == surface)
          return !obstacle.body.can_move();
      return std::any_of(scene.supports.begin(), scene.supports.end(), [&](const auto &support) {
        if (std::count(support.boundaries.begin(), support.boundaries.end(), surface) == 0)
          return false;
        if (support.type != SupportType::displacement)
          return support.direction.norm() == 0 && support.normal_displacement.is_zero();
        for (unsigned int d = 0; d < dim; ++d)
          if (!support.displacement.prescribed(d) || !support.displacement.is_zero(d))
            return false;
        return true;
      });
    }
  } // namespace



  template <int dim>
  std::vector<ContactPair<dim>>
  automatic_pairs(const Scene<dim> &scene, const Mesh<dim> &mesh, ConditionalOStream &out)
  {
    std::vector<double> moduli;
    for (const Body<dim> &body : scene.bodies)
      moduli.push_back(body.material.youngs_modulus);
    const ContactPair<dim> &pattern  = scene.pairs.front();
    const double            distance = pattern.search_distance > 0 ?
                                         pattern.search_distance :
                                         std::max(mesh.size() / 10, largest_expected_approach(scene, mesh));
    auto                    pairs    = find_pairs(mesh, scene.obstacles, moduli, pattern, distance);
    if (pairs.empty())
      out << "  WARNING: no surfaces face each other within " << distance
          << "; define the Contact pairs explicitly, or set Contact pairs/auto/Search distance"
          << std::endl;
    warn_about_penetrations(mesh, pairs, distance, out);
    // A pair of two surfaces that cannot move carries no pressure that depends on the solution.
    pairs.erase(std::remove_if(pairs.begin(),
                               pairs.end(),
                               [&](const ContactPair<dim> &pair) {
                                 return is_held(scene, pair.slave) && is_held(scene, pair.master);
                               }),
                pairs.end());
    return pairs;
  }



#define INSTANTIATE(dim)                                                                           \
  template std::vector<ContactPair<dim>> automatic_pairs(const Scene<dim> &,                       \
                                                         const Mesh<dim> &,                        \
                                                         ConditionalOStream &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
