// SPDX-License-Identifier: Apache-2.0
#include "solid/equation_lines.h"

#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Index = types::global_dof_index;

    /// Add factor times `other` to a list of terms; terms of one degree of freedom are summed.
    void
    add(const double                                 factor,
        const std::vector<std::pair<Index, double>> &other,
        std::vector<std::pair<Index, double>>       &terms)
    {
      for (const auto &[dof, weight] : other)
        {
          const auto same = std::find_if(terms.begin(), terms.end(), [dof = dof](const auto &term) {
            return term.first == dof;
          });
          if (same == terms.end())
            terms.emplace_back(dof, factor * weight);
          else
            same->second += factor * weight;
        }
    }

    /// The constraint of a degree of freedom, from the rank that owns it.
    struct OwnedLine
    {
      Index                                 dof;
      std::vector<std::pair<Index, double>> entries;
      double                                value;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &dof &entries &value;
      }
    };
  } // namespace



  template <int dim>
  EquationLines<dim>::EquationLines(const std::vector<ConstraintEquations<dim>> &sets)
    : sets(sets)
  {}



  template <int dim>
  std::vector<std::vector<typename EquationLines<dim>::Term>>
  EquationLines<dim>::terms() const
  {
    std::vector<std::vector<Term>> result;
    for (unsigned int s = 0; s < first_dofs.size(); ++s)
      for (unsigned int e = 0; e < first_dofs[s].size(); ++e)
        {
          result.emplace_back();
          for (unsigned int k = 0; k < first_dofs[s][e].size(); ++k)
            result.back().push_back({&my_nodes.at(first_dofs[s][e][k]),
                                     sets[s].equations[e][k].component,
                                     sets[s].equations[e][k].factor});
        }
    return result;
  }



  template <int dim>
  std::vector<Index>
  EquationLines<dim>::dofs() const
  {
    std::vector<Index> result;
    for (const auto &[first, node] : my_nodes)
      result.insert(result.end(), node.dofs.begin(), node.dofs.end());
    std::sort(result.begin(), result.end());
    return result;
  }



  // Supports are known on the ranks whose cells have their nodes. Here all ranks get those of the
  // nodes of equations. Collective.
  template <int dim>
  void
  EquationLines<dim>::exchange_lines(AffineConstraints<double> &constraints,
                                     const IndexSet            &owned,
                                     const MPI_Comm             comm) const
  {
    std::vector<OwnedLine> lines;
    for (const Index dof : dofs())
      if (owned.is_element(dof) && constraints.is_constrained(dof))
        lines.push_back(
          {dof, *constraints.get_constraint_entries(dof), constraints.get_inhomogeneity(dof)});
    for (const auto &of_rank : Utilities::MPI::all_gather(comm, lines))
      for (const OwnedLine &line : of_rank)
        if (!constraints.is_constrained(line.dof))
          {
            constraints.add_line(line.dof);
            for (const auto &[other, weight] : line.entries)
              constraints.add_entry(line.dof, other, weight);
            constraints.set_inhomogeneity(line.dof, line.value);
          }
  }



  namespace
  {
    /// Gauss-Jordan elimination of equations sum_k a_k u_k = b, one after the other: what
    /// constraints and earlier equations determine is eliminated from each; then it is solved for
    /// its largest term, the first of several, and that is eliminated from the earlier equations.
    /// So no line depends on the degree of freedom of another one.
    class Elimination
    {
    public:
      using Terms = std::vector<std::pair<Index, double>>;

      /// @param constraints those that the equations come on top of
      explicit Elimination(const AffineConstraints<double> &constraints)
        : constraints(constraints)
      {}

      /// @return false if the equation contradicts the constraints or earlier equations.
      bool
      add_equation(const Terms &terms, const double value)
      {
        Line   next{{}, value};
        double largest = 0, scale = std::abs(value);
        for (const auto &[dof, factor] : terms)
          {
            largest = std::max(largest, std::abs(factor));
            if (!constraints.is_constrained(dof))
              {
                eliminate(factor, dof, next, scale);
                continue;
              }
            const double prescribed = factor * constraints.get_inhomogeneity(dof);
            next.value -= prescribed;
            scale = std::max(scale, std::abs(prescribed));
            for (const auto &[other, weight] : *constraints.get_constraint_entries(dof))
              eliminate(factor * weight, other, next, scale);
          }
        next.terms.erase(std::remove_if(next.terms.begin(),
                                        next.terms.end(),
                                        [&](const auto &term) {
                                          return std::abs(term.second) < 1e-10 * largest;
                                        }),
                         next.terms.end());
        if (next.terms.empty()) // it follows from the others, or contradicts them
          return std::abs(next.value) <= 1e-8 * scale;
        solve(next);
        return true;
      }

      /// Add the lines of all equations.
      void
      add_to(AffineConstraints<double> &all) const
      {
        for (const auto &[dof, line] : lines)
          {
            all.add_line(dof);
            for (const auto &[other, weight] : line.terms)
              all.add_entry(dof, other, weight);
            all.set_inhomogeneity(dof, line.value);
          }
      }

    private:
      /// u = sum of the terms + value; of an equation: sum of the terms = value.
      struct Line
      {
        Terms  terms;
        double value;
      };

      /// Add factor times u(dof) to an equation, by the line of that if there is one.
      void
      eliminate(const double factor, const Index dof, Line &equation, double &scale) const
      {
        const auto line = lines.find(dof);
        if (line == lines.end())
          {
            add(factor, {{dof, 1.}}, equation.terms);
            return;
          }
        add(factor, line->second.terms, equation.terms);
        equation.value -= factor * line->second.value;
        scale = std::max(scale, std::abs(factor * line->second.value));
      }

      /// Make the line of an equation, and eliminate its degree of freedom from the others.
      void
      solve(Line &equation)
      {
        auto pivot = equation.terms.begin();
        for (auto term = equation.terms.begin(); term != equation.terms.end(); ++term)
          if (std::abs(term->second) > (1 + 1e-6) * std::abs(pivot->second))
            pivot = term;
        const auto [dof, factor] = *pivot;
        equation.terms.erase(pivot);
        Line line{{}, equation.value / factor};
        add(-1 / factor, equation.terms, line.terms);
        for (const Index user : users[dof])
          {
            Line      &other = lines.at(user);
            const auto at =
              std::find_if(other.terms.begin(), other.terms.end(), [dof = dof](const auto &term) {
                return term.first == dof;
              });
            if (at == other.terms.end())
              continue;
            const double share = at->second;
            other.terms.erase(at);
            add(share, line.terms, other.terms);
            other.value += share * line.value;
            for (const auto &term : line.terms)
              users[term.first].insert(user);
          }
        for (const auto &term : line.terms)
          users[term.first].insert(dof);
        lines[dof] = line;
      }

      const AffineConstraints<double> &constraints;
      std::map<Index, Line>            lines; ///< by their degrees of freedom
      std::map<Index, std::set<Index>> users; ///< the lines that depend on a degree of freedom
    };
  } // namespace



  template <int dim>
  void
  EquationLines<dim>::add_to(AffineConstraints<double> &constraints,
                             const IndexSet            &owned,
                             const double               t,
                             const MPI_Comm             comm) const
  {
    if (empty())
      return;
    exchange_lines(constraints, owned, comm);
    Elimination elimination(constraints);
    // Middles of faces that supports hold follow these.
    for (const Equation &middle : of_middles)
      if (!constraints.is_constrained(middle.terms[0].first))
        elimination.add_equation(middle.terms, middle.value);
    const auto equations = terms();
    auto       equation  = equations.begin();
    for (const ConstraintEquations<dim> &set : sets)
      {
        const double value = set.value.value(Point<dim>(), t);
        if (!std::isfinite(value))
          throw SceneError(
            "Constraint equations/" + set.name + "/Value = " + shortened(set.value.formula()) +
            ": is not a finite number at t = " + std::to_string(t) + "; correct the formula");
        for (unsigned int e = 0; e < set.equations.size(); ++e, ++equation)
          {
            Elimination::Terms by_dof;
            for (const Term &term : *equation)
              by_dof.emplace_back(term.node->dofs[term.component], term.factor);
            if (!elimination.add_equation(by_dof, value))
              throw SceneError(set.place + ": equation " + std::to_string(e + 1) +
                               " contradicts supports or other equations at t = " +
                               std::to_string(t) + "; remove it, or free a component");
          }
      }
    elimination.add_to(constraints);
  }



  template class EquationLines<2>;
  template class EquationLines<3>;
} // namespace Signorini
