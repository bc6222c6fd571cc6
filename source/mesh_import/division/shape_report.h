// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// How well shaped the cells are into which the elements of a file are divided. The scaled
  /// Jacobian at a corner is the volume (2D: area) that the unit vectors along its edges span: 1 in
  /// a cube, at least 0.71 in the parts of a regular tetrahedron, 0 where it is flat.
  class ShapeReport
  {
  public:
    ShapeReport(const MeshFile &file, unsigned int dim)
      : file(file)
      , dim(dim)
    {}

    /// The next child of an element; the children of one come one after the other.
    void
    add(const MeshFile::Element &element, const MeshFile::Element &child);

    /// What was bad. Throws SceneError if elements are folded or flat.
    std::vector<std::string>
    notes();

  private:
    struct WorstCell
    {
      std::size_t      number; ///< of the element
      std::string      type;
      double           quality; ///< smallest scaled Jacobian
      dealii::Point<3> place;   ///< the corner
    };

    void
    finish();
    std::string
    text_of(const WorstCell &one) const;

    const MeshFile    &file;
    const unsigned int dim;

    const MeshFile::Element *present = nullptr;
    double                   least = 0, largest = 0; ///< of the present element
    dealii::Point<3>         position_of_least, position_of_largest;
    bool                     bends = false;

    std::vector<WorstCell> worst; ///< the worst first
    unsigned int           n_poor = 0, n_folded = 0;
    std::string            first_folded;
  };
} // namespace Signorini
