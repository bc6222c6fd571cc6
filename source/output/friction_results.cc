// SPDX-License-Identifier: Apache-2.0
#include "contact/laws/bonds.h"
#include "fields/friction_fields.h"
#include "output/json.h"
#include "output/results.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Sums and extreme values over the closed points of a pair.
    struct FrictionSums
    {
      /// Largest slip of this load step and since contact [length].
      double slip = 0, total_slip = 0;
      /// Largest slip of points that stick [length].
      double elastic_slip = 0;
      /// Largest |t| - mu p, and the largest work density that friction would give to the bodies,
      /// t.s.
      double excess = 0, gained = 0;

      void
      reduce_over_ranks(const MPI_Comm comm)
      {
        for (double *x : {&slip, &total_slip, &elastic_slip, &excess, &gained})
          *x = Utilities::MPI::max(*x, comm);
      }
    };

    /// @return the sums of one pair. Collective.
    template <int dim>
    FrictionSums
    friction_sums(const Snapshot<dim> &s, const unsigned int pair)
    {
      FrictionSums        sums;
      const PointVectors  gaps   = s.contact.gaps(s.displacement);
      const PointVectors  slip   = slip_at_points(s);
      const PointVectors &t      = s.contact_state.traction;
      const PointVectors &before = s.contact_state.internal.scalars,
                         &after  = s.contact_state.internal_at_end.scalars;
      const double rounding =
        rounding_of_pressure(s.elasticity.mesh().size(), s.contact, s.displacement);
      s.contact.for_each_point([&](const auto i, const unsigned int of_point) {
        if (of_point != pair || !is_closed(s.contact_state.status(i)))
          return;
        const double total = after.empty() ? 0. : double(after[0](i)),
                     work  = before.empty() ? total : total - before[0](i);
        const double size  = length_at(t, i, 1);
        sums.slip          = std::max(sums.slip, length_at(gaps, i, 1));
        sums.total_slip    = std::max(sums.total_slip, length_at(slip, i, 0));
        if (status_of(s.contact_state.status(i)) == ContactStatus::stick)
          sums.elastic_slip = std::max(sums.elastic_slip, length_at(gaps, i, 1));
        if (size > rounding)
          sums.excess =
            std::max(sums.excess, size - s.contact.coefficients.friction_bound(i, t[0](i)).value);
        sums.gained = std::max(sums.gained, -work);
      });
      sums.reduce_over_ranks(s.elasticity.mesh().communicator());
      return sums;
    }

    /// @return the largest tangential traction at the nodes. Collective.
    template <int dim>
    double
    largest_tangential_traction(const Snapshot<dim> &s, const unsigned int pair)
    {
      double                        largest = 0;
      const std::vector<LA::Vector> t       = tangential_traction(s, pair);
      for (const auto i : t[0].locally_owned_elements())
        largest = std::max(largest, length_at(t, i));
      return Utilities::MPI::max(largest, s.elasticity.mesh().communicator());
    }
  } // namespace



  template <int dim>
  Json
  friction_results(const Snapshot<dim>  &s,
                   const Tensor<1, dim> &force,
                   const double          area,
                   const unsigned int    pair)
  {
    const FrictionSums sums  = friction_sums(s, pair);
    const ContactPatch stick = stick_zone(s, pair);
    const double       work  = s.friction_work.empty() ? 0. : s.friction_work[pair];
    Json               result{{"friction_force", list(force)},
                {"stick_area", stick.area},
                {"slip_area", std::max(0., area - stick.area)},
                {"stick_from", list(stick.from)},
                {"stick_to", list(stick.to)},
                {"stick_semi_axes", list(stick.semi_axes)},
                {"max_tangential_traction", largest_tangential_traction(s, pair)},
                {"max_slip", sums.slip},
                {"max_slip_since_contact", sums.total_slip},
                {"max_elastic_slip", sums.elastic_slip},
                {"friction_work",
                               work}, // replaced by the recorder, which knows the load step before
                {"total_friction_work", work},
                {"max_friction_excess", sums.excess},
                {"friction_change", change_of_friction(s, pair)},
                {"max_friction_gain", sums.gained}};
    return result;
  }



  template <int dim>
  Json
  tie_results(const Snapshot<dim> &s, const Tensor<1, dim> &force, const unsigned int pair)
  {
    Json result = {{"tangential_force", list(force)},
                   {"max_tangential_traction", largest_tangential_traction(s, pair)}};
    if (s.pairs[pair].strength.given())
      {
        const LA::Vector utilisation =
          bond_utilisation(s.pairs, s.contact, s.contact_state.traction);
        double areas[2] = {0, 0}, largest = 0; // areas: all, and where the bond is intact
        s.contact.for_each_point([&](const auto i, const unsigned int of) {
          if (of != pair)
            return;
          areas[0] += s.contact.weight(i);
          if (status_of(s.contact.coefficients.least_status(i)) == ContactStatus::stick)
            areas[1] += s.contact.weight(i);
          largest = std::max(largest, double(utilisation(i)));
        });
        const MPI_Comm comm = s.elasticity.mesh().communicator();
        Utilities::MPI::sum(areas, comm, areas);
        result["bond"] = {{"area", areas[1]},
                          {"failed_share", areas[0] > 0 ? 1 - areas[1] / areas[0] : 0.},
                          {"utilisation", Utilities::MPI::max(largest, comm)},
                          {"change_across_face", change_across_face(s.contact, pair, utilisation)}};
      }
    return result;
  }



  template Json
  tie_results(const Snapshot<2> &, const Tensor<1, 2> &, unsigned int);
  template Json
  tie_results(const Snapshot<3> &, const Tensor<1, 3> &, unsigned int);
  template Json
  friction_results(const Snapshot<2> &, const Tensor<1, 2> &, double, unsigned int);
  template Json
  friction_results(const Snapshot<3> &, const Tensor<1, 3> &, double, unsigned int);
} // namespace Signorini
