#include <signorini/contact/methods/integration.h>

namespace Signorini
{
  const std::vector<std::string> &
  Integration::names()
  {
    static const std::vector<std::string> list = {"segments", "quadrature", "nodes"};
    return list;
  }
} // namespace Signorini
