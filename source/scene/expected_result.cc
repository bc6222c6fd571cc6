// SPDX-License-Identifier: Apache-2.0
#include "parameters/compiled_formula.h"
#include "scene/former_entries.h"
#include <signorini/parameters/section.h>
#include <signorini/scene/expected_result.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace Signorini
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// @return whether a formula is the constant zero.
    bool
    is_zero(const CompiledFormula &formula)
    {
      return formula.is_constant() && formula.value(nullptr) == 0;
    }
  } // namespace



  // Formulas are compiled once to check them; names of quantities must not be those of Definitions.
  void
  ExpectedResult::declare(Section &section)
  {
    section.add("Quantities",
                quantities,
                "NAME = PATH, ...: path of the number in results.json, or in its last load step");
    place = section.source_of("Quantities");
    section.add("Value", value, "formula in these names");
    section.add("Reference", reference, "formula in these names");
    section.add("Tolerance", tolerance, "relative", non_negative);
    section.add("Absolute tolerance",
                absolute_tolerance,
                "for references that may be zero",
                non_negative);
    section.add("Source", source, "source of the reference value");
    if (section.reading() && (quantities.empty() || value.empty()))
      section.fail(value.empty() ? "Value" : "Quantities", "is needed");
    std::vector<std::string> names;
    for (const std::string &quantity : quantities)
      {
        const auto parts = split(quantity, '=');
        if (parts.size() != 2)
          section.fail("Quantities", "'" + quantity + "' is not NAME = PATH");
        if (section.defines(parts[0]))
          section.fail("Quantities", "'" + parts[0] + "' is one of the Definitions; rename one");
        names.push_back(parts[0]);
      }
    if (!section.reading())
      return;
    const auto compile = [&](const char *key, const Formula &formula) {
      try
        {
          return std::make_unique<CompiledFormula>(formula, names);
        }
      catch (const SceneError &error)
        {
          section.fail(key, error.what());
        }
    };
    compile("Value", value);
    // No value but zero itself would be within a relative tolerance of zero.
    if (is_zero(*compile("Reference", reference)) && absolute_tolerance == 0)
      section.fail(
        "Reference",
        "is zero, for which a relative Tolerance is meaningless; set Absolute tolerance");
  }



  // Former names of entries in results.json are replaced by the present ones, with a note.
  void
  ExpectedResult::use_present_paths(Section &section, const unsigned int dim)
  {
    for (std::string &quantity : quantities)
      {
        const auto        parts = split(quantity, '=');
        const std::string path  = present_path(parts[1], dim);
        if (path == parts[1])
          continue;
        section.add_note(place,
                         "'" + parts[1] + "' is now called '" + path +
                           "'; the former name is accepted until the next release");
        quantity = parts[0] + " = " + path;
      }
  }



  namespace
  {
    /// @return the entry of a list or object; null if there is none.
    const Json *
    below(const Json &tree, const std::string &part)
    {
      if (tree.is_object())
        return tree.contains(part) ? &tree[part] : nullptr;
      // Numbers with more digits could exceed the range of the conversion, and no list is so long.
      constexpr std::size_t most_digits = 9;
      if (!tree.is_array() || part.empty() || part.size() > most_digits ||
          part.find_first_not_of("0123456789") != std::string::npos)
        return nullptr;
      const std::size_t index = std::stoul(part);
      return index < tree.size() ? &tree[index] : nullptr;
    }

    /// @return the entry at a path of names and indices; null if there is none.
    const Json *
    at_path(const Json &tree, const std::string &path)
    {
      const Json *place = &tree;
      for (const std::string &part : split(path, '/'))
        place = place ? below(*place, part) : nullptr;
      return place;
    }

    /// @return the number at a path in the last load step, or else in the results. Throws
    /// SceneError if there is none.
    double
    number_at(const Json &results, const std::string &path, const std::string &name)
    {
      const Json &last  = results["load_steps"].back();
      const Json *all[] = {at_path(last, path), at_path(results, path)};
      for (const Json *place : all)
        if (place && place->is_number())
          return place->get<double>();
      throw SceneError("Expected results/" + name + "/Quantities: there is no number '" + path +
                       "' in results.json");
    }

    /// @return whether a path begins with an entry whose length or existence depends on the
    /// solution, so that it cannot be checked in advance.
    bool
    is_open(const std::string &first, const std::vector<std::string> &whole)
    {
      for (const char *name :
           {"krylov_iterations", "newton_iterations_before_augmentations", "stabilised_modes"})
        if (first == name)
          return true;
      return std::find(whole.begin(), whole.end(), first) != whole.end();
    }

    /// @return one line of the table.
    std::string
    row(const std::string &name,
        const std::string &value,
        const std::string &reference,
        const std::string &deviation,
        const std::string &allowed,
        const std::string &verdict)
    {
      std::ostringstream text;
      text << "  " << std::left << std::setw(34) << name << std::right << std::setw(14) << value
           << std::setw(14) << reference << std::setw(12) << deviation << std::setw(12) << allowed
           << "  " << verdict;
      return text.str();
    }

    /// @return a number as text.
    std::string
    text(const double x, const int digits)
    {
      std::ostringstream out;
      out << std::setprecision(digits) << x;
      return out.str();
    }
  } // namespace



  // Each path must lead to a number (or null) in the example of a load step, or begin with an entry
  // that only the solution determines.
  void
  check_paths(const std::vector<ExpectedResult> &expected,
              const Json                        &step,
              const std::vector<std::string>    &whole)
  {
    for (const ExpectedResult &one : expected)
      for (const std::string &quantity : one.quantities)
        {
          const std::string path  = split(quantity, '=')[1];
          const std::string first = path.substr(0, path.find('/'));
          if (is_open(first, whole))
            continue;
          const Json *const end = at_path(step, path);
          if (end && (end->is_number() || end->is_null()))
            continue;
          // Find the part of the path that exists, and list what may follow it.
          const Json *place = &step;
          std::string known;
          for (const std::string &part : split(path, '/'))
            {
              const Json *const next = below(*place, part);
              if (!next)
                break;
              place = next;
              known += "/" + part;
            }
          // Names that may follow the known part; at the top level also the entries of the whole
          // run.
          std::vector<std::string> words;
          if (place->is_structured())
            for (const auto &[key, value] : place->items())
              words.push_back(key);
          if (known.empty())
            words.insert(words.end(), whole.begin(), whole.end());
          throw SceneError("Expected results/" + one.name + "/Quantities: there is no number '" +
                           path + "' in results.json; after '" + known +
                           "' there are: " + (words.empty() ? "no more names" : join(words)));
        }
  }



  // The names of the quantities are constants of both formulas.
  bool
  compare(const std::vector<ExpectedResult> &expected, Json &results, std::ostream &out)
  {
    if (expected.empty())
      return true;
    bool all_hold = true;
    out << "\n"
        << row("Expected results", "value", "reference", "deviation", "allowed", "") << "\n";
    for (const ExpectedResult &one : expected)
      {
        // Each quantity has the form NAME=PATH, with the path of a number in the results.
        std::map<std::string, double> constants;
        for (const std::string &quantity : one.quantities)
          {
            const auto parts    = split(quantity, '=');
            constants[parts[0]] = number_at(results, parts[1], one.name);
          }
        // The deviation is absolute if the entry has an absolute tolerance, otherwise relative to
        // the reference.
        const double value     = evaluate(one.value, constants),
                     reference = evaluate(one.reference, constants);
        const bool   absolute  = one.absolute_tolerance > 0;
        const double deviation = absolute ? value - reference : value / reference - 1;
        const double allowed   = absolute ? one.absolute_tolerance : one.tolerance;
        const bool   holds     = std::abs(deviation) <= allowed;
        all_hold               = all_hold && holds;
        const auto relative    = [&](const double x) {
          return absolute ? text(x, 3) : text(100 * x, 3) + " %";
        };
        out << row(one.name,
                   text(value, 8),
                   text(reference, 8),
                   relative(deviation),
                   relative(allowed),
                   holds ? "ok" : "MISSED")
            << "\n";
        results["expected"][one.name] = {{"value", value},
                                         {"reference", reference},
                                         {"deviation", deviation},
                                         {"allowed", allowed},
                                         {"holds", holds},
                                         {"source", one.source}};
      }
    return all_hold;
  }
} // namespace Signorini
