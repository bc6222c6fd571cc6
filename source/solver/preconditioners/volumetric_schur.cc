// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioners/volumetric_schur.h"

#include "linear_algebra/values.h"

namespace Signorini
{
  VolumetricSchur::VolumetricSchur(const ContactSystem            &system,
                                   const VolumetricCoupling       &volumetric,
                                   std::unique_ptr<Preconditioner> others)
    : volumetric(volumetric)
    , others(std::move(others))
    , rest(system.zero())
  {}



  // The block triangular preconditioner (7.13): x_m = -S_m^-1 r_m, then the other unknowns with r_u
  // - B_m^T x_m.
  void
  VolumetricSchur::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    const unsigned int  last    = src.n_blocks() - 1;
    LA::Vector          m       = src.block(last);
    double *const       values  = LA::values_of(m);
    const double *const divisor = LA::values_of(volumetric.schur);
    for (unsigned int i = 0; i < m.locally_owned_size(); ++i)
      values[i] /= divisor[i];
    rest             = src;
    rest.block(last) = 0;
    volumetric.B.Tvmult_add(rest.block(0), m);
    others->vmult(dst, rest);
    dst.block(last) = m;
    dst.block(last) *= -1;
  }
} // namespace Signorini
