// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/configuration.h"
#include <signorini/contact/pair.h>

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The faces of a boundary on locally owned cells, with their geometry.
  template <int dim>
  struct BoundaryFaces
  {
    std::vector<std::pair<CellIterator<dim>, unsigned int>> faces; ///< cell and number of the face
    std::vector<FacePatch<dim>> patches; ///< geometry in the configuration, one for each face
    std::vector<FacePatch<dim>> rest;    ///< geometry in the reference configuration
    /// Geometry at the start of the load step; empty unless the configuration has a start.
    std::vector<FacePatch<dim>> start;

    /// In the reference configuration.
    BoundaryFaces(const Elasticity<dim> &elasticity, const std::string &boundary);

    BoundaryFaces(const Configuration<dim> &configuration, const std::string &boundary);

    /// A predicate that selects faces by cell and face number.
    using Choice = std::function<bool(const CellIterator<dim> &, unsigned int)>;

    BoundaryFaces(const Configuration<dim> &configuration, const Choice &choice);

    /// Where the slave of a pair meets its master: the image, shifted by a pretension; the cells
    /// are those of the master.
    static BoundaryFaces
    of_master(const Configuration<dim> &configuration, const ContactPair<dim> &pair);

    /// The faces for which `chosen` is true. @param chosen one flag for each face
    BoundaryFaces
    among(const std::vector<bool> &chosen) const;

    /// The mean of the outward unit normals in the reference configuration, over the faces of all
    /// ranks; zero if there are none. Collective.
    dealii::Tensor<1, dim>
    mean_normal(MPI_Comm comm) const;

    /// The size h of the cell behind face i, normal to the face [length].
    double
    depth(unsigned int i) const;

    /// Young's modulus E of the cell behind face i.
    double
    modulus(const Elasticity<dim> &elasticity, unsigned int i) const;

    /// E/h of the cell behind face i [force/length^3].
    double
    stiffness(const Elasticity<dim> &elasticity, unsigned int i) const;

  private:
    BoundaryFaces() = default;
  };

  /// Call visit(cell, face) for the faces of some boundaries on the cells of this rank and on ghost
  /// cells.
  /// @param cells all active cells
  /// @param ids of the boundaries
  template <typename Cells, typename Visit>
  void
  for_each_face(const Cells &cells, const BoundaryIds &ids, const Visit &visit)
  {
    for (const auto &cell : cells)
      if (!cell->is_artificial() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && ids.count(cell->face(f)->boundary_id()) > 0)
            visit(cell, f);
  }

  /// Flags of the sides of a face, see ends_of_side(); a triangle has the first three.
  template <int dim>
  using SidesOfFace = std::array<bool, 2 * (dim - 1)>;

  /// The sides of each face behind which the boundary continues, on this rank or another.
  template <int dim>
  std::vector<SidesOfFace<dim>>
  inner_sides(const Mesh<dim> &mesh, const std::string &boundary, const BoundaryFaces<dim> &faces);
} // namespace Signorini
