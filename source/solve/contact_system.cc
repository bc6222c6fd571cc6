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
    , factor(0)
    , compliant(method.predictor() == Predictor::none)
    , D(contact.zero())
    , X(contact.zero())
    , Y(contact.zero())
    , A(contact.zero())
    , I(contact.zero())
  {}



  ContactSystem::ContactSystem(const LA::SparseMatrix &stiffness,
                               const GapOperator      &contact,
                               const double            factor)
    : K(stiffness)
    , contact(contact)
    , saddle(false)
    , factor(factor)
    , compliant(false)
    , D(contact.zero())
    , X(contact.zero())
    , Y(contact.zero())
    , A(contact.zero())
    , I(contact.zero())
  {}



  void
  ContactSystem::set_active(const LA::Vector &active, const double softness)
  {
    for (const auto i : active.locally_owned_elements())
      {
        const bool   touches = active(i) > 0;
        const double W = contact.weight(i), k = contact.stiffness(i), epsilon = contact.epsilon(i);
        D(i) = saddle || !touches ? 0. : factor > 0 ? factor * k * W : softness * epsilon * W;
        X(i) = contact.has_stress() && touches ? W : 0.;
        Y(i) = contact.has_stress() && !touches ? W / epsilon : 0.;
        A(i) = saddle && touches ? k * W : 0.;
        I(i) = !saddle ? 0. : !touches ? k * W : compliant ? k * k / epsilon * W : 0.;
      }
    for (LA::Vector *v : {&D, &X, &Y, &A, &I})
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
    LA::Vector gap = contact.zero(), stress;
    contact.B_free.vmult(gap, src.block(0));
    if (contact.has_stress())
      {
        stress = contact.zero();
        contact.S_free.vmult(stress, src.block(0));
        add_stress_terms(dst.block(0), gap, stress);
        gap.scale(D);
        stress.scale(X);
        gap -= stress;
      }
    else if (saddle)
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
    contact.B_free.Tvmult_add(dst.block(0), gap);
  }



  void
  ContactSystem::add_stress_terms(LA::Vector       &dst,
                                  const LA::Vector &gap,
                                  const LA::Vector &stress) const
  {
    if (contact.theta == 0)
      return;
    LA::Vector terms = stress, of_gap = gap;
    terms.scale(Y);
    of_gap.scale(X);
    terms += of_gap;
    terms *= -contact.theta;
    contact.S_free.Tvmult_add(dst, terms);
  }
} // namespace Signorini
