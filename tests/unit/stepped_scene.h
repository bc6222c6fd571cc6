// SPDX-License-Identifier: Apache-2.0
// A scene that is led through load steps as the program does it.
#pragma once

#include "accuracy/refinement.h"
#include "driver/equilibrium.h"

#include <doctest/doctest.h>

#include <memory>
#include <sstream>

#include "small_scene.h"

namespace TestScene
{
  template <int dim>
  struct SteppedScene
  {
    explicit SteppedScene(const Lines &lines)
      : scene(lines)
      , out(log, true)
    {}

    /// From nothing; the scene has its contact.
    void
    start()
    {
      state.displacement = scene.elasticity->zero_vector();
      state.contact      = SurfaceField(dim);
      equilibrium        = std::make_unique<Equilibrium<dim>>(
        scene.decisions, *scene.elasticity, *scene.contact, state, scene.timer, out, [this] {
          return print_steps(out);
        });
      equilibrium->find_contact();
    }

    bool
    solve(const double t)
    {
      const bool is_solved = equilibrium->solve(t, scene.scene.newton.tolerance);
      if (!is_solved)
        log << equilibrium->report().reason << "\n";
      return is_solved;
    }

    /// Cells on one side, so that nodes hang at the contact surface.
    void
    refine_some()
    {
      auto &mesh = *scene.mesh;
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned() && cell->center()[0] < 0.5)
          cell->set_refine_flag();
      const auto n = mesh.triangulation().n_global_active_cells();
      refine(mesh, *scene.elasticity, {&state.displacement, &state.start.displacement});
      CHECK(mesh.triangulation().n_global_active_cells() > n);
      equilibrium->invalidate();
      equilibrium->find_contact();
    }

    SmallScene<dim>                   scene;
    State                             state;
    std::ostringstream                log;
    ConditionalOStream                out;
    std::unique_ptr<Equilibrium<dim>> equilibrium;
  };
} // namespace TestScene
