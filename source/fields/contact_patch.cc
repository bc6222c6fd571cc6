// SPDX-License-Identifier: Apache-2.0
#include "fields/contact_patch.h"

#include "fields/nodal_fields.h"
#include "fields/surface_parts.h"
#include "linear_algebra/dense.h"
#include <signorini/solid/model.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>


namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Area, first and second moments of a part of a surface, and its extent along some directions.
    /// Sums are those of this rank until sum_up().
    template <int dim>
    struct Moments
    {
      /// The area, dim first moments and dim x dim second moments.
      std::vector<double> sums = std::vector<double>(1 + dim + dim * dim, 0.);
      /// Area of the parts that the edge of contact crosses.
      double edge = 0;
      /// Unit vectors: the coordinate axes, then the directions of the pair.
      std::vector<Tensor<1, dim>> directions;
      /// For each direction minus the lowest and the highest coordinate, so that both are maxima.
      std::vector<double> box;

      /// Moments of the area without an extent.
      Moments() = default;

      /// Moments with an extent along the axes.
      /// @param more directions of any length
      explicit Moments(const std::vector<Point<dim>> &more)
      {
        for (unsigned int d = 0; d < dim; ++d)
          directions.push_back(Point<dim>::unit_vector(d));
        for (const Point<dim> &direction : more)
          directions.push_back(Tensor<1, dim>(direction / direction.norm()));
        box.assign(2 * directions.size(), -std::numeric_limits<double>::max());
      }

      /// Add an area that is concentrated at a point.
      void
      add(const double area, const Point<dim> &x)
      {
        sums[0] += area;
        for (unsigned int d = 0; d < dim; ++d)
          {
            sums[1 + d] += area * x[d];
            for (unsigned int e = 0; e < dim; ++e)
              sums[1 + dim + dim * d + e] += area * x[d] * x[e];
          }
      }

      /// Let the extent contain a point.
      void
      extend(const Point<dim> &x)
      {
        for (unsigned int i = 0; i < directions.size(); ++i)
          {
            const double along = directions[i] * x;
            box[2 * i]         = std::max(box[2 * i], -along);
            box[2 * i + 1]     = std::max(box[2 * i + 1], along);
          }
      }

      /// @return area, extent and semi-axes of the part.
      ContactPatch
      patch(const Model model)
      {
        ContactPatch result;
        // A zone that contains neither nodes nor points has its centre as extent.
        if (sums[0] > 0 && box[0] == -std::numeric_limits<double>::max())
          {
            Point<dim> center;
            for (unsigned int d = 0; d < dim; ++d)
              center[d] = sums[1 + d] / sums[0];
            extend(center);
          }
        result.area = sums[0];
        result.edge = edge;
        for (unsigned int d = 0; d < dim && result.area > 0; ++d)
          {
            result.from.push_back(0. - box[2 * d]);
            result.to.push_back(box[2 * d + 1]);
          }
        for (unsigned int i = dim; i < directions.size() && result.area > 0; ++i)
          result.along.emplace_back(0. - box[2 * i], box[2 * i + 1]);
        // Contact zones of axisymmetric models are rings without principal axes.
        if (result.area <= 0 || model == Model::axisymmetric)
          return result;
        Eigen::Matrix<double, dim, dim> spread;
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
            spread(d, e) =
              sums[1 + dim + dim * d + e] / sums[0] - sums[1 + d] / sums[0] * sums[1 + e] / sums[0];
        const Eigen::VectorXd values = eigenvalues_of_symmetric(spread);
        // The second moment of an interval of half-width a is a^2/3 per length, that of an ellipse
        // a^2/4 per area.
        for (unsigned int d = 0; d < dim - 1; ++d)
          result.semi_axes.push_back(
            std::sqrt((dim == 2 ? 3 : 4) * std::max(0., values[dim - 1 - d])));
        return result;
      }
    };

    /// Determines the contact zone of a pair from nodal pressures, on the parts of slave faces
    /// between neighbouring nodes (2nd degree: halves or quarters of the face). The square of the
    /// pressure is interpolated multilinearly on each part, with negative values at open nodes that
    /// continue the slope of the active side; the zone is where it is positive. See
    /// contact_patch().
    template <int dim>
    class Lattice
    {
    public:
      static constexpr unsigned int n = dim == 2 ? 2 : 4;

      /// @param marks 1 at the rows inside of the zone
      Lattice(const Snapshot<dim> &s,
              const unsigned int   pair,
              const LA::Vector    &pressure,
              const LA::Vector    &marks)
        : s(s)
        , surface(s.surfaces[pair])
        , directions(s.pairs[pair].directions)
        , squares(s.elasticity.with_ghosts(squares_of(pressure)))
        , status(s.elasticity.with_ghosts(nodal_field(s, marks, pair)))
      {}

      /// @return the moments of the contact zone on this rank. Collective.
      Moments<dim>
      moments() const
      {
        // The contact zone is where the level function is positive: the squared pressure at active
        // nodes, its linear continuation at the others.
        const LA::Vector          level  = s.elasticity.with_ghosts(continued(slopes()));
        const std::vector<double> shares = covered_shares();
        Moments<dim>              result(directions);
        for_each_part(surface.slave_faces, [&](const Part<dim> &nodes, const SlaveFace<dim> &face) {
          std::array<double, n> values;
          unsigned int          n_active = 0;
          for (unsigned int c = 0; c < nodes.size(); ++c)
            {
              const auto node = face.nodes[nodes[c]];
              n_active += is_active(node);
              values[c] = is_active(node) ? std::max(squares(node), tiny) : level(node);
            }
          if (n_active == 0)
            return;
          const double share = shares[&face - surface.slave_faces.data()];
          add_part(nodes, face, values, n_active == nodes.size(), share, result);
          // Parts inside of the zone contribute all their nodes to its extent; parts at its edge
          // also count as edge, with their whole area.
          if (n_active == nodes.size() && !is_part(face))
            for (const unsigned int node : nodes)
              result.extend(face.positions[node]);
          if (n_active == nodes.size())
            return;
          Moments<dim>          whole;
          std::array<double, n> ones;
          ones.fill(1.);
          add_part(nodes, face, ones, true, share, whole);
          result.edge += whole.sums[0];
        });
        extend_by_points(result);
        return result;
      }

    private:
      static constexpr double tiny = std::numeric_limits<double>::min();

      /// @return the squares of the entries.
      LA::Vector
      squares_of(const LA::Vector &pressure) const
      {
        LA::Vector result = pressure;
        for (const auto i : result.locally_owned_elements())
          result(i) = pressure(i) * pressure(i);
        result.compress(VectorOperation::insert);
        return result;
      }

      /// @return whether a node is in contact.
      bool
      is_active(const types::global_dof_index node) const
      {
        return status(node) > 0.5;
      }

      /// @return whether the master covers a face only partly. Then the points alone tell where on
      /// the face contact is.
      static bool
      is_part(const SlaveFace<dim> &face)
      {
        constexpr double whole = 0.99;
        return face.covered < whole;
      }

      /// Let the extent contain the active points of faces that are covered partly.
      void
      extend_by_points(Moments<dim> &moments) const
      {
        for (const ContactPoint<dim> &point : surface.points)
          if (is_part(surface.slave_faces[point.face]) && value_at(surface, point, status) > 0.5)
            moments.extend(point.slave_force_point);
      }

      /// @return the sums, at each node, of the gradients of the squared pressure over adjacent
      /// parts whose nodes are all in contact, component by component, and as last vector the
      /// number of these parts; with ghost values. Collective.
      std::vector<LA::Vector>
      slopes() const
      {
        std::vector<LA::Vector> result(dim + 1, s.elasticity.zero_vector());
        for_each_part(surface.slave_faces, [&](const Part<dim> &nodes, const SlaveFace<dim> &face) {
          for (const unsigned int i : nodes)
            if (!is_active(face.nodes[i]))
              return;
          std::array<double, n>         values;
          std::array<Tensor<1, dim>, n> positions;
          for (unsigned int c = 0; c < nodes.size(); ++c)
            {
              values[c]    = squares(face.nodes[nodes[c]]);
              positions[c] = face.positions[nodes[c]];
            }
          const Tensor<1, dim> slope = slope_of_part<dim>(nodes.size(), positions, values);
          for (const unsigned int i : nodes)
            {
              for (unsigned int d = 0; d < dim; ++d)
                result[d](face.nodes[i]) += slope[d];
              result[dim](face.nodes[i]) += 1;
            }
        });
        // Ranks add their contributions at shared nodes.
        for (LA::Vector &v : result)
          v.compress(VectorOperation::add);
        std::vector<LA::Vector> with_ghosts;
        for (const LA::Vector &v : result)
          with_ghosts.push_back(s.elasticity.with_ghosts(v));
        return with_ghosts;
      }

      /// @return the squared pressure at open nodes beside nodes in contact, continued linearly
      /// from these, and never positive. Collective.
      LA::Vector
      continued(const std::vector<LA::Vector> &slopes) const
      {
        LA::Vector sum = s.elasticity.zero_vector(), count = sum;
        for_each_part(surface.slave_faces, [&](const Part<dim> &nodes, const SlaveFace<dim> &face) {
          for (const unsigned int open : nodes)
            if (!is_active(face.nodes[open]))
              for (const unsigned int i : nodes)
                if (const auto node = face.nodes[i]; is_active(node))
                  {
                    // Without a gradient (a zone of one node), or where the pressure grows towards
                    // the edge, as at corners, the edge is assumed half-way to the open node.
                    double change = 0;
                    for (unsigned int d = 0; d < dim; ++d)
                      if (slopes[dim](node) > 0)
                        change += slopes[d](node) / slopes[dim](node) *
                                  (face.positions[open] - face.positions[i])[d];
                    const double value = change < 0 ? squares(node) + change : -squares(node);
                    sum(face.nodes[open]) += value;
                    count(face.nodes[open]) += 1;
                  }
        });
        for (LA::Vector *v : {&sum, &count})
          v->compress(VectorOperation::add);
        for (const auto i : sum.locally_owned_elements())
          sum(i) = count(i) > 0 ? std::min(sum(i) / count(i), -tiny) : -1.;
        sum.compress(VectorOperation::insert);
        return sum;
      }

      /// @return the share of each face that has a projection on the master, relative to the area
      /// of its parts: above one where these are chords of a curved face.
      std::vector<double>
      covered_shares() const
      {
        std::vector<Moments<dim>> whole(surface.slave_faces.size());
        std::vector<double>       shares(whole.size(), 0.);
        std::array<double, n>     ones;
        ones.fill(1.);
        for_each_part(surface.slave_faces, [&](const Part<dim> &nodes, const SlaveFace<dim> &face) {
          add_part(nodes, face, ones, true, 1., whole[&face - surface.slave_faces.data()]);
        });
        for (const ContactPoint<dim> &point : surface.points)
          shares[point.face] += point.weight * point.stretch / whole[point.face].sums[0];
        return shares;
      }

      /// Add the area of a part where the interpolated values are positive, by sampling.
      void
      add_part(const Part<dim>             &nodes,
               const SlaveFace<dim>        &face,
               const std::array<double, n> &values,
               const bool                   is_whole,
               const double                 covered,
               Moments<dim>                &moments) const
      {
        // Whole parts have 2 Gauss points in each direction; parts at the edge are sampled at as
        // many midpoints as the resolution of the edge needs.
        const unsigned int m     = is_whole ? 2 : dim == 2 ? 200 : 16;
        const auto         place = [&](const unsigned int a) {
          return is_whole ? 0.5 + (a == 0 ? -1 : 1) * std::sqrt(1. / 12) : (a + 0.5) / m;
        };
        for (unsigned int b = 0; b < (dim == 3 ? m : 1); ++b)
          for (unsigned int a = 0; a < m; ++a)
            {
              const PartFunctions           at(nodes.size(), place(a), place(b));
              double                        value = 0;
              Point<dim>                    x;
              std::array<Tensor<1, dim>, 2> tangents;
              for (unsigned int c = 0; c < nodes.size(); ++c)
                {
                  const Tensor<1, dim> position(face.positions[nodes[c]]);
                  value += at.value[c] * values[c];
                  x += at.value[c] * position;
                  for (unsigned int d = 0; d < 2; ++d)
                    tangents[d] += at.slope[d][c] * position;
                }
              if (value <= 0)
                continue;
              double area = 0;
              if constexpr (dim == 2)
                area = tangents[0].norm() / m;
              else
                area = cross_product_3d(tangents[0], tangents[1]).norm() / (m * m);
              moments.add(covered * area * measure(s.elasticity.model(), x), x);
              if (!is_part(face))
                moments.extend(x);
            }
      }

      const Snapshot<dim>           &s;
      const ContactSurface<dim>     &surface;
      const std::vector<Point<dim>> &directions;
      /// Squared pressure and status at nodes, with ghost values.
      const LA::Vector squares, status;
    };
  } // namespace



  namespace
  {
    /// Sum the moments over all ranks. Collective.
    template <int dim>
    void
    sum_up(Moments<dim> &moments, const MPI_Comm comm)
    {
      Utilities::MPI::sum(moments.sums, comm, moments.sums);
      moments.edge = Utilities::MPI::sum(moments.edge, comm);
      Utilities::MPI::max(moments.box, comm, moments.box);
    }

    /// @return the moments of the active points, for methods that sample at points. Collective.
    template <int dim>
    Moments<dim>
    moments_of_points(const Snapshot<dim> &s, const unsigned int pair, const LA::Vector &marks)
    {
      Moments<dim> result(s.pairs[pair].directions);
      auto         row = first_row(s, pair);
      for (const ContactPoint<dim> &point : s.surfaces[pair].points)
        if (marks(row++) > 0)
          {
            const double area = point.weight * point.stretch;
            result.add(area, point.slave_force_point);
            result.extend(point.slave_force_point);
            result.edge += area;
          }
      sum_up(result, s.elasticity.mesh().communicator());
      return result;
    }
  } // namespace



  // If no node is in contact, the active points are the zone.
  template <int dim>
  ContactPatch
  contact_patch(const Snapshot<dim> &s,
                const unsigned int   pair,
                const LA::Vector    &density,
                const LA::Vector    &marks)
  {
    Moments<dim> moments = Lattice<dim>(s, pair, density, marks).moments();
    sum_up(moments, s.elasticity.mesh().communicator());
    if (moments.sums[0] <= 0 && !samples_nodes(s.contact))
      moments = moments_of_points(s, pair, marks);
    return moments.patch(s.elasticity.model());
  }



  template <int dim>
  double
  largest_pressure(const Snapshot<dim> &s,
                   const unsigned int   pair,
                   const LA::Vector    &pressure,
                   const ContactPatch  &patch)
  {
    double largest = 0, force = 0;
    for (const auto i : pressure.locally_owned_elements())
      largest = std::max(largest, pressure(i));
    auto which = s.contact.origin.pair.begin();
    for (const auto i : s.pressure.locally_owned_elements())
      if (*which++ == pair)
        force += s.pressure(i) * s.contact.weight(i);
    const MPI_Comm comm = s.elasticity.mesh().communicator();
    largest             = Utilities::MPI::max(largest, comm);
    force               = Utilities::MPI::sum(force, comm);
    return patch.area > 0 ? std::max(largest, force / patch.area) : largest;
  }



#define INSTANTIATE(dim)                                                                           \
  template ContactPatch contact_patch(const Snapshot<dim> &,                                       \
                                      unsigned int,                                                \
                                      const LA::Vector &,                                          \
                                      const LA::Vector &);                                         \
  template double       largest_pressure(const Snapshot<dim> &,                                    \
                                         unsigned int,                                             \
                                         const LA::Vector &,                                       \
                                         const ContactPatch &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
