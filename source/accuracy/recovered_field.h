// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <deal.II/hp/fe_values.h>

#include <functional>
#include <vector>

namespace Signorini
{
  /// @return whether a cell of a quadrilateral or hexahedral mesh is the only one across a body, or
  /// across a layer of a material.
  template <int dim>
  bool
  is_one_cell_thick(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell);

  /// A sample of a field, and its share of the recovered value at a point.
  template <int dim>
  struct RecoverySample
  {
    typename dealii::DoFHandler<dim>::active_cell_iterator cell;
    dealii::Point<dim>                                     unit; ///< in coordinates of the cell
    dealii::Point<dim>                                     place;
    double                                                 weight;
  };

  /// @return the samples of which the value of a recovered field, see RecoveredField, is the sum.
  /// @param elasticity the model
  /// @param cell locally owned
  /// @param x point in the cell
  template <int dim>
  std::vector<RecoverySample<dim>>
  recovery_samples(const Elasticity<dim>                                        &elasticity,
                   const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                   const dealii::Point<dim>                                     &x);

  /// Recovers fields of higher order from derivatives of finite element solutions, (8.5): in each
  /// cell the polynomial of the degree of the displacement that fits the field best at the
  /// superconvergent points of the cell and of all cells that share a vertex with it (Zienkiewicz,
  /// Zhu 1992, see doc/theory; cell by cell instead of vertex by vertex). At boundaries patches are
  /// one-sided, and the fit has the same order there. Patches do not extend to other bodies or
  /// materials. Only locally owned and ghost cells are needed, so that nothing is communicated.
  template <int dim>
  class RecoveredField
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Writes the components of the field at the points of a locally owned or ghost cell, point
    /// after point.
    using Sampler =
      std::function<void(const Cell &cell, const dealii::FEValues<dim> &at, double *values)>;

    /// Sample the field.
    /// @param elasticity to which the object refers
    /// @param n_values number of components
    /// @param sampler of the field; it is kept
    RecoveredField(const Elasticity<dim> &elasticity, unsigned int n_values, Sampler sampler);

    /// The recovered field minus that of the finite elements in one cell.
    struct Deviations
    {
      /// Quadrature weights of the points; in axisymmetric models including 2 pi r.
      std::vector<double> weights;
      /// Field of the finite elements, and recovered minus computed field, point after point.
      std::vector<double> computed, deviation;
    };

    /// @return the deviations in a locally owned cell; valid until the next call.
    /// @param cell the cell
    const Deviations &
    operator()(const Cell &cell);

  private:
    /// @return the index of the rule with that many points in each direction.
    unsigned int
    rule(const Cell &cell, unsigned int points_per_direction) const;
    void
    sample();
    void
    find_neighbours();
    void
    collect_patch(const Cell &cell);

    const Elasticity<dim> &elasticity;
    const unsigned int     n_values;
    const Sampler          sampler;

    // By the index of locally owned and ghost cells:
    /// Index of the first sample of each cell, and the end.
    std::vector<unsigned int>       first_sample;
    std::vector<dealii::Point<dim>> places;
    /// Components at all points, see sample().
    std::vector<double> samples;

    std::vector<unsigned int> first_at_vertex, cells_at_vertex, material_of_cell;
    /// Indices of the cells of the present patch.
    std::vector<unsigned int> patch;

    dealii::hp::QCollection<dim> rules;
    dealii::hp::FEValues<dim>    values;
    Deviations                   result;
  };
} // namespace Signorini
