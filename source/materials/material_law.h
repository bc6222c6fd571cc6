// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/hyperelastic.h"
#include <signorini/materials/material.h>

#include <functional>

namespace Signorini
{
  /// A constitutive law for finite strain under its name in scene files.
  struct MaterialLaw
  {
    std::string name, about;
    /// Description of the entry `Coefficients`; empty if the law has none.
    std::string coefficients;
    /// The shear modulus in the reference configuration as function of the coefficients; it throws
    /// std::domain_error where they are not valid.
    std::function<double(const std::vector<double> &)> shear_modulus;
    /// Creates the law for a material, whose moduli agree with its coefficients.
    std::function<std::shared_ptr<const ConstitutiveLaw>(const Material &material)> make;
  };

  /// @return all laws: the registry, to which new laws are added.
  const std::vector<MaterialLaw> &
  material_laws();

  /// @return the law of a material.
  /// @param material whose law is one of material_laws()
  const MaterialLaw &
  law_of(const Material &material);
} // namespace Signorini
