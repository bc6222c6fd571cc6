// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// The shape that belongs to the name of an element type of Abaqus or CalculiX.
  struct AbaqusType
  {
    MeshFile::Shape shape = MeshFile::Shape::unknown;
    /// Number of nodes; 0: as many as the data line has.
    unsigned int n_nodes = 0;
  };

  /// @return the shape of an element type; unknown if the type is not supported.
  /// @param name in upper case, such as C3D8R, CPS4, S4, T3D2, MASS
  AbaqusType
  abaqus_type(const std::string &name);

  /// @return the nodes of an element in the order of MeshFile::Element.
  /// @param type of the element
  /// @param nodes in the order of Abaqus
  MeshFile::Nodes
  reordered(const AbaqusType &type, MeshFile::Nodes nodes);

  /// @return the corners of the faces of an element with a label; all faces if the label is empty;
  /// none for shapes that are not cells, and for unknown labels.
  /// @param element the element
  /// @param label S1 to S6 of solids, S1 to S4 (or E1 to E4) of plane cells, SPOS and SNEG for the
  /// plane cell itself
  std::vector<MeshFile::Nodes>
  abaqus_faces(const MeshFile::Element &element, const std::string &label);
} // namespace Signorini
