// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/trace.h"
#include <signorini/contact/methods/integration.h>

#include <array>
#include <vector>

namespace Signorini
{
  /// A node of a slave face.
  struct FaceNode
  {
    dealii::types::global_dof_index index;      ///< first degree of freedom
    std::array<double, 2>           xi;         ///< parameters on the face; 2D: the first alone
    bool                            prescribed; ///< it cannot move along the normal
    double                          share; ///< of the area of a whole face that its function has
  };

  /// The basis on one slave face, from the shape functions there. Both bases sum up to one.
  ///
  /// Duality holds on that part of the face that has a projection (Cichosz, Bischoff, Comput.
  /// Methods Appl. Mech. Engrg. 200 (2011) 1317-1332). A node that has less than a quarter of its
  /// area there has no pressure of its own: the force that holds it where the master would go on,
  /// over so small an area, is no pressure of that place (Popp, Wohlmuth, Gee, Wall, SIAM J. Sci.
  /// Comput. 34 (2012) B421-B446, have the same trouble). The nearest node with more of its area
  /// takes its function over, so that the functions sum up to one also there; and so it is where
  /// functions hardly differ on the covered part, until the pressure of the face is constant.
  ///
  /// A node whose displacement along the normal is prescribed has no pressure of its own: nothing
  /// would balance it, and the system may be singular. It takes the pressure of the nearest other
  /// node of the face, as in mortar methods where Dirichlet boundaries begin (Wohlmuth, Lect. Notes
  /// Comput. Sci. Eng. 17 (2001), sec. 1.2); extrapolation of higher order would have weights that
  /// change their sign, which makes open gaps look closed. The error is one of L2 norm h^(3/2).
  class PressureBasis
  {
  public:
    /// @param shapes at the points of integration, hanging nodes as they are
    /// @param weights areas of the points
    /// @param area of the whole face
    PressureBasis(const std::vector<FaceNode>  &nodes,
                  const std::vector<SparseRow> &shapes,
                  const std::vector<double>    &weights,
                  double                        area,
                  Basis                         basis);

    /// The node has a function of its own.
    bool
    has(dealii::types::global_dof_index node) const;

    /// psi at a point where phi is `shape`.
    SparseRow
    at(const SparseRow &shape) const;

    /// True if all nodes are prescribed: the face carries no pressure.
    bool
    empty() const
    {
      return functions.empty();
    }

  private:
    /// Each basis function as a combination of shape functions.
    std::vector<std::pair<dealii::types::global_dof_index, SparseRow>> functions;
  };
} // namespace Signorini
