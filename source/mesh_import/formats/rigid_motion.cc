// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/rigid_motion.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  RigidMotion
  RigidMotion::translation(const Tensor<1, 3> &by)
  {
    RigidMotion motion;
    motion.shift = by;
    return motion;
  }



  // Rodrigues' formula R = cos(a) I + sin(a) [n]x + (1 - cos(a)) n n^T, column by column; the shift
  // leaves the axis fixed.
  RigidMotion
  RigidMotion::about_axis(const Point<3> &a, const Point<3> &b, const double angle)
  {
    const Tensor<1, 3> n = (b - a) / a.distance(b);
    RigidMotion        motion;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
        motion.rotation[i][i] = std::cos(angle) + (1 - std::cos(angle)) * n[i] * n[i];
        motion.rotation[j][i] = std::sin(angle) * n[k] + (1 - std::cos(angle)) * n[i] * n[j];
        motion.rotation[k][i] = -std::sin(angle) * n[j] + (1 - std::cos(angle)) * n[i] * n[k];
      }
    motion.shift = a - motion.rotation * a;
    return motion;
  }



  // The columns of the rotation are the axes of the system, orthogonalised.
  RigidMotion
  RigidMotion::of_system(const Point<3> &origin, const Point<3> &on_x, const Point<3> &in_xy)
  {
    const Tensor<1, 3> x = (on_x - origin) / origin.distance(on_x);
    Tensor<1, 3>       z = cross_product_3d(x, in_xy - origin);
    z /= z.norm();
    const Tensor<1, 3> y = cross_product_3d(z, x);
    RigidMotion        motion;
    for (unsigned int i = 0; i < 3; ++i)
      {
        motion.rotation[i][0] = x[i];
        motion.rotation[i][1] = y[i];
        motion.rotation[i][2] = z[i];
      }
    motion.shift = origin;
    return motion;
  }



  // x -> R2 (R1 x + c1) + c2.
  RigidMotion
  RigidMotion::then(const RigidMotion &next) const
  {
    RigidMotion motion;
    motion.rotation = next.rotation * rotation;
    motion.shift    = next.rotation * shift + next.shift;
    return motion;
  }
} // namespace Signorini
