// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/trace.h"
#include <signorini/contact/methods/integration.h>

#include <array>
#include <vector>

namespace Signorini
{
  /// A node of a slave face, as the multiplier basis needs it.
  struct FaceNode
  {
    dealii::types::global_dof_index index;      ///< first degree of freedom
    std::array<double, 2>           xi;         ///< isotropic_coordinates(); 2D: the first alone
    bool                            prescribed; ///< its displacement along the normal is prescribed
    /// Share of the area of the whole face that the integral of its function has; zero: it has no
    /// pressure of its own, and its function is added to those of the nearest nodes that have.
    double share;
  };

  /// The multiplier basis psi on one slave face (doc/theory, 3.4), either the shape functions
  /// themselves or their dual functions, int psi_A phi_B dA = delta_AB int phi_B dA. Both bases sum
  /// up to one.
  ///
  /// Duality holds on the part of the face that has a projection (Cichosz, Bischoff, Comput.
  /// Methods Appl. Mech. Engrg. 200 (2011) 1317-1332). A node with less than a quarter of its area
  /// there has no multiplier of its own: a force over so small an area would not be a meaningful
  /// pressure (Popp, Wohlmuth, Gee, Wall, SIAM J. Sci. Comput. 34 (2012) B421-B446, discuss the
  /// same problem). Its function is added to that of the nearest node with more area, so that the
  /// functions still sum up to one. The same is done where functions are nearly linearly dependent
  /// on the covered part, until the pressure on the face is constant.
  ///
  /// A node whose normal displacement is prescribed has no multiplier either, since no displacement
  /// could balance it and the system might be singular. It takes the pressure of the nearest other
  /// node of the face, as in mortar methods at the boundary of Dirichlet conditions (Wohlmuth,
  /// Lect. Notes Comput. Sci. Eng. 17 (2001), sec. 1.2). Extrapolation of higher order would have
  /// weights of both signs, by which open gaps could look closed. The error is of order h^(3/2) in
  /// the L2 norm.
  class PressureBasis
  {
  public:
    /// Construct the basis (doc/theory, (3.8) to (3.10)).
    /// @param shapes displacement shape functions at the integration points, hanging nodes not
    /// condensed
    /// @param weights areas of the points
    /// @param area of the whole face
    PressureBasis(const std::vector<FaceNode>  &nodes,
                  const std::vector<SparseRow> &shapes,
                  const std::vector<double>    &weights,
                  double                        area,
                  Basis                         basis);

    /// True if the node has a multiplier of its own on this face.
    bool
    has(dealii::types::global_dof_index node) const;

    /// The multiplier shape functions at a point. @param shape the displacement shape functions
    /// there
    SparseRow
    at(const SparseRow &shape) const;

    /// True if all nodes are prescribed: the face carries no pressure.
    bool
    empty() const
    {
      return functions.empty();
    }

  private:
    /// (node, coefficients of the displacement shape functions) of each basis function.
    std::vector<std::pair<dealii::types::global_dof_index, SparseRow>> functions;
  };
} // namespace Signorini
