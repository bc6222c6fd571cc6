#include <signorini/contact/sides.h>

#include <algorithm>

namespace Signorini
{
  double
  Sides::risk() const
  {
    const double finer = std::max(1., 1 / size);
    return modulus * finer * finer * finer;
  }



  bool
  Sides::better_exchanged() const
  {
    // Below one, the error of the mesh itself is larger.
    return risk() > 2 * std::max(1., exchanged().risk());
  }
} // namespace Signorini
