// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/generators/file.h"
#include <signorini/parameters/section.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "source_directory.h"

/// What the tests of meshes share.
namespace MeshTests
{
  using namespace dealii;
  using namespace Signorini;

  using Keys = std::vector<std::pair<std::string, std::string>>;

  template <int dim>
  std::unique_ptr<MeshGenerator<dim>>
  generator(const std::string &name, const Keys &keys, const std::string &folder = "")
  {
    RawSection raw;
    for (const auto &[key, value] : keys)
      raw.set_value(key, value, "test");
    Section section(raw);
    auto    result = MeshGenerator<dim>::create(name);
    result->declare(section);
    section.close();
    result->read_file(folder, "the test");
    return result;
  }



  template <int dim>
  void
  create(Triangulation<dim> &triangulation, const CoarseMesh<dim> &mesh)
  {
    triangulation.create_triangulation(mesh.vertices, mesh.cells, mesh.faces);
    for (const auto &[id, manifold] : mesh.manifolds)
      triangulation.set_manifold(id, *manifold);
  }



  template <int dim>
  double
  volume(const Triangulation<dim> &triangulation)
  {
    const MappingQ<dim>   mapping(2);
    const FE_Nothing<dim> fe;
    FEValues<dim>         values(mapping, fe, QGauss<dim>(4), update_JxW_values);
    double                sum = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        values.reinit(cell);
        for (const unsigned int q : values.quadrature_point_indices())
          sum += values.JxW(q);
      }
    return sum;
  }



  /// A file that vanishes.
  struct TemporaryFile
  {
    TemporaryFile(const std::string &text, const std::string &extension = ".msh")
      : path((std::filesystem::temp_directory_path() /
              ("signorini-" + std::to_string(getpid()) + extension))
               .string())
    {
      std::ofstream(path, std::ios::binary) << text;
    }

    ~TemporaryFile()
    {
      std::filesystem::remove(path);
    }

    const std::string path;
  };



  inline std::string
  message_of(const std::function<void()> &action)
  {
    try
      {
        action();
      }
    catch (const SceneError &error)
      {
        return error.what();
      }
    return "";
  }



  inline bool
  says(const std::string &message, const std::string &words)
  {
    CAPTURE(message);
    const bool found = message.find(words) != std::string::npos;
    CHECK(found);
    return found;
  }



  inline std::string
  stored_mesh(const std::string &name)
  {
    return source_directory() + "/meshes/" + name;
  }

  /// Of those that are for tests alone.
  inline std::string
  test_mesh(const std::string &name)
  {
    return source_directory() + "/tests/meshes/" + name;
  }
} // namespace MeshTests
