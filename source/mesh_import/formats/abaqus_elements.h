// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// The shape behind the name of an element type of Abaqus or CalculiX.
  struct AbaqusType
  {
    MeshFile::Shape shape   = MeshFile::Shape::unknown;
    unsigned int    n_nodes = 0; ///< 0: as many as the data line has
  };

  /// `name` in upper case: C3D8R, CPS4, S4, T3D2, MASS...
  AbaqusType
  abaqus_type(const std::string &name);

  /// From the order of the nodes in Abaqus to that of MeshFile.
  MeshFile::Nodes
  reordered(const AbaqusType &type, MeshFile::Nodes nodes);

  /// Corners of the face with a label: S1 to S6 of solids, S1 to S4 (or E1 to E4) of plane cells,
  /// SPOS and SNEG for the plane cell itself, and all of these if there is no label. No face for
  /// other shapes, which are no cells; nor for an unknown label.
  std::vector<MeshFile::Nodes>
  abaqus_faces(const MeshFile::Element &element, const std::string &label);
} // namespace Signorini
