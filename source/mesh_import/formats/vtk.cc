// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/file_position.h"
#include "mesh_import/formats/readers.h"
#include "mesh_import/formats/vtk_cells.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>

namespace Signorini
{
  namespace
  {
    /// @return a number of a binary legacy file, which is big-endian, on a little-endian machine.
    template <typename T>
    T
    from_big_endian(const char *bytes)
    {
      char reversed[sizeof(T)];
      std::reverse_copy(bytes, bytes + sizeof(T), reversed);
      T value;
      std::memcpy(&value, reversed, sizeof(T));
      return value;
    }



    /// Reads the sections of a legacy file one after the other. The first two lines are the version
    /// and a title; the third is ASCII or BINARY. Sections that do not matter are skipped by
    /// reading their numbers.
    class VTKReader
    {
    public:
      explicit VTKReader(const std::string &file_name)
        : file_name(file_name)
        , in(file_name, std::ios::binary)
      {
        std::string version, title, format;
        skip_byte_order_mark(in);
        std::getline(in, version);
        if (version.compare(0, 22, "# vtk DataFile Version") != 0)
          fail("is not a legacy file of VTK: it does not begin with # vtk DataFile Version");
        std::getline(in, title);
        in >> format;
        binary = format == "BINARY";
      }

      MeshFile
      read()
      {
        for (std::string word; in >> word;)
          {
            /// Read the section that a word begins.
            read_section(word);
            if (in.fail())
              fail("has something behind " + word + " that does not belong there" +
                   (binary ? "" : position_of_failure(in, file_name)));
          }
        if (file.elements.empty())
          fail("has no cells");
        return std::move(file);
      }

    private:
      [[noreturn]] void
      fail(const std::string &what) const
      {
        throw SceneError("mesh file '" + file_name + "' " + what);
      }

      void
      read_section(const std::string &word)
      {
        static const std::map<std::string, unsigned int> skipped = {
          {"VECTORS", 3}, {"NORMALS", 3}, {"TENSORS", 9}, {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}};
        if (word == "DATASET")
          {
            if (next_word() != "UNSTRUCTURED_GRID")
              fail("is no unstructured grid; save it as one");
          }
        else if (word == "POINTS")
          read_points();
        else if (word == "CELLS")
          read_cells();
        else if (word == "CELL_TYPES")
          read_types();
        else if (word == "CELL_DATA" || word == "POINT_DATA")
          {
            of_cells = word == "CELL_DATA";
            n_values = next_number();
          }
        /// SCALARS name type [components], LOOKUP_TABLE name, values.
        else if (word == "SCALARS")
          read_scalars();
        /// FIELD name number-of-arrays, then for each array: name, components, tuples, type,
        /// values.
        else if (word == "FIELD")
          read_fields();
        else if (word == "METADATA")
          skip_paragraph();
        else if (skipped.count(word))
          {
            /// @return the next word of the text; empty at the end of the file.
            next_word();
            numbers<double>(next_word(), n_values * skipped.at(word));
          }
        else
          fail("has '" + word + "', which is not read here; save it as .vtu");
      }

      std::string
      next_word()
      {
        std::string word;
        in >> word;
        return word;
      }

      /// @return the next number of the text; 0 if there is none.
      std::size_t
      next_number()
      {
        std::size_t number = 0;
        in >> number;
        return number;
      }

      /// Skip the lines up to the next empty one (METADATA).
      void
      skip_paragraph()
      {
        for (std::string line; std::getline(in, line) && line.empty();)
          ;
        for (std::string line; std::getline(in, line) && !trim(line).empty();)
          ;
      }

      /// @return n numbers of a type as VTK names it; fewer if the file ends, or a word is none.
      /// Memory grows with what is read, so that a wrong n cannot exhaust it.
      template <typename T>
      std::vector<T>
      numbers(const std::string &type, const std::size_t n)
      {
        if (!binary)
          return words_as<T>(n);
        in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        if (type == "float")
          return bytes_as<T, float>(n);
        if (type == "double")
          return bytes_as<T, double>(n);
        if (type == "int")
          return bytes_as<T, std::int32_t>(n);
        if (type == "unsigned_int")
          return bytes_as<T, std::uint32_t>(n);
        if (type == "long" || type == "vtkIdType" || type == "vtktypeint64")
          return bytes_as<T, std::int64_t>(n);
        if (type == "short")
          return bytes_as<T, std::int16_t>(n);
        if (type == "unsigned_short")
          return bytes_as<T, std::uint16_t>(n);
        if (type == "char")
          return bytes_as<T, std::int8_t>(n);
        if (type == "unsigned_char")
          return bytes_as<T, std::uint8_t>(n);
        fail("has numbers of type '" + type + "', which are not read here; save it as text");
      }

