// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/displacements.h"
#include "solid/unconstrained_mode.h"
#include <signorini/materials/material.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// The rigid-body modes that no support constrains (doc/theory, 4.10): those of each connected
  /// piece of an elastic body, and those of rigid bodies along their free components; and the
  /// stabilisation that makes K regular.
  template <int dim>
  class UnsupportedModes
  {
  public:
    /// Keeps a reference to the displacements.
    UnsupportedModes(const Displacements<dim> &displacements);

    /// Find the modes, after degrees of freedom have been distributed. Collective.
    void
    find();

    /// True if there are any. Valid after find().
    bool
    any() const;

    /// The names of the modes, as in "ball: translation z".
    std::vector<std::string>
    names() const;

    /// The modes in the order of the names. They vanish at all constrained degrees of freedom.
    std::vector<UnconstrainedMode>
    motions() const;

    /// The stabilising stiffness, a diagonal: on the nodes of pieces with such modes, strength
    /// times E L/L^3 times their share of the volume; on free components of rigid bodies, strength
    /// times `of_rigid_bodies`. Zero at constrained degrees of freedom; empty if there are no
    /// modes.
    /// @param materials by their ids
    /// @param of_rigid_bodies stiffness to which that of rigid bodies is related [force/length]
    /// @param strength dimensionless, see Elasticity::default_stabilisation
    LA::Vector
    stabilisation(const std::vector<Material> &materials,
                  double                       of_rigid_bodies,
                  double                       strength) const;

  private:
    /// A combination of the rigid-body modes of one connected piece of an elastic body.
    struct PieceMotion
    {
      unsigned int piece;
      /// Coefficients of RigidBodyModes, of Euclidean norm one.
      dealii::Vector<double> modes;
    };

    /// The Gram matrices of the constrained directions, one for each piece. Collective.
    std::vector<dealii::FullMatrix<double>>
    gram_of_constrained_directions() const;
    void
    add_equations(std::vector<dealii::FullMatrix<double>> &gram) const;
    /// Set the motions of the pieces in the first entries of a list.
    void
    set_motions_of_pieces(std::vector<UnconstrainedMode> &result) const;

    const Displacements<dim> &displacements;
    std::vector<PieceMotion>  of_pieces;
  };
} // namespace Signorini
