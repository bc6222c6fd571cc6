// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace Signorini
{
  /// A file that differs from what was written: truncated, changed, or of another format.
  class Damaged : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// Write a file whose first line contains the length and checksum of the rest, and wait until it
  /// is on the disk. Throws OutputError.
  /// @param path of the file
  /// @param content any bytes
  void
  write_sealed(const std::string &path, const std::string &content);

  /// @return the content of a file of write_sealed(). Throws Damaged with file and reason.
  /// @param path of the file
  std::string
  read_sealed(const std::string &path);

  /// @return the CRC-32 checksum that write_sealed() stores, by which other files refer to this
  /// one.
  /// @param content any bytes
  std::uint32_t
  checksum(const std::string &content);

  /// Wait until the names in a folder are on the disk. Throws OutputError.
  /// @param path of the folder
  void
  sync_folder(const std::string &path);
} // namespace Signorini
