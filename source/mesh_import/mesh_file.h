// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace Signorini
{
  /// What a mesh file says, whatever its format. Own readers, because those of GridIn drop the
  /// names, cannot take one part out of a file, and give up on named interior faces.
  struct MeshFile
  {
    using Nodes = std::vector<unsigned int>; ///< indices into `nodes`

    enum class Shape
    {
      point,
      line,
      triangle,
      quadrilateral,
      tetrahedron,
      pyramid,
      wedge,
      hexahedron,
      unknown ///< with any number of nodes
    };

    struct Element
    {
      Shape       shape;
      std::string type;   ///< as the file calls it, for messages
      std::size_t number; ///< in the file, for messages
      /// The corners, around the bottom and then around the top. In second order then the middles
      /// of the edges at the bottom, at the top and between, each around; of 27 then the centers of
      /// the faces x-, x+, y-, y+, z-, z+, and the center; of 9 the center; of 18 (wedges) those of
      /// the quadrilaterals, in the order of their edges at the bottom; of 14 (pyramids) that of
      /// the base.
      Nodes nodes;
    };

    /// What has a common name. In d dimensions, its elements of dimension d are a part and a set of
    /// cells; those of dimension d-1 and the faces are a boundary, or if there are none, the faces
    /// all of whose corners are in `nodes`.
    struct Group
    {
      std::string               name;
      std::vector<unsigned int> elements; ///< indices into `elements`
      std::vector<Nodes>        faces;    ///< the corners of each
      Nodes                     nodes;
    };

    std::vector<dealii::Point<3>> nodes;
    std::vector<Element>          elements;
    std::vector<Group>            groups; ///< in the order in which they are to be listed
    /// Nodes by their numbers, where the format has any; by the instance (in upper case, empty:
    /// none).
    std::map<std::string, std::unordered_map<std::size_t, unsigned int>> numbers;
    std::vector<std::string> notes; ///< what the user may want to know about the file

    /// Nodes from here on are not in the file: they were made by dividing cells (see
    /// hex_subdivision.h).
    unsigned int first_inserted = -1;

    /// Of cells that were divided: the face of the file that a face at the
    /// boundary is a part of, by the sorted corners of the latter.
    std::map<Nodes, Nodes> whole_faces;

    /// The face of the file that a boundary face with these corners is a part of, or itself.
    const Nodes &
    parent_face(const Nodes &corners) const;
    /// Numbers at the nodes, by name: one a node, not a number where the file has none.
    std::map<std::string, std::vector<double>> fields;

    /// The group of that name, made if there is none.
    Group &
    group(const std::string &name);
  };

  /// 0 to 3; 4 if unknown.
  unsigned int
  dimension_of(MeshFile::Shape shape);

  /// Number of corners; 0 if unknown.
  unsigned int
  n_corners(MeshFile::Shape shape);

  /// The corners of an element; all nodes if its shape is unknown.
  MeshFile::Nodes
  corners_of(const MeshFile::Element &element);

  /// Names of the groups with elements of that dimension.
  std::vector<std::string>
  part_names(const MeshFile &file, unsigned int dim);

  /// Read a file in the format that its extension says. Throws SceneError with the name of the file
  /// if it cannot be opened, has another extension, or is not what the extension says.
  MeshFile
  read_mesh_file(const std::string &file_name);

  /// "Gmsh (.msh), ...", for messages and help.
  std::string
  mesh_formats();
} // namespace Signorini
