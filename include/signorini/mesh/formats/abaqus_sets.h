#pragma once

#include <signorini/mesh/formats/keyword_file.h>

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
  /// in any case. All functions that take a file throw SceneError with its present line.
  class AbaqusSets
  {
  public:
    /// Let the number in the file stand for the index; false if it stands for another one already.
    bool
    insert(const std::size_t number, const unsigned int index)
    {
      return index_of.insert({number, index}).second;
    }

    /// Index of the node or element; `none` if it is not known.
    unsigned int
    index(std::size_t number) const;

    static constexpr unsigned int none = -1;

    /// The set of that name, made if there is none.
    AbaqusSet &
    get(const std::string &name);

    /// By their names in upper case.
    const std::map<std::string, AbaqusSet> &
    all() const
    {
      return sets;
    }

    /// Append what a word means: a number, or the name of a set.
    void
    append(const KeywordFile         &in,
           const std::string         &word,
           std::vector<unsigned int> &members) const;

    /// Append the data lines of a keyword: words, or with GENERATE first, last, step.
    void
    append_lines(KeywordFile &in, std::vector<unsigned int> &members) const;

  private:
    std::unordered_map<std::size_t, unsigned int> index_of;
    std::map<std::string, AbaqusSet>              sets;
  };

  /// The number of a node or element.
  std::size_t
  number_from(const KeywordFile &in, const std::string &word);
} // namespace Signorini