      /// @return n numbers that are written as text.
      template <typename T>
      std::vector<T>
      words_as(const std::size_t n)
      {
        std::vector<T> result;
        for (T value; result.size() < n && in >> value;)
          result.push_back(value);
        return result;
      }

      /// @return n binary numbers, converted from the type in which they are stored.
      template <typename T, typename Stored>
      std::vector<T>
      bytes_as(const std::size_t n)
      {
        std::vector<T> result;
        char           bytes[sizeof(Stored)];
        while (result.size() < n && in.read(bytes, sizeof(Stored)))
          result.push_back(static_cast<T>(from_big_endian<Stored>(bytes)));
        return result;
      }

      /// POINTS n type, 3 n coordinates.
      void
      read_points()
      {
        const std::size_t         n  = next_number();
        const std::vector<double> xs = numbers<double>(next_word(), 3 * n);
        for (std::size_t i = 0; i + 2 < xs.size(); i += 3)
          file.nodes.emplace_back(xs[i], xs[i + 1], xs[i + 2]);
      }

      /// Since version 5, CELLS are two arrays: where each cell begins, and the points of all
      /// cells. Before, the number of points precedes the points of each cell.
      void
      read_cells()
      {
        const std::size_t n = next_number(), m = next_number();
        const auto        here = in.tellg();
        if (next_word() == "OFFSETS")
          {
            offsets = numbers<long>(next_word(), n);
            next_word();
            points = numbers<long>(next_word(), m);
            return;
          }
        in.clear();
        in.seekg(here);
        const std::vector<long> mixed = numbers<long>("int", m);
        offsets                       = {0};
        for (std::size_t i = 0; i < mixed.size() && offsets.size() <= n; i += mixed[i] + 1)
          {
            if (mixed[i] < 0 || i + mixed[i] >= mixed.size())
              fail("ends within CELLS");
            points.insert(points.end(), mixed.begin() + i + 1, mixed.begin() + i + 1 + mixed[i]);
            offsets.push_back(points.size());
          }
      }

      /// CELL_TYPES n, n types. The cells are added here, since CELLS precede their types.
      void
      read_types()
      {
        const std::vector<long> types = numbers<long>("int", next_number());
        try
          {
            add_vtk_cells(file, types, offsets, points);
          }
        catch (const SceneError &error)
          {
            fail(error.what());
          }
      }

      void
      read_scalars()
      {
        const std::string name = next_word(), type = next_word();
        std::string       rest;
        std::getline(in, rest);
        const std::string components = trim(rest);
        const std::size_t n =
          components.empty() ? 1 : std::strtoul(components.c_str(), nullptr, 10);
        if (n < 1 || n > 4)
          fail("has SCALARS " + name + " with '" + shortened(components) +
               "' components; there are 1 to 4");
        if (next_word() == "LOOKUP_TABLE")
          next_word();
        else
          fail("has SCALARS " + name + " without LOOKUP_TABLE");
        /// Read an array. Scalars at points become fields; integers at cells become groups;
        /// everything else is read and discarded.
        read_array(name, type, n, n_values);
      }

      void
      read_fields()
      {
        next_word();
        const std::size_t n_arrays = next_number();
        for (std::size_t i = 0; i < n_arrays && in; ++i)
          {
            std::string name = next_word();
            if (name == "METADATA")
              {
                skip_paragraph();
                name = next_word();
              }
            const std::size_t n_components = next_number(), n = next_number();
            read_array(name, next_word(), n_components, n);
          }
      }

      void
      read_array(const std::string &name,
                 const std::string &type,
                 const std::size_t  n_components,
                 const std::size_t  n)
      {
        const bool at_points = !of_cells && n_components == 1 && n == file.nodes.size();
        if (at_points)
          file.fields[name] = numbers<double>(type, n);
        else if (type == "float" || type == "double")
          numbers<double>(type, n_components * n);
        else
          {
            const std::vector<long> values = numbers<long>(type, n_components * n);
            if (of_cells && n_components == 1 && values.size() == file.elements.size())
              add_vtk_groups(file, name, values);
          }
      }

      const std::string file_name;
      std::ifstream     in;
      MeshFile          file;
      std::vector<long> offsets, points;
      std::size_t       n_values = 0;
      bool              binary   = false;
      /// Whether data belong to cells or to points.
      bool of_cells = false;
    };
  } // namespace



  MeshFile
  read_vtk(const std::string &file_name)
  {
    return VTKReader(file_name).read();
  }
} // namespace Signorini
