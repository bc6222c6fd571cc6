// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shapes.h"
#include "contact/obstacles/triangle_surface.h"
#include "mesh/generators/file.h"
#include "mesh_import/formats/keyword_file.h"
#include "mesh_import/mesh_file.h"
#include <signorini/parameters/section.h>

#include <filesystem>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A surface of triangles from an STL file, or of surface elements of a mesh file, scaled and
    /// translated.
    template <int dim>
    class Stl : public ObstacleShape<dim>
    {
    public:
      void
      declare(Section &section) override
      {
        section.add("File",
                    file,
                    "STL file, text or binary, or mesh file (" + mesh_formats() +
                      ") with surface elements, beside the scene; those of second order become "
                      "facets through their mid-side nodes; 3D only");
        section.add(
          "Surface",
          set_name,
          "set of surface elements of a mesh file; empty: all; outside is where corners go "
          "around anticlockwise");
        section.add("Scale", scale, "factor of the file's coordinates", positive);
        section.add("Offset", offset, "translation after scaling [length]");
        if (!section.reading())
          return;
        if (dim == 2)
          section.fail("Shape", "a surface of triangles needs Dimension = 3");
        if (file.empty())
          section.fail("File", "is required for Shape = STL");
        place = section.source_of("File");
      }

      void
      read_file(const std::string &folder) override
      {
        try
          {
            // The path of the scene is kept in absolute form where the file exists, so that the
            // scene can be written to another folder.
            const std::string path = find_beside_scene(file, folder);
            if (file_exists(path))
              file = std::filesystem::absolute(path).lexically_normal(); // for the written scene
            const bool is_stl =
              upper_case(std::filesystem::path(path).extension().string()) == ".STL";
            if (is_stl && !set_name.empty())
              throw SceneError("STL files have no sets; remove Surface");
            Triangles triangles = is_stl ? read_stl(path) : read_mesh_surface(path, set_name);
            for (auto &vertex : triangles.vertices)
              for (unsigned int d = 0; d < dim; ++d)
                vertex[d] = scale * vertex[d] + offset[d];
            surface = surface_of(triangles, path);
          }
        catch (const SceneError &error)
          {
            throw SceneError(place + ": " + error.what());
          }
      }

      // In the plane declare() has refused the shape already.
      ObstaclePoint<dim>
      closest(const Point<dim> &x) const override
      {
        if constexpr (dim == 3)
          return surface->closest(x);
        (void)x;
        AssertThrow(false, ExcNotImplemented());
      }

    private:
      static std::shared_ptr<const TriangleSurface>
      surface_of(const Triangles &triangles, const std::string &path)
      {
        try
          {
            return std::make_shared<TriangleSurface>(triangles);
          }
        catch (const SceneError &error)
          {
            throw SceneError("surface file '" + path + "' " + error.what());
          }
      }

      std::string                            file, set_name, place; ///< in the scene
      double                                 scale = 1;
      Point<dim>                             offset;
      std::shared_ptr<const TriangleSurface> surface;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_stl()
  {
    return std::make_unique<Stl<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_stl();
  template std::unique_ptr<ObstacleShape<3>>
  make_stl();
} // namespace Signorini
