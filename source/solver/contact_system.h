// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_law.h"
#include "linear_algebra/columns.h"
#include "solid/stiffness.h"
#include "solver/unconstrained_modes.h"
#include "solver/volumetric_equations.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <optional>
#include <vector>

namespace Signorini
{
  /// The linear system of one Newton step, for given statuses of the contact points, in two forms.
  /// Indices a, b are the components of a point, normal and tangential ones, see PointVectors; p is
  /// the traction, g the gap with the slip, all blocks are diagonal matrices of the points.
  ///
  /// Condensed (the traction follows from the gap): (K + sum_ab B_a^T D_ab B_b) du = r with
  /// D_ab = -dp_a/dg_b W, which is eps W on closed points without friction. With Nitsche's method
  /// also the stress S u of the points takes part:
  ///
  ///     K + [B; S]^T [ D          -X       ] [B; S],   X = dp/ds W,
  ///                  [ -theta Z   -theta Y ]           Y = (1 - dp/ds) W/eps,   Z = D/eps.
  ///
  /// Saddle point (the traction is unknown; doc/theory, 4.3):
  ///     [  K      -B^T A ] [du]   [  r   ]
  ///     [ -C B     -I    ] [q ] = [ k W d ],   dp = k q,
  /// with the residual d of the constraint, zero at open points, A = k W on closed points,
  /// C = k W dd/dg, I = k^2 W dd/dp there, and I = k W on open ones. Without friction C = A, and I
  /// on closed points is (k^2/eps) W where the law is g + p/eps = 0, else zero. The scaling with
  /// k = E/h makes q a length and both residuals forces: nothing depends on the units of the scene.
  ///
  /// Where surfaces move, K - G takes the place of K, see MovedContact.
  ///
  /// Bodies that are mixed have one more row and column in either form, those of the volumetric
  /// stress, see VolumetricCoupling; contact touches them with Nitsche's method alone, where S is
  /// [S T].
  ///
  /// Vectors are blocks (u, q), q with a block a component, and with mixed bodies (u, q, m); q is
  /// one empty block in the condensed form. K belongs to the bodies and is never touched; what
  /// changes with the statuses are vectors on the contact surface.
  class ContactSystem
  {
  public:
    /// A diagonal matrix over the points for each pair of components, [a][b].
    using Blocks = std::vector<PointVectors>;

    /// Keeps references to all arguments but the unconstrained modes.
    /// @param volumetric null: no body is in displacement-pressure form
    /// @param symmetric_bodies see SolidResidual::is_symmetric()
    ContactSystem(const Stiffness          &stiffness,
                  const ContactLaw         &law,
                  UnconstrainedModes        unconstrained_modes = UnconstrainedModes(),
                  const VolumetricCoupling *volumetric          = nullptr,
                  bool                      symmetric_bodies    = true);

    /// Linearise the law at these inputs, with these statuses.
    void
    linearise(const LawInputs &in, const LA::Vector &status);

    /// Set the statuses only; for laws whose derivatives do not depend on the inputs.
    void
    set_status(const LA::Vector &status);

    /// Make vmult() that of the transposed matrix, until called with false. No effect if
    /// is_symmetric().
    void
    transpose(const bool wanted)
    {
      transposed = wanted && !is_symmetric();
    }

    /// True if vmult() is that of the transposed matrix.
    bool
    is_transposed() const
    {
      return transposed;
    }

    /// dst = A src with the system matrix, or its transpose. Collective. @param src blocks as of
    /// zero()
    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const;

    /// Include the contact geometric stiffness (K - G), or not (K).
    void
    use_geometric_stiffness(const bool wanted)
    {
      uses_geometric = wanted;
    }

    /// True if the contact geometric stiffness G is part of the system matrix.
    bool
    uses_geometric_stiffness() const
    {
      return uses_geometric;
    }

    /// The change of the internal forces, (K - G) du, without the stabilisation of unconstrained
    /// modes that K contains.
    void
    internal_force(LA::Vector &dst, const LA::Vector &du) const;

    /// The rigid-body modes that no support constrains, with those unconstrained at the last
    /// statuses.
    const UnconstrainedModes &
    unconstrained_modes() const
    {
      return motions;
    }

    /// Determine the unconstrained modes for these statuses, without linearising.
    void
    find_unconstrained_modes(const LA::Vector &status, const PointVectors &traction = {})
    {
      motions.set_status(status, traction);
    }

