#include <signorini/solve/preconditioners/contact_filter.h>

#include <Epetra_CrsMatrix.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Nonzero at the degrees of freedom that some contact point touches.
    LA::Vector
    touched(const ContactSystem &system)
    {
      LA::Vector sums;
      sums.reinit(system.zero().block(0));
      if (!system.gap_operator().empty())
        {
          const int error =
            system.gap_operator().B_free.trilinos_matrix().InvColMaxs(*sums.trilinos_vector()(0));
          // A positive code only says that some columns are empty, and those get the largest
          // number.
          AssertThrow(error >= 0, ExcTrilinosError(error));
          for (const auto i : sums.locally_owned_elements())
            sums(i) = sums(i) < 1e100 ? 1. : 0.;
          sums.compress(VectorOperation::insert);
        }
      return sums;
    }
  } // namespace



  ContactFilter::ContactFilter(const ContactSystem &system,
                               const AMG           &amg,
                               const std::string   &direct_solver)
    : system(system)
    , amg(amg)
    , zone(system, touched(system), direct_solver)
    , residual(system.zero())
    , correction(residual.block(0))
  {}



  void
  ContactFilter::update()
  {
    if (zone.size() > 0)
      zone.update();
  }



  void
  ContactFilter::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    if (zone.size() == 0)
      return amg.vmult(dst.block(0), src.block(0));

    const auto compute_residual = [&]() {
      system.vmult(residual, dst);
      residual.sadd(-1, 1, src);
    };
    zone.add_correction(dst, src);
    compute_residual();
    amg.vmult(correction, residual.block(0));
    dst.block(0) += correction;
    compute_residual();
    zone.add_correction(dst, residual);
  }
} // namespace Signorini
