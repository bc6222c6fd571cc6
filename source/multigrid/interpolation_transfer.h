// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/local_vectors.h"
#include "multigrid/prolongation.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The prolongation of linear interpolation in three dimensions, where each node is a vertex of a
  /// cell of the coarser level, or the middle of an edge, a face or the whole: the mean of one,
  /// two, four or eight vertices. That holds for the vertices of children and for the nodes of
  /// degree two. It is applied without a matrix, in single precision; constraints are condensed on
  /// vectors of the coarser level, and constrained degrees of freedom of the finer level get
  /// nothing.
  class InterpolationTransfer : public Prolongation
  {
  public:
    using Index = dealii::types::global_dof_index;

    /// Nodes with the vertices of which they are the means, all by their first degrees of freedom.
    class Nodes
    {
    public:
      /// @param n_vertices 1, 2, 4 or 8
      void
      add(Index node, const Index *vertices, unsigned int n_vertices);

    private:
      struct List
      {
        std::vector<std::uint32_t> nodes, vertices; ///< vertices of node k from n k on
      };

      std::array<List, 4> of; ///< those with 2^i vertices

      friend class InterpolationTransfer;
    };

    /// The degrees of freedom of a level, those of rigid bodies last, which are the same on both.
    struct Side
    {
      const dealii::IndexSet                  &owned;
      const dealii::AffineConstraints<double> &constraints;
    };

    /// Collective.
    /// @param nodes each owned node once
    /// @param n_rigid number of degrees of freedom of rigid bodies
    InterpolationTransfer(
      Nodes nodes, const Side &fine, const Side &coarse, unsigned int n_rigid, MPI_Comm);

    void
    vmult_add(float *fine, const float *coarse) const override;

    void
    Tvmult(float *coarse, const float *fine) const override;

    LA::SparseMatrix
    times(const LA::SparseMatrix &B) const override;

  private:
    /// Calls act(first local degree of freedom of a node, which of its components are free, places
    /// of its vertices, their number).
    template <typename Action>
    void
    for_each_node(const Action &act) const;

    using Row = std::vector<std::pair<Index, double>>;

    /// The rows of P of owned degrees of freedom. Not collective.
    std::unordered_map<Index, Row>
    rows(const std::vector<Index> &dofs) const;

    Nodes                                    nodes; ///< by local numbers, of both sides
    std::array<std::vector<std::uint8_t>, 4> free;  ///< a bit for each component of a node
    const dealii::IndexSet                   fine, coarse;
    LocalVectors<float>                      vertices;

    /// Degrees of freedom of rigid bodies: (local number on the finer level, local index on the
    /// coarser one).
    std::vector<std::pair<std::uint32_t, std::uint32_t>> rigid;
  };
} // namespace Signorini
