// SPDX-License-Identifier: Apache-2.0
#include "contact/laws/contact_law.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  // Values of one point, from one vector for each component. Tangential components of internal
  // vectors follow the normal one, which is zero.
  LawInput
  LawInputs::at(const types::global_dof_index point) const
  {
    const auto read = [&](const PointVectors &from, auto &to) {
      for (unsigned int a = 0; a < from.size(); ++a)
        to[a] = from[a](point);
    };
    LawInput in;
    read(gap, in.gap);
    read(stress, in.stress);
    read(traction, in.traction);
    in.internal.vectors.resize(internal.vectors.size());
    for (unsigned int k = 0; k < internal.vectors.size(); ++k)
      for (unsigned int a = 0; a < internal.vectors[k].size(); ++a)
        in.internal.vectors[k][a + 1] = internal.vectors[k][a](point);
    in.internal.scalars.resize(internal.scalars.size());
    read(internal.scalars, in.internal.scalars);
    return in;
  }



  PointVectors
  ContactLaw::trial(const LawInputs &in) const
  {
    return at_all_points([&](const Index i) { return trial(i, in.at(i)); });
  }



  // The status that the law would choose at each point, by its trial traction.
  LA::Vector
  ContactLaw::status(const PointVectors &trial) const
  {
    LA::Vector result = contact.zero();
    for (const auto i : result.locally_owned_elements())
      {
        LawVector at;
        for (unsigned int a = 0; a < trial.size(); ++a)
          at[a] = trial[a](i);
        result(i) = static_cast<double>(status(i, at));
      }
    result.compress(VectorOperation::insert);
    return result;
  }



  // The response is evaluated with the status that the active-set strategy has chosen, not with
  // that of the trial.
  PointVectors
  ContactLaw::traction(const LawInputs &in, const LA::Vector &status) const
  {
    return at_all_points(
      [&](const Index i) { return response(i, in.at(i), status_of(status(i))).traction; });
  }



  // r_q = k W d of doc/theory, (4.2).
  PointVectors
  ContactLaw::residual(const LawInputs &in, const LA::Vector &status) const
  {
    return at_all_points([&](const Index i) {
      return contact.weight(i) * residual_stiffness(i) *
             response(i, in.at(i), status_of(status(i))).residual;
    });
  }



  InternalFields
  ContactLaw::initial_fields() const
  {
    const InternalVariables at_point = initial_variables();
    InternalFields          result;
    result.vectors.assign(at_point.vectors.size(),
                          PointVectors(n_components() - 1, contact.zero()));
    result.scalars.assign(at_point.scalars.size(), contact.zero());
    return result;
  }



  // Internal variables at the end of the step, with the tangential components of vectors only.
  InternalFields
  ContactLaw::internal(const LawInputs &in, const LA::Vector &status) const
  {
    InternalFields result = initial_fields();
    if (result.empty())
      return result;
    for (const auto i : status.locally_owned_elements())
      {
        const InternalVariables now = response(i, in.at(i), status_of(status(i))).internal;
        for (unsigned int k = 0; k < now.vectors.size(); ++k)
          for (unsigned int a = 0; a < result.vectors[k].size(); ++a)
            result.vectors[k][a](i) = now.vectors[k][a + 1];
        for (unsigned int k = 0; k < now.scalars.size(); ++k)
          result.scalars[k](i) = now.scalars[k];
      }
    result.compress();
    return result;
  }
} // namespace Signorini
