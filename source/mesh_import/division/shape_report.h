// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Collects the quality of the cells into which the elements of a file are divided. The scaled
  /// Jacobian at a corner is the volume (2D: area) that the unit vectors along its edges span: 1 in
  /// a cube, at least 0.71 in the parts of a regular tetrahedron, 0 where the cell is flat.
  class ShapeReport
  {
  public:
    /// @param file the mesh, to whose nodes and elements the report refers
    /// @param dim 2 or 3
    ShapeReport(const MeshFile &file, unsigned int dim)
      : file(file)
      , dim(dim)
    {}

    /// Add the next child of an element. All children of one element must be added in sequence.
    /// @param element of the file
    /// @param child one of the cells into which it is divided
    void
    add(const MeshFile::Element &element, const MeshFile::Element &child);

    /// Throws SceneError with the number of elements that are folded or flat, and with the first of
    /// them.
    /// @return a message about the worst cells; none if no element was added
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

    /// Add the present element to the statistics.
    void
    finish();
    /// @return number, type, quality and position of an element, for messages.
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
