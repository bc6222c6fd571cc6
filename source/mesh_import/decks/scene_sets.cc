// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/scene_text.h"
#include "mesh_import/decks/scene_writer.h"
#include "mesh_import/formats/abaqus_elements.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

// Histories as formulas, and the sets that loads and supports refer to.

namespace Signorini
{
  // A constant, a multiple of t, or a table of points.
  std::string
  SceneWriter::formula(const DeckModel::Points &points, const double factor) const
  {
    const auto same = [&](const auto &point) { return point.second == points[0].second; };
    if (std::all_of(points.begin(), points.end(), same))
      return long_text(factor * points[0].second);
    if (points.size() == 2 && points[0].second == 0)
      return long_text(factor * points[1].second) + "*t" +
             (points[1].first == 1 ? "" : "/" + long_text(points[1].first));
    std::vector<std::string> words{"t"};
    for (const auto &[t, y] : points)
      {
        words.push_back(text_of_time(t));
        words.push_back(long_text(factor * y));
      }
    return "table(" + join(words) + ")";
  }



  std::string
  SceneWriter::vector_formula(const MemberGroup &group,
                              const std::string &otherwise,
                              const double       factor) const
  {
    std::vector<std::string> words;
    for (unsigned int d = 0; d < dim; ++d)
      words.push_back(group.histories[d] == MemberGroup::free ?
                        otherwise :
                        formula(histories[group.histories[d]].points, factor));
    return join(words, "; ");
  }



  // Whoever uses a history gets load steps that end at its kinks.
  const DeckModel::History &
  SceneWriter::history(const unsigned int id)
  {
    end_steps_at_kinks(histories[id]);
    return histories[id];
  }



  /// @return whether a group has a history in one of the components of this dimension.
  bool
  SceneWriter::has_content(const MemberGroup &group)
  {
    bool result = false;
    for (unsigned int d = 0; d < dim; ++d)
      if (group.histories[d] != MemberGroup::free)
        {
          history(group.histories[d]);
          result = true;
        }
    return result;
  }



  /// Let load steps end at the kinks of a history, where loads may be largest. Kinks closer to each
  /// other than 1e-6 of a step are one.
  void
  SceneWriter::end_steps_at_kinks(const DeckModel::History &history)
  {
    for (const auto &[t, y] : history.points)
      for (const auto &step : model.steps)
        if (const double little = 1e-6 * (step.end - step.begin);
            t > step.begin + little && t < step.end - little)
          {
            const auto next = kinks.lower_bound(t - little);
            if (next == kinks.end() || *next > t + little)
              kinks.insert(t);
          }
  }



