// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/formats/abaqus_sets.h"
#include "mesh_import/mesh_file.h"

#include <set>

namespace Signorini
{
  /// The mesh of an input file of Abaqus or CalculiX, with the nodes, elements and sets by which
  /// the rest of the file refers to it.
  struct AbaqusDeck
  {
    /// Nodes, elements and groups.
    MeshFile mesh;
    /// Numbers and named sets of nodes and elements, with indices as in `mesh`.
    AbaqusSets nodes, elements;
    std::map<std::string, std::vector<std::string>>
      /// Names of the instances of each part, by the name of the part in upper case.
      instances_of;
    /// Names, in upper case, of the surfaces of contact pairs of which nodes were moved by ADJUST.
    std::set<std::string> adjusted;
    /// Elements that are left out, since they are removed in the first step and never come back.
    std::set<unsigned int> removed_elements;
    /// Messages about names and faces in sets and surfaces that do not exist in the file.
    std::vector<std::string> missing;
  };

  /// Read an input file of Abaqus or CalculiX, flat or with parts and instances. The groups of the
  /// mesh are: instances and element sets (with elements), element surfaces (with faces; without a
  /// face label all faces of the elements), node sets and node surfaces (with nodes), and the faces
  /// that *DLOAD loads. Sets of a part are called INSTANCE.NAME. Materials, steps and all other
  /// keywords are ignored; of the type of an element only its shape matters. Throws SceneError with
  /// file and line if something is not understood, or if a keyword that creates nodes or elements
  /// is not supported.
  /// @param file_name path of the file
  /// @return the mesh and its names
  AbaqusDeck
  read_abaqus_deck(const std::string &file_name);

  /// @return whether a label of *DLOAD is a pressure on a face of an element: P1 to P6.
  /// @param label in upper case
  bool
  is_pressure_label(const std::string &label);

  /// @return the name of the surface of the faces on which the n-th *DLOAD of a file has its k-th
  /// different pressure: "DLOAD 2", then "DLOAD 2 2".
  /// @param n,k counted from 1
  std::string
  name_of_loaded_faces(unsigned int n, unsigned int k);

  /// @return the name of the other side of a section along which *PRE-TENSION SECTION cuts the
  /// mesh.
  /// @param section name of its surface
  std::string
  other_side_of(const std::string &section);

  /// @return the mesh of read_abaqus_deck() alone.
  /// @param file_name path of the file
  MeshFile
  read_abaqus(const std::string &file_name);
} // namespace Signorini
