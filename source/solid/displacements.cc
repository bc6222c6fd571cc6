// SPDX-License-Identifier: Apache-2.0
#include "solid/displacements.h"

#include "base/compatibility.h"
#include "solid/equation_lines.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Displacements<dim>::Displacements(const Mesh<dim>                             &mesh,
                                    const std::vector<Support<dim>>             &supports,
                                    const std::vector<unsigned int>             &degrees,
                                    const Model                                  model,
                                    const std::vector<RigidBody<dim>>           &rigid_bodies,
                                    const std::vector<ConstraintEquations<dim>> &equations)
    : my_mesh(mesh)
    , my_supports(supports)
    , my_model(model)
    , my_rigid_bodies(rigid_bodies)
    , equations(std::make_unique<EquationLines<dim>>(equations))
    , dofs(mesh.triangulation())
  {
    Assert(degrees.size() == 1 || degrees.size() == mesh.n_bodies(),
           ExcDimensionMismatch(degrees.size(), mesh.n_bodies()));
    // One element for each different shape of cells and degree; bodies share no nodes, so that
    // nothing has to be constrained between different elements.
    std::vector<std::pair<bool, unsigned int>> of_bodies; // whether of simplices, and degree
    for (unsigned int body = 0; body < mesh.n_bodies(); ++body)
      of_bodies.emplace_back(mesh.reference_cell(body).is_simplex(),
                             degrees[degrees.size() == 1 ? 0 : body]);
    const std::set<std::pair<bool, unsigned int>> different(of_bodies.begin(), of_bodies.end());
    for (const auto &[of_simplices, degree] : different)
      elements.push_back(of_simplices ? FESystem<dim>(FE_SimplexP<dim>(degree), dim) :
                                        FESystem<dim>(FE_Q<dim>(degree), dim));
    for (const auto &one : of_bodies)
      element_of_body.push_back(std::distance(different.begin(), different.find(one)));
  }



  // The order matters: hanging nodes depend on the numbering, constrained nodes on hanging nodes
  // (these are skipped), and constraints on both.
  template <int dim>
  void
  Displacements<dim>::distribute_dofs(const double t)
  {
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        cell->set_active_fe_index(element_of_body[my_mesh.body(cell)]);
    dofs.distribute_dofs(elements);
    // Rotations of rigid bodies are unknowns after multiplication with this length, so that they
    // are of the size of displacements, and convergence criteria treat both alike.
    my_rotation_length_scale = my_mesh.size() / 2;
    number_dofs();

    const auto find_hanging_nodes = [&] {
      Compatibility::reinit(hanging, locally_owned, locally_relevant);
      DoFTools::make_hanging_node_constraints(dofs, hanging);
      hanging.close();
    };
    find_hanging_nodes();
    if (!equations->empty())
      {
        // The nodes of equations are known on all ranks, since any of them may depend on others.
        equations->find_nodes(my_mesh, dofs, hanging);
        for (const auto dof : equations->dofs())
          locally_relevant.add_index(dof);
        find_hanging_nodes();
      }

    my_time_of_supports = t;
    constrained         = find_constrained_nodes(my_mesh, dofs, hanging, my_supports, t, my_model);
    make_constraints(t);
    inclined = find_inclined_supports();
  }



  // False if the set of active supports at time t, or of rigid bodies that are driven, differs from
  // that of the present constraints: then degrees of freedom are constrained that are free now, or
  // the reverse, and K has to be rebuilt.
  template <int dim>
  bool
  Displacements<dim>::has_supports_of(const double t) const
  {
    const auto as_at_t = [&](const TimeSpan &span) {
      return span.acts(t) == span.acts(my_time_of_supports);
    };
    return std::all_of(my_supports.begin(), my_supports.end(), as_at_t) &&
           std::all_of(my_rigid_bodies.begin(), my_rigid_bodies.end(), [&](const auto &body) {
             return as_at_t(body.driven);
           });
  }



  template <int dim>
  Displacements<dim>::~Displacements() = default;



  template <int dim>
  const ConstrainedNodes<dim> &
  Displacements<dim>::nodes_of_equations() const
  {
    return equations->nodes();
  }



  template <int dim>
  unsigned int
  Displacements<dim>::rigid_body(const std::string &name) const
  {
    return std::find_if(my_rigid_bodies.begin(),
                        my_rigid_bodies.end(),
                        [&](const auto &body) { return body.name == name; }) -
           my_rigid_bodies.begin();
  }



  template <int dim>
  types::global_dof_index
  Displacements<dim>::first_dof(const std::string &name) const
  {
    const unsigned int body = rigid_body(name);
    return body < my_rigid_bodies.size() ? first_dof(body) : numbers::invalid_dof_index;
  }



  template <int dim>
  bool
  Displacements<dim>::is_free(const unsigned int body, const unsigned int i) const
  {
    return my_rigid_bodies[body].is_free(i) &&
           my_rigid_bodies[body].driven.acts(my_time_of_supports);
  }



  template <int dim>
  bool
  Displacements<dim>::locks_rigid_bodies() const
  {
    return std::any_of(my_rigid_bodies.begin(), my_rigid_bodies.end(), [](const auto &body) {
      return body.driven.is_limited();
    });
  }



  // The values are constraints, which are made anew only where they can have changed.
  template <int dim>
  void
  Displacements<dim>::hold_rigid_bodies(const LA::Vector &u)
  {
    if (!locks_rigid_bodies())
      return;
    kept_motion = rigid_motion(u);
    make_constraints(my_time);
  }



  // Number all degrees of freedom: those of the mesh first, as deal.II numbers them, then those of
  // the moving rigid bodies, which the last rank owns and all ranks may read.
  template <int dim>
  void
  Displacements<dim>::number_dofs()
  {
    const auto         n_mesh = dofs.n_dofs(), n = n_mesh + n_rigid_dofs();
    const unsigned int rank    = Utilities::MPI::this_mpi_process(my_mesh.communicator()),
                       n_ranks = Utilities::MPI::n_mpi_processes(my_mesh.communicator());
    locally_owned = locally_relevant = IndexSet(n);
    locally_owned.add_indices(dofs.locally_owned_dofs());
    locally_relevant.add_indices(DoFTools::extract_locally_relevant_dofs(dofs));
    locally_relevant.add_range(n_mesh, n);
    if (rank == n_ranks - 1)
      locally_owned.add_range(n_mesh, n);
    zero_with_ghosts.clear();
  }



  // A constraint with entries couples a component of a node to others: the support is not along an
  // axis, or there are equations. Collective.
  template <int dim>
  bool
  Displacements<dim>::find_inclined_supports() const
  {
    bool any = !equations->empty();
    for (const auto &[index, node] : constrained)
      for (const auto dof : node.dofs)
        any |= all_constraints.is_constrained(dof) &&
               !all_constraints.get_constraint_entries(dof)->empty();
    return Utilities::MPI::max(any ? 1 : 0, my_mesh.communicator()) == 1;
  }



  namespace
  {
    /// Throws SceneError if a formula of a rigid body's motion or load has no finite value at time
    /// t.
    template <int dim>
    void
    check_motion(const RigidBody<dim> &body, const double t)
    {
      const auto check = [&](const char *key, const auto &formulas) {
        if (!std::isfinite(formulas.value(Point<dim>(), t).norm()))
          throw SceneError(
            (body.is_shortening ?
               "The " + body.name :
               "Obstacles/" + body.name + "/" + key + " = " + shortened(formulas.text())) +
            ": is not a finite number at t = " + Utilities::to_string(t) + "; correct the formula");
      };
      check("Displacement", body.displacement);
      check("Rotation", body.rotation);
      check("Force", body.force);
      check("Moment", body.moment);
    }
  } // namespace



  // The set of constrained nodes stays; only values change. Formulas of rigid bodies are checked
  // also where the time is the same, since a scene may begin there.
  template <int dim>
  void
  Displacements<dim>::prescribe(const double t)
  {
    if (t != my_time)
      make_constraints(t);
    for (const RigidBody<dim> &body : my_rigid_bodies)
      check_motion(body, t);
  }



  // All constraints at time t: hanging nodes, supports of the present set with their values at t,
  // prescribed motions of rigid bodies. Prescribed rotations are multiplied by the length scale.
  template <int dim>
  void
  Displacements<dim>::make_constraints(const double t)
  {
    my_time = t;
    Compatibility::reinit(all_constraints, locally_owned, locally_relevant);
    all_constraints.merge(hanging);
    constrain(constrained, my_mesh, t, all_constraints);
    kept_motion.resize(n_rigid_dofs(), 0.);
    for (unsigned int body = 0; body < my_rigid_bodies.size(); ++body)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        if (!is_free(body, i))
          {
            all_constraints.add_line(first_dof(body) + i);
            all_constraints.set_inhomogeneity(
              first_dof(body) + i,
              my_rigid_bodies[body].is_free(i) ?
                kept_motion[body * RigidBody<dim>::n_dofs + i] :
                my_rigid_bodies[body].prescribed(i, t, my_rotation_length_scale));
          }
    equations->add_to(all_constraints, locally_owned, t, my_mesh.communicator());
    all_constraints.close();
  }



  // A copy of the displacements of the mesh with the values of ghost cells, for evaluations cell by
  // cell. Collective.
  template <int dim>
  LA::Vector
  Displacements<dim>::with_ghosts(const LA::Vector &u) const
  {
    // Copies of a vector share its partition, whose construction costs more than the exchange of
    // values.
    if (zero_with_ghosts.size() == 0)
      zero_with_ghosts.reinit(dofs.locally_owned_dofs(),
                              locally_relevant.get_view(0, dofs.n_dofs()),
                              my_mesh.communicator());
    LA::Vector ghosted = zero_with_ghosts;
    if (u.size() == dofs.n_dofs())
      ghosted = u;
    // A vector with degrees of freedom of rigid bodies is restricted to the mesh first.
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



  // The degrees of freedom of rigid bodies in u are not changed.
  template <int dim>
  void
  Displacements<dim>::set_mesh_part(const LA::Vector &part, LA::Vector &u) const
  {
    for (const auto i : dofs.locally_owned_dofs())
      u(i) = part(i);
    u.compress(VectorOperation::insert);
  }



  // The motions of all rigid bodies are few, and each rank needs them: they are summed to every
  // rank. Collective.
  template <int dim>
  std::vector<double>
  Displacements<dim>::rigid_motion(const LA::Vector &u) const
  {
    // The rank that owns a value contributes it, the others zero.
    std::vector<double> values(n_rigid_dofs(), 0.);
    for (unsigned int i = 0; i < values.size(); ++i)
      if (locally_owned.is_element(dofs.n_dofs() + i))
        values[i] = u(dofs.n_dofs() + i);
    Utilities::MPI::sum(values, my_mesh.communicator(), values);
    return values;
  }



  template <int dim>
  void
  Displacements<dim>::set_rigid_motion(const std::vector<double> &values, LA::Vector &u) const
  {
    for (unsigned int i = 0; i < values.size(); ++i)
      if (locally_owned.is_element(dofs.n_dofs() + i))
        u(dofs.n_dofs() + i) = values[i];
    u.compress(VectorOperation::insert);
  }



  template class Displacements<2>;
  template class Displacements<3>;
} // namespace Signorini
