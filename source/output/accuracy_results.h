// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_control.h"
#include "output/results.h"

#include <iosfwd>

namespace Signorini
{
  /// @return the entry `accuracy` of results.json: the error estimates on the last mesh.
  /// @param goals the quantities and targets
  /// @param control the histories of their errors
  /// @param estimate the estimate on the last mesh
  Json
  accuracy_results(const Goals &goals, const ErrorControl &control, const ErrorEstimate &estimate);

  /// @return the estimates of all quantities from an entry `accuracy`, in their order, as the run
  /// that wrote it had computed them. Throws if entries are missing.
  /// @param results the entry
  std::vector<QuantityEstimate>
  quantities_of(const Json &results);

  /// Print a table with one line for each quantity: value, error bound, and the parts of the error,
  /// which are relative to the value.
  /// @param goals the quantities and targets
  /// @param control the histories of their errors
  /// @param out the stream
  void
  print_accuracy(const Goals &goals, const ErrorControl &control, std::ostream &out);
} // namespace Signorini
