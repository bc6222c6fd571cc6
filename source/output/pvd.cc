#include <signorini/output/pvd.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

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
    std::ofstream out(path);
    DataOutBase::write_pvd_record(out, steps);
    if (!out.flush())
      throw std::runtime_error("cannot write " + path);
  }



  DataOutBase::VtkFlags
  vtk_flags()
  {
    DataOutBase::VtkFlags flags;
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    return flags;
  }
} // namespace Signorini
