// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Signorini
{
  /// Reverse cells whose nodes are listed with negative orientation. Throws SceneError with the
  /// number of cells that are folded or flat, and with the element and the corner of the first.
  /// @param cells the cells, which are changed
  /// @param vertices to which they refer
  /// @param elements the element of each cell, for the message
  template <int dim>
  void
  orient(std::vector<dealii::CellData<dim>>           &cells,
         const std::vector<dealii::Point<dim>>        &vertices,
         const std::vector<const MeshFile::Element *> &elements);

  /// Pairs of nodes of a mesh that are closer to each other than a distance. Refers to the cells
  /// and vertices.
  template <int dim>
  class CoincidingNodes
  {
  public:
    /// Find the pairs.
    /// @param cells the mesh; other vertices are ignored
    /// @param vertices to which the cells refer
    /// @param distance [length] up to which nodes coincide; 0 stands for 1e-3 of the shortest edge
    /// of the cells
    CoincidingNodes(const std::vector<dealii::CellData<dim>> &cells,
                    const std::vector<dealii::Point<dim>>    &vertices,
                    double                                    distance);

    /// @return for each vertex the one that replaces it if nodes are merged: the lowest index among
    /// those that coincide, itself for all others.
    std::vector<unsigned int>
    representatives() const;

    /// Throws SceneError if nodes coincide although their cells are connected elsewhere, which is a
    /// crack; with the number of such pairs and the position of the first.
    /// @return a message about coinciding nodes of pieces that are not connected; empty if there
    /// are none
    std::string
    reject_cracks() const;

  private:
    const std::vector<dealii::CellData<dim>> &cells;
    const std::vector<dealii::Point<dim>>    &vertices;
    /// Pairs of coinciding nodes, the lower index first, sorted.
    std::vector<std::pair<unsigned int, unsigned int>> pairs;
  };

  /// Throws SceneError if a node at the boundary lies inside an edge of the boundary of the same
  /// connected piece: cells of different sizes meet there without sharing nodes, and would
  /// separate. Separate pieces that touch are accepted.
  /// @param cells the mesh
  /// @param boundary_faces all faces with one cell only
  /// @param vertices to which both refer
  template <int dim>
  void
  reject_hanging_nodes(const std::vector<dealii::CellData<dim>>     &cells,
                       const std::vector<dealii::CellData<dim - 1>> &boundary_faces,
                       const std::vector<dealii::Point<dim>>        &vertices);

  /// Decides which groups of a mesh file name a boundary face: those that contain the face, and
  /// sets of nodes that contain all its corners. A set with all nodes of the part names nothing.
  /// Refers to the file and the representatives.
  class FaceNames
  {
  public:
    /// @param file the mesh file
    /// @param dim dimension of the cells, 2 or 3
    /// @param names the groups that are boundaries, of which the first one that contains a face
    /// names it; empty: all groups, and a face has the names of all that contain it
    /// @param representatives of all nodes, after merging
    /// @param part_nodes the nodes of the cells of the part
    FaceNames(const MeshFile                  &file,
              unsigned int                     dim,
              const std::vector<std::string>  &names,
              const std::vector<unsigned int> &representatives,
              const std::vector<unsigned int> &part_nodes);

    /// @return indices of the names of a face; none if no group contains it.
    /// @param corners of the face in the mesh, which may be a part of a face of the file
    std::set<unsigned int>
    operator()(const MeshFile::Nodes &corners) const;

    /// @return a name.
    /// @param index as operator() returns it
    const std::string &
    name(const unsigned int index) const
    {
      return names[index];
    }

    /// @return messages about sets of nodes that are only partly a boundary, because some of their
    /// nodes are on no face with all its corners in the set.
    /// @param faces the corners of all boundary faces
    /// @param part_nodes the nodes of the cells of the part
    std::vector<std::string>
    notes(const std::vector<MeshFile::Nodes> &faces,
          const std::vector<unsigned int>    &part_nodes) const;

  private:
    /// Register a name of a face.
    void
    add(const MeshFile::Nodes &face, unsigned int name);

    const MeshFile                                   &file;
    const std::vector<unsigned int>                  &representatives;
    const bool                                        in_order;
    std::vector<std::string>                          names;
    std::map<MeshFile::Nodes, std::set<unsigned int>> by_face;
    std::vector<std::pair<unsigned int, std::vector<bool>>>
      /// Indices of names, with one entry for each node of the file: whether it is in the set.
      node_sets;
  };

  /// A set of boundary faces that are connected without a kink.
  template <int dim>
  struct SmoothPatch
  {
    /// Indices into the list of faces, in ascending order.
    std::vector<unsigned int> faces;
    /// The centre of gravity of the patch.
    dealii::Point<dim> center;
  };

  /// Divide faces into patches where they meet at more than a feature angle.
  /// @param faces with vertices in deal.II's order
  /// @param vertices of the mesh
  /// @param angle [degrees] between the normals of neighbouring faces above which they are in
  /// different patches; 0 is flat
  /// @return the patches in the order of the first coordinate of their centres, then of the second,
  /// the third, and of their extent: an order that does not depend on the numbers of nodes and
  /// elements
  template <int dim>
  std::vector<SmoothPatch<dim>>
  smooth_patches(const std::vector<dealii::CellData<dim - 1>> &faces,
                 const std::vector<dealii::Point<dim>>        &vertices,
                 double                                        angle);
} // namespace Signorini
