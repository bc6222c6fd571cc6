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

    /// The geometry of a boundary face, of the lowest degree that reproduces it to 3e-6 of the
    /// face's diameter: a search spends most of its time in evaluating patches.
    FacePatch<dim>
    operator()(const typename dealii::Triangulation<dim>::cell_iterator &cell, unsigned int face);

  private:
    const unsigned int degree;
    /// Evaluation of the mapping on each face of a cell, by its shape; empty if no body has it.
    std::vector<std::unique_ptr<dealii::FEValues<dim>>> of_hypercubes, of_simplices;
  };
} // namespace Signorini
