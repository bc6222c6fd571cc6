// SPDX-License-Identifier: Apache-2.0
#include "contact/laws/normal_contact.h"
#include "contact/methods/augmented_lagrangian.h"
#include "contact/methods/direct_elimination.h"
#include "contact/methods/lagrange_multiplier.h"
#include "contact/methods/nitsche.h"
#include "contact/methods/penalty.h"
#include "contact/methods/perturbed_lagrangian.h"
#include <signorini/contact/methods/method.h>

#include <deal.II/base/exceptions.h>

#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Maker = std::function<std::shared_ptr<ContactMethod>()>;

    // The registry: one line for each method.
    const std::vector<std::pair<std::string, Maker>> registry = {
      {"penalty", [] { return std::make_shared<Penalty>(); }},
      {"augmented Lagrangian", [] { return std::make_shared<AugmentedLagrangian>(); }},
      {"perturbed Lagrangian", [] { return std::make_shared<PerturbedLagrangian>(); }},
      {"Lagrange multiplier", [] { return std::make_shared<LagrangeMultiplier>(); }},
      {"direct elimination", [] { return std::make_shared<DirectElimination>(); }},
      {"Nitsche", [] { return std::make_shared<Nitsche>(); }}};
  } // namespace



  const std::vector<std::string> &
  method_names()
  {
    static const std::vector<std::string> names = [] {
      std::vector<std::string> list;
      for (const auto &entry : registry)
        list.push_back(entry.first);
      return list;
    }();
    return names;
  }



  std::unique_ptr<ContactLaw>
  ContactMethod::make_law(const GapOperator &contact) const
  {
    return std::make_unique<NormalContact>(*this, contact);
  }



  std::shared_ptr<ContactMethod>
  ContactMethod::create(const std::string &name)
  {
    for (const auto &[known, make] : registry)
      if (known == name)
        return make();
    AssertThrow(false, ExcMessage("unknown contact method " + name));
    return nullptr;
  }
} // namespace Signorini
