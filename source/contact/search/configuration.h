// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/face_patch.h"
#include "solid/elasticity.h"
#include <signorini/contact/obstacles/obstacle.h>

#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace Signorini
{
  template <int dim>
  using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /// Where the surfaces are on which contact is looked for: at rest, where gaps and normals are
  /// those of the undeformed bodies, or displaced by a u, where they are those of the displaced
  /// bodies (doc/theory, 5.1). Keeps a reference to the elasticity, and a copy of u.
  template <int dim>
  class Configuration
  {
  public:
    /// At rest.
    explicit Configuration(const Elasticity<dim> &elasticity);

    /// Displaced by u. Collective.
    Configuration(const Elasticity<dim> &elasticity, const LA::Vector &u);

    /// Displaced by u, with the frames of another displacement in moved(). What the rows of a
    /// contact point say of its gap is the derivative at frames that stay: how they turn with a
    /// change of u is left out of the variation, and comes with the next placement of the surfaces.
    /// Collective.
    Configuration(const Elasticity<dim> &elasticity,
                  const LA::Vector      &u,
                  const LA::Vector      &of_frames);

    bool
    is_reference() const
    {
      return at_rest;
    }

    const Elasticity<dim> &
    elasticity() const
    {
      return my_elasticity;
    }

    /// u, without ghosts; empty at rest.
    const LA::Vector &
    displacement() const
    {
      return u;
    }

    /// The load step that has led here has started from another displacement, which slip counts
    /// from. Collective.
    void
    set_start(const LA::Vector &u)
    {
      my_start = std::make_shared<const Configuration<dim>>(my_elasticity, u);
    }

    /// Null: nobody asks for the slip.
    const Configuration<dim> *
    start() const
    {
      return my_start.get();
    }

    /// A face of a locally owned cell where its nodes have got to. What the surface has between
    /// the nodes beyond the shape functions of the displacement, c at rest, turns and stretches
    /// with them:
    ///
    ///   x(xi) = sum_i N_i(xi) x_i + c^a t_a + h n,
    ///
    /// c^a and h being the components of c by tangents and normal of the face of the shape
    /// functions at rest, t_a and n those of it now. So a rigid motion of the nodes is one of
    /// the face.
    FacePatch<dim>
    moved(const FacePatch<dim> &rest, const CellIterator<dim> &cell, unsigned int face) const;

    /// Of an obstacle.
    RigidPose<dim>
    pose(const Obstacle<dim> &obstacle) const;

    /// Where it would be. @param rigid_motion see Elasticity::rigid_motion()
    RigidPose<dim>
    pose(const Obstacle<dim> &obstacle, const std::vector<double> &rigid_motion) const;

    /// What belongs to a point: the closest point of the obstacle where it is now.
    ObstaclePoint<dim>
    closest(const Obstacle<dim>      &obstacle,
            const RigidPose<dim>     &pose,
            const dealii::Point<dim> &x) const;

  private:
    /// A shape function at a node of a face's geometry.
    struct Shape
    {
      unsigned int                function; ///< of the scalar element
      double                      value;
      std::array<double, dim - 1> slopes; ///< by the parameters of the face
    };

    /// Those that are not zero, by node.
    using ShapesAtNodes = std::vector<std::vector<Shape>>;

    const ShapesAtNodes &
    shapes_at_nodes(unsigned int element, unsigned int face, unsigned int degree) const;

    const Elasticity<dim>                    &my_elasticity;
    std::shared_ptr<const Configuration<dim>> my_start;
    bool                                      at_rest;
    LA::Vector                                u, ghosted;
    LA::Vector          of_frames;           ///< the displacement of the frames, with ghosts
    LA::Vector          reference_positions; ///< of nodes, with ghosts
    std::vector<double> rigid_motion;

    mutable std::map<std::tuple<unsigned int, unsigned int, unsigned int>, ShapesAtNodes> shapes;
  };
} // namespace Signorini
