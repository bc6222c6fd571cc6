// SPDX-License-Identifier: Apache-2.0
#include "solver/volume_constraint.h"

#include "linear_algebra/sparsity_pattern.h"
#include "solid/cell_nodes.h"
#include "solid/constrained_ghosted.h"
#include "solver/folded_cells.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <numeric>

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



  // Cubes have a node inside.
  template <int dim>
  typename VolumeConstraint<dim>::Hold
  VolumeConstraint<dim>::hold(const Cell &cell) const
  {
    if (cell->reference_cell().is_hyper_cube())
      return Hold::none;
    const auto is_prescribed = [&](const types::global_dof_index i) {
      const auto *const entries = elasticity.constraints().get_constraint_entries(i);
      return entries && entries->empty();
    };
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int d = 0; d < dim; ++d)
        if (!is_prescribed(cell->vertex_dof_index(v, d, cell->active_fe_index())))
          return Hold::none;
    std::vector<types::global_dof_index> indices;
    read_indices<dim>(cell, indices);
    return std::all_of(indices.begin(), indices.end(), is_prescribed) ? Hold::nodes :
                                                                        Hold::vertices;
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
      const auto &numbers = volumetric.indices(*cell);
      const auto &mass    = volumetric.mass(*cell);
      for (unsigned int i = 0; i < numbers.size(); ++i)
        for (unsigned int j = 0; j < numbers.size(); ++j)
          if (mass[i][j] != 0)
            of_masses.add(numbers[i], numbers[j]);
      return false;
    });
    for (LA::SparsityPattern *one : {&pattern, &of_masses})
      one->compress();
    my_coupling.B.reinit(pattern);
    my_coupling.C.reinit(of_masses);
  }



  // Of a cell C_m is int phi_i phi_j/(s lambda) dV: at finite strain the energy m^2/(2 lambda) is
  // per volume of the expanded body, m per volume at T_0, with the ratio s of these volumes. Where
  // vertices are held, int (m - mean of m)^2/(2 mu) dV is added (doc/theory, 6.6), which is the
  // mass matrix M minus (M 1) (M 1)^T/V.
  template <int dim>
  typename VolumetricStress<dim>::MassMatrix
  VolumeConstraint<dim>::compliance(const Cell &cell) const
  {
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    const auto                  &one        = volumetric.one(*cell);
    const auto                  &mass       = volumetric.mass(*cell);
    const Material              &material   = elasticity.material(cell->material_id());
    const double                 ratio =
      elasticity.is_finite_strain() ? elasticity.thermal().volume_ratio(*cell, cell->center()) : 1.;
    const Hold hold   = this->hold(cell);
    auto       result = mass;
    for (auto &row : result)
      for (double &entry : row)
        entry *= hold == Hold::nodes ? 0 : material.bulk_compliance() / ratio;
    if (hold == Hold::none)
      return result;
    typename VolumetricStress<dim>::Functions integrals{};
    double                                    volume = 0;
    for (unsigned int i = 0; i <= dim; ++i)
      {
        integrals[i] = std::inner_product(one.begin(), one.end(), mass[i].begin(), 0.);
        volume += integrals[i] * one[i];
      }
    for (unsigned int i = 0; i <= dim; ++i)
      for (unsigned int j = 0; j <= dim; ++j)
        result[i][j] += (mass[i][j] - integrals[i] * integrals[j] / volume) / (2 * material.mu());
    return result;
  }



  // C_m and the diagonal of the Schur complement (doc/theory, (6.20), (7.13)).
  template <int dim>
  void
  VolumeConstraint<dim>::set_compliance()
  {
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    my_coupling.C                           = 0;
    my_coupling.schur                       = volumetric.zero_vector();
    for_cells([&](const Cell &cell) {
      const auto  &numbers  = volumetric.indices(*cell);
      const auto  &mass     = volumetric.mass(*cell);
      const auto   of_cell  = compliance(cell);
      const double by_shear = 1 / (2 * elasticity.material(cell->material_id()).mu());
      for (unsigned int i = 0; i < numbers.size(); ++i)
        {
          for (unsigned int j = 0; j < numbers.size(); ++j)
            if (mass[i][j] != 0)
              my_coupling.C.add(numbers[i], numbers[j], of_cell[i][j]);
          my_coupling.schur(numbers[i]) += of_cell[i][i] + by_shear * mass[i][i];
        }
      return false;
    });
    my_coupling.C.compress(VectorOperation::add);
    my_coupling.schur.compress(VectorOperation::add);
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
      if (hold(cell) == Hold::nodes)
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



  // If a material is incompressible, the constant part of its m is determined only by the
  // displacement of surfaces that are free: B_m^T applied to a constant must not vanish. It is
  // compared with that of a checkerboard-like field. Throws SceneError. Collective.
  template <int dim>
  void
  VolumeConstraint<dim>::check_determined() const
  {
    constexpr double             rounding   = 1e-10;
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    const Mesh<dim>             &mesh       = elasticity.mesh();
    for (unsigned int id = 0; id < mesh.n_materials(); ++id)
      {
        if (!elasticity.material(id).is_up_formulation ||
            elasticity.material(id).bulk_compliance() != 0)
          continue;
        LA::Vector constant = volumetric.zero_vector(), rough = constant;
        for_cells([&](const Cell &cell) {
          if (cell->material_id() == id)
            for (unsigned int i = 0; i <= dim; ++i)
              {
                const auto   index = volumetric.indices(*cell)[i];
                const double one   = volumetric.one(*cell)[i];
                constant(index)    = one;
                // A multiplicative hash: irregular with any numbering.
                rough(index) = (std::uint32_t(index) * 2654435769u >> 31) == 0 ? one : 0.;
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
            "Bodies/" + mesh.body_name(mesh.body_of_material(id)) +
            "/Poisson's ratio = 0.5: the displacement of the whole surface is prescribed, of the body or "
            "of one of its materials, so that the pressure is not unique; leave a part of the surface free, or set 0.4999");
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
