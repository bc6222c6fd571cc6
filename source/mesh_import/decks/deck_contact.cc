// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"
#include "mesh_import/decks/scene_text.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>

// The part of the reader for contact pairs.

namespace Signorini
{
  namespace
  {
    // The interaction of tied surfaces, with a name that no file can contain.
    const char *const tied = "\"TIED";
  } // namespace



  // Data lines: slave, master. ADJUST moves nodes without strain, which changes nothing where gaps
  // are kept without strain.
  void
  DeckReader::read_ties()
  {
    for (const char *const option : {"MULTISTAGE", "FLUID"})
      if (in.has(option))
        {
          skip_item(option);
          model.lacks_supports = true;
          return;
        }
    const std::string key      = "POSITION TOLERANCE";
    const double      farthest = in.has(key) ? number({in.value(key)}, 0) : 0;
    for (Words words; in.next_line(words);)
      if (words.size() < 2 || words[1].empty())
        in.fail("*TIE needs a slave and a master surface");
      else
        {
          model.pairs.push_back({words[0], words[1], tied, farthest});
          if (in.has("CYCLIC SYMMETRY"))
            model.pairs.back().cyclic_tie = upper_case(in.value("NAME"));
        }
    model.interactions[tied].kind = DeckModel::Interaction::Kind::tied;
  }



  // *SURFACE BEHAVIOR up to the next *SURFACE INTERACTION belongs to this interaction.
  void
  DeckReader::begin_interaction()
  {
    interaction = upper_case(in.value("NAME"));
    model.interactions[interaction];
  }



  /// @return the name of the interaction that has taken the place of another one, or its own. In
  /// upper case.
  std::string
  DeckReader::present_interaction(const std::string &name) const
  {
    std::string result = upper_case(name);
    const auto  found  = model.interactions.find(result);
    if (found == model.interactions.end())
      in.fail("*" + in.keyword() + " of an interaction that is not there above: " + result);
    return found->second.successor ? present_interaction(found->second.successor->second) : result;
  }



  // The next *SURFACE BEHAVIOR is that of a copy of the interaction, which takes its place from the
  // beginning of the present step.
  void
  DeckReader::begin_change_of_behaviour()
  {
    const std::string before = present_interaction(in.value("INTERACTION"));
    changes_behaviour        = in_step && counts();
    if (!changes_behaviour)
      return;
    // A name that no file can contain.
    interaction                          = before + "\"";
    const DeckModel::Interaction copy    = model.interactions[before];
    model.interactions[interaction]      = copy;
    model.interactions[before].successor = {model.steps.back().begin, interaction};
  }



  // PRESSURE-OVERCLOSURE: HARD, LINEAR and TIED with a slope, EXPONENTIAL with clearance and
  // pressure, TABULAR with lines of pressure and overclosure.
  void
  DeckReader::read_behaviour()
  {
    // Only *CHANGE SURFACE BEHAVIOR gives a pair another law.
    if (in_step && !changes_behaviour)
      {
        skip_item("its change in a step");
        return;
      }
    changes_behaviour            = false;
    using Kind                   = DeckModel::Interaction::Kind;
    const std::string       kind = upper_case(in.value("PRESSURE-OVERCLOSURE"));
    DeckModel::Interaction &one  = model.interactions[interaction];
    std::vector<Words>      lines;
    for (Words words; in.next_line(words);)
      lines.push_back(words);
    one.kind = kind == "TIED" ? Kind::tied : Kind::separates;
    one.overclosure.clear();
    if (kind == "LINEAR" || (kind == "TIED" && !lines.empty()))
      {
        const double slope = lines.empty() ? 0. : number(lines[0], 0);
        if (!(slope > 0))
          in.fail("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=" + kind + " needs a positive slope");
        one.overclosure = {{"Pressure-overclosure", "linear"},
                           {"Normal stiffness", long_text(slope)}};
      }
    else if (kind == "EXPONENTIAL" || kind == "TABULAR")
      read_soft_contact(kind == "TABULAR", lines, one);
    else if (!kind.empty() && kind != "HARD" && kind != "TIED")
      skip_item(kind + "; contact is hard");
    // After first contact, such surfaces would stay together; before it they could move freely. The
    // pairs of the program either may separate or never do.
    if (in.has("NO SEPARATION"))
      {
        one.kind = Kind::never_separates;
        if (!one.overclosure.empty() && kind != "LINEAR")
          {
            skip_item(kind + " with NO SEPARATION; contact is hard");
            one.overclosure.clear();
          }
        skip_item("NO SEPARATION; the surfaces stay together from the beginning");
      }
  }



