// SPDX-License-Identifier: Apache-2.0
#include "solid/constrained_nodes.h"
#include "solid/nan_check.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The equation n . u = value at a node, solved for the component `pivot`: n[pivot] = 1 after
    /// elimination.
    template <int dim>
    struct Equation
    {
      Tensor<1, dim> n;
      double         value;
      unsigned int   pivot;
    };

    /// Gauss-Jordan elimination with one more equation: eliminate the earlier pivots from it,
    /// choose its largest entry as pivot, and eliminate that from the others. An equation that
    /// depends on earlier ones is dropped if it agrees with them.
    /// @param negligible difference of displacements that counts as agreement [length]
    /// @return false if the equation contradicts the earlier ones
    template <int dim>
    bool
    eliminate(std::vector<Equation<dim>> &equations, Equation<dim> next, const double negligible)
    {
      // The largest value that takes part in the elimination is the scale of its rounding.
      double largest = std::abs(next.value);
      for (const Equation<dim> &one : equations)
        {
          const double factor = next.n[one.pivot];
          next.n -= factor * one.n;
          next.value -= factor * one.value;
          largest = std::max(largest, std::abs(factor * one.value));
        }
      for (unsigned int d = 0; d < dim; ++d)
        // A later component becomes the pivot only if it is larger by more than rounding, so that
        // all ranks choose the same.
        if (std::abs(next.n[d]) > (1 + 1e-6) * std::abs(next.n[next.pivot]))
          next.pivot = d;
      const double factor = next.n[next.pivot];
      if (std::abs(factor) < 1e-6)
        return std::abs(next.value) <= 1e-8 * largest + negligible;
      next.n /= factor;
      next.value /= factor;
      for (Equation<dim> &one : equations)
        {
          const double share = one.n[next.pivot];
          one.n -= share * next.n;
          one.value -= share * next.value;
        }
      equations.push_back(next);
      return true;
    }

    /// The prescribed displacement along a direction at time t [length]; zero on the axis of
    /// symmetry.
    template <int dim>
    double
    prescribed(const ConstrainedNode<dim>     &node,
               const DirectionConstraint<dim> &constraint_at_node,
               const double                    t)
    {
      if (!constraint_at_node.support)
        return 0;
      return constraint_at_node.support->type == SupportType::displacement ?
               constraint_at_node.support->displacement_at(node.position, t) *
                 constraint_at_node.direction :
               constraint_at_node.support->normal_displacement.value(node.position, t);
    }

    /// The message about a prescribed value that is not finite.
    template <int dim>
    std::string
    not_finite(const Support<dim> &support, const Point<dim> &x, const double t)
    {
      const bool is_vector = support.type == SupportType::displacement;
      return Signorini::not_finite("Supports/" + support.name +
                                     (is_vector ? "/Displacement" : "/Normal displacement"),
                                   is_vector ? support.displacement.text() :
                                               support.normal_displacement.formula(),
                                   x,
                                   t);
    }

    /// The message about a support that contradicts an earlier one or the axis of symmetry.
    template <int dim>
    std::string
    contradiction(const ConstrainedNode<dim> &node, const Support<dim> &support, const double t)
    {
      const std::string what =
        support.place + ": what the support '" + support.name + "' prescribes contradicts ";
      if (!node.prescribed_directions.front().support)
        return what + "the axis of symmetry, on which the radial displacement is zero";
      return what + "an earlier support at shared nodes at t = " + Utilities::to_string(t) +
             "; set that component of one of them to 'free'";
    }
  } // namespace



  // One line of constraints for each independent direction of a node: u_pivot = value - sum of the
  // others. Messages are gathered, so that all ranks throw the same one.
  template <int dim>
  void
  constrain(const ConstrainedNodes<dim> &nodes,
            const Mesh<dim>             &mesh,
            const double                 t,
            AffineConstraints<double>   &constraints)
  {
    const double negligible = 1e-12 * mesh.size(); // collective
    // Values that are not finite are replaced by zero, so that the loop can go on to the collective
    // exchange of messages.
    std::string wrong;
    for (const auto &[index, node] : nodes)
      {
        std::vector<Equation<dim>> equations;
        for (const DirectionConstraint<dim> &constraint_at_node : node.prescribed_directions)
          {
            double value = prescribed(node, constraint_at_node, t);
            if (!std::isfinite(value))
              {
                if (t > 0) // the start is not solved for, and formulas may begin after it
                  wrong = not_finite(*constraint_at_node.support, node.position, t);
                value = 0;
              }
            if (!eliminate(equations,
                           Equation<dim>{constraint_at_node.direction, value, 0},
                           negligible))
              wrong = contradiction(node, *constraint_at_node.support, t);
          }
        for (const Equation<dim> &one : equations)
          {
            // After Gauss-Jordan elimination no equation contains the pivot of another one, as
            // AffineConstraints requires: constrained components depend on free ones only.
            const auto line = node.dofs[one.pivot];
            constraints.add_line(line);
            for (unsigned int d = 0; d < dim; ++d)
              if (d != one.pivot && std::abs(one.n[d]) > 1e-13)
                constraints.add_entry(line, node.dofs[d], -one.n[d]);
            constraints.set_inhomogeneity(line, one.value);
          }
      }
    for (const std::string &message : Utilities::MPI::all_gather(mesh.communicator(), wrong))
      if (!message.empty())
        throw SceneError(message);
  }



  template void
  constrain(const ConstrainedNodes<2> &, const Mesh<2> &, double, AffineConstraints<double> &);
  template void
  constrain(const ConstrainedNodes<3> &, const Mesh<3> &, double, AffineConstraints<double> &);
} // namespace Signorini
