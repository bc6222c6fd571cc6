// SPDX-License-Identifier: Apache-2.0
#include "accuracy/error_parts.h"
#include "accuracy/traction_errors.h"
#include "contact/constraints/gap_increments.h"
#include "fields/friction_fields.h"
#include "fields/nodal_fields.h"
#include "fields/point_values.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return a field of nodes with the functions of the multipliers at a contact point.
    template <int dim>
    double
    multiplied_at(const ContactPoint<dim> &point, const LA::Vector &nodes)
    {
      double result = 0;
      for (const auto &[node, value] : point.multiplier_shape)
        result += value * nodes(node);
      return result;
    }

    /// @return what the solution leaves of the relation of pressure and gap at the rows, which is
    /// that of the enforcement: g + d(p) at closed points, zero at others.
    template <int dim>
    LA::Vector
    left_at_rows(const Snapshot<dim> &s)
    {
      LA::Vector result = s.contact.zero();
      for (const auto i : s.gap.locally_owned_elements())
        if (s.active(i) > 0)
          result(i) = s.gap(i) + s.contact.coefficients.overclosure(i, s.pressure(i)).value;
      result.compress(VectorOperation::insert);
      return result;
    }

    /// Add (8.25) of one pair. The law at a point is that of the gap at the point, which nodes know
    /// as a mean only; with n cells across a stiff body on a soft layer, its rotation has an error
    /// of 2/n^2 by that, and no recovered stress shows it.
    template <int dim>
    void
    add_compliance_errors(const Snapshot<dim> &s,
                          const Functional    &functional,
                          const LA::Vector    &z,
                          const unsigned int   pair,
                          std::vector<double> &of_cells)
    {
      const ContactSurface<dim> &surface    = s.surfaces[pair];
      const ContactPair<dim>    &law        = s.pairs[pair];
      const bool                 has_normal = law.compliance.kind != PressureOverclosure::hard;
      const PointValues          values     = point_values(s, pair);
      const LA::Vector pressure = s.elasticity.with_ghosts(nodal_field(s, s.pressure, pair)),
                       left     = s.elasticity.with_ghosts(nodal_field(s, left_at_rows(s), pair));
      // Tractions at the nodes, and what is recovered of them at points.
      std::vector<LA::Vector> tangential;
      if (s.contact.n_components() > 1)
        for (const LA::Vector &component :
             in_space(s, {s.contact_state.traction.begin() + 1, s.contact_state.traction.end()}))
          tangential.push_back(s.elasticity.with_ghosts(nodal_field(s, component, pair)));
      const std::vector<LA::Vector> recovered = recovered_traction(s, pair);
      TractionErrors<dim>           errors;
      for (unsigned int q = 0; q < surface.points.size(); ++q)
        {
          const ContactPoint<dim> &point = surface.points[q];
          const double             sum   = multiplied_at(point, pressure) / point.stretch;
          double                   exact = values.pressure[q];
          if (has_normal)
            exact = law.compliance.pressure(value_at(surface, point, left) - values.gap[q]);
          if (law.can_separate)
            exact = std::max(0., exact);
          // The bound of friction follows the pressure. Where points stick the recovered traction
          // is the best that is known; the dual solution is nearly orthogonal to its error.
          const double follows =
            law.can_separate && values.pressure[q] > 0 ? exact / values.pressure[q] : 1.;
          Tensor<1, dim> along = follows * vector_at(surface, point, recovered);
          for (unsigned int d = 0; d < tangential.size(); ++d)
            along[d] -= multiplied_at(point, tangential[d]) / point.stretch;
          errors.points.push_back(q);
          errors.pressure.push_back(exact - sum);
          errors.tangential.push_back(along);
        }
      add_traction_errors(s, functional, z, pair, errors, of_cells);
    }
  } // namespace



  // Methods that sample at quadrature points have the law at each of them, and no such error.
  template <int dim>
  std::vector<double>
  compliance_errors(const Snapshot<dim> &s, const Functional &functional, const LA::Vector &z)
  {
    std::vector<double> result(s.elasticity.mesh().triangulation().n_active_cells(), 0.);
    if (!s.contact.empty() && samples_nodes(s.contact))
      for (unsigned int pair = 0; pair < s.pairs.size(); ++pair)
        if (!s.pairs[pair].compliance.is_rigid())
          add_compliance_errors(s, functional, z, pair, result);
    return result;
  }



  template std::vector<double>
  compliance_errors(const Snapshot<2> &, const Functional &, const LA::Vector &);
  template std::vector<double>
  compliance_errors(const Snapshot<3> &, const Functional &, const LA::Vector &);
} // namespace Signorini
