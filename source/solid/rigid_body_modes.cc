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
  rigid_body_modes(const NodePositions &nodes, const BoundingBox<dim> &box)
  {
    const RigidBodyModes<dim>        all(box);
    const std::size_t                n = nodes.coordinates.size();
    std::vector<std::vector<double>> modes(RigidBodyModes<dim>::n, std::vector<double>(n, 0.));
    const std::size_t                n_mesh = n - nodes.n_own_rigid * dim;
    for (std::size_t i = n_mesh; i < n; ++i)
      modes[i % dim][i] = 1;
    for (std::size_t i = 0; i < n_mesh; ++i)
      {
        Point<dim> x;
        std::copy_n(&nodes.coordinates[i / dim * dim], dim, x.begin_raw());
        const auto at = all.at(x, i % dim);
        for (unsigned int m = 0; m < at.size(); ++m)
          modes[m][i] = at[m];
      }
    return modes;
  }



  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const Displacements<dim> &displacements)
  {
    return rigid_body_modes(node_positions(displacements), displacements.mesh().extent());
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
  rigid_body_modes(const NodePositions &, const BoundingBox<2> &);
  template std::vector<std::vector<double>>
  rigid_body_modes(const NodePositions &, const BoundingBox<3> &);
  template std::vector<std::vector<double>>
  rigid_body_modes(const Displacements<2> &);
  template std::vector<std::vector<double>>
  rigid_body_modes(const Displacements<3> &);
  template std::vector<unsigned int>
  bodies_of_dofs(const Displacements<2> &);
  template std::vector<unsigned int>
  bodies_of_dofs(const Displacements<3> &);
} // namespace Signorini
