#include <signorini/mesh/body_mesh.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
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
      "map of the generated mesh, one formula in x,y,z a component, e.g. x; y + x^2/600; empty: none");
    section.add("Refinements",
                refinements,
                "how often the cells of this body are halved at the start");
    for (unsigned int d = 0; d < dim; ++d)
      if (!transformation.empty() && !transformation.prescribed(d))
        section.fail("Transformation", "every component needs a formula");
    if (transformation.depends_on_time())
      section.fail("Transformation",
                   "depends on t, but a mesh is made once; write it in the coordinates alone, and "
                   "what moves as the Displacement of Supports");
  }

  template struct BodyMesh<2>;
  template struct BodyMesh<3>;
} // namespace Signorini
