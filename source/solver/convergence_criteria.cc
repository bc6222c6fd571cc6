// SPDX-License-Identifier: Apache-2.0
#include "solver/convergence_criteria.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  ConvergenceCriteria::ConvergenceCriteria(const SolidResidual &bodies,
                                           const ContactLaw    &law,
                                           const double         tolerance)
    : bodies(bodies)
    , law(law)
    , contact(law.gap_operator())
    , tolerance(tolerance)
  {
    const auto &body = bodies.body_of_dof();
    const auto  last = std::max_element(body.begin(), body.end());
    n_bodies =
      Utilities::MPI::max(last == body.end() ? 0u : *last + 1, bodies.stiffness().communicator());
  }



  void
  ConvergenceCriteria::restart()
  {
    largest_force = 0;
  }



  // Residual (4.1) with the scales of forces (4.15) and the rounding (4.17). Collective.
  LA::Vector
  ConvergenceCriteria::residual(const LA::Vector &u, const LawInputs &in, const LA::Vector &status)
  {
    LA::Vector r       = bodies.residual(u);
    double     largest = bodies.load_size();
    my_reference_forces.assign(n_bodies, largest);
    if (!contact.empty())
      {
        const LA::Vector force = contact.force(in.traction, in.stress);
        r += force;
        contact.add_moved_force(r, u);
        largest             = std::max(largest, force.l2_norm());
        my_reference_forces = reference_forces(force, largest);
      }
    // Without present forces, the largest force so far is the scale, or one beside which the
    // rounding of strains is as small as the tolerance: surfaces may just touch.
    const double least =
      std::max(largest <= 1e-13 * bodies.largest_load() ? bodies.largest_load() : 0.,
               bodies.rounding_without_loads() / tolerance);
    if (largest < least)
      {
        largest = least;
        my_reference_forces.assign(n_bodies, largest);
      }
    bodies.constraints().set_zero(r);
    force_scale = largest;
    // The forces of a cold start may be far larger than those of the solution, such as penalties of
    // overlapping bodies; later residuals contain their rounding.
    largest_force = std::max(largest_force, largest);
    // A residual within the rounding is accepted only if that is small beside the forces.
    force_rounding =
      std::max(1e-15 * largest_force, std::min(rounding(u, in, status), 1e-4 * largest));
    return r;
  }



  // Norms over the degrees of freedom of each body. Collective.
  std::vector<double>
  ConvergenceCriteria::norms_of_bodies(const LA::Vector &force) const
  {
    std::vector<double> squares(n_bodies, 0.);
    auto                body = bodies.body_of_dof().begin();
    for (const double x : force)
      squares[*body++] += x * x;
    Utilities::MPI::sum(squares, force.get_mpi_communicator(), squares);
    for (double &x : squares)
      x = std::sqrt(x);
    return squares;
  }



  std::vector<double>
  ConvergenceCriteria::reference_forces(const LA::Vector &contact_force, const double scale) const
  {
    // The lower bound prevents a tolerance below the rounding of the largest forces.
    constexpr double    most = 1e3, least = 1e-4;
    std::vector<double> forces = norms_of_bodies(contact_force);
    for (double &force : forces)
      force = force > 0 ? std::clamp(most * force, least * scale, scale) : scale;
    return forces;
  }



  std::vector<double>
  ConvergenceCriteria::residuals_of_bodies(const LA::Vector &r) const
  {
    std::vector<double> result = norms_of_bodies(r);
    for (unsigned int body = 0; body < n_bodies; ++body)
      result[body] = my_reference_forces[body] > 0 ? result[body] / my_reference_forces[body] : 0.;
    return result;
  }



  double
  ConvergenceCriteria::residual_of_bodies(const LA::Vector &r) const
  {
    double largest = 0;
    for (const double residual : residuals_of_bodies(r))
      largest = std::max(largest, residual);
    return largest;
  }



  unsigned int
  ConvergenceCriteria::worst_body(const LA::Vector &r) const
  {
    const std::vector<double> residuals = residuals_of_bodies(r);
    return std::max_element(residuals.begin(), residuals.end()) - residuals.begin();
  }



  double
  ConvergenceCriteria::smallest_reference_force() const
  {
    return force_scale > 0 ?
             *std::min_element(my_reference_forces.begin(), my_reference_forces.end()) :
             scale();
  }



  // Estimate (4.17) of the rounding error of the residual. Collective.
  double
  ConvergenceCriteria::rounding(const LA::Vector &u,
                                const LawInputs  &in,
                                const LA::Vector &status) const
  {
    // The terms of K u cancel where bodies move far with small strains, as in bending.
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    if (version != bodies.stiffness().version())
      {
        stiffness_diagonal = bodies.stiffness().diagonal();
        version            = bodies.stiffness().version();
      }
    LA::Vector terms = stiffness_diagonal;
    terms.scale(u);
    bodies.constraints().set_zero(terms);
    const double of_bodies = 2 * epsilon * terms.l2_norm();
    if (contact.empty() || law.has_multiplier())
      return of_bodies;
    LA::Vector springs = contact.zero();
    for (const auto i : springs.locally_owned_elements())
      springs(i) =
        contact.weight(i) * law.response(i, in.at(i), status_of(status(i))).by_gap.norm();
    springs.compress(VectorOperation::insert);
    const double length = 2 * u.linfty_norm() + contact.initial_gap.linfty_norm();
    return of_bodies + epsilon * length * springs.l2_norm();
  }



  // Forces have converged (doc/theory, 4.9) if the residual is small, or if it no longer decreases
  // and is within rounding, or if only rounding of earlier forces is left; and if the active set is
  // that of the law.
  bool
  ConvergenceCriteria::is_force_converged(const NewtonStep &step, const double before) const
  {
    // Points that hardly touch may change their status between any two steps without effect on the
    // residual.
    constexpr double largest_undecided = 1e-8;
    const bool       at_bottom = step.changes == 0 && before > 0 && step.residual > before / 2 &&
                           step.residual <= force_rounding / scale();
    const double of_all = std::max(step.residual, step.residual_of_bodies);
    // Only rounding errors of earlier forces are left.
    const bool is_over =
      scale() <= 10 * force_rounding && step.residual * scale() <= 10 * force_rounding;
    const bool is_small =
      of_all <= tolerance && (step.changes == 0 || step.residual <= largest_undecided);
    return (is_small || at_bottom || is_over) && !step.kept_previous_set && !step.restricted_set &&
           (!law.has_scaled_penalty() || step.active == 0);
  }



  // Gap criterion (4.18).
  bool
  ConvergenceCriteria::is_gap_converged(const NewtonStep &step) const
  {
    // The change of an augmentation is known up to the residual of the last solution only.
    return step.gap_residual <= (law.augments() ? 10 : 1) *
                                  std::max(tolerance, force_rounding / smallest_reference_force());
  }
} // namespace Signorini
