// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/scene_text.h"
#include "mesh_import/decks/scene_writer.h"
#include "mesh_import/formats/abaqus_elements.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

// Couplings: obstacles that are attached to surfaces, with tied pairs, and resultants.

namespace Signorini
{
  using namespace dealii;

  /// @return the axis along which alone a plane surface that is normal to it follows its reference
  /// node, and slides otherwise; nothing, if the coupling is another one.
  std::optional<unsigned int>
  SceneWriter::only_axis(const DeckModel::Coupling &one) const
  {
    const auto n = std::count(one.components.begin(), one.components.begin() + dim, true);
    if (n != 1 || one.is_distributing || one.axes || is_finite_strain)
      return {};
    const unsigned int axis =
      std::find(one.components.begin(), one.components.end(), true) - one.components.begin();
    const std::vector<unsigned int> nodes     = model.nodes_of(one);
    const std::vector<Point<3>>    &all_nodes = model.deck.mesh.nodes;
    double least = std::numeric_limits<double>::max(), most = -least, size = 0;
    for (const unsigned int node : nodes)
      {
        least = std::min(least, all_nodes[node][axis]);
        most  = std::max(most, all_nodes[node][axis]);
        size  = std::max(size, all_nodes[node].distance(all_nodes[nodes[0]]));
      }
    return most - least <= 1e-8 * size ? std::optional<unsigned int>(axis) : std::nullopt;
  }



  /// Faces of one cell only are outside. Nodes of bodies that are rigid as a whole follow their
  /// surfaces.
  SceneWriter::CoupledFaces
  SceneWriter::coupled_faces(const DeckModel::Coupling &one) const
  {
    CoupledFaces      result;
    std::vector<bool> is_coupled(model.deck.mesh.nodes.size(), false);
    for (const unsigned int node : one.nodes)
      is_coupled[node] = true;
    std::vector<bool> follows(is_coupled.size(), false);
    for (const auto &[face, n_cells] : cells_at_faces())
      if (n_cells == 1 && std::all_of(face.begin(), face.end(), [&](const unsigned int node) {
            return is_coupled[node];
          }))
        {
          result.faces.push_back(face);
          for (const unsigned int node : face)
            follows[node] = true;
        }
    for (const Body &body : all)
      {
        std::vector<bool> is_corner(is_coupled.size(), false);
        for (unsigned int e = 0; e < model.deck.mesh.elements.size(); ++e)
          if (body.has_element[e])
            for (const auto &face : abaqus_faces(model.deck.mesh.elements[e], ""))
              for (const unsigned int node : face)
                is_corner[node] = true;
        std::size_t n = 0, n_corners = 0, n_coupled = 0;
        for (unsigned int i = 0; i < is_corner.size(); ++i)
          {
            n_corners += is_corner[i];
            n_coupled += is_corner[i] && is_coupled[i];
            n += is_corner[i] && is_coupled[i] && !follows[i];
          }
        result.n_other_nodes += n_coupled == n_corners ? 0 : n;
      }
    return result;
  }



  /// @return the surfaces "BODY.SET, ..." that follow a reference node; empty, with a report, if
  /// there are none. Nodes that are on no whole face of a solid are reported.
  std::string
  SceneWriter::coupled_surfaces(const DeckModel::Coupling &one)
  {
    if (one.is_surface)
      return surfaces(one.name, "a coupling");
    const auto [faces, n_left] = coupled_faces(one);
    if (n_left > 0 || faces.empty())
      {
        model.skip_item(one.keyword + " of " +
                          (faces.empty() ? "nodes" : std::to_string(n_left) + " nodes") + " of '" +
                          one.name + "', which are on no whole face of a solid",
                        "",
                        "support");
        model.lacks_supports = true;
      }
    return faces.empty() ?
             "" :
             faces_of(faces, set_names.make_unique_name("rigid " + as_name(one.name)));
  }



