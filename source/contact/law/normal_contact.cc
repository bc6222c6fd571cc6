#include <signorini/contact/law/normal_contact.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  NormalContact::NormalContact(const GapOperator &contact,
                               const Predictor    predictor,
                               const bool         mixed,
                               const double       spring)
    : ContactLaw(contact)
    , predictor(predictor)
    , mixed(mixed && !contact.empty())
    , spring(spring)
    , last(contact.zero())
  {}



  NormalContact::NormalContact(const ContactMethod &method, const GapOperator &contact)
    : NormalContact(contact, method.predictor(), method.has_multipliers(), -1)
  {}



  NormalContact
  NormalContact::springs(const GapOperator &contact, const double factor)
  {
    return {contact, Predictor::none, false, factor};
  }



  double
  NormalContact::softest() const
  {
    if (contact.empty() || mixed || predictor == Predictor::normal_stress)
      return 1;
    const auto &[permanent, stiffness, epsilon] = contact.coefficients;
    double stiffest                             = 1;
    for (const auto i : epsilon.locally_owned_elements())
      stiffest = std::max(stiffest, epsilon(i) / stiffness(i));
    return 1 / Utilities::MPI::max(stiffest, epsilon.get_mpi_communicator());
  }



  double
  NormalContact::trial(const Index i, const LawInput &in) const
  {
    const double predicted = predictor == Predictor::multiplier    ? in.pressure[0] :
                             predictor == Predictor::normal_stress ? in.stress[0] :
                             predictor == Predictor::last_pressure ? last(i) :
                                                                     0.;
    return predicted - epsilon(i) * in.gap[0];
  }



  LawResponse
  NormalContact::response(const Index i, const LawInput &in, const bool active) const
  {
    LawResponse result;
    if (!active)
      return result;
    result.defect[0] = in.gap[0];
    if (!mixed)
      {
        result.pressure[0] = trial(i, in);
        result.dp_dg[0][0] = -epsilon(i);
        result.dp_ds[0][0] = predictor == Predictor::normal_stress ? 1. : 0.;
        return result;
      }
    result.pressure[0] = in.pressure[0];
    if (predictor == Predictor::none)
      result.compliance[0] = 1 / epsilon(i);
    result.defect[0] += result.compliance[0] * in.pressure[0];
    return result;
  }



  LA::Vector
  NormalContact::trial_from_pressure(const LawInputs &in) const
  {
    if (predictor == Predictor::multiplier || predictor == Predictor::normal_stress)
      return trial(in);
    LA::Vector result = contact.zero();
    for (const auto i : result.locally_owned_elements())
      {
        const double compliance = predictor == Predictor::none ? 1 / epsilon(i) : 0;
        const double c          = std::min(epsilon(i), contact.coefficients.stiffness(i));
        const double p          = in.pressure(i);
        result(i)               = p - c * (in.gap(i) + compliance * p);
      }
    result.compress(VectorOperation::insert);
    return result;
  }
} // namespace Signorini
