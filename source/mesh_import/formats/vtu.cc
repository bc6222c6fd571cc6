// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/readers.h"
#include "mesh_import/formats/vtk_cells.h"
#include "mesh_import/formats/vtu_data.h"
#include <signorini/parameters/raw.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace Signorini
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    /// @return an attribute of an XML element; empty if it has none.
    std::string
    attribute(const Tree &tree, const std::string &name)
    {
      return tree.get<std::string>("<xmlattr>." + name, "");
    }



    /// @return a child of an XML element, or an empty tree. The name is not a temporary string,
    /// because the result would seem to refer to it.
    const Tree &
    child(const Tree &tree, const char *name)
    {
      static const Tree empty;
      const auto        found = tree.find(name);
      return found == tree.not_found() ? empty : found->second;
    }



    /// Reads the XML with Boost's property tree, after raw binary data have been cut off; arrays
    /// are decoded when they are needed.
    class VTUReader
    {
    public:
      /// Read the file. Throws SceneError if it is not valid XML.
      explicit VTUReader(const std::string &file_name)
        : file_name(file_name)
      {
        std::ifstream in(file_name, std::ios::binary);
        std::string   text(std::istreambuf_iterator<char>(in), {});
        cut_raw_data(text);
        reject_depth(text);
        std::istringstream xml(text);
        try
          {
            boost::property_tree::read_xml(xml, document);
          }
        catch (const boost::property_tree::xml_parser_error &error)
          {
            fail("is no XML file: " + error.message() + " in line " + std::to_string(error.line()));
          }
      }

      /// Interpret the file, which must be little-endian and have one piece.
      /// @return the mesh, which is moved out of the reader
      MeshFile
      read()
      {
        const auto root = document.get_child_optional("VTKFile");
        if (!root || attribute(*root, "type") != "UnstructuredGrid")
          fail("is no unstructured grid of VTK: <VTKFile type=\"UnstructuredGrid\">");
        if (attribute(*root, "byte_order") == "BigEndian")
          fail("is big-endian; save it as text");
        try
          {
            data =
              VtuData(attribute(*root, "header_type") == "UInt64", attribute(*root, "compressor"));
            const Tree &grid = child(*root, "UnstructuredGrid");
            if (grid.count("Piece") != 1)
              throw SceneError("has " + std::to_string(grid.count("Piece")) +
                               " pieces; save it in one");
            read_piece(child(grid, "Piece"));
          }
        catch (const SceneError &error)
          {
            fail(error.what());
          }
        return std::move(file);
      }

    private:
      [[noreturn]] void
      fail(const std::string &what) const
      {
        throw SceneError("mesh file '" + file_name + "' " + what);
      }

      /// Throws SceneError if elements are nested too deeply: the XML reader is recursive, and
      /// would exhaust the stack.
      void
      reject_depth(const std::string &text) const
      {
        constexpr int deepest = 1000;
        int           depth   = 0;
        for (std::size_t i = 0; i + 1 < text.size(); ++i)
          {
            const char next = text[i + 1];
            if ((text[i] == '<' && next == '/') || (text[i] == '/' && next == '>'))
              --depth;
            else if (text[i] == '<' && next != '!' && next != '?' && ++depth > deepest)
              fail("has elements within each other more than " + std::to_string(deepest) + " deep");
          }
      }

      /// Read points, cells, scalar fields at points, and groups from arrays of integers at cells.
      void
      read_piece(const Tree &piece)
      {
        for (const auto &[tag, array] : child(piece, "Points"))
          if (tag == "DataArray")
            {
              const std::vector<double> xs = numbers<double>(array);
              if (xs.size() % 3 != 0)
                throw SceneError("has points that do not have three coordinates");
              for (std::size_t i = 0; i + 2 < xs.size(); i += 3)
                file.nodes.emplace_back(xs[i], xs[i + 1], xs[i + 2]);
            }
        read_cells(child(piece, "Cells"));
        if (file.elements.empty())
          throw SceneError("has no cells");
        read_fields(child(piece, "PointData"));
        for (const auto &[tag, array] : child(piece, "CellData"))
          if (tag == "DataArray" && is_integer(attribute(array, "type")) &&
              array.get<unsigned int>("<xmlattr>.NumberOfComponents", 1) == 1)
            {
              const std::vector<long> values = numbers<long>(array);
              if (values.size() == file.elements.size())
                add_vtk_groups(file, attribute(array, "Name"), values);
            }
      }

      /// Read the arrays at points with one component as fields.
      void
      read_fields(const Tree &point_data)
      {
        for (const auto &[tag, array] : point_data)
          if (const std::string type = attribute(array, "type");
              tag == "DataArray" && (is_integer(type) || type.find("Float") == 0) &&
              array.get<unsigned int>("<xmlattr>.NumberOfComponents", 1) == 1)
            {
              const std::vector<double> values = numbers<double>(array);
              if (values.size() == file.nodes.size())
                file.fields[attribute(array, "Name")] = values;
            }
      }

      /// Read the arrays `connectivity`, `offsets` (ends of the cells) and `types`.
      void
      read_cells(const Tree &cells)
      {
        std::vector<long> points, types, offsets{0};
        for (const auto &[tag, array] : cells)
          if (tag == "DataArray")
            {
              const std::string       name   = attribute(array, "Name");
              const std::vector<long> values = numbers<long>(array);
              if (name == "connectivity")
                points = values;
              else if (name == "types")
                types = values;
              else if (name == "offsets")
                offsets.insert(offsets.end(), values.begin(), values.end());
            }
        add_vtk_cells(file, types, offsets, points);
      }

      /// @return whether a type of VTK is an integer: Int32, UInt8 and so on.
      static bool
      is_integer(const std::string &type)
      {
        return type.find("Int") != std::string::npos;
      }

      /// @return the numbers of an array, in whichever format it is stored.
      template <typename T>
      std::vector<T>
      numbers(const Tree &array) const
      {
        const std::string format = attribute(array, "format"), type = attribute(array, "type");
        if (format == "ascii")
          {
            std::istringstream words(array.data());
            std::vector<T>     result;
            for (T value; words >> value;)
              result.push_back(value);
            words.clear();
            if (std::string rest; words >> rest)
              throw SceneError("has in the array '" + attribute(array, "Name") + "' behind " +
                               std::to_string(result.size()) + " numbers '" + rest.substr(0, 40) +
                               "', which is none");
            return result;
          }
        const std::string bytes = bytes_of(array, format);
        if (type == "Float64")
          return bytes_as<T, double>(bytes);
        if (type == "Float32")
          return bytes_as<T, float>(bytes);
        if (type == "Int64")
          return bytes_as<T, std::int64_t>(bytes);
        if (type == "UInt64")
          return bytes_as<T, std::uint64_t>(bytes);
        if (type == "Int32")
          return bytes_as<T, std::int32_t>(bytes);
        if (type == "UInt32")
          return bytes_as<T, std::uint32_t>(bytes);
        if (type == "Int16")
          return bytes_as<T, std::int16_t>(bytes);
        if (type == "UInt16")
          return bytes_as<T, std::uint16_t>(bytes);
        if (type == "Int8")
          return bytes_as<T, std::int8_t>(bytes);
        if (type == "UInt8")
          return bytes_as<T, std::uint8_t>(bytes);
        throw SceneError("has numbers of the unknown type '" + type + "'");
      }

      /// @return the numbers in some bytes, converted from the (little-endian) type in which they
      /// are stored.
      template <typename T, typename Stored>
      static std::vector<T>
      bytes_as(const std::string &bytes)
      {
        std::vector<T> result;
        for (std::size_t i = 0; i + sizeof(Stored) <= bytes.size(); i += sizeof(Stored))
          {
            Stored value;
            std::memcpy(&value, bytes.data() + i, sizeof(Stored));
            result.push_back(static_cast<T>(value));
          }
        return result;
      }

      /// @return the bytes of an array in base64 or in the raw data at the end of the file.
      std::string
      bytes_of(const Tree &array, const std::string &format) const
      {
        if (format == "binary")
          return data.from_base64(array.data());
        if (format != "appended" || raw.empty())
          throw SceneError("has arrays that are " + format + " in base64; save it as text");
        return data.from_raw(raw, array.get<std::size_t>("<xmlattr>.offset", 0));
      }

      /// Move raw data, which follow the first underscore of AppendedData and are not XML, to
      /// `raw`.
      void
      cut_raw_data(std::string &text)
      {
        const auto begin = text.find("<AppendedData");
        const auto end   = text.find('>', begin);
        if (begin == std::string::npos || end == std::string::npos ||
            text.substr(begin, end - begin).find("raw") == std::string::npos)
          return;
        raw = text.substr(std::min(text.find('_', end), text.size() - 1) + 1);
        text.erase(begin);
        text += "</VTKFile>";
      }

      const std::string file_name;
      Tree              document;
      MeshFile          file;
      VtuData           data;
      /// The raw data at the end of the file.
      std::string raw;
    };
  } // namespace



  MeshFile
  read_vtu(const std::string &file_name)
  {
    return VTUReader(file_name).read();
  }
} // namespace Signorini
