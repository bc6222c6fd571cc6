// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace Signorini
{
  /// How the arrays of an XML file of VTK are packed, and how to unpack them. The numbers are
  /// little-endian. In front of each array stands a header: its number of bytes, or if it is
  /// compressed the number of blocks, the size of a block, the size of the last block (0: as the
  /// others), and the compressed size of each block.
  class VtuData
  {
  public:
    /// @param wide_header numbers in headers have 8 bytes, not 4
    /// @param compressor as the file names it; empty: none. Throws SceneError, without the file's
    /// name, if it is not zlib.
    VtuData(bool wide_header = false, const std::string &compressor = "");

    /// The bytes of an array that stands in the file in base64; blanks do not matter. All throw
    /// SceneError, without the file's name, if the array ends too early or cannot be unpacked.
    std::string
    from_base64(const std::string &text) const;

    /// The bytes of an array that begins at `offset` of raw data.
    std::string
    from_raw(const std::string &bytes, std::size_t offset) const;

  private:
    std::size_t
    number(const std::string &header, std::size_t i) const;
    std::size_t
    header_size(const std::string &beginning) const;
    std::string
    unpacked(const std::string &header, const std::string &data) const;

    unsigned int width; ///< of numbers in headers, in bytes
    bool         compressed;
  };
} // namespace Signorini
