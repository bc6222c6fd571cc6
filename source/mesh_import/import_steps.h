// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <deal.II/grid/tria.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Signorini
{
  /// Recognise degenerate elements: some programs write a wedge, a pyramid or a tetrahedron as a
  /// hexahedron with repeated corners, and a triangle as a quadrilateral. Such elements get the
  /// shape that they really have. Elements that are none of these are not changed.
  /// @param file the mesh whose elements are replaced
  /// @param elements indices of the elements to consider
  void
  recognise_collapsed_cells(MeshFile &file, const std::vector<unsigned int> &elements);

  /// Merge nodes that coincide, in elements, groups and numbers. Cells that are to be divided must
  /// be connected before: otherwise neighbours that meet at nodes of their own may be divided
  /// differently.
  /// @param file the mesh, which is changed
  /// @param dim 2 or 3
  /// @param part the group whose cells' nodes are considered; empty: all cells of that dimension
  /// @param distance [length] up to which nodes coincide; 0: 1e-3 of the shortest edge
  void
  merge_coinciding_nodes(MeshFile          &file,
                         unsigned int       dim,
                         const std::string &part,
                         double             distance);

  /// Cut the cells of a mesh along a plane surface inside of it, such as a section through a bolt.
  /// The nodes of the surface are doubled: cells on one side keep them, those on the other get the
  /// copies, in all groups too. The faces of the other side become a group of their own. Throws
  /// SceneError if there is no such surface, or if it is not about plane, not inside of the mesh,
  /// or ends there.
  /// @param file the mesh
  /// @param surface name of a group with faces, in any case of letters
  /// @param other_side name of the new group
  /// @return the copy of each node that was doubled
  std::map<unsigned int, unsigned int>
  cut_mesh(MeshFile &file, const std::string &surface, const std::string &other_side);

  /// Divide triangles into three quadrilaterals, tetrahedra into four and wedges into six
  /// hexahedra, at the middles of their edges and the centres of faces and cells; and likewise,
  /// into four or eight, the quadrilaterals or hexahedra that are connected with them by edges. A
  /// pyramid cannot be divided in this way, because four edges meet at its apex: it and all cells
  /// connected with it by quadrilaterals are divided into tetrahedra first. Connected pieces that
  /// consist of quadrilaterals or hexahedra alone are not changed.
  ///
  /// Neighbours share all nodes. Cells of second order become cells of 9 or 27 nodes that have
  /// exactly the same shape, straight ones become cells of 4 or 8 nodes. Children have the type and
  /// number of their element. Groups of cells contain the children; node sets get the new nodes
  /// that lie between nodes in them; `whole_faces` says of which face in the file each boundary
  /// face is a part, so that boundaries keep their faces. Throws SceneError, without the file's
  /// name, if cells are folded or flat.
  /// @param file the mesh, which is changed
  /// @param dim 2 or 3
  /// @param part the group whose cells these are; empty: all cells
  /// @param mid_side_nodes false: move mid-side nodes of divided cells to the positions that the
  /// corners alone determine
  /// @return messages for the user: what was divided, and the worst cells; none if nothing had to
  /// be divided
  std::vector<std::string>
  divide_cells(MeshFile &file, unsigned int dim, const std::string &part, bool mid_side_nodes);

  /// Cut the quadrilaterals, pyramids, wedges and hexahedra among some cells into triangles or
  /// tetrahedra, see simplices_of(). Throws SceneError as divide_cells().
  /// @param cells numbers of the elements, all of dimension `dim`
  /// @param mid_side_nodes see divide_cells()
  /// @return messages for the user: what was cut, and a warning about nearly flat cells
  std::vector<std::string>
  cut_into_simplices(MeshFile                        &file,
                     unsigned int                     dim,
                     const std::vector<unsigned int> &cells,
                     bool                             mid_side_nodes);

  /// Creates the sets of nodes, faces and elements that a scene defines by their numbers in a mesh
  /// file:
  ///
  ///     NAME: 1, 4-7; OTHER NAME: 9
  ///
  /// All functions throw SceneError for texts of another form, for numbers that do not exist, and
  /// for names that the file has already.
  class NumberedSets
  {
  public:
    /// @param file the mesh file, whose names are taken
    /// @param cells indices of the elements to which numbers refer: those of the body
    NumberedSets(const MeshFile &file, const std::vector<unsigned int> &cells);

    /// Add sets of nodes.
    /// @param text items NUMBER, FIRST-LAST, INSTANCE.NUMBER, INSTANCE.FIRST-LAST
    /// @param file to whose groups the sets are added
    void
    add_nodes(const std::string &text, MeshFile &file) const;

    /// Add sets of faces of elements, with the labels of Abaqus.
    /// @param text items NUMBER.LABEL, FIRST-LAST.LABEL
    /// @param file to whose groups the sets are added
    void
    add_faces(const std::string &text, MeshFile &file) const;

    /// Add sets of elements.
    /// @param text items NUMBER, FIRST-LAST
    /// @param file to whose groups the sets are added
    void
    add_cells(const std::string &text, MeshFile &file) const;

  private:
    using Numbers = std::unordered_map<std::size_t, unsigned int>;

    /// Names of the groups in the file, which are taken.
    std::set<std::string> names;
    Numbers               elements;
  };

  /// Give cells of second order the shape of their mid-side nodes. Each cell that is not straight
  /// gets a manifold of its own, which its faces and lines share unless a neighbour came first:
  /// both agree on the common nodes. Throws SceneError with the element if a curved cell is folded.
  /// @param triangulation a coarse mesh whose cells correspond to the elements
  /// @param file the mesh file with the nodes
  /// @param elements the element of each cell of the triangulation
  /// @param first manifold id; the others follow
  /// @return the number of curved cells, i.e. of manifold ids that were used
  template <int dim>
  unsigned int
  curve_cells(dealii::Triangulation<dim>                   &triangulation,
              const MeshFile                               &file,
              const std::vector<const MeshFile::Element *> &elements,
              dealii::types::manifold_id                    first);
} // namespace Signorini
