// SPDX-License-Identifier: Apache-2.0
#include "fields/friction_fields.h"

#include "fields/nodal_fields.h"
#include "fields/recovered_pressure.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  std::vector<LA::Vector>
  in_space(const Snapshot<dim> &s, const PointVectors &tangential)
  {
    std::vector<LA::Vector> result(dim, s.contact.zero());
    for (unsigned int a = 0; a < dim - 1; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        {
          LA::Vector term = tangential[a];
          term.scale(s.contact.tangential.direction[a][d]);
          result[d] += term;
        }
    return result;
  }



  template <int dim>
  std::vector<LA::Vector>
  tangential_traction(const Snapshot<dim> &s, const unsigned int pair)
  {
    std::vector<LA::Vector> result;
    if (s.contact.n_components() > 1)
      {
        const PointVectors &t = s.contact_state.traction;
        for (const LA::Vector &component : in_space(s, {t.begin() + 1, t.end()}))
          result.push_back(recovered_density(s, pair, component, false));
      }
    return result;
  }



  template <int dim>
  std::vector<LA::Vector>
  slip_since_contact(const Snapshot<dim> &s, const unsigned int pair)
  {
    std::vector<LA::Vector> result;
    for (const LA::Vector &component : in_space(s, slip_at_points(s)))
      result.push_back(nodal_field(s, component, pair));
    return result;
  }



  // An internal variable of the law.
  template <int dim>
  PointVectors
  slip_at_points(const Snapshot<dim> &s)
  {
    const std::vector<PointVectors> &vectors = s.contact_state.internal_at_end.vectors;
    return vectors.size() > 1 ? vectors[1] :
                                PointVectors(s.contact.n_components() - 1, s.contact.zero());
  }



  LA::Vector
  sticks(const LA::Vector &status)
  {
    LA::Vector result = status;
    for (const auto i : result.locally_owned_elements())
      result(i) = status_of(status(i)) == ContactStatus::stick;
    result.compress(VectorOperation::insert);
    return result;
  }



  template <int dim>
  ContactPatch
  stick_zone(const Snapshot<dim> &s, const unsigned int pair)
  {
    const PointVectors &t      = s.contact_state.traction;
    LA::Vector          margin = s.contact.zero();
    for (const auto i : margin.locally_owned_elements())
      {
        const double bound = s.contact.coefficients.friction_bound(i, t[0](i)).value;
        margin(i)          = std::max(0., bound - length_at(t, i, 1));
      }
    margin.compress(VectorOperation::insert);
    return contact_patch(s,
                         pair,
                         recovered_density(s, pair, margin, true),
                         sticks(s.contact_state.status));
  }



  template <int dim>
  std::vector<LA::Vector>
  tractions_of_path(const Snapshot<dim> &snapshot)
  {
    std::vector<LA::Vector> result;
    if (snapshot.contact.n_components() == 1)
      return result;
    LA::Vector counts = snapshot.contact.zero();
    snapshot.contact.for_each_point([&](const auto i, const unsigned int pair) {
      counts(i) = !snapshot.pairs[pair].friction.depends_on_slip() ||
                  status_of(snapshot.contact_state.status(i)) != ContactStatus::slip;
    });
    counts.compress(VectorOperation::insert);
    PointVectors t(snapshot.contact_state.traction.begin() + 1,
                   snapshot.contact_state.traction.end());
    for (LA::Vector &component : t)
      component.scale(counts);
    const std::vector<LA::Vector> components = in_space(snapshot, t);
    for (unsigned int pair = 0; pair < snapshot.pairs.size(); ++pair)
      for (const LA::Vector &component : components)
        result.push_back(recovered_density(snapshot, pair, component, false));
    return result;
  }



  // Where the coefficient after the slip is no number, none is left.
  template <int dim>
  LA::Vector
  ratio_of_friction(const Snapshot<dim> &s)
  {
    LA::Vector result = s.contact.zero();
    result            = 1.;
    const auto &path  = s.contact_state.internal_at_end.scalars;
    if (path.size() < 2 ||
        std::none_of(s.pairs.begin(), s.pairs.end(), [](const ContactPair<dim> &pair) {
          return pair.friction.depends_on_slip();
        }))
      return result;
    s.contact.for_each_point([&](const auto i, const unsigned int pair) {
      const FrictionCoefficient<dim> &friction = s.pairs[pair].friction;
      if (!friction.depends_on_slip() ||
          status_of(s.contact_state.status(i)) != ContactStatus::slip)
        return;
      const double pressure = s.contact_state.traction[0](i),
                   ratio    = s.contact.coefficients.area_ratio(i),
                   before   = s.contact.coefficients.friction_bound(i, pressure).value;
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = s.contact.geometry.position[d](i);
      const double after = ratio * friction.bound(x, s.time, pressure / ratio, path[1](i));
      if (before > 0)
        result(i) = std::isfinite(after) ? after / before : 0.;
    });
    result.compress(VectorOperation::insert);
    return result;
  }



  template <int dim>
  double
  change_of_friction(const Snapshot<dim> &s, const unsigned int pair)
  {
    const LA::Vector      ratio = ratio_of_friction(s);
    std::array<double, 2> sums{{0, 0}}; // of the bound, and of its changes
    s.contact.for_each_point([&](const auto i, const unsigned int of_point) {
      if (of_point != pair || !is_closed(s.contact_state.status(i)))
        return;
      const double bound =
        s.contact.weight(i) *
        s.contact.coefficients.friction_bound(i, s.contact_state.traction[0](i)).value;
      sums[0] += bound;
      sums[1] += std::abs(ratio(i) - 1) * bound;
    });
    const MPI_Comm comm = s.elasticity.mesh().communicator();
    for (double &sum : sums)
      sum = Utilities::MPI::sum(sum, comm);
    return sums[0] > 0 ? sums[1] / sums[0] : 0.;
  }



  // Gaps are differences of positions and displacements.
  double
  rounding_of_pressure(const double size, const GapOperator &contact, const LA::Vector &u)
  {
    constexpr double epsilon = 1e-14;
    return epsilon * contact.coefficients.stiffness.linfty_norm() * (size + u.linfty_norm());
  }



  // The law adds up the work per area of each point. That of a load step is what it has added there
  // since its start, also where a point is open at the end.
  template <int dim>
  std::vector<double>
  bound_of_friction(const Snapshot<dim> &s)
  {
    std::vector<double> result(s.pairs.size(), 0.);
    s.contact.for_each_point([&](const auto i, const unsigned int pair) {
      if (is_closed(s.contact_state.status(i)))
        result[pair] +=
          s.contact.weight(i) *
          s.contact.coefficients.friction_bound(i, s.contact_state.traction[0](i)).value;
    });
    Utilities::MPI::sum(result, s.elasticity.mesh().communicator(), result);
    return result;
  }



  template <int dim>
  double
  relative_mean_bound(const Snapshot<dim> &s, const unsigned int pair, const double bound)
  {
    const std::vector<double> &before = s.friction_bound_at_start;
    // A coefficient that depends on time may have jumped to its present value at any time.
    const bool is_known = !before.empty() && bound > 0 && !s.pairs[pair].friction.depends_on_time();
    return is_known ? 0.5 * (1 + before[pair] / bound) : 1.;
  }



  template <int dim>
  std::vector<double>
  work_of_friction(const Snapshot<dim>       &s,
                   const std::vector<double> &before,
                   const std::vector<double> &bounds)
  {
    std::vector<double> result(s.pairs.size(), 0.);
    const PointVectors &first = s.contact_state.internal.scalars,
                       &last  = s.contact_state.internal_at_end.scalars;
    if (!last.empty())
      s.contact.for_each_point([&](const auto i, const unsigned int pair) {
        result[pair] +=
          s.contact.weight(i) * (last[0](i) - (first.empty() ? 0. : double(first[0](i))));
      });
    Utilities::MPI::sum(result, s.elasticity.mesh().communicator(), result);
    for (unsigned int p = 0; p < result.size(); ++p)
      result[p] =
        relative_mean_bound(s, p, bounds[p]) * result[p] + (before.empty() ? 0. : before[p]);
    return result;
  }



  template <int dim>
  bool
  has_tangential_forces(const Snapshot<dim> &s)
  {
    constexpr double none       = 1e-6;
    double           tangential = 0, normal = 0;
    for (unsigned int pair = 0; pair < s.pairs.size(); ++pair)
      {
        for (const LA::Vector &component : tangential_traction(s, pair))
          tangential += component.l1_norm();
        normal += recovered_pressure(s, pair).l1_norm();
      }
    return tangential > none * normal;
  }



#define INSTANTIATE(dim)                                                                             \
  template std::vector<LA::Vector> in_space(const Snapshot<dim> &, const PointVectors &);            \
  template std::vector<LA::Vector> tangential_traction(const Snapshot<dim> &, unsigned int);         \
  template std::vector<LA::Vector> slip_since_contact(const Snapshot<dim> &, unsigned int);          \
  template PointVectors            slip_at_points(const Snapshot<dim> &);                            \
  template ContactPatch            stick_zone(const Snapshot<dim> &, unsigned int);                  \
  template LA::Vector              ratio_of_friction(const Snapshot<dim> &);                         \
  template double                  change_of_friction(const Snapshot<dim> &, unsigned int);          \
  template std::vector<LA::Vector> tractions_of_path(const Snapshot<dim> &);                         \
  template std::vector<double>     bound_of_friction(const Snapshot<dim> &);                         \
  template double                  relative_mean_bound(const Snapshot<dim> &, unsigned int, double); \
  template std::vector<double>     work_of_friction(const Snapshot<dim> &,                           \
                                                    const std::vector<double> &,                     \
                                                    const std::vector<double> &);                    \
  template bool                    has_tangential_forces(const Snapshot<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
