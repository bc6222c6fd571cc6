#pragma once

#include <signorini/contact/geometry/configuration.h>

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

    /// At rest.
    BoundaryFaces(const Elasticity<dim> &elasticity, const std::string &boundary);

    BoundaryFaces(const Configuration<dim> &configuration, const std::string &boundary);

    /// Of the cell behind face i: h.
    double
    depth(unsigned int i) const;

    /// E of that cell.
    double
    modulus(const Elasticity<dim> &elasticity, unsigned int i) const;

    /// E/h of that cell.
    double
    stiffness(const Elasticity<dim> &elasticity, unsigned int i) const;
  };
} // namespace Signorini
