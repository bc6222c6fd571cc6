#pragma once

#include <signorini/contact/law/contact_law.h>
#include <signorini/elasticity/stiffness.h>
#include <signorini/linear_algebra/columns.h>
#include <signorini/solve/bulk_equations.h>
#include <signorini/solve/free_motions.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <optional>
#include <vector>

namespace Signorini
{
  /// The linear system of one Newton step, for a given active set, in two forms.
  ///
  /// Condensed (the pressure follows from the gap): (K + B^T D B) du = r, D = -dp/dg W, which is
  /// eps W on the active points. With Nitsche's method also the normal stress S u of the points
  /// takes part:
  ///
  ///     K + [B; S]^T [ D   -X             ] [B; S],   X = W on active points,
  ///                  [ -theta X  -theta Y ]           Y = W/eps on inactive ones.
  ///
  /// Saddle point (the pressure is unknown), thesis (49):
  ///     [  K      -B^T A ] [du]   [ r   ]
  ///     [ -A B     -I    ] [q ] = [ A g ],   dp = k q,
  /// A = k W on active points, I = k W on inactive ones and (k^2/eps) W on active ones where the
  /// law is g + p/eps = 0 (else zero, and the right-hand side as well). The scaling with k = E/h
  /// makes q a length and both residuals forces: nothing depends on the units of the scene.
  ///
  /// Points of laws with several components have as many rows of B and S, one after the other, and
  /// blocks in D, X, Y instead of numbers. Where surfaces move, K - G takes the place of K, see
  /// MovedContact.
  ///
  /// Bodies that are mixed have a third row and column in either form, those of the bulk stress,
  /// see BulkCoupling; contact touches them with Nitsche's method alone, where S is [S T].
  ///
  /// Vectors are blocks (u, q), and with mixed bodies (u, q, m); q is empty in the condensed form.
  /// K belongs to the bodies and is never touched; what changes with the active set are vectors on
  /// the contact surface.
  class ContactSystem
  {
  public:
    /// Refers to all but the free motions, which must live as long.
    /// @param bulk null: no body is mixed
    /// @param symmetric_bodies see Bodies::is_symmetric()
    ContactSystem(const Stiffness    &stiffness,
                  const ContactLaw   &law,
                  FreeMotions         free_motions     = FreeMotions(),
                  const BulkCoupling *bulk             = nullptr,
                  bool                symmetric_bodies = true);

    /// Linearise the law, whose derivatives are constant where it is active.
    void
    set_active(const LA::Vector &active);

    /// vmult() is that of the transposed matrix from then on, until this is taken back: another one
    /// if is_symmetric() says no.
    void
    transpose(const bool wanted)
    {
      transposed = wanted && !is_symmetric();
    }

    bool
    is_transposed() const
    {
      return transposed;
    }

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const;

    /// False: K takes the place of K - G, until this is taken back.
    void
    turn_forces(const bool wanted)
    {
      turns = wanted;
    }

    bool
    turns_forces() const
    {
      return turns;
    }

    /// How the forces that are not the law's change: (K - G) du without the springs that K has
    /// against free motions.
    void
    internal_force(LA::Vector &dst, const LA::Vector &du) const;

    const FreeMotions &
    free_motions() const
    {
      return motions;
    }

    /// Find the loose ones of a set, without the system for it.
    void
    find_loose_motions(const LA::Vector &active)
    {
      motions.set_active(active);
    }

    /// The same without K and the bulk stress, which get zero.
    void
    contact_terms(LA::BlockVector &dst, const LA::BlockVector &src) const;

    /// A zero vector (u, q), or (u, q, m).
    LA::BlockVector
    zero() const;

    bool
    is_saddle_point() const
    {
      return saddle;
    }

    bool
    is_symmetric() const
    {
      return symmetric_bodies && (!contact.has_stress() || contact.theta == 1);
    }

    /// K, with springs against free motions: that is what preconditioners are built of.
    const Stiffness &
    stiffness() const
    {
      return K;
    }

    /// Null: no body is mixed.
    const BulkCoupling *
    bulk() const
    {
      return my_bulk;
    }

    const GapOperator &
    gap_operator() const
    {
      return contact;
    }

    /// The diagonal of D.
    const LA::Vector &
    spring() const
    {
      return D_diagonal;
    }

    /// What the points of this rank add to K in the condensed form: a matrix on the local columns
    /// of GapOperator::B_free. Empty in the saddle point form, and without points.
    const dealii::SparseMatrix<double> &
    surface_stiffness() const
    {
      return surface;
    }

    const LA::Vector &
    coupling() const ///< A
    {
      return A;
    }

    const LA::Vector &
    identity() const ///< I
    {
      return I;
    }

  private:
    /// D, X, Y at the rows of this rank.
    struct Sums
    {
      std::vector<std::vector<double>> D, X, Y;
    };

    /// Row i, component a of a point with that response.
    void
    linearise(dealii::types::global_dof_index i,
              unsigned int                    a,
              const LawResponse              &response,
              bool                            touches);
    void
    make_surface_pattern();
    /// B and S have a row a point, and often dozens of points between two faces: summing them up
    /// once an active set costs less than to apply them one by one in each iteration.
    void
    sum_up_surface_stiffness();
    /// Returns false if there was nothing to add.
    bool
    add_row(dealii::FullMatrix<double> &block, int row, const Sums &of) const;
    void
    add_surface_forces(LA::Vector &dst, const LA::Vector &src) const;
    /// What the rows and columns of the bulk stress are.
    void
    add_bulk(LA::BlockVector &dst, const LA::BlockVector &src) const;
    /// With Nitsche's method normal stresses have T dm beside S du.
    void
    add_bulk_at_contact(LA::BlockVector &dst, const LA::BlockVector &src) const;

    /// A block a point: column b in vector b.
    using Blocks = std::vector<LA::Vector>;

    const Stiffness          &K;
    const ContactLaw         &law;
    const GapOperator        &contact;
    const BulkCoupling *const my_bulk;
    const bool                saddle, symmetric_bodies;
    bool                      transposed = false;
    bool                      turns      = true; ///< see turn_forces()
    FreeMotions               motions;
    Blocks                    D, X, Y;
    LA::Vector                D_diagonal, A, I;
    mutable LA::Vector        workspace;
    mutable unsigned int      n_products = 0;

    Sums                              sums; ///< those in `surface`
    dealii::SparsityPattern           pattern;
    dealii::SparseMatrix<double>      surface;
    std::optional<LA::ColumnExchange> columns;             ///< of B_free, with points
    mutable dealii::Vector<double>    displacement, force; ///< there
  };
} // namespace Signorini
