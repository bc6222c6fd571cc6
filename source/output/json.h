// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/tensor.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace Signorini
{
  /// JSON objects that keep the order of their entries.
  using Json = nlohmann::ordered_json;

  /// @return numbers as an array.
  /// @param numbers any container of numbers
  template <typename Container>
  Json
  list(const Container &numbers)
  {
    Json result = Json::array();
    for (const double x : numbers)
      result.push_back(x);
    return result;
  }

  /// @return the components of a vector as an array.
  /// @param t the vector
  template <int dim>
  Json
  list(const dealii::Tensor<1, dim> &t)
  {
    return list(std::vector<double>(&t[0], &t[0] + dim));
  }
} // namespace Signorini
