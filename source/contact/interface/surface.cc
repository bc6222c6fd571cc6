// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/surface.h"

#include "contact/interface/surface_steps.h"
#include <signorini/contact/methods/method.h>

#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Append the points that the unbiased form of Nitsche's method has on the master
    /// (doc/theory, 2.7): each surface is the slave of the other with half of the area weights.
    /// Normals are reversed so that all of them point out of the pair's master; faces of the other
    /// side are numbered after those of the slave.
    template <int dim>
    void
    add_other_side(ContactSurface<dim> &surface, const ContactSurface<dim> &other)
    {
      for (const ContactPoint<dim> &point : other.points)
        {
          surface.points.push_back(point);
          surface.points.back().face += surface.faces;
          surface.points.back().normal *= -1;
        }
      surface.frames.insert(surface.frames.end(), other.frames.begin(), other.frames.end());
      surface.edge_point_frames.insert(surface.edge_point_frames.end(),
                                       other.edge_point_frames.begin(),
                                       other.edge_point_frames.end());
      for (const EdgeContactPoint<dim> &edge_point : other.edge_points)
        {
          surface.edge_points.push_back(edge_point);
          surface.edge_points.back().face += surface.faces;
        }
      for (EdgeContactPoint<dim> &edge_point : surface.edge_points)
        edge_point.weight /= 2;
      surface.full_face_shapes.insert(surface.full_face_shapes.end(),
                                      other.full_face_shapes.begin(),
                                      other.full_face_shapes.end());
      for (ContactPoint<dim> &point : surface.points)
        point.weight /= 2;
      for (auto &entry : surface.full_face_shapes)
        entry.second /= 2;
      // The list gets an entry for each face of this side, so that the numbers of the other side
      // begin after them.
      surface.slave_faces.resize(surface.faces);
      surface.slave_faces.insert(surface.slave_faces.end(),
                                 other.slave_faces.begin(),
                                 other.slave_faces.end());
      surface.has_dirichlet_nodes = surface.has_dirichlet_nodes || other.has_dirichlet_nodes;
      surface.faces += other.faces;
      surface.is_apart = surface.is_apart && other.is_apart;
    }
  } // namespace



  // All entries of the row of the gap, slave and master, unsorted and with repeated columns.
  template <int dim>
  SparseRow
  ContactPoint<dim>::row() const
  {
    SparseRow  result;
    Components all;
    all.fill(true);
    for_each_entry(*this, all, [&](const auto column, const double value) {
      result.emplace_back(column, value);
    });
    return result;
  }



  // Sums of the weights of contact points over the area of all slave faces, over all ranks.
  template <int dim>
  double
  covered_share(const ContactSurface<dim> &surface, const MPI_Comm comm)
  {
    double covered = 0, full_face_shapes = 0;
    for (const auto &point : surface.points)
      covered += point.weight;
    for (const auto &[multiplier_shape, weight] : surface.full_face_shapes)
      full_face_shapes += weight;
    full_face_shapes = Utilities::MPI::sum(full_face_shapes, comm);
    return full_face_shapes > 0 ? Utilities::MPI::sum(covered, comm) / full_face_shapes : 0.;
  }



  // Search and pair the slave side; with the unbiased method the master side as well, whose points
  // are appended. The two searches are independent of each other. Collective.
  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Configuration<dim>  &configuration,
                       const ContactPair<dim>    &pair,
                       const Obstacle<dim>       *obstacle,
                       const ContactMethod       &method,
                       const Integration         &integration,
                       const SearchTolerance     &range,
                       const ContactSurface<dim> *former)
  {
    const std::vector<FixedIntegrationPoint<dim>>  none;
    const std::vector<FixedIntegrationPoint<dim>> &fixed_points =
      former ? former->fixed_points : none;
    auto surface =
      single_pass_surface(configuration, pair, obstacle, method, integration, range, fixed_points);
    if (method.unbiased() && !obstacle)
      {
        ContactPair<dim> other = pair;
        std::swap(other.slave, other.master);
        other.self_side = -pair.self_side;
        const std::vector<FixedIntegrationPoint<dim>> &fixed_points_on_master =
          former ? former->fixed_points_on_master : none;
        const auto of_master = single_pass_surface<dim>(
          configuration, other, nullptr, method, integration, range, fixed_points_on_master);
        surface.fixed_points_on_master = of_master.fixed_points;
        add_other_side(surface, of_master);
      }
    return surface;
  }



  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Elasticity<dim>  &elasticity,
                       const ContactPair<dim> &pair,
                       const Obstacle<dim>    *obstacle,
                       const ContactMethod    &method,
                       const Integration      &integration)
  {
    return make_contact_surface<dim>(
      Configuration<dim>(elasticity), pair, obstacle, method, integration, {}, nullptr);
  }



#define INSTANTIATE(dim)                                                                           \
  template struct ContactPoint<dim>;                                                               \
  template double              covered_share(const ContactSurface<dim> &, MPI_Comm);               \
  template ContactSurface<dim> make_contact_surface(const Configuration<dim> &,                    \
                                                    const ContactPair<dim> &,                      \
                                                    const Obstacle<dim> *,                         \
                                                    const ContactMethod &,                         \
                                                    const Integration &,                           \
                                                    const SearchTolerance &,                       \
                                                    const ContactSurface<dim> *);                  \
  template ContactSurface<dim> make_contact_surface(const Elasticity<dim> &,                       \
                                                    const ContactPair<dim> &,                      \
                                                    const Obstacle<dim> *,                         \
                                                    const ContactMethod &,                         \
                                                    const Integration &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
