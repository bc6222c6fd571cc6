// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/file_position.h"

#include <algorithm>
#include <fstream>

namespace Signorini
{
  // The lines before the position are counted only now, when an error is reported.
  std::string
  position_of_failure(std::istream &in, const std::string &file_name)
  {
    in.clear();
    const std::streamoff at = in.tellg();
    std::string          word;
    if (at < 0 || !(in >> word))
      return "";
    std::ifstream again(file_name, std::ios::binary);
    std::string   before(at, ' ');
    again.read(&before[0], at);
    return ", line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')) + ": " +
           word.substr(0, 40);
  }
} // namespace Signorini
