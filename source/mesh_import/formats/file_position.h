// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <istream>
#include <string>

namespace Signorini
{
  /// @return where reading from a text file has failed, for messages: ", line 12: nan"; empty if
  /// that is the end of the file.
  /// @param in the stream in its failed state, which is cleared
  /// @param file_name the file that it reads
  std::string
  position_of_failure(std::istream &in, const std::string &file_name);
} // namespace Signorini
