// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/scene_text.h"
#include "mesh_import/decks/scene_writer.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

// Equations between displacements.

namespace Signorini
{
  using namespace dealii;

  /// @return "BODY.NUMBER" of each node of a body; empty for others.
  std::vector<std::string>
  SceneWriter::names_of_nodes() const
  {
    std::vector<std::string> result(model.deck.mesh.nodes.size());
    for (const auto &[instance, numbers] : model.deck.mesh.numbers)
      for (const auto &[number, node] : numbers)
        for (const Body &body : all)
          if (body.has_node[node])
            result[node] =
              body.name + "." + (instance.empty() ? "" : instance + ".") + std::to_string(number);
    return result;
  }



  namespace
  {
    /// @return the direction of a component along axes at a place: global ones, if there are none.
    /// Not finite where the axes have none.
    Tensor<1, 3>
    direction_along(const std::optional<DeckModel::Axes> &axes,
                    const Point<3>                       &place,
                    const unsigned int                    component)
    {
      if (!axes)
        {
          Tensor<1, 3> result;
          result[component] = 1;
          return result;
        }
      const auto &[is_cylindrical, first, second] = *axes;
      const auto vector                           = [](const std::array<double, 3> &v) {
        return Tensor<1, 3>({v[0], v[1], v[2]});
      };
      // x' is radial or the first vector, z' the axis or across both vectors.
      Tensor<1, 3> x = vector(first), z = cross_product_3d(x, vector(second));
      if (is_cylindrical)
        {
          z = vector(second) - vector(first);
          x = place - Point<3>(first[0], first[1], first[2]);
          z /= z.norm();
          x -= (x * z) * z;
        }
      x /= x.norm();
      z /= z.norm();
      return component == 0 ? x : component == 2 ? z : cross_product_3d(z, x);
    }
  } // namespace



  /// @return the direction of a component of the displacement of a node: along an axis, or along
  /// those of its *TRANSFORM.
  Tensor<1, 3>
  SceneWriter::direction_of(const unsigned int node, const unsigned int component) const
  {
    const auto turned = model.axes_of_nodes.find(node);
    return direction_along(turned == model.axes_of_nodes.end() ?
                             std::optional<DeckModel::Axes>() :
                             std::optional<DeckModel::Axes>(model.axes[turned->second]),
                           model.deck.mesh.nodes[node],
                           component);
  }



  /// True if an equation does nothing but define the displacement of a node that is on no solid:
  /// there is no force on it, and no other equation with it.
  bool
  SceneWriter::defines_only(const DeckModel::Equation     &equation,
                            const DeckModel::EquationTerm &term) const
  {
    const auto is_same = [&](const DeckModel::EquationTerm &other) {
      return other.node == term.node && other.component == term.component;
    };
    return model.forces.count({term.node, term.component}) == 0 &&
           std::none_of(model.equations.begin(), model.equations.end(), [&](const auto &other) {
             return &other != &equation && std::any_of(other.begin(), other.end(), is_same);
           });
  }



