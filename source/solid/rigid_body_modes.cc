// SPDX-License-Identifier: Apache-2.0
#include "solid/rigid_body_modes.h"

#include "solid/cell_nodes.h"

namespace Signorini
{
  using namespace dealii;

  // Rotations are about the centre of the box, so that they are nearly orthogonal to translations
  // for compact bodies.
  template <int dim>
  RigidBodyModes<dim>::RigidBodyModes(const BoundingBox<dim> &box)
  {
    const auto &[low, high] = box.get_boundary_points();
    center                  = low + (high - low) / 2;
    my_size                 = (high - low).norm() / 2;
  }



  // Component c of the translations (0 or 1) and of the rotations e_r x x, with x relative to the
  // center in units of half the diagonal: all entries are at most about one.
  template <int dim>
  std::array<double, RigidBodyModes<dim>::n>
  RigidBodyModes<dim>::at(const Point<dim> &point, const unsigned int c) const
  {
    const Tensor<1, dim>  x = (point - center) / my_size;
    std::array<double, n> value{};
    value[c] = 1;
    if (dim == 2)
      value[2] = c == 0 ? -x[1] : x[0];
    else
      // Rotation about axis r: e_r x x.
      for (unsigned int r = 0; r < 3; ++r)
        if (c != r)
          value[dim + r] = c == (r + 1) % 3 ? -x[(r + 2) % 3] : x[(r + 1) % 3];
    return value;
  }



  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const Mesh<dim>             &mesh,
                   const DoFHandler<dim>       &dofs,
                   const hp::FECollection<dim> &elements,
                   const IndexSet              &owned)
  {
    // One set of modes about the centre of all bodies. Restricted to an aggregate of one body, they
    // span the same space as its own modes.
    const RigidBodyModes<dim>        all(mesh.extent());
    std::vector<std::vector<double>> modes(RigidBodyModes<dim>::n,
                                           std::vector<double>(owned.n_elements()));
    // A rigid body has two nodes, of translation and rotation, that are coupled to no others; for
    // aggregation each of their components counts as a translation.
    for (auto i = dofs.n_dofs(); i < owned.size(); ++i)
      if (owned.is_element(i))
        modes[(i - dofs.n_dofs()) % dim][owned.index_within_set(i)] = 1;

    CellNodes<dim>                       nodes_of(mesh, elements);
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const std::vector<Point<dim>> &nodes = nodes_of(cell);
          read_indices<dim>(cell, indices);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (owned.is_element(indices[i]))
              {
                const auto at = all.at(nodes[i], cell->get_fe().system_to_component_index(i).first);
                for (unsigned int m = 0; m < at.size(); ++m)
                  modes[m][owned.index_within_set(indices[i])] = at[m];
              }
        }
    return modes;
  }



  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const Displacements<dim> &displacements)
  {
    return rigid_body_modes(displacements.mesh(),
                            displacements.dof_handler(),
                            displacements.finite_elements(),
                            displacements.owned());
  }



  // Degrees of freedom of rigid bodies keep the initial value, the number of bodies.
  template <int dim>
  std::vector<unsigned int>
  bodies_of_dofs(const Displacements<dim> &displacements)
  {
    const IndexSet           &owned = displacements.owned();
    std::vector<unsigned int> result(owned.n_elements(), displacements.mesh().n_bodies());
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : displacements.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          for (const auto i : indices)
            if (owned.is_element(i))
              result[owned.index_within_set(i)] = displacements.mesh().body(cell);
        }
    return result;
  }



  template class RigidBodyModes<2>;
  template class RigidBodyModes<3>;
  template std::vector<std::vector<double>>
  rigid_body_modes(const Mesh<2> &,
                   const DoFHandler<2> &,
                   const hp::FECollection<2> &,
                   const IndexSet &);
  template std::vector<std::vector<double>>
  rigid_body_modes(const Mesh<3> &,
                   const DoFHandler<3> &,
                   const hp::FECollection<3> &,
                   const IndexSet &);
  template std::vector<std::vector<double>>
  rigid_body_modes(const Displacements<2> &);
  template std::vector<std::vector<double>>
  rigid_body_modes(const Displacements<3> &);
  template std::vector<unsigned int>
  bodies_of_dofs(const Displacements<2> &);
  template std::vector<unsigned int>
  bodies_of_dofs(const Displacements<3> &);
} // namespace Signorini