  // EXPONENTIAL of CalculiX is p0 100^(d/c0), as in the scene. That of Abaqus is another function
  // of the same numbers, for which a table stands. The tables of both programs begin at zero
  // pressure, and the last of such lines counts.
  void
  DeckReader::read_soft_contact(const bool                is_table,
                                const std::vector<Words> &lines,
                                DeckModel::Interaction   &one)
  {
    if (lines.empty() || lines[0].size() < 2)
      in.fail("*SURFACE BEHAVIOR needs a line of two numbers");
    using Line = std::pair<double, double>; // pressure, overclosure
    std::vector<Line> table;
    const double      first = number(lines[0], 0), second = number(lines[0], 1);
    if (!is_table && model.deck.instances_of.empty())
      {
        one.overclosure = {{"Pressure-overclosure", "exponential"},
                           {"Clearance", long_text(first)},
                           {"Pressure at zero gap", long_text(second)}};
        return;
      }
    if (is_table)
      for (const Words &words : lines)
        table.emplace_back(number(words, 0), number(words, 1));
    else
      for (double x = 0; x < 8.1; x += 0.125)
        table.emplace_back(second / std::expm1(1.) * x * std::expm1(x), (x - 1) * first);
    while (table.size() > 1 && table[1].first == 0)
      table.erase(table.begin());
    bool        is_increasing = table.size() > 1 && table[0].first == 0;
    std::string text;
    for (unsigned int i = 0; i < table.size(); ++i)
      {
        text += (i > 0 ? "; " : "") + long_text(table[i].first) + ", " + long_text(table[i].second);
        is_increasing = is_increasing && (i == 0 || (table[i].first > table[i - 1].first &&
                                                     table[i].second > table[i - 1].second));
      }
    if (is_increasing)
      one.overclosure = {{"Pressure-overclosure", "tabular"}, {"Overclosure table", text}};
    else
      skip_item("a table that does not increase from zero; contact is hard");
  }



  // Data lines: coefficient, then in CalculiX the stick slope, in Abaqus slip rate, pressure and
  // temperature; with EXPONENTIAL DECAY the static coefficient, the kinetic one and the decay.
  void
  DeckReader::read_friction()
  {
    if (in_step && !counts())
      return;
    if (in_step)
      {
        change_friction();
        return;
      }
    // Zero is the default number of fields on which the coefficient depends.
    const bool by_fields = in.has("DEPENDENCIES") && number({in.value("DEPENDENCIES")}, 0) > 0;
    for (const auto &[option, is_set] : {std::make_pair("USER", in.has("USER")),
                                         std::make_pair("ANISOTROPIC", in.has("ANISOTROPIC")),
                                         std::make_pair("DEPENDENCIES", by_fields)})
      if (is_set)
        {
          skip_item(std::string(option) + "; contact is without friction");
          model.lacks_supports = true;
          return;
        }
    DeckModel::Interaction &one = model.interactions[interaction];
    if (in.has("ROUGH"))
      {
        // No slip at any pressure.
        one.friction = "1e6";
        return;
      }
    if (in.has("TAUMAX"))
      one.shear_limit = number({in.value("TAUMAX")}, 0);
    std::vector<Words> lines;
    for (Words words; in.next_line(words);)
      lines.push_back(words);
    if (lines.empty())
      in.fail("*FRICTION needs a coefficient");
    if (number(lines[0], 0) < 0)
      in.fail("*FRICTION has a negative coefficient");
    one.friction = long_text(number(lines[0], 0));
    if (in.has("EXPONENTIAL DECAY"))
      {
        skip_item("the decay with the slip rate, the static coefficient counts");
        return;
      }
    // The numbers of a line; blank ones are zero, as in Abaqus.
    const auto entry = [&](const Words &words, const unsigned int i) {
      return words.size() > i && !words[i].empty() ? number(words, i) : 0.;
    };
    // In decks with parts and instances, which are those of Abaqus, the second number is a slip
    // rate.
    if (lines.size() == 1 && model.deck.instances_of.empty())
      one.stick_slope = entry(lines[0], 1);
    // Only what differs between lines is a dependence.
    const auto differs = [&](const unsigned int i) {
      return std::any_of(lines.begin(), lines.end(), [&](const Words &words) {
        return entry(words, i) != entry(lines[0], i);
      });
    };
    if (differs(1) || differs(3))
      skip_item("its dependence on slip rate or temperature, the first coefficient counts");
    else if (differs(2))
      {
        one.friction = "table(pressure";
        for (const Words &words : lines)
          one.friction +=
            ", " + long_text(entry(words, 2)) + ", " + long_text(std::max(0., entry(words, 0)));
        one.friction += ")";
      }
    else if (lines.size() > 1 && differs(0))
      in.fail(
        "*FRICTION has several coefficients for the same slip rate, pressure and temperature");
  }



