// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/assembly.h"
#include "solid/deformation.h"
#include "solid/displacements.h"
#include "solid/material_history.h"
#include "solid/surface_loads.h"
#include "solid/thermal_strain.h"
#include "solid/unsupported_modes.h"
#include "solid/volumetric_stress.h"

#include <algorithm>

namespace Signorini
{
  /// Elasticity of all bodies on the present mesh: the virtual work int sigma(u):eps(v) dV = int
  /// b.v dV + int t.v dA for all v (doc/theory, (1.3), (1.4)), discretised to K u = f in the space
  /// of displacements that it extends. K is assembled once per mesh and set of supports; supports,
  /// loads and thermal strains, which are loads here, depend on time. Bodies with a constitutive
  /// law have their forces elsewhere (DeformationKernel); K is then that of the undeformed
  /// material.
  template <int dim>
  class Elasticity : public Displacements<dim>
  {
  public:
    /// @param materials by material id
    /// @param degrees polynomial degree of the displacement, one for each body or one for all
    /// @param rigid_bodies the rigid bodies that move
    /// @param stabilisation factor of stabilising_stiffness()
    /// @param expansions thermal expansions by material id, or none
    Elasticity(const Mesh<dim>                 &mesh,
               const std::vector<Material>     &materials,
               const std::vector<Support<dim>> &supports,
               const std::vector<Load<dim>>    &loads,
               const std::vector<unsigned int> &degrees,
               Model model = dim == 2 ? Model::plane_strain : Model::solid,
               const std::vector<RigidBody<dim>>           &rigid_bodies  = {},
               double                                       stabilisation = default_stabilisation,
               const std::vector<ThermalExpansion<dim>>    &expansions    = {},
               const std::vector<ConstraintEquations<dim>> &equations     = {});

    /// The default stabilisation of unconstrained rigid-body modes, in units of E times the size of
    /// the body. With this value, acting forces move bodies about as far as contact deforms
    /// afterwards, from where it is found soonest.
    static constexpr double default_stabilisation = 0.25;

    /// Distribute degrees of freedom on the present mesh, with the supports that act at time t. K,
    /// and everything derived from its constraints, has to be made again after a change of mesh or
    /// supports. Collective.
    void
    setup(double t = 0);

    /// Assemble K; once per mesh. For bodies in displacement-pressure form it has the deviatoric
    /// part only (lambda = 0). Collective.
    void
    assemble();

    /// Evaluate the prescribed displacements and the temperatures at time t. Throws SceneError
    /// where a temperature is not a number. Collective.
    void
    set_time(double t);

    /// K with hanging nodes condensed and prescribed displacements eliminated (their rows and
    /// columns are diagonal) [force/length]. Valid after assemble().
    const LA::SparseMatrix &
    stiffness() const
    {
      return matrix;
    }

    /// The diagonal terms of K beyond the stiffness of cells [force/length], without ghosts:
    /// entries for prescribed motions of rigid bodies, and the stabilisation of unconstrained
    /// rigid-body modes. Collective.
    LA::Vector
    diagonal_terms() const;

    /// The assembly of K from all or some cells, without diagonal_terms(). Keeps a reference to
    /// this object.
    StiffnessAssembly<dim>
    assembly() const;

    /// Right-hand side at the time of set_time() [force], without ghosts: loads, and forces of
    /// thermal strain of bodies without a constitutive law; at small strain also minus the forces
    /// of the prescribed displacements, as stiffness() requires. Zero at constrained degrees of
    /// freedom. Throws SceneError on all ranks where a load is not a number. Collective.
    LA::Vector
    load() const;

    /// True if any material has a constitutive law other than linear elasticity.
    bool
    is_nonlinear() const
    {
      return std::any_of(materials.begin(), materials.end(), [](const Material &material) {
        return material.constitutive_law != nullptr;
      });
    }

    /// True if any material has a constitutive law at finite strain.
    bool
    is_finite_strain() const
    {
      return std::any_of(materials.begin(), materials.end(), [](const Material &material) {
        return material.constitutive_law && material.strain_measure == StrainMeasure::finite;
      });
    }

    /// A material at a point of a locally owned or ghost cell, with its volumetric stress, internal
    /// variables at the start of the load step, its duration, and the temperature change.
    /// @param x the point in the reference configuration
    /// @param internal set to the internal variables, to which the result refers
    MaterialPoint
    material_point(const dealii::CellAccessor<dim> &cell,
                   const dealii::Point<dim>        &x,
                   std::vector<double>             &internal) const;

    /// In a vector of load(), replace the moments on rigid bodies by their work-conjugates to the
    /// rotation unknowns, J_l^T M, see RigidPose::on_rotations(). Collective.
    /// @param rigid_motion see rigid_motion()
    void
    rotate_moments(const std::vector<double> &rigid_motion, LA::Vector &load) const;

