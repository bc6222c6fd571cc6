#include <signorini/elasticity/cell_nodes.h>
#include <signorini/elasticity/elasticity.h>

#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <map>

#include <Eigen/Eigenvalues>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    constexpr unsigned int n_modes = dim *(dim + 1) / 2;

    /// The modes' value in component c at x (relative to the center, in units of the size).
    template <int dim>
    std::array<double, n_modes<dim>>
    modes_at(const Tensor<1, dim> &x, const unsigned int c)
    {
      std::array<double, n_modes<dim>> value{};
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
    std::string
    mode_name(const Vector<double> &mode)
    {
      const auto largest =
        std::max_element(mode.begin(),
                         mode.end(),
                         [](const double a, const double b) { return std::abs(a) < std::abs(b); }) -
        mode.begin();
      return RigidBody<dim>::name_of(largest);
    }

    /// What rotations are taken about and scaled by.
    template <int dim>
    std::pair<Point<dim>, double>
    center_and_size(const BoundingBox<dim> &box)
    {
      const auto &[low, high] = box.get_boundary_points();
      return {low + (high - low) / 2, (high - low).norm() / 2};
    }
  } // namespace



  template <int dim>
  std::vector<unsigned int>
  Elasticity<dim>::bodies_of_dofs() const
  {
    const IndexSet                       own = owned();
    std::vector<unsigned int>            result(own.n_elements(), my_mesh.n_bodies());
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          for (const auto i : indices)
            if (own.is_element(i))
              result[own.index_within_set(i)] = cell->material_id();
        }
    return result;
  }



  template <int dim>
  std::vector<std::vector<double>>
  Elasticity<dim>::rigid_body_modes() const
  {
    const auto [center, size] = center_and_size(my_mesh.extent());
    std::vector<std::vector<double>> modes(n_modes<dim>,
                                           std::vector<double>(locally_owned.n_elements()));
    // Rigid bodies are not connected to others, but each of their nodes can move.
    for (auto i = dofs.n_dofs(); i < locally_owned.size(); ++i)
      if (locally_owned.is_element(i))
        modes[(i - dofs.n_dofs()) % dim][locally_owned.index_within_set(i)] = 1;

    CellNodes<dim>                       nodes_of(my_mesh, elements);
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const std::vector<Point<dim>> &nodes = nodes_of(cell);
          read_indices<dim>(cell, indices);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (locally_owned.is_element(indices[i]))
              {
                const auto at = modes_at<dim>((nodes[i] - center) / size,
                                              cell->get_fe().system_to_component_index(i).first);
                for (unsigned int m = 0; m < at.size(); ++m)
                  modes[m][locally_owned.index_within_set(indices[i])] = at[m];
              }
        }
    return modes;
  }



  namespace
  {
    /// Combinations of the modes in which nothing with this Gram matrix moves: its kernel.
    template <int dim>
    std::vector<Vector<double>>
    kernel_of(const FullMatrix<double> &gram)
    {
      constexpr unsigned int n = n_modes<dim>;
      Eigen::MatrixXd        matrix(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) = gram(i, j);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
      const double                                         scale = 1 + gram.linfty_norm();
      std::vector<Vector<double>>                          result;
      for (unsigned int i = 0; i < n; ++i)
        if (solver.eigenvalues()[i] < 1e-8 * scale)
          {
            result.emplace_back(n);
            for (unsigned int j = 0; j < n; ++j)
              result.back()[j] = solver.eigenvectors()(j, i);
          }
      return result;
    }
  } // namespace



  template <int dim>
  void
  Elasticity<dim>::find_free_motions()
  {
    // Piece by piece, the Gram matrix of the modes over the directions that supports hold: modes in
    // its kernel move nothing there.
    constexpr unsigned int                     n = n_modes<dim>;
    std::vector<FullMatrix<double>>            gram(my_mesh.pieces().size(), FullMatrix<double>(n));
    std::vector<std::pair<Point<dim>, double>> extents;
    for (const BodyPiece<dim> &piece : my_mesh.pieces())
      extents.push_back(center_and_size(piece.extent));

    for (const auto &[index, node] : held)
      if (locally_owned.is_element(index))
        {
          const auto &[center, size] = extents[node.piece];
          for (const Tensor<1, dim> &direction : node.orthonormal())
            {
              std::array<double, n> along{};
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const auto at = modes_at<dim>((node.position - center) / size, d);
                  for (unsigned int a = 0; a < n; ++a)
                    along[a] += direction[d] * at[a];
                }
              for (unsigned int a = 0; a < n; ++a)
                for (unsigned int b = 0; b < n; ++b)
                  gram[node.piece](a, b) += along[a] * along[b];
            }
        }

    body_motions.clear();
    for (unsigned int piece = 0; piece < gram.size(); ++piece)
      {
        Utilities::MPI::sum(gram[piece], my_mesh.communicator(), gram[piece]);
        if (my_model == Model::axisymmetric)
          // The hoop holds the radius, and so all but the translation along the axis.
          for (const unsigned int a : {0, 2})
            gram[piece](a, a) += 1 + gram[piece].linfty_norm();
        for (const Vector<double> &modes : kernel_of<dim>(gram[piece]))
          body_motions.push_back(
            {piece, my_mesh.pieces()[piece].name + ": " + mode_name<dim>(modes), modes});
      }
  }



  // Springs on the nodes of bodies that can move freely, as stiff as E L/L^3 times their share of
  // the volume; and on free rigid bodies.
  template <int dim>
  void
  Elasticity<dim>::set_stabilisation()
  {
    bool any = !body_motions.empty();
    for (const RigidBody<dim> &body : my_rigid_bodies)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        any |= body.is_free(i);
    stabilisation = any ? zero_vector() : LA::Vector();
    if (!any)
      return;

    std::vector<double> per_volume(my_mesh.pieces().size(), 0.);
    for (const BodyMotion &motion : body_motions)
      {
        const BodyPiece<dim> &piece = my_mesh.pieces()[motion.piece];
        const double          size  = center_and_size(piece.extent).second;
        per_volume[motion.piece] = strength * materials[piece.body].youngs_modulus / (size * size);
      }
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned() && per_volume[my_mesh.piece(cell)] > 0)
        {
          read_indices<dim>(cell, indices);
          const double share = per_volume[my_mesh.piece(cell)] * cell->measure() *
                               measure(my_model, cell->center()) * dim / indices.size();
          for (const auto i : indices)
            if (!all_constraints.is_constrained(i))
              stabilisation(i) += share;
        }
    for (unsigned int body = 0; body < my_rigid_bodies.size(); ++body)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        if (my_rigid_bodies[body].is_free(i) && locally_owned.is_element(first_dof(body) + i))
          stabilisation(first_dof(body) + i) += strength * rigid_stiffness();
    stabilisation.compress(VectorOperation::add);
  }



  template <int dim>
  std::vector<std::string>
  Elasticity<dim>::free_motion_names() const
  {
    std::vector<std::string> names;
    for (const BodyMotion &motion : body_motions)
      names.push_back(motion.name);
    for (const RigidBody<dim> &body : my_rigid_bodies)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        if (body.is_free(i))
          names.push_back(body.name + ": " + RigidBody<dim>::name_of(i));
    return names;
  }



  template <int dim>
  std::vector<FreeMotion>
  Elasticity<dim>::free_motions() const
  {
    std::vector<FreeMotion> result;
    for (const std::string &name : free_motion_names())
      result.push_back({name, zero_vector()});
    std::vector<std::pair<Point<dim>, double>> extents;
    for (const BodyMotion &motion : body_motions)
      extents.push_back(center_and_size(my_mesh.pieces()[motion.piece].extent));

    CellNodes<dim>                       nodes_of(my_mesh, elements);
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        for (unsigned int k = 0; k < body_motions.size(); ++k)
          if (body_motions[k].piece == my_mesh.piece(cell))
            {
              const auto &[center, size]           = extents[k];
              const std::vector<Point<dim>> &nodes = nodes_of(cell);
              read_indices<dim>(cell, indices);
              for (unsigned int i = 0; i < indices.size(); ++i)
                if (locally_owned.is_element(indices[i]) &&
                    !all_constraints.is_constrained(indices[i]))
                  {
                    const auto at =
                      modes_at<dim>((nodes[i] - center) / size,
                                    cell->get_fe().system_to_component_index(i).first);
                    double sum = 0;
                    for (unsigned int m = 0; m < at.size(); ++m)
                      sum += at[m] * body_motions[k].modes[m];
                    result[k].motion(indices[i]) = sum;
                  }
            }
    unsigned int k = body_motions.size();
    for (unsigned int body = 0; body < my_rigid_bodies.size(); ++body)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        if (my_rigid_bodies[body].is_free(i))
          {
            if (locally_owned.is_element(first_dof(body) + i))
              result[k].motion(first_dof(body) + i) = 1;
            ++k;
          }
    for (FreeMotion &one : result)
      one.motion.compress(VectorOperation::insert);
    return result;
  }



  template std::vector<unsigned int>
  Elasticity<2>::bodies_of_dofs() const;
  template std::vector<std::vector<double>>
  Elasticity<2>::rigid_body_modes() const;
  template std::vector<unsigned int>
  Elasticity<3>::bodies_of_dofs() const;
  template std::vector<std::vector<double>>
  Elasticity<3>::rigid_body_modes() const;
  template void
  Elasticity<2>::find_free_motions();
  template void
  Elasticity<3>::find_free_motions();
  template void
  Elasticity<2>::set_stabilisation();
  template void
  Elasticity<3>::set_stabilisation();
  template std::vector<std::string>
  Elasticity<2>::free_motion_names() const;
  template std::vector<std::string>
  Elasticity<3>::free_motion_names() const;
  template std::vector<FreeMotion>
  Elasticity<2>::free_motions() const;
  template std::vector<FreeMotion>
  Elasticity<3>::free_motions() const;
} // namespace Signorini
