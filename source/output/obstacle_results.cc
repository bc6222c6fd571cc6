// SPDX-License-Identifier: Apache-2.0
#include "fields/contact_force.h"
#include "output/results.h"
#include <signorini/solid/rigid_pose.h>

#include <algorithm>
#include <array>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Json
  obstacle_results(const Snapshot<dim> &s)
  {
    // The degrees of freedom of a rigid body are its translations, then its rotations times a
    // length, so that all have the unit of a displacement. The entries of forces that are conjugate
    // to rotations are therefore moments divided by that length.
    using Body                       = RigidBody<dim>;
    const Elasticity<dim>    &e      = s.elasticity;
    const LA::Vector          forces = contact_force(s);
    const std::vector<double> motion = e.rigid_motion(s.displacement),
                              force  = e.rigid_motion(forces);
    Json result                      = Json::object();
    for (unsigned int b = 0; b < e.rigid_bodies().size(); ++b)
      {
        if (e.rigid_bodies()[b].is_shortening)
          continue; // a result of its pair
        Json                            u, w, f, m;
        typename RigidPose<dim>::Moment moment; // about the reference point, where it is now
        const unsigned int              first = b * Body::n_dofs;
        // Around the axis radial forces are in balance, and so are moments.
        const bool on_circles = e.model() == Model::axisymmetric;
        for (unsigned int d = 0; d < dim; ++d)
          {
            u.push_back(motion[first + d]);
            f.push_back(on_circles && d == 0 ? 0. : 0. - force[first + d]);
          }
        for (unsigned int d = 0; d < Body::n_rotations; ++d)
          moment[d] = force[first + dim + d] * e.rotation_length_scale();
        if (!s.contact.at_rest())
          {
            std::array<double, Body::n_dofs> now;
            std::copy_n(motion.begin() + first, now.size(), now.begin());
            moment = RigidPose<dim>(e.rigid_bodies()[b].reference, now, e.rotation_length_scale())
                       .moment_of(moment / e.rotation_length_scale());
          }
        for (unsigned int d = 0; d < Body::n_rotations; ++d)
          {
            // The force of the contact acts on the obstacle; its opposite acts on the bodies. The
            // difference from zero avoids the number -0.
            w.push_back(motion[first + dim + d] / e.rotation_length_scale());
            m.push_back(on_circles ? 0. : 0. - moment[d]);
          }
        result[e.rigid_bodies()[b].name] = {{"displacement", u},
                                            {"rotation", w},
                                            {"force", f},
                                            {"moment", m}};
      }
    return result;
  }



  template Json
  obstacle_results(const Snapshot<2> &);
  template Json
  obstacle_results(const Snapshot<3> &);
} // namespace Signorini
