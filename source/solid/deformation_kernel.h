// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include "solid/cell_tangents.h"
#include "solid/deformation.h"
#include "solid/material_history.h"
#include "solid/thermal_strain.h"
#include "solid/volumetric_stress.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

namespace Signorini
{
  /// Internal forces of one cell by its constitutive law, int P : Grad v dV over the reference cell
  /// (doc/theory, (6.2)), and their derivative int Grad v : (dP/dF) : Grad du dV (6.3). At finite
  /// strain P = F S; at small strain P is sigma, and dP/dF = 2 dS/dC.
  template <int dim>
  class DeformationKernel
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Refers to the volumetric stress of bodies in displacement-pressure form, to the history of
    /// materials and to temperatures.
    /// @param elements the elements of cells, by active FE index
    /// @param volumetric_stress null: no body is in displacement-pressure form
    /// @param history null: no law has internal variables
    /// @param thermal null: no temperature changes
    DeformationKernel(const Mesh<dim>                     &mesh,
                      const dealii::hp::FECollection<dim> &elements,
                      Model                                model,
                      const VolumetricStress<dim>         *volumetric_stress = nullptr,
                      const MaterialHistory<dim>          *history           = nullptr,
                      const ThermalStrain<dim>            *thermal           = nullptr);

    /// Compute the forces of a cell and their derivative.
    /// @param u displacement at the degrees of freedom of the cell [length]
    /// @param forces resized to the degrees of freedom of the cell [force]
    /// @param tangent matrix of the same size [force/length]; null: not wanted
    /// @return false if the cell is inverted, det F <= 0 at a quadrature point; the results are
    /// then undefined
    bool
    assemble(const Cell                   &cell,
             const Material               &material,
             const dealii::Vector<double> &u,
             dealii::Vector<double>       &forces,
             dealii::FullMatrix<double>   *tangent = nullptr);

    /// In space: the derivative dP/dF at each integration point in the reference coordinates of the
    /// cell, with weights, as 45 numbers.
    /// @param points one entry for each integration point
    /// @return false if the cell is inverted; the result is then undefined
    bool
    tangents(const Cell                   &cell,
             const Material               &material,
             const dealii::Vector<double> &u,
             CellTangents                 &points);

    /// Internal variables of the law at the end of the load step with displacement u, point by
    /// point; empty where the cell is inverted.
    PointVariables
    internal(const Cell &cell, const Material &material, const dealii::Vector<double> &u);

    /// det F at the points of integration; valid until the next call.
    const std::vector<double> &
    volume_ratios(const Cell &cell, const dealii::Vector<double> &u);

  private:
    /// The components of a tensor that acts on gradients: those in the plane or in space, row by
    /// row, then the hoop component of axisymmetric models.
    static constexpr unsigned int maximum_components = dim * dim + (dim == 2 ? 1 : 0);
    using Components                                 = std::array<double, maximum_components>;
    using Tangent                                    = std::array<Components, maximum_components>;

    void
    reinit(const Cell &cell);
    /// The deformation gradient F at point q of the present cell.
    dealii::Tensor<2, 3>
    gradient(unsigned int q, const dealii::Vector<double> &u) const;
    /// Read the gradients of the shape functions at point q into `slopes`.
    void
    read_slopes(unsigned int q);
    /// The components of dP/dF at a point.
    Tangent
    derivative(const dealii::Tensor<2, 3> &F, const ConstitutiveResponse &state) const;
    /// The response at point q of the present cell; none where det F <= 0. @param F deformation
    /// gradient; becomes 1 at small strain
    std::optional<ConstitutiveResponse>
    state(const Cell           &cell,
          unsigned int          q,
          const Material       &material,
          ResponseOrder         wanted,
          dealii::Tensor<2, 3> &F);
    /// dP/dF with its weight, transformed to the reference coordinates of the cell.
    CellTangent
    in_unit_coordinates(const Tangent &D, unsigned int q) const;
    /// forces += weight int P : Grad N.
    void
    add_forces(const dealii::Tensor<2, 3> &P, double weight, dealii::Vector<double> &forces) const;
    /// Add the entries on and below the diagonal to `sums`.
    void
    add_tangent(const Tangent &D, double weight);

    const Model                        model;
    const VolumetricStress<dim> *const volumetric_stress; ///< null: none
    /// Null: none.
    const MaterialHistory<dim> *const history;
    /// Null: none.
    const ThermalStrain<dim> *const              thermal;
    const unsigned int                           n_components;
    const dealii::hp::FECollection<dim>          elements; ///< scalar: the values refer to them
    dealii::hp::FEValues<dim>                    all_values;
    const std::vector<std::vector<unsigned int>> all_dofs; ///< see dofs_of_nodes()

    // Of the present cell:
    const dealii::FEValues<dim>     *values = nullptr;
    const std::vector<unsigned int> *dofs   = nullptr;
    /// True if the present material has the measure of small strain.
    bool                is_small = false;
    std::vector<double> ratios;
    std::vector<double> sums; ///< of the tangent, node by node, row by row
    /// At the present point: the gradient of each node's shape function, and its value divided by
    /// the radius.
    std::vector<std::array<double, dim + 1>> slopes;
  };

  template <int dim>
  class Elasticity;

  /// @return the kernel of all bodies, with their volumetric stress, internal variables and
  /// temperatures. Refers to elasticity.
  template <int dim>
  DeformationKernel<dim>
  deformation_kernel(const Elasticity<dim> &elasticity);
} // namespace Signorini
