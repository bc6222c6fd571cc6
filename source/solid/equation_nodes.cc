// SPDX-License-Identifier: Apache-2.0
#include "mesh/face_nodes.h"
#include "solid/cell_nodes.h"
#include "solid/equation_lines.h"
#include "solid/node_location.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

// The nodes of constraint equations.

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Index   = types::global_dof_index;
    using Weights = std::vector<std::pair<Index, double>>;

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
  } // namespace



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
              const auto found = mesh.node_set(term.node).nodes;
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
          first[node.number] = node.dofs[0];
          add_node(node.dofs, node.position, node.piece);
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
    find_middles_of_faces(mesh, dofs);
  }



  namespace
  {
    /// The middle of a face of a cell of degree two, and the other nodes there with the weights by
    /// which functions of elements of 20 nodes have their value in the middle: -1/4 of corners and
    /// 1/2 of the middles of edges.
    struct FaceMiddle
    {
      unsigned int                                 middle = 0;
      std::vector<std::pair<unsigned int, double>> others;

      template <int dim>
      FaceMiddle(const FiniteElement<dim> &scalar, const unsigned int face)
      {
        // On the edges of the face one coordinate is 1/2, in its middle two are.
        for (const unsigned int i : nodes_of_face(scalar, face))
          {
            unsigned int halves = 0;
            for (unsigned int d = 0; d < dim; ++d)
              halves += std::abs(scalar.unit_support_point(i)[d] - 0.5) < 1e-10;
            if (halves == 2)
              middle = i;
            else
              others.emplace_back(i, halves == 0 ? -0.25 : 0.5);
          }
      }
    };
  } // namespace



  // Collective.
  template <int dim>
  void
  EquationLines<dim>::find_middles_of_faces(const Mesh<dim> &mesh, const DoFHandler<dim> &dofs)
  {
    of_middles.clear();
    if (dim == 2)
      return;
    std::set<Index> in_equations, seen;
    for (const auto &equation : terms())
      for (const Term &term : equation)
        in_equations.insert(term.node->dofs[term.component]);
    std::vector<FoundNode<dim>>            found;
    std::vector<std::pair<Index, Weights>> lines;
    std::vector<Index>                     indices;
    CellNodes<dim>                         nodes_of(mesh, dofs.get_fe_collection());
    for (const auto &cell : dofs.active_cell_iterators())
      // Simplices have no nodes in the middle of faces.
      if (cell->is_locally_owned() && cell->get_fe().degree == 2 &&
          cell->reference_cell().is_hyper_cube())
        {
          const FiniteElement<dim> &fe = cell->get_fe();
          read_indices<dim>(cell, indices);
          const auto dof = [&](const unsigned int i, const unsigned int c) {
            return indices[fe.component_to_system_index(c, i)];
          };
          for (const unsigned int f : cell->face_indices())
            {
              const FaceMiddle face(fe.base_element(0), f);
              const Index      first = dof(face.middle, 0);
              // A face between two cells is met twice.
              if (!dofs.locally_owned_dofs().is_element(first) || !seen.insert(first).second)
                continue;
              const std::size_t n_before = lines.size();
              for (unsigned int c = 0; c < dim; ++c)
                if (std::all_of(face.others.begin(), face.others.end(), [&](const auto &other) {
                      return in_equations.count(dof(other.first, c)) > 0;
                    }))
                  {
                    lines.emplace_back(dof(face.middle, c), Weights());
                    for (const auto &[i, weight] : face.others)
                      lines.back().second.emplace_back(dof(i, c), weight);
                  }
              if (lines.size() == n_before)
                continue;
              found.push_back({0, {}, {}, mesh.piece(cell)});
              for (unsigned int d = 0; d < dim; ++d)
                {
                  found.back().dofs.push_back(dof(face.middle, d));
                  found.back().position.push_back(
                    nodes_of(cell)[fe.component_to_system_index(0, face.middle)][d]);
                }
            }
        }
    for (const auto &of_rank : Utilities::MPI::all_gather(mesh.communicator(), found))
      for (const FoundNode<dim> &node : of_rank)
        add_node(node.dofs, node.position, node.piece);
    for (const auto &of_rank : Utilities::MPI::all_gather(mesh.communicator(), lines))
      for (const auto &[middle, others] : of_rank)
        {
          of_middles.push_back({{{middle, 1.}}, 0.});
          for (const auto &[other, weight] : others)
            of_middles.back().terms.emplace_back(other, -weight);
        }
  }



  template <int dim>
  void
  EquationLines<dim>::add_node(const std::vector<Index>  &dofs,
                               const std::vector<double> &position,
                               const unsigned int         piece)
  {
    ConstrainedNode<dim> node;
    for (unsigned int d = 0; d < dim; ++d)
      {
        node.dofs[d]     = dofs[d];
        node.position[d] = position[d];
      }
    node.piece = piece;
    my_nodes.emplace(node.dofs[0], node);
  }



#define INSTANTIATE(dim)                                                                           \
  template void EquationLines<dim>::find_nodes(const Mesh<dim> &,                                  \
                                               const DoFHandler<dim> &,                            \
                                               const AffineConstraints<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
