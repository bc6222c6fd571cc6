// SPDX-License-Identifier: Apache-2.0
#include "solid/elasticity.h"

#include "linear_algebra/diagonal.h"
#include "solid/cell_nodes.h"
#include "solid/deformation.h"
#include "solid/deformation_kernel.h"
#include "solid/kernel.h"
#include "solid/pressure_kernel.h"
#include "solid/stress.h"
#include "solid/wet_faces.h"
#include <signorini/parameters/raw.h>
#include <signorini/solid/rigid_pose.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Degrees given once for all bodies, or one for each, as one for each body.
    template <int dim>
    std::vector<unsigned int>
    one_per_body(const std::vector<unsigned int> &degrees, const Mesh<dim> &mesh)
    {
      return degrees.size() == 1 ? std::vector<unsigned int>(mesh.n_bodies(), degrees[0]) : degrees;
    }

    /// Degrees as one for each material id: that of its body.
    template <int dim>
    std::vector<unsigned int>
    one_per_material(const std::vector<unsigned int> &degrees, const Mesh<dim> &mesh)
    {
      const std::vector<unsigned int> of_bodies = one_per_body(degrees, mesh);
      std::vector<unsigned int>       result;
      for (unsigned int id = 0; id < mesh.n_materials(); ++id)
        result.push_back(of_bodies[mesh.body_of_material(id)]);
      return result;
    }

    /// The loads; those of fluids get faces of their own, none at first.
    template <int dim>
    std::vector<Load<dim>>
    with_wet_faces(std::vector<Load<dim>> loads)
    {
      for (Load<dim> &load : loads)
        if (!load.fluid_entries.empty())
          load.wet = std::make_shared<WetFaces>();
      return loads;
    }
  } // namespace



  template <int dim>
  Elasticity<dim>::Elasticity(const Mesh<dim>                             &mesh,
                              const std::vector<Material>                 &materials,
                              const std::vector<Support<dim>>             &supports,
                              const std::vector<Load<dim>>                &loads,
                              const std::vector<unsigned int>             &degrees,
                              const Model                                  model,
                              const std::vector<RigidBody<dim>>           &rigid_bodies,
                              const double                                 stabilisation,
                              const std::vector<ThermalExpansion<dim>>    &expansions,
                              const std::vector<ConstraintEquations<dim>> &equations)
    : Displacements<dim>(
        mesh, supports, one_per_body(degrees, mesh), model, rigid_bodies, equations)
    , materials(materials)
    , my_loads(with_wet_faces(loads))
    , strength(stabilisation)
    , thermal_strain(mesh, expansions, one_per_material(degrees, mesh), model)
    , my_volumetric_stress(mesh, materials, model)
    , my_history(mesh, this->dof_handler(), materials)
    , unsupported(*this)
  {}



  // Collective.
  template <int dim>
  void
  Elasticity<dim>::setup(const double t)
  {
    // Degrees of freedom and constraints first; fields with values by cell are reset, since the
    // mesh is another one.
    this->distribute_dofs(t);
    unsupported.find();
    stabilisation = unsupported.stabilisation(materials, rigid_stiffness(), strength);
    thermal_strain.reinit();
    my_volumetric_stress.reinit();
    my_history.reinit();
    for (const Load<dim> &load : my_loads)
      if (load.wet)
        load.wet->faces.clear();
  }



  template <int dim>
  void
  Elasticity<dim>::set_time(const double t)
  {
    this->prescribe(t);
    thermal_strain.set_time(t);
  }



  // Stiffness that stands for that of a rigid body, which is infinite [force/length]: about that of
  // the bodies that it touches, E times a length (in the plane, per unit thickness, E).
  template <int dim>
  double
  Elasticity<dim>::rigid_stiffness() const
  {
    double largest = 0;
    for (const Material &material : materials)
      largest = std::max(largest, material.youngs_modulus);
    const bool depends_on_size = dim == 3 || this->model() == Model::axisymmetric;
    return largest * (depends_on_size ? this->rotation_length_scale() : 1.);
  }



  // The assembly refers to the constraints of the present time; values of prescribed displacements
  // do not enter the matrix.
  template <int dim>
  StiffnessAssembly<dim>
  Elasticity<dim>::assembly() const
  {
    return {this->mesh(),
            materials,
            this->model(),
            this->dof_handler(),
            this->finite_elements(),
            this->constraints(),
            this->owned(),
            this->relevant()};
  }



  // The matrix K, for linear bodies, with its diagonal terms. Collective.
  template <int dim>
  void
  Elasticity<dim>::assemble()
  {
    assembly().assemble(matrix);
    LA::add_to_diagonal(matrix, diagonal_terms());
  }



  // Diagonal terms of K: the stabilisation of unconstrained modes, and a regular entry for each
  // prescribed degree of freedom of a rigid body, which no cell contributes to. Collective.
  template <int dim>
  LA::Vector
  Elasticity<dim>::diagonal_terms() const
  {
    LA::Vector result = this->zero_vector();
    if (has_unsupported_modes())
      result = stabilisation;
    for (auto i = this->dof_handler().n_dofs(); i < this->owned().size(); ++i)
      if (this->owned().is_element(i) && this->constraints().is_constrained(i))
        result(i) = rigid_stiffness();
    result.compress(VectorOperation::insert);
    return result;
  }



  // f of K u = f: loads of cells and rigid bodies, with the inhomogeneous constraints eliminated at
  // small strain; zero at constrained degrees of freedom.
  template <int dim>
  LA::Vector
  Elasticity<dim>::load() const
  {
    LA::Vector f = this->zero_vector();
    add_cells(f);
    add_rigid_bodies(f);
    f.compress(VectorOperation::add);
    this->constraints().set_zero(f);
    return f;
  }



  // Loads cell by cell: body forces, nodal forces, surface loads and thermal strain (doc/theory,
  // (1.4)). Where displacements are prescribed, elimination needs the cell matrix: f_i -= K_ij u_j.
  template <int dim>
  void
  Elasticity<dim>::add_cells(LA::Vector &f) const
  {
    const AffineConstraints<double> &constraints = this->constraints();
    const hp::FECollection<dim>     &elements    = this->finite_elements();
    // Pressures that follow the surface at finite strain are not among the dead loads; they belong
    // to the residual.
    StiffnessKernel<dim>         kernel(this->mesh(), elements, this->model());
    const std::vector<Load<dim>> dead = dead_loads(*this);
    LoadKernel<dim>    load_kernel(this->mesh(), elements, this->model(), dead, this->time());
    ThermalLoad<dim>   thermal_load(this->mesh(), elements, thermal_strain, this->model());
    FullMatrix<double> cell_matrix;
    Vector<double>     cell_load;
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : this->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          const Material &material = materials[cell->material_id()];
          const bool      acts     = load_kernel.assemble(cell, cell_load);
          const bool      loaded =
            (!material.constitutive_law && thermal_load.add(cell, material, cell_load)) || acts;
          const bool moved =
            // For linear bodies prescribed displacements are moved to the right-hand side; the
            // residual of nonlinear ones is evaluated at displacements that satisfy them.
            !is_nonlinear() && std::any_of(indices.begin(), indices.end(), [&](const auto i) {
              return constraints.is_inhomogeneously_constrained(i);
            });
          // The matrix of a cell is computed again only where a displacement is prescribed; K
          // itself is not touched.
          if (moved)
            kernel.assemble(cell, material, cell_matrix);
          if (moved)
            constraints.distribute_local_to_global(cell_load, indices, f, cell_matrix);
          else if (loaded)
            constraints.distribute_local_to_global(cell_load, indices, f);
        }
    // A fault on one rank is reported on all of them.
    for (const std::string &fault :
         Utilities::MPI::all_gather(this->mesh().communicator(), load_kernel.fault()))
      if (!fault.empty())
        throw SceneError(fault);
  }



  // Forces and moments on free components of rigid bodies, by the rank that owns them.
  template <int dim>
  void
  Elasticity<dim>::add_rigid_bodies(LA::Vector &f) const
  {
    const std::vector<RigidBody<dim>> &bodies = this->rigid_bodies();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        if (const auto dof = this->first_dof(b) + i; this->owned().is_element(dof))
          f(dof) += bodies[b].load(i, this->time(), this->rotation_length_scale());
  }



  // Moments are applied as J_l^T M at the pose of the last geometry update (doc/theory, 5.5), since
  // the unknowns are rotation vectors and not spins.
  template <int dim>
  void
  Elasticity<dim>::rotate_moments(const std::vector<double> &rigid_motion, LA::Vector &load) const
  {
    using Body                                     = RigidBody<dim>;
    const std::vector<Body> &bodies                = this->rigid_bodies();
    const double             rotation_length_scale = this->rotation_length_scale();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        std::array<double, Body::n_dofs> motion;
        std::copy_n(rigid_motion.begin() + b * Body::n_dofs, motion.size(), motion.begin());
        typename RigidPose<dim>::Moment moment;
        for (unsigned int i = 0; i < Body::n_rotations; ++i)
          moment[i] =
            bodies[b].load(dim + i, this->time(), rotation_length_scale) * rotation_length_scale;
        const auto rotated =
          RigidPose<dim>(bodies[b].reference, motion, rotation_length_scale).on_rotations(moment);
        for (unsigned int i = 0; i < Body::n_rotations; ++i)
          if (const auto dof = this->first_dof(b) + dim + i; this->owned().is_element(dof))
            load(dof) = rotated[i];
      }
    load.compress(VectorOperation::insert);
    this->constraints().set_zero(load);
  }



  template <int dim>
  SymmetricTensor<2, 3>
  Elasticity<dim>::stress(const CellAccessor<dim> &cell,
                          const Tensor<2, dim>    &gradient,
                          const Tensor<1, dim>    &u,
                          const Point<dim>        &x) const
  {
    const Material &material = materials[cell.material_id()];
    // Bodies with a constitutive law: Cauchy stress from the deformation gradient; thermal and
    // volumetric parts are in the material point.
    if (material.constitutive_law)
      {
        std::vector<double> internal;
        return cauchy_stress(this->model(),
                             material_point(cell, x, internal),
                             deformation_gradient(this->model(), gradient, u, x));
      }
    // Linear elasticity: sigma = C : (eps - eps_T), plus m I of the displacement-pressure form.
    const double                volumetric = my_volumetric_stress.value(cell, x);
    const SymmetricTensor<2, 3> of_displacement =
      thermal_strain.expands(cell.material_id()) ?
        elastic_strain(this->model(), material, gradient, u, x, thermal_strain.strain(cell, x)) :
        Signorini::strain(this->model(), material, gradient, u, x);
    return Signorini::stress(material, of_displacement) + volumetric * unit_symmetric_tensor<3>();
  }



  // In plane stress the strain across the sheet is that for which the stress across vanishes.
  template <int dim>
  SymmetricTensor<2, 3>
  Elasticity<dim>::strain(const CellAccessor<dim> &cell,
                          const Tensor<2, dim>    &gradient,
                          const Tensor<1, dim>    &u,
                          const Point<dim>        &x) const
  {
    const Material &material = materials[cell.material_id()];
    if (!material.constitutive_law)
      {
        if (!thermal_strain.expands(cell.material_id()))
          return Signorini::strain(this->model(), material, gradient, u, x);
        const Tensor<1, 3>    thermal = thermal_strain.strain(cell, x);
        SymmetricTensor<2, 3> result =
          elastic_strain(this->model(), material, gradient, u, x, thermal);
        for (unsigned int d = 0; d < 3; ++d)
          result[d][d] += thermal[d];
        return result;
      }
    std::vector<double> internal;
    Tensor<2, 3>        F = deformation_gradient(this->model(), gradient, u, x);
    response_at(this->model(),
                material_point(cell, x, internal),
                F,
                ResponseOrder::stress); // sets F_zz
    if (material.strain_measure == StrainMeasure::small)
      return symmetrize(F) - unit_symmetric_tensor<3>();
    SymmetricTensor<2, 3> result;
    for (const auto &[square, direction] : eigenvectors(symmetrize(F * transpose(F))))
      result += std::log(square) / 2 * symmetrize(outer_product(direction, direction));
    return result;
  }



  // Internal variables at any point of a cell are interpolated by the polynomial through its
  // integration points.
  template <int dim>
  MaterialPoint
  Elasticity<dim>::material_point(const CellAccessor<dim> &cell,
                                  const Point<dim>        &x,
                                  std::vector<double>     &internal) const
  {
    internal.clear();
    if (my_history.n_internal(cell.material_id()) > 0)
      {
        const typename Triangulation<dim>::cell_iterator iterator(&cell.get_triangulation(),
                                                                  cell.level(),
                                                                  cell.index());
        internal =
          my_history.at(cell, this->mesh().mapping().transform_real_to_unit_cell(iterator, x));
      }
    return MaterialPoint(materials[cell.material_id()],
                         my_volumetric_stress.value(cell, x),
                         internal.empty() ? nullptr : internal.data(),
                         my_history.duration(),
                         thermal_strain.any() ? thermal_strain.temperature_change(cell, x) : 0.);
  }



  // Evaluate the law once more at the converged displacement, whose response has the internal
  // variables alpha_(n+1) (doc/theory, (6.9)). Only cells of laws with internal variables.
  // Collective because of the ghost values.
  template <int dim>
  CellVariables
  Elasticity<dim>::internal_variables(const LA::Vector &u) const
  {
    CellVariables result;
    if (my_history.empty())
      return result;
    DeformationKernel<dim> kernel  = deformation_kernel(*this);
    const LA::Vector       ghosted = this->with_ghosts(u);
    Vector<double>         values;
    for (const auto &cell : this->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && my_history.n_internal(cell->material_id()) > 0)
        {
          values.reinit(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_values(ghosted, values);
          result[cell->id()] = kernel.internal(cell, materials[cell->material_id()], values);
        }
    return result;
  }



  template class Elasticity<2>;
  template class Elasticity<3>;
} // namespace Signorini
