// SPDX-License-Identifier: Apache-2.0
#include "contact/laws/coulomb_friction.h"
#include "contact/methods/methods.h"

#include <deal.II/base/exceptions.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Maker = std::shared_ptr<ContactMethod> (*)();

    // The registry: one line a method.
    const std::vector<std::pair<std::string, Maker>> registry = {
      {"penalty", make_penalty},
      {"augmented Lagrangian", make_augmented_lagrangian},
      {"perturbed Lagrangian", make_perturbed_lagrangian},
      {"Lagrange multiplier", make_lagrange_multiplier},
      {"direct elimination", make_direct_elimination},
      {"Nitsche", make_nitsche}};
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
    if (uses_slip())
      return std::make_unique<CoulombFriction>(*this, contact);
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
