#include <signorini/contact/discretisation/trace.h>
#include <signorini/elasticity/cell_nodes.h>
#include <signorini/mesh/face_nodes.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  void
  unite(SparseRow &row)
  {
    std::sort(row.begin(), row.end());
    std::size_t last = 0;
    for (std::size_t i = 1; i < row.size(); ++i)
      if (row[i].first == row[last].first)
        row[last].second += row[i].second;
      else
        row[++last] = row[i];
    if (!row.empty())
      row.resize(last + 1);
  }



  void
  resolve(const AffineConstraints<double> &hanging, SparseRow &row)
  {
    const auto hangs = [&](const auto &entry) { return hanging.is_constrained(entry.first); };
    if (std::none_of(row.begin(), row.end(), hangs))
      return;
    const std::size_t n = row.size();
    for (std::size_t i = 0; i < n; ++i)
      if (const auto *entries = hanging.get_constraint_entries(row[i].first))
        {
          const double factor = row[i].second;
          for (const auto &[index, weight] : *entries)
            row.emplace_back(index, factor * weight);
        }
    row.erase(std::remove_if(row.begin(), row.end(), hangs), row.end());
    unite(row);
  }



  std::vector<double>
  row_values(const std::vector<const SparseRow *> &rows, const LA::Vector &u)
  {
    std::vector<types::global_dof_index> indices;
    for (const SparseRow *row : rows)
      for (const auto &entry : *row)
        indices.push_back(entry.first);
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    IndexSet readable = u.locally_owned_elements();
    readable.add_indices(indices.begin(), indices.end());
    LA::Vector ghosted(u.locally_owned_elements(), readable, u.get_mpi_communicator());
    ghosted = u;
    std::vector<double> values(indices.size()), result;
    ghosted.extract_subvector_to(indices, values);
    const auto value_of = [&](const types::global_dof_index index) {
      return values[std::lower_bound(indices.begin(), indices.end(), index) - indices.begin()];
    };
    for (const SparseRow *row : rows)
      {
        result.push_back(0);
        for (const auto &[index, value] : *row)
          result.back() += value * value_of(index);
      }
    return result;
  }



  template <int dim>
  Trace<dim>::Trace(const Elasticity<dim> &elasticity)
    : hanging(elasticity.hanging_nodes())
    , all_components(elasticity.has_inclined_supports())
  {
    for (const auto &fe : elasticity.finite_elements())
      {
        nodes_of.emplace_back(GeometryInfo<dim>::faces_per_cell);
        for (unsigned int face = 0; face < nodes_of.back().size(); ++face)
          nodes_of.back()[face] = nodes_of_face(fe.base_element(0), face);
      }
  }



  template <int dim>
  void
  Trace<dim>::reinit(const Cell &cell, const unsigned int new_face)
  {
    read_indices<dim>(cell, indices);
    fe      = &cell->get_fe();
    element = cell->active_fe_index();
    face    = new_face;
  }



  template <int dim>
  const std::vector<unsigned int> &
  Trace<dim>::nodes() const
  {
    return nodes_of[element][face];
  }



  template <int dim>
  SparseRow
  Trace<dim>::normal_displacement(const Point<dim> &unit_point, const Tensor<1, dim> &n) const
  {
    SparseRow row;
    row.reserve(2 * dim * nodes().size()); // room for a partner
    for (const unsigned int i : nodes())
      if (const double value = fe->base_element(0).shape_value(i, unit_point);
          std::abs(value) > 1e-14)
        for (unsigned int d = 0; d < dim; ++d)
          if (n[d] != 0 || all_components)
            row.emplace_back(indices[fe->component_to_system_index(d, i)], value * n[d]);
    resolve(hanging, row);
    return row;
  }



  template <int dim>
  SparseRow
  Trace<dim>::normal_slope(const Point<dim>     &unit_point,
                           const Tensor<1, dim> &n,
                           const unsigned int    a) const
  {
    const unsigned int axis = (face / 2 + 1 + a) % dim; // see mesh/face_parameter.h
    SparseRow          row;
    row.reserve(dim * nodes().size());
    for (const unsigned int i : nodes())
      {
        const double slope = fe->base_element(0).shape_grad(i, unit_point)[axis];
        for (unsigned int d = 0; d < dim; ++d)
          if (n[d] != 0 || all_components)
            row.emplace_back(indices[fe->component_to_system_index(d, i)], n[d] * slope);
      }
    resolve(hanging, row);
    return row;
  }



  template <int dim>
  SparseRow
  Trace<dim>::unresolved_shape(const Point<dim> &unit_point) const
  {
    SparseRow row;
    for (const unsigned int i : nodes())
      if (const double value = fe->base_element(0).shape_value(i, unit_point);
          std::abs(value) > 1e-14)
        row.emplace_back(indices[fe->component_to_system_index(0, i)], value);
    return row;
  }



  template <int dim>
  SparseRow
  Trace<dim>::shape(const Point<dim> &unit_point) const
  {
    SparseRow row = unresolved_shape(unit_point);
    resolve(hanging, row);
    return row;
  }



  template class Trace<2>;
  template class Trace<3>;
} // namespace Signorini
