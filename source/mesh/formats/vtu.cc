#include <signorini/mesh/formats/vtk_cells.h>
#include <signorini/mesh/formats/vtu.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/utilities.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Tree = boost::property_tree::ptree;

    std::string
    attribute(const Tree &tree, const std::string &name)
    {
      return tree.get<std::string>("<xmlattr>." + name, "");
    }



    class Reader
    {
    public:
      explicit Reader(const std::string &file_name)
        : file_name(file_name)
      {
        try
          {
            boost::property_tree::read_xml(file_name, document);
          }
        catch (const boost::property_tree::xml_parser_error &error)
          {
            fail("is no XML file, or has its data appended in raw form: " + error.message() +
                 " in line " + std::to_string(error.line()) + "; save it as text");
          }
      }

      MeshFile
      read()
      {
        const auto root = document.get_child_optional("VTKFile");
        if (!root || attribute(*root, "type") != "UnstructuredGrid")
          fail("is no unstructured grid of VTK: <VTKFile type=\"UnstructuredGrid\">");
        if (attribute(*root, "byte_order") == "BigEndian")
          fail("is big-endian; save it as text");
        wide_header     = attribute(*root, "header_type") == "UInt64";
        compressor      = attribute(*root, "compressor");
        const Tree grid = root->get_child("UnstructuredGrid", {});
        if (grid.count("Piece") != 1)
          fail("has " + std::to_string(grid.count("Piece")) + " pieces; save it in one");
        read_piece(grid.get_child("Piece"));
        return std::move(file);
      }

    private:
      [[noreturn]] void
      fail(const std::string &what) const
      {
        throw SceneError("mesh file '" + file_name + "' " + what);
      }

      void
      read_piece(const Tree &piece)
      {
        for (const auto &[tag, array] : piece.get_child("Points", {}))
          if (tag == "DataArray")
            {
              const std::vector<double> xs = numbers<double>(array);
              for (std::size_t i = 0; i + 2 < xs.size(); i += 3)
                file.nodes.emplace_back(xs[i], xs[i + 1], xs[i + 2]);
            }
        read_cells(piece.get_child("Cells", {}));
        if (file.elements.empty())
          fail("has no cells");
        for (const auto &[tag, array] : piece.get_child("CellData", {}))
          if (tag == "DataArray" && is_integer(attribute(array, "type")) &&
              array.get<unsigned int>("<xmlattr>.NumberOfComponents", 1) == 1)
            {
              const std::vector<long> values = numbers<long>(array);
              if (values.size() == file.elements.size())
                add_vtk_groups(file, attribute(array, "Name"), values);
            }
      }

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
        try
          {
            add_vtk_cells(file, types, offsets, points);
          }
        catch (const SceneError &error)
          {
            fail(error.what());
          }
      }

      static bool
      is_integer(const std::string &type)
      {
        return type.find("Int") != std::string::npos;
      }

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
            return result;
          }
        if (format != "binary")
          fail("has data that are " + format +
               "; save it as text, or in binary form within the "
               "arrays");
        const std::string bytes = decoded(trim_all(array.data()));
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
        fail("has numbers of the unknown type '" + type + "'");
      }

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

      static std::string
      trim_all(const std::string &text)
      {
        std::string result;
        for (const char c : text)
          if (!std::isspace(static_cast<unsigned char>(c)))
            result += c;
        return result;
      }

      std::size_t
      header_size() const
      {
        return wide_header ? 8 : 4;
      }

      /// The i-th number of a header.
      std::size_t
      header(const std::string &bytes, const std::size_t i) const
      {
        if (bytes.size() < (i + 1) * header_size())
          fail("has a binary array that ends too early");
        const std::string one = bytes.substr(i * header_size(), header_size());
        return wide_header ? bytes_as<std::size_t, std::uint64_t>(one)[0] :
                             bytes_as<std::size_t, std::uint32_t>(one)[0];
      }

      static std::string
      from_base64(const std::string &text)
      {
        const std::vector<unsigned char> bytes = Utilities::decode_base64(text);
        return {bytes.begin(), bytes.end()};
      }

      /// The header is the number of bytes, or if compressed: number of blocks, size of a block,
      /// size of the last block if it is smaller, compressed size of each block. A compressed
      /// header is encoded on its own.
      std::string
      decoded(const std::string &text) const
      {
        if (compressor.empty())
          {
            const std::string bytes = from_base64(text);
            return bytes.substr(header_size(), header(bytes, 0));
          }
        if (compressor != "vtkZLibDataCompressor")
          fail("is compressed by " + compressor + "; save it with zlib, or as text");
        const std::size_t n_blocks = header(from_base64(text.substr(0, 4 * header_size())), 0);
        const std::size_t n_header = 4 * (((3 + n_blocks) * header_size() + 2) / 3);
        const std::string head     = from_base64(text.substr(0, n_header));
        const std::string data     = from_base64(text.substr(std::min(n_header, text.size())));
        std::string       result;
        for (std::size_t block = 0, at = 0; block < n_blocks; ++block)
          {
            const bool        is_last = block + 1 == n_blocks && header(head, 2) > 0;
            const std::size_t packed  = header(head, 3 + block);
            if (at + packed > data.size())
              fail("has a binary array that ends too early");
            result += inflated(data.substr(at, packed), header(head, is_last ? 2 : 1));
            at += packed;
          }
        return result;
      }

      std::string
      inflated(const std::string &packed, const std::size_t size) const
      {
        std::string bytes(size, '\0');
        uLongf      n = size;
        if (uncompress(reinterpret_cast<Bytef *>(&bytes[0]),
                       &n,
                       reinterpret_cast<const Bytef *>(packed.data()),
                       packed.size()) != Z_OK)
          fail("has a compressed array that cannot be unpacked");
        return bytes.substr(0, n);
      }

      const std::string file_name;
      Tree              document;
      MeshFile          file;
      bool              wide_header = false;
      std::string       compressor;
    };
  } // namespace



  MeshFile
  read_vtu(const std::string &file_name)
  {
    return Reader(file_name).read();
  }
} // namespace Signorini
