#pragma once

namespace Signorini
{
  class Section;

  /// Isotropic linear elasticity: sigma = lambda tr(eps) I + 2 mu eps. For 2D see Model.
  struct Material
  {
    double youngs_modulus = 200000, poissons_ratio = 0.3;

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

    void
    declare(Section &section);
  };
} // namespace Signorini
