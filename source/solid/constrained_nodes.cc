// SPDX-License-Identifier: Apache-2.0
#include "solid/constrained_nodes.h"

#include "solid/node_constrainer.h"
#include <signorini/solid/local_axes.h>

#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The directions of the components at x that a support prescribes. On the axis of cylindrical
    /// coordinates radial and circumferential displacements vanish, so that all directions across
    /// it count as prescribed if one of these is.
    template <int dim>
    std::vector<Tensor<1, dim>>
    prescribed_directions(const Support<dim> &support, const Point<dim> &x)
    {
      const Tensor<2, dim>        axes = support.axes.at(x);
      std::vector<Tensor<1, dim>> result;
      for (unsigned int d = 0; d < dim; ++d)
        if (support.displacement.prescribed(d))
          {
            if (axes[d].norm() > 0)
              result.push_back(without_rounding<dim>(axes[d]));
            else
              // Directions that depend on others are dropped when equations are eliminated.
              for (unsigned int k = 0; k < dim; ++k)
                {
                  Tensor<1, dim> across = axis<dim>(k);
                  if constexpr (dim == 3)
                    across -= (across * axes[2]) * axes[2];
                  result.push_back(across);
                }
          }
      return result;
    }

    /// Constrain the given components of a support of type `displacement`. Nodes are visited by
    /// several faces but constrained once.
    template <int dim>
    void
    constrain_components(NodeConstrainer<dim> &finder,
                         const Mesh<dim>      &mesh,
                         const Support<dim>   &support)
    {
      // The last direction of a node that this support has visited already is its own.
      const auto hold = [&](ConstrainedNode<dim> &node) {
        if (!node.prescribed_directions.empty() &&
            node.prescribed_directions.back().support == &support)
          return;
        for (const Tensor<1, dim> &direction : prescribed_directions(support, node.position))
          node.prescribed_directions.push_back({direction, &support});
      };
      for (const std::string &boundary : support.boundaries)
        finder.on_boundary(mesh.boundary_ids(boundary),
                           false,
                           [&](ConstrainedNode<dim> &node, auto) { hold(node); });
      finder.on_nodes(support.nodes, hold);
    }
  } // namespace



  // Gram-Schmidt; a direction that depends on earlier ones gives zero and keeps its place in the
  // list.
  template <int dim>
  std::vector<Tensor<1, dim>>
  ConstrainedNode<dim>::orthonormal() const
  {
    std::vector<Tensor<1, dim>> result;
    for (const DirectionConstraint<dim> &hold : prescribed_directions)
      {
        Tensor<1, dim> n = hold.direction;
        for (const Tensor<1, dim> &before : result)
          n -= (n * before) * before;
        result.push_back(n.norm() > 1e-6 ? n / n.norm() : Tensor<1, dim>());
      }
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  ConstrainedNode<dim>::free_part(const Tensor<1, dim> &v) const
  {
    Tensor<1, dim> rest = v;
    for (const Tensor<1, dim> &n : orthonormal())
      rest -= (v * n) * n;
    return rest;
  }



  template <int dim>
  ConstrainedNodes<dim>
  find_constrained_nodes(const Mesh<dim>                 &mesh,
                         const DoFHandler<dim>           &dofs,
                         const AffineConstraints<double> &hanging,
                         const std::vector<Support<dim>> &supports,
                         const double                     t,
                         const Model                      model)
  {
    NodeConstrainer<dim> finder(mesh, dofs, hanging);
    if (model == Model::axisymmetric)
      finder.constrain_axis();
    for (const Support<dim> &support : supports)
      if (!support.acts(t))
        continue;
      else if (support.type == SupportType::displacement)
        constrain_components(finder, mesh, support);
      else
        constrain_normals(finder, mesh, support);
    return std::move(finder.result);
  }



  template struct ConstrainedNode<2>;
  template struct ConstrainedNode<3>;
  template ConstrainedNodes<2>
  find_constrained_nodes(const Mesh<2> &,
                         const DoFHandler<2> &,
                         const AffineConstraints<double> &,
                         const std::vector<Support<2>> &,
                         double,
                         Model);
  template ConstrainedNodes<3>
  find_constrained_nodes(const Mesh<3> &,
                         const DoFHandler<3> &,
                         const AffineConstraints<double> &,
                         const std::vector<Support<3>> &,
                         double,
                         Model);
} // namespace Signorini
