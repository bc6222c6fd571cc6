// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/hp/fe_values.h>

#include <vector>

namespace Signorini
{
  /// Recovers stresses of higher order from finite element solutions, (8.5): in each cell the
  /// polynomial of the degree of the displacement that fits the stress best at the superconvergent
  /// points of the cell and of all cells that share a vertex with it (Zienkiewicz, Zhu 1992, see
  /// doc/theory; cell by cell instead of vertex by vertex). At boundaries patches are one-sided,
  /// and the fit has the same order there. Patches do not extend to other bodies or materials. Only
  /// locally owned and ghost cells are needed, so that nothing is communicated after the
  /// construction.
  template <int dim>
  class RecoveredStress
  {
  public:
    using Cell   = typename dealii::DoFHandler<dim>::active_cell_iterator;
    using Stress = dealii::SymmetricTensor<2, 3>;

    /// A displacement, and whether thermal strain is part of its strain: it is for solutions, and
    /// not for their changes.
    struct Field
    {
      const LA::Vector *displacement;
      bool              has_thermal_strain;
    };

    /// Sample the stresses. Collective.
    /// @param elasticity to which the object refers
    /// @param fields whose displacements have no ghost values
    RecoveredStress(const Elasticity<dim> &elasticity, const std::vector<Field> &fields);

    /// The recovered stress minus that of the finite elements in one cell.
    struct Deviations
    {
      /// Quadrature weights of the points; in axisymmetric models including 2 pi r.
      std::vector<double> weights;
      /// Recovered minus computed stress, [field][point].
      std::vector<std::vector<Stress>> deviation;
      /// Computed stress, [field][point].
      std::vector<std::vector<Stress>> stress;
    };

    /// @return the deviations in a locally owned cell; valid until the next call.
    /// @param cell the cell
    const Deviations &
    operator()(const Cell &cell);

  private:
    /// Number of stress components: plane stresses have four.
    static constexpr unsigned int n_components = dim == 2 ? 4 : 6;

    /// @return the number of sample points in each direction; at least two across a body that is
    /// one cell thick, since one point would miss bending.
    unsigned int
    points_per_direction(const Cell &cell) const;
    void
    sample();
    void
    find_neighbours();
    void
    collect_patch(const Cell &cell);
    /// Compute the stresses of all fields at the points of `values`.
    void
    stresses_at(const Cell                            &cell,
                const dealii::FEValues<dim>           &values,
                const std::vector<dealii::Point<dim>> &points,
                std::vector<std::vector<Stress>>      &result) const;

    const Elasticity<dim>  &elasticity;
    std::vector<LA::Vector> ghosted;
    std::vector<bool>       has_thermal_strain;

    // By the index of locally owned and ghost cells:
    /// Index of the first sample of each cell, and the end.
    std::vector<unsigned int>       first_sample;
    std::vector<dealii::Point<dim>> places;
    /// Stress components of all points, see sample().
    std::vector<double> samples;

    std::vector<unsigned int> first_at_vertex, cells_at_vertex, material_of_cell;
    /// Indices of the cells of the present patch.
    std::vector<unsigned int> patch;

    dealii::hp::QCollection<dim> rules;
    dealii::hp::FEValues<dim>    values;
    Deviations                   result;
  };
} // namespace Signorini
