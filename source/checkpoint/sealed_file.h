// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace Signorini
{
  /// A file that is not what was written: cut off, changed, or of another format.
  class Damaged : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// Writes a file whose first line says its length and its checksum, and waits until the disk has
  /// it. Throws OutputError.
  void
  write_sealed(const std::string &path, const std::string &content);

  /// What write_sealed() wrote. Throws Damaged, saying file and reason.
  std::string
  read_sealed(const std::string &path);

  /// The checksum of the first line (CRC-32), by which other files refer to this one.
  std::uint32_t
  checksum(const std::string &content);

  /// Waits until the disk knows the names in that folder. Throws OutputError.
  void
  sync_folder(const std::string &path);
} // namespace Signorini
