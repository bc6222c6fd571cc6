// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/cell_rule.h"

#include <deal.II/hp/fe_collection.h>
#include <deal.II/hp/q_collection.h>

#include <vector>

namespace Signorini
{
  /// The scalar element of the components of each vector-valued element.
  template <int dim>
  dealii::hp::FECollection<dim>
  scalar_elements(const dealii::hp::FECollection<dim> &elements)
  {
    dealii::hp::FECollection<dim> result;
    for (const auto &fe : elements)
      result.push_back(fe.base_element(0));
    return result;
  }

  /// For each element the rule of its cells with `beyond_degree` points more than its degree, in
  /// each direction, see cell_rule().
  template <int dim>
  dealii::hp::QCollection<dim>
  gauss_rules(const dealii::hp::FECollection<dim> &elements, const unsigned int beyond_degree)
  {
    dealii::hp::QCollection<dim> result;
    for (const auto &fe : elements)
      result.push_back(cell_rule<dim>(fe.reference_cell(), fe.degree + beyond_degree));
    return result;
  }

  /// For each element the rule of its faces, likewise.
  template <int dim>
  dealii::hp::QCollection<dim - 1>
  gauss_rules_of_faces(const dealii::hp::FECollection<dim> &elements,
                       const unsigned int                   beyond_degree)
  {
    dealii::hp::QCollection<dim - 1> result;
    for (const auto &fe : elements)
      result.push_back(
        cell_rule<dim - 1>(fe.reference_cell().face_reference_cell(0), fe.degree + beyond_degree));
    return result;
  }

  /// For each element, its degrees of freedom node by node: that of component d of node i is at
  /// position dim i + d.
  template <int dim>
  std::vector<std::vector<unsigned int>>
  dofs_of_nodes(const dealii::hp::FECollection<dim> &elements)
  {
    std::vector<std::vector<unsigned int>> result;
    for (const auto &fe : elements)
      {
        result.emplace_back(fe.n_dofs_per_cell());
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          {
            const auto [component, node]          = fe.system_to_component_index(i);
            result.back()[node * dim + component] = i;
          }
      }
    return result;
  }
} // namespace Signorini
