// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/decks/deck_model.h"

namespace Signorini
{
  /// The different histories of a model, by numbers.
  class Histories
  {
  public:
    /// Refers to the model.
    explicit Histories(const DeckModel &model)
      : model(model)
    {}

    /// The number of a curve's history: the same for all curves that have the same one.
    unsigned int
    number(const DeckModel::Curve &curve);

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

  /// Nodes or elements with the same histories, component by component.
  struct MemberGroup
  {
    static constexpr unsigned int free = -1;

    std::vector<unsigned int>   members;
    std::array<unsigned int, 3> histories{{free, free, free}}; ///< numbers; free: nothing is said
    unsigned int                target;    ///< of the deck that its members belong to
    bool                        is_target; ///< it has all members of that
  };

  /// A line of the deck that names members.
  struct MemberTarget
  {
    std::vector<unsigned int> members;
    std::array<bool, 3>       components;
  };

  /// All members of all targets, with each component once: groups of the targets themselves where
  /// all of their members have the same history, and of those that are left.
  /// @param may_overlap the same history may be said twice of a member, so that targets that are
  /// groups keep all of their members
  std::vector<MemberGroup>
  groups_by_history(const DeckModel::NodeCurves     &curves,
                    const std::vector<MemberTarget> &targets,
                    bool                             may_overlap,
                    Histories                       &histories);

  /// Names that are there already get a number. Decks may name each node of thousands: nothing is
  /// tried twice.
  class SetNames
  {
  public:
    std::string
    make_unique_name(const std::string &name);

  private:
    std::set<std::string>               taken;
    std::map<std::string, unsigned int> next;
  };

  /// One subsection of a section of named items.
  struct SceneItem
  {
    std::string                                      name;
    std::vector<std::pair<std::string, std::string>> keys;
    std::string                                      within = {}; ///< subsections, line by line
  };

  /// "1, 4-7"
  std::string
  as_ranges(std::vector<std::size_t> numbers);
} // namespace Signorini
