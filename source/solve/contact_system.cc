#include <signorini/solve/contact_system.h>

namespace Signorini
{
  using namespace dealii;

  ContactSystem::ContactSystem(const LA::SparseMatrix &stiffness,
                               const GapOperator      &contact,
                               const ContactMethod    &method)
    : K(stiffness)
    , contact(contact)
    , saddle(method.has_multipliers() && !contact.empty())
    , factor(method.factor())
    , compliance(method.compliance())
    , D(contact.zero())
    , A(contact.zero())
    , I(contact.zero())
  {}



  void
  ContactSystem::set_active(const LA::Vector &active)
  {
    for (const auto i : active.locally_owned_elements())
      {
        const double scale = contact.weight(i) * contact.stiffness(i);
        D(i)               = saddle ? 0. : factor * scale * active(i);
        A(i)               = saddle ? scale * active(i) : 0.;
        I(i)               = saddle ? scale * (active(i) > 0 ? compliance : 1.) : 0.;
      }
    for (LA::Vector *v : {&D, &A, &I})
      v->compress(VectorOperation::insert);
  }



  LA::BlockVector
  ContactSystem::zero() const
  {
    const MPI_Comm comm = K.get_mpi_communicator();
    return LA::BlockVector({K.locally_owned_range_indices(),
                            saddle ? contact.weight.locally_owned_elements() : IndexSet(0)},
                           comm);
  }



  void
  ContactSystem::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    contact_terms(dst, src);
    LA::Vector &force = workspace;
    force.reinit(src.block(0), true);
    K.vmult(force, src.block(0));
    dst.block(0) += force;
  }



  void
  ContactSystem::contact_terms(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    if (contact.empty())
      return;
    LA::Vector gap = contact.zero();
    contact.B_free.vmult(gap, src.block(0));
    if (saddle)
      {
        dst.block(1) = gap;
        dst.block(1).scale(A);
        dst.block(1) *= -1;
        gap = src.block(1);
        gap.scale(I);
        dst.block(1) -= gap;
        gap = src.block(1);
        gap.scale(A);
        gap *= -1;
      }
    else
      gap.scale(D);
    contact.B_free.Tvmult(dst.block(0), gap);
  }
} // namespace Signorini
