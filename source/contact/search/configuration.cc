// SPDX-License-Identifier: Apache-2.0
#include "contact/search/configuration.h"

#include "solid/cell_nodes.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The locally owned cells with a vertex on the boundary. The vertices of boundary faces are
    /// collected first, from ghost cells too: a cell may touch the boundary in a vertex or an edge
    /// only, while its rank is the owner of the node there. Local; one pass over the cells.
    template <int dim>
    std::vector<CellIterator<dim>>
    cells_next_to_boundary(const Elasticity<dim> &elasticity)
    {
      std::vector<bool> is_there(elasticity.mesh().triangulation().n_vertices(), false);
      for (const auto &cell : elasticity.mesh().triangulation().active_cell_iterators())
        if (!cell->is_artificial() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
              for (const unsigned int v : cell->face(f)->vertex_indices())
                is_there[cell->face(f)->vertex_index(v)] = true;
      std::vector<CellIterator<dim>> result;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            if (is_there[cell->vertex_index(v)])
              {
                result.push_back(cell);
                break;
              }
      return result;
    }

    /// The reference positions X_i of the nodes on boundaries, as a vector in the space of
    /// displacements [length]. Hanging nodes are placed by interpolation along the edge or face of
    /// the coarser neighbour (by the constraints of the displacement), not on the curved boundary
    /// between its nodes: X_i is then the interpolant X_h of doc/theory, 5.1, and a rigid motion of
    /// all nodes moves the face of the shape functions rigidly.
    /// @return with ghosts; entries of nodes inside of bodies are zero. Collective.
    template <int dim>
    LA::Vector
    positions_of_nodes(const Elasticity<dim> &elasticity)
    {
      LA::Vector     places = elasticity.zero_vector();
      CellNodes<dim> nodes_of(elasticity.mesh(), elasticity.finite_elements());
      std::vector<types::global_dof_index> indices;
      for (const auto &cell : cells_next_to_boundary(elasticity))
        {
          const std::vector<Point<dim>> &nodes = nodes_of(cell);
          read_indices<dim>(cell, indices);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (elasticity.owned().is_element(indices[i]))
              places(indices[i]) = nodes[i][cell->get_fe().system_to_component_index(i).first];
        }
      places.compress(VectorOperation::insert);
      elasticity.hanging_nodes().distribute(places);
      return elasticity.with_ghosts(places);
    }

    /// A point of a face, and the tangents there.
    template <int dim>
    struct Frame
    {
      Point<dim>                          origin;
      std::array<Tensor<1, dim>, dim - 1> tangents;

      /// The normal, oriented by the parameters of the face; its length is the Jacobian of the
      /// face.
      Tensor<1, dim>
      normal() const
      {
        if constexpr (dim == 2)
          return cross_product_2d(tangents[0]);
        else
          return cross_product_3d(tangents[0], tangents[1]);
      }
    };

    /// The vector c convected from one frame to another: its components c^a along the tangents and
    /// its component along the unit normal are kept (doc/theory, (5.1)). The components follow from
    /// the metric A_ab = t_a . t_b as c^a = A^ab (t_b . c), since tangents are in general neither
    /// orthogonal nor of unit length. A degenerate frame (normal of zero length) leaves c
    /// unchanged.
    template <int dim>
    Tensor<1, dim>
    carried(const Tensor<1, dim> &c, const Frame<dim> &from, const Frame<dim> &to)
    {
      const Tensor<1, dim> n = from.normal(), n_now = to.normal();
      if (n.norm() == 0 || n_now.norm() == 0)
        return c;
      Tensor<2, dim - 1> metric;
      Tensor<1, dim - 1> along;
      for (unsigned int a = 0; a < dim - 1; ++a)
        {
          along[a] = c * from.tangents[a];
          for (unsigned int b = 0; b < dim - 1; ++b)
            metric[a][b] = from.tangents[a] * from.tangents[b];
        }
      const Tensor<1, dim - 1> components = invert(metric) * along;
      Tensor<1, dim>           result     = (c * n) / (n.norm() * n_now.norm()) * n_now;
      for (unsigned int a = 0; a < dim - 1; ++a)
        result += components[a] * to.tangents[a];
      return result;
    }
  } // namespace



  template <int dim>
  Configuration<dim>::Configuration(const Elasticity<dim> &elasticity)
    : my_elasticity(elasticity)
    , at_rest(true)
    , rigid_motion(elasticity.rigid_bodies().size() * RigidBody<dim>::n_dofs, 0.)
  {}



  template <int dim>
  Configuration<dim>::Configuration(const Elasticity<dim> &elasticity, const LA::Vector &u)
    : Configuration(elasticity, u, u)
  {}



  template <int dim>
  Configuration<dim>::Configuration(const Elasticity<dim> &elasticity,
                                    const LA::Vector      &u,
                                    const LA::Vector      &of_frames)
    : my_elasticity(elasticity)
    , at_rest(false)
    , u(u)
    , ghosted(elasticity.with_ghosts(u))
    , of_frames(elasticity.with_ghosts(of_frames))
    , reference_positions(positions_of_nodes(elasticity))
    , rigid_motion(elasticity.rigid_motion(u))
  {}



  template <int dim>
  const typename Configuration<dim>::ShapesAtNodes &
  Configuration<dim>::shapes_at_nodes(const unsigned int element,
                                      const unsigned int face,
                                      const unsigned int degree) const
  {
    // Shape functions at the nodes of a face depend on the element, the face and the degree of the
    // geometry only, so that they are evaluated once for each combination and reused for all faces.
    // Functions that vanish there with their tangential slopes are left out.
    ShapesAtNodes &result = shapes[{element, face, degree}];
    if (result.empty())
      {
        const FiniteElement<dim> &fe = my_elasticity.finite_elements()[element].base_element(0);
        const ReferenceCell       shape_of_face = shape_of_faces(fe.reference_cell());
        for (const Point<dim - 1> &xi : face_lattice<dim>(shape_of_face, degree))
          {
            result.emplace_back();
            const Point<dim> x = unit_point<dim>(fe.reference_cell(), face, xi);
            for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
              {
                Shape                shape{i, fe.shape_value(i, x), {}};
                const Tensor<1, dim> slope = fe.shape_grad(i, x);
                double               size  = std::abs(shape.value);
                for (unsigned int d = 0; d < dim - 1; ++d)
                  {
                    shape.slopes[d] = slope * face_direction<dim>(fe.reference_cell(), face, d);
                    size            = std::max(size, std::abs(shape.slopes[d]));
                  }
                if (size > 1e-14)
                  result.back().push_back(shape);
              }
          }
      }
    return result;
  }



  template <int dim>
  FacePatch<dim>
  Configuration<dim>::moved(const FacePatch<dim>    &rest,
                            const CellIterator<dim> &cell,
                            const unsigned int       face) const
  {
    if (at_rest)
      return rest;
    // Both the true surface and the face of the shape functions are polynomials; the displaced face
    // has the higher of both degrees and is interpolated at its nodes.
    const FiniteElement<dim>            &fe = cell->get_fe();
    const unsigned int                   k  = std::max(rest.get_degree(), fe.degree);
    std::vector<types::global_dof_index> indices;
    read_indices<dim>(cell, indices);
    std::vector<Point<dim>> nodes;
    auto                    node = shapes_at_nodes(cell->active_fe_index(), face, k).begin();
    for (const Point<dim - 1> &xi : face_lattice<dim>(rest.reference_cell(), k))
      {
        // Origin and tangents of the face X_h of the shape functions in the reference
        // configuration, and of the displaced one x_h = X_h + u.
        Frame<dim> before, now;
        for (const Shape &shape : *node++)
          for (unsigned int d = 0; d < dim; ++d)
            {
              const auto   dof = indices[fe.component_to_system_index(d, shape.function)];
              const double X   = reference_positions(dof);
              before.origin[d] += shape.value * X;
              now.origin[d] += shape.value * (X + ghosted(dof));
              for (unsigned int a = 0; a < dim - 1; ++a)
                {
                  before.tangents[a][d] += shape.slopes[a] * X;
                  now.tangents[a][d] += shape.slopes[a] * (X + of_frames(dof));
                }
            }
        // The remainder c = X - X_h of the true surface is convected with the frame.
        nodes.push_back(now.origin + carried(rest.position(xi) - before.origin, before, now));
      }
    return FacePatch<dim>(k, nodes, rest.get_outward());
  }



  namespace
  {
    /// The part of a rigid body in all rigid motions; zero if it does not move.
    template <int dim>
    std::array<double, RigidBody<dim>::n_dofs>
    motion_among(const std::vector<double> &rigid_motion,
                 const Displacements<dim>  &displacements,
                 const std::string         &name)
    {
      std::array<double, RigidBody<dim>::n_dofs> motion{};
      if (const auto body = displacements.rigid_body(name);
          body < displacements.rigid_bodies().size())
        std::copy_n(rigid_motion.begin() + body * motion.size(), motion.size(), motion.begin());
      return motion;
    }
  } // namespace



  template <int dim>
  std::array<double, RigidBody<dim>::n_dofs>
  Configuration<dim>::motion_of(const std::string &rigid_body) const
  {
    return motion_among<dim>(rigid_motion, my_elasticity, rigid_body);
  }



  template <int dim>
  RigidPose<dim>
  Configuration<dim>::pose(const Obstacle<dim> &obstacle) const
  {
    return pose(obstacle, rigid_motion);
  }



  template <int dim>
  RigidPose<dim>
  Configuration<dim>::pose(const Obstacle<dim>       &obstacle,
                           const std::vector<double> &rigid_motion) const
  {
    return {obstacle.body.reference,
            motion_among<dim>(rigid_motion, my_elasticity, obstacle.name),
            my_elasticity.rotation_length_scale()};
  }



  template <int dim>
  ObstaclePoint<dim>
  Configuration<dim>::closest(const Obstacle<dim>  &obstacle,
                              const RigidPose<dim> &pose,
                              const Point<dim>     &x) const
  {
    if (at_rest)
      return obstacle.shape->closest(x);
    // The closest point is evaluated in the coordinates of the obstacle's own frame; normal and
    // curvature are rotated back into space.
    ObstaclePoint<dim> point_on_obstacle =
      obstacle.shape->closest_point(pose.to_body(x), my_elasticity.rotation_length_scale());
    point_on_obstacle.normal    = pose.to_space(point_on_obstacle.normal);
    point_on_obstacle.curvature = pose.to_space(point_on_obstacle.curvature);
    return point_on_obstacle;
  }



  template <int dim>
  std::pair<ObstaclePoint<dim>, Point<dim>>
  Configuration<dim>::partner(const Obstacle<dim>  &obstacle,
                              const RigidPose<dim> &pose,
                              const FacePatch<dim> &face,
                              const FacePatch<dim> &rest,
                              const Point<dim - 1> &xi) const
  {
    const Point<dim> x = face.position(xi);
    if (!obstacle.shape->is_attached())
      {
        const ObstaclePoint<dim> there = closest(obstacle, pose, x);
        return {there, x - there.gap * there.normal};
      }
    const Point<dim>     y = at_rest ? x : pose.position(rest.position(xi));
    const Tensor<1, dim> n = -face.normal(xi);
    return {ObstaclePoint<dim>{(x - y) * n, n}, y};
  }



  template class Configuration<2>;
  template class Configuration<3>;
} // namespace Signorini
