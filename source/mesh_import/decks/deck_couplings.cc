// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"
#include "mesh_import/decks/scene_text.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <array>

// The part of the reader for couplings.

namespace Signorini
{
  /// @return the index of the node that a parameter of the present keyword names.
  unsigned int
  DeckReader::node_of(const std::string &parameter)
  {
    const std::vector<unsigned int> nodes = nodes_of(in.value(parameter));
    if (nodes.size() != 1)
      in.fail("*" + in.keyword() + ", " + parameter + "=" + in.value(parameter) +
              " is not one node");
    return nodes[0];
  }



  // All nodes of a set, or of the elements of a set, follow the reference node. Nodes of solids
  // have no rotations, so that TIE NSET and PIN NSET of Abaqus are the same.
  void
  DeckReader::read_rigid_body()
  {
    DeckModel::Coupling one;
    one.keyword = "*RIGID BODY";
    for (const char *const set : {"NSET", "TIE NSET", "PIN NSET"})
      if (in.has(set))
        {
          const std::vector<unsigned int> more = nodes_of(in.value(set));
          one.name                             = in.value(set);
          one.nodes.insert(one.nodes.end(), more.begin(), more.end());
        }
    if (in.has("ELSET"))
      {
        one.name = in.value("ELSET");
        for (const unsigned int e : elements_of(one.name))
          one.nodes.insert(one.nodes.end(),
                           model.deck.mesh.elements[e].nodes.begin(),
                           model.deck.mesh.elements[e].nodes.end());
      }
    if (in.has("ANALYTICAL SURFACE"))
      {
        one.name = one.analytical_surface = in.value("ANALYTICAL SURFACE");
        if (model.analytical_surfaces.count(upper_case(one.name)) == 0)
          {
            skip_item("an analytical surface");
            model.lacks_supports = true;
            return;
          }
      }
    one.reference = node_of("REF NODE");
    if (in.has("ROT NODE"))
      one.rotation = node_of("ROT NODE");
    std::sort(one.nodes.begin(), one.nodes.end());
    one.nodes.erase(std::unique(one.nodes.begin(), one.nodes.end()), one.nodes.end());
    model.couplings.push_back(one);
  }



  // Other surfaces are part of the mesh. Data lines of SEGMENTS: START, LINE and CIRCL with
  // coordinates x, y or r, z; of REVOLUTION these after two points of the axis, the origin of z and
  // one in its direction. Outside is on the left of the way. What is left out is said where a rigid
  // body refers to it.
  void
  DeckReader::read_analytical_surface()
  {
    const std::string type = upper_case(in.value("TYPE"));
    if ((type != "SEGMENTS" && type != "REVOLUTION") || in.has("FILLET RADIUS") ||
        !model.deck.instances_of.empty())
      {
        ignore();
        return;
      }
    DeckModel::AnalyticalSurface keys{{"Shape", "profile"}};
    Words                        words;
    if (type == "REVOLUTION")
      {
        in.next_line(words);
        const std::array<double, 3> a = triple(words, 0), b = triple(words, 3);
        std::vector<std::string>    origin, axis;
        for (unsigned int d = 0; d < 3; ++d)
          {
            origin.push_back(long_text(a[d]));
            axis.push_back(long_text(b[d] - a[d]));
          }
        keys.insert(keys.end(),
                    {{"Revolved", "yes"}, {"Origin", join(origin)}, {"Axis", join(axis)}});
      }
    std::vector<std::string> points;
    while (in.next_line(words))
      {
        const std::string        word = upper_case(words[0]);
        const unsigned int       n    = word == "CIRCL" ? 4 : 2;
        std::vector<std::string> numbers;
        if (word != (points.empty() ? "START" : "LINE") && (points.empty() || word != "CIRCL"))
          {
            ignore();
            return;
          }
        for (unsigned int i = 1; i <= n; ++i)
          numbers.push_back(long_text(number(words, i)));
        points.push_back(join(numbers));
      }
    keys.emplace_back("Profile", join(points, "; "));
    model.analytical_surfaces[upper_case(in.value("NAME"))] = keys;
  }



  // *KINEMATIC or *DISTRIBUTING follows.
  void
  DeckReader::begin_coupling()
  {
    coupling            = {};
    coupling.keyword    = "*COUPLING";
    coupling.name       = in.value("SURFACE");
    coupling.is_surface = !model.faces_of(coupling.name).empty();
    if (!coupling.is_surface)
      coupling.nodes = nodes_of(coupling.name);
    coupling.reference = node_of("REF NODE");
    if (in.has("ORIENTATION"))
      {
        // One that is not there, or is defined below, counts as cylindrical: it is reported where
        // it matters.
        const auto found = model.orientations.find(upper_case(in.value("ORIENTATION")));
        coupling.axes =
          found == model.orientations.end() ? DeckModel::Axes{true, {}, {}} : found->second;
      }
  }



