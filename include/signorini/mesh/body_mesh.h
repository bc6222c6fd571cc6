// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/mesh/generator.h>
#include <signorini/parameters/expression.h>

namespace Signorini
{
  /// The mesh of one body, as the scene describes it.
  template <int dim>
  struct BodyMesh
  {
    std::string                         type = "box";
    std::shared_ptr<MeshGenerator<dim>> generator;
    /// Map of the generated mesh; empty: none.
    VectorExpression<dim> transformation;
    unsigned int          refinements = 0;
    /// Polynomial degree of curved cells, see Mesh::mapping().
    unsigned int degree = 2;
    /// Names of the sets of cells that have materials of their own; for a cell in several the last
    /// one is valid.
    std::vector<std::string> cells_of_materials;

    /// Declare the keys, also those of the generator, and read their values. Throws SceneError.
    /// @param section of the body
    void
    declare(Section &section);
  };
} // namespace Signorini
