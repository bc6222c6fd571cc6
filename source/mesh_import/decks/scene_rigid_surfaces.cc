// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/scene_text.h"
#include "mesh_import/decks/scene_writer.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

// Rigid bodies of surface elements (R3D3, R3D4, shells): obstacles whose surface is in the deck.

namespace Signorini
{
  /// @return the masters, surfaces of the deck, whose faces are on nodes of a rigid body that are
  /// on no solid.
  std::vector<std::string>
  SceneWriter::masters_on(const DeckModel::Coupling &one) const
  {
    if (!one.analytical_surface.empty())
      {
        const std::string name = upper_case(one.analytical_surface);
        return std::any_of(model.pairs.begin(),
                           model.pairs.end(),
                           [&](const auto &pair) { return upper_case(pair.master) == name; }) ?
                 std::vector<std::string>{one.analytical_surface} :
                 std::vector<std::string>();
      }
    if (one.is_distributing || one.is_surface || dim != 3)
      return {};
    const auto is_on_a_solid = [&](const unsigned int node) {
      return std::any_of(all.begin(), all.end(), [&](const Body &body) {
        return body.has_node[node];
      });
    };
    std::vector<std::string> result;
    for (const DeckModel::Pair &pair : model.pairs)
      {
        const auto faces = model.faces_of(pair.master);
        const bool is_its =
          !faces.empty() && std::all_of(faces.begin(), faces.end(), [&](auto &face) {
            return std::all_of(face.begin(), face.end(), [&](const unsigned int node) {
              return std::binary_search(one.nodes.begin(), one.nodes.end(), node) &&
                     !is_on_a_solid(node);
            });
          });
        if (is_its && std::count(result.begin(), result.end(), pair.master) == 0)
          result.push_back(pair.master);
      }
    return result;
  }



  /// Add the obstacles of a rigid body to the items, if it has masters. Two obstacles that a force
  /// drives would move on their own.
  /// @return whether it has
  bool
  SceneWriter::add_rigid_surfaces(const DeckModel::Coupling &one,
                                  const Reference           &at,
                                  SetNames                  &names,
                                  std::vector<SceneItem>    &items)
  {
    const std::vector<std::string> masters = masters_on(one);
    const auto                     is_free = [](const std::vector<std::string> &motion) {
      return std::count(motion.begin(), motion.end(), "free") > 0;
    };
    if (masters.size() > 1 && (is_free(at.motion) || is_free(at.rotation)))
      {
        model.skip_item(one.keyword + " of '" + one.name +
                          "' with several surfaces in contact, whose motion is not prescribed",
                        "",
                        "support");
        model.lacks_supports = true;
        return false;
      }
    for (const std::string &master : masters)
      {
        SceneItem  item{names.make_unique_name(as_name(master)), {}};
        const auto profile = model.analytical_surfaces.find(upper_case(one.analytical_surface));
        if (profile != model.analytical_surfaces.end())
          item.keys = profile->second;
        else
          item.keys = {{"Shape", "STL"}, {"File", file}, {"Surface", as_name(master)}};
        item.keys.insert(item.keys.end(),
                         {{"Reference point", join(at.place)},
                          {"Displacement", join(at.motion, "; ")},
                          {"Rotation", join(at.rotation, "; ")}});
        if (is_free(at.motion))
          item.keys.emplace_back("Force", join(at.force, "; "));
        if (is_free(at.rotation))
          item.keys.emplace_back("Moment", join(at.moment, "; "));
        rigid_masters[upper_case(master)] = item.name;
        items.push_back(item);
      }
    return !masters.empty();
  }
} // namespace Signorini
