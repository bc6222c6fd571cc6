// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/tensor.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace Signorini
{
  using Json = nlohmann::ordered_json;

  template <typename Container>
  Json
  list(const Container &numbers)
  {
    Json result = Json::array();
    for (const double x : numbers)
      result.push_back(x);
    return result;
  }

  template <int dim>
  Json
  list(const dealii::Tensor<1, dim> &t)
  {
    return list(std::vector<double>(&t[0], &t[0] + dim));
  }
} // namespace Signorini
