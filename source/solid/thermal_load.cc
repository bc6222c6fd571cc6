// SPDX-License-Identifier: Apache-2.0
#include "solid/scalar_elements.h"
#include "solid/thermal_strain.h"

namespace Signorini
{
  using namespace dealii;

  // The mapping of the cells, not that of the true surface: the forces must be those that stiffness
  // times free expansion has, so that a heated body without supports gets no stress.
  template <int dim>
  ThermalLoad<dim>::ThermalLoad(const Mesh<dim>             &mesh,
                                const hp::FECollection<dim> &elements,
                                const ThermalStrain<dim>    &thermal,
                                const Model                  model)
    : thermal(thermal)
    , model(model)
    , all_values(mesh.mappings(),
                 elements,
                 gauss_rules(elements, 1),
                 update_values | update_gradients | update_quadrature_points | update_JxW_values)
  {}



  // int (C : eps_T) : eps(v) dV with the quadrature of the stiffness, so that both cancel for free
  // expansion.
  template <int dim>
  bool
  ThermalLoad<dim>::add(const DofCell &cell, const Material &material, Vector<double> &cell_load)
  {
    if (!thermal.expands(cell->material_id()))
      return false;
    const Tensor<1, 3> stress = thermal.stress_of_unit_rise(material, cell->material_id());
    all_values.reinit(cell);
    const FEValues<dim> &values = all_values.get_present_fe_values();
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &x = values.quadrature_point(q);
        const double      weight =
          thermal.temperature_change(*cell, x) * values.JxW(q) * measure(model, x);
        for (const unsigned int i : values.dof_indices())
          {
            // The thermal stress of an isotropic body with expansion along the axes is diagonal, so
            // that component d works on the derivative in its own direction only.
            const unsigned int d = cell->get_fe().system_to_component_index(i).first;
            cell_load[i] += weight * stress[d] * values.shape_grad(i, q)[d];
            // The hoop component works on u_r/r.
            if (model == Model::axisymmetric && d == 0)
              cell_load[i] += weight * stress[2] * values.shape_value(i, q) / x[0];
          }
      }
    return true;
  }



  template class ThermalLoad<2>;
  template class ThermalLoad<3>;
} // namespace Signorini
