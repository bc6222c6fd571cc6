// SPDX-License-Identifier: Apache-2.0
#include "mesh/generators/box.h"
#include "mesh/generators/disc.h"
#include "mesh/generators/file.h"
#include "mesh/generators/ring.h"
#include "mesh/generators/shell.h"
#include "mesh/generators/sphere.h"
#include <signorini/mesh/generator.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A function that creates a generator.
    template <int dim>
    using Maker = std::unique_ptr<MeshGenerator<dim>> (*)();

    template <int dim, typename Generator>
    std::unique_ptr<MeshGenerator<dim>>
    make()
    {
      return std::make_unique<Generator>();
    }

    template <int dim>
    using Registry = std::vector<std::pair<std::string, Maker<dim>>>;

    /// @return the registry: names of generators with their makers.
    template <int dim>
    Registry<dim>
    registry();

    template <>
    Registry<2>
    registry<2>()
    {
      return {{"box", make<2, BoxMesh<2>>},
              {"disc", make<2, DiscMesh>},
              {"ring", make<2, RingMesh<2>>},
              {"file", make<2, FileMesh<2>>}};
    }

    template <>
    Registry<3>
    registry<3>()
    {
      return {{"box", make<3, BoxMesh<3>>},
              {"ring", make<3, RingMesh<3>>},
              {"sphere", make<3, SphereMesh>},
              {"shell", make<3, ShellMesh>},
              {"file", make<3, FileMesh<3>>}};
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
