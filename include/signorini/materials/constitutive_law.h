// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace Signorini
{
  /// How many derivatives of the energy are wanted: the second ones take most of the time.
  enum class ResponseOrder
  {
    stress,
    tangent
  };

  /// How a law measures strain.
  enum class StrainMeasure
  {
    finite, ///< C = F^T F
    small   ///< C = 1 + 2 eps with the linear strain eps
  };

  /// What a law is asked with at a point of a body.
  struct ConstitutiveInput
  {
    /// The right Cauchy-Green tensor, or what takes its place, see StrainMeasure;
    /// positive definite.
    dealii::SymmetricTensor<2, 3> C;
    /// Internal variables at the end of the last load step, n_internal() of them.
    const double *internal = nullptr;
    double        duration = 0; ///< of this load step [time]
    /// The temperature minus that at which the body is free of stress.
    double temperature_rise = 0;
  };

  /// What a material stores and exerts there, all by reference volume and area.
  struct ConstitutiveResponse
  {
    double                        energy = 0; ///< W, zero at rest
    dealii::SymmetricTensor<2, 3> stress;     ///< S, second Piola-Kirchhoff; sigma of small strain
    dealii::SymmetricTensor<4, 3> tangent;    ///< 2 dS/dC, symmetric; zero up to the stress
    std::vector<double>           internal;   ///< internal variables at the end of the load step
  };

  /// The relation between strain and stress at a point, with a memory, if it has internal
  /// variables: those of the end of a load step follow from those of the last one and from the
  /// strain, as in backward Euler steps. They are numbers that a rotation of the body does not
  /// change, zero at the start. Bodies have a law each, for small or for any strain: see Material.
  class ConstitutiveLaw
  {
  public:
    virtual ~ConstitutiveLaw() = default;

    /// Internal variables a point.
    virtual unsigned int
    n_internal() const
    {
      return 0;
    }

    virtual ConstitutiveResponse
    response(const ConstitutiveInput &in, ResponseOrder wanted) const = 0;
  };
} // namespace Signorini
