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
  /// Make a scene from assignments "Section/Key=value", as they follow --set on the command line,
  /// and read the files that they name. Its members may be changed before it is solved: obstacles,
  /// meshes and materials of other classes may replace those that were read. Throws SceneError for
  /// invalid assignments.
  /// @param assignments "Section/Key=value" each
  /// @param name of the scene: results go to output/NAME if Output/Directory is not set
  /// @param folder in which files are looked for after the present one
  template <int dim>
  Scene<dim>
  scene_of(const std::vector<std::string> &assignments,
           const std::string              &name,
           const std::string              &folder = "");

  /// A contact point of a solution: a node of the slave surface, or an integration point, depending
  /// on the method.
  template <int dim>
  struct ContactValue
  {
    /// Name of the contact pair.
    std::string pair;
    /// Position on the slave in the reference configuration [length].
    dealii::Point<dim>     position;
    dealii::Tensor<1, dim> normal; ///< unit, out of the master
    /// Share of the slave's area in the reference configuration [length^(dim-1)].
    double area;
    double gap;      ///< positive where open [length]
    double pressure; ///< positive in compression [stress]
    bool   is_active;
  };

  /// The result of a load step on the last mesh.
  template <int dim>
  struct LoadStepResult
  {
    /// Number of the load step, from 1 on.
    unsigned int step;
    double       time;
    /// The contact points of this rank; each point is on one rank.
    std::vector<ContactValue<dim>> contact;
  };

  /// Solve a scene with meshes, load steps and results in files, as the program does. Throws
  /// SceneError on all ranks alike. Collective.
  /// @param out stream for messages of the first rank
  /// @param after_step called on all ranks after each load step on the last mesh, if it is not
  /// empty
  /// @return the exit code
  template <int dim>
  ExitCode
  solve(const Scene<dim>                                       &scene,
        MPI_Comm                                                comm,
        std::ostream                                           &out,
        const std::function<void(const LoadStepResult<dim> &)> &after_step = {});
} // namespace Signorini
