// SPDX-License-Identifier: Apache-2.0
#include "accuracy/quantities/kinds.h"
#include "fields/contact_force.h"
#include "solid/cell_nodes.h"
#include "solid/deformation_kernel.h"
#include "solid/pressure_kernel.h"
#include "solid/reactions.h"
#include "solid/volume_kernel.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return a displacement that is a unit vector at the nodes of a support, projected onto the
    /// directions that the support prescribes, and zero elsewhere.
    template <int dim>
    LA::Vector
    indicator_on_support(const Elasticity<dim> &elasticity,
                         const std::string     &name,
                         const Tensor<1, dim>  &direction)
    {
      LA::Vector result = elasticity.zero_vector();
      for (const auto &[index, node] : elasticity.constrained_nodes())
        if (elasticity.owned().is_element(index))
          {
            const auto     directions = node.orthonormal();
            Tensor<1, dim> there;
            for (unsigned int k = 0; k < directions.size(); ++k)
              if (const Support<dim> *support = node.prescribed_directions[k].support;
                  support && support->name == name)
                there += (direction * directions[k]) * directions[k];
            for (unsigned int d = 0; d < dim; ++d)
              result(node.dofs[d]) = there[d];
          }
      result.compress(VectorOperation::insert);
      elasticity.hanging_nodes().distribute(result);
      return result;
    }

    /// Adds the derivatives of the work of internal forces and follower pressures along a given
    /// displacement w, cell by cell.
    template <int dim>
    class WorkDerivative
    {
    public:
      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      explicit WorkDerivative(const Elasticity<dim> &elasticity)
        : elasticity(elasticity)
        , linear(elasticity.mesh(), elasticity.finite_elements(), elasticity.model())
        , nonlinear(deformation_kernel(elasticity))
        , pressures(elasticity)
        , volume(elasticity)
      {}

      /// @return the derivatives by the displacements of one cell.
      /// @param u displacement at the degrees of freedom of the cell
      /// @param w at the same
      const Vector<double> &
      by_displacement(const Cell &cell, const Vector<double> &u, const Vector<double> &w)
      {
        const Material &material = elasticity.material(cell->material_id());
        result.reinit(w.size());
        if (elasticity.is_nonlinear())
          nonlinear.assemble(cell, material, u, forces, &matrix);
        else
          linear.assemble(cell, material, matrix);
        // The transpose matters for follower pressures, whose stiffness is not symmetric.
        matrix.Tvmult(result, w);
        if (!pressures.empty() && pressures.assemble(cell, u, forces, &matrix))
          {
            matrix *= -1;
            matrix.Tvmult_add(result, w);
          }
        return result;
      }

      /// @return the same by the coefficients of the volumetric stress.
      const Vector<double> &
      by_volumetric_stress(const Cell &cell, const Vector<double> &u, const Vector<double> &w)
      {
        volume.assemble(cell, u, forces, &matrix);
        result.reinit(forces.size());
        matrix.vmult(result, w);
        return result;
      }

    private:
      const Elasticity<dim> &elasticity;
      StiffnessKernel<dim>   linear;
      DeformationKernel<dim> nonlinear;
      PressureKernel<dim>    pressures;
      VolumeKernel<dim>      volume;
      FullMatrix<double>     matrix;
      Vector<double>         forces, result;
    };

    /// Add the derivatives of the work of internal forces along a displacement w by the free
    /// degrees of freedom. Cells where w is zero are skipped, since it is zero in most. Collective.
    template <int dim>
    void
    add_work(const Snapshot<dim> &s, const LA::Vector &w, Functional &sum)
    {
      const Elasticity<dim> &elasticity = s.elasticity;
      const auto            &volumetric = elasticity.volumetric_stress();
      const LA::Vector       ghosted    = elasticity.with_ghosts(w),
                       displacement     = elasticity.with_ghosts(s.displacement);
      sum.of_volumetric_stress          = volumetric.zero_vector();
      WorkDerivative<dim>                  work(elasticity);
      Vector<double>                       values, u;
      std::vector<types::global_dof_index> indices;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            read_indices<dim>(cell, indices);
            values.reinit(indices.size());
            cell->get_dof_values(ghosted, values);
            if (values.linfty_norm() == 0)
              continue;
            u.reinit(indices.size());
            cell->get_dof_values(displacement, u);
            elasticity.constraints().distribute_local_to_global(
              work.by_displacement(cell, u, values), indices, sum.of_displacement);
            if (!volumetric.is_on(*cell))
              continue;
            const Vector<double> &of_volume = work.by_volumetric_stress(cell, u, values);
            for (unsigned int k = 0; k < of_volume.size(); ++k)
              sum.of_volumetric_stress(volumetric.indices(*cell)[k]) += of_volume[k];
          }
      sum.of_displacement.compress(VectorOperation::add);
      if (!volumetric.empty())
        sum.of_volumetric_stress.compress(VectorOperation::add);
    }

    /// @return the reaction of a support along a coordinate as functional w.(stiffness forces -
    /// loads - contact forces), with the indicator w of the support as lift.
    template <int dim>
    Functional
    reaction_along(const Snapshot<dim> &s, const std::string &name, const unsigned int direction)
    {
      Functional         result  = zero_functional(s);
      const GapOperator &contact = s.contact;
      result.lift =
        indicator_on_support<dim>(s.elasticity, name, Point<dim>::unit_vector(direction));
      add_work(s, result.lift, result);
      if (contact.empty())
        return result;
      for (unsigned int a = 0; a < contact.n_components(); ++a)
        {
          LA::Vector &of_traction = result.of_traction[a];
          contact.rows(a).vmult(of_traction, result.lift);
          of_traction.scale(contact.weight);
          of_traction *= -1;
          if (!contact.has_stress() || contact.theta == 0)
            continue;
          // Nitsche's method has the additional force theta S^T W (s - t)/eps.
          LA::Vector by_stress = contact.zero();
          contact.S[a].vmult(by_stress, result.lift);
          by_stress.scale(contact.weight);
          for (const auto i : by_stress.locally_owned_elements())
            by_stress(i) *= contact.theta / contact.coefficients.epsilon(i);
          by_stress.compress(VectorOperation::insert);
          of_traction += by_stress;
          by_stress *= -1;
          contact.S_free[a].Tvmult_add(result.of_displacement, by_stress);
        }
      return result;
    }
  } // namespace



  // The radial component of an axisymmetric reaction is zero: radial forces balance around the
  // axis.
  template <int dim>
  Functional
  reaction(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const auto     forces = reactions(s.elasticity, s.displacement, contact_force(s));
    Tensor<1, dim> force;
    for (unsigned int i = 0; i < s.elasticity.supports().size(); ++i)
      if (s.elasticity.supports()[i].name == name.of)
        force = forces.supports[i].force;
    const auto along = [&](const unsigned int d) {
      Functional result = d == 0 && s.elasticity.model() == Model::axisymmetric ?
                            zero_functional(s) :
                            reaction_along(s, name.of, d);
      if (result.lift.size() == 0)
        result.lift = s.elasticity.zero_vector();
      result.value = force[d];
      return result;
    };
    if (!name.component.empty())
      return along(component_number(name.component));
    std::vector<Functional> components;
    for (unsigned int d = 0; d < dim; ++d)
      components.push_back(along(d));
    return size_or_component(name, components);
  }



  // The components are degrees of freedom of the rigid body.
  template <int dim>
  Functional
  motion(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const Elasticity<dim>    &e      = s.elasticity;
    const unsigned int        body   = e.rigid_body(name.of);
    const std::vector<double> values = e.rigid_motion(s.displacement);
    std::vector<Functional>   components;
    for (unsigned int d = 0; d < dim; ++d)
      {
        Functional one = zero_functional(s);
        one.value      = values[body * RigidBody<dim>::n_dofs + d];
        if (const auto dof = e.first_dof(body) + d; e.owned().is_element(dof))
          one.of_displacement(dof) = 1;
        one.of_displacement.compress(VectorOperation::insert);
        components.push_back(one);
      }
    return size_or_component(name, components);
  }



#define INSTANTIATE(quantity)                                                                      \
  template Functional quantity(const QuantityName &, const Snapshot<2> &, const Probes<2> &);      \
  template Functional quantity(const QuantityName &, const Snapshot<3> &, const Probes<3> &);
  INSTANTIATE(reaction)
  INSTANTIATE(motion)
#undef INSTANTIATE
} // namespace Signorini
