// SPDX-License-Identifier: Apache-2.0
#include <signorini/contact/methods/integration.h>

namespace Signorini
{
  const Choices<Rule> &
  Integration::rules()
  {
    static const Choices<Rule> list = {{"segments", Rule::segments},
                                       {"quadrature", Rule::quadrature},
                                       {"nodes", Rule::nodes}};
    return list;
  }
} // namespace Signorini
