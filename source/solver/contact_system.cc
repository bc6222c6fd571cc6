// SPDX-License-Identifier: Apache-2.0
#include "solver/contact_system.h"

#include "base/interruption.h"
#include "linear_algebra/row_view.h"
#include "linear_algebra/values.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>

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



  // Sparsity pattern of the surface stiffness over the local columns of B_free: the columns of each
  // row are coupled. Consecutive rows between the same two faces have the same columns and are
  // added once.
  void
  ContactSystem::make_surface_pattern()
  {
    columns.emplace(contact.B_free);
    DynamicSparsityPattern entries(columns->size(), columns->size());
    const int              n_rows = contact.weight.locally_owned_size();
    for (int row = 0; row < n_rows; ++row)
      {
        const LA::RowView view(contact.B_free, row);
        if (row > 0 && view.has_columns_of(LA::RowView(contact.B_free, row - 1)))
          continue;
        std::vector<unsigned int> sorted(view.columns, view.columns + view.size);
        std::sort(sorted.begin(), sorted.end());
        for (const unsigned int column : sorted)
          entries.add_entries(column, sorted.begin(), sorted.end(), true);
      }
    pattern.copy_from(entries);
    surface.reinit(pattern);
    displacement.reinit(columns->size());
    force.reinit(columns->size());
  }



  namespace
  {
    /// The differences of the blocks to those of `before`, point by point; `before` is set to the
    /// present ones.
    std::vector<std::vector<double>>
    changes(const ContactSystem::Blocks &now, std::vector<std::vector<double>> &before)
    {
      std::vector<std::vector<double>> result;
      before.resize(now.size() * now.size());
      for (const PointVectors &row : now)
        for (const LA::Vector &block : row)
          {
            std::vector<double> &last   = before[result.size()];
            const double *const  values = LA::values_of(block);
            const unsigned int   n      = block.locally_owned_size();
            last.resize(n, 0.);
            result.emplace_back(n);
            for (unsigned int i = 0; i < n; ++i)
              {
                result.back()[i] = values[i] - last[i];
                last[i]          = values[i];
              }
          }
      return result;
    }

    /// The contact stiffness between the components a (left) and b (right) of a point, the 2 x 2
    /// matrix of doc/theory, (4.4).
    struct PointStiffness
    {
      double d, x, y, z; ///< see ContactSystem; y and z times theta

      bool
      is_zero() const
      {
        return d == 0 && x == 0 && y == 0 && z == 0;
      }

      /// Add B_a^T (d B_b - x S_b) - S_a^T (z B_b + y S_b) to a block over the columns of the
      /// point.
      /// @param S_a,S_b rows of the normal stress; null: that component has none
      void
      add_to(FullMatrix<double> &block,
             const double       *B_a,
             const double       *S_a,
             const double       *B_b,
             const double       *S_b) const
      {
        const unsigned int n = block.m();
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int l = 0; l < n; ++l)
            {
              double sum = B_a[k] * (S_b ? d * B_b[l] - x * S_b[l] : d * B_b[l]);
              if (S_a)
                sum -= S_a[k] * (S_b ? z * B_b[l] + y * S_b[l] : z * B_b[l]);
              block(k, l) += sum;
            }
      }
    };
  } // namespace



  // Sum up the contact stiffness of all points of this rank in the matrix `surface`: one product
  // with it replaces those with B, D and B^T in each iteration. Cost: points times squares of their
  // columns, once for each linearisation.
  void
  ContactSystem::sum_up_surface_stiffness()
  {
    if (surface.empty())
      return; // no points on this rank
    // With normal stresses open points contribute too, and most points are unchanged between two
    // active sets: only differences are added. Without them the matrix is summed up anew, since the
    // differences of stiff penalties would leave rounding errors.
    if (!contact.has_stress())
      {
        surface = 0;
        sums    = Sums();
      }
    const Sums                           change{changes(D, sums.D),
                      changes(X, sums.X),
                      changes(Y, sums.Y),
                      changes(Z, sums.Z)};
    const int                            n_points = contact.weight.locally_owned_size();
    FullMatrix<double>                   block; // sum over points between the same two faces
    std::vector<types::global_dof_index> indices;
    for (int first = 0, last = 0; first < n_points; first = last)
      {
        const LA::RowView columns(contact.B_free, first);
        block.reinit(columns.size, columns.size);
        bool any = false;
        for (; last < n_points && LA::RowView(contact.B_free, last).has_columns_of(columns); ++last)
          any |= add_point(block, last, change);
        if (!any)
          continue;
        indices.assign(columns.columns, columns.columns + columns.size);
        surface.add(indices, block);
      }
  }



  // Add the contribution of one point, from the differences of its blocks; false if all of them are
  // zero.
  bool
  ContactSystem::add_point(FullMatrix<double> &block, const int point, const Sums &of) const
  {
    const unsigned int n        = law.n_components();
    const auto         row_of_S = [&](const unsigned int a) -> const double         *{
      return a == 0 && contact.has_stress() ? LA::RowView(contact.S_free, point).values : nullptr;
    };
    bool any = false;
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = 0; b < n; ++b)
        {
          const unsigned int   ab = a * n + b;
          const PointStiffness stiffness{of.D[ab][point],
                                         of.X[ab][point],
                                         contact.theta * of.Y[ab][point],
                                         contact.theta * of.Z[ab][point]};
          if (stiffness.is_zero())
            continue;
          any = true;
          stiffness.add_to(block,
                           LA::RowView(contact.free_rows(a), point).values,
                           row_of_S(a),
                           LA::RowView(contact.free_rows(b), point).values,
                           row_of_S(b));
        }
    return any;
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
          if (contact.has_stress() && a == 0)
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
      blocks.push_back(my_volumetric->compliance.locally_owned_elements());
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
    LA::Vector volume = src.block(m);
    volume.scale(my_volumetric->compliance);
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
    const unsigned int m     = volumetric_block();
    const double       theta = contact.theta;
    LA::Vector         gap = contact.zero(), stress = gap, of_volumetric = gap;
    contact.S_free.vmult(stress, src.block(0));
    contact.S_volumetric.vmult(of_volumetric, src.block(m));
    contact.S_free.Tvmult_add(dst.block(0), product(Y[0][0], of_volumetric, -theta));
    stress += of_volumetric;
    LA::Vector sum = product(Y[0][0], stress, -theta);
    for (unsigned int a = 0; a < law.n_components(); ++a)
      {
        contact.free_rows(a).Tvmult_add(dst.block(0), product(X[a][0], of_volumetric, -1));
        contact.free_rows(a).vmult(gap, src.block(0));
        sum += product(Z[0][a], gap, -theta);
      }
    contact.S_volumetric.Tvmult_add(dst.block(m), sum);
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
