// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include <signorini/fields/probe.h>

#include <deal.II/fe/mapping.h>

#include <limits>
#include <vector>

namespace Signorini
{
  /// The properties of a cell by which one of several candidates for a probe is chosen. They do
  /// not depend on the partition, so that the choice is the same for any number of ranks.
  template <int dim>
  struct Claim
  {
    /// Distance from the reference cell, 0 inside.
    double             distance = std::numeric_limits<double>::infinity();
    unsigned int       body     = dealii::numbers::invalid_unsigned_int;
    dealii::Point<dim> center;
    double             size = 0;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &distance &body &center &size;
    }
  };

  /// A candidate cell of this rank.
  template <int dim>
  struct CellLocation
  {
    Claim<dim>                                             claim;
    typename dealii::DoFHandler<dim>::active_cell_iterator cell;
    /// The point in reference coordinates of the cell, moved into the cell if it is outside.
    dealii::Point<dim> unit;
  };

  /// @return the preferred cell of this rank for each probe. Cost: number of cells times number
  /// of probes, by boxes.
  /// @param elasticity the model
  /// @param probes points in bodies
  /// @param farthest allowed distance from the reference cell
  template <int dim>
  std::vector<CellLocation<dim>>
  own_locations(const Elasticity<dim>         &elasticity,
                const std::vector<Probe<dim>> &probes,
                double                         farthest);

  /// @return the rank with the preferred cell of probe i.
  /// @param claims of all ranks, see all_claims()
  /// @param i index of the probe
  template <int dim>
  unsigned int
  rank_of_best_claim(const std::vector<std::vector<Claim<dim>>> &claims, unsigned int i);

  /// @return the candidates of all ranks, [rank][probe]. Collective.
  /// @param locations result of own_locations()
  /// @param comm the ranks
  template <int dim>
  std::vector<std::vector<Claim<dim>>>
  all_claims(const std::vector<CellLocation<dim>> &locations, MPI_Comm comm);

  /// @return the cells that contain the point x, with its reference coordinates in each of them.
  /// They are found from face to face, so that the other side of a slit is not among them. All
  /// are locally owned or ghost cells.
  /// @param mapping of the mesh
  /// @param first a locally owned cell that contains the point
  /// @param x the point
  template <int dim>
  std::vector<CellLocation<dim>>
  cells_about(const dealii::Mapping<dim> &mapping,
              const CellLocation<dim>    &first,
              const dealii::Point<dim>   &x);

  /// Throw SceneError: the point is outside of all bodies, or of its body, which does perhaps not
  /// exist.
  /// @param probe the point
  /// @param mesh with the bodies, whose extents are listed
  template <int dim>
  [[noreturn]] void
  throw_outside_of_bodies(const Probe<dim> &probe, const Mesh<dim> &mesh);
} // namespace Signorini
