#include <signorini/mesh/generators/file.h>
#include <signorini/mesh/generators/gmsh_part.h>
#include <signorini/parameters/section.h>

#include <algorithm>
#include <filesystem>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const char *const unnamed = "unnamed";

    std::vector<std::string>
    names_of(const std::map<int, std::string> &group)
    {
      std::vector<std::string> names;
      for (const auto &[tag, name] : group)
        if (std::find(names.begin(), names.end(), name) == names.end())
          names.push_back(name);
      return names;
    }



    bool
    is_in(const std::string &name, const std::vector<std::string> &names)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }



    std::string
    found(const std::string &file)
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
  } // namespace



  std::vector<std::string> &
  mesh_search_path()
  {
    static std::vector<std::string> path;
    return path;
  }



  template <int dim>
  void
  FileMesh<dim>::declare(Section &section)
  {
    section.add("File",
                file,
                "mesh file of Gmsh (4.1 or 2.2, text) with physical names, beside the scene");
    section.add("Part",
                part,
                dim == 2 ? "physical surface that is the body; empty: all cells" :
                           "physical volume that is the body; empty: all cells");
    section.add("Curved boundaries",
                curved_text,
                dim == 2 ?
                  "boundaries on circles, separated by ;   NAME circle cx cy" :
                  "boundaries on spheres (center) or cylinders (point and direction of the axis), "
                  "separated by ;   NAME sphere cx cy cz   NAME cylinder px py pz ax ay az");
    if (section.reading())
      check(section);
  }



  template <int dim>
  void
  FileMesh<dim>::check(const Section &section)
  {
    std::string key = "File";
    try
      {
        if (file.empty())
          throw SceneError("a mesh from a file needs its name");
        path                                  = found(file);
        const GmshFile::Groups         groups = read_gmsh_groups(path);
        const std::vector<std::string> parts  = names_of(groups[dim]);

        key = "Part";
        if (!part.empty() && !is_in(part, parts))
          throw SceneError("mesh file '" + path + "' has no such part; it has " +
                           (parts.empty() ? "none" : join(parts)));

        key               = "Curved boundaries";
        curved_boundaries = curved_boundaries_from<dim>(curved_text);
        for (const auto &boundary : curved_boundaries)
          if (!is_in(boundary.name, boundaries()))
            throw SceneError("mesh file '" + path + "' has no boundary '" + boundary.name +
                             "'; it has " + join(boundaries()));
      }
    catch (const SceneError &error)
      {
        section.fail(key, error.what());
      }
  }



  template <int dim>
  std::vector<std::string>
  FileMesh<dim>::boundaries() const
  {
    std::vector<std::string> names = names_of(read_gmsh_groups(path)[dim - 1]);
    if (!is_in(unnamed, names))
      names.push_back(unnamed);
    return names;
  }



  template <int dim>
  CoarseMesh<dim>
  FileMesh<dim>::generate() const
  {
    const std::vector<std::string> names = boundaries();
    const auto                     id_of = [&](const std::string &name) -> types::boundary_id {
      return std::find(names.begin(), names.end(), name) - names.begin();
    };
    const GmshFile contents = read_gmsh(path);
    try
      {
        const GmshPart<dim> mesh(contents, part, names, id_of(unnamed));
        Triangulation<dim>  triangulation;
        triangulation.create_triangulation(mesh.vertices, mesh.cells, mesh.faces);
        for (unsigned int i = 0; i < curved_boundaries.size(); ++i)
          curved_boundaries[i].apply(triangulation, id_of(curved_boundaries[i].name), i);
        return CoarseMesh<dim>::from_triangulation(triangulation, names);
      }
    catch (const SceneError &error)
      {
        throw SceneError("mesh file '" + path + "' " + error.what());
      }
  }



  template class FileMesh<2>;
  template class FileMesh<3>;
} // namespace Signorini
