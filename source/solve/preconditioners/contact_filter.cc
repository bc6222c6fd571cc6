#include <signorini/solve/preconditioners/contact_filter.h>

namespace Signorini
{
  using namespace dealii;

  ContactFilter::ContactFilter(const ContactSystem &system,
                               const AMG           &amg,
                               const std::string   &direct_solver)
    : system(system)
    , amg(amg)
    , direct_solver(direct_solver)
  {}



  void
  ContactFilter::update()
  {
    zone = std::make_unique<ZoneSolver>(system, contact_zone(system), direct_solver);
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
    LA::BlockVector x = system.zero(), right = x, rest = x, correction = x;
    right.block(0) = src;
    start(x, right);
    system.vmult(rest, x);
    rest.sadd(-1, 1, right);
    vmult(correction, rest);
    x += correction;
    dst = x.block(0);
  }



  void
  ContactFilter::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    amg.vmult(dst.block(0), src.block(0));
    if (zone->size() > 0)
      zone->correct(dst, src);
  }
} // namespace Signorini
