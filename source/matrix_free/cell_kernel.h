// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/kernel_tables.h"
#include "solid/cell_tangents.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /// The largest degree for which there is a kernel: from degree three on, deal.II does not number
  /// the components of a node consecutively.
  constexpr unsigned int largest_kernel_degree = 2;

  /// Hexahedra or tetrahedra of one degree with geometry and moduli. A hexahedron has (degree +
  /// 1)^3 nodes, in lexicographic order with x fastest, a tetrahedron 4 or 10: vertices, then
  /// middles of the edges 01, 12, 20, 03, 13, 23. They are also those of its geometry.
  struct KernelCells
  {
    unsigned int degree         = 1;
    bool         are_tetrahedra = false;
    /// [cell][node]: the position of the first component of the node in vectors.
    std::vector<std::uint32_t> nodes;
    /// [cell][node][component]: positions in the reference configuration [length].
    std::vector<double> points;
    /// [cell]: Lamé constants [force/area].
    std::vector<double> lambda, mu;

    /// Tangents in place of positions and moduli, in reference coordinates and with weights: one
    /// for each cell, integrated over it, or tangents_per_cell() of them: [cell][number].
    CellTangents tangents;

    /// The number of cells.
    unsigned int
    size() const
    {
      return nodes.size() / nodes_per_cell();
    }

    /// True if the cells have tangents in place of positions and moduli.
    bool
    has_tangents() const
    {
      return !tangents.empty();
    }

    /// The number of nodes of each cell.
    unsigned int
    nodes_per_cell() const
    {
      if (are_tetrahedra)
        return degree == 1 ? 4 : 10;
      return (degree + 1) * (degree + 1) * (degree + 1);
    }

    /// The number of tangents of each cell: of hexahedra those of the Gauss points, of tetrahedra
    /// the moments of SimplexTables.
    unsigned int
    tangents_per_cell() const
    {
      if (are_tetrahedra)
        return degree == 1 ? 1 : SimplexTables<double, 2>::n_moments;
      return nodes_per_cell();
    }

    /// The number of integration points of each cell: of hexahedra as many as nodes, of tetrahedra
    /// those of SimplexTables.
    unsigned int
    points_per_cell() const
    {
      if (are_tetrahedra)
        return degree == 1 ? SimplexTables<double, 1>::n_points :
                             SimplexTables<double, 2>::n_points;
      return nodes_per_cell();
    }
  };

  /// Products with the stiffness of cells without element matrices, of linear elasticity or of
  /// tangents: the integrals int sigma(u):eps(v) dV are evaluated for each u, for batches of as
  /// many cells as a vector of the processor has lanes. Hexahedra have degree + 1 Gauss points in
  /// each direction and sum factorisation (Orszag, J. Comput. Phys. 37 (1980) 70-92; Kronbichler,
  /// Kormann, ACM Trans. Math. Softw. 45 (2019) 29; doc/theory, 7.9); of tetrahedra the gradients
  /// are linear and follow from those at the vertices.
  ///
  /// Vectors are arrays of one rank, with the three components of a node consecutive. Constraints
  /// are not applied here.
  template <typename Number>
  class CellKernel
  {
  public:
    /// @param cells of degree largest_kernel_degree at most
    /// @param instruction_set one of instruction_sets(); empty: that of the environment's
    /// SIGNORINI_INSTRUCTION_SET, or the best one. Throws SceneError if there is no such
    /// set.
    static std::unique_ptr<CellKernel>
    create(const KernelCells &cells, const std::string &instruction_set = "");

    virtual ~CellKernel() = default;

    /// dst += K src. One element behind the last one of src may be read.
    virtual void
    add_product(Number *dst, const Number *src) const = 0;

    /// dst += diag(K)
    virtual void
    add_diagonal(Number *dst) const = 0;

    /// Raise the elements of dst to at least the largest eigenvalue of diag(K_e)^-1 K_e, up to a
    /// few per cent, of each cell e that they belong to. The largest of all is a bound of that of
    /// diag(K)^-1 K; it is large where cells are of bad shape.
    virtual void
    enlarge_by_eigenvalues(Number *dst) const = 0;

    /// Memory of this rank [bytes].
    virtual std::size_t
    memory_consumption() const = 0;
  };
} // namespace Signorini
