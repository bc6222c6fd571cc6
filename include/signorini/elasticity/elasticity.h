#pragma once

#include <signorini/elasticity/free_motion.h>
#include <signorini/elasticity/held_nodes.h>
#include <signorini/elasticity/model.h>
#include <signorini/elasticity/rigid_body.h>
#include <signorini/elasticity/thermal_strain.h>
#include <signorini/linear_algebra.h>
#include <signorini/mesh/mesh.h>

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/fe_collection.h>
#include <deal.II/lac/affine_constraints.h>

namespace Signorini
{
  /// What acts on some nodes together.
  template <int dim>
  struct Resultant
  {
    dealii::Tensor<1, dim> force;
    dealii::Tensor<1, 3>   moment; ///< about the origin; 2D: the first component alone

    Resultant &
    operator+=(const Resultant &other)
    {
      force += other.force;
      moment += other.moment;
      return *this;
    }
  };

  /// What supports and loads exert.
  template <int dim>
  struct Reactions
  {
    std::vector<Resultant<dim>> supports; ///< each on all bodies
    Resultant<dim>              load;     ///< on all bodies
    std::vector<Resultant<dim>> bodies;   ///< all supports and loads on each body
  };

  /// x cross f; in 2D its only component comes first.
  template <int dim>
  dealii::Tensor<1, 3>
  moment_of(const dealii::Point<dim> &x, const dealii::Tensor<1, dim> &f);

  /// Linear elasticity of all bodies on the present mesh: sum over bodies of the virtual work
  /// int sigma(u):eps(v) dV = int b.v dV + int t.v dA, thesis (28), discretised to K d = f
  /// (38)-(41). K is assembled once per mesh; supports, loads and thermal strains, which are loads
  /// here, depend on time.
  ///
  /// Behind the degrees of freedom of the mesh, those of moving rigid bodies follow, which the last
  /// rank owns.
  template <int dim>
  class Elasticity
  {
  public:
    /// @param degrees polynomial degree of the displacement, one a body or one for all
    /// @param expansions thermal ones, one a body, or none
    Elasticity(const Mesh<dim>                 &mesh,
               const std::vector<Material>     &materials,
               const std::vector<Support<dim>> &supports,
               const std::vector<Load<dim>>    &loads,
               const std::vector<unsigned int> &degrees,
               Model model = dim == 2 ? Model::plane_strain : Model::solid,
               const std::vector<RigidBody<dim>>        &rigid_bodies  = {},
               double                                    stabilisation = default_stabilisation,
               const std::vector<ThermalExpansion<dim>> &expansions    = {});

    /// Of free motions: springs in units of E times the size of the body. With this, forces push
    /// bodies about as far as contact then gives way, from where it is found soonest.
    static constexpr double default_stabilisation = 0.25;

    /// Distribute degrees of freedom on the mesh as it is now.
    void
    setup();

    /// Assemble K; once per mesh.
    void
    assemble();

    /// Evaluate the prescribed displacements and the temperatures at time t. Throws SceneError
    /// where a temperature is not a number. Collective.
    void
    set_time(double t);

    /// K with hanging nodes condensed and prescribed displacements eliminated (their rows and
    /// columns are diagonal).
    const LA::SparseMatrix &
    stiffness() const
    {
      return matrix;
    }

    /// Right-hand side that belongs to stiffness() at the time of set_time(): loads and forces of
    /// thermal strain, minus the forces of the prescribed displacements. Zero at constrained
    /// degrees of freedom.
    LA::Vector
    load() const;

    /// In such a load, moments that act on rigid bodies that have turned so far, see
    /// RigidPose::on_rotations(). Collective.
    void
    turn_moments(const std::vector<double> &rigid_motion, LA::Vector &load) const;

    /// A vector that vanishes but at prescribed displacements (and what hangs on them).
    LA::Vector
    lift() const;

    /// Give constrained degrees of freedom the values that belong to the free ones.
    void
    distribute(LA::Vector &u) const
    {
      all_constraints.distribute(u);
    }

    /// The stress in space, without the thermal strain, at a point x of a locally owned or ghost
    /// cell.
    /// @param gradient of the displacement: [component][derivative]
    /// @param u the displacement at x
    dealii::SymmetricTensor<2, 3>
    stress(const dealii::CellAccessor<dim> &cell,
           const dealii::Tensor<2, dim>    &gradient,
           const dealii::Tensor<1, dim>    &u,
           const dealii::Point<dim>        &x) const;

    /// What the supports exert: internal forces minus loads minus contact forces at the
    /// degrees of freedom of each support. @param contact_force forces of contact on all degrees of
    /// freedom (hanging nodes resolved).
    Reactions<dim>
    reactions(const LA::Vector &u, const LA::Vector &contact_force) const;

