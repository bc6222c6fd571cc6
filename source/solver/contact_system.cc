// SPDX-License-Identifier: Apache-2.0
#include "solver/contact_system.h"

#include "base/interruption.h"

#include <utility>

namespace Signorini
{
  using namespace dealii;

  ContactSystem::ContactSystem(const Stiffness          &stiffness,
                               const ContactLaw         &law,
                               UnconstrainedModes        unconstrained_modes,
                               const VolumetricCoupling *volumetric,
                               const bool                symmetric_bodies)
    : K(stiffness)
    , law(law)
    , contact(law.gap_operator())
    , my_volumetric(volumetric)
    , saddle(law.has_multiplier())
    , symmetric_bodies(symmetric_bodies)
    , motions(std::move(unconstrained_modes))
    , D(law.n_components(), contact.zeros())
    , X(D)
    , Y(D)
    , Z(D)
    , C(D)
    , I(D)
    , A(contact.zero())
  {
    if (!saddle && !contact.empty())
      make_surface_pattern();
  }



  // Laws with constant derivatives need no tractions: only the statuses of points change the
  // system.
  void
  ContactSystem::set_status(const LA::Vector &status)
  {
    Assert(law.has_constant_derivatives(), ExcInternalError());
    const PointVectors   nothing  = contact.zeros();
    const InternalFields internal = law.initial_fields();
    linearise({nothing, nothing, nothing, internal}, status);
  }



  // Evaluate the law at all points and store the diagonal blocks D, X, Y, Z (4.3) and C, I, A
  // (4.6); then the surface stiffness, and the modes that closed points leave unconstrained.
  // Collective.
  void
  ContactSystem::linearise(const LawInputs &in, const LA::Vector &status)
  {
    for (const auto i : status.locally_owned_elements())
      {
        const ContactStatus now = status_of(status(i));
        linearise(i, law.response(i, in.at(i), now), now);
      }
    for (Blocks *blocks : {&D, &X, &Y, &Z, &C, &I})
      for (PointVectors &row : *blocks)
        for (LA::Vector &block : row)
          block.compress(VectorOperation::insert);
    A.compress(VectorOperation::insert);
    if (!saddle && !contact.empty())
      sum_up_surface_stiffness();
    motions.set_status(status);
  }



