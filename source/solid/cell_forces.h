// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/deformation_kernel.h"
#include "solid/elasticity.h"
#include "solid/kernel.h"
#include "solid/volume_kernel.h"

namespace Signorini
{
  /// The internal forces of single cells, int sigma : Grad N dV, of any material and formulation,
  /// with thermal strain and volumetric stress. Keeps a reference to its argument.
  template <int dim>
  class CellForces
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    explicit CellForces(const Elasticity<dim> &elasticity);

    /// @return the internal forces of a cell; valid until the next call.
    /// @param ghosted displacement with ghost values
    const dealii::Vector<double> &
    internal(const Cell &cell, const LA::Vector &ghosted);

    /// @return internal forces minus loads of a cell; valid until the next call.
    /// @param ghosted displacement with ghost values
    /// @param cell_load loads of the cell
    const dealii::Vector<double> &
    residual(const Cell &cell, const LA::Vector &ghosted, const dealii::Vector<double> &cell_load);

  private:
    /// Small strain: add B_m^T m, the forces of the volumetric stress (doc/theory, (6.20)).
    void
    add_volumetric_stress(const Cell &cell);

    const Elasticity<dim>     &elasticity;
    StiffnessKernel<dim>       kernel;
    DeformationKernel<dim>     of_deformation;
    ThermalLoad<dim>           thermal_load;
    VolumeKernel<dim>          of_volume;
    dealii::FullMatrix<double> matrix, slopes;
    dealii::Vector<double>     values, force, changes, of_temperature;
  };
} // namespace Signorini