  /// @return a formula of a component of a motion or force of a node; `otherwise` if it has none.
  std::string
  SceneWriter::component_at(const DeckModel::NodeCurves &curves,
                            const unsigned int           node,
                            const unsigned int           component,
                            const std::string           &otherwise,
                            const double                 factor)
  {
    const auto found = curves.find({node, component});
    if (found == curves.end())
      return otherwise;
    const DeckModel::History &course = history(histories.number(found->second));
    if (&curves == &model.supports && !model.steps.empty() &&
        (course.spans.size() != 1 || course.spans[0].first > 0 ||
         course.spans[0].second < model.steps.back().end))
      model.skip_item(
        "*BOUNDARY of a reference node that begins or ends in a step (it acts always)",
        "",
        "support");
    return formula(course.points, factor);
  }



  // The components of a reference node that nothing prescribes are free, and its forces and moments
  // drive them. Forces and moments of plane scenes are per thickness.
  SceneWriter::Reference
  SceneWriter::reference(const DeckModel::Coupling &one)
  {
    Reference  result;
    const auto component = [&](const DeckModel::NodeCurves &curves,
                               const bool                   rotates,
                               const unsigned int           d,
                               const std::string           &otherwise,
                               const double                 factor) {
      const bool has_node = rotates && one.rotation;
      return component_at(curves,
                          has_node ? *one.rotation : one.reference,
                          rotates && !has_node ? 3 + d : d,
                          otherwise,
                          factor);
    };
    const double factor = 1 / thickness_at(model.nodes_of(one));
    const auto   add    = [&](const bool rotates, const unsigned int d) {
      const std::string given = component(model.supports, rotates, d, "free", 1);
      result.is_held |= given != "free";
      (rotates ? result.rotation : result.motion).push_back(given);
      (rotates ? result.moment : result.force)
        .push_back(given == "free" ? component(model.forces, rotates, d, "0", factor) : "0");
    };
    for (unsigned int d = 0; d < dim; ++d)
      {
        result.place.push_back(long_text(model.deck.mesh.nodes[one.reference][d]));
        add(false, d);
      }
    for (unsigned int d = dim == 2 ? 2 : 0; d < 3; ++d)
      add(true, d);
    return result;
  }



  namespace
  {
    /// @return the global components of a vector, formulas, whose components refer to the axes x'
    /// along the first vector, z' across both, and y' across these.
    std::vector<std::string>
    along_global_axes(const std::vector<std::string> &components, const DeckModel::Axes &axes)
    {
      const auto vector = [](const std::array<double, 3> &v) {
        return Tensor<1, 3>({v[0], v[1], v[2]});
      };
      Tensor<1, 3> x = vector(axes.first), z = cross_product_3d(x, vector(axes.second));
      x /= x.norm();
      z /= z.norm();
      const std::array<Tensor<1, 3>, 3> local{{x, cross_product_3d(z, x), z}};
      std::vector<std::string>          result;
      for (unsigned int d = 0; d < 3; ++d)
        {
          std::vector<std::string> terms;
          for (unsigned int i = 0; i < 3; ++i)
            if (components[i] != "0" && std::abs(local[i][d]) > 1e-14)
              terms.push_back(long_text(local[i][d]) + "*(" + components[i] + ")");
          result.push_back(terms.empty() ? "0" : join(terms, " + "));
        }
      return result;
    }
  } // namespace



