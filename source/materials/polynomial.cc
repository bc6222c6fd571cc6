// SPDX-License-Identifier: Apache-2.0
#include "materials/stored_energies.h"

#include <cmath>

namespace Signorini
{
  Polynomial::Polynomial(const double bulk_modulus,
                         const double c10,
                         const double c01,
                         const double c20,
                         const double c30)
    : K(bulk_modulus)
    , c10(c10)
    , c01(c01)
    , c20(c20)
    , c30(c30)
  {}



  // Chain rule through i1 and i2, which depend on I1 or I2 and on J.
  InvariantEnergy::Derivatives
  Polynomial::derivatives(const double I1, const double I2, const double J) const
  {
    const double scale1 = std::pow(J, -2. / 3), scale2 = scale1 * scale1, i = scale1 * I1 - 3;
    const double d1 = c10 + i * (2 * c20 + 3 * c30 * i), d2 = 2 * c20 + 6 * c30 * i;
    // Derivatives of i1 (i_) and i2 (j_) by J, and mixed ones by I1 or I2.
    const double i_J = -2. / 3 * scale1 * I1 / J, i_1J = -2. / 3 * scale1 / J,
                 i_JJ = 10. / 9 * scale1 * I1 / (J * J);
    const double j_J = -4. / 3 * scale2 * I2 / J, j_2J = -4. / 3 * scale2 / J,
                 j_JJ = 28. / 9 * scale2 * I2 / (J * J);
    Derivatives w;
    w.value = i * (c10 + i * (c20 + c30 * i)) + c01 * (scale2 * I2 - 3) + K / 2 * (J - 1) * (J - 1);
    w.first = {{d1 * scale1, c01 * scale2, d1 * i_J + c01 * j_J + K * (J - 1)}};
    w.second[0][0] = d2 * scale1 * scale1;
    w.second[0][2] = w.second[2][0] = d2 * scale1 * i_J + d1 * i_1J;
    w.second[1][2] = w.second[2][1] = c01 * j_2J;
    w.second[2][2]                  = d2 * i_J * i_J + d1 * i_JJ + c01 * j_JJ + K;
    return w;
  }
} // namespace Signorini
