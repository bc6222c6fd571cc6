#include <signorini/solve/preconditioner.h>
#include <signorini/solve/preconditioners/block.h>
#include <signorini/solve/preconditioners/contact_filter.h>
#include <signorini/solve/preconditioners/direct.h>

#include <deal.II/base/exceptions.h>

#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Pointer = std::unique_ptr<Preconditioner>;
    using Maker   = std::function<Pointer(const ContactSystem &, const AMG *, const std::string &)>;

    // The registry: one line a preconditioner.
    const std::vector<std::pair<std::string, Maker>> registry = {
      {"contact filter",
       [](const auto &system, const AMG *amg, const auto &direct) -> Pointer {
         return std::make_unique<ContactFilter>(system, *amg, direct);
       }},
      {"block diagonal",
       [](const auto &system, const AMG *amg, const auto &) -> Pointer {
         return std::make_unique<BlockPreconditioner>(system, *amg, false);
       }},
      {"block triangular",
       [](const auto &system, const AMG *amg, const auto &) -> Pointer {
         return std::make_unique<BlockPreconditioner>(system, *amg, true);
       }},
      {"direct", [](const auto &system, const AMG *, const auto &direct) -> Pointer {
         return std::make_unique<Direct>(system, direct);
       }}};
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
  Preconditioner::create(const std::string   &name,
                         const ContactSystem &system,
                         const AMG           *amg,
                         const std::string   &direct_solver)
  {
    for (const auto &[known, make] : registry)
      if (known == name)
        return make(system, amg, direct_solver);
    AssertThrow(false, ExcMessage("unknown preconditioner " + name));
    return nullptr;
  }
} // namespace Signorini
