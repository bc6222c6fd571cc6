// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace Signorini
{
  /// The contents of a mesh file, independent of its format. The program has readers of its own,
  /// because those of deal.II's GridIn discard the names of groups, cannot extract one part of a
  /// file, and fail on named interior faces.
  struct MeshFile
  {
    /// Indices into `nodes`.
    using Nodes = std::vector<unsigned int>;

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
      /// A shape that is not supported, with any number of nodes.
      unknown
    };

    /// An element of any dimension and order.
    struct Element
    {
      Shape shape;
      /// Type of the element as the file calls it, for messages.
      std::string type;
      /// Number in the file, for messages.
      std::size_t number;
      /// The corners, around the bottom and then around the top. In second order these are followed
      /// by the middles of the edges at the bottom, at the top and between, each around; with 27
      /// nodes by the centres of the faces x-, x+, y-, y+, z-, z+, and the centre; with 9 by the
      /// centre; with 18 (wedges) by those of the quadrilaterals, in the order of their edges at
      /// the bottom; with 14 (pyramids) by that of the base.
      Nodes nodes;
    };

    /// A named set. In d dimensions, its elements of dimension d are a part and a set of cells. Its
    /// elements of dimension d-1 and its faces are a boundary, or if there are none, the faces all
    /// of whose corners are in `nodes`.
    struct Group
    {
      std::string name;
      /// Indices into `elements`.
      std::vector<unsigned int> elements;
      /// The corners of each face.
      std::vector<Nodes> faces;
      Nodes              nodes;
    };

    std::vector<dealii::Point<3>> nodes;
    std::vector<Element>          elements;
    /// All named sets, in the order in which they are listed.
    std::vector<Group> groups;
    /// The indices of nodes by instance (in upper case, empty: none) and number in the file; empty
    /// if the format has no numbers.
    std::map<std::string, std::unordered_map<std::size_t, unsigned int>> numbers;
    /// Messages for the user about the file.
    std::vector<std::string> notes;

    /// Index of the first node that is not in the file, but was created by dividing cells (see
    /// hex_subdivision.h).
    unsigned int first_inserted = -1;

    /// For cells that were divided: the corners of the face of the file of which a face at the
    /// boundary is a part, by the sorted corners of the latter.
    std::map<Nodes, Nodes> whole_faces;

    /// @return the corners of the face of the file of which a boundary face is a part; the corners
    /// themselves if its cell was not divided.
    /// @param corners of the boundary face, in any order
    const Nodes &
    parent_face(const Nodes &corners) const;
    /// Scalar fields by name: one value for each node, NaN where the file has none.
    std::map<std::string, std::vector<double>> fields;

    /// @return the group of a name, which is created if there is none.
    /// @param name the name
    Group &
    group(const std::string &name);
  };

  /// @return the dimension of a shape, 0 to 3; 4 if the shape is unknown, so that it is never a
  /// cell.
  /// @param shape the shape
  unsigned int
  dimension_of(MeshFile::Shape shape);

  /// @return the number of corners of a shape; 0 if it is unknown.
  /// @param shape the shape
  unsigned int
  n_corners(MeshFile::Shape shape);

  /// @return the corners of an element; all nodes if its shape is unknown.
  /// @param element the element
  MeshFile::Nodes
  corners_of(const MeshFile::Element &element);

  /// @return names of the groups that have elements of a dimension, in the order of the file.
  /// @param file the mesh file
  /// @param dim the dimension
  std::vector<std::string>
  part_names(const MeshFile &file, unsigned int dim);

  /// Read a mesh file in the format that its extension says. Throws SceneError with the name of the
  /// file if it cannot be opened, has another extension, or its contents are not valid.
  /// @param file_name path with the extension .msh, .inp, .vtk or .vtu, in any case
  /// @return the contents
  MeshFile
  read_mesh_file(const std::string &file_name);

  /// @return the formats as a text for messages and help: ".msh (Gmsh), ...".
  std::string
  mesh_formats();
} // namespace Signorini
