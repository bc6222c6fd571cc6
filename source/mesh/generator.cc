// SPDX-License-Identifier: Apache-2.0
#include "mesh/generators/file.h"
#include "mesh/generators/generators.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Maker = std::unique_ptr<MeshGenerator<dim>> (*)();

    template <int dim>
    std::unique_ptr<MeshGenerator<dim>>
    make_file()
    {
      return std::make_unique<FileMesh<dim>>();
    }

    template <int dim>
    using Registry = std::vector<std::pair<std::string, Maker<dim>>>;

    template <int dim>
    Registry<dim>
    registry();

    template <>
    Registry<2>
    registry<2>()
    {
      return {{"box", make_box<2>},
              {"disc", make_disc},
              {"ring", make_ring<2>},
              {"file", make_file<2>}};
    }

    template <>
    Registry<3>
    registry<3>()
    {
      return {{"box", make_box<3>},
              {"ring", make_ring<3>},
              {"sphere", make_sphere},
              {"shell", make_shell},
              {"file", make_file<3>}};
    }
  } // namespace



  template <int dim>
  const std::vector<double> &
  MeshGenerator<dim>::temperature() const
  {
    static const std::vector<double> none;
    return none;
  }



  template <int dim>
  std::vector<std::string>
  generator_names()
  {
    std::vector<std::string> names;
    for (const auto &entry : registry<dim>())
      names.push_back(entry.first);
    return names;
  }



  template <int dim>
  std::unique_ptr<MeshGenerator<dim>>
  MeshGenerator<dim>::create(const std::string &name)
  {
    for (const auto &[known, maker] : registry<dim>())
      if (known == name)
        return maker();
    throw SceneError("there is no mesh '" + name + "' in " + std::to_string(dim) + "D; there are " +
                     join(generator_names<dim>()));
  }



  template class MeshGenerator<2>;
  template class MeshGenerator<3>;
  template std::vector<std::string>
  generator_names<2>();
  template std::vector<std::string>
  generator_names<3>();
} // namespace Signorini
