#include "solver/preconditioners/bulk_schur.h"

#include "linear_algebra/values.h"

namespace Signorini
{
  BulkSchur::BulkSchur(const ContactSystem            &system,
                       const BulkCoupling             &bulk,
                       std::unique_ptr<Preconditioner> others)
    : bulk(bulk)
    , others(std::move(others))
    , rest(system.zero())
  {}



  void
  BulkSchur::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    const unsigned int  last    = src.n_blocks() - 1;
    LA::Vector          m       = src.block(last);
    double *const       values  = LA::values_of(m);
    const double *const divisor = LA::values_of(bulk.schur);
    for (unsigned int i = 0; i < m.locally_owned_size(); ++i)
      values[i] /= divisor[i];
    rest             = src;
    rest.block(last) = 0;
    bulk.B.Tvmult_add(rest.block(0), m); // r_u - B^T (-m)
    others->vmult(dst, rest);
    dst.block(last) = m;
    dst.block(last) *= -1;
  }
} // namespace Signorini
