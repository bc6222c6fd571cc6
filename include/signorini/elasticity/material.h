#pragma once

#include <signorini/materials/hyperelastic.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// Isotropic elasticity. At small deformation all laws are linear:
  /// sigma = lambda tr(eps) I + 2 mu eps. For 2D see Model.
  struct Material
  {
    double              youngs_modulus = 200000, poissons_ratio = 0.3;
    std::string         law = "neo-Hooke"; ///< of large deformation: one of material_laws()
    std::vector<double> coefficients;      ///< of the law; empty: it needs none but E and nu

    /// Of large deformation; null: what deforms is taken for small.
    std::shared_ptr<const Hyperelastic> energy;

    double
    lambda() const
    {
      return youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
    }

    double
    mu() const
    {
      return youngs_modulus / (2 * (1 + poissons_ratio));
    }

    double
    bulk_modulus() const
    {
      return youngs_modulus / (3 * (1 - 2 * poissons_ratio));
    }

    void
    declare(Section &section);
  };
} // namespace Signorini
