// SPDX-License-Identifier: Apache-2.0
#include "multigrid/interpolation_transfer.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/entries.h"
#include "linear_algebra/row_view.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_components = 3;
  } // namespace



  // Nodes are sorted by their number of vertices, a power of two, so that loops have a fixed inner
  // length.
  void
  InterpolationTransfer::Nodes::add(const Index        node,
                                    const Index *const vertices,
                                    const unsigned int n_vertices)
  {
    Assert(n_vertices == 1 || n_vertices == 2 || n_vertices == 4 || n_vertices == 8,
           ExcInternalError());
    List &list = of[n_vertices == 1 ? 0 : n_vertices == 2 ? 1 : n_vertices == 4 ? 2 : 3];
    list.nodes.push_back(node);
    list.vertices.insert(list.vertices.end(), vertices, vertices + n_vertices);
  }



  // Local data of the transfer: nodes and vertices by local indices, and the exchange of vertices
  // that other ranks own. Collective.
  InterpolationTransfer::InterpolationTransfer(Nodes              of_nodes,
                                               const Side        &above,
                                               const Side        &below,
                                               const unsigned int n_rigid,
                                               const MPI_Comm     comm)
    : nodes(std::move(of_nodes))
    , fine(above.owned)
    , coarse(below.owned)
    , vertices(below.owned,
               {&nodes.of[0].vertices,
                &nodes.of[1].vertices,
                &nodes.of[2].vertices,
                &nodes.of[3].vertices},
               below.constraints,
               comm)
  {
    // Renumber nodes and vertices to local arrays, and mark the components of nodes that are free
    // on the finer level.
    for (unsigned int i = 0; i < nodes.of.size(); ++i)
      {
        for (std::uint32_t &vertex : nodes.of[i].vertices)
          vertex = vertices.local_index(vertex);
        for (std::uint32_t &node : nodes.of[i].nodes)
          {
            // Bit c is set if component c of the node is free. Constrained components are not
            // interpolated to, and contribute nothing to the restriction, so that both remain
            // transposes of each other.
            std::uint8_t bits = 0;
            for (unsigned int c = 0; c < n_components; ++c)
              if (!above.constraints.is_constrained(node + c))
                bits |= 1 << c;
            free[i].push_back(bits);
            node = fine.index_within_set(node);
          }
      }
    // Degrees of freedom of rigid bodies are the same on both levels.
    for (Index i = 0; i < n_rigid; ++i)
      if (const Index dof = fine.size() - n_rigid + i;
          fine.is_element(dof) && !above.constraints.is_constrained(dof))
        rigid.emplace_back(fine.index_within_set(dof),
                           vertices.local_index(coarse.size() - n_rigid + i));
  }



  /// Call act(node, free components, vertices, number of vertices) for all nodes of this rank.
  template <typename Action>
  void
  InterpolationTransfer::for_each_node(const Action &act) const
  {
    for (unsigned int i = 0; i < nodes.of.size(); ++i)
      {
        // List i has the nodes that are means of 2^i vertices.
        const unsigned int n = 1 << i;
        for (std::size_t k = 0; k < nodes.of[i].nodes.size(); ++k)
          act(nodes.of[i].nodes[k], free[i][k], &nodes.of[i].vertices[n * k], n);
      }
  }



  // Prolongation u_fine += P C u_coarse: means of vertices, zero at constrained degrees of freedom
  // of the finer level.
  void
  InterpolationTransfer::vmult_add(float *of_fine, const float *of_coarse) const
  {
    // Constrained vertices of the coarser level get their values first; afterwards the
    // interpolation treats all vertices alike.
    const float *const u = vertices.resolve(of_coarse);
    for_each_node(
      [=](const auto node, const auto is_free, const std::uint32_t *of, const unsigned int n) {
        float sum[n_components] = {};
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int c = 0; c < n_components; ++c)
            sum[c] += u[of[j] + c];
        for (unsigned int c = 0; c < n_components; ++c)
          if (is_free >> c & 1)
            of_fine[node + c] += sum[c] / n;
      });
    for (const auto &[i, local_index] : rigid)
      of_fine[i] += u[local_index];
  }



  // Restriction u_coarse = C^T P^T f_fine, the exact transpose.
  void
  InterpolationTransfer::Tvmult(float *of_coarse, const float *of_fine) const
  {
    float *const f = vertices.zero();
    for_each_node(
      [=](const auto node, const auto is_free, const std::uint32_t *of, const unsigned int n) {
        // A node gives each of its n vertices the n-th part of its force.
        float share[n_components];
        for (unsigned int c = 0; c < n_components; ++c)
          share[c] = is_free >> c & 1 ? of_fine[node + c] / n : 0.f;
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int c = 0; c < n_components; ++c)
            f[of[j] + c] += share[c];
      });
    for (const auto &[i, local_index] : rigid)
      f[local_index] += of_fine[i];
    std::copy_n(vertices.condense(), coarse.n_elements(), of_coarse);
  }



  // The rows of P of owned degrees of freedom, constraints of the coarser level condensed.
  std::unordered_map<InterpolationTransfer::Index, InterpolationTransfer::Row>
  InterpolationTransfer::rows(const std::vector<Index> &dofs) const
  {
    // One pass over all nodes selects the rows that are asked for, since no map from degrees of
    // freedom to nodes is stored.
    std::vector<bool> is_asked(fine.n_elements(), false);
    for (const Index dof : dofs)
      is_asked[fine.index_within_set(dof)] = true;
    std::unordered_map<Index, Row> result;
    for_each_node(
      [&](const auto node, const auto is_free, const std::uint32_t *of, const unsigned int n) {
        for (unsigned int c = 0; c < n_components; ++c)
          if (is_asked[node + c] && is_free >> c & 1)
            for (unsigned int j = 0; j < n; ++j)
              vertices.for_each_element(of[j] + c, [&](const Index dof, const double weight) {
                result[fine.nth_index_in_set(node + c)].emplace_back(dof, weight / n);
              });
      });
    for (const auto &[i, local_index] : rigid)
      if (is_asked[i])
        result[fine.nth_index_in_set(i)].emplace_back(vertices.dof(local_index), 1.);
    return result;
  }



  // The product B P for the contact rows of the next level (doc/theory, (7.4)). Collective.
  LA::SparseMatrix
  InterpolationTransfer::times(const LA::SparseMatrix &B) const
  {
    // The rows of P that belong to columns of B: those of this rank are computed, those of other
    // ranks are requested from their owners. Two exchanges between neighbours.
    const MPI_Comm           comm    = B.get_mpi_communicator();
    const std::vector<Index> columns = LA::global_columns(B);
    std::vector<Index>       own, others;
    for (const Index column : columns)
      (fine.is_element(column) ? own : others).push_back(column);
    std::sort(others.begin(), others.end());
    IndexSet of_others(fine.size());
    of_others.add_indices(others.begin(), others.end());
    const std::vector<unsigned int> owners =
      Utilities::MPI::compute_index_owner(fine, of_others, comm);
    std::map<unsigned int, std::vector<Index>> questions;
    for (unsigned int i = 0; i < others.size(); ++i)
      questions[owners[i]].push_back(others[i]);
    const auto asked = Utilities::MPI::some_to_some(comm, questions);
    for (const auto &[rank, dofs] : asked)
      own.insert(own.end(), dofs.begin(), dofs.end());
    std::unordered_map<Index, Row>           P = rows(own);
    std::map<unsigned int, std::vector<Row>> answers;
    for (const auto &[rank, dofs] : asked)
      for (const Index dof : dofs)
        answers[rank].push_back(P[dof]);
    for (const auto &[rank, list] : Utilities::MPI::some_to_some(comm, answers))
      for (unsigned int i = 0; i < list.size(); ++i)
        P[questions[rank][i]] = list[i];

    // B P row by row, as sums over the entries of B.
    std::vector<Row> result(B.local_size());
    for (unsigned int i = 0; i < result.size(); ++i)
      {
        const LA::RowView row(B, i);
        // Several columns of B may depend on the same vertex; a map adds up their contributions and
        // sorts them. Columns without a row of P are constrained.
        std::map<Index, double> sums;
        for (int k = 0; k < row.size; ++k)
          if (const auto below = P.find(columns[row.columns[k]]); below != P.end())
            for (const auto &[dof, weight] : below->second)
              sums[dof] += row.values[k] * weight;
        result[i].assign(sums.begin(), sums.end());
      }
    return LA::matrix_of(result, B.locally_owned_range_indices(), coarse, comm);
  }
} // namespace Signorini
