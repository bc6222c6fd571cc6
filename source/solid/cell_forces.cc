// SPDX-License-Identifier: Apache-2.0
#include "solid/cell_forces.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  CellForces<dim>::CellForces(const Elasticity<dim> &e)
    : elasticity(e)
    , kernel(e.mesh(), e.finite_elements(), e.model())
    , of_deformation(e.mesh(),
                     e.finite_elements(),
                     e.model(),
                     &e.volumetric_stress(),
                     &e.material_history(),
                     &e.thermal())
    , thermal_load(e.mesh(), e.finite_elements(), e.thermal(), e.model())
    , of_volume(e)
  {}



  // Nonlinear bodies have forces from their law, which includes thermal strain and volumetric
  // stress; linear ones the product of the cell matrix with the displacement.
  template <int dim>
  const Vector<double> &
  CellForces<dim>::internal(const Cell &cell, const LA::Vector &ghosted)
  {
    const Material &material = elasticity.material(cell->material_id());
    values.reinit(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_values(ghosted, values);
    if (elasticity.is_nonlinear())
      of_deformation.assemble(cell, material, values, force);
    else
      {
        kernel.assemble(cell, material, matrix);
        force.reinit(matrix.m());
        matrix.vmult(force, values);
        add_volumetric_stress(cell);
      }
    of_temperature.reinit(values.size());
    if (!material.constitutive_law && thermal_load.add(cell, material, of_temperature))
      force -= of_temperature;
    return force;
  }



  template <int dim>
  const Vector<double> &
  CellForces<dim>::residual(const Cell           &cell,
                            const LA::Vector     &ghosted,
                            const Vector<double> &cell_load)
  {
    internal(cell, ghosted);
    force -= cell_load;
    return force;
  }



  // Only the derivative is used here: row k is the integral of function k times the divergence of
  // each shape function.
  template <int dim>
  void
  CellForces<dim>::add_volumetric_stress(const Cell &cell)
  {
    if (!elasticity.volumetric_stress().is_on(*cell))
      return;
    of_volume.assemble(cell, values, changes, &slopes);
    const auto &m = elasticity.volumetric_stress().coefficients(*cell);
    for (unsigned int k = 0; k < m.size(); ++k)
      for (unsigned int i = 0; i < force.size(); ++i)
        force(i) += m[k] * slopes(k, i);
  }



  template class CellForces<2>;
  template class CellForces<3>;
} // namespace Signorini
