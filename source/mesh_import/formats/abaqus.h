// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/formats/abaqus_sets.h"
#include "mesh_import/mesh_file.h"

#include <set>

namespace Signorini
{
  /// The mesh of an input file of Abaqus or CalculiX, and what its numbers and names stand for.
  struct AbaqusDeck
  {
    MeshFile   mesh;
    AbaqusSets nodes, elements;
    std::map<std::string, std::vector<std::string>>
      instances_of; ///< names of the instances of each part, by its name in upper case
    std::set<std::string>    adjusted; ///< surfaces, in upper case, of which nodes were moved
    std::vector<std::string> missing;  ///< names and faces that sets and surfaces have of nothing
  };

  /// Read an input file of Abaqus or CalculiX, flat or of parts and instances. Groups: instances
  /// and element sets (the elements), element surfaces (the faces; without a face label all faces
  /// of the elements), node sets and node surfaces (the nodes); and the faces that *DLOAD loads.
  /// What an instance has of its part is called INSTANCE.NAME. Materials, steps and all else are
  /// left out; the type of an element says its shape and no more. Throws SceneError with file and
  /// line if something cannot be understood, or if a keyword that makes nodes or elements is not
  /// known here.
  AbaqusDeck
  read_abaqus_deck(const std::string &file_name);

  /// P1 to P6: a pressure on a face of an element.
  bool
  is_pressure_label(const std::string &label);

  /// The surface of the faces on which the n-th *DLOAD of a file has its k-th different pressure,
  /// both counted from 1: "DLOAD 2", then "DLOAD 2 2".
  std::string
  name_of_loaded_faces(unsigned int n, unsigned int k);

  /// The mesh alone.
  MeshFile
  read_abaqus(const std::string &file_name);
} // namespace Signorini
