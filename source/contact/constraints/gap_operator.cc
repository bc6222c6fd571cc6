// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/gap_operator.h"

#include "linear_algebra/entries.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  double
  length_at(const PointVectors &v, const types::global_dof_index i, const unsigned int first)
  {
    double square = 0;
    for (unsigned int a = first; a < v.size(); ++a)
      square += v[a](i) * v[a](i);
    return std::sqrt(square);
  }



  // A bound that is not linear is a formula of the user: its derivative is a central difference.
  ContactCoefficients::FrictionBound
  ContactCoefficients::friction_bound(const types::global_dof_index point,
                                      const double                  pressure) const
  {
    if (pressure <= 0)
      return {0., 0.};
    if (!bound_of)
      return {friction(point) * pressure, friction(point)};
    constexpr double small = 1e-5;
    const double     step  = small * pressure;
    return {bound_of(point, pressure),
            (bound_of(point, pressure + step) - bound_of(point, pressure - step)) / (2 * step)};
  }



  ContactCompliance::Value
  ContactCoefficients::overclosure(const types::global_dof_index point, const double pressure) const
  {
    if (!compliance_of)
      return {0., 0.};
    const double                   ratio  = area_ratio(point);
    const ContactCompliance::Value result = compliance_of(point).overclosure(pressure / ratio);
    return {result.value, result.derivative / ratio};
  }



  // Multiplied by the ratio of areas, (2.33) is the equation for true pressures with epsilon/ratio.
  ContactCompliance::Value
  ContactCoefficients::pressure(const types::global_dof_index point,
                                const double                  trial,
                                const double                  epsilon) const
  {
    if (!compliance_of)
      return {trial, 1.};
    const double                   ratio = area_ratio(point);
    const ContactCompliance::Value result =
      compliance_of(point).pressure(trial / ratio, epsilon / ratio);
    return {ratio * result.value, result.derivative};
  }



  double
  ContactCoefficients::tangential_compliance(const types::global_dof_index point) const
  {
    return compliance_of ? 1 / (area_ratio(point) * compliance_of(point).tangential_stiffness) : 0.;
  }



  // g_0 of the rows = beta g_ref + offset (doc/theory, (5.2)); the factor beta of the pair applies
  // to penetrations and to all points of bilateral pairs.
  void
  GapOperator::set_interference(const std::vector<double> &shares)
  {
    interference = shares;
    auto which   = origin.pair.begin();
    initial_gap.reinit(reference_gap);
    for (const auto i : reference_gap.locally_owned_elements())
      {
        const double share  = shares[*which++];
        const bool   counts = reference_gap(i) < 0 || coefficients.least_status(i) > 0;
        const double change = at_rest() ? 0. : double(moved.gap_offset(i));
        const double start  = gap_at_start.size() > 0 ? double(gap_at_start(i)) : 0.;
        initial_gap(i)      = (counts ? share : 1.) * reference_gap(i) + change - start;
      }
    initial_gap.compress(VectorOperation::insert);
  }



  // Only this product has to be computed again in a load step with other temperatures: the mesh,
  // and with it S_thermal, are the same.
  void
  GapOperator::set_temperature_change(const LA::Vector &temperature_change)
  {
    thermal_stress.assign(S_thermal.size(), zero());
    for (unsigned int a = 0; a < S_thermal.size(); ++a)
      S_thermal[a].vmult(thermal_stress[a], temperature_change);
  }



  LA::Vector
  GapOperator::gap(const LA::Vector &u) const
  {
    // Without any points on all ranks the matrix has no rows and was not set up.
    LA::Vector g = zero();
    if (!empty())
      B.vmult(g, u);
    g += initial_gap;
    return g;
  }



  // In the reference configuration the slip is measured by -B_a u_n; in displaced ones the offset
  // contains the start already.
  void
  GapOperator::set_start(const LA::Vector &u)
  {
    for (unsigned int a = 0; a < tangential.B.size() && at_rest(); ++a)
      {
        tangential.B[a].vmult(tangential.offset[a], u);
        tangential.offset[a] *= -1;
      }
  }



  // The normal gap, then one slip for each tangent (equation 3.13), all in the same units.
  PointVectors
  GapOperator::gaps(const LA::Vector &u) const
  {
    PointVectors result = {gap(u)};
    for (unsigned int a = 0; a < tangential.B.size(); ++a)
      {
        result.push_back(zero());
        tangential.B[a].vmult(result.back(), u);
        result.back() += tangential.offset[a];
      }
    return result;
  }



  // A rank without points contributes zero.
  unsigned int
  GapOperator::n_pairs() const
  {
    const auto        &pair = origin.pair;
    const unsigned int own  = pair.empty() ? 0 : 1 + *std::max_element(pair.begin(), pair.end());
    return Utilities::MPI::max(own, weight.get_mpi_communicator());
  }



  // s = S u + s_0: s_0 has the thermal part, the part of loads and linearisation, and that of the
  // volumetric stress m.
  PointVectors
  GapOperator::stress(const LA::Vector &u, const LA::Vector &m) const
  {
    PointVectors s = zeros();
    for (unsigned int a = 0; a < S.size(); ++a)
      {
        if (!empty())
          S[a].vmult(s[a], u);
        for (const PointVectors *fixed : {&thermal_stress, &fixed_stress})
          if (!fixed->empty())
            s[a] += (*fixed)[a];
        if (has_volumetric_stress())
          S_volumetric[a].vmult_add(s[a], m);
      }
    return s;
  }



  // sum_a B_a^T W t_a + theta S^T W E^-1 (s - p) (doc/theory, (4.1)), with the rows for free or for
  // all degrees of freedom.
  LA::Vector
  GapOperator::transposed(const bool is_free, const PointVectors &p, const PointVectors &s) const
  {
    // Not the communicator of p: an empty vector may have been assigned without one.
    LA::Vector result(dofs, weight.get_mpi_communicator());
    if (empty())
      return result;
    LA::Vector term;
    term.reinit(result);
    // The first product overwrites the result, which saves a vector; the others are added. W is
    // applied to the tractions first, since they are short vectors over the surface.
    for (unsigned int a = 0; a < p.size(); ++a)
      {
        LA::Vector weighted = p[a];
        weighted.scale(weight);
        (is_free ? free_rows(a) : rows(a)).Tvmult(a == 0 ? result : term, weighted);
        if (a > 0)
          result += term;
      }
    if (theta == 0)
      return result;
    for (unsigned int a = 0; a < p.size(); ++a)
      {
        (is_free ? S_free : S)[a].Tvmult(term, nitsche_residual(p[a], s[a]));
        result += term;
      }
    return result;
  }



  // theta W E^-1 (s - p), the argument of S^T in the consistency term (doc/theory, 2.7).
  LA::Vector
  GapOperator::nitsche_residual(const LA::Vector &p, const LA::Vector &s) const
  {
    LA::Vector result = zero();
    for (const auto i : result.locally_owned_elements())
      result(i) = theta * weight(i) / coefficients.epsilon(i) * (s(i) - p(i));
    result.compress(VectorOperation::insert);
    return result;
  }



  LA::Vector
  GapOperator::force_on_volumetric_stress(const PointVectors &p, const PointVectors &s) const
  {
    LA::Vector result(S_volumetric[0].locally_owned_domain_indices(),
                      weight.get_mpi_communicator());
    for (unsigned int a = 0; a < p.size() && theta != 0; ++a)
      S_volumetric[a].Tvmult_add(result, nitsche_residual(p[a], s[a]));
    return result;
  }



  // Forces for the residual of Newton's method: constrained degrees of freedom have none, and those
  // of inclined supports are handed to the components that they depend on.
  LA::Vector
  GapOperator::force(const PointVectors &p, const PointVectors &s) const
  {
    return transposed(true, p, s);
  }



  // Forces as they act on all nodes, from which reactions of supports and the resultants of pairs
  // are computed.
  LA::Vector
  GapOperator::total_force(const PointVectors &p, const PointVectors &s) const
  {
    return transposed(false, p, s);
  }



  // dst += G (u - u_k) (doc/theory, (5.9)).
  void
  GapOperator::add_moved_force(LA::Vector &dst, const LA::Vector &u) const
  {
    if (!moved.G)
      return;
    LA::Vector change = u;
    change -= moved.linearisation_point;
    moved.G->vmult_add(dst, change, 1);
  }



  // G has the sign of a force, and the tangent that of a stiffness: K - G.
  void
  GapOperator::subtract_geometric(LA::Vector &dst, const LA::Vector &v) const
  {
    if (moved.G)
      moved.G->vmult_add(dst, v, -1);
  }



  void
  GapOperator::for_each_geometric_entry(
    const LA::Vector &numbers, const std::function<void(double, double, double)> &add) const
  {
    if (moved.G)
      moved.G->for_each_entry(numbers, add);
  }



  std::size_t
  GapOperator::memory_consumption() const
  {
    std::size_t                           bytes    = 0;
    std::vector<const LA::SparseMatrix *> matrices = {&B, &B_free};
    for (const auto *more :
         {&tangential.B, &tangential.B_free, &S, &S_free, &S_thermal, &S_volumetric})
      for (const LA::SparseMatrix &matrix : *more)
        matrices.push_back(&matrix);
    // Matrices that the method does not need are empty and were never set up.
    for (const LA::SparseMatrix *matrix : matrices)
      if (matrix->m() > 0)
        bytes += LA::memory_consumption(*matrix);
    if (moved.G)
      bytes += moved.G->memory_consumption();
    const std::size_t n_vectors =
      5 + geometry.position.size() + geometry.normal.size() + geometry.moment.size();
    return bytes + weight.locally_owned_size() * n_vectors * sizeof(double);
  }
} // namespace Signorini
