// SPDX-License-Identifier: Apache-2.0
#include "fields/nodal_fields.h"
#include "fields/recovery_steps.h"
#include "fields/surface_parts.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Extrapolates the pressure to nodes without multiplier. The pressure of a node near them is a
    /// mean over its own and the adopted functions; it belongs to the centre of gravity of its
    /// multiplier function, not to the node. From there the mean gradient of the adjacent parts in
    /// contact continues it.
    template <int dim>
    class Extrapolation
    {
    public:
      /// @param raw the nodal pressures, see nodal_field()
      /// @param is_positive whether results are not to be negative
      Extrapolation(const Snapshot<dim> &s,
                    const unsigned int   pair,
                    const LA::Vector    &raw,
                    const bool           is_positive)
        : s(s)
        , number_of_pair(pair)
        , surface(s.surfaces[pair])
        , raw(s.elasticity.with_ghosts(raw))
        , is_positive(is_positive)
        , centers(centers_of_functions())
        , slopes(mean_slopes())
      {}

      /// Set the pressures of nodes without multiplier and of the nodes that have adopted their
      /// functions. Collective.
      void
      apply(LA::Vector &pressure) const
      {
        const LA::Vector now = s.elasticity.with_ghosts(pressure);
        fill_dirichlet_nodes<dim>(
          s,
          number_of_pair,
          [&](const SlaveFace<dim> &face,
              const unsigned int    dirichlet_node,
              const unsigned int    near) {
            if (face.under_covered[dirichlet_node])
              return now(face.nodes[near]); // no extrapolation beyond the master
            return is_on_axis(face.positions[dirichlet_node]) ?
                     now(face.nodes[dirichlet_node]) :
                     extrapolated(face.nodes[near], face.positions[dirichlet_node]);
          },
          pressure);
        set_neighbours(pressure);
      }

    private:
      static constexpr unsigned int n = Part<dim>::static_capacity;

      /// @return some zero vectors.
      std::vector<LA::Vector>
      zeros(const unsigned int number) const
      {
        return std::vector<LA::Vector>(number, s.elasticity.zero_vector());
      }

      /// @return vectors of sums of all ranks, with ghost values. Collective.
      std::vector<LA::Vector>
      summed(std::vector<LA::Vector> sums) const
      {
        std::vector<LA::Vector> result;
        for (LA::Vector &v : sums)
          {
            v.compress(VectorOperation::add);
            result.push_back(s.elasticity.with_ghosts(v));
          }
        return result;
      }

      /// @return for each node int psi x dA, component by component, and as last vector int psi dA.
      std::vector<LA::Vector>
      centers_of_functions() const
      {
        std::vector<LA::Vector> sums = zeros(dim + 1);
        for (const ContactPoint<dim> &point : surface.points)
          for (const auto &[node, psi] : point.multiplier_shape)
            {
              for (unsigned int d = 0; d < dim; ++d)
                sums[d](node) += psi * point.weight * point.slave_force_point[d];
              sums[dim](node) += psi * point.weight;
            }
        return summed(std::move(sums));
      }

      /// @return the centre of gravity of the multiplier function of a node.
      Tensor<1, dim>
      center(const types::global_dof_index node) const
      {
        Tensor<1, dim> result;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = centers[d](node) / centers[dim](node);
        return result;
      }

      /// @return for each node the sums of the pressure gradients of adjacent parts whose nodes are
      /// all in compression, and as last vector the number of these parts.
      std::vector<LA::Vector>
      mean_slopes() const
      {
        std::vector<LA::Vector> sums = zeros(dim + 1);
        for_each_part(surface.slave_faces, [&](const Part<dim> &part, const SlaveFace<dim> &face) {
          std::array<double, n>         values;
          std::array<Tensor<1, dim>, n> positions;
          for (unsigned int c = 0; c < part.size(); ++c)
            {
              const auto node = face.nodes[part[c]];
              if (face.without_pressure[part[c]] || (is_positive && raw(node) <= 0) ||
                  centers[dim](node) <= 0)
                return;
              values[c]    = raw(node);
              positions[c] = center(node);
            }
          const Tensor<1, dim> slope = slope_of_part<dim>(part.size(), positions, values);
          for (const unsigned int i : part)
            {
              for (unsigned int d = 0; d < dim; ++d)
                sums[d](face.nodes[i]) += slope[d];
              sums[dim](face.nodes[i]) += 1;
            }
        });
        return summed(std::move(sums));
      }

      /// @return the pressure at x, continued from a node.
      double
      extrapolated(const types::global_dof_index node, const Point<dim> &x) const
      {
        double value = raw(node);
        if (slopes[dim](node) > 0)
          for (unsigned int d = 0; d < dim; ++d)
            value += slopes[d](node) / slopes[dim](node) * (x[d] - center(node)[d]);
        return is_positive ? std::max(0., value) : value;
      }

      /// @return whether a point is on the axis of an axisymmetric model, where the node has no
      /// function for another reason.
      bool
      is_on_axis(const Point<dim> &x) const
      {
        return s.elasticity.model() == Model::axisymmetric &&
               x[0] < 1e-10 * s.elasticity.rotation_length_scale();
      }

      /// Set the nodes that have adopted functions to the extrapolated values at their own
      /// positions.
      void
      set_neighbours(LA::Vector &pressure) const
      {
        std::vector<LA::Vector> sums = zeros(2);
        for (const SlaveFace<dim> &face : surface.slave_faces)
          for (unsigned int i = 0; i < face.nodes.size(); ++i)
            if (face.without_pressure[i] && !face.under_covered[i] &&
                !is_on_axis(face.positions[i]))
              for (const unsigned int near : nearest_free(face, i))
                {
                  sums[0](face.nodes[near]) += extrapolated(face.nodes[near], face.positions[near]);
                  sums[1](face.nodes[near]) += 1;
                }
        for (LA::Vector &v : sums)
          v.compress(VectorOperation::add);
        for (const auto i : s.elasticity.owned())
          if (sums[1](i) > 0)
            pressure(i) = sums[0](i) / sums[1](i);
        pressure.compress(VectorOperation::insert);
      }

      const Snapshot<dim>       &s;
      const unsigned int         number_of_pair;
      const ContactSurface<dim> &surface;
      /// Nodal pressures before the extrapolation, with ghost values.
      const LA::Vector raw;
      const bool       is_positive;
      /// Results of centers_of_functions() and mean_slopes().
      const std::vector<LA::Vector> centers, slopes;
    };
  } // namespace



  template <int dim>
  void
  extrapolate_to_dirichlet_nodes(const Snapshot<dim> &s,
                                 const unsigned int   pair,
                                 const LA::Vector    &raw,
                                 const bool           is_positive,
                                 LA::Vector          &pressure)
  {
    if (s.surfaces[pair].has_dirichlet_nodes)
      Extrapolation<dim>(s, pair, raw, is_positive).apply(pressure);
  }



  template void
  extrapolate_to_dirichlet_nodes(
    const Snapshot<2> &, unsigned int, const LA::Vector &, bool, LA::Vector &);
  template void
  extrapolate_to_dirichlet_nodes(
    const Snapshot<3> &, unsigned int, const LA::Vector &, bool, LA::Vector &);
} // namespace Signorini
