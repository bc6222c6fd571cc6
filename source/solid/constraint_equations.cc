// SPDX-License-Identifier: Apache-2.0
#include <signorini/parameters/raw.h>
#include <signorini/parameters/section.h>
#include <signorini/solid/constraint_equations.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace Signorini
{
  namespace
  {
    /// The term "FACTOR NODE COMPONENT"; names of nodes may have blanks. Throws SceneError.
    template <int dim>
    typename ConstraintEquations<dim>::Term
    term_of(const std::string &text)
    {
      std::vector<std::string> words;
      std::istringstream       in(text);
      for (std::string word; in >> word;)
        words.push_back(word);
      const std::string axes = std::string("xyz").substr(0, dim);
      if (words.size() < 3 || words.back().size() != 1 ||
          axes.find(words.back()) == std::string::npos)
        throw SceneError("the term '" + text +
                         "' is not FACTOR BODY.NODE COMPONENT, as in 1 block.12 x");
      char        *end    = nullptr;
      const double factor = std::strtod(words[0].c_str(), &end);
      if (*end != 0 || !std::isfinite(factor) || factor == 0)
        throw SceneError("the term '" + text + "' begins with '" + words[0] +
                         "', which is no factor other than zero");
      std::string node = words[1];
      for (unsigned int i = 2; i + 1 < words.size(); ++i)
        node += " " + words[i];
      return {factor, node, static_cast<unsigned int>(axes.find(words.back()))};
    }
  } // namespace



  template <int dim>
  void
  ConstraintEquations<dim>::declare(Section &section)
  {
    section.add(
      "Equations",
      text,
      "linear equations between displacements of nodes of mesh files, separated by ';': terms "
      "FACTOR BODY.NODE COMPONENT, separated by ','. 1 block.12 x, -1 block.13 x: both have "
      "the same displacement along x");
    section.add("Value", value, "right-hand side of all these equations: a formula in t [length]");
    if (!section.reading())
      return;
    place = section.source_of("Equations");
    if (value.depends_on_place())
      section.fail("Value", "depends on x, y or z; use a formula in t alone");
    equations.clear();
    for (const std::string &equation : split(text, ';'))
      {
        equations.emplace_back();
        for (const std::string &term : split(equation, ','))
          try
            {
              equations.back().push_back(term_of<dim>(term));
            }
          catch (const SceneError &error)
            {
              section.fail("Equations", error.what());
            }
      }
    if (equations.empty())
      section.fail("Equations", "is required");
  }



  template struct ConstraintEquations<2>;
  template struct ConstraintEquations<3>;
} // namespace Signorini
