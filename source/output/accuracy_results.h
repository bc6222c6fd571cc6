// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_control.h"
#include "output/results.h"

#include <iosfwd>

namespace Signorini
{
  /// What results.json says of the errors on the last mesh.
  Json
  accuracy_results(const Goals &goals, const ErrorControl &control, const ErrorEstimate &estimate);

  /// The quantities of such results, as the run that wrote them had estimated them.
  std::vector<QuantityEstimate>
  quantities_of(const Json &results);

  /// A line a quantity: value, bar, and by what causes it is made. Errors are relative.
  void
  print_accuracy(const Goals &goals, const ErrorControl &control, std::ostream &out);
} // namespace Signorini
