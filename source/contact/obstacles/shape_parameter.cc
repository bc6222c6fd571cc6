// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shape_parameter.h"

#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <cmath>

namespace Signorini
{
  ShapeParameter::ShapeParameter(const double value)
    : formula(Formula(short_text(value)))
    , value(value)
  {}



  void
  ShapeParameter::declare(Section           &section,
                          const std::string &key,
                          const std::string &help,
                          const Range       &range)
  {
    section.add(key, formula, help);
    if (!section.reading())
      return;
    if (formula.depends_on_place())
      section.fail(key, "must not depend on x, y or z; use a formula in t alone");
    this->range = range;
    source      = section.source_of(key);
    value       = formula.value({}, 0);
    if (!is_valid())
      section.fail(key, "must be " + range.text() + (depends_on_time() ? " at t = 0" : ""));
  }



  bool
  ShapeParameter::is_valid() const
  {
    return std::isfinite(value) && range.contains(value);
  }



  void
  ShapeParameter::set_time(const double t)
  {
    if (!depends_on_time())
      return;
    value = formula.value({}, t);
    if (!is_valid())
      throw SceneError(source + ": the value at t = " + short_text(t) + " is " + short_text(value) +
                       "; it must be " + range.text());
  }
} // namespace Signorini
