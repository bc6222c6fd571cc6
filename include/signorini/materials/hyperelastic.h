#pragma once

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini
{
  /// How many derivatives of W are wanted: the second ones take most of the time.
  enum class UpTo
  {
    stress,
    tangent
  };

  /// What a material stores and exerts at a deformation, all by reference volume and area.
  struct HyperelasticState
  {
    double                        energy = 0; ///< W, zero at rest
    dealii::SymmetricTensor<2, 3> stress;     ///< S = 2 dW/dC, the second Piola-Kirchhoff stress
    dealii::SymmetricTensor<4, 3> tangent;    ///< 2 dS/dC; zero up to the stress
  };

  /// A stored energy W(C) of the right Cauchy-Green tensor C = F^T F, thesis (7), isotropic and
  /// free of stress at rest, with its derivatives. C is positive definite.
  class Hyperelastic
  {
  public:
    virtual ~Hyperelastic() = default;

    virtual HyperelasticState
    at(const dealii::SymmetricTensor<2, 3> &C, UpTo wanted) const = 0;
  };
} // namespace Signorini
