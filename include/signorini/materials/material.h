// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/materials/constitutive_law.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// The unknowns of the elastic equations of a body (doc/theory, 6.6).
  enum class Formulation
  {
    /// Displacement-pressure form for nearly incompressible bodies, if degree, model and contact
    /// method allow it.
    automatic,
    /// The displacement alone, from which all stress follows.
    displacement,
    /// Displacement and volumetric stress, see VolumetricStress.
    mixed
  };

  /// An isotropic material. At small strain all laws are linear, sigma = lambda tr(eps) I + 2 mu
  /// eps, (1.1) of doc/theory. For 2D see Model.
  struct Material
  {
    double youngs_modulus = 200000, poissons_ratio = 0.3;
    /// Name of the law for finite strain: one of material_laws().
    std::string law = "neo-Hooke";
    /// Coefficients of the law; empty: it needs E and nu only.
    std::vector<double> coefficients = {};

    /// The constitutive law; null: linear elasticity at small strain.
    std::shared_ptr<const ConstitutiveLaw> constitutive_law = {};
    /// Strain measure of the law.
    StrainMeasure strain_measure = StrainMeasure::finite;

    /// The formulation that the user has chosen.
    Formulation formulation = Formulation::automatic;
    /// Whether the body is in displacement-pressure form.
    bool is_up_formulation = false;

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

    /// @return the shear modulus.
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

    /// Declare the keys and read their values. Throws SceneError if coefficients and moduli do not
    /// agree.
    /// @param section of the body, or of a set of its cells
    void
    declare(Section &section);
  };
} // namespace Signorini
