// SPDX-License-Identifier: Apache-2.0
// What is checked of a solution at the contact interfaces.
#include "base/solver_failure.h"
#include "contact/constraints/inactive_pairs.h"
#include "contact/search/obstacle_path.h"
#include "driver/contact_interfaces.h"
#include <signorini/base/text.h>

namespace Signorini
{
  using namespace dealii;

  // A large step may carry an obstacle through a thin body to its other side, where no point
  // penetrates it. Collective.
  template <int dim>
  void
  ContactInterfaces<dim>::check_tunnelling(const LA::Vector &from, const LA::Vector &to) const
  {
    TimerOutput::Scope       scope(timer, "search");
    const Configuration<dim> start(elasticity, from);
    for (const ContactPair<dim> &pair : decisions.pairs)
      if (const Obstacle<dim> *obstacle = scene.obstacle_of(pair);
          obstacle && !obstacle->shape->is_attached() && pair.acts(elasticity.time()))
        if (obstacle_tunnels(start, to, pair.slave, *obstacle))
          throw SolverFailure("the obstacle '" + obstacle->name + "' would pass through '" +
                              pair.slave +
                              "' in one load step (tunnelling); use smaller load steps");
  }



  // After a solution: obstacles that faces without contact points have passed through, or that a
  // body encloses, are failures of the load step. Collective.
  template <int dim>
  void
  ContactInterfaces<dim>::check_missed_penetration(const LA::Vector &u,
                                                   const LA::Vector &pressure) const
  {
    TimerOutput::Scope       scope(timer, "search");
    const std::vector<bool>  idle = inactive_pairs(*contact, pressure, decisions.pairs.size());
    const Configuration<dim> now(elasticity, u);
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      if (const Obstacle<dim> *obstacle = scene.obstacle_of(decisions.pairs[i]);
          obstacle && !obstacle->shape->is_attached() && decisions.pairs[i].acts(build_time))
        {
          const std::string &slave = decisions.pairs[i].slave;
          std::vector<bool>  seen; // those of the faces with contact points
          if (!idle[i])
            for (const SlaveFace<dim> &face : my_surfaces[i].slave_faces)
              seen.push_back(face.degree > 0);
          if (penetrates_obstacle(now, slave, *obstacle, seen) ||
              encloses_obstacle(now, slave, *obstacle))
            throw SolverFailure("'" + slave + "' has passed through the obstacle '" +
                                obstacle->name +
                                "'; use smaller load steps, or refine the surface");
        }
  }



  // Contact forces at points from the pressures of rows (ghosted), then the geometry error of each
  // pair (doc/theory, 5.7); the largest estimated change of pressure counts.
  template <int dim>
  GeometryChange
  ContactInterfaces<dim>::neglected(const LA::Vector &u, const LA::Vector &pressure) const
  {
    const Configuration<dim> now(elasticity, u);
    LA::Vector               p(rows->owned, rows->writable, elasticity.mesh().communicator());
    p = pressure;
    if (scene.contact.chosen().has_strength)
      {
        LA::Vector of_contact = pressure;
        for (const auto i : of_contact.locally_owned_elements())
          if (status_of(contact->coefficients.least_status(i)) == ContactStatus::stick)
            of_contact(i) = 0;
        of_contact.compress(VectorOperation::insert);
        p = of_contact;
      }
    GeometryChange largest;
    for (unsigned int i = 0; i < my_surfaces.size(); ++i)
      {
        // With small strain, tied bodies are linear as one body is, where their bond is intact.
        if (decisions.pairs[i].is_tied && !decisions.pairs[i].strength.given())
          continue;
        // The force of each contact point: its shares of the tractions of the rows.
        std::vector<double> forces;
        for (const auto &shares : rows->shares[i])
          {
            forces.push_back(0);
            for (const auto &[row, weight] : shares)
              forces.back() += weight * p(row);
          }
        const ContactPair<dim> &pair = decisions.pairs[i];
        const GeometryChange    change =
          geometry_change(now, pair, scene.obstacle_of(pair), my_surfaces[i], forces);
        if (change.pressure > largest.pressure)
          largest = change;
      }
    return largest;
  }



  // A node is over-constrained if rows of two pairs are active there. The numbers of one such pair
  // of pairs are encoded in one integer, so that all ranks agree on the largest code. Collective.
  template <int dim>
  std::string
  ContactInterfaces<dim>::overconstrained_nodes(const LA::Vector &active) const
  {
    std::map<types::global_dof_index, unsigned int> pair_of_node;
    unsigned int                                    both[2] = {0, 0}; // one more than numbers
    const IndexSet                                  rows    = active.locally_owned_elements();
    auto                                            row     = rows.begin();
    for (unsigned int k = 0; k < contact->origin.node.size(); ++k, ++row)
      if (active(*row) > 0)
        if (const auto [at, is_new] =
              pair_of_node.insert({contact->origin.node[k], contact->origin.pair[k]});
            !is_new)
          {
            both[0] = at->second + 1;
            both[1] = contact->origin.pair[k] + 1;
          }
    const unsigned int code = both[0] * decisions.pairs.size() + both[1],
                       most = Utilities::MPI::max(code, elasticity.mesh().communicator());
    if (most == 0)
      return "";
    const unsigned int second = (most - 1) % decisions.pairs.size(),
                       first  = (most - 1) / decisions.pairs.size() - 1;
    return "; pairs '" + decisions.pairs[first].name + "' and '" + decisions.pairs[second].name +
           "' are active at the same nodes (over-constrained): if they act in the same direction, "
           "remove one, or use a penalty method";
  }



#define INSTANTIATE(dim)                                                                              \
  template void ContactInterfaces<dim>::check_tunnelling(const LA::Vector &, const LA::Vector &)      \
    const;                                                                                            \
  template void           ContactInterfaces<dim>::check_missed_penetration(const LA::Vector &,        \
                                                                 const LA::Vector &) const; \
  template GeometryChange ContactInterfaces<dim>::neglected(const LA::Vector &,                       \
                                                            const LA::Vector &) const;                \
  template std::string    ContactInterfaces<dim>::overconstrained_nodes(const LA::Vector &) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