  // Rigid couplings are obstacles and tied pairs, distributing ones loads.
  std::string
  SceneWriter::obstacles()
  {
    std::vector<SceneItem>           items;
    SetNames                         names;
    std::vector<DeckModel::Coupling> imported;
    for (const DeckModel::Coupling &one : model.couplings)
      {
        Reference at = reference(one);
        if (add_rigid_surfaces(one, at, names, items))
          {
            imported.push_back(one);
            continue;
          }
        const auto &held = one.components;
        const auto  axis = only_axis(one);
        const bool  is_whole =
          axis || std::all_of(held.begin(), held.begin() + dim, [](const bool c) { return c; });
        // All components along turned axes are all components.
        const auto is_other_than = [](const std::vector<std::string> &texts, const std::string &x) {
          return std::any_of(texts.begin(), texts.end(), [&](const auto &one) { return one != x; });
        };
        // The mean displacement of nodes can be prescribed, the rotation cannot.
        const bool is_mean = one.is_distributing && at.is_held && !one.nodes.empty() && !one.axes &&
                             !is_other_than(at.rotation, "free"),
                   is_held = one.is_distributing && at.is_held && !is_mean,
                   is_turned =
                     one.is_distributing && one.axes && (dim == 2 || one.axes->is_cylindrical);
        // Nodes that are no surface follow by equations.
        const auto is_surface = [&] {
          const CoupledFaces found = coupled_faces(one);
          return one.is_surface || (!found.faces.empty() && found.n_other_nodes == 0);
        };
        if (!one.is_distributing && (!is_whole || !is_surface()) && add_coupling_equations(one, at))
          continue;
        if (!is_whole || is_held || is_turned)
          {
            model.skip_item(
              one.keyword +
                (!is_whole ?
                   " of some components only, which cannot carry what acts at its reference node, or at "
                   "large deformation" :
                 is_held ? " with a support of its reference node" :
                           " with an ORIENTATION that is cylindrical or not known"),
              "",
              "support");
            model.lacks_supports = true;
            continue;
          }
        if (is_mean)
          {
            add_mean_equations(one);
            if (!is_other_than(at.force, "0") && !is_other_than(at.moment, "0"))
              continue;
          }
        const std::string where = coupled_surfaces(one);
        if (where.empty())
          continue;
        imported.push_back(one);
        // In CalculiX the force of *DISTRIBUTING COUPLING acts at the centre, wherever the
        // reference node is.
        const bool is_at_centre =
          one.keyword == "*DISTRIBUTING COUPLING" && model.deck.instances_of.empty();
        SceneItem item{names.make_unique_name("reference of " + as_name(one.name)), {}};
        if (!is_at_centre)
          item.keys.emplace_back("Reference point", join(at.place));
        const auto add_if_any = [&](const std::string              &key,
                                    const std::vector<std::string> &values) {
          const bool any =
            std::any_of(values.begin(), values.end(), [](const auto &x) { return x != "0"; });
          if (any)
            item.keys.emplace_back(key, join(values, "; "));
          return any;
        };
        if (one.is_distributing)
          {
            item.keys.emplace_back("Boundaries", where);
            if (one.axes)
              for (auto *list : {&at.force, &at.moment})
                *list = along_global_axes(*list, *one.axes);
            const bool has_force = add_if_any("Total force", at.force);
            if (add_if_any("Total moment", at.moment) || has_force)
              coupled_loads.push_back(item);
            continue;
          }
        // Components that no node follows stay zero, where nothing prescribes them.
        for (unsigned int d = 0; axis && d < dim; ++d)
          {
            if (d != *axis && at.motion[d] == "free")
              at.motion[d] = at.force[d] = "0";
            if (d == *axis && dim == 3 && at.rotation[d] == "free")
              at.rotation[d] = at.moment[d] = "0";
          }
        item.keys.emplace_back("Shape", "attached");
        item.keys.emplace_back("Displacement", join(at.motion, "; "));
        item.keys.emplace_back("Rotation", join(at.rotation, "; "));
        add_if_any("Force", at.force);
        add_if_any("Moment", at.moment);
        items.push_back(item);
        for (const std::string &slave : split(where, ','))
          coupled_pairs.push_back({"coupling of " + as_name(one.name),
                                   {{"Slave", slave},
                                    {"Master", item.name},
                                    {axis ? "Separation" : "Law", axis ? "none" : "tied"}}});
      }
    write_pretensions();
    // What acts at the reference nodes of other couplings is reported as left out.
    model.couplings = imported;
    return section("Obstacles", items);
  }



