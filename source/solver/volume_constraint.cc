// SPDX-License-Identifier: Apache-2.0
#include "solver/volume_constraint.h"

#include "linear_algebra/sparsity_pattern.h"
#include "solid/cell_nodes.h"
#include "solid/constrained_ghosted.h"
#include "solver/folded_cells.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
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



  // Simplices of second order may have all nodes on the surface; cubes have one inside.
  template <int dim>
  bool
  VolumeConstraint<dim>::is_held(const Cell &cell) const
  {
    std::vector<types::global_dof_index> indices;
    read_indices<dim>(cell, indices);
    return std::all_of(indices.begin(), indices.end(), [&](const auto i) {
      const auto *const entries = elasticity.constraints().get_constraint_entries(i);
      return entries && entries->empty();
    });
  }



  // The patterns of B_m and C_m, which depend on materials and cells only. Orthogonal functions
  // have diagonal entries alone.
  template <int dim>
  void
  VolumeConstraint<dim>::make_pattern()
  {
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    LA::SparsityPattern          pattern(volumetric.owned(),
                                elasticity.owned(),
                                elasticity.mesh().communicator()),
      of_masses(volumetric.owned(), volumetric.owned(), elasticity.mesh().communicator());
    std::vector<types::global_dof_index> indices;
    for_cells([&](const Cell &cell) {
      read_indices<dim>(cell, indices);
      free.add_entries_local_to_global(
        volumetric.indices(*cell), elasticity.constraints(), indices, pattern, false);
      for_masses(cell, [&](const auto i, const auto j, const double) { of_masses.add(i, j); });
      return false;
    });
    for (LA::SparsityPattern *one : {&pattern, &of_masses})
      one->compress();
    my_coupling.B.reinit(pattern);
    my_coupling.C.reinit(of_masses);
  }



  // C_m and the diagonal of the Schur complement (doc/theory, (6.20), (7.13)). At finite strain the
  // energy m^2/(2 lambda) is per volume of the expanded body, m per volume at T_0: with the ratio s
  // of these volumes, C_m is int phi_i phi_j/(s lambda) dV. Cells that are held have the compliance
  // 1/(2 mu), so that differences within them cost as much as elsewhere.
  template <int dim>
  void
  VolumeConstraint<dim>::set_compliance()
  {
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    my_coupling.C                           = 0;
    my_coupling.schur                       = volumetric.zero_vector();
    for_cells([&](const Cell &cell) {
      const Material &material = elasticity.material(cell->material_id());
      const double    ratio    = elasticity.is_finite_strain() ?
                                   elasticity.thermal().volume_ratio(*cell, cell->center()) :
                                   1.,
                   by_shear    = 1 / (2 * material.mu()),
                   by_volume   = material.bulk_compliance() / ratio,
                   compliance  = is_held(cell) ? by_shear : by_volume;
      for_masses(cell, [&](const auto i, const auto j, const double mass) {
        my_coupling.C.add(i, j, compliance * mass);
        if (i == j)
          my_coupling.schur(i) += (by_volume + by_shear) * mass;
      });
      return false;
    });
    my_coupling.C.compress(VectorOperation::add);
    my_coupling.schur.compress(VectorOperation::add);
  }



  // All entries of the mass matrix of a cell that are not zero by the choice of the functions. In a
  // cell that is held, no displacement depends on m, so that a vertex of such cells alone would
  // have any value: the form V (mean of m_v^2 - (mean of m_v)^2) of the n values m_v at the
  // vertices takes the place of int m^2 dV, and lets them be equal.
  template <int dim>
  void
  VolumeConstraint<dim>::for_masses(
    const Cell                                                                          &cell,
    const std::function<void(types::global_dof_index, types::global_dof_index, double)> &visit)
    const
  {
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    const auto                  &indices    = volumetric.indices(*cell);
    const auto                  &one        = volumetric.one(*cell);
    auto                         mass       = volumetric.mass(*cell);
    if (is_held(cell))
      {
        constexpr double n      = dim + 1;
        double           volume = 0;
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            volume += one[i] * mass[i][j] * one[j];
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            mass[i][j] = volume / n * ((i == j) - 1 / n) / (one[i] * one[j]);
      }
    for (unsigned int i = 0; i < indices.size(); ++i)
      for (unsigned int j = 0; j < indices.size(); ++j)
        if (mass[i][j] != 0)
          visit(indices[i], indices[j], mass[i][j]);
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
    LA::Vector result        = elasticity.volumetric_stress().zero_vector();
    my_coupling.C.vmult(result, elasticity.volumetric_stress().coefficients());
    // Cell by cell: changes of volume at the origin or at u, with their derivative if there is an
    // origin.
    Vector<double>     values, others, changes;
    FullMatrix<double> slopes;
    for_cells([&](const Cell &cell) {
      if (is_held(cell))
        return false;
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
          if (mesh.body(cell) == body)
            for (unsigned int i = 0; i <= dim; ++i)
              {
                const auto   index = volumetric.indices(*cell)[i];
                const double one   = volumetric.one(*cell)[i];
                constant(index)    = one;
                // Signs that differ between neighbours, with dim + 1 numbers a cell or one a
                // vertex.
                rough(index) = (index / (dim + 1) + index) % 2 == 0 ? one : 0.;
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
