// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"
#include "mesh/mesh.h"
#include "solid/constrained_nodes.h"
#include <signorini/solid/model.h>
#include <signorini/solid/rigid_body.h>

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/fe_collection.h>
#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  template <int dim>
  struct ConstraintEquations;
  template <int dim>
  class EquationLines;

  /// The space of displacements on the present mesh: continuous finite elements of one degree for
  /// each body, hanging nodes, the constraints that supports and rigid bodies prescribe at a time,
  /// and vectors of such displacements. Constitutive laws and forces are not part of it.
  ///
  /// Degrees of freedom of the mesh are followed by those of the moving rigid bodies, which the
  /// last rank owns.
  template <int dim>
  class Displacements
  {
  public:
    /// The mesh of all bodies.
    const Mesh<dim> &
    mesh() const
    {
      return my_mesh;
    }

    /// The relation of the mesh to the bodies: space, plane strain, plane stress, or axisymmetric.
    Model
    model() const
    {
      return my_model;
    }

    /// The degrees of freedom of the mesh, without those of rigid bodies.
    const dealii::DoFHandler<dim> &
    dof_handler() const
    {
      return dofs;
    }

    /// The degrees of freedom of the mesh, to be changed by refinement.
    dealii::DoFHandler<dim> &
    dof_handler()
    {
      return dofs;
    }

    /// The finite elements, one for each shape of cells and degree; the active FE index of a cell
    /// selects its element.
    const dealii::hp::FECollection<dim> &
    finite_elements() const
    {
      return elements;
    }

    /// The largest polynomial degree of all bodies.
    unsigned int
    degree() const
    {
      return elements.max_degree();
    }

    /// The polynomial degree of a body.
    unsigned int
    degree(const unsigned int body) const
    {
      return elements[element_of_body[body]].degree;
    }

    /// The degrees of freedom that this rank owns, of the mesh and of rigid bodies.
    const dealii::IndexSet &
    owned() const
    {
      return locally_owned;
    }

    /// The locally relevant degrees of freedom: those of locally owned and ghost cells, and all of
    /// rigid bodies.
    const dealii::IndexSet &
    relevant() const
    {
      return locally_relevant;
    }

    // Constraints

    /// The constraints of hanging nodes alone, for locally relevant degrees of freedom.
    const dealii::AffineConstraints<double> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// The constraints of hanging nodes, and of supports at the present time.
    const dealii::AffineConstraints<double> &
    constraints() const
    {
      return all_constraints;
    }

    /// The present time, at which prescribed displacements were evaluated.
    double
    time() const
    {
      return my_time;
    }

    /// Set constrained degrees of freedom to the values that the constraints imply. Collective.
    /// @param u without ghosts
    void
    distribute(LA::Vector &u) const
    {
      all_constraints.distribute(u);
    }

    /// All supports, including those that do not act at present.
    const std::vector<Support<dim>> &
    supports() const
    {
      return my_supports;
    }

    /// The time at which the set of active supports was determined: supports start and end, see
    /// Support::acts(). The values of their displacements are those at time().
    double
    time_of_supports() const
    {
      return my_time_of_supports;
    }

    /// True if the same supports act, and the same rigid bodies are driven, at time t as at
    /// time_of_supports().
    bool
    has_supports_of(double t) const;

    /// The nodes of locally owned and ghost cells that the active supports constrain.
    const ConstrainedNodes<dim> &
    constrained_nodes() const
    {
      return constrained;
    }

    /// The constraint equations on this mesh.
    const EquationLines<dim> &
    constraint_equations() const
    {
      return *equations;
    }

    /// The nodes of constraint equations by their first degree of freedom, the same on all ranks.
    const ConstrainedNodes<dim> &
    nodes_of_equations() const;

    /// True if supports that are not along the axes, or constraint equations, constrain degrees of
    /// freedom in terms of others.
    bool
    has_inclined_supports() const
    {
      return inclined;
    }

    // Rigid bodies that move

    /// The rigid bodies whose motions are unknown or prescribed.
    const std::vector<RigidBody<dim>> &
    rigid_bodies() const
    {
      return my_rigid_bodies;
    }

    /// The number of the moving rigid body of this name; that of all of them if none has it.
    unsigned int
    rigid_body(const std::string &name) const;

    /// The first degree of freedom of moving rigid body i.
    dealii::types::global_dof_index
    first_dof(const unsigned int i) const
    {
      return dofs.n_dofs() + i * RigidBody<dim>::n_dofs;
    }

    /// The first degree of freedom of the moving rigid body of this name; invalid if none has it.
    dealii::types::global_dof_index
    first_dof(const std::string &name) const;

    /// True if degree of freedom i of a moving rigid body is an unknown at time_of_supports().
    bool
    is_free(unsigned int body, unsigned int i) const;

    /// True if free components of a rigid body are locked at some time, at the motion that the path
    /// has led to.
    bool
    locks_rigid_bodies() const;

    /// Let rigid bodies that are not driven any more keep the motion of u. Collective.
    void
    hold_rigid_bodies(const LA::Vector &u);

    /// The length by which rotations of rigid bodies are multiplied to become degrees of freedom
    /// [length].
    double
    rotation_length_scale() const
    {
      return my_rotation_length_scale;
    }

    /// The values of all degrees of freedom of rigid bodies, the same on all ranks: for each body
    /// its translation [length], then its rotation times rotation_length_scale() [length].
    /// Collective.
    std::vector<double>
    rigid_motion(const LA::Vector &u) const;
    /// Set the degrees of freedom of rigid bodies in a vector. Collective. @param values as of
    /// rigid_motion()
    void
    set_rigid_motion(const std::vector<double> &values, LA::Vector &u) const;

    // Vectors

    /// A zero vector of the degrees of freedom, without ghosts.
    LA::Vector
    zero_vector() const
    {
      return LA::Vector(locally_owned, my_mesh.communicator());
    }

    /// The part of a vector that belongs to the mesh, with ghosts, for reading on locally owned and
    /// ghost cells. Collective.
    /// @param u with or without the degrees of freedom of rigid bodies
    LA::Vector
    with_ghosts(const LA::Vector &u) const;

    /// A zero vector of the degrees of freedom of the mesh, without ghosts.
    LA::Vector
    zero_mesh_vector() const
    {
      return LA::Vector(dofs.locally_owned_dofs(), my_mesh.communicator());
    }

    /// Copy a vector of the mesh's degrees of freedom into one of all degrees of freedom.
    void
    set_mesh_part(const LA::Vector &part, LA::Vector &u) const;

  protected:
    // The following change the space. A derived class that stores more for the same degrees of
    // freedom or the same time calls them.

    /// @param degrees polynomial degree of the displacement, one a body or one for all
    Displacements(const Mesh<dim>                             &mesh,
                  const std::vector<Support<dim>>             &supports,
                  const std::vector<unsigned int>             &degrees,
                  Model                                        model,
                  const std::vector<RigidBody<dim>>           &rigid_bodies,
                  const std::vector<ConstraintEquations<dim>> &equations);

    ~Displacements();

    /// Distribute degrees of freedom on the present mesh, find hanging and constrained nodes, and
    /// make the constraints of the supports that act at time t with their values at t. Collective.
    void
    distribute_dofs(double t);

    /// Make the constraints at time t, of the same supports as before. Throws SceneError where a
    /// formula of a rigid body has no finite value. Collective.
    void
    prescribe(double t);

  private:
    void
    number_dofs();
    void
    make_constraints(double t);
    bool
    find_inclined_supports() const;
    unsigned int
    n_rigid_dofs() const
    {
      return my_rigid_bodies.size() * RigidBody<dim>::n_dofs;
    }

    const Mesh<dim>                          &my_mesh;
    const std::vector<Support<dim>>           my_supports;
    const Model                               my_model;
    const std::vector<RigidBody<dim>>         my_rigid_bodies; ///< the rigid bodies that can move
    const std::unique_ptr<EquationLines<dim>> equations;

    dealii::hp::FECollection<dim>     elements;
    std::vector<unsigned int>         element_of_body;
    dealii::DoFHandler<dim>           dofs;
    dealii::IndexSet                  locally_owned, locally_relevant;
    dealii::AffineConstraints<double> hanging, all_constraints;
    ConstrainedNodes<dim>             constrained;
    /// The motions that rigid bodies keep when they are not driven, see rigid_motion().
    std::vector<double> kept_motion;
    double              my_time = 0, my_time_of_supports = 0, my_rotation_length_scale = 1;
    bool                inclined = false;
    mutable LA::Vector  zero_with_ghosts; ///< of the mesh; empty until it is needed
  };
} // namespace Signorini
