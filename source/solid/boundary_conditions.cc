// SPDX-License-Identifier: Apache-2.0
#include <signorini/parameters/section.h>
#include <signorini/solid/boundary_conditions.h>

namespace Signorini
{
  // The keys by which supports and loads name nodes instead of boundaries. Locations in the scene
  // are kept for messages that only the mesh can give rise to.
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
    section.add("Point body", body, "body that contains the point; empty: the only one there");
    // When reference or templates are printed, values are not read and must not be checked.
    if (!section.reading())
      return;
    sets_location  = section.source_of("Nodes");
    point_location = section.source_of("Point");
    if (!point.empty() && point.size() != dim)
      section.fail("Point", "needs " + std::to_string(dim) + " coordinates, separated by commas");
    if (!body.empty() && point.empty())
      section.fail("Point body", "requires a Point");
  }



  // Read the keys of a support, then check that they fit its type: components for prescribed
  // displacements, a normal or a direction for symmetry and rollers.
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
      "displacement: prescribed components; symmetry: plane of symmetry (plane faces of any "
      "orientation); roller: constrained in one direction");
    section.add(
      "Displacement",
      displacement,
      "one formula in x,y,z,t a component, separated by ';'; 'free' for a component that is free [length]");
    section.add(
      "Normal displacement",
      normal_displacement,
      "displacement of a roller, outwards or along its Direction: formula in x,y,z,t [length]");
    section.add("Direction",
                direction,
                "direction that a roller constrains, of any length; 0: normal to the faces");
    axes.declare(section, "the Displacement");
    section.rename_key("From", "Start time");
    section.rename_key("Until", "End time");
    declare_times(section, "the support");
    if (!section.reading())
      return;
    place = section.source_of("Boundaries");
    if (boundaries.empty() && nodes.empty())
      section.fail("Boundaries", "a support needs at least one boundary, or Nodes, or a Point");
    // Faces have a normal; single nodes need an explicit direction.
    const bool has_normal = nodes.empty() || direction.norm() > 0;
    if (type == SupportType::symmetry && !nodes.empty())
      section.fail("Type", "nodes and points have no normal; prescribe components there");
    if (type == SupportType::roller && !has_normal)
      section.fail("Direction",
                   "is required for a roller at nodes or a point, which have no normal");
    if (type == SupportType::displacement && displacement.empty())
      section.fail("Displacement", "a support must prescribe at least one component");
    if (type != SupportType::displacement && displacement.given())
      section.fail("Displacement",
                   "requires Type = displacement; for a roller set Normal displacement");
    if (type != SupportType::roller && !normal_displacement.is_zero())
      section.fail("Normal displacement", "requires Type = roller");
    if (type != SupportType::roller && direction.norm() > 0)
      section.fail("Direction", "requires Type = roller");
    if (type != SupportType::displacement && !axes.are_global())
      section.fail("Coordinates", "requires Type = displacement");
  }



  template <int dim>
  dealii::Tensor<1, dim>
  Support<dim>::displacement_at(const dealii::Point<dim> &x, const double t) const
  {
    return axes.to_global(displacement.value(x, t), x);
  }



  // Read the keys of a load, then check that each force has a place and each place has a force; a
  // total force belongs to either boundaries or nodes.
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
      "Fluid entry",
      fluid_entries,
      "where a fluid with that Pressure enters, points of the Boundaries, x,y,z; x,y,z; ...: it "
      "acts on faces that it reaches from there, past others that are not in contact or whose contact "
      "pressure is smaller; empty: on all of the Boundaries [length]");
    section.add(
      "Total force",
      total_force,
      "on all Boundaries together, as a uniform traction, or shared equally by the Nodes: "
      "one formula in t a component, separated by ';' [force]");
    section.add("Total moment",
                total_moment,
                "on all Boundaries together, by a traction that is linear in the place; about the "
                "Reference point: formulas in t [force*length]");
    section.add("Reference point",
                reference,
                "point of action of the Total force on Boundaries; empty: their centre [length]");
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
    axes.declare(section, "Traction, Force and Body force");
    if (!section.reading())
      return;
    if (!axes.are_global() && !traction.given() && !force.given() && body_force.empty())
      section.fail("Coordinates", "has no effect without Traction, Force or Body force");
    place           = section.source_of("Boundaries");
    bodies_location = section.source_of("Bodies");
    if (boundaries.empty() && bodies.empty() && nodes.empty())
      section.fail("Boundaries",
                   "a load needs Boundaries (for a traction, pressure or total force), Nodes or a "
                   "Point (for a force) or Bodies (for a body force)");
    if (nodes.empty() && force.given())
      section.fail("Force", "requires Nodes or a Point; on Boundaries set Total force");
    if (!nodes.empty() && !force.given() && !total_force.given())
      section.fail("Force", "is required with Nodes or a Point");
    if (force.given() && total_force.given())
      section.fail("Total force", "is set together with Force; define two loads");
    if (total_force.given() && !nodes.point.empty())
      section.fail("Total force", "requires Boundaries or Nodes; at a Point set Force");
    if (total_force.given() && !boundaries.empty() && !nodes.empty())
      section.fail("Total force", "is set with both Boundaries and Nodes; define two loads");
    if (total_force.given() && boundaries.empty() && nodes.empty())
      section.fail("Total force", "requires Boundaries or Nodes");
    if (boundaries.empty() && (total_moment.given() || !reference.empty()))
      section.fail(total_moment.given() ? "Total moment" : "Reference point",
                   "requires Boundaries");
    if (!reference.empty() && reference.size() != dim)
      section.fail("Reference point", "must have " + std::to_string(dim) + " coordinates");
    if (!reference.empty() && !has_resultant())
      section.fail("Reference point", "has no effect without Total force or Total moment");
    if (total_moment.depends_on_place())
      section.fail("Total moment", "must not depend on x, y or z; use formulas in t alone");
    if (total_force.depends_on_place())
      section.fail("Total force", "must not depend on x, y or z; use a formula in t alone");
    if (!bodies.empty() && body_force.empty())
      section.fail("Body force", "is required with Bodies");
    if (bodies.empty() && !body_force.empty())
      section.fail("Bodies", "is required with a Body force");
    // A pressure may be the formula 0 on purpose; that its key is set tells it from a forgotten
    // load.
    const bool acts = !traction.empty() || section.is_set("Pressure") || total_force.given() ||
                      total_moment.given();
    if (!fluid_entries.empty() && (boundaries.empty() || !section.is_set("Pressure")))
      section.fail("Fluid entry", "requires Boundaries and a Pressure");
    if (!boundaries.empty() && !acts)
      section.fail(
        "Traction",
        "one of Traction, Pressure, Total force or Total moment is required with Boundaries");
  }



  template <int dim>
  dealii::Tensor<1, dim>
  Load<dim>::traction_at(const dealii::Point<dim> &x, const double t) const
  {
    return axes.to_global(traction.value(x, t), x);
  }



  template <int dim>
  dealii::Tensor<1, dim>
  Load<dim>::body_force_at(const dealii::Point<dim> &x, const double t) const
  {
    return axes.to_global(body_force.value(x, t), x);
  }



  template <int dim>
  dealii::Tensor<1, dim>
  Load<dim>::force_at(const dealii::Point<dim> &x, const double t) const
  {
    return axes.to_global(force.value(x, t), x);
  }



  template struct Support<2>;
  template struct Support<3>;
  template struct Load<2>;
  template struct Load<3>;
} // namespace Signorini
