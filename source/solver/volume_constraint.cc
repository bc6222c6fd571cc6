// SPDX-License-Identifier: Apache-2.0
#include "solver/volume_constraint.h"

#include "linear_algebra/sparsity_pattern.h"
#include "solid/cell_nodes.h"
#include "solid/constrained_ghosted.h"
#include "solver/folded_cells.h"
#include <signorini/parameters/raw.h>

#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Constraints of the volumetric stress: there are none.
    AffineConstraints<double>
    none()
    {
      AffineConstraints<double> result;
      result.close();
      return result;
    }
  } // namespace



  // Null if no body is in displacement-pressure form.
  template <int dim>
  std::unique_ptr<VolumeConstraint<dim>>
  VolumeConstraint<dim>::create(Elasticity<dim> &elasticity)
  {
    return elasticity.volumetric_stress().empty() ?
             nullptr :
             std::make_unique<VolumeConstraint<dim>>(elasticity);
  }



  template <int dim>
  VolumeConstraint<dim>::VolumeConstraint(Elasticity<dim> &elasticity)
    : elasticity(elasticity)
    , free(none())
    , kernel(elasticity)
  {
    make_pattern();
    set_compliance();
  }



  // The pattern of B_m, which depends on materials and cells only.
  template <int dim>
  void
  VolumeConstraint<dim>::make_pattern()
  {
    const VolumetricStress<dim>         &volumetric = elasticity.volumetric_stress();
    LA::SparsityPattern                  pattern(volumetric.owned(),
                                elasticity.owned(),
                                elasticity.mesh().communicator());
    std::vector<types::global_dof_index> indices;
    for_cells([&](const Cell &cell) {
      read_indices<dim>(cell, indices);
      free.add_entries_local_to_global(
        volumetric.indices(*cell), elasticity.constraints(), indices, pattern, false);
      return false;
    });
    pattern.compress();
    my_coupling.B.reinit(pattern);
  }



  // The diagonals of C_m and of the Schur complement (doc/theory, (6.20), (7.13)). At finite strain
  // the energy m^2/(2 lambda) is per volume of the expanded body, m per volume at T_0: with the
  // ratio s of these volumes, C_m is int phi^2/(s lambda) dV.
  template <int dim>
  void
  VolumeConstraint<dim>::set_compliance()
  {
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    my_coupling.compliance = my_coupling.schur = volumetric.zero_vector();
    for_cells([&](const Cell &cell) {
      const Material &material = elasticity.material(cell->material_id());
      const double    size     = volumetric.size(*cell),
                   ratio       = elasticity.is_finite_strain() ?
                                   elasticity.thermal().volume_ratio(*cell, cell->center()) :
                                   1.,
                   compliance  = size * material.bulk_compliance() / ratio;
      for (const auto i : volumetric.indices(*cell))
        {
          my_coupling.compliance(i) = compliance;
          my_coupling.schur(i)      = compliance + size / (2 * material.mu());
        }
      return false;
    });
    my_coupling.compliance.compress(VectorOperation::insert);
    my_coupling.schur.compress(VectorOperation::insert);
  }



  // Visit the owned cells of bodies in displacement-pressure form; `visit` returns true if a cell
  // is inverted, which throws SolverFailure on all ranks afterwards. Collective.
  template <int dim>
  void
  VolumeConstraint<dim>::for_cells(const std::function<bool(const Cell &)> &visit) const
  {
    std::string folded;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && elasticity.volumetric_stress().is_on(*cell) && visit(cell))
        folded = elasticity.mesh().body_name(elasticity.mesh().body(cell));
    check_folds(folded, elasticity.mesh().communicator());
  }



  // Until linearise(), residuals are those at the origin plus the derivative there times the
  // difference (extrapolation of a load step).
  template <int dim>
  void
  VolumeConstraint<dim>::extrapolate_from(const LA::Vector &u)
  {
    origin = u;
  }



  // r_m of doc/theory, (6.19): C_m m - int phi theta_v dV, at an origin extended by the derivative.
  template <int dim>
  LA::Vector
  VolumeConstraint<dim>::residual(const LA::Vector &u) const
  {
    const bool       extends = origin.size() > 0;
    const LA::Vector next    = constrained_ghosted(elasticity, u),
                     at      = extends ? elasticity.with_ghosts(origin) : next;
    LA::Vector result        = elasticity.volumetric_stress().coefficients();
    result.scale(my_coupling.compliance);
    // Cell by cell: changes of volume at the origin or at u, with their derivative if there is an
    // origin.
    Vector<double>     values, others, changes;
    FullMatrix<double> slopes;
    for_cells([&](const Cell &cell) {
      values.reinit(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_values(at, values);
      if (!kernel.assemble(cell, values, changes, extends ? &slopes : nullptr))
        return true;
      if (extends)
        {
          others.reinit(values.size());
          cell->get_dof_values(next, others);
          others -= values;
          slopes.vmult_add(changes, others);
        }
      const auto &indices = elasticity.volumetric_stress().indices(*cell);
      for (unsigned int i = 0; i < indices.size(); ++i)
        result(indices[i]) -= changes(i);
      return false;
    });
    result.compress(VectorOperation::add);
    return result;
  }



  // B_m at u, or at the origin if there is one; at small strain it is assembled only once.
  template <int dim>
  void
  VolumeConstraint<dim>::linearise(const LA::Vector &u)
  {
    const bool       extends = origin.size() > 0;
    const LA::Vector there   = extends ? std::exchange(origin, LA::Vector()) : u;
    if (is_linearised && !elasticity.is_finite_strain())
      return;
    const LA::Vector at =
      extends ? elasticity.with_ghosts(there) : constrained_ghosted(elasticity, there);
    Vector<double>                       values, changes;
    FullMatrix<double>                   slopes;
    std::vector<types::global_dof_index> indices;
    my_coupling.B = 0;
    for_cells([&](const Cell &cell) {
      read_indices<dim>(cell, indices);
      values.reinit(indices.size());
      cell->get_dof_values(at, values);
      if (!kernel.assemble(cell, values, changes, &slopes))
        return true;
      free.distribute_local_to_global(slopes,
                                      elasticity.volumetric_stress().indices(*cell),
                                      elasticity.constraints(),
                                      indices,
                                      my_coupling.B);
      return false;
    });
    my_coupling.B.compress(VectorOperation::add);
    if (!is_linearised)
      check_determined();
    is_linearised = true;
  }



  // If all materials of a body are incompressible, the constant part of m is determined only by the
  // displacement of free surfaces: B_m^T applied to a constant must not vanish. It is compared with
  // that of a checkerboard-like field. Throws SceneError. Collective.
  template <int dim>
  void
  VolumeConstraint<dim>::check_determined() const
  {
    constexpr double             rounding   = 1e-10;
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    const Mesh<dim>             &mesh       = elasticity.mesh();
    std::set<unsigned int>       incompressible;
    for (unsigned int id = 0; id < mesh.n_materials(); ++id)
      if (elasticity.material(id).is_up_formulation &&
          elasticity.material(id).bulk_compliance() == 0)
        incompressible.insert(mesh.body_of_material(id));
    for (const unsigned int body : incompressible)
      {
        LA::Vector constant = volumetric.zero_vector(), rough = constant;
        for_cells([&](const Cell &cell) {
          const auto &indices = volumetric.indices(*cell);
          if (mesh.body(cell) == body)
            {
              // The function with the constant value 1; the first function of a cell is constant.
              constant(indices[0]) = 1 / volumetric.functions(*cell, cell->center())[0];
              rough(indices[0])    = indices[0] / (dim + 1) % 2 == 0 ? constant(indices[0]) : 0.;
            }
          return false;
        });
        for (LA::Vector *v : {&constant, &rough})
          v->compress(VectorOperation::insert);
        LA::Vector of_constant = elasticity.zero_vector(), of_rough = of_constant;
        my_coupling.B.Tvmult(of_constant, constant);
        my_coupling.B.Tvmult(of_rough, rough);
        if (of_constant.linfty_norm() <= rounding * of_rough.linfty_norm())
          throw SceneError(
            "Bodies/" + mesh.body_name(body) +
            "/Poisson's ratio = 0.5: the displacement of the whole surface is prescribed, so that "
            "the pressure is not unique; leave a part of the surface free, or set 0.4999");
      }
  }



  // Update the coefficients on all ranks by a Newton step. Collective. The version tells others
  // that linearisations with the former values are outdated.
  template <int dim>
  void
  VolumeConstraint<dim>::add(const double factor, const LA::Vector &dm)
  {
    LA::Vector m = elasticity.volumetric_stress().coefficients();
    m.add(factor, dm);
    elasticity.volumetric_stress().set_coefficients(m);
    ++my_version;
  }



  // r -= B_m^T m, the internal forces of the volumetric stress (doc/theory, (6.20)). Collective.
  template <int dim>
  void
  VolumeConstraint<dim>::subtract_forces(LA::Vector &r) const
  {
    LA::Vector m = elasticity.volumetric_stress().coefficients();
    m *= -1;
    my_coupling.B.Tvmult_add(r, m);
  }



  template class VolumeConstraint<2>;
  template class VolumeConstraint<3>;
} // namespace Signorini
