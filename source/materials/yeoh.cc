// SPDX-License-Identifier: Apache-2.0
#include "materials/stored_energies.h"

#include <cmath>

namespace Signorini
{
  Yeoh::Yeoh(const double bulk_modulus, const double c10, const double c20, const double c30)
    : K(bulk_modulus)
    , c10(c10)
    , c20(c20)
    , c30(c30)
  {}



  // Chain rule through i, which depends on I1 and J.
  InvariantEnergy::Derivatives
  Yeoh::derivatives(const double I1, const double /*I2*/, const double J) const
  {
    const double scale = std::pow(J, -2. / 3), i = scale * I1 - 3;
    const double d1 = c10 + i * (2 * c20 + 3 * c30 * i), d2 = 2 * c20 + 6 * c30 * i;
    // Derivatives of i = J^(-2/3) I1 - 3 by I1 and J.
    const double i_1 = scale, i_J = -2. / 3 * scale * I1 / J, i_1J = -2. / 3 * scale / J,
                 i_JJ = 10. / 9 * scale * I1 / (J * J);
    Derivatives  w;
    const double l = std::log(J);
    w.value        = i * (c10 + i * (c20 + c30 * i)) + K / 2 * l * l;
    w.first        = {{d1 * i_1, 0, d1 * i_J + K * l / J}};
    w.second[0][0] = d2 * i_1 * i_1;
    w.second[0][2] = w.second[2][0] = d2 * i_1 * i_J + d1 * i_1J;
    w.second[2][2]                  = d2 * i_J * i_J + d1 * i_JJ + K * (1 - l) / (J * J);
    return w;
  }
} // namespace Signorini
