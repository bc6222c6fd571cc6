// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/trace.h"

#include "geometry/face_functions.h"
#include "mesh/face_nodes.h"
#include "solid/cell_nodes.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Smaller values of a shape function are rounding, and count as zero.
    constexpr double zero = 1e-14;

    /// Replace the entries of hanging nodes by entries for the nodes that constrain them, phi_I ->
    /// sum_J C_IJ phi_J (doc/theory, 3.2), made by scaled(entry, J, C_IJ). Entries of one index may
    /// then occur repeatedly.
    /// @return false if no entry was of a hanging node
    template <typename Entry, typename Index, typename Scale>
    bool
    replace_hanging(const AffineConstraints<double> &hanging,
                    std::vector<Entry>              &row,
                    const Index                     &index_of,
                    const Scale                     &scaled)
    {
      const auto hangs = [&](const Entry &entry) {
        return hanging.is_constrained(index_of(entry));
      };
      if (std::none_of(row.begin(), row.end(), hangs))
        return false;
      // Entries of masters are appended, and those of hanging nodes removed in the end. Constraints
      // are closed, so that masters do not hang.
      const std::size_t n = row.size();
      for (std::size_t i = 0; i < n; ++i)
        if (const auto *entries = hanging.get_constraint_entries(index_of(row[i])))
          {
            const Entry entry = row[i];
            for (const auto &[index, weight] : *entries)
              row.push_back(scaled(entry, index, weight));
          }
      row.erase(std::remove_if(row.begin(), row.end(), hangs), row.end());
      return true;
    }

    /// Sort functions by nodes and add up those of the same node.
    template <int dim>
    void
    sum_duplicates(FaceShapeFunctions<dim> &functions)
    {
      std::sort(functions.begin(), functions.end(), [](const auto &a, const auto &b) {
        return a.node < b.node;
      });
      std::size_t last = 0;
      for (std::size_t i = 1; i < functions.size(); ++i)
        if (functions[i].node == functions[last].node)
          {
            functions[last].value += functions[i].value;
            for (unsigned int a = 0; a < dim - 1; ++a)
              functions[last].slopes[a] += functions[i].slopes[a];
          }
        else
          functions[++last] = functions[i];
      functions.resize(last + 1);
    }

    /// Condense the hanging nodes of shape functions with their slopes; the constraints of the
    /// first component of a node are those of all its components.
    template <int dim>
    void
    condense_hanging_nodes(const AffineConstraints<double> &hanging,
                           FaceShapeFunctions<dim>         &functions)
    {
      const auto scaled = [](NodeShapeFunction<dim>        function,
                             const types::global_dof_index node,
                             const double                  weight) {
        function.node = node;
        function.value *= weight;
        for (double &slope : function.slopes)
          slope *= weight;
        return function;
      };
      if (replace_hanging(
            hanging, functions, [](const auto &function) { return function.node; }, scaled))
        sum_duplicates<dim>(functions);
    }
  } // namespace



  void
  sum_duplicates(SparseRow &row)
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
  condense_hanging_nodes(const AffineConstraints<double> &hanging, SparseRow &row)
  {
    using Entry       = SparseRow::value_type;
    const auto scaled = [](const Entry &entry, const auto index, const double weight) {
      return Entry(index, weight * entry.second);
    };
    if (replace_hanging(
          hanging, row, [](const Entry &entry) { return entry.first; }, scaled))
      sum_duplicates(row);
  }



  template <int dim>
  Trace<dim>::Trace(const Elasticity<dim> &elasticity)
    : hanging(elasticity.hanging_nodes())
  {
    for (const auto &fe : elasticity.finite_elements())
      elements.push_back(element_of(fe));
  }



  // The nodes of elements of degree 1 and 2 are equidistant. The number of a node in the lattice is
  // found by its position, so that it does not depend on the numbering of deal.II.
  template <int dim>
  typename Trace<dim>::Element
  Trace<dim>::element_of(const FiniteElement<dim> &fe)
  {
    const FiniteElement<dim> &scalar  = fe.base_element(0);
    const ReferenceCell       shape   = shape_of_faces(fe.reference_cell());
    const auto                lattice = face_lattice<dim>(shape, scalar.degree);
    Element                   result{scalar.degree,
                   shape,
                   std::vector<std::vector<Node>>(fe.reference_cell().n_faces())};
    for (unsigned int face = 0; face < result.nodes.size(); ++face)
      for (const unsigned int i : nodes_of_face(scalar, face))
        {
          Node       node{fe.component_to_system_index(0, i), 0};
          const auto xi =
            face_parameter<dim>(scalar.reference_cell(), face, scalar.unit_support_point(i));
          while (node.place < lattice.size() && lattice[node.place].distance(xi) > 1e-10)
            ++node.place;
          AssertThrow(node.place < lattice.size(), ExcInternalError());
          result.nodes[face].push_back(node);
        }
    return result;
  }



  template <int dim>
  void
  Trace<dim>::reinit(const Cell &new_cell, const unsigned int new_face)
  {
    // Consecutive points are mostly on the same face.
    if (new_face == face && new_cell == cell)
      return;
    cell    = new_cell;
    face    = new_face;
    element = &elements[cell->active_fe_index()];
    read_indices<dim>(cell, indices);
    nodes.clear();
    for (const Node &node : element->nodes[face])
      nodes.push_back(indices[node.dof]);
  }



  template <int dim>
  FaceShapeFunctions<dim>
  Trace<dim>::unresolved(const Parameter &xi) const
  {
    const FaceFunctions<dim> values(element->shape, element->degree, xi);
    FaceShapeFunctions<dim>  result;
    result.reserve(nodes.size());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const unsigned int       place = element->nodes[face][k].place;
        NodeShapeFunction<dim>   one{nodes[k], values.value(place), {}};
        const Tensor<1, dim - 1> slope = values.gradient(place);
        for (unsigned int a = 0; a < dim - 1; ++a)
          one.slopes[a] = slope[a];
        result.push_back(one);
      }
    return result;
  }



  // Hanging nodes are replaced by the nodes that constrain them, so that contact is continuous over
  // faces of different size.
  template <int dim>
  FaceShapeFunctions<dim>
  Trace<dim>::functions(const Parameter &xi) const
  {
    FaceShapeFunctions<dim> result = unresolved(xi);
    condense_hanging_nodes<dim>(hanging, result);
    return result;
  }



  // Values only; most points need no slopes. Functions that vanish at the point are omitted.
  template <int dim>
  SparseRow
  Trace<dim>::unresolved_shape(const Parameter &xi) const
  {
    SparseRow row;
    for (const NodeShapeFunction<dim> &function : unresolved(xi))
      if (std::abs(function.value) > zero)
        row.emplace_back(function.node, function.value);
    return row;
  }



  template <int dim>
  SparseRow
  Trace<dim>::shape(const Parameter &xi) const
  {
    SparseRow row = unresolved_shape(xi);
    Signorini::condense_hanging_nodes(hanging, row);
    return row;
  }



  template class Trace<2>;
  template class Trace<3>;
} // namespace Signorini