  // *KINEMATIC or *DISTRIBUTING. Data lines: first and last component of the surface that take
  // part, from 1; none: all do. Forces of the reference node of *DISTRIBUTING act in any case.
  void
  DeckReader::end_coupling()
  {
    if (coupling.keyword.empty())
      in.fail("*" + in.keyword() + " without *COUPLING above");
    coupling.keyword         = "*" + in.keyword();
    coupling.is_distributing = in.keyword() == "DISTRIBUTING";
    bool is_first            = !coupling.is_distributing;
    for (Words words; in.next_line(words); is_first = false)
      {
        if (is_first)
          coupling.components.fill(false);
        add_components(words, 0, coupling);
      }
    model.couplings.push_back(coupling);
    coupling = {};
  }



  // The first and the last component that take part, from 1; those of rotations do not count, since
  // nodes of solids have none.
  void
  DeckReader::add_components(const Words         &words,
                             const unsigned int   at,
                             DeckModel::Coupling &to) const
  {
    const unsigned int first = component(words, at),
                       last  = words.size() > at + 1 && !words[at + 1].empty() ?
                                 component(words, at + 1) :
                                 first;
    for (unsigned int d = std::max(first, 1u); d <= std::min(last, 3u); ++d)
      to.components[d - 1] = true;
  }



  // Data lines: a node or set, first and last component; none: all of them.
  void
  DeckReader::read_kinematic_coupling()
  {
    const unsigned int reference = node_of("REF NODE");
    if (in.has("ORIENTATION"))
      skip_item("ORIENTATION");
    for (Words words; in.next_line(words);)
      {
        DeckModel::Coupling one;
        one.keyword   = "*KINEMATIC COUPLING";
        one.name      = words[0];
        one.nodes     = nodes_of(words[0]);
        one.reference = reference;
        if (words.size() > 1 && !words[1].empty())
          {
            one.components.fill(false);
            add_components(words, 1, one);
          }
        model.couplings.push_back(one);
      }
  }



  // The reference node is that of the element of a set. Data lines: nodes and their weights, which
  // are left out: the force is distributed over the faces of the nodes.
  void
  DeckReader::read_distributing_coupling()
  {
    DeckModel::Coupling one;
    one.keyword            = "*DISTRIBUTING COUPLING";
    one.is_distributing    = true;
    const Members elements = elements_of(in.value("ELSET"));
    if (elements.size() != 1 || model.deck.mesh.elements[elements[0]].nodes.size() != 1)
      {
        skip_item("whose ELSET is not one element with one node");
        model.lacks_supports = true;
        return;
      }
    one.reference = model.deck.mesh.elements[elements[0]].nodes[0];
    std::set<double> weights;
    for (Words words; in.next_line(words);)
      {
        const std::vector<unsigned int> more = nodes_of(words[0]);
        one.name += (one.name.empty() ? "" : " ") + words[0];
        one.nodes.insert(one.nodes.end(), more.begin(), more.end());
        weights.insert(number(words, 1));
      }
    std::sort(one.nodes.begin(), one.nodes.end());
    one.nodes.erase(std::unique(one.nodes.begin(), one.nodes.end()), one.nodes.end());
    if (weights.size() > 1)
      skip_item("its weights; the force is distributed evenly");
    model.couplings.push_back(one);
  }



  // Data line: the direction of the pretension; none: the normal of the section.
  void
  DeckReader::read_pretension()
  {
    if (!in.has("SURFACE"))
      {
        skip_item("of line elements");
        return;
      }
    Words words;
    in.next_line(words);
    model.pretensions.push_back({in.value("SURFACE"), node_of("NODE"), triple(words, 0)});
  }



  // FIXED: reference nodes keep their motion from the beginning of the present step.
  void
  DeckReader::lock_pretensions()
  {
    bool is_left_out = false;
    for (Words words; in.next_line(words);)
      for (const unsigned int node : nodes_of(words[0]))
        {
          const auto one =
            std::find_if(model.pretensions.begin(),
                         model.pretensions.end(),
                         [&](const auto &section) { return section.reference == node; });
          if (one == model.pretensions.end())
            is_left_out = true;
          else if (!one->lock_time)
            one->lock_time = model.steps.back().begin;
        }
    if (is_left_out)
      {
        skip_item("FIXED");
        model.lacks_supports = true;
      }
  }



  // Add a moment about axis d - 3 (d = 4 to 6) to the reference nodes of a target. Returns false if
  // it has other nodes.
  bool
  DeckReader::adds_moments(const std::string &target, const unsigned int d, const double value)
  {
    const std::vector<unsigned int> nodes = nodes_of(target);
    for (const unsigned int node : nodes)
      if (model.is_reference(node))
        add(model.forces[{node, d - 1}], value);
    return std::all_of(nodes.begin(), nodes.end(), [&](const unsigned int node) {
      return model.is_reference(node);
    });
  }



  // Prescribe rotations first to last (4 to 6) of the reference nodes of a target. Returns false if
  // it has other nodes: they have no rotations.
  bool
  DeckReader::holds_rotations(const std::string &target,
                              const unsigned int first,
                              const unsigned int last,
                              const double       value)
  {
    const std::vector<unsigned int> nodes = nodes_of(target);
    for (const unsigned int node : nodes)
      for (unsigned int d = std::max(first, 4u); d <= std::min(last, 6u); ++d)
        if (model.is_reference(node))
          replace(model.supports[{node, d - 1}], value);
    return std::all_of(nodes.begin(), nodes.end(), [&](const unsigned int node) {
      return model.is_reference(node);
    });
  }
} // namespace Signorini
