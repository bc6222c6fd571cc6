// SPDX-License-Identifier: Apache-2.0
#include "checkpoint/cells.h"

#include "mesh/cells_by_name.h"
#include <signorini/parameters/raw.h>

#include <deal.II/distributed/tria.h>

#include <cmath>
#include <map>
#include <string>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the ids of the cells of this rank.
    template <int dim>
    std::vector<CellId>
    owned_cells(const Mesh<dim> &mesh)
    {
      std::vector<CellId> result;
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          result.push_back(cell->id());
      return result;
    }

    /// Throw SceneError: the mesh differs from that of the checkpoint.
    [[noreturn]] void
    reject_mesh(const std::string &why)
    {
      throw SceneError("--restart: the mesh is not the one of the checkpoint: " + why +
                       "; restore mesh files that were changed, or solve the scene from the start");
    }
  } // namespace



  // Each value belongs to the first cell of its owner that has it. Values are identified by the
  // cell and the position in its list of degrees of freedom, not by numbers, which depend on the
  // partition.
  template <int dim>
  std::vector<CellValues>
  values_of_cells(const Elasticity<dim> &elasticity, const LA::Vector &u)
  {
    const IndexSet                      &owned = elasticity.dof_handler().locally_owned_dofs();
    std::vector<bool>                    is_sent(owned.n_elements());
    std::vector<types::global_dof_index> indices;
    std::vector<CellValues>              result;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          indices.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(indices);
          CellValues one{cell->id(), std::vector<std::uint8_t>((indices.size() + 7) / 8), {}};
          for (unsigned int i = 0; i < indices.size(); ++i)
            {
              if (!owned.is_element(indices[i]))
                continue;
              const auto k = owned.index_within_set(indices[i]);
              if (is_sent[k])
                continue;
              is_sent[k] = true;
              one.which[i / 8] |= 1 << (i % 8);
              one.values.push_back(u(indices[i]));
            }
          result.push_back(std::move(one));
        }
    return result;
  }



  // Values of owned cells are fetched from the ranks that have read them, by gather_values().
  template <int dim>
  LA::Vector
  vector_of_cells(const Elasticity<dim> &elasticity, const std::vector<CellValues> &cells)
  {
    std::map<CellId, CellValues> known;
    for (const CellValues &cell : cells)
      known[cell.cell] = cell;
    const auto values =
      gather_values(known, owned_cells(elasticity.mesh()), elasticity.mesh().communicator());
    // Each value occurs once, so that the sum over ranks is the value itself.
    LA::Vector                           sum = elasticity.zero_vector();
    std::vector<types::global_dof_index> indices;
    bool                                 fits = true;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          indices.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(indices);
          const auto found = values.find(cell->id());
          fits =
            fits && found != values.end() && found->second.which.size() == (indices.size() + 7) / 8;
          if (!fits)
            break;
          auto value = found->second.values.begin();
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (found->second.which[i / 8] & (1 << (i % 8)))
              sum(indices[i]) += *value++;
        }
    if (Utilities::MPI::min(int(fits), elasticity.mesh().communicator()) == 0)
      reject_mesh("cells or degrees of freedom differ");
    sum.compress(VectorOperation::add);
    return sum;
  }



  // Active cells of the checkpoint imply the refinement of all their ancestors. In each pass cells
  // that must have children are refined, and those that the checkpoint does not contain are
  // coarsened, until nothing changes; passes are limited in case that the mesh cannot be
  // reproduced.
  template <int dim>
  void
  restore_cells(Mesh<dim> &mesh, const std::vector<CellValues> &cells)
  {
    std::map<CellId, bool> is_active; // false: has children
    // All ancestors of an active cell have children. The path from the coarse cell to a cell is
    // shortened by one child after the other, until an ancestor is known already.
    for (const CellValues &one : cells)
      {
        is_active[one.cell] = true;
        const auto view     = one.cell.get_child_indices();
        for (std::vector<std::uint8_t> path(view.begin(), view.end()); !path.empty();)
          {
            path.pop_back();
            const CellId parent(one.cell.get_coarse_cell_id(), path.size(), path.data());
            if (!is_active.insert({parent, false}).second)
              break;
          }
      }
    auto                  &triangulation = mesh.triangulation();
    constexpr unsigned int most          = 100; // twice as many levels as there can be
    for (unsigned int round = 0; round < most; ++round)
      {
        // Ranks ask for the states of their present cells, which other ranks may have read from the
        // checkpoint.
        const auto   wanted    = gather_values(is_active, owned_cells(mesh), mesh.communicator());
        unsigned int n_changes = 0;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
            {
              const auto found = wanted.find(cell->id());
              if (found == wanted.end() && cell->level() > 0)
                cell->set_coarsen_flag();
              else if (found != wanted.end() && !found->second)
                cell->set_refine_flag();
              else
                continue;
              ++n_changes;
            }
        if (Utilities::MPI::sum(n_changes, mesh.communicator()) == 0)
          return;
        if (!dynamic_cast<parallel::distributed::Triangulation<dim> *>(&triangulation))
          reject_mesh("Mesh/Distribution = METIS produced different cells");
        triangulation.execute_coarsening_and_refinement();
      }
  }



  // Sums over cells, which do not depend on the partition except for rounding.
  template <int dim>
  nlohmann::ordered_json
  mark_of_mesh(const Mesh<dim> &mesh)
  {
    std::uint64_t       hash = 0;
    std::vector<double> moments(2 * dim, 0.);
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          hash += hash_of(cell->id());
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double x = cell->center()[d] / mesh.size();
              moments[d] += x;
              moments[dim + d] += x * x;
            }
        }
    Utilities::MPI::sum(moments, mesh.communicator(), moments);
    const auto n = mesh.triangulation().n_global_active_cells();
    for (double &moment : moments)
      moment /= n;
    // As a text: not all JSON readers have integers of 64 bits.
    return {{"cells", n},
            {"names", std::to_string(Utilities::MPI::sum(hash, mesh.communicator()))},
            {"centres", moments}};
  }



  template <int dim>
  void
  check_mark(const Mesh<dim> &mesh, const nlohmann::ordered_json &mark)
  {
    const auto now = mark_of_mesh(mesh);
    if (now["cells"] != mark["cells"])
      reject_mesh("it has " + now["cells"].dump() + " cells instead of " + mark["cells"].dump());
    if (now["names"] != mark["names"])
      reject_mesh("different cells are refined");
    for (unsigned int i = 0; i < 2 * dim; ++i)
      {
        const double a = now["centres"][i], b = mark["centres"][i];
        if (!(std::abs(a - b) <= 1e-9 * (1 + std::abs(b))))
          reject_mesh("cells are at different positions");
      }
  }



#define INSTANTIATE(dim)                                                                           \
  template std::vector<CellValues> values_of_cells(const Elasticity<dim> &, const LA::Vector &);   \
  template LA::Vector vector_of_cells(const Elasticity<dim> &, const std::vector<CellValues> &);   \
  template void       restore_cells(Mesh<dim> &, const std::vector<CellValues> &);                 \
  template nlohmann::ordered_json mark_of_mesh(const Mesh<dim> &);                                 \
  template void                   check_mark(const Mesh<dim> &, const nlohmann::ordered_json &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
