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
  /// A key of a scene, as documentation shows it.
  struct KeyDescription
  {
    std::string              key, type, value, help, range;
    std::vector<std::string> choices;
    bool                     is_required = false;
  };

  /// A name that scenes may still use for one release, and the one that it has now.
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
    std::string key; ///< of a choice
  };

  /// A section with all that may stand in it. Sections that the user names are there once, with the
  /// name NAME.
  struct SectionDescription
  {
    std::string                    name, help;
    std::vector<KeyDescription>    keys;
    std::deque<SectionDescription> sections;
    std::vector<FormerName>        former_names = {};
  };

  /// Closed or half-open range of a number; the text of it goes into the error message.
  struct Range
  {
    double low            = -std::numeric_limits<double>::infinity();
    double high           = std::numeric_limits<double>::infinity();
    bool   low_is_allowed = true, high_is_allowed = true;

    bool
    contains(double x) const;
    std::string
    text() const;
  };

  const Range positive{0, std::numeric_limits<double>::infinity(), false, true};
  const Range non_negative{0, std::numeric_limits<double>::infinity(), true, true};

  /// One section of the scene file, seen by the structs that live in it. Each struct has one
  /// function `declare(Section &)` in which it binds its members: key, member (its value is the
  /// default), one sentence of documentation with the unit. The same function serves to read a
  /// scene, to write the resolved scene, to write the commented template, and for the reference of
  /// all keys.
  class Section
  {
  public:
    /// Reading: values in `raw` overwrite the members; what is absent keeps its default.
    explicit Section(RawSection &raw, const std::string &path = "");

    /// Writing: `comments` adds the documentation of each key.
    /// @param given what was read: numbers are written as they stand there
    Section(std::ostream     &out,
            bool              comments,
            unsigned int      indentation = 0,
            const RawSection *given       = nullptr);

    /// Describing: all keys and sections go into that description.
    explicit Section(SectionDescription &description)
      : description(&description)
    {}

    template <typename T>
    void
    add(const std::string &key, T &value, const std::string &help, const Range &range = {});

    /// A key without a default: a scene that does not set it is refused.
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

    /// A key whose default a scene should not rely on: where it is not set, a note says what is
    /// used.
    template <typename T>
    void
    add_noted(const std::string &key, T &value, const std::string &help)
    {
      add(key, value, help);
      if (reading() && !is_set(key))
        note_default(key, text_of(value));
    }

    /// Reading: true if the scene says something about that key.
    bool
    is_set(const std::string &key) const
    {
      return raw && raw->find_value(key);
    }

    /// The key had another name in the last release. A scene that uses it is read as if it had the
    /// new one, and a note says so; a scene that sets both is refused, but a command line overrides
    /// a file. To be called before the key is added.
    void
    rename_key(const std::string &former, const std::string &key);

    /// Likewise a subsection.
    void
    rename_section(const std::string &former, const std::string &name);

    /// Likewise a choice of a key.
    void
    rename_choice(const std::string &key, const std::string &former, const std::string &choice);

    /// Reading: remarks for the user so far, of this section and of those in it; each is there
    /// once.
    const std::vector<std::string> &
    notes() const
    {
      return *my_notes;
    }

    /// Reading: add a remark. @param where file and line, which may differ for equal remarks
    void
    add_note(const std::string &where, const std::string &text);

    /// A word out of a list.
    void
    add_choice(const std::string              &key,
               std::string                    &value,
               const std::vector<std::string> &choices,
               const std::string              &help);

    /// A word out of a list, for the value that it stands for.
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

    /// A fixed subsection: body(section) declares what is in it.
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

    /// Items that the user names: first `Names = a, b`, then one subsection a name. T has a member
    /// `std::string name` and a function declare(Section &).
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

    /// A subsection whose keys the user invents: names that stand for formulas in what comes later.
    void
    add_definitions(const std::string &name, Definitions &value, const std::string &help);

    /// True if that name stands for a formula.
    bool
    defines(const std::string &name) const;

    bool
    reading() const
    {
      return raw != nullptr;
    }

    /// Where and how a key of this section was set, for messages about its value:
    /// "scene.prm:12: Bodies/block/Mesh = ball". Works while reading.
    std::string
    source_of(const std::string &key) const;

    /// Throws SceneError("PLACE: what").
    [[noreturn]] void
    fail(const std::string &key, const std::string &what) const;

    const std::string &
    path() const
    {
      return my_path;
    }

    /// Reading: complain about keys and subsections that nobody asked for.
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

  /// A formula for a number is welcome wherever a number is: `set Poisson's ratio = 1/3`.
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
