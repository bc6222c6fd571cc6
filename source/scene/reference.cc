// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shapes.h"
#include "scene/descriptions.h"
#include "scene/documentation.h"
#include "solver/preconditioner.h"
#include "solver/preconditioners/schur_complement.h"
#include <signorini/parameters/section.h>
#include <signorini/scene/scene.h>

#include <algorithm>
#include <ostream>

namespace Signorini
{
  namespace
  {
    const std::string introduction = R"(# Reference of all keys

This page is written by the program: `signorini --print-reference`. A scene to start from is printed by `signorini
--print-template 3`, parts of it by `signorini --print-template ring plane penalty`, with what you choose by name.

A scene consists of `set KEY = VALUE`, and of sections: `subsection NAME`, ..., `end`. `#` starts a comment, `\` at the end
of a line continues it. NAME below stands for a name of yours. Units are any that are consistent.

* **Numbers** may be formulas: `set Poisson's ratio = 1/3`. Several are separated by commas.
* **Formulas** know the coordinates `x`, `y` (and `z` in 3D), the time `t`, all names of the section Definitions, `pi`,
  `+ - * / ^`, comparisons, `&`, `|`, `if(condition, a, b)`, `sin cos tan cot sec csc asin acos atan sinh cosh tanh`,
  `exp log log2 log10 sqrt abs sign pow min max sum avg int (nearest integer) floor ceil erf erfc`, and
  `table(t, t1, y1, t2, y2, ...)`, which is linear between its points. Several formulas, one a component, are separated by
  semicolons; `free` stands for a component that is not prescribed.
* **Boundaries** are written BODY.BOUNDARY; the names of the boundaries follow from the mesh, and `signorini --check` lists
  them with their places.
)";

    /// A section in 2D and in 3D; null where it does not exist.
    struct SectionPair
    {
      const SectionDescription *two, *three;

      /// @return the section in one of the dimensions in which it exists.
      const SectionDescription &
      any() const
      {
        return three ? *three : *two;
      }
    };

    /// @return a subsection; null if there is none.
    const SectionDescription *
    find(const SectionDescription *section, const std::string &name)
    {
      if (section)
        for (const SectionDescription &child : section->sections)
          if (child.name == name)
            return &child;
      return nullptr;
    }

    /// @return a key of a section; null if there is none.
    const KeyDescription *
    find_key(const SectionDescription *section, const std::string &key)
    {
      if (section)
        for (const KeyDescription &one : section->keys)
          if (one.key == key)
            return &one;
      return nullptr;
    }

    /// @return a subsection in both dimensions.
    SectionPair
    child(const SectionPair &section, const std::string &name)
    {
      return {find(section.two, name), find(section.three, name)};
    }

    /// @return the names of items of two lists, in the order of 3D, followed by those that exist in
    /// 2D only.
    template <typename List, typename Name>
    std::vector<std::string>
    united(const List *two, const List *three, const Name &name)
    {
      std::vector<std::string> names;
      for (const List *list : {three, two})
        if (list)
          for (const auto &item : *list)
            if (std::find(names.begin(), names.end(), name(item)) == names.end())
              names.push_back(name(item));
      return names;
    }

    /// @return the names of all keys of a section.
    std::vector<std::string>
    key_names(const SectionPair &section)
    {
      return united(section.two ? &section.two->keys : nullptr,
                    section.three ? &section.three->keys : nullptr,
                    [](const KeyDescription &key) { return key.key; });
    }

    /// @return the names of all subsections of a section.
    std::vector<std::string>
    section_names(const SectionPair &section)
    {
      return united(section.two ? &section.two->sections : nullptr,
                    section.three ? &section.three->sections : nullptr,
                    [](const SectionDescription &one) { return one.name; });
    }

    /// @return a text in backquotes; nothing if it is empty.
    std::string
    code(const std::string &text)
    {
      return text.empty() ? "" : "`" + text + "`";
    }

