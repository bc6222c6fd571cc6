#include <signorini/contact/law/contact_law.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    LawVector
    of_all_components(const double value)
    {
      LawVector values;
      for (unsigned int a = 0; a < 3; ++a)
        values[a] = value;
      return values;
    }
  } // namespace



  LawInput
  LawInputs::at(const types::global_dof_index first, const unsigned int n) const
  {
    LawInput in;
    for (unsigned int a = 0; a < n; ++a)
      {
        in.gap[a]      = gap(first + a);
        in.stress[a]   = stress(first + a);
        in.pressure[a] = pressure(first + a);
      }
    return in;
  }



  template <typename F>
  LA::Vector
  ContactLaw::at_all_points(const F &f) const
  {
    const unsigned int n      = n_components();
    LA::Vector         result = contact.zero();
    const IndexSet     rows   = result.locally_owned_elements();
    for (auto i = rows.begin(); i != rows.end();)
      {
        const LawVector values = f(*i);
        for (unsigned int a = 0; a < n; ++a)
          result(*i++) = values[a];
      }
    result.compress(VectorOperation::insert);
    return result;
  }



  LA::Vector
  ContactLaw::trial(const LawInputs &in) const
  {
    return at_all_points(
      [&](const Index i) { return of_all_components(trial(i, in.at(i, n_components()))); });
  }



  LA::Vector
  ContactLaw::pushes(const LA::Vector &trial) const
  {
    return at_all_points(
      [&](const Index i) { return of_all_components(pushes(i, trial(i)) ? 1. : 0.); });
  }



  LA::Vector
  ContactLaw::pressure(const LawInputs &in, const LA::Vector &active) const
  {
    return at_all_points(
      [&](const Index i) { return response(i, in.at(i, n_components()), active(i) > 0).pressure; });
  }



  LA::Vector
  ContactLaw::defect(const LawInputs &in, const LA::Vector &active) const
  {
    return at_all_points([&](const Index i) {
      return contact.weight(i) * defect_stiffness(i) *
             response(i, in.at(i, n_components()), active(i) > 0).defect;
    });
  }
} // namespace Signorini
