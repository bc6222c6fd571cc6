#include <signorini/import/import_deck.h>
#include <signorini/import/scene_writer.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>
#include <sstream>

namespace Signorini
{
  namespace
  {
    std::string
    text(const double x)
    {
      std::ostringstream out;
      out.precision(12);
      out << x;
      return out.str();
    }



    /// One subsection of a section of named items.
    struct Item
    {
      std::string                                      name;
      std::vector<std::pair<std::string, std::string>> keys;
    };



    /// Names that are there already get a number. Decks may name each node of thousands: nothing is
    /// tried twice.
    class Names
    {
    public:
      std::string
      unlike(const std::string &name)
      {
        if (taken.insert(name).second)
          return name;
        for (unsigned int &i = next.insert({name, 2}).first->second;; ++i)
          if (const std::string result = name + " " + std::to_string(i);
              taken.insert(result).second)
            return result;
      }

    private:
      std::set<std::string>               taken;
      std::map<std::string, unsigned int> next;
    };



    std::string
    keys_of(const Item &item, const std::string &indent)
    {
      std::size_t width = 0;
      for (const auto &[key, value] : item.keys)
        width = std::max(width, key.size());
      std::string result;
      for (const auto &[key, value] : item.keys)
        result +=
          indent + "set " + key + std::string(width - key.size(), ' ') + " = " + value + "\n";
      return result;
    }



    std::string
    section(const std::string &title, const std::vector<Item> &items)
    {
      if (items.empty())
        return "";
      std::vector<std::string> names;
      std::string              body;
      for (const Item &item : items)
        {
          names.push_back(item.name);
          body += "  subsection " + item.name + "\n" + keys_of(item, "    ") + "  end\n";
        }
      return "\nsubsection " + title + "\n  set Names = " + join(names) + "\n" + body + "end\n";
    }



    /// By the types of the plane elements.
    std::string
    model_of_types(const DeckModel &model)
    {
      for (const auto &element : model.deck.mesh.elements)
        for (const auto &[start, name] :
             {std::pair<std::string, std::string>{"CAX", "axisymmetric"}, {"CPS", "plane stress"}})
          if (element.type.compare(0, start.size(), start) == 0)
            return name;
      return "plane strain";
    }
  } // namespace



  SceneWriter::SceneWriter(DeckModel given, const std::string &file)
    : model(std::move(given))
    , file(file)
  {
    bool has_solids = false, has_planes = false;
    for (const auto &element : model.deck.mesh.elements)
      {
        has_solids |= dimension_of(element.shape) == 3;
        has_planes |=
          dimension_of(element.shape) == 2 && element.type[0] == 'C' && element.type != "CONN3D2";
      }
    if (!has_solids && !has_planes)
      throw SceneError("'" + file +
                       "': no elastic solid is left: there are no elements of the "
                       "families C3D, CPE, CPS, CAX");
    dim = has_solids ? 3 : 2;
    if (dim == 2)
      kind = model_of_types(model);
    make_bodies();
  }



  std::string
  SceneWriter::bodies() const
  {
    std::vector<Item> items;
    for (const Body &body : all)
      {
        const auto &material = model.materials.at(body.material);
        Item        item{body.name, {{"Mesh", "file"}, {"File", file}}};
        if (all.size() > 1)
          item.keys.emplace_back("Part", body.part);
        item.keys.emplace_back("Young's modulus", text(*material.youngs_modulus));
        item.keys.emplace_back("Poisson's ratio", text(*material.poissons_ratio));
        if (body.is_quadratic)
          item.keys.emplace_back("Degree", "2");
        if (!body.temperature.empty())
          {
            item.keys.emplace_back("Thermal expansion", text(*material.expansion));
            item.keys.emplace_back("Temperature", formula(body.temperature));
            item.keys.emplace_back("Reference temperature", text(body.initial_temperature));
          }
        items.push_back(item);
      }
    return section("Bodies", items);
  }



  std::string
  SceneWriter::formula(const DeckModel::Curve &curve, const double factor) const
  {
    DeckModel::Points points = model.history(curve);
    const auto        same   = [&](const auto &point) { return point.second == points[0].second; };
    if (std::all_of(points.begin(), points.end(), same))
      return text(factor * points[0].second);
    if (points.size() == 2 && points[0].second == 0)
      return text(factor * points[1].second) + "*t" +
             (points[1].first == 1 ? "" : "/" + text(points[1].first));
    std::vector<std::string> words{"t"};
    for (const auto &[t, y] : points)
      {
        words.push_back(text(t));
        words.push_back(text(factor * y));
      }
    return "table(" + join(words) + ")";
  }



