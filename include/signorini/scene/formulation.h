#pragma once

#include <signorini/scene/scene.h>

namespace Signorini
{
  /// Which bodies are mixed: those that the user wants to be, and those that displacements alone
  /// would lock or take hundreds of iterations for, if nothing in the scene is against it. A mixed
  /// body has Degree = 2 where nobody says it, and so has one of displacements alone that would
  /// lock and of which a quantity is wanted. Throws SceneError where that is impossible.
  /// @param has_degree the user has set Mesh/Degree
  template <int dim>
  void
  choose_formulations(Scene<dim> &scene, bool has_degree);
} // namespace Signorini
