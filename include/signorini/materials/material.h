// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/materials/constitutive_law.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// The unknowns of a body.
  enum class Formulation
  {
    automatic,    ///< mixed where Poisson's ratio asks for it, and nothing is against it
    displacement, ///< all stress follows from the displacement
    mixed         ///< the stress of changes of volume is a field of its own, see VolumetricStress
  };

  /// Isotropic elasticity. At small deformation all laws are linear:
  /// sigma = lambda tr(eps) I + 2 mu eps. For 2D see Model.
  struct Material
  {
    double              youngs_modulus = 200000, poissons_ratio = 0.3;
    std::string         law = "neo-Hooke"; ///< of large deformation: one of material_laws()
    std::vector<double> coefficients = {}; ///< of the law; empty: it needs none but E and nu

    /// Null: linear elasticity of small strain.
    std::shared_ptr<const ConstitutiveLaw> constitutive_law = {};
    StrainMeasure                          strain_measure   = StrainMeasure::finite; ///< of the law

    Formulation formulation       = Formulation::automatic; ///< what the user wants
    bool        is_up_formulation = false;                  ///< what it is

    /// That of stresses that follow from the displacement: none in a mixed body, whose displacement
    /// alone does not feel how nearly incompressible it is.
    double
    lambda() const
    {
      return is_up_formulation ? 0. : full_lambda();
    }

    /// Infinite for nu = 1/2.
    double
    full_lambda() const
    {
      return youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
    }

    double
    mu() const
    {
      return youngs_modulus / (2 * (1 + poissons_ratio));
    }

    /// Of that lambda.
    double
    bulk_modulus() const
    {
      return is_up_formulation ? 2 * mu() / 3 : youngs_modulus / (3 * (1 - 2 * poissons_ratio));
    }

    /// By how much what is mixed gives way: 1/lambda, zero for nu = 1/2.
    double
    bulk_compliance() const
    {
      return (1 + poissons_ratio) * (1 - 2 * poissons_ratio) / (youngs_modulus * poissons_ratio);
    }

    void
    declare(Section &section);
  };
} // namespace Signorini
