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
  /// Internal variables at the points of integration of a cell, which are those of a Gauss rule
  /// with so many points a line, lexicographic; point by point.
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

  /// What constitutive laws remember from the load step before, on the present mesh. Cells that
  /// were there then have the same numbers; those that come from a larger one, or from smaller
  /// ones, have the polynomial through the points of these.
  template <int dim>
  class MaterialHistory
  {
  public:
    using Cell = dealii::CellAccessor<dim>;

    /// Refers to the mesh and the degrees of freedom. @param materials by their ids
    MaterialHistory(const Mesh<dim>               &mesh,
                    const dealii::DoFHandler<dim> &dof_handler,
                    const std::vector<Material>   &materials);

    /// No law has internal variables: there is nothing to do, and nothing is stored.
    bool
    empty() const
    {
      return n_variables.empty();
    }

    /// The mesh has changed: all variables are zero.
    void
    reinit();

    /// A load step starts. Collective.
    /// @param before variables at the end of the last one, on any ranks; zero where nothing is
    /// known
    /// @param duration of the load step
    void
    start(const CellVariables &before, double duration);

    double
    duration() const
    {
      return my_duration;
    }

    /// Changes with each start().
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

    // Of a locally owned or ghost cell:

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
