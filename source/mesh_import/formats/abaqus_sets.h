// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/formats/keyword_file.h"

#include <unordered_map>

namespace Signorini
{
  /// A set of nodes or of elements.
  struct AbaqusSet
  {
    /// Name in the case of letters in which it was written first.
    std::string name;
    /// Indices as in MeshFile, possibly repeated.
    std::vector<unsigned int> members;
  };

  /// The numbers and named sets of the nodes, or of the elements, of a file. Names are compared in
  /// upper case. Those of an instance are INSTANCE.NUMBER and INSTANCE.SET. All functions that have
  /// an argument of type KeywordFile throw SceneError with its present line.
  class AbaqusSets
  {
  public:
    /// Assign a number of the file to an index.
    /// @return false if the number is assigned already, which is then not changed
    /// @param number in the file
    /// @param index as in MeshFile
    bool
    insert(const std::size_t number, const unsigned int index)
    {
      return index_of.insert({number, index}).second;
    }

    /// @return the index of a node or element; `none` if there is no such number.
    /// @param number in the file
    /// @param instance name of the instance; empty: outside of instances
    unsigned int
    index(std::size_t number, const std::string &instance = "") const;

    static constexpr unsigned int none = -1;

    /// @return the set of a name, which is created if there is none.
    /// @param name in any case
    AbaqusSet &
    get(const std::string &name);

    /// @return the set of a name; null if there is none.
    /// @param name in any case
    const AbaqusSet *
    find(const std::string &name) const;

    /// @return all sets, by their names in upper case.
    const std::map<std::string, AbaqusSet> &
    all() const
    {
      return sets;
    }

    /// @return the indices by number, without those of instances.
    const std::unordered_map<std::size_t, unsigned int> &
    numbers() const
    {
      return index_of;
    }

    /// @return the indices by instance (in upper case, empty: none) and number.
    std::map<std::string, std::unordered_map<std::size_t, unsigned int>>
    all_numbers() const;

    /// Append what a word refers to: a number, or the name of a set.
    /// @param word the number or name
    /// @param members to which indices are appended
    /// @param instance in which it is looked up; empty: outside of instances
    /// @return false if there is no such number or set
    bool
    append_if_known(const std::string         &word,
                    std::vector<unsigned int> &members,
                    const std::string         &instance = "") const;

    /// Append what a word refers to, as append_if_known() does; throws SceneError if there is no
    /// such number or set. An empty word is ignored.
    /// @param in the file, for messages
    /// @param word the number or name
    /// @param members to which indices are appended
    /// @param instance in which it is looked up; empty: outside of instances
    void
    append(const KeywordFile         &in,
           const std::string         &word,
           std::vector<unsigned int> &members,
           const std::string         &instance = "") const;

    /// Append the members in the data lines of a keyword: words, or with GENERATE first, last,
    /// step; with INSTANCE=NAME those of an instance.
    /// @param in the file, at the keyword
    /// @param members to which indices are appended
    /// @return the words that are not known so far, with their instance
    std::vector<std::string>
    append_lines(KeywordFile &in, std::vector<unsigned int> &members) const;

    /// Add the numbers and sets of an instance.
    /// @param name of the instance
    /// @param of its numbers and sets
    /// @return false if there is an instance of that name already
    bool
    add_instance(const std::string &name, const AbaqusSets &of);

  private:
    using Numbers = std::unordered_map<std::size_t, unsigned int>;

    /// @return the numbers of an instance, or of none; null if there is no such instance.
    const Numbers *
    numbers_of(const std::string &instance) const;

    /// Append all existing numbers among first, first + step, ... up to last.
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

  /// Throws SceneError if a line would create more nodes, elements or members of sets than the
  /// memory of the machine can hold.
  /// @param in the file, for the message
  /// @param number how many there would be
  void
  check_amount(const KeywordFile &in, double number);

  /// @return the number of a node or element. Throws SceneError with the present line if the word
  /// is none.
  /// @param in the file, for the message
  /// @param word digits
  std::size_t
  number_from(const KeywordFile &in, const std::string &word);
} // namespace Signorini
