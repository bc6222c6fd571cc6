// SPDX-License-Identifier: Apache-2.0
#include "solid/material_history.h"

#include "mesh/cells_by_name.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The value at a point of the reference cell of the tensor-product polynomial through the
    /// Gauss points of a cell, for each internal variable.
    template <int dim>
    std::vector<double>
    interpolated(const PointVariables &from, const Point<dim> &unit_point)
    {
      const unsigned int n = from.points_per_line, n_points = Utilities::fixed_power<dim>(n),
                         n_internal = from.values.size() / n_points;
      const auto basis = Polynomials::generate_complete_Lagrange_basis(QGauss<1>(n).get_points());
      std::vector<double> result(n_internal, 0.);
      for (unsigned int q = 0; q < n_points; ++q)
        {
          // Tensor product of the Lagrange polynomials through the Gauss points. Points are
          // numbered with the first coordinate running fastest.
          double factor = 1;
          for (unsigned int d = 0, rest = q; d < dim; ++d, rest /= n)
            factor *= basis[rest % n].value(unit_point[d]);
          for (unsigned int k = 0; k < n_internal; ++k)
            result[k] += factor * from.values[q * n_internal + k];
        }
      return result;
    }

    /// Internal variables at a point of the cell `id`, interpolated from the cell itself, from its
    /// parent, or from the child that has the point; empty if none of them is known.
    template <int dim>
    std::vector<double>
    gathered_at(const CellVariables &known, const CellId &id, const Point<dim> &unit_point)
    {
      using Geometry = GeometryInfo<dim>;
      if (const auto own = known.find(id); own != known.end())
        return interpolated(own->second, unit_point);
      if (has_parent(id))
        if (const auto found = known.find(parent_of(id)); found != known.end())
          return interpolated(found->second,
                              Geometry::child_to_cell_coordinates(unit_point, number_of_child(id)));
      // After coarsening the values come from the child that contains the point.
      const unsigned int child = Geometry::child_cell_from_point(unit_point);
      if (const auto found = known.find(child_of(id, child)); found != known.end())
        return interpolated(found->second, Geometry::cell_to_child_coordinates(unit_point, child));
      return {};
    }
  } // namespace



  // If no law has internal variables, the list is emptied, and nothing is stored.
  template <int dim>
  MaterialHistory<dim>::MaterialHistory(const Mesh<dim>             &mesh,
                                        const DoFHandler<dim>       &dof_handler,
                                        const std::vector<Material> &materials)
    : mesh(mesh)
    , dof_handler(dof_handler)
  {
    for (const Material &material : materials)
      n_variables.push_back(material.constitutive_law ? material.constitutive_law->n_internal() :
                                                        0);
    if (std::count(n_variables.begin(), n_variables.end(), 0u) ==
        static_cast<std::ptrdiff_t>(n_variables.size()))
      n_variables.clear();
  }



  // All cells of this rank and ghost cells get zeros.
  template <int dim>
  void
  MaterialHistory<dim>::reinit()
  {
    if (empty())
      return;
    ++my_version;
    cells.assign(mesh.triangulation().n_active_cells(), PointVariables());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial() && n_internal(cell->material_id()) > 0)
        {
          PointVariables &variables = cells[cell->active_cell_index()];
          variables.points_per_line = cell->get_fe().degree + 1;
          variables.values.assign(Utilities::fixed_power<dim>(variables.points_per_line) *
                                    n_internal(cell->material_id()),
                                  0.);
        }
  }



  // Set the variables at the start of a load step from those of another mesh or partition: cells
  // that exist in both keep them, others interpolate them from their parent or children. Points
  // without any source stay at zero, the virgin state. Collective.
  template <int dim>
  void
  MaterialHistory<dim>::start(const CellVariables &before, const double duration)
  {
    if (empty())
      return;
    reinit();
    my_duration = duration;
    // Cells that may be sources: the cell, its parent (after refinement) and its children (after
    // coarsening). Values may be on any rank and are gathered in one exchange.
    std::vector<CellId> wanted;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial() && n_internal(cell->material_id()) > 0)
        {
          wanted.push_back(cell->id());
          if (has_parent(cell->id()))
            wanted.push_back(parent_of(cell->id()));
          for (unsigned int c = 0; c < GeometryInfo<dim>::max_children_per_cell; ++c)
            wanted.push_back(child_of(cell->id(), c));
        }
    const CellVariables known = gather_values(before, wanted, mesh.communicator());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        PointVariables &variables = cells[cell->active_cell_index()];
        if (variables.values.empty())
          continue;
        const CellId id = cell->id();
        if (const auto own = known.find(id);
            own != known.end() && own->second.points_per_line == variables.points_per_line)
          {
            // An unchanged cell keeps its values exactly.
            variables.values = own->second.values;
            continue;
          }
        const QGauss<dim>  rule(variables.points_per_line);
        const unsigned int n = n_internal(cell->material_id());
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const std::vector<double> values = gathered_at<dim>(known, id, rule.point(q));
            std::copy(values.begin(), values.end(), variables.values.begin() + q * n);
          }
      }
  }



  // The variables of point q of the rule of the stiffness; null for laws without any.
  template <int dim>
  const double *
  MaterialHistory<dim>::at(const Cell &cell, const unsigned int q) const
  {
    const unsigned int n = n_internal(cell.material_id());
    return n == 0 ? nullptr : cells[cell.active_cell_index()].values.data() + q * n;
  }



  template <int dim>
  std::vector<double>
  MaterialHistory<dim>::at(const Cell &cell, const Point<dim> &unit_point) const
  {
    if (n_internal(cell.material_id()) == 0)
      return {};
    return interpolated(cells[cell.active_cell_index()], unit_point);
  }



  template class MaterialHistory<2>;
  template class MaterialHistory<3>;
} // namespace Signorini
