// SPDX-License-Identifier: Apache-2.0
#include "solver/nonlinear_solid.h"

#include "solid/cell_nodes.h"
#include "solid/constrained_ghosted.h"
#include "solver/folded_cells.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  NonlinearSolid<dim>::NonlinearSolid(const StiffnessForm       form,
                                      Elasticity<dim>          &elasticity,
                                      std::vector<unsigned int> body_of_dof,
                                      TimerOutput              &timer)
    : elasticity(elasticity)
    , bodies(std::move(body_of_dof))
    , timer(timer)
    , my_volumetric(VolumeConstraint<dim>::create(elasticity))
    , f(elasticity.zero_vector())
    , kernel(deformation_kernel(elasticity))
    , pressures(elasticity)
    , linearisation(Linearisation<dim>::create(form, elasticity, kernel, pressures))
    , rounding_of_strain(elasticity.is_finite_strain() ? size_of_rounding() : 0.)
  {}



  template <int dim>
  void
  NonlinearSolid<dim>::set_load(LA::Vector load)
  {
    f            = std::move(load);
    thermal_size = size_of_thermal_forces();
    if (my_volumetric && elasticity.thermal().any())
      my_volumetric->set_compliance();
  }



  // Bodies with a law contain their thermal strain in the internal forces, which are zero in
  // equilibrium: the scale is the force that would suppress the expansion. Collective.
  template <int dim>
  double
  NonlinearSolid<dim>::size_of_thermal_forces() const
  {
    if (!elasticity.thermal().any())
      return 0;
    ThermalLoad<dim> thermal(elasticity.mesh(),
                             elasticity.finite_elements(),
                             elasticity.thermal(),
                             elasticity.model());
    LA::Vector       sum = elasticity.zero_vector();
    Vector<double>   of_cell;
    for_cells([&](const Cell &cell, const std::vector<types::global_dof_index> &indices) {
      const Material &material = elasticity.material(cell->material_id());
      of_cell.reinit(indices.size());
      if (material.constitutive_law && thermal.add(cell, material, of_cell))
        elasticity.constraints().distribute_local_to_global(of_cell, indices, sum);
    });
    sum.compress(VectorOperation::add);
    return sum.l2_norm();
  }



  template <int dim>
  void
  NonlinearSolid<dim>::extrapolate_from(const LA::Vector &u)
  {
    origin = u;
    if (my_volumetric)
      my_volumetric->extrapolate_from(u);
  }



  // Loop over the locally owned cells; `indices` is reused.
  template <int dim>
  void
  NonlinearSolid<dim>::for_cells(
    const std::function<void(const Cell &, const std::vector<types::global_dof_index> &)> &visit)
    const
  {
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          visit(cell, indices);
        }
  }



  // Internal forces minus follower pressures, cell by cell (doc/theory, 6.1). With an origin
  // (extrapolate_from()) the forces are those at the origin plus its tangent times the difference.
  // Besides the forces with constraints condensed, those without are summed up for the reactions,
  // and the follower pressures for the scale of forces. Collective; throws SolverFailure on all
  // ranks if a cell is inverted.
  template <int dim>
  LA::Vector
  NonlinearSolid<dim>::forces(const LA::Vector &u) const
  {
    TimerOutput::Scope scope(timer, "assembly");
    const bool         extends  = origin.size() > 0;
    const LA::Vector   at       = extends ? elasticity.with_ghosts(origin) :
                                            constrained_ghosted(elasticity, u),
                     change     = extends ? constrained_ghosted(elasticity, u) : LA::Vector();
    LA::Vector         balanced = elasticity.zero_vector(), all = balanced, pushed = balanced;
    Vector<double>     values, others, of_cell, push;
    FullMatrix<double> tangent, of_push;
    std::string        folded;
    for_cells([&](const Cell &cell, const std::vector<types::global_dof_index> &indices) {
      const Material &material = elasticity.material(cell->material_id());
      values.reinit(indices.size());
      cell->get_dof_values(at, values);
      if (!kernel.assemble(cell, material, values, of_cell, extends ? &tangent : nullptr))
        {
          folded = elasticity.mesh().body_name(elasticity.mesh().body(cell));
          return;
        }
      const bool pushes = pressures.assemble(cell, values, push, extends ? &of_push : nullptr);
      if (extends)
        {
          others.reinit(indices.size());
          cell->get_dof_values(change, others);
          others -= values;
          tangent.vmult_add(of_cell, others);
          if (pushes)
            of_push.vmult_add(push, others);
        }
      if (pushes)
        {
          of_cell -= push;
          elasticity.constraints().distribute_local_to_global(push, indices, pushed);
        }
      elasticity.constraints().distribute_local_to_global(of_cell, indices, balanced);
      elasticity.hanging_nodes().distribute_local_to_global(of_cell, indices, all);
    });
    balanced.compress(VectorOperation::add);
    all.compress(VectorOperation::add);
    pushed.compress(VectorOperation::add);
    check_folds(folded, elasticity.mesh().communicator());
    check_pressures();
    double squares = 0;
    for (const auto i : all.locally_owned_elements())
      if (elasticity.constraints().is_constrained(i))
        squares += all(i) * all(i);
    reaction  = std::sqrt(Utilities::MPI::sum(squares, elasticity.mesh().communicator()));
    following = pushed.l2_norm();
    largest   = std::max(largest, load_size());
    return balanced;
  }



  // The entries of F = I + Grad u have the rounding of one, whatever the strain is.
  template <int dim>
  double
  NonlinearSolid<dim>::size_of_rounding() const
  {
    LA::Vector     sizes = elasticity.zero_vector();
    Vector<double> of_cell;
    for_cells([&](const Cell &cell, const std::vector<types::global_dof_index> &indices) {
      of_cell.reinit(indices.size());
      of_cell = elasticity.material(cell->material_id()).youngs_modulus * cell->measure() /
                cell->diameter() * measure(elasticity.model(), cell->center());
      elasticity.constraints().distribute_local_to_global(of_cell, indices, sizes);
    });
    sizes.compress(VectorOperation::add);
    return std::numeric_limits<double>::epsilon() * sizes.l2_norm();
  }



  template <int dim>
  double
  NonlinearSolid<dim>::rounding_without_loads() const
  {
    constexpr double nothing = 1e-13; // of the largest load so far
    const double     applied = std::max({double(f.l2_norm()), following, thermal_size});
    return applied <= nothing * largest ? rounding_of_strain : 0.;
  }



  // A pressure that is not finite on one rank is reported on all of them. Collective.
  template <int dim>
  void
  NonlinearSolid<dim>::check_pressures() const
  {
    if (pressures.empty())
      return;
    for (const std::string &fault :
         Utilities::MPI::all_gather(elasticity.mesh().communicator(), pressures.fault()))
      if (!fault.empty())
        throw SceneError(fault);
  }



  // r = f - f_int(u), see forces().
  template <int dim>
  LA::Vector
  NonlinearSolid<dim>::residual(const LA::Vector &u) const
  {
    LA::Vector r = forces(u);
    r.sadd(-1, 1, f);
    return r;
  }



  // The scale of forces: loads, reactions at prescribed displacements, follower pressures, or
  // thermal strain.
  template <int dim>
  double
  NonlinearSolid<dim>::load_size() const
  {
    return std::max({double(f.l2_norm()), reaction, following, thermal_size});
  }



  // The tangent at u, or at the origin if there is one, which is used up by this. Nothing is done
  // if neither displacement nor volumetric stress nor history nor temperature have changed.
  template <int dim>
  void
  NonlinearSolid<dim>::linearise(const LA::Vector &u)
  {
    const bool       extends = origin.size() > 0;
    const LA::Vector there   = extends ? origin : u;
    origin                   = LA::Vector();
    // The volumetric stress has the same origin and uses it up in any case.
    if (my_volumetric)
      my_volumetric->linearise(u);
    const unsigned int volumetric_version = my_volumetric ? my_volumetric->version() : 0;
    const unsigned int history_version    = elasticity.material_history().version();
    const unsigned int thermal_version    = elasticity.thermal().version();
    if (linearised.size() > 0 && linearised_volumetric == volumetric_version &&
        linearised_history == history_version && linearised_thermal == thermal_version)
      {
        LA::Vector change = there;
        change -= linearised;
        if (change.linfty_norm() == 0)
          return;
      }
    TimerOutput::Scope scope(timer, "assembly");
    // If cells are inverted, there is no valid linearisation afterwards.
    linearised = LA::Vector();
    linearisation->linearise(extends ? elasticity.with_ghosts(there) :
                                       constrained_ghosted(elasticity, there));
    linearised            = there;
    linearised_volumetric = volumetric_version;
    linearised_history    = history_version;
    linearised_thermal    = thermal_version;
  }



  // Halve the step up to five times until det F remains positive at all quadrature points and loses
  // at most nine tenths of its value (doc/theory, 4.7). Collective.
  template <int dim>
  double
  NonlinearSolid<dim>::largest_admissible_step(const LA::Vector &u, const LA::Vector &du) const
  {
    constexpr unsigned int most = 6;
    // Smallest ratio of volumes after and before.
    constexpr double least = 0.1;
    double           step  = 1;
    const LA::Vector now   = constrained_ghosted(elasticity, u);
    Vector<double>   values;
    for (unsigned int i = 0; i < most; ++i, step /= 2)
      {
        LA::Vector next = u;
        next.add(step, du);
        const LA::Vector then  = constrained_ghosted(elasticity, next);
        bool             folds = false;
        for_cells([&](const Cell &cell, const std::vector<types::global_dof_index> &indices) {
          values.reinit(indices.size());
          cell->get_dof_values(now, values);
          const std::vector<double> before = kernel.volume_ratios(cell, values);
          cell->get_dof_values(then, values);
          const std::vector<double> &after = kernel.volume_ratios(cell, values);
          for (unsigned int q = 0; q < after.size(); ++q)
            folds = folds || !(after[q] > least * std::clamp(before[q], least, 1.));
        });
        if (Utilities::MPI::max(folds ? 1 : 0, elasticity.mesh().communicator()) == 0)
          return step;
      }
    throw SolverFailure("cells would be inverted for any step length; use smaller load steps");
  }



  template class NonlinearSolid<2>;
  template class NonlinearSolid<3>;
} // namespace Signorini
