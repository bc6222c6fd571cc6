#pragma once

#include <signorini/mesh/generator.h>
#include <signorini/mesh/generators/curved_boundary.h>

namespace Signorini
{
  /// Folders in which mesh files are looked for after the current one: main() adds that of the
  /// scene.
  std::vector<std::string> &
  mesh_search_path();

  /// A mesh file of Gmsh with physical names, or one part of it. Boundaries: the physical names of
  /// lines (2D) or surfaces (3D), and `unnamed` for faces without.
  template <int dim>
  class FileMesh : public MeshGenerator<dim>
  {
  public:
    /// While reading, the file must be there, and the names in the section in it.
    void
    declare(Section &section) override;

    std::vector<std::string>
    boundaries() const override;

    CoarseMesh<dim>
    generate() const override;

    bool
    curved() const override
    {
      return !curved_boundaries.empty();
    }

  private:
    void
    check(const Section &section);

    std::string file, part, curved_text;

    std::string                      path; ///< where the file was found
    std::vector<CurvedBoundary<dim>> curved_boundaries;
  };
} // namespace Signorini
