// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/vtu_data.h"

#include <signorini/parameters/raw.h>

#include <deal.II/base/utilities.h>

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return a text without white space.
    std::string
    without_blanks(std::string text)
    {
      text.erase(std::remove_if(text.begin(),
                                text.end(),
                                [](const unsigned char c) { return std::isspace(c); }),
                 text.end());
      return text;
    }



    /// @return the bytes of a text in base64. Throws SceneError.
    std::string
    decoded(const std::string &base64)
    {
      try
        {
          const std::vector<unsigned char> bytes = Utilities::decode_base64(base64);
          return {bytes.begin(), bytes.end()};
        }
      catch (const std::exception &)
        {
          throw SceneError("has an array that is not base64, as it says");
        }
    }



    /// @return the number of characters of n bytes in base64, where three bytes become four
    /// characters.
    std::size_t
    in_base64(const std::size_t n_bytes)
    {
      return 4 * ((n_bytes + 2) / 3);
    }



    /// @return `size` bytes from `begin` on. Throws SceneError if there are not as many.
    std::string
    part_of(const std::string &bytes, const std::size_t begin, const std::size_t size)
    {
      if (begin > bytes.size() || size > bytes.size() - begin)
        throw SceneError("has an array that ends too early");
      return bytes.substr(begin, size);
    }



    /// @return all bytes from `begin` on. Throws SceneError if there are none.
    std::string
    rest_of(const std::string &bytes, const std::size_t begin)
    {
      if (begin > bytes.size())
        throw SceneError("has an array that ends too early");
      return bytes.substr(begin);
    }



    /// @return uncompressed bytes. A size that zlib cannot reach from so few bytes is rejected
    /// before memory is allocated.
    std::string
    inflated(const std::string &packed, const std::size_t size)
    {
      constexpr std::size_t largest_ratio = 1032; // of zlib
      if (size / largest_ratio > packed.size())
        throw SceneError("has a compressed array that says that it is larger than it can be");
      std::string bytes(size, '\0');
      uLongf      n = size;
      if (uncompress(reinterpret_cast<Bytef *>(&bytes[0]),
                     &n,
                     reinterpret_cast<const Bytef *>(packed.data()),
                     packed.size()) != Z_OK)
        throw SceneError("has a compressed array that cannot be unpacked");
      return bytes.substr(0, n);
    }
  } // namespace



  VtuData::VtuData(const bool wide_header, const std::string &compressor)
    : width(wide_header ? 8 : 4)
    , compressed(!compressor.empty())
  {
    if (compressed && compressor != "vtkZLibDataCompressor")
      throw SceneError("is compressed by " + compressor + "; save it with zlib, or as text");
  }



  std::size_t
  VtuData::number(const std::string &header, const std::size_t i) const
  {
    const std::string bytes = part_of(header, i * width, width);
    std::uint64_t     value = 0;
    std::memcpy(&value, bytes.data(), width); // both are little-endian
    return value;
  }



  std::size_t
  VtuData::header_size(const std::string &beginning) const
  {
    return compressed ? (3 + number(beginning, 0)) * width : width;
  }



  std::string
  VtuData::from_base64(const std::string &text) const
  {
    const std::string characters = without_blanks(text);
    if (!compressed)
      {
        const std::string bytes = decoded(characters);
        return unpacked(part_of(bytes, 0, width), rest_of(bytes, width));
      }
    // The header is encoded on its own.
    const std::string beginning = decoded(part_of(characters, 0, in_base64(3 * width)));
    const std::size_t size      = in_base64(header_size(beginning));
    return unpacked(decoded(part_of(characters, 0, size)), decoded(rest_of(characters, size)));
  }



  std::string
  VtuData::from_raw(const std::string &bytes, const std::size_t offset) const
  {
    const std::size_t size = header_size(part_of(bytes, offset, width));
    return unpacked(part_of(bytes, offset, size), rest_of(bytes, offset + size));
  }



  // All blocks have the same size, except for the last one if its size is not zero.
  std::string
  VtuData::unpacked(const std::string &header, const std::string &data) const
  {
    if (!compressed)
      return part_of(data, 0, number(header, 0));
    const std::size_t n = number(header, 0), size = number(header, 1), last = number(header, 2);
    std::string       result;
    for (std::size_t block = 0, at = 0; block < n; ++block)
      {
        const std::size_t packed = number(header, 3 + block);
        const bool        is_cut = block + 1 == n && last > 0;
        result += inflated(part_of(data, at, packed), is_cut ? last : size);
        at += packed;
      }
    return result;
  }
} // namespace Signorini
