// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_stiffness.h"
#include "solid/deformation_kernel.h"

#include <string>

namespace Signorini
{
  /// The tangent stiffness of bodies at finite strain, matrix-free. Products in double precision
  /// use the tangents of all integration points; the finest multigrid level uses their means over
  /// cells, as the coarser levels do, which have to be read only once for each cell.
  class TangentStiffness : public CellStiffness
  {
  public:
    /// The tangent is that of the undeformed bodies until it is linearised elsewhere. Keeps
    /// references to the elasticity and to the kernel. Collective.
    TangentStiffness(const Elasticity<3> &elasticity, DeformationKernel<3> &kernel);

    /// Evaluate the tangents of the integration points at u. Not collective.
    /// @param u with ghosts, satisfies the constraints
    /// @return the name of a body of which cells on this rank are inverted; then nothing has
    /// changed, and the caller informs the other ranks. Empty: there are none
    std::string
    evaluate(const LA::Vector &u);

    /// Linearise at the displacement of the last evaluate(). Collective.
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
    /// Cells and constraints; it has tangents only between evaluate() and update().
    CellSpace space;
    /// The displacement of the last evaluate().
    LA::Vector next;
    /// The displacement of the last update().
    LA::Vector   linearisation_point;
    CellTangents means;
  };
} // namespace Signorini
