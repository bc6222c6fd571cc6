// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioners/factorised.h"

namespace Signorini
{
  namespace
  {
    /// A marker of all degrees of freedom.
    LA::Vector
    everywhere(const ContactSystem &system)
    {
      LA::Vector marker;
      marker.reinit(system.zero().block(0));
      marker = 1.;
      return marker;
    }
  } // namespace



  Direct::Direct(const ContactSystem &system, const LA::DirectLibrary direct_solver)
    : system(system)
    , all(system, everywhere(system), direct_solver)
  {}



  void
  Direct::update()
  {
    all.update();
  }



  void
  Direct::start(LA::BlockVector &x, const LA::BlockVector &rhs) const
  {
    vmult(x, rhs);
  }



  void
  Direct::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    all.add_correction(dst, src);
  }
} // namespace Signorini
