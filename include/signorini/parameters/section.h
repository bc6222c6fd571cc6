// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/choices.h>
#include <signorini/parameters/expression.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/point.h>

#include <deque>
#include <iosfwd>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace Signorini
{
  /// The description of a key, for documentation.
  struct KeyDescription
  {
    std::string key, type, value, help, range;
    /// Words that are possible; empty: any value of the type.
    std::vector<std::string> choices;
    /// Whether the key has no default.
    bool is_required = false;
  };

  /// A former name, which scenes may use for one release, and its present one.
  struct FormerName
  {
    enum class Kind
    {
      key,
      section,
      choice
    };

    Kind        kind;
    std::string former, now;
    /// For choices: the key.
    std::string key;
  };

  /// The description of a section. Sections of items that the user names occur once, with the name
  /// NAME.
  struct SectionDescription
  {
    std::string                    name, help;
    std::vector<KeyDescription>    keys;
    std::deque<SectionDescription> sections;
    std::vector<FormerName>        former_names = {};
  };

  /// A range of numbers, in which both ends may or may not be allowed.
  struct Range
  {
    double low            = -std::numeric_limits<double>::infinity();
    double high           = std::numeric_limits<double>::infinity();
    bool   low_is_allowed = true, high_is_allowed = true;

    /// @return whether a number is in the range.
    /// @param x the number
    bool
    contains(double x) const;
    /// @return a text for messages, such as ">= 0 and < 1".
    std::string
    text() const;
  };

  const Range positive{0, std::numeric_limits<double>::infinity(), false, true};
  const Range non_negative{0, std::numeric_limits<double>::infinity(), true, true};

  /// A section of a scene file, to which structs bind their members. Each struct has a function
  /// `declare(Section &)` that calls add() for each key: name, member (whose value is the default),
  /// and one sentence of documentation with the unit. The same function serves to read a scene, to
  /// write it with all defaults, to write the commented template, and to describe all keys for the
  /// reference.
  class Section
  {
  public:
    /// Read: values in `raw` overwrite the members; members of keys that are not set keep their
    /// defaults.
    /// @param raw the section of the file, in which used values are marked
    /// @param path of the section, for messages
    explicit Section(RawSection &raw, const std::string &path = "");

    /// Write.
    /// @param out the stream
    /// @param comments whether the documentation of each key is added
    /// @param indentation depth of the section
    /// @param given what was read: numbers are written as the formulas there; null: none
    Section(std::ostream     &out,
            bool              comments,
            unsigned int      indentation = 0,
            const RawSection *given       = nullptr);

    /// Describe.
    /// @param description receives all keys and sections
    explicit Section(SectionDescription &description)
      : description(&description)
    {}

    /// Bind a key. Throws SceneError if its value is not of the type, or not in the range.
    /// @param key its name
    /// @param value the member
    /// @param help one sentence, which ends with the unit in brackets
    /// @param range of the value
    template <typename T>
    void
    add(const std::string &key, T &value, const std::string &help, const Range &range = {});

    /// Bind a key without default. Throws SceneError if it is not set.
    /// @param key its name
    /// @param value the member
    /// @param help one sentence, which ends with the unit in brackets
    /// @param range of the value
    template <typename T>
    void
    add_required(const std::string &key, T &value, const std::string &help, const Range &range = {})
    {
      add(key, value, out ? help + "; required" : help, range);
      if (description)
        description->keys.back().is_required = true;
      if (reading() && !is_set(key))
        fail(key, "is required (" + help + ")");
    }

    /// Bind a key on whose default a scene should not rely: if it is not set, the user is told
    /// which value is used.
    /// @param key its name
    /// @param value the member
    /// @param help one sentence
    template <typename T>
    void
    add_noted(const std::string &key, T &value, const std::string &help)
    {
      add(key, value, help);
      if (reading() && !is_set(key))
        note_default(key, text_of(value));
    }

    /// @return when reading, whether the scene sets a key.
    /// @param key its name
    bool
    is_set(const std::string &key) const
    {
      return raw && raw->find_value(key);
    }

    /// Declare the former name of a key, before the key is added. A scene that uses it is read as
    /// if it had the present one, and the user is told so; a scene that sets both is rejected,
    /// except that the command line overrides a file.
    /// @param former name in the last release
    /// @param key present name
    void
    rename_key(const std::string &former, const std::string &key);

    /// Declare the former name of a subsection, as rename_key() does.
    /// @param former name in the last release
    /// @param name present name
    void
    rename_section(const std::string &former, const std::string &name);

    /// Declare the former name of a choice, as rename_key() does.
    /// @param key the key
    /// @param former word in the last release
    /// @param choice present word
    void
    rename_choice(const std::string &key, const std::string &former, const std::string &choice);

    /// @return when reading, the messages for the user so far, from this section and those in it,
    /// each once.
    const std::vector<std::string> &
    notes() const
    {
      return *my_notes;
    }

    /// Add a message when reading.
    /// @param where file and line, which may differ for equal messages
    /// @param text the message
    void
    add_note(const std::string &where, const std::string &text);

    /// Bind a key that has one of some words. Throws SceneError for others.
    /// @param key its name
    /// @param value the member
    /// @param choices the words
    /// @param help one sentence
    void
    add_choice(const std::string              &key,
               std::string                    &value,
               const std::vector<std::string> &choices,
               const std::string              &help);

    /// Bind a key that has one of some words, which denote values. Throws SceneError for others.
    /// @param key its name
    /// @param value the member
    /// @param choices the words with their values
    /// @param help one sentence
    template <typename Value, typename = std::enable_if_t<!std::is_same_v<Value, std::string>>>
    void
    add_choice(const std::string    &key,
               Value                &value,
               const Choices<Value> &choices,
               const std::string    &help)
    {
      std::string word = word_of(choices, value);
      add_choice(key, word, words_of(choices), help);
      value = value_of(choices, word);
    }

    /// Declare a subsection.
    /// @param name of the subsection
    /// @param help one sentence
    /// @param body function that declares the keys of a Section
    template <typename Body>
    void
    add_section(const std::string &name, const std::string &help, Body body)
    {
      if (reading())
        {
          RawSection  nothing;
          RawSection *child = open(name);
          Section     section(child ? *child : nothing, path_of(name));
          section.definitions = definitions;
          section.my_notes    = my_notes;
          body(section);
          section.close();
        }
      else if (description)
        {
          description->sections.push_back({name, help, {}, {}});
          Section section(description->sections.back());
          body(section);
        }
      else
        {
          Section section = begin(name, help);
          body(section);
          end();
        }
    }

    /// Bind a section of items that the user names: the key Names, and one subsection for each
    /// name. T has a member `std::string name` and a function declare(Section &).
    /// @param name of the section
    /// @param items the members
    /// @param help one sentence
    template <typename T>
    void
    add_named(const std::string &name, std::vector<T> &items, const std::string &help)
    {
      add_section(name, help, [&](Section &list) {
        std::vector<std::string> names;
        for (const T &item : items)
          names.push_back(item.name);
        list.add("Names", names, "the names, separated by commas; each has its subsection");
        if (list.reading())
          {
            list.check_names(names);
            items.clear();
            items.resize(names.size());
            for (unsigned int i = 0; i < names.size(); ++i)
              items[i].name = names[i];
          }
        if (list.description && items.empty())
          {
            T item;
            list.add_section("NAME", "", [&](Section &s) { item.declare(s); });
          }
        for (T &item : items)
          list.add_section(item.name, "", [&](Section &s) { item.declare(s); });
      });
    }

    /// Declare a subsection whose keys are defined by the user: names that stand for formulas in
    /// later sections.
    /// @param name of the subsection
    /// @param value the definitions
    /// @param help one sentence
    void
    add_definitions(const std::string &name, Definitions &value, const std::string &help);

    /// @return whether a name stands for a formula.
    /// @param name the name
    bool
    defines(const std::string &name) const;

    /// @return whether the section is read.
    bool
    reading() const
    {
      return raw != nullptr;
    }

    /// @return when reading, where and how a key was set, for messages: "scene.prm:12:
    /// Bodies/block/Mesh = ball".
    /// @param key its name
    std::string
    source_of(const std::string &key) const;

    /// Throws SceneError with the position of a key.
    /// @param key its name
    /// @param what the message
    [[noreturn]] void
    fail(const std::string &key, const std::string &what) const;

    /// @return the path of the section, such as "Bodies/block".
    const std::string &
    path() const
    {
      return my_path;
    }

    /// Throws SceneError for keys and subsections in the file that were not declared. At the end of
    /// reading a section.
    void
    close();

  private:
    std::string
    path_of(const std::string &name) const;
    RawSection *
    open(const std::string &name);
    Section
    begin(const std::string &name, const std::string &help);
    void
    end();
    void
    check_names(const std::vector<std::string> &names) const;
    template <typename T>
    static std::string
    text_of(const T &value);
    void
    note_default(const std::string &key, const std::string &value);
    std::string
    as_given(const std::string &key, const std::string &otherwise) const;
    void
    write(const std::string &key, const std::string &value, const std::string &help);

    RawSection                        *raw = nullptr;
    std::string                        my_path;
    std::shared_ptr<const Definitions> definitions = std::make_shared<Definitions>();

    std::shared_ptr<std::vector<std::string>> my_notes =
      std::make_shared<std::vector<std::string>>();

    std::ostream     *out         = nullptr;
    const RawSection *given       = nullptr;
    bool              comments    = false;
    unsigned int      indentation = 0;

    SectionDescription *description = nullptr;

    std::vector<std::string> known_keys, known_sections;
  };

  /// Read a value. Numbers may be given by formulas: `set Poisson's ratio = 1/3`. Throws
  /// SceneError, without position, if the text is not of the type.
  void
  from_text(const Formula &text, double &value);
  void
  from_text(const Formula &text, unsigned int &value);
  void
  from_text(const Formula &text, bool &value);
  void
  from_text(const Formula &text, std::string &value);
  void
  from_text(const Formula &text, Formula &value);
  void
  from_text(const Formula &text, std::vector<std::string> &value);
  void
  from_text(const Formula &text, std::vector<double> &value);
  void
  from_text(const Formula &text, std::vector<unsigned int> &value);
  template <int dim>
  void
  from_text(const Formula &text, dealii::Point<dim> &value);
  template <int dim>
  void
  from_text(const Formula &text, std::vector<dealii::Point<dim>> &value);
  template <int dim>
  void
  from_text(const Formula &text, Expression<dim> &value);
  template <int dim, int n_components>
  void
  from_text(const Formula &text, VectorExpression<dim, n_components> &value);
} // namespace Signorini
