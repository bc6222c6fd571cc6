// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/materials/constitutive_law.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// The unknowns of the elastic equations of a body.
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

    /// The constitutive law; null: linear elasticity at small strain.
    std::shared_ptr<const ConstitutiveLaw> constitutive_law = {};
    StrainMeasure                          strain_measure   = StrainMeasure::finite; ///< of the law

    Formulation formulation       = Formulation::automatic; ///< as the user chose it
    bool        is_up_formulation = false; ///< the body is in displacement-pressure form

    /// Lame's lambda in stresses that follow from the displacement: zero in displacement-pressure
    /// form, where the volumetric stress takes its place.
    double
    lambda() const
    {
      return is_up_formulation ? 0. : full_lambda();
    }

    /// Lame's lambda of the material; infinite for nu = 1/2.
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

    /// The bulk modulus that belongs to lambda(): K of the material, or 2 mu/3 in
    /// displacement-pressure form.
    double
    bulk_modulus() const
    {
      return is_up_formulation ? 2 * mu() / 3 : youngs_modulus / (3 * (1 - 2 * poissons_ratio));
    }

    /// The compliance 1/lambda of the volumetric stress; zero for nu = 1/2.
    double
    bulk_compliance() const
    {
      return (1 + poissons_ratio) * (1 - 2 * poissons_ratio) / (youngs_modulus * poissons_ratio);
    }

    void
    declare(Section &section);
  };
} // namespace Signorini
