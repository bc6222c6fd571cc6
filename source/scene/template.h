// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace Signorini
{
  /// What is to be written of the example scene.
  struct TemplateRequest
  {
    unsigned int             dimension = 0; ///< 0: 2, or 3 if the words say so
    std::vector<std::string> words;     ///< generators, shapes, methods, preconditioners, sections
    std::vector<std::string> overrides; ///< "Section/Key=value"
  };

  /// A complete scene with defaults and one sentence on each key; with words only those sections in
  /// which they are chosen. Throws SceneError for a word that means nothing.
  void
  print_template(const TemplateRequest &request, std::ostream &out);
} // namespace Signorini
