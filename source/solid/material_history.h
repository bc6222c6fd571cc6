// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include <signorini/materials/material.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/hp/fe_collection.h>

#include <map>
#include <vector>

namespace Signorini
{
  /// Internal variables at the integration points of a cell, those of a Gauss rule with
  /// `points_per_line` points in each direction, in lexicographic order; the variables of a point
  /// are adjacent.
  struct PointVariables
  {
    unsigned int        points_per_line = 0;
    std::vector<double> values;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &points_per_line &values;
    }
  };

  /// The internal variables of some cells, by cell id: they refer to no mesh and no partition, and
  /// outlive both.
  using CellVariables = std::map<dealii::CellId, PointVariables>;

  /// The internal variables of constitutive laws at the start of the load step, on the present
  /// mesh. Unchanged cells keep their values; cells that come from a coarser cell, or from finer
  /// ones, interpolate by the polynomial through the integration points of these (doc/theory, 6.3).
  template <int dim>
  class MaterialHistory
  {
  public:
    using Cell = dealii::CellAccessor<dim>;

    /// Refers to the mesh and the degrees of freedom. @param materials by their ids
    MaterialHistory(const Mesh<dim>               &mesh,
                    const dealii::DoFHandler<dim> &dof_handler,
                    const std::vector<Material>   &materials);

    /// True if no law has internal variables; then nothing is stored.
    bool
    empty() const
    {
      return n_variables.empty();
    }

    /// Adapt to a new mesh; all variables become zero.
    void
    reinit();

    /// Set the variables at the start of a load step. Collective.
    /// @param before variables at the end of the last load step, each cell on any rank; zero where
    /// there are none
    /// @param duration duration of the load step [time]
    void
    start(const CellVariables &before, double duration);

    /// The duration of the present load step [time].
    double
    duration() const
    {
      return my_duration;
    }

    /// A number that changes with each start() and reinit().
    unsigned int
    version() const
    {
      return my_version;
    }

    /// The number of internal variables at a point of a material.
    unsigned int
    n_internal(const unsigned int material_id) const
    {
      return empty() ? 0 : n_variables[material_id];
    }

    // Values of a locally owned or ghost cell:

    /// The internal variables at an integration point; null if the law has none.
    const double *
    at(const Cell &cell, unsigned int q) const;

    /// The internal variables at a point of the reference cell, interpolated by the polynomial
    /// through the integration points.
    std::vector<double>
    at(const Cell &cell, const dealii::Point<dim> &unit_point) const;

  private:
    const Mesh<dim>               &mesh;
    const dealii::DoFHandler<dim> &dof_handler;
    std::vector<unsigned int>      n_variables; ///< by material id; empty: none has any
    std::vector<PointVariables>    cells;       ///< by number of the active cell
    double                         my_duration = 0;
    unsigned int                   my_version  = 0;
  };
} // namespace Signorini
