// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_stiffness.h"
#include "solid/deformation_kernel.h"

#include <string>

namespace Signorini
{
  /// The tangent of bodies that deform by any amount. Products in double precision have the
  /// tangents of all points of integration, the finest level of multigrid their means over cells:
  /// there they need be read once a cell, and coarser levels have no more either.
  class TangentStiffness : public CellStiffness
  {
  public:
    /// The tangent of the undeformed bodies, until it is linearised elsewhere. Keeps references to
    /// the elasticity, whose bodies all have a stored energy, and to the kernel. Collective.
    TangentStiffness(const Elasticity<3> &elasticity, DeformationKernel<3> &kernel);

    /// The tangents of the points at u. Returns the name of a body of which cells of this rank are
    /// folded there: then nothing has changed, and all ranks are to be told. Empty: none.
    /// @param u with ghosts, satisfies the constraints
    std::string
    evaluate(const LA::Vector &u);

    /// Linearise where it was evaluated. Collective.
    void
    update();

    const CellTangents *
    tangents() const override
    {
      return &means;
    }

  protected:
    void
    assemble(LA::SparseMatrix &K, const std::function<bool(const Cell &)> &takes) const override;

  private:
    DeformationKernel<3> &kernel;
    CellSpace             space;               ///< its tangents are there in between only
    LA::Vector            next;                ///< where it was evaluated
    LA::Vector            linearisation_point; ///< where it is linearised
    CellTangents          means;
  };
} // namespace Signorini
