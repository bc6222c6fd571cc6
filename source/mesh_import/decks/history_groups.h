// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/decks/deck_model.h"

namespace Signorini
{
  /// The different histories of a model, numbered from 0.
  class Histories
  {
  public:
    /// @param model to which the object refers
    explicit Histories(const DeckModel &model)
      : model(model)
    {}

    /// @return the number of the history of a curve, which is the same for all curves with equal
    /// histories.
    /// @param curve the changes of a value
    unsigned int
    number(const DeckModel::Curve &curve);

    /// @return a history; valid until the next call of number().
    /// @param number of the history
    const DeckModel::History &
    operator[](const unsigned int number) const
    {
      return all[number];
    }

  private:
    const DeckModel                         &model;
    std::vector<DeckModel::History>          all;
    std::map<DeckModel::Curve, unsigned int> of_curves;
  };

  /// Nodes or elements with equal histories in each component.
  struct MemberGroup
  {
    static constexpr unsigned int free = -1;

    std::vector<unsigned int> members;
    /// Number of the history of each component; `free`: not prescribed.
    std::array<unsigned int, 3> histories{{free, free, free}};
    /// Index of the target of the deck to which the members belong.
    unsigned int target;
    /// Whether the group has all members of the target.
    bool is_target;
  };

  /// A node or element set of the deck with supports or loads, and the components that they have.
  struct MemberTarget
  {
    std::vector<unsigned int> members;
    std::array<bool, 3>       components;
  };

  /// Group the members of all targets such that each member occurs once for each component: targets
  /// whose members all have equal histories are one group, others are divided.
  /// @param curves by member and component
  /// @param targets in the order of the deck
  /// @param may_overlap whether the same history may be prescribed for a member twice (supports,
  /// not forces), so that targets keep all of their members
  /// @param histories the numbers of histories, to which new ones are added
  /// @return the groups
  std::vector<MemberGroup>
  groups_by_history(const DeckModel::NodeCurves     &curves,
                    const std::vector<MemberTarget> &targets,
                    bool                             may_overlap,
                    Histories                       &histories);

  /// Creates unique names: a name that exists already gets a number. The next number of each name
  /// is kept, since decks may name thousands of nodes one by one.
  class SetNames
  {
  public:
    /// @return the name itself, or with a number that makes it unique.
    /// @param name any name
    std::string
    make_unique_name(const std::string &name);

  private:
    std::set<std::string>               taken;
    std::map<std::string, unsigned int> next;
  };

  /// A subsection of a scene in a section of named items.
  struct SceneItem
  {
    std::string                                      name;
    std::vector<std::pair<std::string, std::string>> keys;
    /// Inner subsections as text.
    std::string within = {};
  };

  /// @return numbers as a text with ranges, "1, 4-7".
  /// @param numbers in any order
  std::string
  as_ranges(std::vector<std::size_t> numbers);
} // namespace Signorini
