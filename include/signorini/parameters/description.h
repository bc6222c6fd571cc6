// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <vector>

namespace Signorini
{
  /// A key of a scene, as documentation shows it.
  struct KeyDescription
  {
    std::string              key, type, value, help, range;
    std::vector<std::string> choices;
    bool                     is_required = false;
  };

  /// A name that scenes may still use for one release, and the one that it has now.
  struct FormerName
  {
    enum class Kind
    {
      key,
      section,
      choice
    };

    Kind        kind;
    std::string former, now;
    std::string key; ///< of a choice
  };

  /// A section with all that may stand in it. Sections that the user names are there once, with the
  /// name NAME.
  struct SectionDescription
  {
    std::string                    name, help;
    std::vector<KeyDescription>    keys;
    std::deque<SectionDescription> sections;
    std::vector<FormerName>        former_names = {};
  };
} // namespace Signorini
