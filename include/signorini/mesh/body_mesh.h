// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/mesh/generator.h>
#include <signorini/parameters/expression.h>

namespace Signorini
{
  /// What the scene says about the mesh of one body.
  template <int dim>
  struct BodyMesh
  {
    std::string                         type = "box";
    std::shared_ptr<MeshGenerator<dim>> generator;
    VectorExpression<dim>               transformation; ///< empty: none
    unsigned int                        refinements = 0;
    unsigned int                        degree      = 2; ///< of curved cells, see Mesh::mapping()
    /// Sets of cells that have materials of their own; of a cell in several the last one counts.
    std::vector<std::string> cells_of_materials;

    void
    declare(Section &section);
  };
} // namespace Signorini
