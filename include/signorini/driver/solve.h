// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/base/exit_code.h>
#include <signorini/scene/scene.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace Signorini
{
  /// A scene from assignments "Section/Key=value", as they follow --set on the command line, which
  /// includes reading the files that they name. Its members may be changed before it is solved:
  /// obstacles, meshes and materials of other classes take the places of those that were read.
  /// Throws SceneError for what cannot be.
  /// @param name of the scene: results go to output/NAME if Output/Directory is not set
  /// @param folder in which files are looked for after the present one
  template <int dim>
  Scene<dim>
  scene_of(const std::vector<std::string> &assignments,
           const std::string              &name,
           const std::string              &folder = "");

  /// A contact point of a solution: a node of the slave surface, or a point of integration, as the
  /// method has them.
  template <int dim>
  struct ContactValue
  {
    std::string            pair;
    dealii::Point<dim>     position; ///< on the slave, where contact was looked for [length]
    dealii::Tensor<1, dim> normal;   ///< unit, out of the master
    double                 area;     ///< that the point stands for [length^(dim-1)]
    double                 gap;      ///< positive where open [length]
    double                 pressure; ///< positive in compression [stress]
    bool                   is_active;
  };

  /// What is known after each load step of the last mesh.
  template <int dim>
  struct LoadStepResult
  {
    unsigned int                   step; ///< from 1 on
    double                         time;
    std::vector<ContactValue<dim>> contact; ///< points of this rank; each is on one rank
  };

  /// Solve a scene: meshes, load steps, results in files, as the program does. Collective. Throws
  /// SceneError on all ranks alike.
  /// @param out where the first rank reports
  /// @param after_step called on all ranks after each load step, if it is not empty
  template <int dim>
  ExitCode
  solve(const Scene<dim>                                       &scene,
        MPI_Comm                                                comm,
        std::ostream                                           &out,
        const std::function<void(const LoadStepResult<dim> &)> &after_step = {});
} // namespace Signorini
