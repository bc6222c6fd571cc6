// SPDX-License-Identifier: Apache-2.0
// A scene in a few lines, set up as the program does, for tests that look inside.
#pragma once

#include "driver/contact_interfaces.h"
#include "solid/cell_nodes.h"
#include "solver/contact_solver.h"

#include <memory>
#include <string>
#include <vector>

namespace TestScene
{
  using namespace Signorini;
  using namespace dealii;

  using Lines  = std::vector<std::string>;
  using Values = std::vector<double>;

  inline Lines
  operator+(Lines a, const Lines &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  /// Contact is built by use() only.
  template <int dim>
  class SmallScene
  {
  public:
    /// @param lines "Section/Key=value", as after --set
    explicit SmallScene(const Lines &lines);

    /// Choose the method by lines of the section "Contact method", and build contact.
    void
    use(const Lines &method);

    const ContactMethod &
    method() const
    {
      return scene.contact.chosen();
    }

    const GapOperator &
    gap_operator() const
    {
      return contact->gap_operator();
    }

    UnconstrainedModes
    unconstrained_modes() const;

    /// From nothing to the solution at time t.
    NewtonReport
    solve(double t, LA::Vector &u, LA::Vector &p);

    /// A field without any symmetry, the same on any number of ranks, that obeys homogeneous
    /// constraints: zero at constrained degrees of freedom.
    LA::Vector
    rough_field(double amplitude, double seed) const;

    Scene<dim>                              scene;
    Decisions<dim>                          decisions;
    ConditionalOStream                      silence;
    TimerOutput                             timer;
    std::unique_ptr<Mesh<dim>>              mesh;
    std::unique_ptr<Elasticity<dim>>        elasticity;
    std::unique_ptr<ContactInterfaces<dim>> contact;
  };

  /// All entries of a vector, on all ranks.
  Values
  everywhere(const LA::Vector &v);

  double
  dot(const Values &a, const Values &b);

  /// The value of a row at u.
  double
  at(const SparseRow &row, const Values &u);

  /// a + factor b
  Values
  sum(const Values &a, double factor, const Values &b);

  /// All entries that obey the constraints, on all ranks; `change`: those without what supports
  /// prescribe.
  template <int dim>
  Values
  distributed(const Elasticity<dim> &elasticity, const LA::Vector &u);
  template <int dim>
  Values
  distributed_change(const Elasticity<dim> &elasticity, const LA::Vector &du);

  /// The methods in all their forms, as lines for SmallScene::use().
  const std::vector<Lines> &
  all_methods();

  /// The interpolant of u(x, body).
  template <int dim, typename U>
  LA::Vector
  interpolant(const SmallScene<dim> &scene, const U &u)
  {
    LA::Vector                           result = scene.elasticity->zero_vector();
    CellNodes<dim>                       nodes_of(*scene.mesh, scene.elasticity->finite_elements());
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : scene.elasticity->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          const auto &nodes = nodes_of(cell);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (scene.elasticity->owned().is_element(indices[i]))
              result(indices[i]) =
                u(nodes[i], cell->material_id())[cell->get_fe().system_to_component_index(i).first];
        }
    result.compress(VectorOperation::insert);
    return result;
  }
} // namespace TestScene
