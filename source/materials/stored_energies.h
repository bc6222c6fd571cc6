// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/hyperelastic.h"
#include "materials/invariant_energy.h"
#include "materials/stretch_energy.h"

#include <utility>
#include <vector>

namespace Signorini
{
  /// The neo-Hookean law, (6.8) of doc/theory: W = mu/2 (I1 - 3) - mu ln J + lambda/2 (ln J)^2
  /// (Bonet and Wood).
  class NeoHooke : public InvariantEnergy
  {
  public:
    NeoHooke(double lambda, double mu);

  protected:
    Derivatives
    derivatives(double I1, double I2, double J) const override;

  private:
    const double lambda, mu;
  };

  /// The Mooney-Rivlin law, (6.8) of doc/theory: W = c10 (I1 - 3) + c01 (I2 - 3) - (2 c10 + 4 c01)
  /// ln J + (lambda - 4 c01)/2 (ln J)^2, so that the reference configuration is free of stress and
  /// has the moduli lambda and mu = 2 (c10 + c01).
  class MooneyRivlin : public InvariantEnergy
  {
  public:
    MooneyRivlin(double lambda, double c10, double c01);

  protected:
    Derivatives
    derivatives(double I1, double I2, double J) const override;

  private:
    const double lambda, c10, c01;
  };

  /// Yeoh's law, (6.8) of doc/theory: W = c10 i + c20 i^2 + c30 i^3 + K/2 (ln J)^2 with i =
  /// J^(-2/3) I1 - 3, which does not depend on the change of volume; mu = 2 c10. The volumetric
  /// energy has the same form as in the displacement-pressure formulation.
  class Yeoh : public InvariantEnergy
  {
  public:
    Yeoh(double bulk_modulus, double c10, double c20, double c30);

  protected:
    Derivatives
    derivatives(double I1, double I2, double J) const override;

  private:
    const double K, c10, c20, c30;
  };

  /// Rivlin's series for rubber in the form of Abaqus and CalculiX, up to the third power of the
  /// first invariant: W = c10 i1 + c01 i2 + c20 i1^2 + c30 i1^3 + K/2 (J - 1)^2, i1 = J^(-2/3) I1 -
  /// 3, i2 = J^(-4/3) I2 - 3 (CalculiX 2.20 manual, 6.8.3, where K = 2/D1); see (6.8) of
  /// doc/theory.
  class Polynomial : public InvariantEnergy
  {
  public:
    Polynomial(double bulk_modulus, double c10, double c01, double c20, double c30);

  protected:
    Derivatives
    derivatives(double I1, double I2, double J) const override;

  private:
    const double K, c10, c01, c20, c30;
  };

  /// Ogden's law, (6.8) of doc/theory: W = sum over terms of mu_p/alpha_p (l1^alpha_p + l2^alpha_p
  /// + l3^alpha_p - 3) - mu_p ln J, plus lambda/2 (ln J)^2; mu = sum mu_p alpha_p/2.
  class Ogden : public StretchEnergy
  {
  public:
    /// @param lambda Lame's first modulus [stress]
    /// @param terms pairs (mu_p [stress], alpha_p)
    Ogden(double lambda, std::vector<std::pair<double, double>> terms);

  protected:
    Derivatives
    derivatives(const std::array<double, 3> &log_stretches) const override;

  private:
    const double                                 lambda;
    const std::vector<std::pair<double, double>> terms;
  };

  /// Hencky's law, (6.8) of doc/theory: linear elasticity of the logarithmic strains, W = mu (e1^2
  /// + e2^2 + e3^2) + lambda/2 (e1 + e2 + e3)^2.
  class Hencky : public StretchEnergy
  {
  public:
    Hencky(double lambda, double mu);

  protected:
    Derivatives
    derivatives(const std::array<double, 3> &log_stretches) const override;

  private:
    const double lambda, mu;
  };

  /// Saint Venant-Kirchhoff's law, linear elasticity of the Green strain E = (C - I)/2: W =
  /// lambda/2 (tr E)^2 + mu E:E, (6.8) of doc/theory. Its tangent is indefinite in strong
  /// compression: along one axis from a stretch of 1/sqrt(3) on.
  class SaintVenantKirchhoff : public Hyperelastic
  {
  public:
    SaintVenantKirchhoff(double lambda, double mu);

    ConstitutiveResponse
    at(const dealii::SymmetricTensor<2, 3> &C, ResponseOrder wanted) const override;

  private:
    const double lambda, mu;
  };
} // namespace Signorini
