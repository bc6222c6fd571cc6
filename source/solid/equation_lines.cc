// SPDX-License-Identifier: Apache-2.0
#include "solid/equation_lines.h"

#include "solid/cell_nodes.h"
#include "solid/node_location.h"
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

    /// A node of an equation, from the rank that owns it.
    template <int dim>
    struct FoundNode
    {
      unsigned int        number; ///< of the name
      std::vector<Index>  dofs;
      std::vector<double> position;
      unsigned int        piece;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &number &dofs &position &piece;
      }
    };

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



  // Each node is found by its place in the coarse cells that have it, in one pass over the cells of
  // this rank, and told to all ranks by its owner.
  template <int dim>
  void
  EquationLines<dim>::find_nodes(const Mesh<dim>                 &mesh,
                                 const DoFHandler<dim>           &dofs,
                                 const AffineConstraints<double> &hanging)
  {
    my_nodes.clear();
    first_dofs.clear();
    if (empty())
      return;
    std::map<std::string, unsigned int>                                      numbers;
    std::vector<std::string>                                                 names, places;
    std::map<unsigned int, std::vector<std::pair<Point<dim>, unsigned int>>> by_cell;
    for (const ConstraintEquations<dim> &set : sets)
      for (const auto &equation : set.equations)
        for (const auto &term : equation)
          if (numbers.insert({term.node, names.size()}).second)
            {
              const NodeSet<dim> found = mesh.node_set(term.node);
              if (found.size() != 1)
                throw SceneError(set.place + ": '" + term.node + "' is not one node, but " +
                                 std::to_string(found.size()));
              for (const NodeLocation<dim> &place : found[0])
                by_cell[place.cell].emplace_back(place.unit, names.size());
              names.push_back(term.node);
              places.push_back(set.place);
            }
    std::vector<FoundNode<dim>> found;
    std::vector<bool>           is_found(names.size(), false);
    std::vector<Index>          indices;
    CellNodes<dim>              nodes_of(mesh, dofs.get_fe_collection());
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        if (const auto here = by_cell.find(cell->id().get_coarse_cell_id()); here != by_cell.end())
          {
            const FiniteElement<dim> &fe = cell->get_fe();
            read_indices<dim>(cell, indices);
            for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell(); ++i)
              {
                const Point<dim> unit =
                  in_coarse_cell(cell->id(), fe.base_element(0).unit_support_point(i));
                for (const auto &[place, number] : here->second)
                  if (!is_found[number] && place.distance_square(unit) < 1e-20)
                    {
                      FoundNode<dim> node{number, {}, {}, mesh.piece(cell)};
                      for (unsigned int d = 0; d < dim; ++d)
                        {
                          node.dofs.push_back(indices[fe.component_to_system_index(d, i)]);
                          node.position.push_back(
                            nodes_of(cell)[fe.component_to_system_index(0, i)][d]);
                        }
                      if (!dofs.locally_owned_dofs().is_element(node.dofs[0]) ||
                          hanging.is_constrained(node.dofs[0]))
                        continue;
                      is_found[number] = true;
                      found.push_back(node);
                    }
              }
          }
    std::vector<Index> first(names.size(), numbers::invalid_dof_index);
    for (const auto &of_rank : Utilities::MPI::all_gather(mesh.communicator(), found))
      for (const FoundNode<dim> &node : of_rank)
        {
          ConstrainedNode<dim> one;
          for (unsigned int d = 0; d < dim; ++d)
            {
              one.dofs[d]     = node.dofs[d];
              one.position[d] = node.position[d];
            }
          one.piece          = node.piece;
          first[node.number] = one.dofs[0];
          my_nodes.emplace(one.dofs[0], one);
        }
    for (unsigned int n = 0; n < names.size(); ++n)
      if (first[n] == numbers::invalid_dof_index)
        throw SceneError(places[n] + ": '" + names[n] +
                         "' is no node of the finite-element mesh, or it hangs at a refined "
                         "neighbour; choose a corner of cells");
    for (const ConstraintEquations<dim> &set : sets)
      {
        first_dofs.emplace_back();
        for (const auto &equation : set.equations)
          {
            first_dofs.back().emplace_back();
            for (const auto &term : equation)
              first_dofs.back().back().push_back(first[numbers.at(term.node)]);
          }
      }
  }



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



  // Gauss-Jordan elimination: what supports and earlier equations determine is eliminated from each
  // equation; then it is solved for its largest term, the first of several, and that is eliminated
  // from the earlier equations. So no line depends on the degree of freedom of another one.
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
    std::map<Index, Equation>        lines; // u_dof = sum of the terms + value, by dof
    std::map<Index, std::set<Index>> uses;  // the lines that depend on a degree of freedom
    for (unsigned int s = 0; s < sets.size(); ++s)
      for (unsigned int e = 0; e < sets[s].equations.size(); ++e)
        {
          const double value = sets[s].value.value(Point<dim>(), t);
          if (!std::isfinite(value))
            throw SceneError("Constraint equations/" + sets[s].name +
                             "/Value = " + shortened(sets[s].value.formula()) +
                             ": is not a finite number at t = " + std::to_string(t) +
                             "; correct the formula");
          Equation next{{}, value};
          double   largest = 0, scale = std::abs(value);
          // A constrained degree of freedom is replaced by what it depends on.
          const auto add_dof = [&](const double factor, const Index dof) {
            if (const auto line = lines.find(dof); line != lines.end())
              {
                add(factor, line->second.terms, next.terms);
                next.value -= factor * line->second.value;
                scale = std::max(scale, std::abs(factor * line->second.value));
              }
            else
              add(factor, {{dof, 1.}}, next.terms);
          };
          for (unsigned int k = 0; k < sets[s].equations[e].size(); ++k)
            {
              const auto &term = sets[s].equations[e][k];
              const Index dof  = my_nodes.at(first_dofs[s][e][k]).dofs[term.component];
              largest          = std::max(largest, std::abs(term.factor));
              if (!constraints.is_constrained(dof))
                {
                  add_dof(term.factor, dof);
                  continue;
                }
              const double prescribed = constraints.get_inhomogeneity(dof);
              next.value -= term.factor * prescribed;
              scale = std::max(scale, std::abs(term.factor * prescribed));
              for (const auto &[other, weight] : *constraints.get_constraint_entries(dof))
                add_dof(term.factor * weight, other);
            }
          const auto is_rounding = [&](const auto &term) {
            return std::abs(term.second) < 1e-10 * largest;
          };
          next.terms.erase(std::remove_if(next.terms.begin(), next.terms.end(), is_rounding),
                           next.terms.end());
          if (next.terms.empty())
            {
              if (std::abs(next.value) > 1e-8 * scale)
                throw SceneError(sets[s].place + ": equation " + std::to_string(e + 1) +
                                 " contradicts supports or other equations at t = " +
                                 std::to_string(t) + "; remove it, or free a component");
              continue; // it follows from the others
            }
          auto pivot = next.terms.begin();
          for (auto term = next.terms.begin(); term != next.terms.end(); ++term)
            if (std::abs(term->second) > (1 + 1e-6) * std::abs(pivot->second))
              pivot = term;
          const auto [dof, factor] = *pivot;
          next.terms.erase(pivot);
          Equation line{{}, next.value / factor};
          add(-1 / factor, next.terms, line.terms);
          for (const Index user : uses[dof])
            {
              Equation  &other = lines.at(user);
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
                uses[term.first].insert(user);
            }
          for (const auto &term : line.terms)
            uses[term.first].insert(dof);
          lines[dof] = line;
        }
    for (const auto &[dof, line] : lines)
      {
        constraints.add_line(dof);
        for (const auto &[other, weight] : line.terms)
          constraints.add_entry(dof, other, weight);
        constraints.set_inhomogeneity(dof, line.value);
      }
  }



  template class EquationLines<2>;
  template class EquationLines<3>;
} // namespace Signorini
