#include <signorini/parameters/section.h>
#include <signorini/solid/boundary_conditions.h>

namespace Signorini
{
  void
  NodeChoice::declare(Section &section, const unsigned int dim, const std::string &what)
  {
    section.add("Nodes",
                sets,
                what +
                  " at sets of nodes of mesh files, or at nodes by their numbers: BODY.SET, ...");
    section.add("Point",
                point,
                what + " at a point of a body: its coordinates x,y" + (dim == 3 ? ",z" : "") +
                  "; empty: none [length]");
    section.add("Point body", body, "that has the point; empty: the only one there");
    if (!section.reading())
      return;
    sets_place  = section.place_of("Nodes");
    point_place = section.place_of("Point");
    if (!point.empty() && point.size() != dim)
      section.fail("Point", "needs " + std::to_string(dim) + " coordinates, separated by commas");
    if (!body.empty() && point.empty())
      section.fail("Point body", "belongs to a Point");
  }



  template <int dim>
  void
  Support<dim>::declare(Section &section)
  {
    section.add("Boundaries", boundaries, "where: BODY.BOUNDARY, several separated by commas");
    nodes.declare(section, dim, "or where:");
    section.add_choice(
      "Type",
      type,
      {{"displacement", SupportType::displacement},
       {"symmetry", SupportType::symmetry},
       {"roller", SupportType::roller}},
      "prescribed components; a plane of symmetry (plane faces, any direction); or held along one direction alone");
    section.add(
      "Displacement",
      displacement,
      "one formula in x,y,z,t a component, separated by ';'; 'free' for a component that is free [length]");
    section.add("Normal displacement",
                normal_displacement,
                "of a roller, outwards or along its Direction: formula in x,y,z,t [length]");
    section.add("Direction",
                direction,
                "in which a roller holds; 0: normal to the faces; any length");
    section.add("From",
                from,
                "the support begins to hold right after this time, at which a load step ends; 0: "
                "it holds from the start",
                non_negative);
    section.add("Until",
                until,
                "the support holds up to this time, at which a load step ends, and then no more; "
                "0: to the end",
                non_negative);
    if (!section.reading())
      return;
    place = section.place_of("Boundaries");
    if (until > 0 && until <= from)
      section.fail("Until", "must be later than From, or 0 for a support that holds to the end");
    if (boundaries.empty() && nodes.empty())
      section.fail("Boundaries", "a support needs at least one boundary, or Nodes, or a Point");
    const bool has_normal = nodes.empty() || direction.norm() > 0;
    if (type == SupportType::symmetry && !nodes.empty())
      section.fail("Type", "nodes and points have no normal; prescribe components there");
    if (type == SupportType::roller && !has_normal)
      section.fail("Direction", "is needed: nodes and points have no normal");
    if (type == SupportType::displacement && displacement.empty())
      section.fail("Displacement", "a support must prescribe at least one component");
    if (type != SupportType::displacement && displacement.given())
      section.fail("Displacement",
                   "belongs to Type = displacement; a roller has its Normal displacement");
    if (type != SupportType::roller && !normal_displacement.is_zero())
      section.fail("Normal displacement", "belongs to Type = roller");
    if (type != SupportType::roller && direction.norm() > 0)
      section.fail("Direction", "belongs to Type = roller");
  }



  template <int dim>
  bool
  Support<dim>::acts(const double t) const
  {
    constexpr double rounding = 1e-10;
    return (from == 0 || t > from * (1 + rounding)) && (until == 0 || t <= until * (1 + rounding));
  }



  template <int dim>
  void
  Load<dim>::declare(Section &section)
  {
    section.add("Boundaries", boundaries, "where traction and pressure act: BODY.BOUNDARY, ...");
    section.add("Traction",
                traction,
                "one formula in x,y,z,t a component, separated by ';' [force/area]");
    section.add("Pressure",
                pressure,
                "formula in x,y,z,t; positive pushes into the body [force/area]");
    section.add(
      "Total force",
      total_force,
      "on all Boundaries together, as a uniform traction, or shared equally by the Nodes: "
      "one formula in t a component, separated by ';' [force]");
    nodes.declare(section, dim, "where the force acts,");
    section.add("Force",
                force,
                "at each of the Nodes, or at the Point, around which stresses are singular: one "
                "formula in x,y,z,t a component, separated by ';' [force]");
    section.add("Bodies",
                bodies,
                "where the body force acts: BODY, or BODY.SET of cells of a mesh file, ...");
    section.add("Body force",
                body_force,
                "one formula in x,y,z,t a component, separated by ';' [force/volume]");
    if (!section.reading())
      return;
    place        = section.place_of("Boundaries");
    bodies_place = section.place_of("Bodies");
    if (boundaries.empty() && bodies.empty() && nodes.empty())
      section.fail("Boundaries",
                   "a load needs Boundaries (for a traction, pressure or total force), Nodes or a "
                   "Point (for a force) or Bodies (for a body force)");
    if (nodes.empty() && force.given())
      section.fail("Force", "needs Nodes or a Point; on Boundaries there is a Total force");
    if (!nodes.empty() && !force.given() && !total_force.given())
      section.fail("Force", "is needed where Nodes or a Point are named");
    if (force.given() && total_force.given())
      section.fail("Total force", "and a Force exclude each other; make two loads of them");
    if (total_force.given() && !nodes.point.empty())
      section.fail("Total force", "belongs to Boundaries or Nodes; at a Point there is a Force");
    if (total_force.given() && !boundaries.empty() && !nodes.empty())
      section.fail("Total force", "acts on Boundaries or on Nodes; make two loads of them");
    if (total_force.given() && boundaries.empty() && nodes.empty())
      section.fail("Total force", "needs Boundaries or Nodes");
    if (total_force.depends_on_place())
      section.fail("Total force", "is one for all; it depends on t alone");
    if (!bodies.empty() && body_force.empty())
      section.fail("Body force", "is needed where Bodies are named");
    if (bodies.empty() && !body_force.empty())
      section.fail("Bodies", "are needed where a Body force is given");
    const bool acts = !traction.empty() || section.is_set("Pressure") || total_force.given();
    if (!boundaries.empty() && !acts)
      section.fail("Traction", "Pressure or Total force is needed where Boundaries are named");
  }



  template struct Support<2>;
  template struct Support<3>;
  template struct Load<2>;
  template struct Load<3>;
} // namespace Signorini
