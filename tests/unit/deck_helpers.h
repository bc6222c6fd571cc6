// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/decks/import_deck.h"
#include "mesh_import/mesh_file.h"
#include <signorini/scene/scene.h>

#include <sstream>
#include <string>
#include <utility>

#include "mesh_helpers.h"

namespace DeckTests
{
  using namespace Signorini;

  /// The group of a name; throws SceneError if there is none.
  inline const MeshFile::Group &
  group(const MeshFile &file, const std::string &name)
  {
    for (const auto &one : file.groups)
      if (one.name == name)
        return one;
    throw SceneError("there is no group " + name);
  }

  /// The scene that a deck describes, and the messages.
  inline std::pair<std::string, std::string>
  imported(const std::string &file)
  {
    std::ostringstream scene, messages;
    import_deck(file, scene, messages);
    return {scene.str(), messages.str()};
  }

  /// All that is checked before meshes are made.
  template <int dim>
  Scene<dim>
  checked(const std::string &text)
  {
    const MeshTests::TemporaryFile file(text, ".prm");
    RawSection                     raw = read_raw(file.path);
    Scene<dim>                     scene;
    Section                        section(raw);
    scene.declare(section);
    section.close();
    scene.read_files("");
    scene.check();
    return scene;
  }
} // namespace DeckTests
