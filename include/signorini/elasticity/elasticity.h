#pragma once

#include <signorini/elasticity/boundary_conditions.h>
#include <signorini/elasticity/material.h>
#include <signorini/linear_algebra.h>
#include <signorini/mesh/mesh.h>

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>

namespace Signorini
{
  /// What acts on some nodes together.
  template <int dim>
  struct Resultant
  {
    dealii::Tensor<1, dim> force;
    dealii::Tensor<1, 3>   moment; ///< about the origin; 2D: the first component alone
  };

  /// x cross f; in 2D its only component comes first.
  template <int dim>
  dealii::Tensor<1, 3>
  moment_of(const dealii::Point<dim> &x, const dealii::Tensor<1, dim> &f);

  /// Linear elasticity of all bodies on the present mesh: sum over bodies of the virtual work
  /// int sigma(u):eps(v) dV = int b.v dV + int t.v dA, thesis (28), discretised to K d = f
  /// (38)-(41). K is assembled once per mesh; supports and loads depend on time.
  template <int dim>
  class Elasticity
  {
  public:
    Elasticity(const Mesh<dim>                 &mesh,
               const std::vector<Material>     &materials,
               const std::vector<Support<dim>> &supports,
               const std::vector<Load<dim>>    &loads,
               unsigned int                     degree);

    /// Distribute degrees of freedom on the mesh as it is now.
    void
    setup();

    /// Assemble K; once per mesh.
    void
    assemble();

    /// Evaluate the prescribed displacements at time t.
    void
    set_time(double t);

    /// K with hanging nodes condensed and prescribed displacements eliminated (their rows and
    /// columns are diagonal).
    const LA::SparseMatrix &
    stiffness() const
    {
      return matrix;
    }

    /// Right-hand side that belongs to stiffness() at the time of set_time(): loads minus the
    /// forces of the prescribed displacements. Zero at constrained degrees of freedom.
    LA::Vector
    load() const;

    /// A vector that vanishes but at prescribed displacements (and what hangs on them).
    LA::Vector
    lift() const;

    /// Give constrained degrees of freedom the values that belong to the free ones.
    void
    distribute(LA::Vector &u) const
    {
      all_constraints.distribute(u);
    }

    /// What the supports exert: internal forces minus loads minus contact forces at the
    /// degrees of freedom of each support. @param contact_force forces of contact on all degrees of
    /// freedom (hanging nodes resolved). Returns one resultant a support, and last that of the
    /// loads.
    std::vector<Resultant<dim>>
    reactions(const LA::Vector &u, const LA::Vector &contact_force) const;

    /// Rigid-body modes (dim translations, then rotations about the center, scaled to size one) on
    /// the locally owned degrees of freedom, mode by mode. One set serves all bodies: aggregates of
    /// the multigrid method never contain nodes of two bodies, and on one body a rotation about
    /// another center differs by a translation only.
    std::vector<std::vector<double>>
    rigid_body_modes() const;

    /// Names of the rigid-body modes that no support holds, e.g. "ball: translation z".
    std::vector<std::string>
    unrestrained_modes() const;

    const Mesh<dim> &
    mesh() const
    {
      return my_mesh;
    }

    const dealii::DoFHandler<dim> &
    dof_handler() const
    {
      return dofs;
    }

    dealii::DoFHandler<dim> &
    dof_handler()
    {
      return dofs;
    }

    const dealii::FESystem<dim> &
    finite_element() const
    {
      return fe;
    }

    const dealii::IndexSet &
    owned() const
    {
      return locally_owned;
    }

    const dealii::IndexSet &
    relevant() const
    {
      return locally_relevant;
    }

    const dealii::AffineConstraints<double> &
    hanging_nodes() const
    {
      return hanging;
    }

    const dealii::AffineConstraints<double> &
    constraints() const
    {
      return all_constraints;
    }

    const Material &
    material(const unsigned int body) const
    {
      return materials[body];
    }

    const std::vector<Support<dim>> &
    supports() const
    {
      return my_supports;
    }

    /// A zero vector of the degrees of freedom, without ghosts.
    LA::Vector
    zero_vector() const
    {
      return LA::Vector(locally_owned, my_mesh.communicator());
    }

    /// The same vector with ghosts, to be read on locally owned and ghost cells.
    LA::Vector
    with_ghosts(const LA::Vector &u) const;

    unsigned int
    degree() const
    {
      return fe.degree;
    }

  private:
    void
    prescribe(const Support<dim> &support);
    void
    make_constraints(double t);

    const Mesh<dim>                &my_mesh;
    const std::vector<Material>     materials;
    const std::vector<Support<dim>> my_supports;
    const std::vector<Load<dim>>    loads;

    dealii::FESystem<dim>             fe;
    dealii::DoFHandler<dim>           dofs;
    dealii::IndexSet                  locally_owned, locally_relevant;
    dealii::AffineConstraints<double> hanging, all_constraints;
    LA::SparseMatrix                  matrix;
    double                            time = 0;
  };
} // namespace Signorini
