// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/configuration.h"

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// Faces of a boundary on locally owned cells.
  template <int dim>
  struct BoundaryFaces
  {
    std::vector<std::pair<CellIterator<dim>, unsigned int>> faces; ///< cell and number of the face
    std::vector<FacePatch<dim>>                             patches; ///< where they are
    std::vector<FacePatch<dim>>                             rest;    ///< where they were
    /// Where they were when the load step started; empty: nobody asks for the slip.
    std::vector<FacePatch<dim>> start;

    /// At rest.
    BoundaryFaces(const Elasticity<dim> &elasticity, const std::string &boundary);

    BoundaryFaces(const Configuration<dim> &configuration, const std::string &boundary);

    /// Which faces they are, by cell and number.
    using Choice = std::function<bool(const CellIterator<dim> &, unsigned int)>;

    BoundaryFaces(const Configuration<dim> &configuration, const Choice &choice);

    /// Those for which that is true. @param chosen one a face
    BoundaryFaces
    among(const std::vector<bool> &chosen) const;

    /// Of the cell behind face i: h.
    double
    depth(unsigned int i) const;

    /// E of that cell.
    double
    modulus(const Elasticity<dim> &elasticity, unsigned int i) const;

    /// E/h of that cell.
    double
    stiffness(const Elasticity<dim> &elasticity, unsigned int i) const;

  private:
    BoundaryFaces() = default;
  };

  /// The sides of a face, by the parameter that is constant there: 2 d + (0 or 1).
  template <int dim>
  using SidesOfFace = std::array<bool, 2 * (dim - 1)>;

  /// The sides of each face behind which the boundary goes on, on this rank or another.
  template <int dim>
  std::vector<SidesOfFace<dim>>
  inner_sides(const Mesh<dim> &mesh, const std::string &boundary, const BoundaryFaces<dim> &faces);
} // namespace Signorini
