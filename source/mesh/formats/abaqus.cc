#include <signorini/mesh/formats/abaqus.h>
#include <signorini/mesh/formats/abaqus_elements.h>
#include <signorini/mesh/formats/keyword_file.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <unordered_map>

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
              read_set("NSET", node_sets, node_index);
            else if (keyword == "ELSET")
              read_set("ELSET", element_sets, element_index);
            else if (keyword == "SURFACE")
              read_surface();
          }
        if (file.elements.empty())
          in.fail("the file has no elements: *ELEMENT");
        make_groups();
        return std::move(file);
      }

    private:
      using Index = std::unordered_map<std::size_t, unsigned int>;

      struct Set
      {
        std::string               name;
        std::vector<unsigned int> members;
      };

      /// By the name in upper case.
      using Sets = std::map<std::string, Set>;

      std::size_t
      integer(const std::string &word) const
      {
        char             *end    = nullptr;
        const std::size_t number = std::strtoul(word.c_str(), &end, 10);
        if (word.empty() || *end != '\0' || word[0] == '-')
          in.fail("'" + word + "' should be the number of a node or element");
        return number;
      }

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

      static Set &
      set_of(Sets &sets, const std::string &name)
      {
        return sets.insert({upper_case(name), {name, {}}}).first->second;
      }

      void
      read_nodes()
      {
        if (in.has("SYSTEM") && upper_case(in.value("SYSTEM")) != "R")
          in.fail("*NODE, SYSTEM=" + in.value("SYSTEM") +
                  " is not read here; write Cartesian coordinates");
        Set *const set = in.has("NSET") ? &set_of(node_sets, in.value("NSET")) : nullptr;
        for (Words words; in.next_line(words);)
          {
            const auto [entry, is_new] = node_index.insert({integer(words[0]), file.nodes.size()});
            if (is_new)
              file.nodes.emplace_back();
            for (unsigned int d = 0; d < 3; ++d)
              file.nodes[entry->second][d] = d + 1 < words.size() ? number(words[d + 1]) : 0.;
            if (set)
              set->members.push_back(entry->second);
          }
      }

      void
      read_elements()
      {
        const std::string type_name = upper_case(in.value("TYPE"));
        if (type_name.empty())
          in.fail("*ELEMENT needs TYPE=...");
        const AbaqusType type = abaqus_type(type_name);
        Set *const       set = in.has("ELSET") ? &set_of(element_sets, in.value("ELSET")) : nullptr;
        std::vector<std::size_t> numbers;
        for (Words words; in.next_line(words);)
          {
            for (const std::string &word : words)
              if (!word.empty())
                numbers.push_back(integer(word));
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
                  Set                            *set)
      {
        if (numbers.empty() || (type.n_nodes > 0 && numbers.size() != type.n_nodes + 1))
          in.fail("an element of type " + type_name + " does not have its " +
                  std::to_string(type.n_nodes) + " nodes");
        MeshFile::Nodes nodes;
        for (unsigned int i = 1; i < numbers.size(); ++i)
          {
            const auto found = node_index.find(numbers[i]);
            // Springs to the ground and the like may have a node 0 or none.
            if (found == node_index.end() && type.n_nodes > 0)
              in.fail("element " + std::to_string(numbers[0]) + " has the unknown node " +
                      std::to_string(numbers[i]));
            if (found != node_index.end())
              nodes.push_back(found->second);
          }
        if (!element_index.insert({numbers[0], file.elements.size()}).second)
          in.fail("element " + std::to_string(numbers[0]) + " is there twice");
        if (set)
          set->members.push_back(file.elements.size());
        const bool lacks_nodes = nodes.size() < n_corners(type.shape);
        file.elements.push_back({lacks_nodes ? MeshFile::Shape::unknown : type.shape,
                                 type_name,
                                 numbers[0],
                                 reordered(type, nodes)});
      }

      /// Numbers, other sets of the kind, or with GENERATE: first, last, step.
      void
      read_set(const std::string &parameter, Sets &sets, const Index &index)
      {
        if (in.value(parameter).empty())
          in.fail("*" + parameter + " needs " + parameter + "=name");
        std::vector<unsigned int> members;
        if (parameter == "NSET" && in.has("ELSET"))
          members = nodes_of(in.value("ELSET"));
        for (Words words; in.next_line(words);)
          if (in.has("GENERATE"))
            generate(words, index, members);
          else
            for (const std::string &word : words)
              append(word, sets, index, members);
        Set &set = set_of(sets, in.value(parameter));
        set.members.insert(set.members.end(), members.begin(), members.end());
      }

      void
      generate(const Words &words, const Index &index, std::vector<unsigned int> &members) const
      {
        const std::size_t first = integer(words.at(0)),
                          last  = words.size() > 1 ? integer(words[1]) : first,
                          step  = words.size() > 2 ? integer(words[2]) : 1;
        for (std::size_t i = first; i <= last; i += std::max<std::size_t>(step, 1))
          if (index.count(i))
            members.push_back(index.at(i));
      }

      void
      append(const std::string         &word,
             const Sets                &sets,
             const Index               &index,
             std::vector<unsigned int> &members) const
      {
        const auto set = sets.find(upper_case(word));
        if (set != sets.end())
          members.insert(members.end(), set->second.members.begin(), set->second.members.end());
        else if (!word.empty())
          {
            const bool is_number = word.find_first_not_of("0123456789") == std::string::npos;
            const auto found     = is_number ? index.find(integer(word)) : index.end();
            if (found == index.end())
              in.fail("'" + word + "' is no node, element or set that stands above");
            members.push_back(found->second);
          }
      }

      std::vector<unsigned int>
      nodes_of(const std::string &element_set) const
      {
        std::vector<unsigned int> elements;
        append(element_set, element_sets, element_index, elements);
        std::set<unsigned int> nodes;
        for (const unsigned int e : elements)
          nodes.insert(file.elements[e].nodes.begin(), file.elements[e].nodes.end());
        return {nodes.begin(), nodes.end()};
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
            append(words[0], node_sets, node_index, surface.nodes);
          else
            add_faces(words[0], words.size() > 1 ? upper_case(words[1]) : "", surface.faces);
        surfaces.push_back(surface);
      }

      void
      add_faces(const std::string            &elements,
                const std::string            &label,
                std::vector<MeshFile::Nodes> &faces) const
      {
        std::vector<unsigned int> members;
        append(elements, element_sets, element_index, members);
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
        for (const auto &[name, set] : element_sets)
          file.group(set.name).elements = set.members;
        for (const auto &[name, set] : node_sets)
          {
            MeshFile::Nodes &nodes = file.group(set.name).nodes;
            nodes.insert(nodes.end(), set.members.begin(), set.members.end());
          }
      }

      KeywordFile                  in;
      MeshFile                     file;
      Index                        node_index, element_index;
      Sets                         node_sets, element_sets;
      std::vector<MeshFile::Group> surfaces;
    };
  } // namespace



  MeshFile
  read_abaqus(const std::string &file_name)
  {
    return Reader(file_name).read();
  }
} // namespace Signorini