    /// The Cauchy stress at a point x of a locally owned or ghost cell [force/area], tension
    /// positive, three-dimensional in all models; with the present volumetric_stress() in bodies in
    /// displacement-pressure form. It is the stress of the elastic strain, without the thermal
    /// strain.
    /// @param gradient gradient of the displacement: [component][derivative]
    /// @param u displacement at x
    dealii::SymmetricTensor<2, 3>
    stress(const dealii::CellAccessor<dim> &cell,
           const dealii::Tensor<2, dim>    &gradient,
           const dealii::Tensor<1, dim>    &u,
           const dealii::Point<dim>        &x) const;

    /// The material of a material id.
    const Material &
    material(const unsigned int id) const
    {
      return materials[id];
    }

    /// All materials by their ids; one for each body, if no body has several
    /// (Mesh::body_of_material).
    const std::vector<Material> &
    all_materials() const
    {
      return materials;
    }

    /// All loads of the scene.
    const std::vector<Load<dim>> &
    loads() const
    {
      return my_loads;
    }

    /// The thermal strain at the time of set_time(); ThermalStrain::any() is false without one.
    const ThermalStrain<dim> &
    thermal() const
    {
      return thermal_strain;
    }

    /// The volumetric stress of bodies in displacement-pressure form; empty if there are none.
    /// Solvers update it together with the displacement.
    const VolumetricStress<dim> &
    volumetric_stress() const
    {
      return my_volumetric_stress;
    }

    /// The volumetric stress, for solvers that update it.
    VolumetricStress<dim> &
    volumetric_stress()
    {
      return my_volumetric_stress;
    }

    /// The internal variables of the constitutive laws; empty if they have none.
    const MaterialHistory<dim> &
    material_history() const
    {
      return my_history;
    }

    /// The internal variables, to be set at the start of a load step.
    MaterialHistory<dim> &
    material_history()
    {
      return my_history;
    }

    /// Internal variables of all owned cells of laws that have some, at the end of a load step with
    /// displacement u. Collective.
    CellVariables
    internal_variables(const LA::Vector &u) const;

    /// The rigid-body modes that no support constrains: those of elastic bodies, and those of rigid
    /// bodies along free components. They vanish at all constrained degrees of freedom.
    std::vector<UnconstrainedMode>
    unconstrained_modes() const
    {
      return unsupported.motions();
    }

    std::vector<std::string>
    /// The names of these modes, as in "ball: translation z", in the same order.
    unsupported_mode_names() const
    {
      return unsupported.names();
    }

    /// True if there are rigid-body modes that no support constrains. Valid after setup().
    bool
    has_unsupported_modes() const
    {
      return stabilisation.size() > 0;
    }

    /// The stabilising stiffness, a diagonal [force/length]: K has it where unconstrained
    /// rigid-body modes would make it singular; empty if there are none. The residual of Newton's
    /// method does not contain it.
    const LA::Vector &
    stabilising_stiffness() const
    {
      return stabilisation;
    }

    /// The total strain at a point x of a locally owned or ghost cell, in three dimensions, with
    /// the thermal part: of bodies at small strain the linear one; of bodies with a law of finite
    /// strain the logarithmic one, ln V with V^2 = F F^T, whose principal values are the logarithms
    /// of the stretches.
    /// @param gradient gradient of the displacement: [component][derivative]
    /// @param u displacement at x
    dealii::SymmetricTensor<2, 3>
    strain(const dealii::CellAccessor<dim> &cell,
           const dealii::Tensor<2, dim>    &gradient,
           const dealii::Tensor<1, dim>    &u,
           const dealii::Point<dim>        &x) const;

  private:
    void
    add_cells(LA::Vector &f) const;
    void
    add_rigid_bodies(LA::Vector &f) const;
    double
    rigid_stiffness() const;

    const std::vector<Material>  materials;
    const std::vector<Load<dim>> my_loads;
    /// Dimensionless factor of the stabilisation.
    const double          strength;
    ThermalStrain<dim>    thermal_strain;
    VolumetricStress<dim> my_volumetric_stress;
    MaterialHistory<dim>  my_history;
    LA::SparseMatrix      matrix;
    UnsupportedModes<dim> unsupported;
    LA::Vector            stabilisation;
  };

  /// The surface loads at the present time. Collective.
  template <int dim>
  SurfaceLoads<dim>
  surface_loads(const Elasticity<dim> &elasticity)
  {
    return {elasticity.mesh(),
            elasticity.finite_elements(),
            elasticity.model(),
            elasticity.loads(),
            elasticity.time()};
  }
} // namespace Signorini
