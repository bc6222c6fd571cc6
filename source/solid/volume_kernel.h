// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

namespace Signorini
{
  /// The changes of volume of one cell of a mixed body, as VolumetricStress sees them: int phi
  /// theta dV with theta = tr eps without thermal strain (small deformation) or ln J (large), and
  /// how they change with the displacement, int phi tr(Grad v F^-1) dV with F = I if that is small.
  template <int dim>
  class VolumeKernel
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Refers to elasticity.
    explicit VolumeKernel(const Elasticity<dim> &elasticity);

    /// Returns false, and leaves nothing that means anything, where the cell is folded: J <= 0.
    /// @param u the displacement at the degrees of freedom of the cell
    /// @param changes one a function phi [force]
    /// @param slopes a row a function, a column a degree of freedom; null: not wanted
    bool
    assemble(const Cell                   &cell,
             const dealii::Vector<double> &u,
             dealii::Vector<double>       &changes,
             dealii::FullMatrix<double>   *slopes = nullptr);

  private:
    const Elasticity<dim>                       &elasticity;
    const dealii::hp::FECollection<dim>          elements; ///< scalar: the values refer to them
    dealii::hp::FEValues<dim>                    all_values;
    const std::vector<std::vector<unsigned int>> all_dofs; ///< see dofs_of_nodes()
  };
} // namespace Signorini
