// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/hyperelastic.h"
#include <signorini/materials/material.h>

#include <functional>

namespace Signorini
{
  /// A material of large deformation, as the scene file calls it.
  struct MaterialLaw
  {
    std::string name, about;
    /// Description of the entry `Coefficients`; empty if the law has none.
    std::string coefficients;
    /// mu at rest by the coefficients. Throws std::domain_error where they are none.
    std::function<double(const std::vector<double> &)> shear_modulus;
    /// @param material whose moduli are those of the coefficients
    std::function<std::shared_ptr<const Hyperelastic>(const Material &material)> make;
  };

  const std::vector<MaterialLaw> &
  material_laws();

  /// The material law of a material.
  const MaterialLaw &
  law_of(const Material &material);
} // namespace Signorini
