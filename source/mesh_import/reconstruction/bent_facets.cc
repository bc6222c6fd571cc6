// SPDX-License-Identifier: Apache-2.0
#include "geometry/connected.h"
#include "mesh_import/reconstruction/curved_faces.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Below, facets count as one plane: coordinates in files are rounded.
    constexpr double smallest_angle = 0.5; // [degrees]

    /// @return the angle [degrees] by which the surface bends between two neighbours, whose normals
    /// have arbitrary signs.
    template <int dim>
    double
    angle_between(const unsigned int f, const unsigned int g, const FacetGraph<dim> &graph)
    {
      return std::acos(std::min(1., std::abs(graph.normal(f) * graph.normal(g)))) * 180 /
             numbers::PI;
    }



    /// @return sets of faces: those connected at rims where the surface bends by at most `angle`
    /// degrees.
    template <int dim>
    Connected
    connected_below(const FacetGraph<dim> &graph, const double angle)
    {
      Connected sets(graph.faces.size());
      for (unsigned int f = 0; f < graph.faces.size(); ++f)
        for (const auto &n : graph.neighbours(f))
          if (angle_between(f, n.face, graph) <= angle)
            sets.connect(f, n.face);
      return sets;
    }
  } // namespace



  template <int dim>
  std::vector<double>
  find_bent_facets(const FacetGraph<dim> &graph)
  {
    const unsigned int n       = graph.faces.size();
    Connected          planes  = connected_below(graph, smallest_angle);
    Connected          patches = connected_below(graph, 180.);

    // A corner is inside a plane if all faces there that continue each other are in that plane.
    std::vector<std::vector<unsigned int>> around(graph.vertices.size());
    for (unsigned int f = 0; f < n; ++f)
      for (const unsigned int v : graph.faces[f].vertices)
        around[v].push_back(f);
    std::vector<bool> is_divided(n, false); // by the first face of each plane
    for (unsigned int v = 0; v < around.size(); ++v)
      if (!graph.inserted[v])
        for (const unsigned int f : around[v])
          if (std::all_of(around[v].begin(), around[v].end(), [&](const unsigned int g) {
                return planes.first_of(g) == planes.first_of(f) ||
                       patches.first_of(g) != patches.first_of(f);
              }))
            is_divided[planes.first_of(f)] = true;

    std::vector<std::set<unsigned int>> beside(n); // planes, by the first face of each plane
    std::vector<double>                 result(n, 0.);
    for (unsigned int f = 0; f < n; ++f)
      for (const auto &neighbour : graph.neighbours(f))
        if (planes.first_of(neighbour.face) != planes.first_of(f))
          {
            beside[planes.first_of(f)].insert(planes.first_of(neighbour.face));
            result[f] = std::max(result[f], angle_between(f, neighbour.face, graph));
          }
    for (unsigned int f = 0; f < n; ++f)
      if (beside[planes.first_of(f)].size() < 2 || is_divided[planes.first_of(f)])
        result[f] = 0;
    return result;
  }



  template std::vector<double>
  find_bent_facets(const FacetGraph<2> &);
  template std::vector<double>
  find_bent_facets(const FacetGraph<3> &);
} // namespace Signorini
