#include <signorini/elasticity/elasticity.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    constexpr unsigned int n_modes = dim *(dim + 1) / 2;

    const std::vector<std::string> axes = {"x", "y", "z"};

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
      return largest < dim ? "translation " + axes[largest] :
                             "rotation about " + axes[dim == 2 ? 2 : largest - dim];
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
  std::vector<std::vector<double>>
  Elasticity<dim>::rigid_body_modes() const
  {
    const auto [center, size] = center_and_size(my_mesh.extent());
    std::vector<std::vector<double>> modes(n_modes<dim>,
                                           std::vector<double>(locally_owned.n_elements()));

    FEValues<dim>                        values(my_mesh.mapping(),
                         fe,
                         Quadrature<dim>(fe.get_unit_support_points()),
                         update_quadrature_points);
    std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          values.reinit(cell);
          cell->get_dof_indices(indices);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (locally_owned.is_element(indices[i]))
              {
                const auto at = modes_at<dim>((values.quadrature_point(i) - center) / size,
                                              fe.system_to_component_index(i).first);
                for (unsigned int m = 0; m < at.size(); ++m)
                  modes[m][locally_owned.index_within_set(indices[i])] = at[m];
              }
        }
    return modes;
  }



  template <int dim>
  std::vector<std::string>
  Elasticity<dim>::unrestrained_modes() const
  {
    // Body by body, the Gram matrix of the modes over the prescribed degrees of freedom: modes in
    // its kernel move nothing that a support holds.
    constexpr unsigned int                     n = n_modes<dim>;
    std::vector<FullMatrix<double>>            gram(my_mesh.n_bodies(), FullMatrix<double>(n));
    std::vector<std::pair<Point<dim>, double>> extents;
    for (unsigned int body = 0; body < my_mesh.n_bodies(); ++body)
      extents.push_back(center_and_size(my_mesh.extent(body)));

    FEValues<dim>                        values(my_mesh.mapping(),
                         fe,
                         Quadrature<dim>(fe.get_unit_support_points()),
                         update_quadrature_points);
    std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        {
          const auto &[center, size] = extents[cell->material_id()];
          values.reinit(cell);
          cell->get_dof_indices(indices);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (all_constraints.is_constrained(indices[i]) && !hanging.is_constrained(indices[i]))
              {
                const auto at = modes_at<dim>((values.quadrature_point(i) - center) / size,
                                              fe.system_to_component_index(i).first);
                for (unsigned int a = 0; a < n; ++a)
                  for (unsigned int b = 0; b < n; ++b)
                    gram[cell->material_id()](a, b) += at[a] * at[b];
              }
        }

    std::vector<std::string> names;
    for (unsigned int body = 0; body < my_mesh.n_bodies(); ++body)
      {
        Utilities::MPI::sum(gram[body], my_mesh.communicator(), gram[body]);
        LAPACKFullMatrix<double> matrix(n);
        matrix = gram[body];
        FullMatrix<double> vectors(n, n);
        Vector<double>     eigenvalues(n);
        const double       scale = 1 + gram[body].linfty_norm();
        matrix.compute_eigenvalues_symmetric(
          -scale, 2 * scale, 1e-14 * scale, eigenvalues, vectors);
        for (unsigned int i = 0; i < eigenvalues.size(); ++i)
          if (eigenvalues[i] < 1e-8 * scale)
            {
              Vector<double> mode(n);
              for (unsigned int j = 0; j < n; ++j)
                mode[j] = vectors(j, i);
              names.push_back(my_mesh.body_name(body) + ": " + mode_name<dim>(mode));
            }
      }
    return names;
  }



  template std::vector<std::vector<double>>
  Elasticity<2>::rigid_body_modes() const;
  template std::vector<std::vector<double>>
  Elasticity<3>::rigid_body_modes() const;
  template std::vector<std::string>
  Elasticity<2>::unrestrained_modes() const;
  template std::vector<std::string>
  Elasticity<3>::unrestrained_modes() const;
} // namespace Signorini