    /// vmult() of the contact terms alone; the results of K and of the volumetric stress are zero.
    void
    contact_terms(LA::BlockVector &dst, const LA::BlockVector &src) const;

    /// A zero vector (u, q), or (u, q, m).
    LA::BlockVector
    zero() const;

    /// The number of blocks of the multipliers q, of which the first is block 1; 1 (empty) in the
    /// condensed form.
    unsigned int
    n_multiplier_blocks() const
    {
      return saddle ? law.n_components() : 1;
    }

    /// The index of the block of the volumetric stress, if there is one.
    unsigned int
    volumetric_block() const
    {
      return 1 + n_multiplier_blocks();
    }

    /// True for laws with multipliers.
    bool
    is_saddle_point() const
    {
      return saddle;
    }

    /// True if the system matrix is symmetric.
    bool
    is_symmetric() const
    {
      return symmetric_bodies && law.is_symmetric() &&
             (!contact.has_stress() || contact.theta == 1);
    }

    /// K, with the stabilisation of unconstrained rigid-body modes: what preconditioners are made
    /// of.
    const Stiffness &
    stiffness() const
    {
      return K;
    }

    /// Null: no body is mixed.
    const VolumetricCoupling *
    volumetric() const
    {
      return my_volumetric;
    }

    /// The gap operator of the contact law.
    const GapOperator &
    gap_operator() const
    {
      return contact;
    }

    /// The diagonal contact stiffness D_aa of each component a [force/length].
    PointVectors
    contact_stiffness() const;

    /// True if the point is closed; in the condensed form only if its stiffness is not zero.
    bool
    is_active_point(dealii::types::global_dof_index point) const;

    /// The contact stiffness of this rank's points in the condensed form, over the local columns of
    /// GapOperator::B_free. Empty in the saddle point form, and without points.
    const dealii::SparseMatrix<double> &
    surface_stiffness() const
    {
      return surface;
    }

    /// The blocks of the saddle point system, diagonal in the points (doc/theory, (4.5), (4.6)): A
    /// of each component.
    const LA::Vector &
    coupling() const
    {
      return A;
    }

    /// The blocks C, [residual component][component of the gap].
    const Blocks &
    constraint() const
    {
      return C;
    }

    /// The blocks I, [residual component][component of the traction].
    const Blocks &
    identity() const
    {
      return I;
    }

  private:
    /// The blocks at the points of this rank, [a * n_components + b].
    struct Sums
    {
      std::vector<std::vector<double>> D, X, Y, Z;
    };

    /// Set the blocks of one point.
    void
    linearise(dealii::types::global_dof_index point,
              const LawResponse              &response,
              ContactStatus                   status);
    /// Make the sparsity pattern of the surface stiffness from the columns of B_free.
    void
    make_surface_pattern();
    /// Assemble the surface stiffness. B and S have a row for each point, and often dozens of
    /// points lie between two faces: summing them up once for each active set costs less than
    /// applying them one by one in each iteration.
    void
    sum_up_surface_stiffness();
    /// dst += B^T D B src and the terms of the normal stress, by the surface stiffness. Collective.
    void
    add_surface_forces(LA::Vector &dst, const LA::Vector &src) const;
    /// Add the rows and columns of the multipliers. Collective.
    void
    add_multipliers(LA::BlockVector &dst, const LA::BlockVector &src) const;
    /// Add the rows and columns of the volumetric stress.
    void
    add_volumetric(LA::BlockVector &dst, const LA::BlockVector &src) const;
    /// Add the contribution of the volumetric stress T dm to the normal stress of Nitsche's method.
    void
    add_volumetric_at_contact(LA::BlockVector &dst, const LA::BlockVector &src) const;

    const Stiffness                &K;
    const ContactLaw               &law;
    const GapOperator              &contact;
    const VolumetricCoupling *const my_volumetric;
    const bool                      saddle, symmetric_bodies;
    bool                            transposed     = false;
    bool                            uses_geometric = true; ///< see use_geometric_stiffness()
    UnconstrainedModes              motions;
    Blocks                          D, X, Y, Z, C, I;
    LA::Vector                      A;
    mutable LA::Vector              workspace;
    mutable unsigned int            n_products = 0;

    Sums                              sums; ///< those in `surface`
    dealii::SparsityPattern           pattern;
    dealii::SparseMatrix<double>      surface;
    std::optional<LA::ColumnExchange> columns;             ///< of B_free, with points
    mutable dealii::Vector<double>    displacement, force; ///< there
  };
} // namespace Signorini
