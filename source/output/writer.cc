#include <signorini/output/contact_vtu.h>
#include <signorini/output/profiles.h>
#include <signorini/output/vtu.h>
#include <signorini/output/writer.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Writer<dim>::Writer(const OutputSettings<dim> &settings,
                      const std::string         &directory,
                      const MPI_Comm             comm)
    : settings(settings)
    , directory(directory)
    , bodies(directory + "/solution.pvd", comm)
    , contact(directory + "/contact.pvd", comm)
  {}



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
