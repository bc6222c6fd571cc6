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
  /// Forces of one cell by its constitutive law, int P : Grad v dV over the cell at rest; and how
  /// they change with its displacement, int Grad v : (dP/dF) : Grad du dV. At finite strain P = F
  /// S (doc/theory, 6.1), and dP_aJ/dF_bL = delta_ab S_JL + F_aI (2 dS/dC)_IJKL F_bK; at small
  /// strain P is sigma, and dP/dF = 2 dS/dC.
  template <int dim>
  class DeformationKernel
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Refers to the volumetric stress of mixed bodies, to the history of materials, to
    /// temperatures.
    /// @param elements that cells have, by their index
    /// @param history null: no law remembers anything
    /// @param thermal null: no temperature changes
    DeformationKernel(const Mesh<dim>                     &mesh,
                      const dealii::hp::FECollection<dim> &elements,
                      Model                                model,
                      const VolumetricStress<dim>         *volumetric_stress = nullptr,
                      const MaterialHistory<dim>          *history           = nullptr,
                      const ThermalStrain<dim>            *thermal           = nullptr);

    /// Returns false, and leaves nothing that means anything, where the cell is folded: det F <= 0.
    /// @param u the displacement at the degrees of freedom of the cell
    /// @param forces takes the size of the cell
    /// @param tangent likewise; null: not wanted
    bool
    assemble(const Cell                   &cell,
             const Material               &material,
             const dealii::Vector<double> &u,
             dealii::Vector<double>       &forces,
             dealii::FullMatrix<double>   *tangent = nullptr);

    /// In three dimensions: the same derivative at each point of integration, in unit coordinates.
    /// Returns false, and leaves nothing that means anything, where the cell is folded.
    bool
    tangents(const Cell                   &cell,
             const Material               &material,
             const dealii::Vector<double> &u,
             CellTangents                 &points);

    /// Internal variables of the law at the end of this load step, point by point; nothing where
    /// the cell is folded.
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
    dealii::Tensor<2, 3>
    gradient(unsigned int q, const dealii::Vector<double> &u) const;
    /// Read the gradients of the shape functions at point q into `slopes`.
    void
    read_slopes(unsigned int q);
    Tangent
    derivative(const dealii::Tensor<2, 3> &F, const ConstitutiveResponse &state) const;
    /// @param F deformation gradient; becomes 1 at small strain
    std::optional<ConstitutiveResponse>
    state(const Cell           &cell,
          unsigned int          q,
          const Material       &material,
          ResponseOrder         wanted,
          dealii::Tensor<2, 3> &F);
    CellTangent
    in_unit_coordinates(const Tangent &D, unsigned int q) const;
    void
    add_forces(const dealii::Tensor<2, 3> &P, double weight, dealii::Vector<double> &forces) const;
    /// Add the entries on and below the diagonal to `sums`.
    void
    add_tangent(const Tangent &D, double weight);

    const Model                                  model;
    const VolumetricStress<dim> *const           volumetric_stress; ///< null: none
    const MaterialHistory<dim> *const            history;           ///< likewise
    const ThermalStrain<dim> *const              thermal;           ///< likewise
    const unsigned int                           n_components;
    const dealii::hp::FECollection<dim>          elements; ///< scalar: the values refer to them
    dealii::hp::FEValues<dim>                    all_values;
    const std::vector<std::vector<unsigned int>> all_dofs; ///< see dofs_of_nodes()

    // Of the present cell:
    const dealii::FEValues<dim>     *values   = nullptr;
    const std::vector<unsigned int> *dofs     = nullptr;
    bool                             is_small = false; ///< its strain measure
    std::vector<double>              ratios;
    std::vector<double>              sums; ///< of the tangent, node by node, row by row
    /// At the present point: the gradient of each node's shape function, and its value divided by
    /// the radius.
    std::vector<std::array<double, dim + 1>> slopes;
  };
} // namespace Signorini
