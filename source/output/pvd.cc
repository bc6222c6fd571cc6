// SPDX-License-Identifier: Apache-2.0
#include "output/pvd.h"

#include "base/compatibility.h"
#include "output/directory.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  PvdRecord::PvdRecord(const std::string &path, const MPI_Comm comm)
    : path(path)
    , writes(Utilities::MPI::this_mpi_process(comm) == 0)
  {}



  void
  PvdRecord::add(const double time, const std::string &file)
  {
    steps.erase(std::remove_if(steps.begin(),
                               steps.end(),
                               [&](const auto &step) { return step.second == file; }),
                steps.end());
    steps.emplace_back(time, file);
    if (!writes)
      return;
    std::ostringstream out;
    DataOutBase::write_pvd_record(out, steps);
    replace_file(path, out.str());
  }



  DataOutBase::VtkFlags
  vtk_flags()
  {
    DataOutBase::VtkFlags flags;
    flags.compression_level = Compatibility::compression_best_speed;
    return flags;
  }
} // namespace Signorini
