// SPDX-License-Identifier: Apache-2.0
#include "solver/newton_report.h"

#include <iomanip>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  StepVisitor
  print_steps(ConditionalOStream &out)
  {
    out << "    step   active  changes    residual         gap  damping  iterations" << std::endl;
    return [&out, number = 0u](const NewtonStep &step) mutable {
      if (step.fell_back_to_direct)
        out << "    the iterative solver does not converge: a direct solver is used from here on"
            << std::endl;
      std::ostringstream row;
      row << std::setw(8) << number++ << std::setw(9) << step.active << std::setw(9) << step.changes
          << std::scientific << std::setprecision(2) << std::setw(12) << step.residual
          << std::setw(12) << step.gap_residual << std::fixed << std::setw(9) << step.damping
          << std::setw(12) << step.krylov_iterations;
      out << row.str() << std::endl;
    };
  }
} // namespace Signorini
