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
    /// A node, and a component of its displacement (0, 1, 2) or rotation (3, 4, 5).
    using NodeComponent = std::pair<unsigned int, unsigned int>;

    /// A sum of displacements and rotations with factors.
    using Row = std::map<NodeComponent, double>;

    /// Take an unknown out of all rows by the one where its factor is largest, which is removed.
    /// @param least factor that counts as one
    /// @param works likewise, by what acts
    /// @return false if no row determines the unknown, but something acts on it
    bool
    eliminate(const NodeComponent         &unknown,
              const double                 least,
              std::vector<Row>            &rows,
              std::map<unsigned int, Row> &works)
    {
      const auto factor = [&](const Row &row) {
        const auto found = row.find(unknown);
        return found == row.end() ? 0. : found->second;
      };
      const auto   pivot   = std::max_element(rows.begin(), rows.end(), [&](auto &a, auto &b) {
        return std::abs(factor(a)) < std::abs(factor(b));
      });
      const Row    removed = pivot == rows.end() ? Row() : *pivot;
      const double largest = factor(removed);
      const bool   is_determined = std::abs(largest) > least;
      const auto   reduce        = [&](Row &row) {
        if (const double share = factor(row) / largest; is_determined && share != 0)
          for (const auto &[term, value] : removed)
            row[term] -= share * value;
        row.erase(unknown);
      };
      if (is_determined)
        rows.erase(pivot);
      std::for_each(rows.begin(), rows.end(), reduce);
      for (auto &[component, work] : works)
        {
          if (!is_determined && std::abs(factor(work)) > least)
            return false;
          reduce(work);
        }
      return true;
    }



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
  // the equations determine: Gauss-Jordan elimination takes them out of all the others, and out of
  // the work of what acts on them, which is left as that of forces on nodes.
  bool
  SceneWriter::add_coupling_equations(const DeckModel::Coupling &one, const Reference &acting)
  {
    const std::vector<std::string> names = names_of_nodes();
    if (is_finite_strain || !names[one.reference].empty())
      return false;
    const auto motion = [&](const unsigned int q) {
      return q >= 3 && one.rotation ? NodeComponent(*one.rotation, q - 3) :
                                      NodeComponent(one.reference, q);
    };
    const auto is_motion = [&](const NodeComponent &term) {
      return term.first == one.reference || (one.rotation && term.first == *one.rotation);
    };
    // What acts on a component of the motion: formulas; in the plane, there is one moment.
    const auto action = [&](const unsigned int q) {
      return q >= 3 ? acting.moment[dim == 2 ? 0 : q - 3] : acting.force[q];
    };
    const auto exists = [&](const unsigned int q) { return dim == 3 || q < 2 || q == 5; };
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
                row[{node, d}] = e[d];
                row[motion(d)] = -e[d];
              }
            for (unsigned int d = dim == 2 ? 2 : 0; d < 3; ++d)
              row[motion(3 + d)] = -turn[d];
            rows.push_back(row);
          }
    std::map<unsigned int, Row> works; // factors of displacements, by component of the motion
    for (unsigned int q = 0; q < 6; ++q)
      if (exists(q) && action(q) != "0")
        works[q][motion(q)] = 1;
    for (unsigned int q = 0; q < 6; ++q)
      {
        const NodeComponent unknown = motion(q);
        if (!exists(q) ||
            !component_at(model.supports, unknown.first, unknown.second, "", 1).empty())
          continue;
        // Distances of nodes from the reference node are levers.
        if (!eliminate(unknown, q < 3 ? 1e-8 : 1e-8 * mean_distance(one), rows, works))
          return false;
      }
    Forces forces;
    for (const auto &[q, work] : works)
      for (const auto &[term, value] : work)
        if (!is_motion(term) && std::abs(value) > 1e-14)
          forces[term.first][term.second].push_back(long_text(value) + "*(" + action(q) + ")");
    add_forces_on_nodes(as_name(one.name), forces, names);
    for (unsigned int q = 0; q < 6; ++q)
      nodes_in_equations.insert(motion(q).first);
    for (const Row &row : rows)
      {
        double largest = 0;
        for (const auto &[term, value] : row)
          largest = is_motion(term) ? largest : std::max(largest, std::abs(value));
        DeckModel::Equation equation;
        for (const auto &[term, value] : row)
          if (std::abs(value) > 1e-12 * largest || is_motion(term))
            equation.push_back({term.first, term.second, value});
        if (largest > 1e-8)
          model.equations.push_back(equation);
      }
    return true;
  }



  /// Add loads at single nodes.
  void
  SceneWriter::add_forces_on_nodes(const std::string              &of,
                                   const Forces                   &forces,
                                   const std::vector<std::string> &names)
  {
    for (const auto &[node, components] : forces)
      {
        std::vector<std::string> texts;
        for (unsigned int d = 0; d < dim; ++d)
          texts.push_back(components[d].empty() ? "0" : join(components[d], " + "));
        coupled_loads.push_back(
          {"force of " + of, {{"Nodes", names[node]}, {"Force", join(texts, "; ")}}});
      }
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
                nodes_in_equations.insert(term.node);
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
