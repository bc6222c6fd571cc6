// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/hp/fe_values.h>

#include <vector>

namespace Signorini
{
  /// Stresses of finite element solutions, and better ones: in each cell the polynomial of the
  /// displacement's degree that fits the stress best at the superconvergent points of the cell and
  /// of all that share a vertex with it (Zienkiewicz, Zhu, Int. J. Numer. Meth. Engng. 33 (1992)
  /// 1331, cell by cell instead of vertex by vertex). At boundaries patches are one-sided, and the
  /// fit is of the same order there. Patches end with their body. No cell asks for more than its
  /// ghosts, so that nothing is sent.
  template <int dim>
  class RecoveredStress
  {
  public:
    using Cell   = typename dealii::DoFHandler<dim>::active_cell_iterator;
    using Stress = dealii::SymmetricTensor<2, 3>;

    /// A displacement, and whether thermal strain is part of its strain: it is of solutions, not of
    /// their changes.
    struct Field
    {
      const LA::Vector *displacement;
      bool              has_thermal_strain;
    };

    /// Refers to the elasticity. Collective.
    RecoveredStress(const Elasticity<dim> &elasticity, const std::vector<Field> &fields);

    /// The recovered stress minus that of the finite elements.
    struct Deviations
    {
      std::vector<double>              weights;   ///< of the points, areas of rings included
      std::vector<std::vector<Stress>> deviation; ///< [field][point]
      std::vector<std::vector<Stress>> stress;    ///< [field][point], of the finite elements
    };

    /// In a locally owned cell; valid until the next call.
    const Deviations &
    operator()(const Cell &cell);

  private:
    /// Stresses in a plane have four components.
    static constexpr unsigned int n_components = dim == 2 ? 4 : 6;

    /// At how many points a direction: one would not see the bending of a body that is one cell
    /// thick.
    unsigned int
    points_per_direction(const Cell &cell) const;
    void
    sample();
    void
    find_neighbours();
    void
    collect_patch(const Cell &cell);
    /// The stresses of the fields at the points where the values are.
    void
    stresses_at(const Cell                            &cell,
                const dealii::FEValues<dim>           &values,
                const std::vector<dealii::Point<dim>> &points,
                std::vector<std::vector<Stress>>      &result) const;

    const Elasticity<dim>  &elasticity;
    std::vector<LA::Vector> ghosted;
    std::vector<bool>       has_thermal_strain;

    // Of all cells that this rank knows, by their number:
    std::vector<unsigned int>       first_sample; ///< one more than there are cells
    std::vector<dealii::Point<dim>> places;
    std::vector<double>             samples; ///< field by field, component by component

    std::vector<unsigned int> first_at_vertex, cells_at_vertex, material_of_cell;
    std::vector<unsigned int> patch; ///< numbers of cells

    dealii::hp::QCollection<dim> rules;
    dealii::hp::FEValues<dim>    values;
    Deviations                   result;
  };
} // namespace Signorini