  // *CHANGE FRICTION names the interaction that the next *FRICTION belongs to.
  void
  DeckReader::begin_change_of_friction()
  {
    interaction = present_interaction(in.value("INTERACTION"));
  }



  // Another coefficient from the beginning of the present step. Load steps end there, so that the
  // jump is between two of them.
  void
  DeckReader::change_friction()
  {
    DeckModel::Interaction &one = model.interactions[interaction];
    Words                   words, more;
    if (!in.next_line(words) || in.next_line(more) || !in.all_parameters().empty() ||
        number(words, 0) < 0)
      {
        skip_item("its change in a step, which is not that of one coefficient");
        model.lacks_supports = true;
        return;
      }
    if (model.deck.instances_of.empty() && number(words, 1) != one.stick_slope)
      skip_item("another stick slope in a step; that of the beginning stays");
    const std::string now    = long_text(number(words, 0));
    const double      begin  = model.steps.back().begin;
    const std::string before = one.friction.empty() ? "0" : one.friction;
    one.friction =
      begin > 0 ? "if(t > " + text_of_time(begin) + ", " + now + ", " + before + ")" : now;
  }



  // Data lines: slave, master. Whether the surfaces exist is not checked here.
  void
  DeckReader::read_pairs()
  {
    if (const std::string by = in.value("ADJUST"); !model.deck.nodes.find(by))
      number({by}, 0); // or it fails
    for (Words words; in.next_line(words);)
      if (words.size() < 2 || words[1].empty())
        skip_item("of one surface with itself: " + words[0]);
      else
        model.pairs.push_back(
          {words[0], words[1], in.has("TIED") ? tied : upper_case(in.value("INTERACTION")), 0});
    if (in.has("TIED"))
      model.interactions[tied].kind = DeckModel::Interaction::Kind::tied;
  }



  // Data lines: slave, master. Other kinds of changes are those of elements.
  void
  DeckReader::read_model_change()
  {
    const bool adds = in.has("ADD");
    // The mesh does not have them.
    if (upper_case(in.value("TYPE")) == "ELEMENT" && !model.deck.removed_elements.empty())
      return;
    if (upper_case(in.value("TYPE")) != "CONTACT PAIR" || !in_step || adds == in.has("REMOVE"))
      {
        skip_item("elements are there at all times");
        return;
      }
    if (!counts())
      return;
    const double now = model.steps.back().begin;
    for (Words words; in.next_line(words);)
      {
        const auto is_it = [&](const DeckModel::Pair &one) {
          return words.size() > 1 && upper_case(one.slave) == upper_case(words[0]) &&
                 upper_case(one.master) == upper_case(words[1]);
        };
        const auto pair = std::find_if(model.pairs.begin(), model.pairs.end(), is_it);
        if (pair == model.pairs.end())
          in.fail("*MODEL CHANGE of a contact pair that is not there above");
        if (pair->is_removed() == adds)
          pair->changes.push_back(now);
      }
  }



  // Data line: two points of the axis. Without TIE it belongs to the only tie.
  void
  DeckReader::read_sectors()
  {
    const std::string tie = upper_case(in.value("TIE"));
    const double      n   = number({in.value("N")}, 0);
    Words             words;
    if (!(n >= 1) || !in.next_line(words) || words.size() < 6)
      in.fail("*CYCLIC SYMMETRY MODEL needs the number N of sectors and two points of the axis");
    // CONTACT makes it part of another analysis.
    if (in.has("CONTACT"))
      {
        skip_item("CONTACT");
        model.lacks_supports = true;
        return;
      }
    bool found = false;
    for (DeckModel::Pair &pair : model.pairs)
      if (pair.cyclic_tie && (tie.empty() || *pair.cyclic_tie == tie))
        {
          pair.sectors = {n, triple(words, 0), triple(words, 3)};
          found        = true;
        }
    if (!found)
      in.fail("*CYCLIC SYMMETRY MODEL of a tie that is not there above");
  }



  // The gap of a pair at the start.
  void
  DeckReader::read_clearance()
  {
    model.clearances.push_back(
      {in.value("SLAVE"), in.value("MASTER"), number({in.value("VALUE")}, 0)});
    if (!in.has("VALUE"))
      in.fail("*CLEARANCE needs VALUE=gap");
  }
} // namespace Signorini
