// SPDX-License-Identifier: Apache-2.0
#include "output/files.h"

#include <filesystem>

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



  // Bodies, then the contact surfaces and their profiles, if there are any. Collective.
  template <int dim>
  void
  Writer<dim>::write(const Snapshot<dim> &snapshot, const Formula &reference_pressure)
  {
    if (settings.vtu)
      bodies.add(snapshot.time, write_bodies(snapshot, directory, settings.strain));
    if (snapshot.pairs.empty())
      return;
    if (settings.vtu)
      contact.add(snapshot.time, write_contact(snapshot, directory));
    write_profiles(snapshot, directory + "/profiles", reference_pressure);
  }



  template <int dim>
  void
  Writer<dim>::write_failure(const Snapshot<dim> &snapshot)
  {
    if (settings.vtu && !snapshot.pairs.empty())
      write_contact(snapshot, directory, "failed");
  }



  // Records of the steps before the restart are taken over if their files exist.
  template <int dim>
  void
  Writer<dim>::restore(const std::vector<std::pair<double, unsigned int>> &times)
  {
    const auto files = [&](const std::string &name) {
      std::vector<std::pair<double, std::string>> result;
      for (const auto &[time, step] : times)
        if (const std::string file = name + "_" + Utilities::int_to_string(step, 4) + ".pvtu";
            std::filesystem::exists(directory + "/" + file)) // not if Output/VTU is new
          result.emplace_back(time, file);
      return result;
    };
    bodies.restore(files("solution"));
    contact.restore(files("contact"));
  }



  template class Writer<2>;
  template class Writer<3>;
} // namespace Signorini
