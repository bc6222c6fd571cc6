// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

// The part of the reader for the nodes and elements that data lines name, and for the values that
// they get from step to step.

namespace Signorini
{
  /// @return whether the present keyword is part of the model or of a step that is computed;
  /// otherwise it is reported.
  bool
  DeckReader::counts()
  {
    const bool result = !in_step || step_counts;
    if (!result)
      skip_item("in a step that is left out");
    return result;
  }



  // Parameters other than the known ones are reported, and references to amplitudes that do not
  // exist.
  // A load whose amplitude is unknown is kept and ramped instead of being dropped, since a missing
  // load would change the answer more than another course in time.
  void
  DeckReader::check_parameters(const std::set<std::string> &known)
  {
    for (const auto &[name, value] : in.all_parameters())
      if (known.count(name) == 0)
        skip_item("its " + name);
    const std::string amplitude = in.value("AMPLITUDE");
    if (!amplitude.empty() && model.amplitudes.count(upper_case(amplitude)) == 0)
      skip_item("its AMPLITUDE=" + amplitude + ", which is not there above; values are ramped");
  }



  // The value of the present step, with the amplitude and type of the present keyword.
  DeckModel::Change
  DeckReader::change_to(const double value) const
  {
    const bool is_velocity = upper_case(in.value("TYPE")) == "VELOCITY";
    return {present_step(),
            value,
            upper_case(in.value("AMPLITUDE")),
            is_velocity ? DeckModel::Change::Kind::velocity : DeckModel::Change::Kind::value};
  }



  /// Set the value of the present step; the last of several lines is valid.
  /// The entries of a curve are in the order of the steps with at most one entry for each, so that
  /// only its last entry has to be compared.
  void
  DeckReader::replace(Curve &curve, const double value) const
  {
    // Entries of earlier steps stay: they are the values from which this step begins.
    if (!curve.empty() && curve.back().step == present_step())
      curve.pop_back();
    curve.push_back(change_to(value));
  }



  /// Add to the value of the present step: several lines of one step add up, and replace those of
  /// earlier steps. Throws SceneError if their amplitudes differ.
  void
  DeckReader::add(Curve &curve, const double value) const
  {
    const DeckModel::Change change = change_to(value);
    if (curve.empty() || curve.back().step < change.step ||
        curve.back().kind == DeckModel::Change::Kind::removed)
      replace(curve, value);
    // A curve has one amplitude in each step; the sum of two courses in time could not be expressed
    // by it.
    else if (curve.back().amplitude != change.amplitude)
      in.fail("loads of different amplitudes at one place in one step; CalculiX refuses them, and "
              "so does this program");
    else
      curve.back().value += value;
  }



  /// @return whether the present keyword is the first of its kind in this step and has OP=NEW,
  /// which removes all loads (supports) of earlier steps.
  bool
  DeckReader::removes_old(const std::string &kind)
  {
    // The kind is inserted in any case, also without OP=NEW: only the first keyword of a kind in a
    // step decides, and later ones add to it. Loads of the model before all steps have nothing that
    // they could remove.
    return reported_kinds.insert(kind).second && in_step && upper_case(in.value("OP")) == "NEW";
  }



  // A value from an earlier step ends at the beginning of the present one.
  void
  DeckReader::remove_old(Curve &curve) const
  {
    // Values of the present step are those that follow OP=NEW and stay; a second removal would be
    // without effect.
    if (curve.back().step < present_step() && curve.back().kind != DeckModel::Change::Kind::removed)
      curve.push_back({present_step(), 0., "", DeckModel::Change::Kind::removed});
  }



  /// @return a component of displacement or force, counted from 1; out of range if the number is no
  /// component.
  unsigned int
  DeckReader::component(const Words &words, const unsigned int i) const
  {
    // The value is limited before the conversion to an integer, which is undefined for negative and
    // for very large numbers. All callers reject numbers that are out of the range of components.
    return std::clamp(number(words, i), 0., 1000.);
  }



  /// @return the nodes of a number or set, each once, in ascending order. Throws SceneError if
  /// there are none of that name.
  std::vector<unsigned int>
  DeckReader::nodes_of(const std::string &target)
  {
    if (target.empty())
      in.fail("*" + in.keyword() + " without the name of a node or set");
    std::vector<unsigned int> nodes;
    model.deck.nodes.append(in, target, nodes);
    // Repetitions matter for forces alone, which would be added; prescribed values and temperatures
    // are the same however often they are set.
    if (in.keyword() == "CLOAD")
      skip_repetitions(target, nodes);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }



  /// @return the elements of a number or set, as often as the deck names them; all elements without
  /// a target.
  DeckReader::Members
  DeckReader::elements_of(const std::string &target)
  {
    Members elements;
    if (target.empty())
      for (unsigned int e = 0; e < model.deck.mesh.elements.size(); ++e)
        elements.push_back(e);
    else
      model.deck.elements.append(in, target, elements);
    skip_repetitions(target, elements);
    return elements;
  }



  /// Report members that a set contains twice. CalculiX applies loads to them twice, Abaqus and
  /// this program once.
  void
  DeckReader::skip_repetitions(const std::string &target, Members members)
  {
    // Equal members are neighbours after sorting; `members` is a copy, so that the order of the set
    // itself is not changed.
    std::sort(members.begin(), members.end());
    if (std::adjacent_find(members.begin(), members.end()) != members.end())
      skip_item("on " + target +
                ", which names members twice: each is loaded once, as in Abaqus, "
                "but not in CalculiX");
  }



  /// @return the entry of a node or set in a list, which is created if there is none; null, with a
  /// report, if it has the reference node of a coupling with other axes (*TRANSFORM). The pointer
  /// is valid until the next call. Lists are searched by name in upper case, as names in decks do
  /// not distinguish case; the map `places` makes this search independent of the number of entries.
  DeckModel::AtNodes *
  DeckReader::at_nodes(std::vector<DeckModel::AtNodes> &list, const std::string &target)
  {
    const std::string upper = upper_case(target);
    const auto        known = places.find({&list, upper});
    if (known != places.end())
      {
        if (list[known->second].axes != axes_of(list[known->second].nodes))
          in.fail("'" + target + "' is named before and after its *TRANSFORM; put that before");
        return &list[known->second];
      }
    DeckModel::AtNodes one;
    const AbaqusSet   *set = model.deck.nodes.find(target);
    one.name               = set ? set->name : target;
    one.nodes              = nodes_of(target);
    // A target of digits would be ambiguous: the node of that number, or the set of that name.
    if (set && target.find_first_not_of("0123456789") == std::string::npos)
      in.fail("a set of nodes is called as a number: " + target + "; give it another name");
    // The components of reference nodes are those of obstacles, along the global axes.
    one.axes = axes_of(one.nodes);
    for (const unsigned int node : one.nodes)
      if (axes_of({node}) != one.axes || (one.axes && model.is_reference(node)))
        {
          skip_item(axes_of({node}) != one.axes ?
                      "on nodes with the axes of different *TRANSFORM" :
                      "on a reference node whose axes *TRANSFORM turns");
          model.lacks_supports |= in.keyword() == "BOUNDARY";
          return nullptr;
        }
    places[{&list, upper}] = list.size();
    list.push_back(one);
    return &list.back();
  }
} // namespace Signorini
