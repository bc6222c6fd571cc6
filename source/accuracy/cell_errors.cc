// SPDX-License-Identifier: Apache-2.0
#include "accuracy/error_parts.h"
#include "solid/stress.h"

namespace Signorini
{
  using namespace dealii;

  // The integrals of (8.6) with the stress deviations of the solution (field 0) and of each dual
  // solution (fields 1, 2, ...). Only the solution has thermal strain, since dual solutions are
  // changes of displacement.
  template <int dim>
  CellErrors
  cell_errors(const Elasticity<dim>         &elasticity,
              const LA::Vector              &displacement,
              const std::vector<LA::Vector> &duals)
  {
    std::vector<typename RecoveredStress<dim>::Field> fields = {{&displacement, true}};
    for (const LA::Vector &z : duals)
      fields.push_back({&z, false});
    RecoveredStress<dim> recovered(elasticity, fields);

    const auto        &triangulation = elasticity.mesh().triangulation();
    const unsigned int n             = triangulation.n_active_cells();
    CellErrors         result;
    result.energy.assign(n, 0.);
    result.products.assign(duals.size(), std::vector<double>(n, 0.));
    result.energies_of_duals.assign(duals.size(), 0.);
    double energy = 0;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const auto        &at       = recovered(cell);
          const Material    &material = elasticity.material(cell->material_id());
          const unsigned int i        = cell->active_cell_index();
          // Energy products of stresses: (s, t) = integral of s : C^-1 t, with the compliance C^-1
          // of the material.
          for (unsigned int q = 0; q < at.weights.size(); ++q)
            {
              const auto strain = compliance(material, at.deviation[0][q]);
              result.energy[i] += at.weights[q] * (at.deviation[0][q] * strain);
              for (unsigned int z = 0; z < duals.size(); ++z)
                {
                  const auto &of_dual = at.deviation[z + 1][q];
                  result.products[z][i] += at.weights[q] * (of_dual * strain);
                  result.energies_of_duals[z] +=
                    at.weights[q] * (of_dual * compliance(material, of_dual));
                }
              energy += at.weights[q] * (at.stress[0][q] * compliance(material, at.stress[0][q]));
            }
        }
    Utilities::MPI::sum(result.energies_of_duals,
                        triangulation.get_communicator(),
                        result.energies_of_duals);
    result.energy_of_solution = Utilities::MPI::sum(energy, triangulation.get_communicator());
    return result;
  }



  template CellErrors
  cell_errors(const Elasticity<2> &, const LA::Vector &, const std::vector<LA::Vector> &);
  template CellErrors
  cell_errors(const Elasticity<3> &, const LA::Vector &, const std::vector<LA::Vector> &);
} // namespace Signorini