  // The blocks of one point.
  void
  ContactSystem::linearise(const types::global_dof_index i,
                           const LawResponse            &response,
                           const ContactStatus           status)
  {
    const double       W = contact.weight(i), k = contact.coefficients.stiffness(i);
    const bool         closed = status != ContactStatus::open;
    const unsigned int n      = law.n_components();
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = 0; b < n; ++b)
        {
          const double unit = a == b ? 1 : 0, by_gap = response.by_gap[a][b],
                       by_stress = response.by_stress[a][b];
          D[a][b](i)             = -by_gap * W;
          X[a][b](i)             = by_stress * W;
          if (contact.has_stress())
            {
              const double epsilon = contact.coefficients.epsilon(i);
              Y[a][b](i)           = (unit - by_stress) / epsilon * W;
              Z[a][b](i)           = -by_gap / epsilon * W;
            }
          if (!saddle)
            continue;
          C[a][b](i) = k * W * response.residual_by_gap[a][b];
          I[a][b](i) = closed ? k * k * response.residual_by_traction[a][b] * W : unit * k * W;
        }
    A(i) = saddle && closed ? k * W : 0.;
  }



  PointVectors
  ContactSystem::contact_stiffness() const
  {
    PointVectors result;
    for (unsigned int a = 0; a < D.size(); ++a)
      result.push_back(D[a][a]);
    return result;
  }



  bool
  ContactSystem::is_active_point(const types::global_dof_index point) const
  {
    bool any = A(point) != 0;
    for (unsigned int a = 0; a < D.size(); ++a)
      any = any || D[a][a](point) != 0;
    return any;
  }



  LA::BlockVector
  ContactSystem::zero() const
  {
    std::vector<IndexSet> blocks = {K.owned()};
    blocks.resize(1 + n_multiplier_blocks(),
                  saddle ? contact.weight.locally_owned_elements() : IndexSet(0));
    if (my_volumetric)
      blocks.push_back(my_volumetric->schur.locally_owned_elements());
    return LA::BlockVector(blocks, K.communicator());
  }



  // dst = A src: contact terms, K - G, stabilisation along unconstrained modes, and volumetric
  // stress. Collective; called once in each Krylov iteration.
  void
  ContactSystem::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    // Number of products between two checks for an interruption: hundreds of products take less
    // than a second, or minutes.
    constexpr unsigned int often = 8;
    if (++n_products % often == 0)
      check_for_interruption();
    contact_terms(dst, src);
    LA::Vector &force = workspace;
    force.reinit(src.block(0), true);
    internal_force(force, src.block(0));
    dst.block(0) += force;
    motions.add_unconstrained_stiffness(dst.block(0), src.block(0));
    if (my_volumetric)
      add_volumetric(dst, src);
  }



  // Rows and columns of the volumetric stress, B_m^T dm and B_m du - C_m dm (doc/theory, (6.20)).
  void
  ContactSystem::add_volumetric(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    const unsigned int m = volumetric_block();
    my_volumetric->B.Tvmult_add(dst.block(0), src.block(m));
    LA::Vector volume;
    volume.reinit(src.block(m), true);
    my_volumetric->C.vmult(volume, src.block(m));
    volume *= -1;
    my_volumetric->B.vmult_add(volume, src.block(0));
    dst.block(m) += volume;
    if (contact.has_volumetric_stress())
      add_volumetric_at_contact(dst, src);
  }



  // With Nitsche's method the stress s has the part T dm (doc/theory, (4.4) with [S T] in place of
  // S).
  void
  ContactSystem::add_volumetric_at_contact(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    Assert(!transposed, dealii::StandardExceptions::ExcNotImplemented());
    const auto product = [](const LA::Vector &block, const LA::Vector &v, const double factor) {
      LA::Vector result = v;
      result.scale(block);
      result *= factor;
      return result;
    };
    const unsigned int m = volumetric_block(), n = law.n_components();
    const double       theta = contact.theta;
    PointVectors       gap = contact.zeros(), stress = gap, of_volumetric = gap;
    for (unsigned int b = 0; b < n; ++b)
      {
        contact.free_rows(b).vmult(gap[b], src.block(0));
        contact.S_free[b].vmult(stress[b], src.block(0));
        contact.S_volumetric[b].vmult(of_volumetric[b], src.block(m));
        stress[b] += of_volumetric[b];
      }
    for (unsigned int a = 0; a < n; ++a)
      {
        LA::Vector on_gap = contact.zero(), on_stress = on_gap, on_volumetric = on_gap;
        for (unsigned int b = 0; b < n; ++b)
          {
            on_gap += product(X[a][b], of_volumetric[b], -1);
            on_stress += product(Y[a][b], of_volumetric[b], -theta);
            on_volumetric += product(Y[a][b], stress[b], -theta);
            on_volumetric += product(Z[a][b], gap[b], -theta);
          }
        contact.free_rows(a).Tvmult_add(dst.block(0), on_gap);
        contact.S_free[a].Tvmult_add(dst.block(0), on_stress);
        contact.S_volumetric[a].Tvmult_add(dst.block(m), on_volumetric);
      }
  }



  // (K - G) du without the stabilisation of unconstrained modes.
  void
  ContactSystem::internal_force(LA::Vector &dst, const LA::Vector &du) const
  {
    K.vmult(dst, du);
    if (uses_geometric)
      contact.subtract_geometric(dst, du);
    motions.subtract_stabilisation(dst, du);
  }



  // dst = contact blocks times src, without K: those of the multipliers, or the surface stiffness.
  void
  ContactSystem::contact_terms(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    if (contact.empty())
      return;
    if (saddle)
      add_multipliers(dst, src);
    else
      add_surface_forces(dst.block(0), src.block(0));
  }



  // The blocks of the multipliers in (4.5), or their transposes.
  void
  ContactSystem::add_multipliers(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    const unsigned int n           = law.n_components();
    const auto         minus_scale = [](LA::Vector &v, const LA::Vector &block) {
      v.scale(block);
      v *= -1;
    };
    LA::Vector term = contact.zero();
    for (unsigned int b = 0; b < n; ++b)
      {
        // Constraint rows: -C_ab B_b u; of the transposed matrix -A B_b u.
        LA::Vector gap = contact.zero();
        contact.free_rows(b).vmult(gap, src.block(0));
        for (unsigned int a = 0; a < n; ++a)
          {
            if (transposed && a != b)
              continue;
            term = gap;
            minus_scale(term, transposed ? A : C[a][b]);
            dst.block(1 + a) += term;
          }
        for (unsigned int a = 0; a < n; ++a)
          {
            term = src.block(1 + b);
            minus_scale(term, transposed ? I[b][a] : I[a][b]);
            dst.block(1 + a) += term;
          }
        // Forces: -B_b^T A q_b; of the transposed matrix -B_b^T sum_a C_ab q_a.
        LA::Vector force = contact.zero();
        for (unsigned int a = 0; a < n; ++a)
          {
            if (!transposed && a != b)
              continue;
            term = src.block(1 + a);
            minus_scale(term, transposed ? C[a][b] : A);
            force += term;
          }
        contact.free_rows(b).Tvmult_add(dst.block(0), force);
      }
  }



  // Gather the displacement at the local columns, multiply by the summed-up surface stiffness, and
  // add the forces to their owners. Collective.
  void
  ContactSystem::add_surface_forces(LA::Vector &dst, const LA::Vector &src) const
  {
    columns->fetch(src, displacement.begin());
    if (columns->size() > 0 && transposed)
      surface.Tvmult(force, displacement);
    else if (columns->size() > 0)
      surface.vmult(force, displacement);
    columns->add(force.begin(), dst);
  }
} // namespace Signorini
