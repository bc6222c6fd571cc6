// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace Signorini
{
  /// Decodes the arrays of an XML file of VTK, with little-endian numbers. Each array has a header:
  /// its number of bytes, or if it is compressed the number of blocks, the size of a block, the
  /// size of the last block (0: as the others), and the compressed size of each block. All
  /// functions throw SceneError, without the file's name, if an array ends too early or cannot be
  /// decompressed.
  class VtuData
  {
  public:
    /// Throws SceneError, without the file's name, if the compressor is not zlib.
    /// @param wide_header whether numbers in headers have 8 bytes, not 4
    /// @param compressor as the file names it; empty: none
    VtuData(bool wide_header = false, const std::string &compressor = "");

    /// @return the bytes of an array that is written in base64, where white space is ignored.
    /// @param text the contents of the XML element
    std::string
    from_base64(const std::string &text) const;

    /// @return the bytes of an array in raw data.
    /// @param bytes all raw data
    /// @param offset at which the header of the array begins
    std::string
    from_raw(const std::string &bytes, std::size_t offset) const;

  private:
    /// @return number i of a header.
    std::size_t
    number(const std::string &header, std::size_t i) const;
    /// @return the number of bytes of a header, of which the beginning is known.
    std::size_t
    header_size(const std::string &beginning) const;
    /// @return the bytes of an array.
    std::string
    unpacked(const std::string &header, const std::string &data) const;

    /// Number of bytes of each number in headers.
    unsigned int width;
    bool         compressed;
  };
} // namespace Signorini