  // The mean displacement of the nodes of a distributing coupling is that of its reference node,
  // where that has a support.
  void
  SceneWriter::add_mean_equations(const DeckModel::Coupling &one)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (!component_at(model.supports, one.reference, d, "", 1).empty())
        {
          DeckModel::Equation equation;
          for (const unsigned int node : one.nodes)
            equation.push_back({node, d, 1});
          equation.push_back({one.reference, d, -double(one.nodes.size())});
          model.equations.push_back(equation);
        }
  }



  // e.u = e.(U + w x r) for the coupled components e of each node, with the motion U, w of the
  // reference node. Those of its components that nothing prescribes are unknowns, which a few of
  // the equations determine: Gauss-Jordan elimination takes them out of all the others.
  bool
  SceneWriter::add_coupling_equations(const DeckModel::Coupling &one)
  {
    using Row = std::map<std::pair<unsigned int, unsigned int>, double>;
    if (is_finite_strain || one.rotation || !names_of_nodes()[one.reference].empty())
      return false;
    const std::vector<Point<3>> &at = model.deck.mesh.nodes;
    std::vector<Row>             rows;
    for (const unsigned int node : model.nodes_of(one))
      for (unsigned int c = 0; c < 3; ++c)
        if (one.components[c] && (dim == 3 || c < 2))
          {
            const Tensor<1, 3> e = direction_along(one.axes, at[node], c),
                               r = at[node] - at[one.reference], turn = cross_product_3d(r, e);
            if (model.axes_of_nodes.count(node) > 0)
              return false;
            // On a cylindrical axis there are no radial and tangential directions.
            if (!std::isfinite(e.norm()))
              continue;
            Row row;
            for (unsigned int d = 0; d < dim; ++d)
              {
                row[{node, d}]          = e[d];
                row[{one.reference, d}] = -e[d];
              }
            for (unsigned int d = dim == 2 ? 2 : 0; d < 3; ++d)
              row[{one.reference, 3 + d}] = -turn[d];
            rows.push_back(row);
          }
    for (unsigned int q = 0; q < 6; ++q)
      {
        const std::pair<unsigned int, unsigned int> unknown(one.reference, q);
        if (!component_at(model.supports, one.reference, q, "", 1).empty())
          continue;
        const auto factor = [&](const Row &row) {
          const auto found = row.find(unknown);
          return found == row.end() ? 0. : found->second;
        };
        const auto pivot = std::max_element(rows.begin(), rows.end(), [&](auto &a, auto &b) {
          return std::abs(factor(a)) < std::abs(factor(b));
        });
        if (pivot == rows.end())
          return false;
        const Row    removed = *pivot;
        const double largest = factor(removed);
        // Distances of nodes from the reference node are levers.
        if (std::abs(largest) > (q < 3 ? 1e-8 : 1e-8 * mean_distance(one)))
          {
            rows.erase(pivot);
            for (Row &row : rows)
              if (const double share = factor(row) / largest; share != 0)
                for (const auto &[term, value] : removed)
                  row[term] -= share * value;
          }
        for (Row &row : rows)
          row.erase(unknown);
      }
    for (const Row &row : rows)
      {
        double largest = 0;
        for (const auto &[term, value] : row)
          largest = term.first == one.reference ? largest : std::max(largest, std::abs(value));
        DeckModel::Equation equation;
        for (const auto &[term, value] : row)
          if (std::abs(value) > 1e-12 * largest || term.first == one.reference)
            equation.push_back({term.first, term.second, value});
        if (largest > 1e-8)
          model.equations.push_back(equation);
      }
    return true;
  }



  /// @return the mean distance of the nodes of a coupling from its reference node.
  double
  SceneWriter::mean_distance(const DeckModel::Coupling &one) const
  {
    const std::vector<unsigned int> nodes = model.nodes_of(one);
    double                          sum   = 0;
    for (const unsigned int node : nodes)
      sum += model.deck.mesh.nodes[node].distance(model.deck.mesh.nodes[one.reference]);
    return sum / nodes.size();
  }



  // Nodes that are on no body stand for the right-hand side: their displacements are prescribed.
  // Equations with the same right-hand side are one entry of the scene.
  std::string
  SceneWriter::equations()
  {
    if (model.equations.empty())
      return "";
    const std::vector<std::string>                                names = names_of_nodes();
    std::vector<std::pair<std::string, std::vector<std::string>>> by_value;
    unsigned int                                                  n_left = 0;
    for (const DeckModel::Equation &equation : model.equations)
      {
        std::vector<std::string> terms, values;
        bool                     is_known = true, is_needed = true;
        for (const DeckModel::EquationTerm &term : equation)
          {
            if (term.factor == 0)
              continue;
            if (!names[term.node].empty())
              {
                const Tensor<1, 3> direction = direction_of(term.node, term.component);
                is_known                     = is_known && std::isfinite(direction.norm()) &&
                           (dim == 3 || std::abs(direction[2]) < 1e-12);
                for (unsigned int d = 0; d < dim; ++d)
                  if (std::abs(direction[d]) > 1e-12)
                    terms.push_back(long_text(term.factor * direction[d]) + " " + names[term.node] +
                                    " " + "xyz"[d]);
              }
            else if (const std::string motion =
                       component_at(model.supports, term.node, term.component, "", -term.factor);
                     !motion.empty())
              {
                nodes_of_values.insert(term.node);
                if (motion != "0" && motion != "-0")
                  values.push_back(motion);
              }
            else if (!defines_only(equation, term))
              is_known = false;
            else
              is_needed = false;
          }
        if (!is_needed)
          continue;
        if (!is_known)
          {
            ++n_left;
            continue;
          }
        if (terms.empty())
          continue;
        const std::string value = values.empty() ? "0" : join(values, " + ");
        const auto        same = std::find_if(by_value.begin(), by_value.end(), [&](const auto &x) {
          return x.first == value;
        });
        (same == by_value.end() ? by_value.emplace_back(value, std::vector<std::string>()) : *same)
          .second.push_back(join(terms));
      }
    if (model.has_linearised_equations && (is_finite_strain || !model.axes_of_nodes.empty()))
      model.skip_item(
        is_finite_strain ?
          "*MPC that follows the motion; equations are those of the undeformed bodies" :
          "*MPC beside *TRANSFORM, whose axes count for it too",
        "",
        "support");
    if (n_left > 0)
      {
        model.skip_item("*EQUATION of " + std::to_string(n_left) +
                          (n_left == 1 ? " line" : " lines") +
                          " with nodes that are on no solid and free",
                        "",
                        "support");
        model.lacks_supports = true;
      }
    std::vector<SceneItem> items;
    SetNames               item_names;
    for (const auto &[value, list] : by_value)
      {
        items.push_back(
          {item_names.make_unique_name("equations"), {{"Equations", join(list, "; \\\n      ")}}});
        if (value != "0")
          items.back().keys.emplace_back("Value", value);
      }
    return section("Constraint equations", items);
  }
} // namespace Signorini
