// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>
#include <signorini/solid/rigid_pose.h>

#include <deal.II/base/bounding_box.h>

#include <string>

namespace Signorini
{
  class Section;

  /// The motion of a rigid body: a translation and a rotation about a reference point, each
  /// component prescribed or free. Along free ones a given force or moment drives the body, and the
  /// motion is an unknown. In the vectors of the scene a rigid body has two nodes, one for the
  /// translation and one for the rotation; the rotation counts as the length by which it moves
  /// what is one lever arm away.
  template <int dim>
  struct RigidBody
  {
    static constexpr unsigned int n_rotations = RigidPose<dim>::n_rotations;
    static constexpr unsigned int n_dofs      = RigidPose<dim>::n_dofs;

    std::string                        name;
    VectorExpression<dim>              displacement; ///< not given: at rest
    VectorExpression<dim, n_rotations> rotation;     ///< [radian], not given: none
    VectorExpression<dim>              force;
    VectorExpression<dim, n_rotations> moment; ///< about the reference point
    dealii::Point<dim>                 reference;

    void
    declare(Section &section);

    /// True if the body can move, so that it has degrees of freedom.
    bool
    can_move() const
    {
      return displacement.given() || rotation.given();
    }

    bool
    is_free(unsigned int i) const;

    /// The prescribed value of degree of freedom i at time t, a length.
    double
    prescribed(unsigned int i, double t, double rotation_length_scale) const;

    /// The generalised force on degree of freedom i [force]; moments are divided by the rotation
    /// length scale.
    double
    load(unsigned int i, double t, double rotation_length_scale) const;

    /// The longest lever arm of a point of the box about the reference point.
    double
    arm(const dealii::BoundingBox<dim> &box) const;

    /// The name of degree of freedom i, as in "translation y".
    static std::string
    name_of(unsigned int i);
  };
} // namespace Signorini
