// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <istream>
#include <string>

namespace Signorini
{
  /// Where reading from a text file has failed, for messages: ", line 12: nan"; empty where that is
  /// the end of the file.
  std::string
  position_of_failure(std::istream &in, const std::string &file_name);
} // namespace Signorini
