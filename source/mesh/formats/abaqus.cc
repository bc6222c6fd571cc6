#include <signorini/mesh/formats/abaqus.h>
#include <signorini/mesh/formats/abaqus_elements.h>
#include <signorini/mesh/formats/abaqus_sets.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace Signorini
{
  namespace
  {
    using Words = std::vector<std::string>;

    /// Keywords without which the mesh would not be what the file means, and the cure.
    const std::map<std::string, std::string> refused = {
      {"PART",
       "write the file without parts; in Abaqus/CAE: Model, Edit attributes, Do not use parts and assemblies in input files"},
      {"INSTANCE", "write the file without instances"},
      {"SYSTEM", "write the nodes in the global Cartesian system"},
      {"NGEN", "write all nodes"},
      {"NFILL", "write all nodes"},
      {"NCOPY", "write all nodes"},
      {"ELGEN", "write all elements"},
      {"ELCOPY", "write all elements"}};



    class Reader
    {
    public:
      explicit Reader(const std::string &file_name)
        : in(file_name)
      {}

      MeshFile
      read()
      {
        while (in.next_keyword())
          {
            const std::string &keyword = in.keyword();
            if (refused.count(keyword))
              in.fail("*" + keyword + " is not read here; " + refused.at(keyword));
            if (keyword == "NODE")
              read_nodes();
            else if (keyword == "ELEMENT")
              read_elements();
            else if (keyword == "NSET")
              read_set("NSET", nodes);
            else if (keyword == "ELSET")
              read_set("ELSET", elements);
            else if (keyword == "SURFACE")
              read_surface();
          }
        if (file.elements.empty())
          in.fail("the file has no elements: *ELEMENT");
        make_groups();
        return std::move(file);
      }

    private:
      double
      number(std::string word) const
      {
        // Fortran writes 1.5D+3 in double precision.
        std::replace_if(
          word.begin(), word.end(), [](const char c) { return c == 'D' || c == 'd'; }, 'E');
        char        *end   = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (*end != '\0')
          in.fail("'" + word + "' should be a coordinate");
        return value;
      }

      void
      read_nodes()
      {
        if (in.has("SYSTEM") && upper_case(in.value("SYSTEM")) != "R")
          in.fail("*NODE, SYSTEM=" + in.value("SYSTEM") +
                  " is not read here; write Cartesian coordinates");
        AbaqusSet *const set = in.has("NSET") ? &nodes.get(in.value("NSET")) : nullptr;
        for (Words words; in.next_line(words);)
          {
            const std::size_t n = number_from(in, words[0]);
            if (nodes.insert(n, file.nodes.size()))
              file.nodes.emplace_back();
            const unsigned int node = nodes.index(n);
            for (unsigned int d = 0; d < 3; ++d)
              file.nodes[node][d] = d + 1 < words.size() ? number(words[d + 1]) : 0.;
            if (set)
              set->members.push_back(node);
          }
      }

      void
      read_elements()
      {
        const std::string type_name = upper_case(in.value("TYPE"));
        if (type_name.empty())
          in.fail("*ELEMENT needs TYPE=...");
        const AbaqusType         type = abaqus_type(type_name);
        AbaqusSet *const         set = in.has("ELSET") ? &elements.get(in.value("ELSET")) : nullptr;
        std::vector<std::size_t> numbers;
        for (Words words; in.next_line(words);)
          {
            for (const std::string &word : words)
              if (!word.empty())
                numbers.push_back(number_from(in, word));
            const bool complete = type.n_nodes > 0 ? numbers.size() > type.n_nodes : !in.goes_on();
            if (complete)
              {
                add_element(type, type_name, numbers, set);
                numbers.clear();
              }
          }
        if (!numbers.empty())
          in.fail("element " + std::to_string(numbers[0]) + " of type " + type_name +
                  " is without its " + std::to_string(type.n_nodes) + " nodes");
      }

      void
      add_element(const AbaqusType               &type,
                  const std::string              &type_name,
                  const std::vector<std::size_t> &numbers,
                  AbaqusSet                      *set)
      {
        if (numbers.empty() || (type.n_nodes > 0 && numbers.size() != type.n_nodes + 1))
          in.fail("an element of type " + type_name + " does not have its " +
                  std::to_string(type.n_nodes) + " nodes");
        MeshFile::Nodes members;
        for (unsigned int i = 1; i < numbers.size(); ++i)
          {
            const unsigned int node = nodes.index(numbers[i]);
            // Springs to the ground and the like may have a node 0 or none.
            if (node == AbaqusSets::none && type.n_nodes > 0)
              in.fail("element " + std::to_string(numbers[0]) + " has the unknown node " +
                      std::to_string(numbers[i]));
            if (node != AbaqusSets::none)
              members.push_back(node);
          }
        if (!elements.insert(numbers[0], file.elements.size()))
          in.fail("element " + std::to_string(numbers[0]) + " is there twice");
        if (set)
          set->members.push_back(file.elements.size());
        const bool lacks_nodes = members.size() < n_corners(type.shape);
        file.elements.push_back({lacks_nodes ? MeshFile::Shape::point : type.shape,
                                 type_name,
                                 numbers[0],
                                 reordered(type, members)});
      }

      void
      read_set(const std::string &parameter, AbaqusSets &sets)
      {
        if (in.value(parameter).empty())
          in.fail("*" + parameter + " needs " + parameter + "=name");
        std::vector<unsigned int> members;
        if (parameter == "NSET" && in.has("ELSET"))
          members = nodes_of(in.value("ELSET"));
        sets.append_lines(in, members);
        AbaqusSet &set = sets.get(in.value(parameter));
        set.members.insert(set.members.end(), members.begin(), members.end());
      }

      std::vector<unsigned int>
      nodes_of(const std::string &element_set) const
      {
        std::vector<unsigned int> members;
        elements.append(in, element_set, members);
        std::set<unsigned int> result;
        for (const unsigned int e : members)
          result.insert(file.elements[e].nodes.begin(), file.elements[e].nodes.end());
        return {result.begin(), result.end()};
      }

      /// Other kinds than the two are not made of the mesh: analytical rigid surfaces.
      void
      read_surface()
      {
        const std::string type = in.has("TYPE") ? upper_case(in.value("TYPE")) : "ELEMENT";
        if (type != "ELEMENT" && type != "NODE")
          return;
        MeshFile::Group surface{in.value("NAME"), {}, {}, {}};
        if (surface.name.empty())
          in.fail("*SURFACE needs NAME=name");
        for (Words words; in.next_line(words);)
          if (type == "NODE")
            nodes.append(in, words[0], surface.nodes);
          else
            add_faces(words[0], words.size() > 1 ? upper_case(words[1]) : "", surface.faces);
        surfaces.push_back(surface);
      }

      void
      add_faces(const std::string            &of,
                const std::string            &label,
                std::vector<MeshFile::Nodes> &faces) const
      {
        std::vector<unsigned int> members;
        elements.append(in, of, members);
        for (const unsigned int e : members)
          for (const MeshFile::Nodes &face : abaqus_faces(file.elements[e], label))
            faces.push_back(face);
      }

      void
      make_groups()
      {
        for (const MeshFile::Group &surface : surfaces)
          {
            MeshFile::Group &group = file.group(surface.name);
            group.faces.insert(group.faces.end(), surface.faces.begin(), surface.faces.end());
            group.nodes.insert(group.nodes.end(), surface.nodes.begin(), surface.nodes.end());
          }
        for (const auto &[name, set] : elements.all())
          file.group(set.name).elements = set.members;
        for (const auto &[name, set] : nodes.all())
          {
            MeshFile::Nodes &members = file.group(set.name).nodes;
            members.insert(members.end(), set.members.begin(), set.members.end());
          }
      }

      KeywordFile                  in;
      MeshFile                     file;
      AbaqusSets                   nodes, elements;
      std::vector<MeshFile::Group> surfaces;
    };
  } // namespace



  MeshFile
  read_abaqus(const std::string &file_name)
  {
    return Reader(file_name).read();
  }
} // namespace Signorini
