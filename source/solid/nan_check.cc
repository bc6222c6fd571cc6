// SPDX-License-Identifier: Apache-2.0
#include "solid/nan_check.h"

#include <signorini/base/text.h>

#include <sstream>

namespace Signorini
{
  using namespace dealii;

  // The message names formula, position and time, with which the user can evaluate it by hand.
  template <int dim>
  std::string
  not_finite(const std::string &key,
             const std::string &formula,
             const Point<dim>  &x,
             const double       t)
  {
    std::ostringstream text;
    text << key << " = " << shortened(formula) << ": is not a finite number at (";
    for (unsigned int d = 0; d < dim; ++d)
      text << (d > 0 ? ", " : "") << x[d];
    text << "), t = " << t << "; correct the formula";
    return text.str();
  }



  template std::string
  not_finite(const std::string &, const std::string &, const Point<2> &, double);
  template std::string
  not_finite(const std::string &, const std::string &, const Point<3> &, double);
} // namespace Signorini
