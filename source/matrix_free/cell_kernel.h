// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/cell_tangents.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /// The largest degree that there is a kernel for: from three on, deal.II does not number the
  /// components of a node one after the other.
  constexpr unsigned int largest_kernel_degree = 2;

  /// Hexahedra of one degree, and what they are made of. A cell has (degree + 1)^3 nodes, in
  /// lexicographic order, x fastest, which are those of its geometry, too.
  struct KernelCells
  {
    unsigned int               degree = 1;
    std::vector<std::uint32_t> nodes;  ///< [cell][node]: place of its first component in vectors
    std::vector<double>        points; ///< [cell][node][component]: places in space
    std::vector<double>        lambda, mu; ///< [cell]

    /// Instead of places and moduli: [cell][point], one for all of a cell or those of its points of
    /// integration with their weights.
    CellTangents tangents;

    unsigned int
    size() const
    {
      return nodes.size() / nodes_per_cell();
    }

    bool
    has_tangents() const
    {
      return !tangents.empty();
    }

    unsigned int
    nodes_per_cell() const
    {
      return (degree + 1) * (degree + 1) * (degree + 1);
    }
  };

  /// Linear elasticity of hexahedra without their matrices, that of materials or of tangents: the
  /// integrals int sigma(u):eps(v) dV are evaluated anew for each u, by sum factorisation (Orszag,
  /// J. Comput. Phys. 37 (1980) 70-92; Kronbichler, Kormann, ACM Trans. Math. Softw. 45 (2019) 29),
  /// for as many cells at a time as the processor's vectors have places (batches), by Gauss' rule
  /// with degree + 1 points a direction.
  ///
  /// Vectors here are those of one rank, with the three components of a node one after the other,
  /// and know nothing of constraints.
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

    /// Elements of dst become at least the largest eigenvalue of diag(K_e)^-1 K_e, up to some
    /// per cent, of each cell e that they belong to. The largest of all bounds that of
    /// diag(K)^-1 K; it is large where cells are of bad shape.
    virtual void
    enlarge_by_eigenvalues(Number *dst) const = 0;

    /// Bytes.
    virtual std::size_t
    memory_consumption() const = 0;
  };
} // namespace Signorini
