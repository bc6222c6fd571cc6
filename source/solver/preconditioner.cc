// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioner.h"

#include "solver/linear_solver.h"
#include "solver/preconditioners/factorised.h"
#include "solver/preconditioners/interface_multigrid.h"

#include <deal.II/base/exceptions.h>

#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Settings = LinearSolverSettings;
    using Pointer  = std::unique_ptr<Preconditioner>;
    using Maker =
      std::function<Pointer(const Settings &, const ContactSystem &, const Hierarchy *, bool)>;

    Maker
    block(const BlockPreconditioner::Form form)
    {
      return [form](const Settings      &settings,
                    const ContactSystem &system,
                    const Hierarchy     *hierarchy,
                    bool) {
        return std::make_unique<BlockPreconditioner>(form, settings, system, *hierarchy);
      };
    }

    // The registry: one line for each preconditioner.
    const std::vector<std::pair<std::string, Maker>> registry = {
      {"interface multigrid",
       [](const Settings      &settings,
          const ContactSystem &system,
          const Hierarchy     *hierarchy,
          const bool           interface_includes_geometric) -> Pointer {
         return std::make_unique<InterfaceMultigrid>(system,
                                                     *hierarchy,
                                                     settings.direct_solver.value(),
                                                     interface_includes_geometric);
       }},
      {"block diagonal", block(BlockPreconditioner::diagonal)},
      {"block triangular", block(BlockPreconditioner::triangular)},
      {"SIMPLE", block(BlockPreconditioner::simple)},
      {"direct",
       [](const Settings &settings, const ContactSystem &system, const Hierarchy *, bool)
         -> Pointer { return std::make_unique<Direct>(system, settings.direct_solver.value()); }}};
  } // namespace



  std::vector<std::string>
  preconditioner_names()
  {
    std::vector<std::string> names;
    for (const auto &entry : registry)
      names.push_back(entry.first);
    return names;
  }



  std::unique_ptr<Preconditioner>
  Preconditioner::create(const LinearSolverSettings &settings,
                         const ContactSystem        &system,
                         const Hierarchy            *hierarchy,
                         const bool                  interface_includes_geometric)
  {
    for (const auto &[known, make] : registry)
      if (known == settings.preconditioner)
        return make(settings, system, hierarchy, interface_includes_geometric);
    AssertThrow(false, ExcMessage("unknown preconditioner " + settings.preconditioner));
    return nullptr;
  }
} // namespace Signorini
