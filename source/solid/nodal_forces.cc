// SPDX-License-Identifier: Apache-2.0
#include "solid/nodal_forces.h"

#include "solid/node_location.h"

namespace Signorini
{
  using namespace dealii;

  // A total force is shared equally by the nodes of the sets.
  template <int dim>
  Tensor<1, dim>
  NodalForces<dim>::Force::value(const double t) const
  {
    return load->force_at(position, t) + load->total_force.value(position, t) / n_shares;
  }



  template <int dim>
  NodalForces<dim>::NodalForces(const Mesh<dim> &mesh, const std::vector<Load<dim>> &loads)
  {
    for (const Load<dim> &load : loads)
      {
        if (!load.nodes.sets.empty())
          add_set(mesh, load, load.nodes.sets);
        if (!load.nodes.point.empty())
          add_point(mesh, load);
      }
  }



  // Each node of the sets of a load acts once, on the first coarse cell that has it: sets of one
  // load may overlap. Nodes that the mesh import inserted are no nodes of the file, and get no
  // force.
  template <int dim>
  void
  NodalForces<dim>::add_set(const Mesh<dim>                &mesh,
                            const Load<dim>                &load,
                            const std::vector<std::string> &sets)
  {
    const auto precedes = [](const NodeLocation<dim> &a, const NodeLocation<dim> &b) {
      if (a.cell != b.cell)
        return a.cell < b.cell;
      for (unsigned int d = 0; d < dim; ++d)
        if (a.unit[d] != b.unit[d])
          return a.unit[d] < b.unit[d];
      return false;
    };
    std::set<NodeLocation<dim>, decltype(precedes)> nodes(precedes);
    for (const std::string &set : sets)
      for (const auto &places : mesh.node_set(set).nodes)
        // Nodes inserted by the subdivision of cells are left out.
        if (!places.at(0).is_inserted)
          nodes.insert(places.at(0));

    std::map<unsigned int, std::vector<Point<dim>>> by_coarse_cell;
    for (const NodeLocation<dim> &node : nodes)
      by_coarse_cell[node.cell].push_back(node.unit);
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        if (const auto found = by_coarse_cell.find(cell->id().get_coarse_cell_id());
            found != by_coarse_cell.end())
          // The node belongs to exactly one of the active cells that touch it.
          for (Point<dim> unit : found->second)
            if (descend(cell->id(), unit))
              by_cell[cell->active_cell_index()].push_back(
                {&load,
                 unit,
                 mesh.mapping().transform_unit_to_real_cell(cell, unit),
                 static_cast<unsigned int>(nodes.size())});
  }



  // A point need not be a node: its force is distributed by the shape functions of the cell that
  // contains it. Collective.
  template <int dim>
  void
  NodalForces<dim>::add_point(const Mesh<dim> &mesh, const Load<dim> &load)
  {
    Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = load.nodes.point[d];
    const PointLocation<dim> place = locate(mesh, x, load.nodes.body, load.nodes.point_location);
    if (place.is_on_this_rank)
      by_cell[place.active_cell].push_back({&load, place.unit, x, 1});
  }



  template <int dim>
  const std::vector<typename NodalForces<dim>::Force> *
  NodalForces<dim>::on(const unsigned int active_cell) const
  {
    const auto found = by_cell.find(active_cell);
    return found == by_cell.end() ? nullptr : &found->second;
  }



  template class NodalForces<2>;
  template class NodalForces<3>;
} // namespace Signorini
