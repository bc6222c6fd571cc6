// SPDX-License-Identifier: Apache-2.0
#include "mesh/generators/file.h"
#include <signorini/parameters/section.h>

namespace Signorini
{
  namespace
  {
    /// @return the boundaries on spheres and cylinders that the scene lists; none if the text is a
    /// keyword. Throws SceneError with the position of the key.
    template <int dim>
    std::vector<CurvedBoundary<dim>>
    read_curved_boundaries(const std::string &text, const Section &section)
    {
      try
        {
          if (text == "automatic" || text == "none")
            return {};
          return curved_boundaries_from<dim>(text);
        }
      catch (const SceneError &error)
        {
          section.fail("Curved boundaries", error.what());
        }
    }
  } // namespace



  // Names refer to the file and are checked when it is read; positions of keys are stored for
  // messages.
  template <int dim>
  void
  FileMesh<dim>::declare(Section &section)
  {
    section.add("File",
                file,
                "mesh file, relative to the scene; the format follows from the extension: " +
                  mesh_formats());
    section.add(
      "Part",
      selection.part,
      std::string("physical ") + (dim == 2 ? "surface" : "volume") +
        " (Gmsh), instance or element set (Abaqus) or ARRAY VALUE of cell data (VTK) of the body, "
        "with separate nodes; or piece1, piece2, ...: connected components that are no set; empty: "
        "all cells");
    section.add_choice(
      "Cells",
      cells,
      {{"automatic", CellChoice::automatic},
       {word_of_cells(dim, false), CellChoice::hypercubes},
       {"as in file", CellChoice::as_in_file}},
      dim == 2 ?
        "quadrilaterals: each triangle is divided into three quadrilaterals; as in file: triangles "
        "are kept, with the degrees of freedom of the file and without refinement; automatic: "
        "triangles of second order are kept, unless the scene asks for adaptive or refined meshes, "
        "internal variables, or degree 1" :
        "hexahedra: tetrahedra, wedges and pyramids are divided into hexahedra; as in file: "
        "tetrahedra are kept, with the degrees of freedom of the file and without refinement; "
        "wedges, pyramids and hexahedra of second order beside them are cut into tetrahedra; "
        "automatic: the same for cells of second order, unless the scene asks for adaptive or "
        "refined meshes, internal variables, or degree 1");
    section.add("Boundaries",
                selection.boundaries,
                "names in the file that are boundaries, separated by commas; a face belongs to the "
                "first that contains it; empty: all, and a face may have several names");
    section.add("Feature angle",
                selection.feature_angle,
                "faces without a name are split at edges of more than this angle into unnamed1, "
                "unnamed2, ... by the x, then y, then z of their centers; 0: one boundary unnamed "
                "[degrees]",
                Range{0, 180});
    section.rename_choice("Coinciding nodes", "refuse", "error");
    section.add_choice(
      "Coinciding nodes",
      selection.coinciding_nodes,
      {{"error", CoincidingPoints::refuse},
       {"merge", CoincidingPoints::merge},
       {"keep", CoincidingPoints::keep}},
      "treatment of coinciding nodes of cells that are not connected; disconnected pieces "
      "of the body stay separate if a contact pair joins them");
    section.add("Node distance",
                selection.node_distance,
                "tolerance of coinciding nodes; 0: 1e-3 of the shortest edge [length]",
                non_negative);
    section.add(
      "Mid-side nodes",
      mid_side_nodes,
      "yes: second-order cells are curved according to their mid-side nodes; no: they are first-order cells");
    section.add(
      "Curved boundaries",
      curved_text,
      dim == 2 ?
        "automatic: facets with corners on circles, or on any smooth curve, are curved; none: facets "
        "remain straight; or boundaries on circles, separated by ;   NAME circle cx cy" :
        "automatic: facets with corners on spheres, cylinders, cones, or on any smooth surface, are "
        "curved; none: facets remain plane; or boundaries on spheres (center) or cylinders (point "
        "and direction of the axis), separated by ;   NAME sphere cx cy cz   NAME cylinder px py pz "
        "ax ay az");
    section.add("Temperature field",
                temperature_field,
                "name in the file of temperatures at the nodes, linear between those of corners; "
                "empty: none");
    section.add("Node sets",
                node_set_text,
                "additional node sets by the node numbers of the file: NAME: 1, 4-7; NAME: ...; "
                "numbers of an instance as INSTANCE.4-7");
    section.add("Face sets",
                face_set_text,
                "additional boundaries: element faces of the part by element number and face label "
                "of Abaqus, NAME: 3.S2, 5-8.S1; NAME: ...");
    section.add(
      "Cell sets",
      cell_set_text,
      "additional element sets of the part by the element numbers of the file: NAME: 3, 5-8; NAME: ...");
    if (!section.reading())
      return;
    if (file.empty())
      section.fail("File", "is required for Mesh = file");
    surfaces = read_curved_boundaries<dim>(curved_text, section);
    for (const char *key : {"File",
                            "Cells",
                            "Part",
                            "Boundaries",
                            "Curved boundaries",
                            "Temperature field",
                            "Node sets",
                            "Face sets",
                            "Cell sets"})
      place_of[key] = section.source_of(key);
  }



  template void
  FileMesh<2>::declare(Section &);
  template void
  FileMesh<3>::declare(Section &);
} // namespace Signorini
