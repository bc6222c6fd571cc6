#include <signorini/elasticity/elasticity.h>
#include <signorini/elasticity/expression_function.h>
#include <signorini/elasticity/kernel.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Elasticity<dim>::Elasticity(const Mesh<dim>                 &mesh,
                              const std::vector<Material>     &materials,
                              const std::vector<Support<dim>> &supports,
                              const std::vector<Load<dim>>    &loads,
                              const unsigned int               degree)
    : my_mesh(mesh)
    , materials(materials)
    , my_supports(supports)
    , loads(loads)
    , fe(FE_Q<dim>(degree), dim)
    , dofs(mesh.triangulation())
  {}



  template <int dim>
  void
  Elasticity<dim>::setup()
  {
    dofs.distribute_dofs(fe);
    locally_owned = dofs.locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(dofs, locally_relevant);

    hanging.reinit(locally_relevant);
    DoFTools::make_hanging_node_constraints(dofs, hanging);
    hanging.close();

    make_constraints(0);
  }



  template <int dim>
  void
  Elasticity<dim>::set_time(const double t)
  {
    if (t != time)
      make_constraints(t);
  }



  template <int dim>
  void
  Elasticity<dim>::make_constraints(const double t)
  {
    time = t;
    all_constraints.reinit(locally_relevant);
    all_constraints.merge(hanging);
    for (const Support<dim> &support : my_supports)
      prescribe(support);
    all_constraints.close();
  }



  // Where supports meet, the first one counts; the others must agree with it.
  template <int dim>
  void
  Elasticity<dim>::prescribe(const Support<dim> &support)
  {
    const DisplacementFunction<dim> displacement(support.displacement, time);
    ComponentMask                   mask(dim, false);
    for (unsigned int d = 0; d < dim; ++d)
      mask.set(d, support.displacement.prescribed(d));
    std::map<types::global_dof_index, double> values;
    for (const std::string &boundary : support.boundaries)
      VectorTools::interpolate_boundary_values(
        my_mesh.mapping(), dofs, my_mesh.boundary_id(boundary), displacement, values, mask);

    const double negligible  = 1e-12 * my_mesh.size(); // collective
    bool         contradicts = false;
    for (const auto &[dof, value] : values)
      if (!all_constraints.is_constrained(dof))
        {
          all_constraints.add_line(dof);
          all_constraints.set_inhomogeneity(dof, value);
        }
      else if (!hanging.is_constrained(dof))
        {
          const double first = all_constraints.get_inhomogeneity(dof);
          contradicts |= std::abs(first - value) >
                         1e-8 * std::max(std::abs(first), std::abs(value)) + negligible;
        }
    if (Utilities::MPI::max(contradicts ? 1 : 0, my_mesh.communicator()) > 0)
      throw SceneError(
        support.place + ": the Displacement of the support '" + support.name +
        "' contradicts that of a support before it, at nodes that they share at t = " +
        Utilities::to_string(time) + "; leave a component free in one of them");
  }



  template <int dim>
  void
  Elasticity<dim>::assemble()
  {
    TrilinosWrappers::SparsityPattern sparsity(locally_owned,
                                               locally_owned,
                                               locally_relevant,
                                               my_mesh.communicator());
    DoFTools::make_sparsity_pattern(dofs,
                                    sparsity,
                                    all_constraints,
                                    false,
                                    Utilities::MPI::this_mpi_process(my_mesh.communicator()));
    sparsity.compress();
    matrix.reinit(sparsity);

    StiffnessKernel<dim>                 kernel(my_mesh.mapping(), fe);
    FullMatrix<double>                   cell_matrix(fe.n_dofs_per_cell());
    std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          kernel.assemble(cell, materials[cell->material_id()], cell_matrix);
          cell->get_dof_indices(indices);
          all_constraints.distribute_local_to_global(cell_matrix, indices, matrix);
        }
    matrix.compress(VectorOperation::add);
  }



  template <int dim>
  LA::Vector
  Elasticity<dim>::load() const
  {
    LA::Vector           f = zero_vector();
    StiffnessKernel<dim> kernel(my_mesh.mapping(), fe);
    LoadKernel<dim>      load_kernel(my_mesh, fe, loads, time);

    const unsigned int                   n = fe.n_dofs_per_cell();
    FullMatrix<double>                   cell_matrix(n);
    Vector<double>                       cell_load(n);
    std::vector<types::global_dof_index> indices(n);
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(indices);
          const bool loaded = load_kernel.assemble(cell, cell_load);
          const bool moved  = std::any_of(indices.begin(), indices.end(), [&](const auto i) {
            return all_constraints.is_inhomogeneously_constrained(i);
          });
          // Only these few cells need their matrix again: K of the others stays untouched.
          if (moved)
            kernel.assemble(cell, materials[cell->material_id()], cell_matrix);
          if (moved)
            all_constraints.distribute_local_to_global(cell_load, indices, f, cell_matrix);
          else if (loaded)
            all_constraints.distribute_local_to_global(cell_load, indices, f);
        }
    f.compress(VectorOperation::add);
    all_constraints.set_zero(f);
    return f;
  }



  template <int dim>
  LA::Vector
  Elasticity<dim>::lift() const
  {
    LA::Vector u = zero_vector();
    distribute(u);
    return u;
  }



  template <int dim>
  LA::Vector
  Elasticity<dim>::with_ghosts(const LA::Vector &u) const
  {
    LA::Vector ghosted(locally_owned, locally_relevant, my_mesh.communicator());
    ghosted = u;
    return ghosted;
  }



  template <int dim>
  Tensor<1, 3>
  moment_of(const Point<dim> &x, const Tensor<1, dim> &f)
  {
    Tensor<1, 3> m;
    if constexpr (dim == 2)
      m[0] = x[0] * f[1] - x[1] * f[0];
    else
      m = cross_product_3d(x, f);
    return m;
  }



  template <int dim>
  std::vector<Resultant<dim>>
  Elasticity<dim>::reactions(const LA::Vector &u, const LA::Vector &contact_force) const
  {
    // Unconstrained residual: internal forces - loads, hanging nodes resolved.
    const LA::Vector     ghosted  = with_ghosts(u);
    LA::Vector           residual = zero_vector();
    StiffnessKernel<dim> kernel(my_mesh.mapping(), fe);
    LoadKernel<dim>      load_kernel(my_mesh, fe, loads, time);

    const unsigned int                   n = fe.n_dofs_per_cell();
    FullMatrix<double>                   cell_matrix(n);
    Vector<double>                       cell_force(n), cell_load(n), values(n);
    std::vector<types::global_dof_index> indices(n);
    Resultant<dim>                       total_load;
    // Of the nodes of supported cells; a node is a point in the middle of a cell, too.
    std::map<types::global_dof_index, Point<dim>> position;
    FEValues<dim>                                 nodes(my_mesh.mapping(),
                        fe,
                        Quadrature<dim>(fe.get_unit_support_points()),
                        update_quadrature_points);
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(indices);
          const bool loaded    = load_kernel.assemble(cell, cell_load);
          const bool supported = std::any_of(indices.begin(), indices.end(), [&](const auto i) {
            return all_constraints.is_constrained(i);
          });
          if (!supported && !loaded)
            continue;
          nodes.reinit(cell);
          for (unsigned int i = 0; i < n; ++i)
            {
              position[indices[i]] = nodes.quadrature_point(i);
              Tensor<1, dim> force;
              force[fe.system_to_component_index(i).first] = loaded ? cell_load[i] : 0.;
              total_load.force += force;
              total_load.moment += moment_of(nodes.quadrature_point(i), force);
            }
          kernel.assemble(cell, materials[cell->material_id()], cell_matrix);
          cell->get_dof_values(ghosted, values);
          cell_matrix.vmult(cell_force, values);
          if (loaded)
            cell_force -= cell_load;
          hanging.distribute_local_to_global(cell_force, indices, residual);
        }
    residual.compress(VectorOperation::add);
    residual -= contact_force;

    std::vector<Resultant<dim>> result;
    IndexSet                    counted(dofs.n_dofs()); // by a support before
    for (const Support<dim> &support : my_supports)
      {
        std::set<types::boundary_id> ids;
        for (const std::string &boundary : support.boundaries)
          ids.insert(my_mesh.boundary_id(boundary));
        Resultant<dim> sum;
        for (unsigned int d = 0; d < dim; ++d)
          if (support.displacement.prescribed(d))
            {
              ComponentMask mask(dim, false);
              mask.set(d, true);
              IndexSet held = DoFTools::extract_boundary_dofs(dofs, mask, ids) & locally_owned;
              held.subtract_set(counted);
              for (const auto i : held)
                if (!hanging.is_constrained(i))
                  {
                    Tensor<1, dim> force;
                    force[d] = residual(i);
                    sum.force += force;
                    sum.moment += moment_of(position.at(i), force);
                  }
              counted.add_indices(held);
            }
        result.push_back(sum);
      }
    result.push_back(total_load);
    for (Resultant<dim> &resultant : result)
      {
        resultant.force  = Utilities::MPI::sum(resultant.force, my_mesh.communicator());
        resultant.moment = Utilities::MPI::sum(resultant.moment, my_mesh.communicator());
      }
    return result;
  }



  template Tensor<1, 3>
  moment_of(const Point<2> &, const Tensor<1, 2> &);
  template Tensor<1, 3>
  moment_of(const Point<3> &, const Tensor<1, 3> &);
  template class Elasticity<2>;
  template class Elasticity<3>;
} // namespace Signorini
