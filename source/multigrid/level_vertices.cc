// SPDX-License-Identifier: Apache-2.0
#include "multigrid/levels.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Index = types::global_dof_index;

    constexpr unsigned int space_dim = 3;

    /// The mesh of a DoFHandler, which must be distributed.
    const parallel::distributed::Triangulation<space_dim> &
    distributed(const DoFHandler<space_dim> &dofs)
    {
      return dynamic_cast<const parallel::distributed::Triangulation<space_dim> &>(
        dofs.get_triangulation());
    }

    /// A request for the name of the vertex at a corner of a leaf of another rank.
    struct NumberRequest
    {
      SpaceFillingCurve::Position position; ///< of the leaf
      unsigned int                corner;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &position.first &position.second &corner;
      }
    };

    /// The name of a vertex, and the constraints of its components.
    struct Answer
    {
      Index                                                     name;
      std::vector<std::pair<unsigned int, LevelVertices::Line>> lines; ///< by component

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &name &lines;
      }
    };

    void
    sort_unique(std::vector<Index> &list)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  } // namespace



  // The name of a vertex on all levels is its first degree of freedom on the finest mesh. Names at
  // vertices of owned cells are read from the degrees of freedom; those of vertices of coarser
  // cells whose leaf is on another rank are requested.
  LevelVertices::LevelVertices(const DoFHandler<space_dim>     &dofs,
                               const AffineConstraints<double> &hanging,
                               const AffineConstraints<double> &constraints)
    : my_curve(distributed(dofs))
    , my_names(dofs.locally_owned_dofs())
    , has_line(my_names.size(), false)
    , names(dofs.get_triangulation().n_vertices(), numbers::invalid_dof_index)
  {
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          // The first component of a vertex names it on all levels. Kernels assume three
          // consecutive components, which is asserted once here.
          if (Index &name = names[cell->vertex_index(v)]; name == numbers::invalid_dof_index)
            {
              name = cell->vertex_dof_index(v, 0, cell->active_fe_index());
              AssertThrow(name % space_dim == 0 &&
                            cell->vertex_dof_index(v, 2, cell->active_fe_index()) == name + 2,
                          ExcInternalError("Components of a node are not one after the other."));
              for (unsigned int c = 0; c < space_dim; ++c)
                if (const auto *entries = constraints.get_constraint_entries(name + c))
                  {
                    lines[name + c] = {*entries, hanging.is_constrained(name + c)};
                    if (my_names.has(name))
                      has_line[my_names.local_index(name + c)] = true;
                  }
            }
    query_other_ranks(distributed(dofs).get_communicator());
  }



  // Request the names and constraints of corners of ancestors whose leaf at the corner is on
  // another rank. Two exchanges between neighbours. Collective.
  void
  LevelVertices::query_other_ranks(const MPI_Comm comm)
  {
    // The leaf at the corner of an ancestor has that vertex as its corner of the same number. The
    // curve tells its owner, which knows the name, without a search. Each vertex is asked for once.
    std::map<unsigned int, std::vector<NumberRequest>> questions;
    std::map<unsigned int, std::vector<unsigned int>>  asked; // numbers of vertices
    std::vector<bool>                                  is_asked(names.size(), false);
    for (const SpaceFillingCurve::PlacedCell &local_index : my_curve.ancestors())
      for (unsigned int v = 0; v < GeometryInfo<space_dim>::vertices_per_cell; ++v)
        if (const unsigned int vertex = local_index.cell->vertex_index(v);
            names[vertex] == numbers::invalid_dof_index && !is_asked[vertex])
          {
            const SpaceFillingCurve::Position position =
              SpaceFillingCurve::at_corner(local_index, v);
            const unsigned int rank = my_curve.owner(position);
            questions[rank].push_back({position, v});
            asked[rank].push_back(vertex);
            is_asked[vertex] = true;
          }
    // Answers to the requests of other ranks: names, and the constraints of the three components.

    std::map<unsigned int, std::vector<Answer>> answers;
    for (const auto &[rank, list] : Utilities::MPI::some_to_some(comm, questions))
      for (const NumberRequest &question : list)
        {
          Answer answer{name(my_curve.leaf(question.position).cell, question.corner), {}};
          for (unsigned int c = 0; c < space_dim; ++c)
            if (const Line *of_dof = line(answer.name + c))
              answer.lines.emplace_back(c, *of_dof);
          answers[rank].push_back(answer);
          // Answers have the order of the requests.
        }
    for (const auto &[rank, list] : Utilities::MPI::some_to_some(comm, answers))
      for (unsigned int i = 0; i < list.size(); ++i)
        {
          names[asked[rank][i]] = list[i].name;
          for (const auto &[c, of_dof] : list[i].lines)
            lines[list[i].name + c] = of_dof;
        }
  }



  // The constraints of a vertex may refer to vertices that no cell of this rank has.
  void
  LevelVertices::add_masters(std::vector<Index> &list) const
  {
    // Entries that are appended are not examined again: deal.II resolves chains of constraints when
    // they are closed, so that masters are not constrained themselves.
    const std::size_t n = list.size();
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned int c = 0; c < space_dim; ++c)
        if (const Line *of_dof = line(list[i] + c))
          for (const auto &entry : of_dof->entries)
            list.push_back(entry.first - entry.first % space_dim);
  }



  namespace
  {
    /// The owners of the degrees of freedom of the finest mesh, by the ranges of the ranks.
    class Owners
    {
    public:
      Owners(const IndexSet &owned, const MPI_Comm comm)
      {
        // Ranks own contiguous ranges in their order, so that the ends of the ranges determine the
        // owner by bisection.
        Index end = 0;
        for (const auto n : Utilities::MPI::all_gather(comm, owned.n_elements()))
          ends.push_back(end += n);
      }

      unsigned int
      operator()(const Index dof) const
      {
        return std::upper_bound(ends.begin(), ends.end(), dof) - ends.begin();
      }

      /// The degrees of freedom of a list that other ranks own, each once, by rank.
      std::map<unsigned int, std::vector<Index>>
      from_other_ranks(const std::vector<Index> &list, const LA::OwnRange &own) const
      {
        std::vector<Index> others;
        for (const Index dof : list)
          if (!own.has(dof))
            others.push_back(dof);
        sort_unique(others);
        std::map<unsigned int, std::vector<Index>> result;
        for (const Index dof : others)
          result[(*this)(dof)].push_back(dof);
        return result;
      }

    private:
      std::vector<Index> ends;
    };
  } // namespace



  // Vertices of cells of this level are numbered on the rank that owns their name. Each rank
  // announces the corners of its cells to their owners, the owners number them contiguously over
  // the ranks, and the numbers of known names of other ranks are requested. Three exchanges between
  // neighbours. Collective.
  VertexNumbers::VertexNumbers(const std::vector<Index> &corners,
                               const std::vector<Index> &known,
                               const IndexSet           &owned,
                               const unsigned int        n_rigid,
                               const MPI_Comm            comm)
    : on_finest(owned)
    , numbers(on_finest.size() / space_dim, dealii::numbers::invalid_dof_index)
  {
    const Owners owners(owned, comm);
    // Which of the names of this rank occur as corners, on any rank.
    std::vector<bool> is_present(numbers.size(), false);
    for (const Index name : corners)
      if (on_finest.has(name))
        is_present[on_finest.local_index(name) / space_dim] = true;
    for (const auto &[rank, list] :
         Utilities::MPI::some_to_some(comm, owners.from_other_ranks(corners, on_finest)))
      for (const Index name : list)
        is_present[on_finest.local_index(name) / space_dim] = true;
    for (std::size_t i = 0; i < is_present.size(); ++i)
      if (is_present[i])
        my_names.push_back(on_finest.dof(space_dim * i));

    // Contiguous numbers; three degrees of freedom for each vertex, those of rigid bodies last on
    // the last rank.
    // The numbers of a rank follow those of the ranks before it, in the order of the names.
    const auto  counts = Utilities::MPI::all_gather(comm, my_names.size());
    const auto  rank   = Utilities::MPI::this_mpi_process(comm);
    const Index before = std::accumulate(counts.begin(), counts.begin() + rank, Index(0)),
                all    = std::accumulate(counts.begin(), counts.end(), Index(0));
    my_owned           = IndexSet(3 * all + n_rigid);
    my_owned.add_range(3 * before, 3 * (before + my_names.size()));
    if (rank + 1 == counts.size())
      my_owned.add_range(3 * all, 3 * all + n_rigid);
    for (unsigned int i = 0; i < my_names.size(); ++i)
      numbers[on_finest.local_index(my_names[i]) / space_dim] = before + i;

    // Numbers of vertices of other ranks; names that are no vertices of this level have none.
    const auto questions = owners.from_other_ranks(known, on_finest);
    std::map<unsigned int, std::vector<Index>> answers;
    for (const auto &[other, list] : Utilities::MPI::some_to_some(comm, questions))
      for (const Index name : list)
        answers[other].push_back(number(name));
    for (const auto &[other, list] : Utilities::MPI::some_to_some(comm, answers))
      for (unsigned int i = 0; i < list.size(); ++i)
        if (list[i] != dealii::numbers::invalid_dof_index)
          numbers_of_others[questions.at(other)[i]] = list[i];
  }
} // namespace Signorini
