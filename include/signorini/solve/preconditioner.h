#pragma once

#include <signorini/solve/contact_system.h>
#include <signorini/solve/preconditioners/amg.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /// A preconditioner of the contact system: one file pair under solve/preconditioners and one line
  /// in the registry. Each serves both forms of the system.
  class Preconditioner
  {
  public:
    virtual ~Preconditioner() = default;

    /// The active set has changed.
    virtual void
    update() = 0;

    virtual void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const = 0;

    /// Symmetric and positive definite on saddle point systems too, as MINRES needs it. (On
    /// condensed systems all are.)
    virtual bool
    is_positive_definite() const = 0;

    /// True: one application solves the system.
    virtual bool
    is_exact() const
    {
      return false;
    }

    static std::unique_ptr<Preconditioner>
    create(const std::string   &name,
           const ContactSystem &system,
           const AMG           *amg,
           const std::string   &direct_solver);
  };

  std::vector<std::string>
  preconditioner_names();
} // namespace Signorini
