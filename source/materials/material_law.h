// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/hyperelastic.h"
#include <signorini/materials/material.h>

#include <deal.II/base/tensor.h>

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

  /// @return a law of a body that expands with temperature: the deformation gradient is the product
  /// of an elastic one and the stretches 1 + alpha_i (T - T_0) along the axes (doc/theory, (6.22);
  /// Lubarda, Appl. Mech. Rev. 57 (2004) 95). The given law gets the elastic part, per volume of
  /// the expanded body without stress: a uniformly heated body behaves as a larger one. Laws of
  /// small strain get the difference of both strains. The response throws std::domain_error where
  /// the body would shrink to nothing, 1 + alpha_i (T - T_0) <= 0.
  /// @param law of the elastic deformation
  /// @param measure the strain measure of that law
  /// @param alpha coefficients of expansion along the axes [1/temperature]
  std::shared_ptr<const ConstitutiveLaw>
  with_thermal_stretch(std::shared_ptr<const ConstitutiveLaw> law,
                       StrainMeasure                          measure,
                       const dealii::Tensor<1, 3>            &alpha);

  /// @return the law of a material.
  /// @param material whose law is one of material_laws()
  const MaterialLaw &
  law_of(const Material &material);
} // namespace Signorini
