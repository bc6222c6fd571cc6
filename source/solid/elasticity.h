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
  /// Linear elasticity of all bodies on the present mesh: sum over bodies of the virtual work
  /// int sigma(u):eps(v) dV = int b.v dV + int t.v dA (doc/theory, 1.1), discretised to K d = f
  /// (38)-(41) in the space of displacements that it extends. K is assembled once per mesh;
  /// supports, loads and thermal strains, which are loads here, depend on time.
  template <int dim>
  class Elasticity : public Displacements<dim>
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

    /// The default stabilisation of unconstrained rigid-body modes, in units of E times the size of
    /// the body. With this value, acting forces move bodies about as far as contact deforms
    /// afterwards, from where it is found soonest.
    static constexpr double default_stabilisation = 0.25;

    /// Distribute degrees of freedom on the mesh as it is now, with the supports that act at time
    /// t. K, and all that is made of its constraints, is another one where these change.
    void
    setup(double t = 0);

    /// Assemble K; once per mesh. That of mixed bodies knows nothing of their volumetric stress.
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

    /// The diagonal terms of K beyond the stiffness of cells: entries for prescribed motions of
    /// rigid bodies, and the stabilisation of unconstrained rigid-body modes.
    LA::Vector
    diagonal_terms() const;

    /// The assembly of K from all or some cells, without diagonal_terms(). Keeps a reference to
    /// this object.
    StiffnessAssembly<dim>
    assembly() const;

    /// Right-hand side at the time of set_time(): loads and forces of thermal strain, and at small
    /// deformation, to go with stiffness(), minus the forces of the prescribed displacements. Zero
    /// at constrained degrees of freedom. Throws SceneError where a load is not a number.
    /// Collective.
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

    /// A material at a point of a locally owned or ghost cell, with its volumetric stress and its
    /// history.
    /// @param internal gets the internal variables, which the result refers to
    MaterialPoint
    material_point(const dealii::CellAccessor<dim> &cell,
                   const dealii::Point<dim>        &x,
                   std::vector<double>             &internal) const;

    /// In a vector of load(): transform the moments on rigid bodies for the rotations that they
    /// have undergone, see RigidPose::on_rotations(). Collective.
    void
    rotate_moments(const std::vector<double> &rigid_motion, LA::Vector &load) const;

    /// The stress in space, without the thermal strain, at a point x of a locally owned or ghost
    /// cell; Cauchy's of large deformation. In mixed bodies with volumetric_stress() as it is now.
    /// @param gradient of the displacement: [component][derivative]
    /// @param u the displacement at x
    dealii::SymmetricTensor<2, 3>
    stress(const dealii::CellAccessor<dim> &cell,
           const dealii::Tensor<2, dim>    &gradient,
           const dealii::Tensor<1, dim>    &u,
           const dealii::Point<dim>        &x) const;

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

    const std::vector<Load<dim>> &
    loads() const
    {
      return my_loads;
    }

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

    MaterialHistory<dim> &
    material_history()
    {
      return my_history;
    }

    /// Internal variables of all owned cells at the end of a load step that has come to u.
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

    /// What K has on its diagonal beyond the stiffness where unconstrained rigid-body modes would
    /// make it singular; empty if there are none. Newton's method takes it out of the residual.
    const LA::Vector &
    stabilising_stiffness() const
    {
      return stabilisation;
    }

  private:
    void
    add_cells(LA::Vector &f) const;
    void
    add_rigid_bodies(LA::Vector &f) const;
    double
    rigid_stiffness() const;

    const std::vector<Material>  materials;
    const std::vector<Load<dim>> my_loads;
    const double                 strength; ///< of the stabilisation
    ThermalStrain<dim>           thermal_strain;
    VolumetricStress<dim>        my_volumetric_stress;
    MaterialHistory<dim>         my_history;
    LA::SparseMatrix             matrix;
    UnsupportedModes<dim>        unsupported;
    LA::Vector                   stabilisation;
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
