// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include "solid/nodal_forces.h"
#include "solid/surface_loads.h"
#include <signorini/solid/boundary_conditions.h>
#include <signorini/solid/model.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>

namespace Signorini
{
  /// Stiffness matrix of one cell (doc/theory, 1.1).
  template <int dim>
  class StiffnessKernel
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// @param elements that cells have, by their index
    StiffnessKernel(const Mesh<dim>                     &mesh,
                    const dealii::hp::FECollection<dim> &elements,
                    Model                                model);

    /// Compute the stiffness matrix of a cell; cell_matrix is resized to its number of degrees of
    /// freedom.
    void
    assemble(const Cell &cell, const Material &material, dealii::FullMatrix<double> &cell_matrix);

  private:
    /// Add the part of the hoop strain u_r/r of axisymmetric models.
    void
    add_hoop(const std::vector<unsigned int> &dof,
             double                           lambda,
             double                           mu,
             dealii::FullMatrix<double>      &cell_matrix);

    const Model model;
    // The gradients of the scalar element serve all components; the values refer to it.
    const dealii::hp::FECollection<dim>          scalars;
    dealii::hp::FEValues<dim>                    all_values;
    std::vector<double>                          weights; ///< of the quadrature points
    const std::vector<std::vector<unsigned int>> dofs;    ///< see dofs_of_nodes()
  };

  /// Load vector of one cell: body forces, tractions and pressures (doc/theory, 1.1), and forces at
  /// nodes.
  template <int dim>
  class LoadKernel
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Evaluate surface loads and find the cells of nodal forces. Collective.
    /// @param more_points of quadrature in each direction than is usual
    LoadKernel(const Mesh<dim>                     &mesh,
               const dealii::hp::FECollection<dim> &elements,
               Model                                model,
               const std::vector<Load<dim>>        &loads,
               double                               t,
               unsigned int                         more_points = 0);

    /// Compute the load vector of a cell.
    /// @param cell_load resized to the degrees of freedom of the cell [force]
    /// @return false if nothing acts on the cell
    bool
    assemble(const Cell &cell, dealii::Vector<double> &cell_load);

    /// A message about the first formula that had no finite value on this rank; empty if there is
    /// none.
    const std::string &
    fault() const
    {
      return error_message.empty() ? surface_loads.fault() : error_message;
    }

  private:
    /// Store a message if a value is not finite, the first time.
    void
    check(double                    size,
          const Load<dim>          &load,
          const std::string        &key,
          const std::string        &formula,
          const dealii::Point<dim> &x);
    /// The body forces that act on a cell, each once.
    std::vector<const Load<dim> *>
    body_forces(const Cell &cell) const;
    void
    add_body_force(const Cell &cell, const Load<dim> &load, dealii::Vector<double> &cell_load);
    void
    add_surface_loads(const Cell &cell, unsigned int face, dealii::Vector<double> &cell_load);

    void
    add_nodal_forces(const Cell &cell, dealii::Vector<double> &cell_load);

    const Model                         model;
    const double                        t;
    const NodalForces<dim>              nodal_forces;
    SurfaceLoads<dim>                   surface_loads;
    const dealii::hp::FECollection<dim> scalars; ///< the values refer to it
    dealii::hp::FEValues<dim>           all_values;
    dealii::hp::FEFaceValues<dim>       all_face_values;

    std::string error_message;

    std::map<unsigned int, std::vector<const Load<dim> *>>                  by_material;
    std::map<dealii::types::coarse_cell_id, std::vector<const Load<dim> *>> by_cell; ///< of sets
  };
} // namespace Signorini