  std::string
  SceneWriter::vector_formula(const std::array<DeckModel::Curve, 3> &components,
                              const std::string                     &otherwise,
                              const double                           factor) const
  {
    std::vector<std::string> words;
    for (unsigned int d = 0; d < dim; ++d)
      words.push_back(components[d].empty() ? otherwise : formula(components[d], factor));
    return join(words, "; ");
  }



  /// "BODY.SET, ..." of all bodies with nodes of the set; empty if there are none.
  std::string
  SceneWriter::targets(const DeckModel::AtNodes &at, const std::string &what)
  {
    std::vector<std::string> result;
    std::set<unsigned int>   homeless(at.nodes.begin(), at.nodes.end());
    for (const Body &body : all)
      {
        bool has_some = false;
        for (const unsigned int node : at.nodes)
          if (body.has_node[node])
            {
              has_some = true;
              homeless.erase(node);
            }
        if (has_some)
          result.push_back(body.name + "." + at.target);
      }
    if (!homeless.empty())
      model.leave_out(what + " at " + std::to_string(homeless.size()) + " nodes of " + at.target +
                        " that are on no solid",
                      "");
    return join(result);
  }



  std::string
  SceneWriter::supports()
  {
    std::vector<Item> items;
    Names             names;
    for (const auto &at : model.supports)
      {
        const std::string displacement = vector_formula(at.components, "free");
        const bool        holds        = std::any_of(at.components.begin(),
                                       at.components.begin() + dim,
                                       [](const auto &curve) { return !curve.empty(); });
        const std::string where        = holds ? targets(at, "*BOUNDARY") : "";
        if (where.empty())
          continue;
        for (unsigned int d = 0; d < dim; ++d)
          if (!at.components[d].empty() && at.components[d].front().step > 1)
            model.leave_out("that the support of " + at.target +
                              " begins in a later step; it holds from the beginning",
                            "*BOUNDARY");
        // Nodes of their own with the same displacement are one support.
        const bool is_number = at.nodes.size() == 1 && !model.deck.nodes.find(at.target);
        const auto like      = std::find_if(items.begin(), items.end(), [&](const Item &one) {
          return is_number && one.name.compare(0, 5, "nodes") == 0 &&
                 one.keys[1].second == displacement;
        });
        if (like != items.end())
          like->keys[0].second += ", " + where;
        else
          items.push_back({names.unlike(is_number ? "nodes" : as_name(at.target)),
                           {{"Nodes", where}, {"Displacement", displacement}}});
      }
    return section("Supports", items);
  }



  /// "BODY.SURFACE, ..."
  std::string
  SceneWriter::surfaces(const std::string &surface, const std::string &what)
  {
    std::vector<std::string> result;
    for (const Body &body : all)
      for (const std::string &boundary : body.boundaries)
        if (upper_case(boundary) == upper_case(surface))
          result.push_back(body.name + "." + boundary);
    if (result.empty())
      model.leave_out(what + " on '" + surface + "', which has no whole face of a solid", "");
    return join(result);
  }



  /// Of plane bodies per thickness.
  std::string
  SceneWriter::forces(const DeckModel::AtNodes &at) const
  {
    double thickness = 1;
    for (const Body &body : all)
      for (const unsigned int node : at.nodes)
        if (body.has_node[node])
          thickness = body.thickness;
    return vector_formula(at.components, "0", dim == 2 ? 1 / thickness : 1.);
  }



  std::string
  SceneWriter::loads()
  {
    std::vector<Item> items;
    Names             names;
    for (const auto &at : model.forces)
      {
        const std::string force = forces(at), where = targets(at, "*CLOAD");
        const bool        is_number = at.nodes.size() == 1 && !model.deck.nodes.find(at.target);
        if (where.empty())
          continue;
        const auto like = std::find_if(items.begin(), items.end(), [&](const Item &one) {
          return is_number && one.name.compare(0, 5, "nodes") == 0 && one.keys[1].second == force;
        });
        if (like != items.end())
          like->keys[0].second += ", " + where;
        else
          items.push_back({names.unlike(is_number ? "nodes" : as_name(at.target)),
                           {{"Nodes", where}, {"Force", force}}});
      }
    for (const auto &load : model.pressures)
      if (const std::string where = surfaces(load.surface, "a pressure"); !where.empty())
        items.push_back({names.unlike(as_name(load.surface)),
                         {{"Boundaries", where}, {"Pressure", formula(load.pressure)}}});
    for (const auto &load : model.body_loads)
      for (const Body &body : all)
        if (std::any_of(load.elements.begin(), load.elements.end(), [&](const unsigned int e) {
              return body.has_element[e];
            }))
          {
            const auto &density = model.materials.at(body.material).density;
            if (load.is_gravity && !density)
              {
                model.leave_out("gravity on " + body.name + ", whose material has no *DENSITY", "");
                continue;
              }
            const std::string        size = formula(load.size, load.is_gravity ? *density : 1.);
            std::vector<std::string> words;
            for (unsigned int d = 0; d < dim; ++d)
              words.push_back(load.direction[d] == 0 ? "0" :
                                                       text(load.direction[d]) + "*(" + size + ")");
            items.push_back({names.unlike("body force of " + body.name),
                             {{"Bodies", body.name}, {"Body force", join(words, "; ")}}});
          }
    return section("Loads", items);
  }



