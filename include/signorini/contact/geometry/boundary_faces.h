#pragma once

#include <signorini/contact/geometry/face_patch.h>
#include <signorini/elasticity/elasticity.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  template <int dim>
  using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /// Faces of a boundary on locally owned cells.
  template <int dim>
  struct BoundaryFaces
  {
    std::vector<std::pair<CellIterator<dim>, unsigned int>> faces; ///< cell and number of the face
    std::vector<FacePatch<dim>>                             patches;

    BoundaryFaces(const Elasticity<dim> &elasticity, const std::string &boundary);

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