  /// @return the sum of the normals of the faces of a surface, of either sign.
  Tensor<1, 3>
  SceneWriter::normal_of(const std::string &surface) const
  {
    Tensor<1, 3> sum;
    for (const auto &group : model.deck.mesh.groups)
      if (upper_case(group.name) == upper_case(surface))
        for (const auto &face : group.faces)
          {
            const auto x = [&](const unsigned int i) { return model.deck.mesh.nodes[face[i]]; };
            const Tensor<1, 3> e = x(1) - x(0);
            const auto         one =
              face.size() == 2 ? Tensor<1, 3>({-e[1], e[0], 0}) : cross_product_3d(e, x(2) - x(0));
            sum += (one * sum < 0 ? -1. : 1.) * one;
          }
    return sum;
  }



  // The two sides of each section, along which the mesh was cut, are tied. What cannot be imported
  // is taken from the list, so that what acts at its reference node is reported.
  void
  SceneWriter::write_pretensions()
  {
    std::vector<DeckModel::PretensionSection> imported;
    for (const DeckModel::PretensionSection &one : model.pretensions)
      {
        const std::string what = "a pretension", slave = surfaces(one.surface, what),
                          master = surfaces(other_side_of(one.surface), what);
        if (slave.empty() || master.empty() || split(slave, ',').size() > 1 ||
            split(master, ',').size() > 1)
          {
            model.skip_item("*PRE-TENSION SECTION of '" + one.surface +
                              "', whose sides are not one body each",
                            "",
                            "support");
            model.lacks_supports = true;
            continue;
          }
        const Tensor<1, 3> normal = normal_of(one.surface),
                           given({one.direction[0], one.direction[1], one.direction[2]});
        if (std::abs(normal * given) < 0.999 * normal.norm() * given.norm())
          model.skip_item("*PRE-TENSION SECTION in another direction than the normal of '" +
                            one.surface + "', along which it acts",
                          "",
                          "load");
        imported.push_back(one);
        // As in CalculiX, a direction against the outward normal of the surface changes the sign.
        // The corners of faces are in an order such that the normal here points inwards.
        const double      sign = model.deck.instances_of.empty() && normal * given > 0 ? -1 : 1;
        const std::string shortening = component_at(model.supports, one.reference, 0, "", sign);
        if (!shortening.empty() && model.forces.count({one.reference, 0}) > 0)
          model.skip_item("*CLOAD of the pretension of '" + one.surface +
                            "', whose shortening *BOUNDARY prescribes",
                          "",
                          "load");
        SceneItem item{"pretension of " + as_name(one.surface),
                       {{"Slave", slave}, {"Master", master}, {"Law", "tied"}}};
        if (shortening.empty())
          {
            const double thickness = thickness_at(*model.faces_of(one.surface).begin());
            item.keys.emplace_back(
              "Pretension", component_at(model.forces, one.reference, 0, "0", sign / thickness));
          }
        else
          item.keys.emplace_back("Shortening", shortening);
        if (one.lock_time && shortening.empty())
          item.keys.emplace_back("Lock time", text_of_time(*one.lock_time));
        coupled_pairs.push_back(item);
      }
    model.pretensions = imported;
  }



  /// Their supports and forces are those of obstacles.
  void
  SceneWriter::forget_reference_nodes()
  {
    for (auto *list : {&model.supported, &model.loaded})
      {
        for (DeckModel::AtNodes &at : *list)
          at.nodes.erase(std::remove_if(at.nodes.begin(),
                                        at.nodes.end(),
                                        [&](const unsigned int node) {
                                          return model.is_reference(node) ||
                                                 nodes_in_equations.count(node) > 0;
                                        }),
                         at.nodes.end());
        list->erase(std::remove_if(list->begin(),
                                   list->end(),
                                   [](const auto &at) { return at.nodes.empty(); }),
                    list->end());
      }
  }
} // namespace Signorini
