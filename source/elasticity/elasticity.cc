#include <signorini/compatibility.h>
#include <signorini/elasticity/cell_nodes.h>
#include <signorini/elasticity/elasticity.h>
#include <signorini/elasticity/kernel.h>
#include <signorini/elasticity/rigid_pose.h>
#include <signorini/elasticity/stress.h>
#include <signorini/parameters/raw.h>
#include <signorini/parameters/text.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <algorithm>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::vector<unsigned int>
    one_a_body(const std::vector<unsigned int> &degrees, const Mesh<dim> &mesh)
    {
      return degrees.size() == 1 ? std::vector<unsigned int>(mesh.n_bodies(), degrees[0]) : degrees;
    }
  } // namespace



  template <int dim>
  Elasticity<dim>::Elasticity(const Mesh<dim>                          &mesh,
                              const std::vector<Material>              &materials,
                              const std::vector<Support<dim>>          &supports,
                              const std::vector<Load<dim>>             &loads,
                              const std::vector<unsigned int>          &degrees,
                              const Model                               model,
                              const std::vector<RigidBody<dim>>        &rigid_bodies,
                              const double                              stabilisation,
                              const std::vector<ThermalExpansion<dim>> &expansions)
    : my_mesh(mesh)
    , materials(materials)
    , my_supports(supports)
    , loads(loads)
    , my_model(model)
    , my_rigid_bodies(rigid_bodies)
    , strength(stabilisation)
    , thermal_strain(mesh, expansions, one_a_body(degrees, mesh), model)
    , dofs(mesh.triangulation())
  {
    Assert(degrees.size() == 1 || degrees.size() == mesh.n_bodies(),
           ExcDimensionMismatch(degrees.size(), mesh.n_bodies()));
    const std::set<unsigned int> different(degrees.begin(), degrees.end());
    for (const unsigned int degree : different)
      elements.push_back(FESystem<dim>(FE_Q<dim>(degree), dim));
    for (const unsigned int degree : one_a_body(degrees, mesh))
      element_of_body.push_back(std::distance(different.begin(), different.find(degree)));
  }



  template <int dim>
  void
  Elasticity<dim>::setup()
  {
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        cell->set_active_fe_index(element_of_body[cell->material_id()]);
    dofs.distribute_dofs(elements);
    my_lever = my_mesh.size() / 2;

    // Indices of the mesh, and those of the rigid bodies behind them.
    const auto         n_mesh = dofs.n_dofs(), n = n_mesh + n_rigid_dofs();
    const unsigned int rank    = Utilities::MPI::this_mpi_process(my_mesh.communicator()),
                       n_ranks = Utilities::MPI::n_mpi_processes(my_mesh.communicator());
    locally_owned = locally_relevant = IndexSet(n);
    locally_owned.add_indices(dofs.locally_owned_dofs());
    locally_relevant.add_indices(DoFTools::extract_locally_relevant_dofs(dofs));
    locally_relevant.add_range(n_mesh, n);
    if (rank == n_ranks - 1)
      locally_owned.add_range(n_mesh, n);

    Compatibility::reinit(hanging, locally_owned, locally_relevant);
    DoFTools::make_hanging_node_constraints(dofs, hanging);
    hanging.close();

    held = find_held_nodes(my_mesh, dofs, hanging, my_supports, my_model);
    make_constraints(0);
    inclined = false;
    for (const auto &[index, node] : held)
      for (const auto dof : node.dofs)
        inclined |= all_constraints.is_constrained(dof) &&
                    !all_constraints.get_constraint_entries(dof)->empty();
    inclined = Utilities::MPI::max(inclined ? 1 : 0, my_mesh.communicator()) == 1;
    find_free_motions();
    set_stabilisation();
    thermal_strain.reinit();
  }



  namespace
  {
    /// Throws SceneError where a formula has no finite value at time t.
    template <int dim>
    void
    check_motion(const RigidBody<dim> &body, const double t)
    {
      const auto check = [&](const char *key, const auto &formulas) {
        if (!std::isfinite(formulas.value(Point<dim>(), t).norm()))
          throw SceneError(
            "Obstacles/" + body.name + "/" + key + " = " + shortened(formulas.text()) +
            ": is not a finite number at t = " + Utilities::to_string(t) + "; correct the formula");
      };
      check("Displacement", body.displacement);
      check("Rotation", body.rotation);
      check("Force", body.force);
      check("Moment", body.moment);
    }
  } // namespace



  template <int dim>
  void
  Elasticity<dim>::set_time(const double t)
  {
    if (t != time)
      make_constraints(t);
    for (const RigidBody<dim> &body : my_rigid_bodies)
      check_motion(body, t);
    thermal_strain.set_time(t);
  }



  template <int dim>
  void
  Elasticity<dim>::make_constraints(const double t)
  {
    time = t;
    Compatibility::reinit(all_constraints, locally_owned, locally_relevant);
    all_constraints.merge(hanging);
    constrain(held, my_mesh, t, all_constraints);
    for (unsigned int body = 0; body < my_rigid_bodies.size(); ++body)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        if (!my_rigid_bodies[body].is_free(i))
          {
            all_constraints.add_line(first_dof(body) + i);
            all_constraints.set_inhomogeneity(first_dof(body) + i,
                                              my_rigid_bodies[body].prescribed(i, t, my_lever));
          }
    all_constraints.close();
  }



  // Of a rigid body, whose own is infinite: about that of the bodies that it touches.
  template <int dim>
  double
  Elasticity<dim>::rigid_stiffness() const
  {
    double largest = 0;
    for (const Material &material : materials)
      largest = std::max(largest, material.youngs_modulus);
    const bool depends_on_size = dim == 3 || my_model == Model::axisymmetric;
    return largest * (depends_on_size ? my_lever : 1.);
  }



  template <int dim>
  void
  Elasticity<dim>::assemble()
  {
    TrilinosWrappers::SparsityPattern    sparsity(locally_owned,
                                               locally_owned,
                                               locally_relevant,
                                               my_mesh.communicator());
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          all_constraints.add_entries_local_to_global(indices, sparsity, false);
        }
    for (const auto i : locally_owned)
      sparsity.add(i, i);
    sparsity.compress();
    matrix.reinit(sparsity);

    StiffnessKernel<dim> kernel(my_mesh, elements, my_model);
    FullMatrix<double>   cell_matrix;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          kernel.assemble(cell, materials[cell->material_id()], cell_matrix);
          read_indices<dim>(cell, indices);
          all_constraints.distribute_local_to_global(cell_matrix, indices, matrix);
        }
    for (auto i = dofs.n_dofs(); i < locally_owned.size(); ++i)
      if (locally_owned.is_element(i) && all_constraints.is_constrained(i))
        matrix.add(i, i, rigid_stiffness());
    if (has_free_motions())
      for (const auto i : locally_owned)
        if (stabilisation(i) > 0)
          matrix.add(i, i, stabilisation(i));
    matrix.compress(VectorOperation::add);
  }



  template <int dim>
  LA::Vector
  Elasticity<dim>::load() const
  {
    LA::Vector           f = zero_vector();
    StiffnessKernel<dim> kernel(my_mesh, elements, my_model);
    LoadKernel<dim>      load_kernel(my_mesh, elements, my_model, loads, time);
    ThermalLoad<dim>     thermal_load(my_mesh, elements, thermal_strain, my_model);

    FullMatrix<double>                   cell_matrix;
    Vector<double>                       cell_load;
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          const Material &material = materials[cell->material_id()];
          const bool      acts     = load_kernel.assemble(cell, cell_load);
          const bool      loaded   = thermal_load.add(cell, material, cell_load) || acts;
          const bool      moved    = std::any_of(indices.begin(), indices.end(), [&](const auto i) {
            return all_constraints.is_inhomogeneously_constrained(i);
          });
          // Only these few cells need their matrix again: K of the others stays untouched.
          if (moved)
            kernel.assemble(cell, material, cell_matrix);
          if (moved)
            all_constraints.distribute_local_to_global(cell_load, indices, f, cell_matrix);
          else if (loaded)
            all_constraints.distribute_local_to_global(cell_load, indices, f);
        }
    for (const std::string &fault :
         Utilities::MPI::all_gather(my_mesh.communicator(), load_kernel.fault()))
      if (!fault.empty())
        throw SceneError(fault);
    for (unsigned int body = 0; body < my_rigid_bodies.size(); ++body)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        if (locally_owned.is_element(first_dof(body) + i))
          f(first_dof(body) + i) += my_rigid_bodies[body].load(i, time, my_lever);
    f.compress(VectorOperation::add);
    all_constraints.set_zero(f);
    return f;
  }



  template <int dim>
  SymmetricTensor<2, 3>
  Elasticity<dim>::stress(const CellAccessor<dim> &cell,
                          const Tensor<2, dim>    &gradient,
                          const Tensor<1, dim>    &u,
                          const Point<dim>        &x) const
  {
    const Material &material = materials[cell.material_id()];
    if (!thermal_strain.expands(cell.material_id()))
      return Signorini::stress(material, strain(my_model, material, gradient, u, x));
    return Signorini::stress(
      material, elastic_strain(my_model, material, gradient, u, x, thermal_strain.strain(cell, x)));
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
    LA::Vector ghosted(dofs.locally_owned_dofs(),
                       locally_relevant.get_view(0, dofs.n_dofs()),
                       my_mesh.communicator());
    if (u.size() == dofs.n_dofs())
      ghosted = u;
    else
      {
        LA::Vector part = zero_mesh_vector();
        for (const auto i : dofs.locally_owned_dofs())
          part(i) = u(i);
        part.compress(VectorOperation::insert);
        ghosted = part;
      }
    return ghosted;
  }



  template <int dim>
  void
  Elasticity<dim>::set_mesh_part(const LA::Vector &part, LA::Vector &u) const
  {
    for (const auto i : dofs.locally_owned_dofs())
      u(i) = part(i);
    u.compress(VectorOperation::insert);
  }



  template <int dim>
  void
  Elasticity<dim>::turn_moments(const std::vector<double> &rigid_motion, LA::Vector &load) const
  {
    using Body = RigidBody<dim>;
    for (unsigned int b = 0; b < my_rigid_bodies.size(); ++b)
      {
        std::array<double, Body::n_dofs> motion;
        std::copy_n(rigid_motion.begin() + b * Body::n_dofs, motion.size(), motion.begin());
        typename RigidPose<dim>::Moment moment;
        for (unsigned int i = 0; i < Body::n_rotations; ++i)
          moment[i] = my_rigid_bodies[b].load(dim + i, time, my_lever) * my_lever;
        const auto turned =
          RigidPose<dim>(my_rigid_bodies[b].reference, motion, my_lever).on_rotations(moment);
        for (unsigned int i = 0; i < Body::n_rotations; ++i)
          if (const auto dof = first_dof(b) + dim + i; locally_owned.is_element(dof))
            load(dof) = turned[i];
      }
    load.compress(VectorOperation::insert);
    all_constraints.set_zero(load);
  }



  template <int dim>
  std::vector<double>
  Elasticity<dim>::rigid_motion(const LA::Vector &u) const
  {
    std::vector<double> values(n_rigid_dofs(), 0.);
    for (unsigned int i = 0; i < values.size(); ++i)
      if (locally_owned.is_element(dofs.n_dofs() + i))
        values[i] = u(dofs.n_dofs() + i);
    Utilities::MPI::sum(values, my_mesh.communicator(), values);
    return values;
  }



  template <int dim>
  void
  Elasticity<dim>::set_rigid_motion(const std::vector<double> &values, LA::Vector &u) const
  {
    for (unsigned int i = 0; i < values.size(); ++i)
      if (locally_owned.is_element(dofs.n_dofs() + i))
        u(dofs.n_dofs() + i) = values[i];
    u.compress(VectorOperation::insert);
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
  Reactions<dim>
  Elasticity<dim>::reactions(const LA::Vector &u, const LA::Vector &contact_force) const
  {
    // Unconstrained residual: internal forces - loads, hanging nodes resolved.
    const LA::Vector     ghosted  = with_ghosts(u);
    LA::Vector           residual = zero_vector();
    StiffnessKernel<dim> kernel(my_mesh, elements, my_model);
    LoadKernel<dim>      load_kernel(my_mesh, elements, my_model, loads, time);
    ThermalLoad<dim>     thermal_load(my_mesh, elements, thermal_strain, my_model);

    FullMatrix<double>                   cell_matrix;
    Vector<double>                       cell_force, cell_load, values;
    std::vector<types::global_dof_index> indices;
    Reactions<dim>                       result;
    result.supports.resize(my_supports.size());
    result.bodies.resize(my_mesh.n_bodies());
    CellNodes<dim> nodes_of(my_mesh, elements);
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          const bool loaded    = load_kernel.assemble(cell, cell_load);
          const bool supported = std::any_of(indices.begin(), indices.end(), [&](const auto i) {
            return all_constraints.is_constrained(i);
          });
          if (!supported && !loaded)
            continue;
          const std::vector<Point<dim>> &nodes = nodes_of(cell);
          for (unsigned int i = 0; i < indices.size(); ++i)
            {
              const unsigned int component = cell->get_fe().system_to_component_index(i).first;
              if (my_model == Model::axisymmetric && component == 0)
                continue; // the circumference is in balance
              Tensor<1, dim> force;
              force[component] = loaded ? cell_load[i] : 0.;
              const Resultant<dim> at_node{force, moment_of(nodes[i], force)};
              result.load += at_node;
              result.bodies[cell->material_id()] += at_node;
            }
          const Material &material = materials[cell->material_id()];
          kernel.assemble(cell, material, cell_matrix);
          values.reinit(indices.size());
          cell_force.reinit(indices.size());
          cell->get_dof_values(ghosted, values);
          cell_matrix.vmult(cell_force, values);
          thermal_load.add(cell, material, cell_load); // in balance within the body, no load of it
          cell_force -= cell_load;
          hanging.distribute_local_to_global(cell_force, indices, residual);
        }
    residual.compress(VectorOperation::add);
    residual -= contact_force;

    for (const auto &[index, node] : held)
      if (locally_owned.is_element(index))
        {
          Tensor<1, dim> force;
          for (unsigned int d = 0; d < dim; ++d)
            force[d] = residual(node.dofs[d]);
          // Where supports meet, the first one takes what it can.
          const auto directions = node.orthonormal();
          for (unsigned int k = 0; k < directions.size(); ++k)
            if (const Support<dim> *support = node.holds[k].support)
              {
                Tensor<1, dim> share = (force * directions[k]) * directions[k];
                if (my_model == Model::axisymmetric)
                  share[0] = 0;
                const Resultant<dim> at_node{share, moment_of(node.position, share)};
                result.supports[support - my_supports.data()] += at_node;
                result.bodies[my_mesh.pieces()[node.piece].body] += at_node;
              }
        }
    const auto over_ranks = [&](Resultant<dim> &resultant) {
      resultant.force  = Utilities::MPI::sum(resultant.force, my_mesh.communicator());
      resultant.moment = Utilities::MPI::sum(resultant.moment, my_mesh.communicator());
      if (my_model == Model::axisymmetric)
        resultant.moment = 0;
    };
    over_ranks(result.load);
    for (auto *list : {&result.supports, &result.bodies})
      for (Resultant<dim> &resultant : *list)
        over_ranks(resultant);
    return result;
  }



  template Tensor<1, 3>
  moment_of(const Point<2> &, const Tensor<1, 2> &);
  template Tensor<1, 3>
  moment_of(const Point<3> &, const Tensor<1, 3> &);
  template class Elasticity<2>;
  template class Elasticity<3>;
} // namespace Signorini
