// SPDX-License-Identifier: Apache-2.0
#include "scene/former_entries.h"

#include <signorini/parameters/raw.h>

#include <nlohmann/json.hpp>

namespace Signorini
{
  using Json = nlohmann::ordered_json;

  const std::vector<FormerEntry> &
  former_entries()
  {
    static const std::vector<FormerEntry> list = [] {
      std::vector<FormerEntry> all = {{"", "left_out", "skipped"},
                                      {"", "shares_of_ranks", "partition"},
                                      {"linear_reference", "R", "time_ratio"},
                                      {"linear_reference", "W", "cycle_ratio"},
                                      {"preflight", "left_out", "skipped"},
                                      {"preflight",
                                       "held_by_contact_alone",
                                       "modes_constrained_by_contact"},
                                      {"load_steps/*", "definite", "tangent_positive_definite"},
                                      {"load_steps/*", "jump", "snap_through_ratio"},
                                      {"load_steps/*", "held_motions", "stabilised_modes"},
                                      {"load_steps/*/errors", "bulk_stress", "volumetric_stress"},
                                      {"load_steps/*/pairs/*", "contact_along", "contact_extents"},
                                      {"verdict/checks/*", "what", "message"},
                                      {"verdict/checks/*", "cure", "advice"}};
      for (const char *accuracy : {"accuracy", "load_steps/*/accuracy", "cycles/*/accuracy"})
        {
          const std::string quantity = std::string(accuracy) + "/quantities/*";
          all.push_back({quantity, "bar", "error_bound"});
          all.push_back({quantity, "relative_bar", "relative_error_bound"});
          all.push_back({quantity, "most", "cauchy_schwarz_bound"});
          all.push_back({quantity + "/extrapolated", "bar", "error_bound"});
        }
      return all;
    }();
    return list;
  }



  const std::vector<std::pair<std::string, std::string>> &
  former_checks()
  {
    static const std::vector<std::pair<std::string, std::string>> list = {
      {"motion / size of the scene", "displacement / model size"},
      {"something acts", "loading"},
      {"acts", "inactive pair"},
      {"overlap without pressure / face", "penetration without pressure / face size"},
      {"force / normal force", "contact force / normal force"},
      {"faces across the contact zone", "faces across the contact area"},
      {"contact / faces in contact", "contact area / area of contact faces"},
      {"sharpness of the peak", "pressure peak resolution"},
      {"motion of the surfaces / size", "surface motion / model size"},
      {"overlap / face", "initial overlap / face size"},
      {"rounding / pressure", "penalty round-off / pressure"},
      {"angle from opposite", "normal misalignment"},
      {"facets", "faceting error"},
      {"alternating pressure", "pressure oscillation"},
      {"sides", "slave choice"},
      {"partners off nodes", "non-matching nodes"},
      {"error bar", "error bound"},
      {"load steps without bars", "load steps without error bounds"},
      {"load by two rules", "load quadrature error"},
      {"balance of forces", "force balance"},
      {"balance of moments", "moment balance"},
      {"locking", "volumetric locking"},
      {"definiteness", "tangent definiteness"},
      {"jump", "snap-through ratio"},
      {"rounding of coordinates", "coordinate round-off"},
      {"left out", "not imported"},
      {"unseen contact", "undetected contact"}};
    return list;
  }



  namespace
  {
    /// Call f(object) for all objects at a path, from its part `first` on; the part `*` stands for
    /// all entries.
    template <typename F>
    void
    at_all(Json &tree, const std::vector<std::string> &parts, const unsigned int first, const F &f)
    {
      if (first == parts.size())
        {
          if (tree.is_object())
            f(tree);
        }
      else if (parts[first] == "*")
        {
          if (tree.is_structured())
            for (Json &one : tree)
              at_all(one, parts, first + 1, f);
        }
      else if (tree.is_object() && tree.contains(parts[first]))
        at_all(tree[parts[first]], parts, first + 1, f);
    }

    /// @return whether a path begins with a pattern, in which `*` stands for any part.
    bool
    begins_with(const std::vector<std::string> &path, const std::vector<std::string> &pattern)
    {
      if (path.size() < pattern.size())
        return false;
      for (unsigned int i = 0; i < pattern.size(); ++i)
        if (pattern[i] != "*" && pattern[i] != path[i])
          return false;
      return true;
    }

    /// Replace the part of a path at the end of a matching pattern.
    void
    exchange(std::vector<std::string>       &path,
             const std::vector<std::string> &pattern,
             const std::string              &now)
    {
      if (begins_with(path, pattern))
        // Only the last part of a pattern is a former name; what follows in the path is kept.
        path[pattern.size() - 1] = now;
    }
  } // namespace



  void
  add_former_entries(Json &results)
  {
    Json entries = Json::object(), checks = Json::object();
    for (const auto &[parent, former, now] : former_entries())
      {
        const std::string prefix = parent.empty() ? "" : parent + "/";
        entries[prefix + former] = prefix + now;
        at_all(results, split(parent, '/'), 0, [former = former, now = now](Json &object) {
          // Entries are copied, not moved, so that present and former names are both in the file.
          if (object.contains(now))
            object[former] = Json(object[now]);
        });
      }
    for (const auto &[former, now] : former_checks())
      checks[former] = now;
    results["deprecated"] = {{"entries", entries}, {"checks", checks}};
  }



  // Former names are replaced one by one, at their positions in the path.
  std::string
  present_path(const std::string &path, const unsigned int dim)
  {
    std::vector<std::string> parts = split(path, '/');
    const auto entry = [&](std::string parent, const std::string &former, const std::string &now) {
      const std::string steps = "load_steps/*";
      // The first pass takes the path from the top of the results, the second one relative to a
      // load step.
      for (unsigned int of_last = 0; of_last < 2; ++of_last)
        {
          exchange(parts, split(parent.empty() ? former : parent + "/" + former, '/'), now);
          // Paths may be relative to the last load step.
          if (parent.compare(0, steps.size(), steps) != 0)
            break;
          parent = parent.size() > steps.size() ? parent.substr(steps.size() + 1) : "";
        }
    };
    for (const auto &[parent, former, now] : former_entries())
      entry(parent, former, now);
    // Stress components were lists in former releases.
    const std::vector<std::string> components =
      dim == 2 ? std::vector<std::string>{"xx", "yy", "xy", "zz"} :
                 std::vector<std::string>{"xx", "yy", "zz", "xy", "xz", "yz"};
    for (unsigned int i = 0; i < components.size(); ++i)
      entry("load_steps/*/probes/*/stress", std::to_string(i), components[i]);
    return join(parts, "/");
  }
} // namespace Signorini
