#include <signorini/linear_algebra/diagonal.h>
#include <signorini/solve/stiffness.h>

namespace Signorini
{
  LA::Vector
  AssembledStiffness::diagonal() const
  {
    return LA::diagonal(K);
  }
} // namespace Signorini
