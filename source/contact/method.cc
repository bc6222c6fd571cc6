#include <signorini/contact/method.h>
#include <signorini/contact/methods/augmented_lagrangian.h>
#include <signorini/contact/methods/direct_elimination.h>
#include <signorini/contact/methods/lagrange_multiplier.h>
#include <signorini/contact/methods/nitsche.h>
#include <signorini/contact/methods/penalty.h>
#include <signorini/contact/methods/perturbed_lagrangian.h>

#include <deal.II/base/exceptions.h>

#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Maker = std::function<std::shared_ptr<ContactMethod>()>;

    // The registry: one line a method.
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



  std::shared_ptr<ContactMethod>
  ContactMethod::create(const std::string &name)
  {
    for (const auto &[known, make] : registry)
      if (known == name)
        return make();
    AssertThrow(false, ExcMessage("unknown contact method " + name));
    return nullptr;
  }



  unsigned int
  find_active(const GapOperator &contact,
              const LA::Vector  &gap,
              const LA::Vector  &predicted,
              LA::Vector        &active)
  {
    unsigned int n_active = 0;
    for (const auto i : contact.weight.locally_owned_elements())
      {
        const bool pushes  = predicted(i) - contact.epsilon(i) * gap(i) > 0;
        const bool touches = (pushes || contact.permanent(i) > 0) && contact.weight(i) > 0;
        active(i)          = touches ? 1. : 0.;
        n_active += touches;
      }
    active.compress(VectorOperation::insert);
    return Utilities::MPI::sum(n_active, active.get_mpi_communicator());
  }



  void
  set_pressure(const ContactMethod &method,
               const GapOperator   &contact,
               const LA::Vector    &gap,
               const LA::Vector    &predicted,
               const LA::Vector    &active,
               LA::Vector          &pressure)
  {
    for (const auto i : contact.weight.locally_owned_elements())
      if (!(active(i) > 0))
        pressure(i) = 0;
      else if (!method.has_multipliers())
        pressure(i) = predicted(i) - contact.epsilon(i) * gap(i);
    pressure.compress(VectorOperation::insert);
  }
} // namespace Signorini
