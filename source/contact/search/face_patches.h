// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/face_patch.h"
#include "mesh/mesh.h"

#include <deal.II/fe/fe_values.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// Makes patches of boundary faces, of the true shape of the boundary, see
  /// Mesh::surface_mapping(). The points that a mapping needs are found once a face.
  template <int dim>
  class FacePatches
  {
  public:
    explicit FacePatches(const Mesh<dim> &mesh);

    /// Of the lowest degree that has the shape up to 3e-6 of the face's diameter: what is evaluated
    /// most in a search are patches.
    FacePatch<dim>
    operator()(const typename dealii::Triangulation<dim>::cell_iterator &cell, unsigned int face);

  private:
    const unsigned int degree;
    /// Of each face of a cell.
    std::vector<std::unique_ptr<dealii::FEValues<dim>>> values;
  };
} // namespace Signorini
