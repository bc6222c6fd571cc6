// SPDX-License-Identifier: Apache-2.0
#include <signorini/parameters/section.h>
#include <signorini/solid/rigid_body.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const std::array<std::string, 3> axes = {{"x", "y", "z"}};

    /// Reports a force in a component whose motion is prescribed, where it would have no effect, or
    /// is not given.
    template <int dim, int n>
    void
    check_driven(const Section                  &section,
                 const std::string              &force_key,
                 const VectorExpression<dim, n> &force,
                 const std::string              &motion_key,
                 const VectorExpression<dim, n> &motion)
    {
      for (unsigned int d = 0; d < n; ++d)
        if (!force.is_zero(d) && (!motion.given() || motion.prescribed(d)))
          section.fail(force_key,
                       "acts in component " + std::to_string(d + 1) + ", in which " + motion_key +
                         (motion.given() ? " prescribes the motion" : " is not given") +
                         "; write 'free' for that component of " + motion_key);
    }
  } // namespace



  // In the plane the rotation has one component, in space it is a rotation vector: its direction is
  // the axis, its length the angle.
  template <int dim>
  void
  RigidBody<dim>::declare(Section &section)
  {
    section.add(
      "Displacement",
      displacement,
      "motion, one formula in t a component, separated by ';'; 'free' where a Force drives it; empty: at rest [length]");
    section.add("Force",
                force,
                "external force on the obstacle in its free components: formulas in t [force]");
    section.add(
      "Rotation",
      rotation,
      dim == 2 ?
        "rotation, counterclockwise: formula in t, or free; empty: none. Large rotations require "
        "Contact geometry = updated [radian]" :
        "rotation vector x; y; z: formulas in t, or free; empty: none. Large rotations require "
        "Contact geometry = updated [radian]");
    section.add(
      "Moment",
      moment,
      "external moment on the obstacle about the Reference point in free components of the Rotation: "
      "formulas in t [force*length]");
    section.add("Reference point", reference, "center of the Rotation [length]");
    section.add(
      "Lock time",
      driven.until,
      "after this time, at which a load step ends, free components keep the motion that they "
      "have then, whatever the Force and the Moment are; 0: never",
      non_negative);
    if (!section.reading())
      return;
    // The type of these formulas is that of fields in space, which may depend on the position.
    if (displacement.depends_on_place())
      section.fail("Displacement",
                   "depends on x, y or z, but an obstacle is rigid; use formulas in t alone");
    if (rotation.depends_on_place())
      section.fail("Rotation",
                   "depends on x, y or z, but an obstacle is rigid; use formulas in t alone");
    if (force.depends_on_place())
      section.fail("Force",
                   "depends on x, y or z, but an obstacle is rigid; use formulas in t alone");
    if (moment.depends_on_place())
      section.fail("Moment",
                   "depends on x, y or z, but an obstacle is rigid; use formulas in t alone");
    bool any_free = false;
    for (unsigned int i = 0; i < n_dofs; ++i)
      any_free |= is_free(i);
    if (driven.until > 0 && !any_free)
      section.fail(
        "Lock time",
        "requires a free component; write 'free' for one of Displacement or Rotation, or "
        "remove it");
    check_driven(section, "Force", force, "Displacement", displacement);
    check_driven(section, "Moment", moment, "Rotation", rotation);
  }



  // A component is free if it is written as such. Without any formula the body is at rest.
  template <int dim>
  bool
  RigidBody<dim>::is_free(const unsigned int i) const
  {
    if (i < dim)
      return displacement.given() && !displacement.prescribed(i);
    return i - dim < n_rotations && rotation.given() && !rotation.prescribed(i - dim);
  }



  // Rotations are multiplied by the length scale, so that all unknowns of the body are lengths.
  template <int dim>
  double
  RigidBody<dim>::prescribed(const unsigned int i,
                             const double       t,
                             const double       rotation_length_scale) const
  {
    if (i < dim)
      return displacement.value(Point<dim>(), t)[i];
    // Unknowns beyond the rotations exist in the plane only, where the second node of the body has
    // dim components but one rotation; they are prescribed to zero.
    return i - dim < n_rotations ?
             rotation.value(Point<dim>(), t)[i - dim] * rotation_length_scale :
             0.;
  }



  // Moments are divided by the length scale: their work on the unknown is that on the rotation.
  template <int dim>
  double
  RigidBody<dim>::load(const unsigned int i,
                       const double       t,
                       const double       rotation_length_scale) const
  {
    if (i < dim)
      return force.value(Point<dim>(), t)[i];
    return i - dim < n_rotations ? moment.value(Point<dim>(), t)[i - dim] / rotation_length_scale :
                                   0.;
  }



  // The largest distance between the reference point and a corner of the box.
  template <int dim>
  double
  RigidBody<dim>::arm(const BoundingBox<dim> &box) const
  {
    const auto &[low, high] = box.get_boundary_points();
    Tensor<1, dim> farthest;
    for (unsigned int d = 0; d < dim; ++d)
      farthest[d] = std::max(std::abs(low[d] - reference[d]), std::abs(high[d] - reference[d]));
    return farthest.norm();
  }



  template <int dim>
  std::string
  RigidBody<dim>::name_of_motion(const unsigned int i) const
  {
    return is_shortening ? name : name + ": " + name_of(i);
  }



  template <int dim>
  std::string
  RigidBody<dim>::name_of(const unsigned int i)
  {
    return i < dim ? "translation " + axes[i] : "rotation about " + axes[dim == 2 ? 2 : i - dim];
  }



  template struct RigidBody<2>;
  template struct RigidBody<3>;
} // namespace Signorini
