// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <map>
#include <vector>

namespace Signorini
{
  /// The edges, faces and nodes of a shape of cells of mesh files, and its midpoint subdivision:
  /// one child at each corner, between the corner, the middles of its edges, the centres of its
  /// faces and that of the cell. A child is a hexahedron if three edges meet at its corner, and a
  /// quadrilateral in 2D.
  ///
  /// Triangle, tetrahedron, quadrilateral, hexahedron and wedge are products of simplices (a line
  /// is one too). So are their functions of second order: the product over the simplices of either
  /// a barycentric coordinate L_i or 4 L_i L_j. The map from the reference cell to a child in it is
  /// trilinear in all L, so that the child of a quadratic cell is exactly a triquadratic cell of 27
  /// nodes.
  class CellShape
  {
  public:
    /// A set of corners of the cell, bit by bit. It represents the corner, edge, face or cell that
    /// they span, and the node at its centre.
    using Corners = unsigned int;

    /// @return the shape, which is created at the first call and kept (not thread-safe). Pyramids
    /// have no children and no weights.
    /// @param shape of a cell in 2D or 3D
    static const CellShape &
    of(MeshFile::Shape shape);

    unsigned int dim;
    /// The edges, and the faces around (of plane cells the edges).
    std::vector<MeshFile::Nodes> edges, faces;
    /// For each node of the cell, up to that at the centre of the cell, the set of corners of which
    /// it is the centre, in the order of MeshFile::Element; cells may have fewer nodes.
    std::vector<Corners> nodes;
    /// For the child at each corner the sets of which its corners are the centres, in the order of
    /// MeshFile.
    std::vector<std::vector<Corners>> children;

    /// @return the set of all corners, which is the cell itself.
    Corners
    all() const
    {
      return (1u << n_corners) - 1;
    }

    unsigned int n_corners;

    /// @return the corners, as indices into MeshFile::nodes, between which a node of a cell lies.
    /// @param i position of the node in the list of the cell
    /// @param cell an element of this shape
    MeshFile::Nodes
    corners_around(unsigned int i, const MeshFile::Element &cell) const;

    /// @return the volume that the three edges from the first of four corners span in the reference
    /// cell (2D: with three corners, twice the area of their triangle); negative if they are
    /// left-handed.
    /// @param corners numbers of corners of the cell
    double
    orientation(const MeshFile::Nodes &corners) const;

    /// The weights of the nodes of a cell in the interpolated position at a point, one for each
    /// node.
    using Weights = std::vector<double>;

    /// Weights of cells with a certain number of nodes.
    struct SecondOrder
    {
      /// For each child and each of its 27 (2D: 9) nodes the weights of the nodes of the cell.
      std::vector<std::vector<Weights>> children;
      /// For each node behind the corners the weights of its offset from the position that the
      /// nodes before it define: the offset is zero in a cell with straight, evenly divided edges.
      std::vector<Weights> bends;
      /// The weights of the position of the centre.
      Weights center;
    };

    /// @return the weights of cells of this shape with a given number of nodes; computed at the
    /// first call and kept.
    /// @param n_nodes at least the number of corners
    const SecondOrder &
    second_order(unsigned int n_nodes) const;

  private:
    explicit CellShape(MeshFile::Shape shape);

    /// The barycentric coordinates L of all simplices, one simplex after the other.
    using Coordinates = std::vector<double>;

    void
    add_children();
    Coordinates
    center_of(const std::vector<Coordinates> &points, Corners which) const;
    double
    function(Corners node, const Coordinates &point) const;
    Weights
    weights(unsigned int n_nodes, const Coordinates &point) const;

    /// Number of corners of each simplex.
    std::vector<unsigned int>                   simplices;
    std::vector<Coordinates>                    corners;
    mutable std::map<unsigned int, SecondOrder> by_n_nodes;
  };

  /// @return the nodes of a cell, such as those of one of its faces.
  /// @param element the cell
  /// @param positions in its list of nodes
  MeshFile::Nodes
  nodes_at(const MeshFile::Element &element, const MeshFile::Nodes &positions);
} // namespace Signorini
