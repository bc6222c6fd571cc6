#include <signorini/output/contact_vtu.h>
#include <signorini/output/profiles.h>
#include <signorini/output/vtu.h>
#include <signorini/output/writer.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/mpi.h>

#include <filesystem>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Rank 0 creates it; all ranks learn whether that worked and go on only then.
    void
    create_directory(const std::string &directory, const MPI_Comm comm)
    {
      std::string problem;
      if (Utilities::MPI::this_mpi_process(comm) == 0)
        {
          std::error_code error;
          std::filesystem::create_directories(directory, error);
          if (error)
            problem = error.message();
        }
      problem = Utilities::MPI::broadcast(comm, problem);
      if (!problem.empty())
        throw SceneError("the output directory '" + directory + "' cannot be created: " + problem);
    }
  } // namespace



  template <int dim>
  Writer<dim>::Writer(const OutputSettings<dim> &settings,
                      const std::string         &directory,
                      const MPI_Comm             comm)
    : settings(settings)
    , directory(directory)
    , bodies(directory + "/solution.pvd", comm)
    , contact(directory + "/contact.pvd", comm)
  {
    create_directory(directory, comm);
    create_directory(directory + "/profiles", comm);
  }



  template <int dim>
  void
  Writer<dim>::write(const Snapshot<dim> &snapshot, const Formula &reference_pressure)
  {
    if (settings.vtu)
      bodies.add(snapshot.time, write_bodies(snapshot, directory));
    if (snapshot.pairs.empty())
      return;
    if (settings.vtu)
      contact.add(snapshot.time, write_contact(snapshot, directory));
    write_profiles(snapshot, directory + "/profiles", reference_pressure);
  }



  template class Writer<2>;
  template class Writer<3>;
} // namespace Signorini
