// SPDX-License-Identifier: Apache-2.0
// What pairs say of the law at their points: compliance, friction, and bonds.
#include "contact/laws/bonds.h"
#include "contact/laws/coulomb_friction.h"
#include "driver/contact_interfaces.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the length of the path on which a point has slipped before the load step [length],
    /// an internal variable of friction.
    double
    slip_path(const InternalFields &internal, const types::global_dof_index point)
    {
      return internal.scalars.size() > 1 ? double(internal.scalars[1](point)) : 0.;
    }
  } // namespace



  // The compliance of its pair at each point, if any pair has one.
  template <int dim>
  void
  ContactInterfaces<dim>::set_compliance()
  {
    ContactCoefficients &of      = contact->coefficients;
    bool                 is_null = true;
    for (const ContactPair<dim> &pair : decisions.pairs)
      {
        is_null = is_null && pair.compliance.is_rigid();
        of.has_nonlinear_compliance |= pair.compliance.is_nonlinear();
      }
    if (!is_null)
      of.compliance_of = [this, points = contact->weight.locally_owned_elements()](
                           const auto i) -> const ContactCompliance & {
        return decisions.pairs[contact->origin.pair[points.index_within_set(i)]].compliance;
      };
  }



  // The coefficient of each point at its position in the reference configuration, or the bound as a
  // function of the pressure. Throws SceneError on all ranks where a coefficient is negative, or no
  // number.
  template <int dim>
  void
  ContactInterfaces<dim>::set_friction(const double t, const InternalFields &internal)
  {
    ContactCoefficients &coefficients = contact->coefficients;
    const bool           is_nonlinear =
      std::any_of(decisions.pairs.begin(), decisions.pairs.end(), [](const auto &one) {
        return one.friction.is_nonlinear();
      });
    check_friction(t, internal, contact->zero());
    const auto position = [this](const auto i) { return position_of(i); };
    const auto slip     = [internal](const auto i) { return slip_path(internal, i); };
    std::map<types::global_dof_index, unsigned int> pair_of; // if the bound is nonlinear
    contact->for_each_point([&](const auto i, const unsigned int pair) {
      const FrictionCoefficient<dim> &friction = decisions.pairs[pair].friction;
      if (is_nonlinear)
        pair_of[i] = pair;
      coefficients.friction(i) =
        is_nonlinear && !friction.is_zero() ? 1. : friction.value(position(i), t, 0., slip(i));
    });
    coefficients.friction.compress(VectorOperation::insert);
    coefficients.bound_of = nullptr;
    if (is_nonlinear)
      coefficients.bound_of = [this, t, slip, position, pair_of](const auto i, const double p) {
        const double ratio = contact->coefficients.area_ratio(i);
        return ratio *
               decisions.pairs[pair_of.at(i)].friction.bound(position(i), t, p / ratio, slip(i));
      };
  }



  template <int dim>
  Point<dim>
  ContactInterfaces<dim>::position_of(const types::global_dof_index point) const
  {
    Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = contact->geometry.position[d](point);
    return x;
  }



  template <int dim>
  void
  ContactInterfaces<dim>::check_friction(const double          t,
                                         const InternalFields &internal,
                                         const LA::Vector     &pressure) const
  {
    unsigned int wrong = 0; // one more than the number of a pair
    contact->for_each_point([&](const auto i, const unsigned int pair) {
      if (!std::isfinite(decisions.pairs[pair].friction.value(
            position_of(i),
            t,
            std::max(0., pressure(i) / contact->coefficients.area_ratio(i)),
            slip_path(internal, i))))
        wrong = pair + 1;
    });
    wrong = Utilities::MPI::max(wrong, elasticity.mesh().communicator());
    if (wrong > 0)
      throw SceneError("Contact pairs/" + decisions.pairs[wrong - 1].name +
                       "/Friction = " + decisions.pairs[wrong - 1].friction.mu.text +
                       ": is negative, or no number, at some points at t = " + short_text(t) +
                       "; correct the formula");
  }



  template <int dim>
  void
  ContactInterfaces<dim>::set_bonds(LA::Vector &intact)
  {
    Signorini::set_bonds(decisions.pairs, intact, *contact);
  }



  // Along the tangents the slip is that of the load step in any case.
  template <int dim>
  bool
  ContactInterfaces<dim>::set_gaps_at_start(const LA::Vector &u, InternalFields &internal)
  {
    LA::Vector &start     = internal.scalars[CoulombFriction::gap_at_start],
               &known     = internal.scalars[CoulombFriction::gap_is_known];
    contact->gap_at_start = LA::Vector();
    contact->set_interference(contact->interference);
    const LA::Vector now    = contact->gap(u);
    bool             is_new = false;
    contact->for_each_point([&](const auto i, const unsigned int pair) {
      const ContactPair<dim> &of_point = decisions.pairs[pair];
      const bool              is_late  = of_point.is_tied && of_point.from > 0;
      if (is_late && known(i) < 0.5)
        {
          start(i) = now(i);
          is_new   = true;
        }
      known(i) = is_late ? 1. : 0.;
      start(i) = is_late ? double(start(i)) : 0.;
    });
    start.compress(VectorOperation::insert);
    known.compress(VectorOperation::insert);
    // A copy would take over the ghost layout, which may differ between ranks.
    contact->gap_at_start = contact->zero();
    for (const auto i : contact->weight.locally_owned_elements())
      contact->gap_at_start(i) = start(i);
    contact->gap_at_start.compress(VectorOperation::insert);
    contact->set_interference(contact->interference);
    return Utilities::MPI::max(is_new ? 1 : 0, elasticity.mesh().communicator()) > 0;
  }



  template <int dim>
  bool
  ContactInterfaces<dim>::break_bonds(const PointVectors &traction, LA::Vector &intact)
  {
    const bool has_broken = Signorini::break_bonds(decisions.pairs, *contact, traction, intact);
    if (has_broken)
      set_bonds(intact);
    return has_broken;
  }



#define INSTANTIATE(dim)                                                                           \
  template void ContactInterfaces<dim>::set_bonds(LA::Vector &);                                   \
  template bool ContactInterfaces<dim>::set_gaps_at_start(const LA::Vector &, InternalFields &);   \
  template bool ContactInterfaces<dim>::break_bonds(const PointVectors &, LA::Vector &);           \
  template void ContactInterfaces<dim>::set_compliance();                                          \
  template void ContactInterfaces<dim>::set_friction(double, const InternalFields &);              \
  template Point<dim> ContactInterfaces<dim>::position_of(types::global_dof_index) const;          \
  template void       ContactInterfaces<dim>::check_friction(double,                               \
                                                       const InternalFields &,               \
                                                       const LA::Vector &) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
