// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// Linear equations between components of the displacements of nodes, sum_k a_k u_k = b, all with
  /// the same right-hand side b.
  template <int dim>
  struct ConstraintEquations
  {
    /// a u, with a component of the displacement of a node.
    struct Term
    {
      double       factor;
      std::string  node; ///< "body.number"
      unsigned int component;
    };

    std::string name;
    std::string place; ///< in the scene file, for messages
    /// The terms of each equation.
    std::vector<std::vector<Term>> equations;
    /// b, as a formula in t [length].
    Expression<dim> value;

    /// Declare the keys. Throws SceneError through the section for equations that are not
    /// understood.
    void
    declare(Section &section);

  private:
    std::string text; ///< of the equations
  };
} // namespace Signorini
