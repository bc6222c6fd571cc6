// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace Signorini
{
  // One sentence about each generator, shape, method, rule and preconditioner that is chosen by its
  // name, for the template and the reference. Each function throws if there is none.

  std::string
  about_mesh(const std::string &generator);

  std::string
  about_shape(const std::string &obstacle);

  std::string
  about_method(const std::string &method);

  std::string
  about_integration(const std::string &rule);

  std::string
  about_preconditioner(const std::string &name);

  std::string
  about_schur_complement(const std::string &name);
} // namespace Signorini
