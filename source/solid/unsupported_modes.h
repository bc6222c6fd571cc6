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
  /// Motions without deformation that no support holds, of elastic bodies piece by piece, and of
  /// rigid ones along their free components; and the springs that make K regular in spite of them.
  template <int dim>
  class UnsupportedModes
  {
  public:
    /// Keeps a reference.
    UnsupportedModes(const Displacements<dim> &displacements);

    /// To be called when degrees of freedom have been distributed anew. Collective.
    void
    find();

    bool
    any() const;

    /// "ball: translation z"
    std::vector<std::string>
    names() const;

    /// In the order of the names. They vanish at all constrained degrees of freedom.
    std::vector<UnconstrainedMode>
    motions() const;

    /// A diagonal: on the nodes of pieces with such motions, strength times E L/L^3 times their
    /// share of the volume, and on free components of rigid bodies strength times theirs. Zero at
    /// constrained degrees of freedom; empty if there are no motions.
    /// @param materials by their ids
    /// @param of_rigid_bodies what stands for the stiffness of rigid bodies
    LA::Vector
    stabilisation(const std::vector<Material> &materials,
                  double                       of_rigid_bodies,
                  double                       strength) const;

  private:
    /// A combination of the rigid-body modes of one connected piece of an elastic body.
    struct PieceMotion
    {
      unsigned int           piece;
      dealii::Vector<double> modes;
    };

    std::vector<dealii::FullMatrix<double>>
    gram_of_constrained_directions() const;
    void
    set_motions_of_pieces(std::vector<UnconstrainedMode> &result) const;

    const Displacements<dim> &displacements;
    std::vector<PieceMotion>  of_pieces;
  };
} // namespace Signorini
