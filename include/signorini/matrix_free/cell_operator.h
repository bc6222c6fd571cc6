#pragma once

#include <signorini/elasticity/stiffness.h>
#include <signorini/matrix_free/cell_space.h>
#include <signorini/matrix_free/local_vectors.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// K by kernels for the cells of a space, with hanging nodes condensed and prescribed
  /// displacements eliminated; on its diagonal also the space's terms, and the plain stiffness
  /// where a degree of freedom is constrained.
  template <typename Number>
  class CellOperator : public StiffnessOperator
  {
  public:
    /// The space is not needed any more afterwards.
    explicit CellOperator(const CellSpace &space);

    void
    vmult(LA::Vector &dst, const LA::Vector &src) const override;

    LA::Vector
    diagonal() const override
    {
      return my_diagonal;
    }

    /// From the eigenvalues of cells.
    LA::Vector
    row_sizes() const override;

    dealii::IndexSet
    owned() const override
    {
      return my_owned;
    }

    MPI_Comm
    communicator() const override
    {
      return my_diagonal.get_mpi_communicator();
    }

    std::size_t
    memory() const;

  private:
    void
    make_diagonal(const CellSpace &space);

    const dealii::IndexSet                           my_owned;
    LocalVectors<Number>                             vectors;
    std::vector<std::unique_ptr<CellKernel<Number>>> kernels; ///< one a degree
    LA::Vector                                       my_diagonal, terms;
  };
} // namespace Signorini
