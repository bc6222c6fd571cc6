#include <signorini/mesh/generators/curved_cells.h>
#include <signorini/mesh/generators/file.h>
#include <signorini/parameters/section.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::vector<CurvedBoundary<dim>>
    read_curved_boundaries(const std::string &text, const Section &section)
    {
      try
        {
          return curved_boundaries_from<dim>(text);
        }
      catch (const SceneError &error)
        {
          section.fail("Curved boundaries", error.what());
        }
    }



    void
    check_groups(const MeshFile &file, const std::vector<std::string> &wanted)
    {
      std::vector<std::string> names;
      for (const auto &group : file.groups)
        names.push_back(group.name);
      for (const std::string &name : wanted)
        if (std::find(names.begin(), names.end(), name) == names.end())
          throw SceneError("has nothing that is called '" + name + "'; it has " +
                           (names.empty() ? "no names" : join(names)));
    }



    /// All ranks read the file, one speaks.
    void
    tell(const std::string &body, const std::string &path, const std::vector<std::string> &notes)
    {
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        for (const std::string &note : notes)
          std::cout << body << ", mesh file '" << path << "': " << note << std::endl;
    }



    bool
    is_in(const std::string &name, const std::vector<std::string> &names)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }
  } // namespace



  std::vector<std::string> &
  mesh_search_path()
  {
    static std::vector<std::string> path;
    return path;
  }



  std::string
  found_beside_scene(const std::string &file)
  {
    if (std::filesystem::exists(file) || std::filesystem::path(file).is_absolute())
      return file;
    for (const std::string &folder : mesh_search_path())
      {
        const auto candidate = std::filesystem::path(folder) / file;
        if (std::filesystem::exists(candidate))
          return candidate.string();
      }
    return file;
  }



  template <int dim>
  void
  FileMesh<dim>::declare(Section &section)
  {
    section.add("File",
                file,
                "mesh file, beside the scene; its extension says the format: " + mesh_formats());
    section.add("Part",
                selection.part,
                std::string("physical ") + (dim == 2 ? "surface" : "volume") +
                  " (Gmsh), element set (Abaqus) or ARRAY VALUE of cell data (VTK) that is the "
                  "body, with nodes of its own; empty: all cells");
    section.add("Boundaries",
                selection.boundaries,
                "names in the file that are boundaries, separated by commas; of several that "
                "contain a face the first wins; empty: all, and none may overlap");
    section.add("Feature angle",
                selection.feature_angle,
                "faces without a name are divided where they meet at more than this angle into "
                "unnamed1, unnamed2, ... by the x, then y, then z of their centers; 0: one "
                "boundary unnamed [degrees]",
                Range{0, 180});
    section.add_choice("Coinciding nodes",
                       selection.coinciding_nodes,
                       {"refuse", "merge", "keep"},
                       "what is done with nodes at one place, where cells are not connected");
    section.add("Node distance",
                selection.node_distance,
                "up to which nodes coincide; 0: 1e-3 of the shortest edge [length]",
                non_negative);
    section.add("Mid-side nodes",
                mid_side_nodes,
                "yes: cells of second order are as curved as their nodes say; no: straight "
                "between the corners");
    section.add("Curved boundaries",
                curved_text,
                dim == 2 ?
                  "boundaries on circles, separated by ;   NAME circle cx cy" :
                  "boundaries on spheres (center) or cylinders (point and direction of the axis), "
                  "separated by ;   NAME sphere cx cy cz   NAME cylinder px py pz ax ay az");
    if (section.reading())
      read(section);
  }



  template <int dim>
  void
  FileMesh<dim>::read(const Section &section)
  {
    if (file.empty())
      section.fail("File", "a mesh from a file needs its name");
    const auto        surfaces = read_curved_boundaries<dim>(curved_text, section);
    const std::string path     = found_beside_scene(file);
    if (std::filesystem::exists(path))
      file = std::filesystem::absolute(path).lexically_normal(); // for the scene that is written
    std::string key = "File";
    try
      {
        const MeshFile all = read_mesh_file(path);

        key                                  = "Part";
        const std::vector<std::string> parts = part_names(all, dim);
        if (!selection.part.empty() && !is_in(selection.part, parts))
          throw SceneError("has no such part; it has " + (parts.empty() ? "none" : join(parts)));

        key = "Boundaries";
        check_groups(all, selection.boundaries);

        key = "File";
        const FilePart<dim> part(all, selection);
        tell(section.path(), path, part.notes);

        key = "Curved boundaries";
        for (const auto &surface : surfaces)
          if (!is_in(surface.name, part.boundaries))
            throw SceneError("has no boundary '" + surface.name + "'; it has " +
                             join(part.boundaries));
        Triangulation<dim> triangulation;
        triangulation.create_triangulation(part.vertices, part.cells, part.faces);
        for (unsigned int i = 0; i < surfaces.size(); ++i)
          {
            const auto &all_names = part.boundaries;
            const auto  at        = std::find(all_names.begin(), all_names.end(), surfaces[i].name);
            surfaces[i].apply(triangulation, at - all_names.begin(), i);
          }

        key = "File";
        const unsigned int n_curved =
          mid_side_nodes ? curve_cells(triangulation, all, part.elements, surfaces.size()) : 0;
        is_curved = n_curved + surfaces.size() > 0;
        mesh      = CoarseMesh<dim>::from_triangulation(triangulation, part.boundaries);
      }
    catch (const SceneError &error)
      {
        // The readers name the file that they read, which may be an included one.
        const std::string what = error.what(), named = "mesh file '";
        const bool        is_it = what.compare(0, named.size(), named) == 0;
        section.fail(key, is_it ? what : named + path + "' " + what);
      }
  }



  template class FileMesh<2>;
  template class FileMesh<3>;
} // namespace Signorini
