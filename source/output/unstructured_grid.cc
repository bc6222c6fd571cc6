// SPDX-License-Identifier: Apache-2.0
#include "output/unstructured_grid.h"

#include <deal.II/base/utilities.h>

#include <zlib.h>

#include <array>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace Signorini
{
  namespace
  {
    using Bytes = std::vector<unsigned char>;

    template <typename Number>
    constexpr const char *
    type_name()
    {
      if (std::is_same<Number, float>())
        return "Float32";
      return sizeof(Number) == 1 ? "UInt8" : "Int32";
    }

    template <typename Number>
    Bytes
    bytes_of(const Number *const values, const std::size_t size)
    {
      const auto *const first = reinterpret_cast<const unsigned char *>(values);
      return Bytes(first, first + size * sizeof(Number));
    }

    /// One block, compressed fast: the best compression would take longer than the solution of
    /// small scenes.
    Bytes
    compressed(const Bytes &bytes)
    {
      uLongf size = compressBound(bytes.size());
      Bytes  result(size);
      if (compress2(result.data(), &size, bytes.data(), bytes.size(), Z_BEST_SPEED) != Z_OK)
        throw std::runtime_error("zlib cannot compress a field");
      result.resize(size);
      return result;
    }

    /// The attributes of an array. @param name may be empty, as that of positions
    template <typename Number>
    std::string
    attributes(const std::string &name, const unsigned int n_components)
    {
      return std::string("type=\"") + type_name<Number>() + "\"" +
             (name.empty() ? "" : " Name=\"" + name + "\"") + " NumberOfComponents=\"" +
             std::to_string(n_components) + "\"";
    }

    /// An array in base64: number of blocks, size of the first block and of the last, and their
    /// compressed sizes, then the blocks.
    template <typename Number>
    void
    write_array(std::ostream              &out,
                const std::string         &name,
                const unsigned int         n_components,
                const std::vector<Number> &values)
    {
      const Bytes plain = bytes_of(values.data(), values.size()), packed = compressed(plain);
      const auto  size = static_cast<std::uint32_t>(plain.size());
      const std::array<std::uint32_t, 4> header{
        {1, size, size, static_cast<std::uint32_t>(packed.size())}};
      out << "<DataArray " << attributes<Number>(name, n_components) << " format=\"binary\">\n"
          << dealii::Utilities::encode_base64(bytes_of(header.data(), header.size()))
          << dealii::Utilities::encode_base64(packed) << "\n</DataArray>\n";
    }

    template <typename Number>
    void
    write_fields(std::ostream                                       &out,
                 const std::string                                  &section,
                 const std::vector<UnstructuredGrid::Field<Number>> &fields)
    {
      out << '<' << section << ">\n";
      for (const auto &field : fields)
        write_array(out, field.name, field.n_components, field.values);
      out << "</" << section << ">\n";
    }

    template <typename Number>
    void
    write_names(std::ostream                                       &out,
                const std::string                                  &section,
                const std::vector<UnstructuredGrid::Field<Number>> &fields)
    {
      out << '<' << section << ">\n";
      for (const auto &field : fields)
        out << "<PDataArray " << attributes<Number>(field.name, field.n_components) << "/>\n";
      out << "</" << section << ">\n";
    }
  } // namespace



  void
  UnstructuredGrid::write(std::ostream &out) const
  {
    out << "<Piece NumberOfPoints=\"" << points.size() / 3 << "\" NumberOfCells=\"" << types.size()
        << "\">\n<Points>\n";
    write_array(out, "", 3, points);
    out << "</Points>\n<Cells>\n";
    write_array(out, "connectivity", 1, connectivity);
    write_array(out, "offsets", 1, offsets);
    write_array(out, "types", 1, types);
    out << "</Cells>\n";
    write_fields(out, "PointData", of_points);
    write_fields(out, "CellData", of_cells);
    out << "</Piece>\n";
  }



  std::string
  UnstructuredGrid::record(const std::vector<std::string> &files) const
  {
    std::ostringstream out;
    out
      << "<?xml version=\"1.0\"?>\n<!-- written by Signorini -->\n<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<PUnstructuredGrid GhostLevel=\"0\">\n";
    write_names(out, "PPointData", of_points);
    write_names(out, "PCellData", of_cells);
    out << "<PPoints>\n<PDataArray " << attributes<float>("", 3) << "/>\n</PPoints>\n";
    for (const std::string &file : files)
      out << "<Piece Source=\"" << file << "\"/>\n";
    out << "</PUnstructuredGrid>\n</VTKFile>\n";
    return out.str();
  }
} // namespace Signorini
