#include <signorini/elasticity/boundary_conditions.h>
#include <signorini/elasticity/material.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  Material::declare(Section &section)
  {
    section.add("Young's modulus", youngs_modulus, "E [stress]", positive);
    section.add("Poisson's ratio", poissons_ratio, "nu [-]", Range{-1, 0.5, false, false});
  }



  template <int dim>
  void
  Support<dim>::declare(Section &section)
  {
    section.add("Boundaries", boundaries, "where: BODY.BOUNDARY, several separated by commas");
    section.add_choice(
      "Type",
      type,
      {"displacement", "symmetry", "roller"},
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
    if (!section.reading())
      return;
    place = section.place_of("Boundaries");
    if (boundaries.empty())
      section.fail("Boundaries", "a support needs at least one boundary");
    if (type == "displacement" && displacement.empty())
      section.fail("Displacement", "a support must prescribe at least one component");
    if (type != "displacement" && displacement.given())
      section.fail("Displacement",
                   "belongs to Type = displacement; a roller has its Normal displacement");
    if (type != "roller" && !normal_displacement.is_zero())
      section.fail("Normal displacement", "belongs to Type = roller");
    if (type != "roller" && direction.norm() > 0)
      section.fail("Direction", "belongs to Type = roller");
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
    section.add("Bodies", bodies, "where the body force acts");
    section.add("Body force",
                body_force,
                "one formula in x,y,z,t a component, separated by ';' [force/volume]");
    if (!section.reading())
      return;
    place        = section.place_of("Boundaries");
    bodies_place = section.place_of("Bodies");
    if (boundaries.empty() && bodies.empty())
      section.fail(
        "Boundaries",
        "a load needs Boundaries (for a traction or pressure) or Bodies (for a body force)");
    if (!bodies.empty() && body_force.empty())
      section.fail("Body force", "is needed where Bodies are named");
    if (bodies.empty() && !body_force.empty())
      section.fail("Bodies", "are needed where a Body force is given");
    if (!boundaries.empty() && traction.empty() && pressure.is_zero())
      section.fail("Traction", "or Pressure is needed where Boundaries are named");
  }



  template struct Support<2>;
  template struct Support<3>;
  template struct Load<2>;
  template struct Load<3>;
} // namespace Signorini
