// SPDX-License-Identifier: Apache-2.0
#include "contact/search/search_radius.h"

#include "geometry/extent.h"
#include "mesh/face_nodes.h"
#include "solid/cell_nodes.h"

#include <algorithm>
#include <limits>
#include <map>

namespace Signorini
{
  using namespace dealii;

  // The box of faces on all ranks; boxes of faces enclose them also where they are curved.
  template <int dim>
  BoundingBox<dim>
  box_of(const std::vector<FacePatch<dim>> &patches, const MPI_Comm comm)
  {
    Extent<dim> extent;
    for (const FacePatch<dim> &patch : patches)
      {
        const auto &[low, high] = patch.box().get_boundary_points();
        extent.add(low);
        extent.add(high);
      }
    return extent.reduce_over_ranks(comm);
  }



  template <int dim>
  double
  largest_displacement(const Elasticity<dim> &elasticity,
                       const Obstacle<dim>   &obstacle,
                       const LA::Vector      &u)
  {
    // Bound of |tau + omega x r| over the model: translations add up by component, rotations count
    // with the largest arm. Rotational unknowns are lengths (multiplied by the length scale), so
    // that the arm is divided by it.
    const std::vector<double> motion = elasticity.rigid_motion(u);
    const unsigned int        b      = elasticity.rigid_body(obstacle.name);
    if (b == elasticity.rigid_bodies().size())
      return 0;
    const double arm = elasticity.rigid_bodies()[b].arm(elasticity.mesh().extent()) /
                       elasticity.rotation_length_scale();
    double     sum   = 0;
    const auto first = motion.begin() + b * RigidBody<dim>::n_dofs;
    for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
      sum += (i < dim ? 1 : arm) * std::abs(first[i]);
    return sum;
  }



  // The radius of a pair in the reference configuration: the user's, or at least a tenth of the
  // model.
  template <int dim>
  double
  search_radius_of_pair(const Elasticity<dim>  &elasticity,
                        const ContactPair<dim> &pair,
                        const double            candidate_gap)
  {
    // The rotation length scale is half of the size of the model, a fifth of it a tenth of the
    // model.
    const double tenth_of_scene = elasticity.rotation_length_scale() / 5;
    return pair.search_distance > 0 ? pair.search_distance :
                                      std::max(tenth_of_scene, candidate_gap);
  }



  // True if a pair cannot come into contact within the distance, by cheap lower bounds of the gap:
  // the search is then omitted. Collective.
  template <int dim>
  bool
  is_apart(const Elasticity<dim>    &elasticity,
           const ContactPair<dim>   &pair,
           const Obstacle<dim>      *obstacle,
           const BoundaryFaces<dim> &slave,
           const double              distance)
  {
    const MPI_Comm comm = elasticity.mesh().communicator();
    // A gap given by a formula does not depend on the distance of the surfaces.
    if (pair.gap_is_given())
      return false;
    if (obstacle)
      {
        // From obstacles the distance is that of the centers of the faces, less their diameters: a
        // lower bound.
        double closest = std::numeric_limits<double>::max();
        for (const FacePatch<dim> &patch : slave.patches)
          closest =
            std::min(closest,
                     std::abs(obstacle->shape->closest(patch.center()).gap) - patch.diameter());
        return Utilities::MPI::min(closest, comm) > distance;
      }
    BoundingBox<dim> box = box_of(slave.patches, comm);
    box.extend(distance);
    const BoundingBox<dim> master =
      box_of(BoundaryFaces<dim>::of_master(Configuration<dim>(elasticity), pair).patches, comm);
    return box.get_neighbor_type(master) == NeighborType::not_neighbors;
  }



  // By boundary id, so that any boundary of a scene, which is a set of ids, can be looked up.
  template <int dim>
  std::vector<double>
  largest_displacements(const Elasticity<dim> &elasticity, const LA::Vector &u)
  {
    // The largest nodal displacement over the boundary faces of locally owned cells, then over all
    // ranks.
    const LA::Vector                     ghosted = elasticity.with_ghosts(u);
    std::vector<double>                  largest(elasticity.mesh().end_of_boundary_ids(), 0.);
    std::vector<types::global_dof_index> indices;
    // The nodes of each face of the elements, which are those of a few degrees.
    std::map<const FiniteElement<dim> *, std::vector<std::vector<unsigned int>>> nodes_of_elements;
    const auto nodes_of_faces = [&](const FiniteElement<dim> &fe) -> const auto &
    {
      auto &nodes = nodes_of_elements[&fe];
      for (unsigned int f = nodes.size(); f < fe.reference_cell().n_faces(); ++f)
        nodes.push_back(nodes_of_face(fe.base_element(0), f));
      return nodes;
    };
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        {
          const FiniteElement<dim> &fe    = cell->get_fe();
          const auto               &nodes = nodes_of_faces(fe);
          read_indices<dim>(cell, indices);
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
              for (const unsigned int i : nodes[f])
                {
                  Tensor<1, dim> displacement;
                  for (unsigned int d = 0; d < dim; ++d)
                    displacement[d] = ghosted(indices[fe.component_to_system_index(d, i)]);
                  double &of_boundary = largest[cell->face(f)->boundary_id()];
                  of_boundary         = std::max(of_boundary, displacement.norm());
                }
        }
    Utilities::MPI::max(largest, elasticity.mesh().communicator(), largest);
    return largest;
  }



  // An upper bound of the decrease of the gap.
  template <int dim>
  double
  largest_approach(const Elasticity<dim>     &elasticity,
                   const ContactPair<dim>    &pair,
                   const Obstacle<dim>       *obstacle,
                   const LA::Vector          &u,
                   const std::vector<double> &of_boundaries)
  {
    // Displacements of both surfaces are added as if they moved towards each other.
    const auto largest = [&](const std::string &boundary) {
      double result = 0;
      for (const types::boundary_id id : elasticity.mesh().boundary_ids(boundary))
        result = std::max(result, of_boundaries[id]);
      return result;
    };
    return largest(pair.slave) +
           (obstacle ? largest_displacement(elasticity, *obstacle, u) : largest(pair.master));
  }



#define INSTANTIATE(dim)                                                                           \
  template BoundingBox<dim>    box_of(const std::vector<FacePatch<dim>> &, MPI_Comm);              \
  template double              largest_displacement(const Elasticity<dim> &,                       \
                                                    const Obstacle<dim> &,                         \
                                                    const LA::Vector &);                           \
  template double              search_radius_of_pair(const Elasticity<dim> &,                      \
                                                     const ContactPair<dim> &,                     \
                                                     double);                                      \
  template bool                is_apart(const Elasticity<dim> &,                                   \
                                        const ContactPair<dim> &,                                  \
                                        const Obstacle<dim> *,                                     \
                                        const BoundaryFaces<dim> &,                                \
                                        double);                                                   \
  template std::vector<double> largest_displacements(const Elasticity<dim> &, const LA::Vector &); \
  template double              largest_approach(const Elasticity<dim> &,                           \
                                                const ContactPair<dim> &,                          \
                                                const Obstacle<dim> *,                             \
                                                const LA::Vector &,                                \
                                                const std::vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