    /// Rigid-body modes (dim translations, then rotations about the center, scaled to size one) on
    /// the locally owned degrees of freedom, mode by mode. One set serves all bodies: aggregates of
    /// the multigrid method never contain nodes of two bodies, and on one body a rotation about
    /// another center differs by a translation only.
    std::vector<std::vector<double>>
    rigid_body_modes() const;

    /// The body of each locally owned degree of freedom; Mesh::n_bodies() for those of rigid ones.
    std::vector<unsigned int>
    bodies_of_dofs() const;

    /// Motions without deformation that no support holds: of elastic bodies, and of rigid ones
    /// along free components. They vanish at all constrained degrees of freedom.
    std::vector<FreeMotion>
    free_motions() const;

    std::vector<std::string>
    free_motion_names() const;

    /// True if there are any. Known after setup().
    bool
    has_free_motions() const
    {
      return stabilisation.size() > 0;
    }

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

    /// One a degree; cells have the index of theirs.
    const dealii::hp::FECollection<dim> &
    finite_elements() const
    {
      return elements;
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

    const ThermalStrain<dim> &
    thermal() const
    {
      return thermal_strain;
    }

    const std::vector<Support<dim>> &
    supports() const
    {
      return my_supports;
    }

    const HeldNodes<dim> &
    held_nodes() const
    {
      return held;
    }

    Model
    model() const
    {
      return my_model;
    }

    const std::vector<RigidBody<dim>> &
    rigid_bodies() const
    {
      return my_rigid_bodies;
    }

    /// The first degree of freedom of rigid body i.
    dealii::types::global_dof_index
    first_dof(const unsigned int i) const
    {
      return dofs.n_dofs() + i * RigidBody<dim>::n_dofs;
    }

    /// Arm by which rotations of rigid bodies are measured.
    double
    lever() const
    {
      return my_lever;
    }

    /// The values of all degrees of freedom of rigid bodies, on all ranks. Collective.
    std::vector<double>
    rigid_motion(const LA::Vector &u) const;
    void
    set_rigid_motion(const std::vector<double> &values, LA::Vector &u) const;

    /// What K has on its diagonal beyond the stiffness where free motions would make it singular;
    /// empty if there are none. Newton's method takes it out of the residual.
    const LA::Vector &
    stabilising_springs() const
    {
      return stabilisation;
    }

    /// True if degrees of freedom are tied to others by supports that are not along the axes.
    bool
    has_inclined_supports() const
    {
      return inclined;
    }

    /// A zero vector of the degrees of freedom, without ghosts.
    LA::Vector
    zero_vector() const
    {
      return LA::Vector(locally_owned, my_mesh.communicator());
    }

    /// The part of a vector that belongs to the mesh, with ghosts, to be read on locally owned and
    /// ghost cells.
    LA::Vector
    with_ghosts(const LA::Vector &u) const;

    /// Of the mesh alone, without ghosts.
    LA::Vector
    zero_mesh_vector() const
    {
      return LA::Vector(dofs.locally_owned_dofs(), my_mesh.communicator());
    }

    /// Puts the mesh's part into a vector, and back.
    void
    set_mesh_part(const LA::Vector &part, LA::Vector &u) const;

    /// The largest of all bodies.
    unsigned int
    degree() const
    {
      return elements.max_degree();
    }

    unsigned int
    degree(const unsigned int body) const
    {
      return elements[element_of_body[body]].degree;
    }

  private:
    void
    make_constraints(double t);
    void
    find_free_motions();
    void
    set_stabilisation();
    double
    rigid_stiffness() const;
    unsigned int
    n_rigid_dofs() const
    {
      return my_rigid_bodies.size() * RigidBody<dim>::n_dofs;
    }

    const Mesh<dim>                  &my_mesh;
    const std::vector<Material>       materials;
    const std::vector<Support<dim>>   my_supports;
    const std::vector<Load<dim>>      loads;
    const Model                       my_model;
    const std::vector<RigidBody<dim>> my_rigid_bodies; ///< those that can move
    const double                      strength;        ///< of the stabilisation
    ThermalStrain<dim>                thermal_strain;

    dealii::hp::FECollection<dim>     elements;
    std::vector<unsigned int>         element_of_body;
    dealii::DoFHandler<dim>           dofs;
    dealii::IndexSet                  locally_owned, locally_relevant;
    dealii::AffineConstraints<double> hanging, all_constraints;
    HeldNodes<dim>                    held;
    LA::SparseMatrix                  matrix;
    double                            time = 0, my_lever = 1;
    bool                              inclined = false;

    /// A combination of the rigid-body modes of one connected piece of an elastic body.
    struct BodyMotion
    {
      unsigned int           piece;
      std::string            name;
      dealii::Vector<double> modes;
    };

    std::vector<BodyMotion> body_motions; ///< that no support holds
    LA::Vector              stabilisation;
  };
} // namespace Signorini
