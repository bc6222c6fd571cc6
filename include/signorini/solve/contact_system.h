#pragma once

#include <signorini/contact/method.h>
#include <signorini/linear_algebra.h>

namespace Signorini
{
  /// The linear system of one Newton step, for a given active set, in two forms.
  ///
  /// Condensed (the pressure follows from the gap): (K + B^T D B) du = r, D = eps W on the active
  /// points.
  ///
  /// Saddle point (the pressure is unknown), thesis (49):
  ///     [  K      -B^T A ] [du]   [ r   ]
  ///     [ -A B     -I    ] [q ] = [ A g ],   dp = k q,
  /// A = k W on active points, I = k W on inactive ones and c k W on active ones, where the law is
  /// g + c p / k = 0 (c = 0 but for perturbed multipliers, and its right-hand side as well). The
  /// scaling with k = E/h makes q a length and both residuals forces: nothing depends on the units
  /// of the scene.
  ///
  /// Vectors are blocks (u, q); q is empty in the condensed form. K belongs to the mesh and is
  /// never touched; what changes with the active set are three vectors on the contact surface.
  class ContactSystem
  {
  public:
    ContactSystem(const LA::SparseMatrix &stiffness,
                  const GapOperator      &contact,
                  const ContactMethod    &method);

    void
    set_active(const LA::Vector &active);

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const;

    /// The same without K.
    void
    contact_terms(LA::BlockVector &dst, const LA::BlockVector &src) const;

    /// A zero vector (u, q).
    LA::BlockVector
    zero() const;

    bool
    is_saddle_point() const
    {
      return saddle;
    }

    const LA::SparseMatrix &
    stiffness() const
    {
      return K;
    }

    const GapOperator &
    gap_operator() const
    {
      return contact;
    }

    const LA::Vector &
    spring() const ///< D
    {
      return D;
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
    const LA::SparseMatrix &K;
    const GapOperator      &contact;
    const bool              saddle;
    const double            factor, compliance;
    LA::Vector              D, A, I;
    mutable LA::Vector      workspace;
  };
} // namespace Signorini
