// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shapes.h"
#include "scene/documentation.h"
#include "solver/preconditioner.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>
#include <signorini/parameters/section.h>
#include <signorini/scene/scene.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace Signorini
{
  namespace
  {
    /// @return a scene with all keys that have no default, and one item of each kind.
    std::string
    example(const unsigned int dim)
    {
      const std::string zero = dim == 2 ? "0" : "0; 0";
      return "set Dimension = " + std::to_string(dim) + R"(
set Title = a block pressed onto a rigid plane
subsection Bodies
  set Names = block
  subsection block
    set Mesh = box
    set Young's modulus = 200000
    set Poisson's ratio = 0.3
  end
end
subsection Obstacles
  set Names = ground
  subsection ground
    set Shape = plane
    set Normal = )" +
             (dim == 2 ? "0, 1" : "0, 0, 1") + R"(
  end
end
subsection Supports
  set Names = press
  subsection press
    set Boundaries = block.top
    set Displacement = )" +
             zero + R"(; -0.01*t
  end
end
subsection Loads
  set Names = weight
  subsection weight
    set Bodies = block
    set Body force = )" +
             zero + R"(; -1e-6
  end
end
subsection Contact pairs
  set Names = foot
  subsection foot
    set Slave = block.bottom
    set Master = ground
  end
end
subsection Mesh
  subsection Refinement regions
    set Names = foot
    subsection foot
      set Inside = 0.1 - )" +
             (dim == 2 ? "y" : "z") + R"(
    end
  end
end
subsection Output
  subsection Probes
    set Names = corner
    subsection corner
      set Body = block
    end
  end
