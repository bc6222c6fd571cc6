// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"
#include <signorini/parameters/raw.h>

// The part of the reader for equations between displacements.

namespace Signorini
{
  // Data lines: the number of terms; then node or set, component and factor of each term, on any
  // number of lines. Where the first node is a set, there is an equation for each of its nodes; the
  // others are sets of as many nodes, or one node.
  void
  DeckReader::read_equations()
  {
    if (in.has("REMOVE") || in_step)
      {
        skip_item(in_step ? "its change in a step" : "REMOVE");
        model.lacks_supports = true;
        return;
      }
    for (Words words; in.next_line(words);)
      {
        const double n = number(words, 0);
        if (!(n >= 1) || n > 1e6)
          in.fail("*EQUATION needs the number of its terms");
        Words all;
        while (all.size() < 3 * n && in.next_line(words))
          for (const std::string &word : words)
            if (!word.empty())
              all.push_back(word);
        if (all.size() != 3 * n)
          in.fail("*EQUATION needs a node, a component and a factor for each of " +
                  std::to_string(int(n)) + " terms");
        add_equations(all);
      }
  }



  // The equations of terms, one for each node of the first set.
  void
  DeckReader::add_equations(const Words &terms)
  {
    std::vector<std::vector<unsigned int>> nodes;
    for (unsigned int i = 0; i < terms.size(); i += 3)
      {
        nodes.push_back(nodes_of(terms[i]));
        if (nodes.back().size() != 1 && nodes.back().size() != nodes[0].size())
          in.fail("*EQUATION: '" + terms[i] + "' has " + std::to_string(nodes.back().size()) +
                  " nodes, and '" + terms[0] + "' " + std::to_string(nodes[0].size()));
      }
    for (unsigned int k = 0; k < nodes[0].size(); ++k)
      {
        DeckModel::Equation equation;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            const unsigned int d = component(terms, 3 * i + 1);
            if (d < 1 || d > 3)
              {
                skip_item("of rotations, temperatures and the like");
                model.lacks_supports = true;
                return;
              }
            equation.push_back(
              {nodes[i][nodes[i].size() == 1 ? 0 : k], d - 1, number(terms, 3 * i + 2)});
          }
        model.equations.push_back(equation);
      }
  }
} // namespace Signorini
