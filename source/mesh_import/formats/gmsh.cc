// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/file_position.h"
#include "mesh_import/formats/readers.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <unordered_map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Shape = MeshFile::Shape;

    /// Shape and number of nodes of an element type.
    struct Type
    {
      Shape shape;
      /// Number of nodes; 0: any.
      unsigned int n_nodes;
    };

    /// @return shape and number of nodes of an element type as Gmsh numbers it.
    Type
    type_of(const unsigned int type)
    {
      static const std::array<Type, 20> types{
        {{Shape::unknown, 0},       {Shape::line, 2},          {Shape::triangle, 3},
         {Shape::quadrilateral, 4}, {Shape::tetrahedron, 4},   {Shape::hexahedron, 8},
         {Shape::wedge, 6},         {Shape::pyramid, 5},       {Shape::line, 3},
         {Shape::triangle, 6},      {Shape::quadrilateral, 9}, {Shape::tetrahedron, 10},
         {Shape::hexahedron, 27},   {Shape::wedge, 18},        {Shape::pyramid, 14},
         {Shape::point, 1},         {Shape::quadrilateral, 8}, {Shape::hexahedron, 20},
         {Shape::wedge, 15},        {Shape::pyramid, 13}}};
      return types[type < types.size() ? type : 0];
    }



    /// @return the nodes of an element in the order of MeshFile::Element. Gmsh lists the edges by
    /// their first and second corner and the faces by their corners.
    MeshFile::Nodes
    reordered(const Shape shape, const MeshFile::Nodes &nodes)
    {
      static const std::map<Shape, MeshFile::Nodes> orders = {
        {Shape::tetrahedron, {0, 1, 2, 3, 4, 5, 6, 7, 9, 8}},
        {Shape::pyramid, {0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12, 13}},
        {Shape::wedge, {0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11, 15, 17, 16}},
        {Shape::hexahedron, {0,  1,  2,  3,  4,  5,  6,  7,  8,  11, 13, 9,  16, 18,
                             19, 17, 10, 12, 14, 15, 22, 23, 21, 24, 20, 25, 26}}};
      const auto order = orders.find(shape);
      if (order == orders.end())
        return nodes;
      MeshFile::Nodes result(nodes.size());
      for (unsigned int i = 0; i < nodes.size(); ++i)
        result[i] = nodes[order->second[i]];
      return result;
    }



    /// Reads the sections $Name ... $EndName in the order of the file. Only ASCII files of format
    /// 2.2 ("old") and 4.1 ("new") are accepted. In format 4.1 elements belong to entities, which
    /// belong to physical groups; in format 2.2 they have their group themselves.
    class GmshReader
    {
    public:
      /// Open the file and check its format.
      GmshReader(const std::string &file_name)
        : file_name(file_name)
        , in(file_name)
      {
        if (!in)
          fail("cannot be opened");
        skip_byte_order_mark(in);
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
        skip_section("MeshFormat");
      }

      /// Read all sections, then create the groups from physical names and tags.
      /// @return the mesh, which is moved out of the reader
      MeshFile
      read()
      {
        for (std::string section = next_section(); !section.empty(); section = next_section())
          {
            if (section == "PartitionedEntities")
              fail("is partitioned; save it undivided, the program divides it itself");
            if (section == "PhysicalNames")
              read_names();
            else if (section == "Entities")
              read_entities();
            else if (section == "Nodes")
              is_new ? read_new_nodes() : read_old_nodes();
            else if (section == "Elements")
              is_new ? read_new_elements() : read_old_elements();
            else if (section == "NodeData")
              read_field();
            skip_section(section);
          }
        if (file.elements.empty())
          fail("has no elements");
        for (unsigned int dimension = 0; dimension < 4; ++dimension)
          {
            /// Append a list to another one.
            for (const auto &[tag, name] : names[dimension])
              append(file.group(name).elements, members[dimension][tag]);
            for (const auto &[tag, elements] : members[dimension])
              if (tag != 0 && names[dimension].count(tag) == 0) // 0: of no group
                append(file.group(std::to_string(tag)).elements, elements);
          }
        return std::move(file);
      }

    private:
      [[noreturn]] void
      fail(const std::string &what) const
      {
        throw SceneError("mesh file '" + file_name + "' " + what);
      }

      static void
      append(std::vector<unsigned int> &to, const std::vector<unsigned int> &from)
      {
        to.insert(to.end(), from.begin(), from.end());
      }

      /// @return the name of the next section; empty at the end of the file.
      std::string
      next_section()
      {
        for (std::string line; std::getline(in, line);)
          if (!line.empty() && line[0] == '$')
            return trim(line.substr(1));
        return "";
      }

      /// Advance behind the end of a section whose numbers have been read. Throws SceneError if
      /// reading has failed.
      void
      skip_section(const std::string &section)
      {
        if (in.fail())
          fail("has something in $" + section + " that does not belong there" +
               position_of_failure(in, file_name));
        if (next_section() != "End" + section)
          fail("ends within $" + section);
      }

      /// Lines: dimension, tag, "name" of a physical group.
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
            names[dimension][tag] = trim(rest.substr(from + 1, to - from - 1));
          }
      }

      /// The numbers of points, curves, surfaces and volumes, and then these.
      void
      read_entities()
      {
        std::array<std::size_t, 4> n{};
        for (std::size_t &count : n)
          in >> count;
        /// Tag, coordinates or bounding box, physical groups, and boundaries of one entity.
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
        /// Read and discard n numbers.
        skip_numbers(dimension == 0 ? 3 : 6); // a point, or a bounding box
        in >> n;
        for (std::size_t i = 0; i < n && in >> group; ++i)
          entities[dimension][tag].push_back(without_sign(group));
        if (dimension == 0)
          return;
        in >> n;
        for (std::size_t i = 0; i < n && in; ++i)
          in >> ignored;
      }

      void
      skip_numbers(const std::size_t n)
      {
        double ignored;
        for (std::size_t i = 0; i < n && in; ++i)
          in >> ignored;
      }

      /// @return the absolute value of a group, whose sign is a direction. The smallest integer has
      /// no absolute value.
      static int
      without_sign(const int group)
      {
        return std::abs(std::max(group, -std::numeric_limits<int>::max()));
      }

      /// Read the three coordinates of a node with a tag.
      void
      read_point(const std::size_t tag)
      {
        Point<3> p;
        in >> p[0] >> p[1] >> p[2];
        if (in && !std::isspace(in.peek()))
          in.setstate(std::ios::failbit); // 0x1p4 is more than its 0
        index_of[tag] = file.nodes.size();
        file.nodes.push_back(p);
      }

      /// Lines: tag and coordinates of each node.
      void
      read_old_nodes()
      {
        std::size_t n = 0, tag = 0;
        in >> n;
        for (std::size_t i = 0; i < n && in >> tag; ++i)
          read_point(tag);
      }

      /// Blocks of nodes of one entity: first all tags, then all coordinates, with parameters on
      /// the entity if the block is parametric.
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

      /// Read an element, whose nodes are the rest of the line, and add it to its groups.
      void
      read_element(const std::size_t       number,
                   const unsigned int      type,
                   const std::vector<int> &groups)
      {
        const auto [shape, n] = type_of(type);
        MeshFile::Element element{shape, "type " + std::to_string(type), number, {}};
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
        if (n > 0 && element.nodes.size() != n)
          fail("has element " + std::to_string(number) + " of type " + std::to_string(type) +
               " without its " + std::to_string(n) + " nodes");
        element.nodes                = reordered(shape, element.nodes);
        const unsigned int dimension = dimension_of(shape);
        if (dimension < 4)
          for (const int group : groups)
            members[dimension][group].push_back(file.elements.size());
        file.elements.push_back(element);
      }

      /// Lines: tag, type, number of tags, tags (the first is the physical group), nodes.
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
            for (unsigned int j = 0; j < n_tags && in; ++j)
              in >> (j == 0 ? group : ignored);
            read_element(tag, type, {without_sign(group)});
          }
      }

      /// Blocks of elements of one entity and type.
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
              read_element(tag, type, entities[std::min(dimension, 3u)][entity]);
          }
      }

      /// Read a $NodeData. Of several with one name, such as steps in time, the last one is kept.
      /// Fields with more than one component are skipped.
      void
      read_field()
      {
        std::size_t n = 0;
        std::string name, line;
        in >> n >> std::ws;
        for (std::size_t i = 0; i < n && std::getline(in, line); ++i)
          if (i == 0)
            name = trim(line);
        if (name.size() > 1 && name.front() == '"' && name.back() == '"')
          name = name.substr(1, name.size() - 2);
        in >> n;
        skip_numbers(n);
        in >> n;
        // String tags (the first is the name), real tags (skipped), integer tags: step, components,
        // nodes.
        std::vector<std::size_t> tags; // of the step, number of components, number of nodes
        for (std::size_t tag; tags.size() < n && in >> tag;)
          tags.push_back(tag);
        if (tags.size() < 3 || tags[1] == 0)
          fail("has a $NodeData without its three whole numbers");
        std::vector<double> values(file.nodes.size(), std::numeric_limits<double>::quiet_NaN());
        std::size_t         node = 0;
        for (std::size_t i = 0; i < tags[2] && in >> node; ++i)
          {
            double value = 0;
            in >> value;
            skip_numbers(tags[1] - 1);
            if (const auto entry = index_of.find(node); entry != index_of.end())
              values[entry->second] = value;
          }
        if (tags[1] == 1)
          file.fields[name] = values;
      }

      const std::string file_name;
      std::ifstream     in;
      MeshFile          file;
      /// Whether the format is 4.1 (otherwise 2.2).
      bool is_new = true;
      /// Index of a node by its tag.
      std::unordered_map<std::size_t, unsigned int> index_of;

      // By dimension and then by tag: physical names, physical tags of entities, and elements of
      // physical tags.
      std::array<std::map<int, std::string>, 4>               names;
      std::array<std::map<int, std::vector<int>>, 4>          entities;
      std::array<std::map<int, std::vector<unsigned int>>, 4> members;
    };
  } // namespace



  MeshFile
  read_gmsh(const std::string &file_name)
  {
    return GmshReader(file_name).read();
  }
} // namespace Signorini
