// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/mesh/generator.h>

namespace Signorini
{
  // All generators but that of mesh files; each has its file here, and its line in the registry of
  // MeshGenerator::create().

  template <int dim>
  std::unique_ptr<MeshGenerator<dim>>
  make_box();

  template <int dim>
  std::unique_ptr<MeshGenerator<dim>>
  make_ring();

  std::unique_ptr<MeshGenerator<2>>
  make_disc();

  std::unique_ptr<MeshGenerator<3>>
  make_sphere();

  std::unique_ptr<MeshGenerator<3>>
  make_shell();
} // namespace Signorini
