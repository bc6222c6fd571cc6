// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

namespace Signorini
{
  /// The volume change of one cell of a body in displacement-pressure form, tested with the
  /// functions of VolumetricStress: int phi theta dV with the volumetric strain theta = tr eps
  /// without thermal strain (small strain) or ln J (finite strain), and its derivative by the
  /// displacement, int phi tr(Grad v F^-1) dV, with F = I at small strain.
  template <int dim>
  class VolumeKernel
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Keeps a reference to elasticity.
    explicit VolumeKernel(const Elasticity<dim> &elasticity);

    /// Evaluate one cell. Returns false, and leaves the results undefined, where the cell is
    /// inverted: J <= 0.
    /// @param u displacement at the degrees of freedom of the cell
    /// @param changes int phi theta dV for each function phi [force]
    /// @param slopes derivatives: one row for each function, one column for each degree of freedom;
    /// null: not needed
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
