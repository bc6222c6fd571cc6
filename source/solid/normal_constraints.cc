// SPDX-License-Identifier: Apache-2.0
#include "geometry/extent.h"
#include "solid/node_constrainer.h"
#include <signorini/base/text.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Add a face normal to the sum of those of the same smooth surface at a node, those within 50
    /// degrees of each other; start a new sum otherwise: the node is at an edge or corner, and is
    /// constrained in several directions.
    template <int dim>
    void
    add_normal(const Tensor<1, dim> &n, std::vector<Tensor<1, dim>> &sums)
    {
      // The cosine of 50 degrees.
      constexpr double cosine_of_corner = 0.64;
      for (Tensor<1, dim> &sum : sums)
        if (n * sum > cosine_of_corner * sum.norm())
          {
            sum += n;
            return;
          }
      sums.push_back(n);
    }

    /// Throws SceneError on all ranks if the normals of a plane of symmetry differ by more than
    /// 1e-6 in a component. Collective.
    template <int dim>
    void
    check_plane(const Mesh<dim>                   &mesh,
                const Support<dim>                &support,
                const std::string                 &boundary,
                const std::vector<Tensor<1, dim>> &normals)
    {
      Extent<dim> directions;
      for (const Tensor<1, dim> &n : normals)
        directions.add(n);
      const BoundingBox<dim> box = directions.reduce_over_ranks(mesh.communicator());
      for (unsigned int d = 0; d < dim; ++d)
        if (box.side_length(d) > 1e-6)
          throw SceneError(
            support.place + ": '" + boundary +
            "' is not plane, so that it cannot be a plane of symmetry (components of "
            "its unit normals differ by " +
            short_text(box.side_length(d), 2) +
            "); set Type = roller to constrain a curved surface in normal direction");
    }
  } // namespace



  template <int dim>
  void
  constrain_normals(NodeConstrainer<dim> &finder,
                    const Mesh<dim>      &mesh,
                    const Support<dim>   &support)
  {
    std::map<ConstrainedNode<dim> *, std::vector<Tensor<1, dim>>> sums;
    const bool along_normal = support.direction.norm() == 0;
    for (const std::string &boundary : support.boundaries)
      {
        // The normals of a boundary are collected for the test of planes. A node that belongs to
        // several boundaries of the support adds up the normals of all of them, unless they differ
        // by an edge.
        std::vector<Tensor<1, dim>> normals;
        finder.on_boundary(mesh.boundary_ids(boundary),
                           along_normal,
                           [&](ConstrainedNode<dim> &node, const Tensor<1, dim> &n) {
                             normals.push_back(n);
                             if (along_normal)
                               add_normal(n, sums[&node]);
                             else
                               sums[&node] = {without_rounding<dim>(support.direction /
                                                                    support.direction.norm())};
                           });
        if (support.type == SupportType::symmetry)
          check_plane(mesh, support, boundary, normals);
      }
    finder.on_nodes(support.nodes, [&](ConstrainedNode<dim> &node) {
      sums[&node] = {without_rounding<dim>(support.direction / support.direction.norm())};
    });
    for (auto &[node, directions] : sums)
      {
        for (Tensor<1, dim> &n : directions)
          n /= n.norm();
        // The order in which faces around a node are visited depends on the rank; directions are
        // sorted, so that all ranks eliminate in the same order.
        std::sort(directions.begin(), directions.end(), [](const auto &a, const auto &b) {
          for (unsigned int d = 0; d < dim; ++d)
            if (std::abs(a[d] - b[d]) > 1e-6)
              return a[d] < b[d];
          return false;
        });
        for (const Tensor<1, dim> &n : directions)
          node->prescribed_directions.push_back({without_rounding<dim>(n), &support});
      }
  }



  template void
  constrain_normals(NodeConstrainer<2> &, const Mesh<2> &, const Support<2> &);
  template void
  constrain_normals(NodeConstrainer<3> &, const Mesh<3> &, const Support<3> &);
} // namespace Signorini