    /// @return a text with bars escaped, for the cell of a table.
    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        result += c == '|' ? std::string("\\|") : std::string(1, c);
      return result;
    }

    /// @return a help text "text [unit]" as two parts; the unit may be empty.
    std::pair<std::string, std::string>
    split_unit(const std::string &help)
    {
      const auto open = help.rfind('[');
      if (open == std::string::npos || help.back() != ']')
        return {help, ""};
      return {trim(help.substr(0, open)), help.substr(open + 1, help.size() - open - 2)};
    }

    /// @return the type and range of a key, or its choices.
    std::string
    value_of(const KeyDescription &key)
    {
      if (!key.choices.empty())
        {
          std::vector<std::string> words;
          for (const std::string &choice : key.choices)
            words.push_back(code(choice));
          return join(words);
        }
      return key.type + (key.range.empty() ? "" : " " + key.range);
    }

    std::string
    default_of(const KeyDescription &key)
    {
      return key.is_required ? "required" : code(key.value);
    }

    std::string
    sentence_of(const KeyDescription &key)
    {
      return split_unit(key.help).first;
    }

    std::string
    unit_of(const KeyDescription &key)
    {
      return split_unit(key.help).second;
    }

    /// @return a text about a key; with both dimensions if they differ.
    template <typename F>
    std::string
    in_both(const KeyDescription *two, const KeyDescription *three, const F &text)
    {
      if (!two || !three)
        return text(two ? *two : *three);
      const std::string a = text(*two), b = text(*three);
      return a == b ? a : "2D: " + a + "; 3D: " + b;
    }

    /// Print the table of the keys of a section.
    /// @param without keys that are printed elsewhere
    void
    print_keys(const SectionPair              &section,
               std::ostream                   &out,
               const std::vector<std::string> &without = {})
    {
      std::vector<std::string> names = key_names(section);
      for (const std::string &key : without)
        names.erase(std::remove(names.begin(), names.end(), key), names.end());
      if (names.empty())
        return;
      out << "\n| key | value | unit | default | |\n|---|---|---|---|---|\n";
      for (const std::string &name : names)
        {
          const KeyDescription *two   = find_key(section.two, name),
                               *three = find_key(section.three, name);
          // The dimension of a key is mentioned only if the section exists in both.
          const std::string where = !section.two || !section.three || (two && three) ? "" :
                                    two                                              ? " (2D)" :
                                                                                       " (3D)";
          const auto cell = [&](const auto &text) { return escaped(in_both(two, three, text)); };
          out << "| " << code(name) << where << " | " << cell(value_of) << " | " << cell(unit_of)
              << " | " << cell(default_of) << " | " << cell(sentence_of) << " |\n";
        }
    }

    /// Print a heading.
    void
    heading(const unsigned int level, const std::string &text, std::ostream &out)
    {
      out << "\n" << std::string(level, '#') << " " << text << "\n";
    }

    /// @return the description of the keys that an object declares.
    template <typename Object>
    SectionDescription
    described(Object &object)
    {
      SectionDescription description;
      Section            section(description);
      object.declare(section);
      return description;
    }

    template <typename List>
    bool
    is_in(const std::string &word, const List &words)
    {
      return std::find(words.begin(), words.end(), word) != words.end();
    }

    /// @return a text about the dimensions in which something exists; empty for both.
    std::string
    dimensions(const bool two, const bool three)
    {
      return two && three ? "" : two ? " (2D)" : " (3D)";
    }

    /// @return the boundaries of a generator for each of its parts: "`arc` (full); `arc`, `top`
    /// (lower half)". The generator is asked for each value of the key Part.
    template <int dim>
    std::string
    boundaries_of(const std::string &generator)
    {
      if (generator == "file")
        return "the names that the file gives to faces, and `unnamed` or `unnamed1`, `unnamed2`, ... "
               "for the others";
      const auto            any  = MeshGenerator<dim>::create(generator);
      const auto            keys = described(*any);
      const KeyDescription *part = find_key(&keys, "Part");
      std::vector<std::pair<std::string, std::vector<std::string>>> lists; // names, parts
      for (const std::string &name : part ? part->choices : std::vector<std::string>{""})
        {
          RawSection raw;
          if (part)
            raw.set_value("Part", name, "the reference");
          Section    section(raw);
          const auto one = MeshGenerator<dim>::create(generator);
          one->declare(section);
          std::vector<std::string> words;
          for (const std::string &boundary : one->boundaries())
            words.push_back(code(boundary));
          const std::string text = join(words);
          // Successive parts with the same boundaries share one list.
          if (lists.empty() || lists.back().first != text)
            lists.push_back({text, {}});
          lists.back().second.push_back(name);
        }
      std::vector<std::string> texts;
      for (const auto &[names, parts] : lists)
        texts.push_back(names + (lists.size() > 1 ? " (" + join(parts) + ")" : ""));
      return join(texts, "; ");
    }

    /// Print the section of a mesh generator.
    void
    print_mesh(const std::string &name, const unsigned int level, std::ostream &out)
    {
      const bool two = is_in(name, generator_names<2>()), three = is_in(name, generator_names<3>());
      SectionDescription keys_2, keys_3;
      std::string        in_2, in_3;
      if (two)
        {
          keys_2 = described(*MeshGenerator<2>::create(name));
          in_2   = boundaries_of<2>(name);
        }
      if (three)
        {
          keys_3 = described(*MeshGenerator<3>::create(name));
          in_3   = boundaries_of<3>(name);
        }
      heading(level, "Mesh = " + name + dimensions(two, three), out);
      out << "\n" << about_mesh(name) << "\n\nBoundaries: ";
      if (two && three && in_2 != in_3)
        out << "in 2D " << in_2 << "; in 3D " << in_3 << ".\n";
      else
        out << (three ? in_3 : in_2) << ".\n";
      print_keys({two ? &keys_2 : nullptr, three ? &keys_3 : nullptr}, out);
    }

    /// Print the section of a shape of obstacles.
    void
    print_shape(const std::string &name, const unsigned int level, std::ostream &out)
    {
      SectionDescription two   = described(*make_shape<2>(name)),
                         three = described(*make_shape<3>(name));
      heading(level, "Shape = " + name, out);
      out << "\n" << about_shape(name) << "\n";
      print_keys({&two, &three}, out);
    }

    /// Print the choices of a key with one sentence about each.
    template <typename About>
    void
    print_choices(const std::string              &key,
                  const std::vector<std::string> &choices,
                  const About                    &about,
                  std::ostream                   &out)
    {
      out << "\n" << code(key) << ":\n\n";
      for (const std::string &choice : choices)
        out << "* " << code(choice) << ": " << about(choice) << "\n";
    }

    /// Print a section with its subsections, one heading level deeper each.
    void
    print_section(const SectionPair &section,
                  const std::string &path,
                  unsigned int       level,
                  std::ostream      &out);

    /// @return the keys of the default generator or shape, which a section contains in addition to
    /// its own.
    std::vector<std::string>
    keys_of_first(const SectionDescription &two, const SectionDescription &three)
    {
      return key_names({&two, &three});
    }

    /// Print the section of a body, followed by those of all generators.
    void
    print_body(const SectionPair &section, const unsigned int level, std::ostream &out)
    {
      print_keys(section,
                 out,
                 keys_of_first(described(*MeshGenerator<2>::create("box")),
                               described(*MeshGenerator<3>::create("box"))));
      const auto two = generator_names<2>(), three = generator_names<3>();
      for (const std::string &name :
           united(&two, &three, [](const std::string &name) { return name; }))
        print_mesh(name, level + 1, out);
    }

    /// Print the section of an obstacle, followed by those of all shapes.
    void
    print_obstacle(const SectionPair &section, const unsigned int level, std::ostream &out)
    {
      print_keys(section,
                 out,
                 keys_of_first(described(*make_shape<2>("plane")),
                               described(*make_shape<3>("plane"))));
      for (const std::string &name : obstacle_names<3>())
        print_shape(name, level + 1, out);
    }

    void
    print_section(const SectionPair &section,
                  const std::string &path,
                  const unsigned int level,
                  std::ostream      &out)
    {
      heading(level, path, out);
      if (!section.any().help.empty())
        out << "\n" << section.any().help << "\n";
      if (path == "Bodies/NAME")
        print_body(section, level, out);
      else if (path == "Obstacles/NAME")
        print_obstacle(section, level, out);
      else
        print_keys(section, out);
      if (path == "Contact method")
        print_choices("Integration",
                      words_of(or_auto(Integration::rules())),
                      about_integration,
                      out);
      if (path == "Solver")
        {
          print_choices("Preconditioner", preconditioner_names(), about_preconditioner, out);
          print_choices("Schur complement", SchurComplement::names(), about_schur_complement, out);
        }
      for (const std::string &name : section_names(section))
        print_section(child(section, name), path + "/" + name, level + 1, out);
    }
  } // namespace



  void
  print_reference(std::ostream &out)
  {
    Scene<2>                 scene_2;
    Scene<3>                 scene_3;
    const SectionDescription two = described(scene_2), three = described(scene_3);
    const SectionPair        all{&two, &three};
    out << introduction;
    heading(2, "At the top", out);
    print_keys(all, out);
    for (const std::string &name : section_names(all))
      print_section(child(all, name), name, 2, out);
  }
} // namespace Signorini