  std::string
  SceneWriter::pairs()
  {
    std::vector<Item> items;
    Names             names;
    for (const auto &pair : model.pairs)
      {
        const std::string slaves  = surfaces(pair.slave, "the slave of a contact pair"),
                          masters = surfaces(pair.master, "the master of a contact pair");
        const auto found          = model.interactions.find(pair.interaction);
        const bool stays          = found != model.interactions.end() &&
                           found->second.kind == DeckModel::Interaction::Kind::tied;
        for (const std::string &slave : split(slaves, ','))
          for (const std::string &master : split(masters, ','))
            {
              items.push_back({names.unlike(as_name(pair.slave) + " on " + as_name(pair.master)),
                               {{"Slave", slave}, {"Master", master}}});
              if (stays)
                items.back().keys.emplace_back("Separates", "no");
            }
      }
    return section("Contact pairs", items);
  }



  std::string
  SceneWriter::steps() const
  {
    if (model.steps.empty())
      return "";
    std::vector<std::string> ends;
    for (const auto &step : model.steps)
      ends.push_back(text(step.end));
    return "\nsubsection Load steps\n  set Times = " + join(ends) + "\nend\n";
  }



  /// One method for all pairs: that of linear ones if there are no others.
  std::string
  SceneWriter::method()
  {
    using Kind       = DeckModel::Interaction::Kind;
    double stiffness = 0;
    bool   has_hard  = false;
    for (const auto &pair : model.pairs)
      if (const auto found = model.interactions.find(pair.interaction);
          found != model.interactions.end())
        {
          const auto &one = found->second;
          has_hard |= one.kind == Kind::hard;
          if (one.kind == Kind::linear && stiffness > 0 && one.stiffness != stiffness)
            model.leave_out("different slopes of *SURFACE BEHAVIOR (the largest counts for all)",
                            "");
          if (one.kind == Kind::linear)
            stiffness = std::max(stiffness, one.stiffness);
        }
    if (stiffness == 0)
      return "";
    if (has_hard)
      {
        model.leave_out("the slope of linear contact beside a hard one (all contact is hard)", "");
        return "";
      }
    return "\nsubsection Contact method\n  set Method = penalty\n  subsection penalty\n    set "
           "Stiffness = " +
           text(stiffness) + "\n  end\nend\n";
  }



  std::string
  SceneWriter::free_motions() const
  {
    return model.lacks_restraint ?
             "\nsubsection Newton\n  # What was left out may have held bodies. Look at the forces "
             "that this takes.\n  set Undetermined motions = hold\nend\n" :
             "";
  }



  std::vector<std::string>
  SceneWriter::left_out() const
  {
    std::vector<std::string> lines;
    for (const auto &[what, places] : model.left_out)
      {
        std::string line = "left out: " + what;
        if (!places[0].empty())
          line += ": " + places[0];
        if (places.size() > 1)
          line += " and " + std::to_string(places.size() - 1) + " more";
        lines.push_back(line);
      }
    return lines;
  }



  void
  SceneWriter::write(std::ostream &scene)
  {
    // First all sections, which leave things out.
    const std::string body =
      bodies() + supports() + loads() + pairs() + method() + steps() + free_motions();
    scene << "# Made of " << file << "\n";
    for (const std::string &line : left_out())
      scene << "# " << line << "\n";
    scene << "set Dimension = " << dim << "\n";
    if (dim == 2)
      scene << "set Model     = " << kind << "\n";
    scene << "set Title     = " << std::filesystem::path(file).stem().string() << "\n" << body;
  }



  void
  import_deck(const std::string &file, std::ostream &out, std::ostream &messages)
  {
    SceneWriter writer(read_deck_model(file), file);
    writer.write(out);
    for (const std::string &line : writer.left_out())
      messages << "warning: " << file << ": " << line << "\n";
  }
} // namespace Signorini
