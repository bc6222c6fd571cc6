#pragma once

#include <signorini/contact/trace.h>

#include <set>
#include <vector>

namespace Signorini
{
  /// The functions psi_A, one a slave node, in which methods that sample at nodes expand the
  /// pressure, and with which they weight the gap.
  enum class Basis
  {
    standard, ///< the trace of the displacement's shape functions phi_A
    dual      ///< int psi_A phi_B dA = delta_AB int phi_B dA (Wohlmuth, SIAM J. Numer. Anal. 38
              ///< (2000) 989-1012)
  };

  /// The basis on one slave face, from the shape functions there. Both bases sum up to one.
  ///
  /// Duality holds on that part of the face that has a partner (Cichosz, Bischoff, Comput. Methods
  /// Appl. Mech. Engrg. 200 (2011) 1317-1332). Where that is so small a part that the functions
  /// would grow beyond bounds, the standard basis is taken.
  ///
  /// A node whose displacement along the normal is prescribed takes part in no pressure of its own:
  /// nothing would balance it, and the system would be singular. Its function goes to the other
  /// nodes of the face, as mortar methods do where Dirichlet boundaries begin.
  class PressureBasis
  {
  public:
    /// @param shapes of the nodes at the points of integration, hanging nodes as they are
    /// @param weights areas of the points
    /// @param prescribed nodes that cannot move along the normal
    PressureBasis(const std::vector<SparseRow>                    &shapes,
                  const std::vector<double>                       &weights,
                  Basis                                            basis,
                  const std::set<dealii::types::global_dof_index> &prescribed);

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
