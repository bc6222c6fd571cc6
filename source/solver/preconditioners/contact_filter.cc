#include "solver/preconditioners/contact_filter.h"

#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Of closed points; those of multipliers that have a constraint are rigid.
    PointVectors
    springs(const ContactSystem &system)
    {
      PointVectors D = system.springs();
      for (unsigned int a = 0; a < D.size(); ++a)
        {
          for (const auto i : D[a].locally_owned_elements())
            if (system.coupling()(i) != 0 && system.constraint()[a][a](i) != 0)
              D[a](i) = std::numeric_limits<double>::max();
          D[a].compress(VectorOperation::insert);
        }
      return D;
    }
  } // namespace



  ContactFilter::ContactFilter(const ContactSystem    &system,
                               const Hierarchy        &hierarchy,
                               const LA::DirectLibrary direct_solver,
                               const bool              zone_turns)
    : system(system)
    , amg(hierarchy, &system.gap_operator())
    , n_components(hierarchy.n_components())
    , direct_solver(direct_solver)
    , zone_turns(zone_turns)
  {
    // Those of any active set, once.
    system.stiffness().rows(contact_reach(system));
  }



  void
  ContactFilter::update()
  {
    amg.set_springs(springs(system));
    // Forces that turn push nodes along all components.
    zone = std::make_unique<ZoneSolver>(system,
                                        zone_turns ? contact_zone(system) :
                                                     contact_core(system, n_components),
                                        direct_solver,
                                        zone_turns);
    if (zone->size() > 0)
      zone->update();
  }



  void
  ContactFilter::start(LA::BlockVector &x, const LA::BlockVector &rhs) const
  {
    if (zone->size() > 0)
      zone->add_correction(x, rhs);
  }



  void
  ContactFilter::solve(LA::Vector &dst, const LA::Vector &src) const
  {
    LA::BlockVector x = system.zero(), right = x;
    right.block(0) = src;
    filter_first(x, right);
    dst = x.block(0);
  }



  void
  ContactFilter::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    // The bulk stress of mixed bodies leaves forces on the zone in each application.
    if (zone->size() > 0 && (!system.free_motions().empty() || system.bulk()))
      filter_first(dst, src);
    else
      cycle_and_filter(dst, src);
  }



  void
  ContactFilter::filter_first(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    start(dst, src);
    LA::BlockVector rest = src, correction = src, force = src;
    system.contact_terms(force, dst);
    system.stiffness().vmult_add(force.block(0), dst.block(0));
    rest -= force;
    cycle_and_filter(correction, rest);
    dst += correction;
  }



  void
  ContactFilter::cycle_and_filter(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    amg.vmult(dst.block(0), src.block(0));
    if (zone->size() > 0)
      zone->correct(dst, src);
  }
} // namespace Signorini
