#pragma once

#include <string>

namespace Signorini
{
  class Section;

  struct LinearSolverSettings
  {
    std::string  preconditioner     = "contact filter";
    std::string  krylov             = "auto";
    std::string  schur_complement   = "zone";
    double       augmentation       = 0;
    std::string  direct_solver      = "auto";
    std::string  near_null_space    = "rigid body modes";
    unsigned int maximum_iterations = 1000;

    void
    declare(Section &section);
  };
} // namespace Signorini
