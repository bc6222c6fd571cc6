// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/formats/keyword_file.h"

#include <unordered_map>

namespace Signorini
{
  /// A set of nodes or of elements with the name as it was first written.
  struct AbaqusSet
  {
    std::string               name;
    std::vector<unsigned int> members; ///< indices, as in MeshFile
  };

  /// The nodes, or the elements, of a file by their numbers, and the sets of them by their names,
  /// in any case. Those of an instance are INSTANCE.NUMBER and INSTANCE.SET. All functions that
  /// take a file throw SceneError with its present line.
  class AbaqusSets
  {
  public:
    /// Let the number in the file stand for the index; false if it stands for another one already.
    bool
    insert(const std::size_t number, const unsigned int index)
    {
      return index_of.insert({number, index}).second;
    }

    /// Index of the node or element; `none` if it is not known. @param instance empty: of none
    unsigned int
    index(std::size_t number, const std::string &instance = "") const;

    static constexpr unsigned int none = -1;

    /// The set of that name, made if there is none.
    AbaqusSet &
    get(const std::string &name);

    /// The set of that name; null if there is none.
    const AbaqusSet *
    find(const std::string &name) const;

    /// By their names in upper case.
    const std::map<std::string, AbaqusSet> &
    all() const
    {
      return sets;
    }

    /// The numbers with their indices, of what is in no instance.
    const std::unordered_map<std::size_t, unsigned int> &
    numbers() const
    {
      return index_of;
    }

    /// Of all nodes, by their instance (in upper case, empty: none) and their number.
    std::map<std::string, std::unordered_map<std::size_t, unsigned int>>
    all_numbers() const;

    /// Append what a word means: a number, or the name of a set; in an instance, if one is named.
    /// False if there is no such thing.
    bool
    append_if_known(const std::string         &word,
                    std::vector<unsigned int> &members,
                    const std::string         &instance = "") const;

    /// The same; throws SceneError if there is no such thing.
    void
    append(const KeywordFile         &in,
           const std::string         &word,
           std::vector<unsigned int> &members,
           const std::string         &instance = "") const;

    /// Append the data lines of a keyword: words, or with GENERATE first, last, step; with
    /// INSTANCE=NAME those of an instance. Returns the words that mean nothing so far, with their
    /// instance.
    std::vector<std::string>
    append_lines(KeywordFile &in, std::vector<unsigned int> &members) const;

    /// Take the numbers and sets of an instance in. Returns false if there is one of that name.
    bool
    add_instance(const std::string &name, const AbaqusSets &of);

  private:
    using Numbers = std::unordered_map<std::size_t, unsigned int>;

    /// Those of the instance, or of none; null if there is no such instance.
    const Numbers *
    numbers_of(const std::string &instance) const;

    /// What there is of first, first + step, ... up to last.
    void
    append_range(std::size_t                first,
                 std::size_t                last,
                 std::size_t                step,
                 const std::string         &instance,
                 std::vector<unsigned int> &members) const;

    std::unordered_map<std::size_t, unsigned int>                        index_of;
    std::map<std::string, AbaqusSet>                                     sets;
    std::map<std::string, std::unordered_map<std::size_t, unsigned int>> instances;
  };

  /// A line of a few words may ask for more nodes, elements or members of sets than any memory
  /// holds: that is refused.
  void
  check_amount(const KeywordFile &in, double number);

  /// The number of a node or element.
  std::size_t
  number_from(const KeywordFile &in, const std::string &word);
} // namespace Signorini
