// SPDX-License-Identifier: Apache-2.0
#include "small_scene.h"

#include "driver/scene_setup.h"
#include "solid/cell_nodes.h"
#include "solid/rigid_body_modes.h"
#include <signorini/parameters/section.h>

#include <cmath>
#include <iostream>

namespace TestScene
{
  namespace
  {
    Section
    section_of(RawSection &raw, const Lines &lines)
    {
      for (const std::string &line : lines)
        override_value(raw, line);
      return Section(raw);
    }

    template <int dim>
    Scene<dim>
    read(const Lines &lines)
    {
      RawSection raw;
      Section    section = section_of(raw, lines);
      Scene<dim> scene;
      scene.declare(section);
      section.close();
      scene.read_files("");
      scene.check();
      return scene;
    }
  } // namespace



  template <int dim>
  SmallScene<dim>::SmallScene(const Lines &lines)
    : scene(read<dim>(lines))
    , decisions(scene)
    , silence(std::cout, false)
    , timer(MPI_COMM_SELF, silence, TimerOutput::never, TimerOutput::wall_times)
    , mesh(make_mesh(decisions, MPI_COMM_WORLD))
    , elasticity(make_elasticity(decisions, *mesh))
  {
    elasticity->setup();
    elasticity->assemble();
  }



  template <int dim>
  void
  SmallScene<dim>::use(const Lines &method)
  {
    RawSection      raw;
    Section         section = section_of(raw, method);
    ContactSettings settings;
    settings.declare(section);
    section.close();
    for (auto &[name, one] : settings.methods)
      {
        one->has_friction = scene.contact.chosen().has_friction;
        one->has_ties     = scene.contact.chosen().has_ties;
        one->has_strength = scene.contact.chosen().has_strength;
      }
    scene.contact = settings;
    decisions.check();
    contact = std::make_unique<ContactInterfaces<dim>>(decisions, *elasticity, timer, silence);
    contact->build(Configuration<dim>(*elasticity));
  }



  template <int dim>
  UnconstrainedModes
  SmallScene<dim>::unconstrained_modes() const
  {
    if (!elasticity->has_unsupported_modes())
      return {};
    return {elasticity->unconstrained_modes(), elasticity->stabilising_stiffness(), gap_operator()};
  }



  template <int dim>
  NewtonReport
  SmallScene<dim>::solve(const double t, LA::Vector &u, LA::Vector &p)
  {
    elasticity->set_time(t);
    contact->set_time(t);
    LinearElasticSolid bodies(std::make_unique<AssembledStiffness>(elasticity->stiffness()),
                              elasticity->stabilising_stiffness(),
                              elasticity->constraints(),
                              bodies_of_dofs(*elasticity));
    bodies.set_load(elasticity->load());
    SolidHierarchy hierarchies(scene.solver, bodies.stiffness(), *elasticity);
    ContactSolver  solver(scene.newton,
                         scene.solver,
                         method(),
                         bodies,
                         gap_operator(),
                         unconstrained_modes(),
                         hierarchies,
                         timer);
    u = elasticity->zero_vector();
    elasticity->distribute(u);
    ContactState       state  = open_contact(gap_operator());
    const NewtonReport report = solver.newton.solve(u, state, [](const NewtonStep &) {});
    p                         = state.pressure();
    elasticity->distribute(u);
    return report;
  }



  template <int dim>
  LA::Vector
  SmallScene<dim>::rough_field(const double amplitude, const double seed) const
  {
    LA::Vector                           u = elasticity->zero_vector();
    CellNodes<dim>                       nodes_of(*mesh, elasticity->finite_elements());
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : elasticity->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          const auto &nodes = nodes_of(cell);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (elasticity->owned().is_element(indices[i]))
              {
                double phase = seed + 2.3 * cell->material_id() +
                               1.7 * cell->get_fe().system_to_component_index(i).first;
                for (unsigned int d = 0; d < dim; ++d)
                  phase += (17.3 + 11.9 * d) * nodes[i][d];
                u(indices[i]) = amplitude * std::sin(phase);
              }
        }
    for (unsigned int b = 0; b < elasticity->rigid_bodies().size(); ++b)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        if (const auto dof = elasticity->first_dof(b) + i; elasticity->owned().is_element(dof))
          u(dof) = amplitude * std::sin(seed + 1.7 * i);
    u.compress(VectorOperation::insert);
    elasticity->constraints().set_zero(u);
    return u;
  }



  Values
  everywhere(const LA::Vector &v)
  {
    Values values(v.size(), 0.);
    for (const auto i : v.locally_owned_elements())
      values[i] = v(i);
    Utilities::MPI::sum(values, MPI_COMM_WORLD, values);
    return values;
  }



  double
  dot(const Values &a, const Values &b)
  {
    double result = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      result += a[i] * b[i];
    return result;
  }



  double
  at(const SparseRow &row, const Values &u)
  {
    double sum = 0;
    for (const auto &[index, value] : row)
      sum += value * u[index];
    return sum;
  }



  Values
  sum(const Values &a, const double factor, const Values &b)
  {
    Values result = a;
    for (std::size_t i = 0; i < a.size(); ++i)
      result[i] += factor * b[i];
    return result;
  }



  template <int dim>
  Values
  distributed(const Elasticity<dim> &elasticity, const LA::Vector &u)
  {
    LA::Vector full = u;
    elasticity.distribute(full);
    return everywhere(full);
  }



  template <int dim>
  Values
  distributed_change(const Elasticity<dim> &elasticity, const LA::Vector &du)
  {
    return sum(distributed(elasticity, du), -1, distributed(elasticity, elasticity.zero_vector()));
  }



  const std::vector<Lines> &
  all_methods()
  {
    static const std::vector<Lines> methods = {
      {"Method=penalty", "penalty/Factor=5", "penalty/Mesh size exponent=1"},
      {"Method=penalty", "penalty/Factor=5", "Pressure basis=standard"},
      {"Method=penalty", "penalty/Factor=5", "penalty/Weighting=pointwise"},
      {"Method=Lagrange multiplier", "Lagrange multiplier/Complementarity factor=3"},
      {"Method=Lagrange multiplier", "Pressure basis=standard"},
      {"Method=augmented Lagrangian", "augmented Lagrangian/Factor=7"},
      {"Method=augmented Lagrangian", "augmented Lagrangian/Scheme=Newton"},
      {"Method=perturbed Lagrangian", "perturbed Lagrangian/Factor=7"},
      {"Method=perturbed Lagrangian",
       "perturbed Lagrangian/Factor=7",
       "perturbed Lagrangian/System=condensed"},
      {"Method=Nitsche", "Nitsche/Theta=1"},
      {"Method=Nitsche", "Nitsche/Theta=0"},
      {"Method=Nitsche", "Nitsche/Theta=-1"},
      {"Method=Nitsche", "Nitsche/Unbiased=yes"},
      {"Method=direct elimination"}};
    return methods;
  }



  template class SmallScene<2>;
  template class SmallScene<3>;
  template Values
  distributed(const Elasticity<2> &, const LA::Vector &);
  template Values
  distributed(const Elasticity<3> &, const LA::Vector &);
  template Values
  distributed_change(const Elasticity<2> &, const LA::Vector &);
  template Values
  distributed_change(const Elasticity<3> &, const LA::Vector &);
} // namespace TestScene