  /// @return the kind of omission of nodes that are on no solid: harmless ("model") if they are
  /// only fixed, otherwise a missing motion or load.
  std::string
  SceneWriter::kind_at_no_solid(const MemberGroup &group, const std::string &what)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (group.histories[d] != MemberGroup::free)
        for (const auto &[t, y] : history(group.histories[d]).points)
          if (y != 0)
            return what == "*CLOAD" ? "load" : "motion";
    return "model";
  }



  /// @return "BODY.SET, ..." of all bodies with nodes of the group; empty if there are none. Where
  /// the deck has no set of just these nodes, sets are added to the bodies.
  std::string
  SceneWriter::nodes_of(const MemberGroup &group,
                        const std::string &target,
                        const std::string &what)
  {
    std::vector<std::string> result;
    std::set<unsigned int>   unassigned(group.members.begin(), group.members.end());
    const std::string        name =
      group.is_target ? target : set_names.make_unique_name(as_name(target) + " part");
    for (Body &body : all)
      {
        // The members of the group on this body.
        std::set<unsigned int> here;
        for (const unsigned int node : group.members)
          if (body.has_node[node])
            {
              here.insert(node);
              unassigned.erase(node);
            }
        if (here.empty())
          continue;
        result.push_back(body.name + "." + name);
        if (group.is_target)
          continue;
        // The set as ranges of node numbers, instance by instance.
        std::vector<std::string> ranges;
        for (const auto &[instance, numbers] : model.deck.mesh.numbers)
          {
            std::vector<std::size_t> of_instance;
            for (const auto &[number, node] : numbers)
              if (here.erase(node) > 0)
                of_instance.push_back(number);
            for (const std::string &range : split(as_ranges(of_instance), ','))
              ranges.push_back((instance.empty() ? "" : instance + ".") + trim(range));
          }
        body.node_sets.push_back(name + ": " + join(ranges));
      }
    if (!unassigned.empty())
      model.skip_item(what + " at " + std::to_string(unassigned.size()) + " nodes of " + target +
                        " that are on no solid",
                      "",
                      kind_at_no_solid(group, what));
    return join(result);
  }



  /// @return "BODY.SURFACE, ..." of all bodies that have faces of a surface; empty, with a report,
  /// if there are none.
  std::string
  SceneWriter::surfaces(const std::string &surface, const std::string &what)
  {
    // A set of nodes may have the same name, in other case.
    bool has_faces = false;
    for (const auto &group : model.deck.mesh.groups)
      has_faces |= upper_case(group.name) == upper_case(surface) && !group.faces.empty();
    std::set<std::string> of_faces;
    for (const auto &group : model.deck.mesh.groups)
      if (!has_faces || !group.faces.empty())
        of_faces.insert(group.name);
    std::vector<std::string> result;
    for (const Body &body : all)
      for (const std::string &boundary : body.boundaries)
        if (upper_case(boundary) == upper_case(surface) && of_faces.count(boundary) > 0)
          result.push_back(body.name + "." + boundary);
    if (result.empty() && !is_removed(surface))
      model.skip_item(what + " on '" + surface + "', which has no whole face of a solid",
                      "",
                      what == "a pressure" ? "load" : "pair");
    return join(result);
  }



  /// @return whether a surface has faces, all of them on elements that the deck removes for good.
  bool
  SceneWriter::is_removed(const std::string &surface) const
  {
    const MeshFile                 &mesh  = model.deck.mesh;
    const std::set<DeckModel::Face> faces = model.faces_of(surface);
    return !faces.empty() && std::all_of(faces.begin(), faces.end(), [&](const auto &face) {
      return std::any_of(model.deck.removed_elements.begin(),
                         model.deck.removed_elements.end(),
                         [&](const unsigned int e) {
                           const auto &nodes = mesh.elements[e].nodes;
                           return std::all_of(face.begin(), face.end(), [&](const auto node) {
                             return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
                           });
                         });
    });
  }



  /// @return the thickness [length] of the plane body at these nodes, by which forces are divided;
  /// 1 in other dimensions.
  double
  SceneWriter::thickness_at(const std::vector<unsigned int> &nodes) const
  {
    double thickness = 1;
    for (const Body &body : all)
      for (const unsigned int node : nodes)
        if (body.has_node[node])
          thickness = body.thickness;
    return dim == 2 ? thickness : 1;
  }



  bool
  SceneWriter::is_a_node(const DeckModel::AtNodes &at) const
  {
    return at.nodes.size() == 1 && !model.deck.nodes.find(at.name);
  }



  /// @return "BODY.SET, ..." of a new set of faces, which is added to the bodies by numbers of
  /// elements and labels.
  std::string
  SceneWriter::faces_of(const std::vector<DeckModel::Face> &faces, const std::string &name)
  {
    const MeshFile                 &mesh = model.deck.mesh;
    const std::set<DeckModel::Face> wanted(faces.begin(), faces.end());
    std::vector<std::string>        result;
    for (Body &body : all)
      {
        // The faces as ranges of element numbers, label by label.
        std::map<std::string, std::vector<std::size_t>> by_label;
        for (unsigned int e = 0; e < mesh.elements.size(); ++e)
          if (body.has_element[e])
            for (const std::string label : {"S1", "S2", "S3", "S4", "S5", "S6"})
              for (DeckModel::Face face : abaqus_faces(mesh.elements[e], label))
                {
                  std::sort(face.begin(), face.end());
                  if (wanted.count(face) > 0)
                    by_label[label].push_back(mesh.elements[e].number);
                }
        std::vector<std::string> ranges;
        for (const auto &[label, numbers] : by_label)
          for (const std::string &range : split(as_ranges(numbers), ','))
            ranges.push_back(trim(range) + "." + label);
        if (ranges.empty())
          continue;
        body.face_sets.push_back(name + ": " + join(ranges));
        result.push_back(body.name + "." + name);
      }
    return join(result);
  }



  /// @return "BODY" or "BODY.SET, ..." of some elements; a set of cells is added to bodies that
  /// contain more elements.
  std::string
  SceneWriter::cells_of(const std::vector<unsigned int> &elements, const std::string &name)
  {
    std::vector<std::string> result;
    std::string              set;
    for (Body &body : all)
      {
        std::vector<std::size_t> numbers;
        for (const unsigned int e : elements)
          if (body.has_element[e])
            numbers.push_back(model.deck.mesh.elements[e].number);
        if (numbers.empty())
          continue;
        if (numbers.size() == static_cast<std::size_t>(
                                std::count(body.has_element.begin(), body.has_element.end(), true)))
          {
            result.push_back(body.name);
            continue;
          }
        if (set.empty())
          set = set_names.make_unique_name(as_name(name) + " part");
        body.cell_sets.push_back(set + ": " + as_ranges(numbers));
        result.push_back(body.name + "." + set);
      }
    return join(result);
  }
} // namespace Signorini
