// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace Signorini
{
  /// The highest derivative of the energy that is computed. The second derivatives take most of the
  /// time.
  enum class ResponseOrder
  {
    /// Energy and stress.
    stress,
    /// Also the consistent tangent.
    tangent
  };

  /// The strain measure that is the argument of a law.
  enum class StrainMeasure
  {
    /// The right Cauchy-Green tensor C = F^T F.
    finite,
    /// C = 1 + 2 eps with the linear strain eps.
    small
  };

  /// The arguments of a constitutive law at a quadrature point, (6.9) of doc/theory.
  struct ConstitutiveInput
  {
    /// The right Cauchy-Green tensor, or what takes its place, see StrainMeasure;
    /// positive definite.
    dealii::SymmetricTensor<2, 3> C;
    /// Internal variables at the end of the last load step, n_internal() of them; null if there are
    /// none.
    const double *internal = nullptr;
    /// Duration of the present load step [time].
    double duration = 0;
    /// The temperature minus the reference temperature at which the body is free of stress.
    double temperature_rise = 0;
  };

  /// The response of a constitutive law at a point, per reference volume and area.
  struct ConstitutiveResponse
  {
    /// Stored energy W per volume [stress], zero in the reference configuration.
    double energy = 0;
    /// Second Piola-Kirchhoff stress S; sigma for laws of small strain.
    dealii::SymmetricTensor<2, 3> stress;
    /// Tangent 2 dS/dC, with major symmetry; zero if only the stress was requested.
    dealii::SymmetricTensor<4, 3> tangent;
    /// Internal variables at the end of the load step, n_internal() of them.
    std::vector<double> internal;
  };

  /// The relation between strain and stress at a point, possibly with internal variables: their
  /// values at the end of a load step follow from those of the last one and from the strain, as in
  /// backward Euler steps. They are invariant under rotations of the body, and zero at the start.
  /// Each body has a law of its own, for small or finite strain: see Material.
  class ConstitutiveLaw
  {
  public:
    virtual ~ConstitutiveLaw() = default;

    /// @return the number of internal variables at each point.
    virtual unsigned int
    n_internal() const
    {
      return 0;
    }

    /// @return energy, stress, internal variables and, if requested, the tangent.
    /// @param in strain, internal variables, temperature
    /// @param wanted the highest derivative
    virtual ConstitutiveResponse
    response(const ConstitutiveInput &in, ResponseOrder wanted) const = 0;
  };
} // namespace Signorini
