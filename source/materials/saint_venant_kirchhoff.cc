// SPDX-License-Identifier: Apache-2.0
#include "materials/stored_energies.h"

namespace Signorini
{
  using namespace dealii;

  SaintVenantKirchhoff::SaintVenantKirchhoff(const double lambda, const double mu)
    : lambda(lambda)
    , mu(mu)
  {}



  // The tangent is constant.
  ConstitutiveResponse
  SaintVenantKirchhoff::at(const SymmetricTensor<2, 3> &C, const ResponseOrder wanted) const
  {
    const SymmetricTensor<2, 3> one = unit_symmetric_tensor<3>(), strain = 0.5 * (C - one);
    ConstitutiveResponse        state;
    state.stress = lambda * trace(strain) * one + 2 * mu * strain;
    state.energy = 0.5 * (state.stress * strain);
    if (wanted == ResponseOrder::tangent)
      state.tangent = lambda * outer_product(one, one) + 2 * mu * identity_tensor<3>();
    return state;
  }
} // namespace Signorini
