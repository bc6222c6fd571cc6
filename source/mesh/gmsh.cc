#include <signorini/mesh/gmsh.h>
#include <signorini/parameters/raw.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <unordered_map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Dimension of an element type of Gmsh, straight or of second order; 4 if unknown.
    unsigned int
    dimension_of(const unsigned int type)
    {
      static const std::array<unsigned int, 20> dimensions{
        {4, 1, 2, 2, 3, 3, 3, 3, 1, 2, 2, 3, 3, 3, 3, 0, 2, 3, 3, 3}};
      return type < dimensions.size() ? dimensions[type] : 4;
    }



    class Reader
    {
    public:
      Reader(const std::string &file_name)
        : file_name(file_name)
        , in(file_name)
      {
        if (!in)
          fail("cannot be opened");
        if (next_section() != "MeshFormat")
          fail("is not a mesh file of Gmsh: it does not begin with $MeshFormat");
        std::string  version;
        unsigned int binary = 0;
        in >> version >> binary;
        if (version != "2.2" && version != "4.1")
          fail("has format " + version + "; save it in 4.1 or 2.2: gmsh -format msh41");
        if (binary)
          fail("is binary; save it as text: Mesh.Binary = 0");
        is_new = version == "4.1";
        leave_section("MeshFormat");
      }

      void
      read_groups()
      {
        for (std::string section = next_section(); !section.empty(); section = next_section())
          if (section == "PhysicalNames")
            return read_names();
          else
            leave_section(section);
        fail("has no physical names; name the parts and the boundaries in Gmsh, for example "
             "Physical Surface(\"top\") = {6};");
      }

      void
      read_the_rest()
      {
        for (std::string section = next_section(); !section.empty(); section = next_section())
          {
            if (section == "PartitionedEntities")
              fail("is partitioned; save it undivided, the program divides it itself");
            if (section == "Entities")
              read_entities();
            else if (section == "Nodes")
              is_new ? read_new_nodes() : read_old_nodes();
            else if (section == "Elements")
              is_new ? read_new_elements() : read_old_elements();
            leave_section(section);
          }
        if (file.elements.empty())
          fail("has no elements");
      }

      GmshFile file;

    private:
      [[noreturn]] void
      fail(const std::string &what) const
      {
        throw SceneError("mesh file '" + file_name + "' " + what);
      }

      /// What stands behind the next `$`; empty at the end of the file.
      std::string
      next_section()
      {
        for (std::string line; std::getline(in, line);)
          if (!line.empty() && line[0] == '$')
            return trim(line.substr(1));
        return "";
      }

      void
      leave_section(const std::string &section)
      {
        if (in.fail())
          fail("has something in $" + section + " that does not belong there");
        if (next_section() != "End" + section)
          fail("ends within $" + section);
      }

      void
      read_names()
      {
        unsigned int n = 0;
        in >> n;
        for (unsigned int i = 0; i < n && in; ++i)
          {
            unsigned int dimension = 0;
            int          tag       = 0;
            std::string  rest;
            in >> dimension >> tag;
            std::getline(in, rest);
            const auto from = rest.find('"'), to = rest.rfind('"');
            if (dimension > 3 || from == to)
              fail("has a line in $PhysicalNames that is not: dimension tag \"name\"");
            file.groups[dimension][tag] = trim(rest.substr(from + 1, to - from - 1));
          }
        leave_section("PhysicalNames");
      }

      void
      read_entities()
      {
        std::array<std::size_t, 4> n{};
        for (std::size_t &count : n)
          in >> count;
        for (unsigned int dimension = 0; dimension < 4; ++dimension)
          for (std::size_t i = 0; i < n[dimension] && in; ++i)
            read_entity(dimension);
      }

      void
      read_entity(const unsigned int dimension)
      {
        int         tag = 0, group = 0, ignored;
        std::size_t n = 0;
        in >> tag;
        skip_numbers(dimension == 0 ? 3 : 6); // a point, or a bounding box
        in >> n;
        if (n > 1)
          fail("has entity " + std::to_string(tag) + " of dimension " + std::to_string(dimension) +
               " in several physical groups; leave it in one");
        for (std::size_t i = 0; i < n; ++i)
          in >> group;
        entities[dimension][tag] = std::abs(group); // the sign is a direction
        if (dimension == 0)
          return;
        in >> n;
        for (std::size_t i = 0; i < n && in; ++i)
          in >> ignored;
      }

      void
      skip_numbers(const unsigned int n)
      {
        double ignored;
        for (unsigned int i = 0; i < n; ++i)
          in >> ignored;
      }

      void
      read_point(const std::size_t tag)
      {
        Point<3> p;
        in >> p[0] >> p[1] >> p[2];
        index_of[tag] = file.nodes.size();
        file.nodes.push_back(p);
      }

      void
      read_old_nodes()
      {
        std::size_t n = 0, tag = 0;
        in >> n;
        for (std::size_t i = 0; i < n && in >> tag; ++i)
          read_point(tag);
      }

      void
      read_new_nodes()
      {
        std::size_t blocks = 0;
        in >> blocks;
        skip_numbers(3);
        for (std::size_t block = 0; block < blocks && in; ++block)
          {
            unsigned int dimension = 0, entity = 0, parametric = 0;
            std::size_t  n = 0;
            in >> dimension >> entity >> parametric >> n;
            std::vector<std::size_t> tags;
            for (std::size_t tag = 0; tags.size() < n && in >> tag;)
              tags.push_back(tag);
            for (const std::size_t tag : tags)
              {
                read_point(tag);
                skip_numbers(parametric ? dimension : 0);
              }
          }
      }

      /// The nodes are what is left of the line.
      void
      read_element(const unsigned int type, const int group)
      {
        GmshFile::Element element{dimension_of(type), type, group, {}};
        std::string       line;
        std::getline(in, line);
        std::istringstream words(line);
        for (std::size_t tag; words >> tag;)
          {
            const auto entry = index_of.find(tag);
            if (entry == index_of.end())
              fail("has an element with the unknown node " + std::to_string(tag));
            element.nodes.push_back(entry->second);
          }
        const unsigned int n = type == 1 ? 2 : type == 3 ? 4 : type == 5 ? 8 : element.nodes.size();
        if (element.nodes.size() != n)
          fail("has an element of type " + std::to_string(type) + " without its " +
               std::to_string(n) + " nodes");
        file.elements.push_back(element);
      }

      void
      read_old_elements()
      {
        std::size_t n = 0;
        in >> n;
        for (std::size_t i = 0; i < n && in; ++i)
          {
            std::size_t  tag;
            unsigned int type = 0, n_tags = 0;
            int          group = 0, ignored;
            in >> tag >> type >> n_tags;
            for (unsigned int j = 0; j < n_tags; ++j)
              in >> (j == 0 ? group : ignored);
            read_element(type, std::abs(group));
          }
      }

      void
      read_new_elements()
      {
        std::size_t blocks = 0;
        in >> blocks;
        skip_numbers(3);
        for (std::size_t block = 0; block < blocks && in; ++block)
          {
            unsigned int dimension = 0, type = 0;
            int          entity = 0;
            std::size_t  n      = 0, tag;
            in >> dimension >> entity >> type >> n;
            for (std::size_t i = 0; i < n && in >> tag; ++i)
              read_element(type, dimension < 4 ? entities[dimension][entity] : 0);
          }
      }

      const std::string                             file_name;
      std::ifstream                                 in;
      bool                                          is_new = true; ///< format 4.1
      std::array<std::map<int, int>, 4>             entities;      ///< their physical tags
      std::unordered_map<std::size_t, unsigned int> index_of;      ///< index of a node by its tag
    };
  } // namespace



  GmshFile
  read_gmsh(const std::string &file_name)
  {
    Reader reader(file_name);
    reader.read_groups();
    reader.read_the_rest();
    return std::move(reader.file);
  }



  GmshFile::Groups
  read_gmsh_groups(const std::string &file_name)
  {
    Reader reader(file_name);
    reader.read_groups();
    return std::move(reader.file.groups);
  }
} // namespace Signorini
