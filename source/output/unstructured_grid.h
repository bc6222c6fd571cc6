// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace Signorini
{
  /// A mesh with fields for a VTU file, whose cells share points (The VTK User's Guide, 11th ed.,
  /// 2010, "XML file formats").
  struct UnstructuredGrid
  {
    /// The values of all points or cells, one after the other.
    template <typename Number>
    struct Field
    {
      std::string         name;
      unsigned int        n_components;
      std::vector<Number> values;
    };

    std::vector<float>        points;       ///< three coordinates each
    std::vector<std::int32_t> connectivity; ///< the points of all cells, in the order of VTK
    std::vector<std::int32_t> offsets;      ///< for each cell, the end of its points
    std::vector<std::uint8_t> types;        ///< of the cells, by VTK

    std::vector<Field<float>>        of_points;
    std::vector<Field<std::int32_t>> of_cells;

    /// Write the element Piece.
    void
    write(std::ostream &out) const;

    /// The file that has the pieces of several ranks with these fields. @param files their names
    std::string
    record(const std::vector<std::string> &files) const;
  };
} // namespace Signorini
