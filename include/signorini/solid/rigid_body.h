// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>
#include <signorini/parameters/time_span.h>
#include <signorini/solid/rigid_pose.h>

#include <deal.II/base/bounding_box.h>

#include <string>

namespace Signorini
{
  class Section;

  /// The motion of a rigid body: a translation and a rotation about a reference point, each
  /// component prescribed or free. Along free components a given force or moment acts, and the
  /// motion is an unknown. In vectors a rigid body has two nodes, one for the translation and one
  /// for the rotation; rotations are multiplied by a length scale, so that all unknowns are
  /// lengths.
  template <int dim>
  struct RigidBody
  {
    static constexpr unsigned int n_rotations = RigidPose<dim>::n_rotations;
    static constexpr unsigned int n_dofs      = RigidPose<dim>::n_dofs;

    /// Name of the obstacle.
    std::string name;
    /// Components of the translation as functions of time [length]; not given: at rest.
    VectorExpression<dim> displacement;
    /// Components of the rotation vector (2D: the angle) as functions of time [radian]; not given:
    /// none.
    VectorExpression<dim, n_rotations> rotation;
    /// External force in free components [force].
    VectorExpression<dim> force;
    /// External moment about the reference point in free components [force length].
    VectorExpression<dim, n_rotations> moment;
    /// The reference point in the reference configuration [length].
    dealii::Point<dim> reference;
    /// It stands for the shortening of a bolt: its first component, and no translation.
    bool is_shortening = false;
    /// When free components are driven by their forces; after that they keep their motion.
    TimeSpan driven;

    /// Declare the keys; formulas that depend on the position are reported through the section.
    void
    declare(Section &section);

    /// True if the body can move, so that it has degrees of freedom.
    bool
    can_move() const
    {
      return displacement.given() || rotation.given();
    }

    /// True if degree of freedom i is an unknown while it is driven: its component is given as
    /// `free`.
    bool
    is_free(unsigned int i) const;

    /// The prescribed value of degree of freedom i at time t [length]; zero for components that are
    /// not given.
    double
    prescribed(unsigned int i, double t, double rotation_length_scale) const;

    /// The generalised force on degree of freedom i [force]; moments are divided by the rotation
    /// length scale.
    double
    load(unsigned int i, double t, double rotation_length_scale) const;

    /// The largest distance of a point of the box from the reference point [length].
    double
    arm(const dealii::BoundingBox<dim> &box) const;

    /// The name of the motion by degree of freedom i, as in "punch: translation y".
    std::string
    name_of_motion(unsigned int i) const;

    /// The name of degree of freedom i, as in "translation y".
    static std::string
    name_of(unsigned int i);
  };
} // namespace Signorini
