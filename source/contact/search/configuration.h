// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/face_patch.h"
#include "solid/elasticity.h"
#include <signorini/contact/obstacles/obstacle.h>

#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace Signorini
{
  template <int dim>
  using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /// The configuration of the surfaces in which contact is searched for and linearised: the
  /// reference configuration, with gaps and normals of the undeformed bodies (small sliding), or
  /// one displaced by u (doc/theory, 5.1). Keeps a reference to the elasticity and a copy of u.
  template <int dim>
  class Configuration
  {
  public:
    /// The reference configuration.
    explicit Configuration(const Elasticity<dim> &elasticity);

    /// The configuration displaced by u. Collective.
    Configuration(const Elasticity<dim> &elasticity, const LA::Vector &u);

    /// The configuration displaced by u, with the local frames of another displacement in moved().
    /// The row of a contact point is the derivative of its gap at fixed frames: their rotation with
    /// u is not part of the variation, and enters when the configuration is updated. For tests of
    /// that derivative. Collective.
    Configuration(const Elasticity<dim> &elasticity,
                  const LA::Vector      &u,
                  const LA::Vector      &of_frames);

    /// True if surfaces are not displaced.
    bool
    is_reference() const
    {
      return at_rest;
    }

    /// The bodies whose surfaces are displaced.
    const Elasticity<dim> &
    elasticity() const
    {
      return my_elasticity;
    }

    /// The displacement u, without ghosts; empty in the reference configuration.
    const LA::Vector &
    displacement() const
    {
      return u;
    }

    /// Set the displacement at the start of the load step, from which the slip is measured.
    /// Collective.
    void
    set_start(const LA::Vector &u)
    {
      my_start = std::make_shared<const Configuration<dim>>(my_elasticity, u);
    }

    /// The configuration at the start of the load step; null if it was not set.
    const Configuration<dim> *
    start() const
    {
      return my_start.get();
    }

    /// The geometry of a face of a locally owned cell in this configuration. The difference c
    /// between the true surface and the shape functions of the displacement, in the reference
    /// configuration, is convected with the surface:
    ///
    ///   x(xi) = sum_i N_i(xi) x_i + c^a t_a + h n,
    ///
    /// where c^a and h are the components of c along the tangents and the normal of the reference
    /// face, and t_a and n those of the current one. So a rigid motion of the nodes is a rigid
    /// motion of the face.
    /// @param rest the face in the reference configuration
    FacePatch<dim>
    moved(const FacePatch<dim> &rest, const CellIterator<dim> &cell, unsigned int face) const;

    /// The degrees of freedom of a rigid body in this configuration [length]; zero if it does not
    /// move.
    std::array<double, RigidBody<dim>::n_dofs>
    motion_of(const std::string &rigid_body) const;

    /// The pose of an obstacle in this configuration.
    RigidPose<dim>
    pose(const Obstacle<dim> &obstacle) const;

    /// The pose of an obstacle for another rigid motion. @param rigid_motion see
    /// Elasticity::rigid_motion()
    RigidPose<dim>
    pose(const Obstacle<dim> &obstacle, const std::vector<double> &rigid_motion) const;

    /// The closest point of an obstacle to x, with its gap and normal.
    /// @param pose pose() of the obstacle
    ObstaclePoint<dim>
    closest(const Obstacle<dim>      &obstacle,
            const RigidPose<dim>     &pose,
            const dealii::Point<dim> &x) const;

    /// The point of an obstacle that a point of a slave face is paired with, and its position: the
    /// closest point; of an attached obstacle the one that was in the same place at the start, with
    /// the normal of the face.
    /// @param pose pose() of the obstacle
    /// @param face the slave face in this configuration
    /// @param rest the same in the reference configuration
    /// @param xi the point, by the parameters of the face
    std::pair<ObstaclePoint<dim>, dealii::Point<dim>>
    partner(const Obstacle<dim>          &obstacle,
            const RigidPose<dim>         &pose,
            const FacePatch<dim>         &face,
            const FacePatch<dim>         &rest,
            const dealii::Point<dim - 1> &xi) const;

  private:
    /// A shape function at a node of a face's geometry.
    struct Shape
    {
      unsigned int                function; ///< of the scalar element
      double                      value;
      std::array<double, dim - 1> slopes; ///< by the parameters of the face
    };

    /// The shape functions that are not zero at each node of the face's geometry.
    using ShapesAtNodes = std::vector<std::vector<Shape>>;

    /// The shape functions of an element at the geometry nodes of a face; computed once for each
    /// combination.
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
