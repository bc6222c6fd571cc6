#include <signorini/contact/law/contact_law.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  ContactLaw::ContactLaw(const GapOperator &contact,
                         const Predictor    predictor,
                         const bool         mixed,
                         const double       spring)
    : contact(contact)
    , predictor(predictor)
    , mixed(mixed && !contact.empty())
    , spring(spring)
    , last(contact.zero())
  {}



  ContactLaw::ContactLaw(const ContactMethod &method, const GapOperator &contact)
    : ContactLaw(contact, method.predictor(), method.has_multipliers(), -1)
  {}



  ContactLaw
  ContactLaw::springs(const GapOperator &contact, const double factor)
  {
    return {contact, Predictor::none, false, factor};
  }



  void
  ContactLaw::augment(const LA::Vector &pressure)
  {
    last = pressure;
  }



  double
  ContactLaw::softest() const
  {
    if (contact.empty() || mixed || predictor == Predictor::normal_stress)
      return 1;
    double stiffest = 1;
    for (const auto i : contact.epsilon.locally_owned_elements())
      stiffest = std::max(stiffest, contact.epsilon(i) / contact.stiffness(i));
    return 1 / Utilities::MPI::max(stiffest, contact.epsilon.get_mpi_communicator());
  }



  double
  ContactLaw::trial(const Index i, const LawInput &in) const
  {
    const double predicted = predictor == Predictor::multiplier    ? in.pressure :
                             predictor == Predictor::normal_stress ? in.stress :
                             predictor == Predictor::last_pressure ? last(i) :
                                                                     0.;
    return predicted - epsilon(i) * in.gap;
  }



  LawResponse
  ContactLaw::response(const Index i, const LawInput &in, const bool active) const
  {
    LawResponse result;
    if (!active)
      return result;
    result.defect = in.gap;
    if (!mixed)
      {
        result.pressure = trial(i, in);
        result.dp_dg    = -epsilon(i);
        result.dp_ds    = predictor == Predictor::normal_stress ? 1. : 0.;
        return result;
      }
    result.pressure = in.pressure;
    if (predictor == Predictor::none)
      result.d_defect_d_p = 1 / epsilon(i);
    result.defect += result.d_defect_d_p * in.pressure;
    return result;
  }



  LA::Vector
  ContactLaw::trial(const LawInputs &in) const
  {
    LA::Vector result = contact.zero();
    for (const auto i : result.locally_owned_elements())
      result(i) = trial(i, in(i));
    result.compress(VectorOperation::insert);
    return result;
  }



  LA::Vector
  ContactLaw::trial_from_pressure(const LawInputs &in) const
  {
    if (predictor == Predictor::multiplier || predictor == Predictor::normal_stress)
      return trial(in);
    LA::Vector result = contact.zero();
    for (const auto i : result.locally_owned_elements())
      {
        const LawInput at         = in(i);
        const double   compliance = predictor == Predictor::none ? 1 / epsilon(i) : 0;
        const double   c          = std::min(epsilon(i), contact.stiffness(i));
        result(i)                 = at.pressure - c * (at.gap + compliance * at.pressure);
      }
    result.compress(VectorOperation::insert);
    return result;
  }



  LA::Vector
  ContactLaw::pushes(const LA::Vector &trial) const
  {
    LA::Vector result = contact.zero();
    for (const auto i : result.locally_owned_elements())
      result(i) = pushes(i, trial(i)) ? 1. : 0.;
    result.compress(VectorOperation::insert);
    return result;
  }



  LA::Vector
  ContactLaw::pressure(const LawInputs &in, const LA::Vector &active) const
  {
    LA::Vector result = contact.zero();
    for (const auto i : result.locally_owned_elements())
      result(i) = response(i, in(i), active(i) > 0).pressure;
    result.compress(VectorOperation::insert);
    return result;
  }



  LA::Vector
  ContactLaw::defect(const LawInputs &in, const LA::Vector &active) const
  {
    LA::Vector result = contact.zero();
    for (const auto i : result.locally_owned_elements())
      result(i) = contact.weight(i) * (augments() ? epsilon(i) : contact.stiffness(i)) *
                  response(i, in(i), active(i) > 0).defect;
    result.compress(VectorOperation::insert);
    return result;
  }
} // namespace Signorini
