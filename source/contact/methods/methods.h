// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/methods/method.h>

namespace Signorini
{
  // All methods; each has its file here, and its line in the registry of ContactMethod::create().

  std::shared_ptr<ContactMethod>
  make_penalty();

  std::shared_ptr<ContactMethod>
  make_augmented_lagrangian();

  std::shared_ptr<ContactMethod>
  make_perturbed_lagrangian();

  std::shared_ptr<ContactMethod>
  make_lagrange_multiplier();

  std::shared_ptr<ContactMethod>
  make_direct_elimination();

  std::shared_ptr<ContactMethod>
  make_nitsche();
} // namespace Signorini
