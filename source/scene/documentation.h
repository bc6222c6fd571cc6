// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace Signorini
{
  /// Print all sections and keys of both dimensions, which is the page doc/guide/reference.md.
  /// @param out the stream
  void
  print_reference(std::ostream &out);

  /// A request for a template.
  struct TemplateRequest
  {
    /// 2 or 3; 0: 2, or 3 if the words require it.
    unsigned int dimension = 0;
    /// Names of generators, shapes, methods, preconditioners, sections.
    std::vector<std::string> words;
    /// Values of keys, "Section/Key=value".
    std::vector<std::string> overrides;
  };

  /// Print a complete scene with defaults and one sentence about each key; with words only the
  /// sections in which they are chosen. Throws SceneError for unknown words.
  /// @param request what is printed
  /// @param out the stream
  void
  print_template(const TemplateRequest &request, std::ostream &out);
} // namespace Signorini