end
)";
    }

    /// @return the text of a scene with comments. `given` has the values that were set; null: none.
    template <int dim>
    std::string
    written(Scene<dim> &scene, const RawSection *given)
    {
      std::ostringstream text;
      Section            section(text, true, 0, given);
      scene.declare(section);
      return text.str();
    }

    /// @return the complete example, with the values that the user sets. Throws SceneError.
    template <int dim>
    std::string
    whole(const std::vector<std::string> &overrides)
    {
      std::istringstream in(example(dim));
      RawSection         raw = read_raw(in, "example");
      for (const std::string &assignment : overrides)
        override_value(raw, assignment);
      if (raw.find_value("Dimension")->text != std::to_string(dim))
        throw SceneError("the dimension of the template follows the option: --print-template 3");
      Scene<dim> scene;
      Section    section(raw);
      scene.declare(section);
      section.close();
      return written(scene, &raw);
    }

    bool
    is_in(const std::string &word, const std::vector<std::string> &words)
    {
      return std::find(words.begin(), words.end(), word) != words.end();
    }

    /// @return the names of sections.
    std::vector<std::string>
    names_of(const std::deque<SectionDescription> &sections)
    {
      std::vector<std::string> names;
      for (const SectionDescription &section : sections)
        names.push_back(section.name);
      return names;
    }

    /// The interpretation of words in one dimension: each may be the name of several things.
    template <int dim>
    struct TemplateWords
    {
      Scene<dim> scene;
      /// Sections in which something is chosen.
      std::vector<std::string> sections;
      std::vector<std::string> methods;
      unsigned int             n_meanings = 0;
      std::vector<std::string> unknown, known;

      /// Interpret all words. Those without meaning are collected in `unknown`.
      explicit TemplateWords(const std::vector<std::string> &words)
      {
        SectionDescription all;
        Section            section(all);
        Scene<dim>().declare(section);
        const auto section_names = names_of(all.sections);
        for (const auto &names : {generator_names<dim>(),
                                  obstacle_names<dim>(),
                                  method_names(),
                                  preconditioner_names(),
                                  section_names})
          known.insert(known.end(), names.begin(), names.end());
        for (const std::string &word : words)
          {
            const unsigned int before = n_meanings;
            if (is_in(word, generator_names<dim>()))
              {
                scene.bodies.emplace_back();
                scene.bodies.back().name = scene.bodies.back().mesh.type = word;
                /// Record that a word has chosen something in a section.
                mean("Bodies");
              }
            if (is_in(word, obstacle_names<dim>()))
              {
                scene.obstacles.emplace_back();
                scene.obstacles.back().name = scene.obstacles.back().type = word;
                mean("Obstacles");
              }
            if (is_in(word, method_names()))
              {
                methods.push_back(scene.contact.method = word);
                mean("Contact method");
              }
            if (is_in(word, preconditioner_names()))
              {
                scene.solver.preconditioner = word;
                mean("Solver");
              }
            if (is_in(word, section_names))
              mean(word);
            if (n_meanings == before)
              unknown.push_back(word);
          }
      }

    private:
      void
      mean(const std::string &section)
      {
        sections.push_back(section);
        ++n_meanings;
      }
    };

    /// @return some sections of the text of a scene, with the comments before them; of the
    /// subsections of the contact methods those of the given methods only, or all if none is given.
    std::string
    excerpt(const std::string              &text,
            const std::vector<std::string> &sections,
            const std::vector<std::string> &methods)
    {
      std::istringstream in(text);
      std::string        line, result, waiting, top;
      unsigned int       depth = 0, skipped_items = 0; // 0: nothing is being skipped
      while (std::getline(in, line))
        {
          // Comments wait for the line that follows them. `skipped_items` is the depth of the
          // section that is being skipped, 0 if none.
          const std::string word  = trim(line);
          const bool        opens = word.compare(0, 11, "subsection ") == 0, closes = word == "end";
          if (word.empty() || word[0] == '#')
            {
              waiting += line + "\n";
              continue;
            }
          if (opens && ++depth == 1)
            top = word.substr(11);
          const bool is_other_method = opens && depth == 2 && top == "Contact method" &&
                                       !methods.empty() && !is_in(word.substr(11), methods);
          if (skipped_items == 0 && (is_other_method || depth == 0 || !is_in(top, sections)))
            skipped_items = std::max(depth, 1u);
          if (skipped_items == 0)
            result += waiting + line + "\n";
          waiting.clear();
          if (skipped_items > 0 && ((closes && depth == skipped_items) || depth == 0))
            skipped_items = 0;
          depth -= closes;
        }
      return result;
    }

    /// @return the sections that the words of a request choose. Throws SceneError for unknown
    /// words.
    template <int dim>
    std::string
    of_words(const TemplateRequest &request)
    {
      TemplateWords<dim> meaning(request.words);
      if (!meaning.unknown.empty())
        {
          const std::string word = meaning.unknown[0], close = nearest(word, meaning.known);
          throw SceneError("--print-template: '" + shortened(word) + "' is nothing in " +
                           std::to_string(dim) + "D" +
                           (close.empty() ? "." : "; did you mean '" + close + "'?") +
                           " There are: " + join(meaning.known));
        }
      if (!request.overrides.empty())
        throw SceneError("--set goes with --print-template alone, not with words");
      // Sections that are requested by their own name are those of the example.
      std::istringstream in(example(dim));
      RawSection         raw = read_raw(in, "example");
      Scene<dim>         scene;
      Section            section(raw);
      scene.declare(section);
      if (!meaning.scene.bodies.empty())
        scene.bodies = meaning.scene.bodies;
      if (!meaning.scene.obstacles.empty())
        scene.obstacles = meaning.scene.obstacles;
      if (!meaning.methods.empty())
        scene.contact = meaning.scene.contact;
      scene.solver = meaning.scene.solver;
      return excerpt(written(scene, nullptr), meaning.sections, meaning.methods);
    }

    /// @return the dimension of a request: the given one, or the one in which its words have more
    /// meanings.
    unsigned int
    dimension_of(const TemplateRequest &request)
    {
      if (request.dimension > 0)
        return request.dimension;
      return TemplateWords<3>(request.words).n_meanings >
                 TemplateWords<2>(request.words).n_meanings ?
               3 :
               2;
    }
  } // namespace



  void
  print_template(const TemplateRequest &request, std::ostream &out)
  {
    const unsigned int dim = dimension_of(request);
    if (request.words.empty())
      out
        << "# A complete scene with all keys; values are defaults. Lengths, forces and times in any "
           "consistent units.\n"
        << (dim == 2 ? whole<2>(request.overrides) : whole<3>(request.overrides));
    else
      out << "# Parts of a scene in " << dim << "D; values are defaults.\n"
          << (dim == 2 ? of_words<2>(request) : of_words<3>(request));
  }
} // namespace Signorini
