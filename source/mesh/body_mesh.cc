// SPDX-License-Identifier: Apache-2.0
#include <signorini/mesh/body_mesh.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  // The generator that the key Mesh names declares its own keys in the same section.
  template <int dim>
  void
  BodyMesh<dim>::declare(Section &section)
  {
    section.add_choice("Mesh", type, generator_names<dim>(), "generator of the mesh");
    if (section.reading() || !generator)
      generator = MeshGenerator<dim>::create(type);
    generator->declare(section);
    section.add(
      "Transformation",
      transformation,
      "mapping of the generated mesh, one formula in x,y,z a component, e.g. x; y + x^2/600; empty: none");
    section.add("Refinements",
                refinements,
                "number of uniform refinements of this body at the start");
    for (unsigned int d = 0; d < dim; ++d)
      if (!transformation.empty() && !transformation.prescribed(d))
        section.fail("Transformation", "every component needs a formula");
    if (transformation.depends_on_time())
      section.fail(
        "Transformation",
        "depends on t, but the mesh is generated once; use formulas in x, y, z alone, and "
        "describe motion by Displacement of Supports");
  }

  template struct BodyMesh<2>;
  template struct BodyMesh<3>;
} // namespace Signorini
