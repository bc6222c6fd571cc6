// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioner.h"

#include "solver/linear_solver.h"
#include "solver/preconditioners/factorised.h"
#include "solver/preconditioners/interface_multigrid.h"
#include <signorini/base/scene_error.h>

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

    struct Entry
    {
      std::string          name; ///< of the key Solver/Preconditioner
      PreconditionerTraits traits;
      Maker                make;
    };

    Pointer
    make_interface_multigrid(const Settings      &settings,
                             const ContactSystem &system,
                             const Hierarchy     *hierarchy,
                             const bool           interface_includes_geometric)
    {
      return std::make_unique<InterfaceMultigrid>(system,
                                                  *hierarchy,
                                                  settings.direct_solver.value(),
                                                  interface_includes_geometric);
    }

    Pointer
    make_direct(const Settings &settings, const ContactSystem &system, const Hierarchy *, bool)
    {
      return std::make_unique<Direct>(system, settings.direct_solver.value());
    }

    // The registry: one line for each preconditioner. Traits: needs_matrix, uses_hierarchy,
    // factorises, solves_interface, admits_augmentation.
    const std::vector<Entry> registry = {
      {"interface multigrid", {false, true, false, true, true}, make_interface_multigrid},
      {"block diagonal", {true, true, false, false, true}, block(BlockPreconditioner::diagonal)},
      {"block triangular",
       {true, true, false, false, true},
       block(BlockPreconditioner::triangular)},
      // It uses the diagonal of the stiffness, without augmentation.
      {"SIMPLE", {true, true, false, false, false}, block(BlockPreconditioner::simple)},
      {"direct", {true, false, true, false, true}, make_direct}};

    const Entry &
    entry(const std::string &name)
    {
      for (const Entry &one : registry)
        if (one.name == name)
          return one;
      throw SceneError("Solver/Preconditioner = " + name + ": there is no such preconditioner");
    }
  } // namespace



  std::vector<std::string>
  preconditioner_names()
  {
    std::vector<std::string> names;
    for (const Entry &one : registry)
      names.push_back(one.name);
    return names;
  }



  const PreconditionerTraits &
  LinearSolverSettings::traits() const
  {
    return entry(preconditioner).traits;
  }



  std::unique_ptr<Preconditioner>
  Preconditioner::create(const LinearSolverSettings &settings,
                         const ContactSystem        &system,
                         const Hierarchy            *hierarchy,
                         const bool                  interface_includes_geometric)
  {
    return entry(settings.preconditioner)
      .make(settings, system, hierarchy, interface_includes_geometric);
  }
} // namespace Signorini
