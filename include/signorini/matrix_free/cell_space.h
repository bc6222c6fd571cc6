#pragma once

#include <signorini/elasticity/elasticity.h>
#include <signorini/matrix_free/cell_kernel.h>

#include <functional>
#include <vector>

namespace Signorini
{
  /// A space of displacements in three dimensions as kernels see it: cells, degrees of freedom and
  /// constraints, of the finest mesh or of a coarser one.
  struct CellSpace
  {
    dealii::IndexSet                  owned; ///< degrees of freedom, those of rigid bodies last
    std::vector<KernelCells>          cells; ///< of this rank, one a degree; nodes by global index
    dealii::AffineConstraints<double> constraints; ///< of all that these cells touch
    LA::Vector diagonal_terms; ///< what K has on its diagonal beyond the stiffness of cells
    MPI_Comm   comm;
  };

  /// That of the bodies on the present mesh.
  CellSpace
  cell_space(const Elasticity<3> &elasticity);

  /// What the diagonal of C^T K C has beyond that of K because degrees of freedom hang on others
  /// (hanging nodes, inclined supports): with the weights c_rj of constraint r,
  ///   sum over cells of sum_rs c_rj c_sj K_rs - K_jj.
  /// @param add takes degree of freedom j, which may be another rank's, and a summand
  void
  add_tied_diagonal(const CellSpace                                                    &space,
                    const std::function<void(dealii::types::global_dof_index, double)> &add);

  /// K assembled. Collective.
  void
  assemble(const CellSpace &space, LA::SparseMatrix &K);
} // namespace Signorini
