// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cctype>

// The part of the reader for supports.

namespace Signorini
{
  // Prescribe displacement components (0, 1, 2) of the nodes of a target.
  // The mask of components belongs to the target as a whole, over all steps; the values are stored
  // node by node, because later keywords may name the same nodes by other sets.
  void
  DeckReader::hold(const std::string               &target,
                   const std::vector<unsigned int> &components,
                   const double                     value)
  {
    if (DeckModel::AtNodes *nodes = at_nodes(model.supported, target))
      for (const unsigned int d : components)
        {
          nodes->components[d] = true;
          for (const unsigned int node : nodes->nodes)
            replace(model.supports[{node, d}], value);
        }
  }



  /// @return whether the values of *BOUNDARY are displacements or constant velocities; others are
  /// reported.
  bool
  DeckReader::accepts_type()
  {
    const std::string type = upper_case(in.value("TYPE"));
    if (type.empty() || type == "DISPLACEMENT" || (type == "VELOCITY" && !in.has("AMPLITUDE")))
      return true;
    skip_item("its TYPE=" + type + (in.has("AMPLITUDE") ? " with an amplitude" : ""));
    model.lacks_supports = true;
    return false;
  }



  // Data lines: node or set, first component, last component, value; or node or set, type.
  void
  DeckReader::read_boundary()
  {
    if (!counts())
      return;
    if (removes_old("BOUNDARY"))
      for (auto &[where, curve] : model.supports)
        remove_old(curve);
    if (in.has("FIXED") && in_step)
      {
        lock_pretensions();
        return;
      }
    // The values of these supports are not in the deck: they are the displacements reached before,
    // or come from a user routine or another computation.
    for (const std::string type : {"FIXED", "USER", "SUBMODEL"})
      if (in.has(type))
        {
          skip_item(type);
          model.lacks_supports = true;
          return;
        }
    check_parameters({"OP", "AMPLITUDE", "TYPE"});
    if (!accepts_type())
      return;
    for (Words words; in.next_line(words);)
      {
        // The second word is either a component number or the name of a type.
        if (words.size() > 1 && !words[1].empty() && !std::isdigit(words[1][0]))
          {
            add_symmetry(words[0], upper_case(words[1]));
            continue;
          }
        // Components 1 to 3 are displacements, 4 to 6 rotations, others are of other physics. Nodes
        // of solids have no rotations: ranges such as 1 to 6 with zero hold their displacements.
        const unsigned int first = component(words, 1),
                           last =
                             words.size() > 2 && !words[2].empty() ? component(words, 2) : first;
        if (last > 6)
          skip_item("of temperatures, fluxes and the like");
        else if (last > 3 && !holds_rotations(words[0], first, last, number(words, 3)) &&
                 (first > 3 || number(words, 3) != 0))
          model.skip_item("*BOUNDARY of rotations", in.current_position());
        if (last < first)
          skip_item("whose last component is below the first");
        if (first < 1 || first > 3)
          continue;
        std::vector<unsigned int> components;
        for (unsigned int d = first; d <= std::min(last, 3u); ++d)
          components.push_back(d - 1);
        hold(words[0], components, number(words, 3));
      }
  }



  // The named types of *BOUNDARY: which components are zero.
  // Rotations that these types fix as well do not exist in solids. Antisymmetry with respect to a
  // plane fixes the two displacements in that plane.
  void
  DeckReader::add_symmetry(const std::string &target, const std::string &kind)
  {
    static const std::map<std::string, std::vector<unsigned int>> held  = {{"XSYMM", {0}},
                                                                           {"YSYMM", {1}},
                                                                           {"ZSYMM", {2}},
                                                                           {"PINNED", {0, 1, 2}},
                                                                           {"ENCASTRE", {0, 1, 2}},
                                                                           {"XASYMM", {1, 2}},
                                                                           {"YASYMM", {0, 2}},
                                                                           {"ZASYMM", {0, 1}}};
    const auto                                                    found = held.find(kind);
    if (found == held.end())
      {
        skip_item("type " + kind);
        model.lacks_supports = true;
      }
    else
      hold(target, found->second, 0.);
  }



  // Data line: two vectors (TYPE=R), or two points of the axis (TYPE=C).
  void
  DeckReader::read_transform()
  {
    Members nodes;
    model.deck.nodes.append(in, in.value("NSET"), nodes);
    // What was prescribed above refers to the global axes. Nodes that are fixed in all of them may
    // get others, in which they are fixed as well.
    const auto is_fixed = [&](const unsigned int node) {
      bool result = true;
      for (unsigned int d = 0; d < 3; ++d)
        {
          const auto curve = model.supports.find({node, d});
          result &= curve != model.supports.end() && curve->second.size() == 1 &&
                    curve->second[0].value == 0;
        }
      return result;
    };
    for (const unsigned int node : nodes)
      for (unsigned int d = 0; d < 3; ++d)
        if ((model.supports.count({node, d}) > 0 && !is_fixed(node)) ||
            model.forces.count({node, d}) > 0)
          in.fail("*TRANSFORM of nodes that have *BOUNDARY or *CLOAD above; put it before these");
    const std::string type = upper_case(in.value("TYPE"));
    if (!type.empty() && type != "R" && type != "C")
      in.fail("*TRANSFORM, TYPE=" + type + " is not available: R or C");
    Words words;
    if (!in.next_line(words) || words.size() < 6)
      in.fail("*TRANSFORM needs six numbers");
    model.axes.push_back({type == "C", triple(words, 0), triple(words, 3)});
    for (const unsigned int node : nodes)
      model.axes_of_nodes[node] = model.axes.size() - 1;
  }



  // Data line: two vectors (rectangular), or two points of the axis (cylindrical). Materials are
  // isotropic, so that couplings alone have an orientation. A further line rotates the axes.
  void
  DeckReader::read_orientation()
  {
    const std::string system = upper_case(in.value("SYSTEM"));
    Words             words, more;
    if ((!system.empty() && system != "RECTANGULAR" && system != "CYLINDRICAL") ||
        !in.next_line(words) || words.size() < 6 || (in.next_line(more) && number(more, 1) != 0))
      {
        skip_item("other than by six numbers, rectangular or cylindrical");
        model.lacks_supports = true;
        return;
      }
    model.orientations[upper_case(in.value("NAME"))] = {system == "CYLINDRICAL",
                                                        triple(words, 0),
                                                        triple(words, 3)};
  }



  /// @return the axes of the first of some nodes; none: the global ones.
  std::optional<unsigned int>
  DeckReader::axes_of(const std::vector<unsigned int> &nodes) const
  {
    const auto end   = model.axes_of_nodes.end(),
               found = nodes.empty() ? end : model.axes_of_nodes.find(nodes[0]);
    return found == end ? std::nullopt : std::optional<unsigned int>(found->second);
  }
} // namespace Signorini
