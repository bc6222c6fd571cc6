#pragma once

#include <signorini/contact/discretisation/gap_operator.h>
#include <signorini/contact/discretisation/surface.h>
#include <signorini/scene/scene.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <memory>
#include <set>

namespace Signorini
{
  /// The contact pairs of a scene on the present mesh: how far partners are looked for, the
  /// surfaces that were found, and the gap operator that the solver sees. How far surfaces may come
  /// closer is guessed before the first solution and checked after each. Keeps references to its
  /// arguments.
  template <int dim>
  class ContactSetup
  {
  public:
    /// @param scene whose pairs may be exchanged by build()
    ContactSetup(Scene<dim>                 &scene,
                 const Elasticity<dim>      &elasticity,
                 dealii::TimerOutput        &timer,
                 dealii::ConditionalOStream &out);

    /// Search, and assemble the gap operator, which ends all references to the former one and to
    /// the surfaces. Slave and master of pairs are exchanged where their stiffness and their meshes
    /// ask for it. Throws SceneError where a pair that has to see its partner does not.
    void
    build();

    // After build():

    const std::vector<ContactSurface<dim>> &
    surfaces() const
    {
      return my_surfaces;
    }

    GapOperator &
    gap_operator()
    {
      return *contact;
    }

    const GapOperator &
    gap_operator() const
    {
      return *contact;
    }

    /// True if surfaces have moved so far with displacement u that others than the candidates may
    /// touch: then more are, with the next build().
    bool
    needs_more(const LA::Vector &u);

    /// Look farther, with the next build(), for what may stop loose bodies. False if that is far
    /// enough.
    bool
    look_farther();

    /// The share of initial overlaps that counts at time t, and the stress of the temperatures that
    /// the bodies have now.
    void
    set_time(double t);

    /// Two pairs that press the same nodes, as a cause of singular systems, in words; may be empty.
    /// Collective.
    std::string
    pressed_twice(const LA::Vector &active) const;

    /// What was left out, for the results.
    std::vector<std::string>
    left_out() const;

  private:
    ContactSurface<dim>
    surface_of(const ContactPair<dim> &pair, unsigned int i) const;
    /// If the mesh asks for it, and if the other side can be slave.
    void
    exchange_sides(unsigned int i);

    Scene<dim>                 &scene;
    const Elasticity<dim>      &elasticity;
    dealii::TimerOutput        &timer;
    dealii::ConditionalOStream &out;

    std::vector<double>              reach; ///< of each pair: gaps of candidates
    std::vector<ContactSurface<dim>> my_surfaces;
    std::unique_ptr<GapOperator>     contact;
    std::set<std::string>            kept; ///< pairs whose master cannot be the slave
  };

  /// How far surfaces of a scene may come closer: sound guesses save a second solution.
  template <int dim>
  double
  largest_closing(const Scene<dim> &scene, const Mesh<dim> &mesh);

  /// The pairs that Names = auto stands for. Collective.
  template <int dim>
  std::vector<ContactPair<dim>>
  automatic_pairs(const Scene<dim> &scene, const Mesh<dim> &mesh, dealii::ConditionalOStream &out);
} // namespace Signorini
