// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/division/centers.h"
#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Divide a quadrilateral into two triangles, or a pyramid, wedge or hexahedron into two, three
  /// or six tetrahedra, of second order if the cell is.
  ///
  /// Each face is divided by the diagonal at its corner with the lowest node number, so that
  /// neighbours agree; the simplices are cones from the lowest corner of the cell over the
  /// triangles of the faces (in the plane the edges) that do not contain it (J. Dompierre, P.
  /// Labbé, M.-G. Vallet, R. Camarero: How to subdivide pyramids, prisms, and hexahedra into
  /// tetrahedra, 8th International Meshing Roundtable 1999).
  /// @param cell the element; a triangle or tetrahedron is returned unchanged
  /// @param file the mesh, to which nodes of second order may be appended
  /// @param centers the nodes of second order
  /// @return the simplices, with type and number of the cell
  std::vector<MeshFile::Element>
  simplices_of(const MeshFile::Element &cell, MeshFile &file, Centers &centers);

  /// @return the two triangles into which this rule divides a quadrilateral.
  /// @param around its corners, in cyclic order
  std::vector<MeshFile::Nodes>
  triangles_of(const MeshFile::Nodes &around);

  /// @return whether cells, not only simplices, become triangles or tetrahedra of second order with
  /// the nodes that they have, and few more: all have nodes of second order, and not all are
  /// quadrilaterals or hexahedra.
  /// @param file the mesh
  /// @param cells numbers of elements
  bool
  can_be_cut(const MeshFile &file, const std::vector<unsigned int> &cells);

  /// Check triangles or tetrahedra that are not divided. Throws SceneError if some are flat, or if
  /// neighbours of second order have different nodes on their common edge.
  /// @param file the mesh
  /// @param cells numbers of elements
  /// @param dim 2 or 3
  /// @return a warning about nearly flat ones; none if there are none
  std::vector<std::string>
  check_simplices(MeshFile &file, const std::vector<unsigned int> &cells, unsigned int dim);

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

    /// notes() without that about shapes that are no matter.
    std::vector<std::string>
    warnings();

  private:
    struct WorstCell
    {
      /// Number of the element.
      std::size_t number;
      std::string type;
      /// Smallest scaled Jacobian.
      double quality;
      /// Position of the corner where it is smallest.
      dealii::Point<3> place;
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
    /// Extreme scaled Jacobians of the present element.
    double           least = 0, largest = 0;
    dealii::Point<3> position_of_least, position_of_largest;
    bool             bends = false;

    /// The worst elements so far, the worst first.
    std::vector<WorstCell> worst;
    unsigned int           n_poor = 0, n_folded = 0;
    std::string            first_folded;
  };
} // namespace Signorini
