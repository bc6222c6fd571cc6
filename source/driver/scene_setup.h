// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include "scene/decisions.h"
#include "solid/elasticity.h"
#include <signorini/scene/scene.h>

#include <deal.II/base/conditional_ostream.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// @return the scene that stands in a section, with the files that it names, checked, and with
  /// the notes for the user. Throws SceneError.
  /// @param name of the scene
  /// @param folder in which files are searched for after the working directory
  template <int dim>
  Scene<dim>
  read_scene(RawSection &raw, const std::string &name, const std::string &folder);

  /// The bodies of a scene in one mesh, refined where the scene says. Collective.
  template <int dim>
  std::unique_ptr<Mesh<dim>>
  make_mesh(const Decisions<dim> &decisions, MPI_Comm comm);

  /// Their elasticity, with what acts on them, on that mesh; not set up yet.
  template <int dim>
  std::unique_ptr<Elasticity<dim>>
  make_elasticity(const Decisions<dim> &decisions, const Mesh<dim> &mesh);

  /// The pairs that Names = auto stands for: all surfaces that see each other, not
  /// through the wall of a body, and of which one can move. Collective.
  /// @param out warned where surfaces may overlap that are none
  template <int dim>
  std::vector<ContactPair<dim>>
  automatic_pairs(const Scene<dim> &scene, const Mesh<dim> &mesh, dealii::ConditionalOStream &out);
} // namespace Signorini
