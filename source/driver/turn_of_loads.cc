// SPDX-License-Identifier: Apache-2.0
#include "contact/search/configuration.h"
#include "driver/equilibrium.h"
#include <signorini/solid/rigid_pose.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/LU>
#include <Eigen/SVD>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The rotation of the material of a surface between two displacements, by least squares over
    /// the vertices of its faces (Kabsch, Acta Cryst. A 34 (1978) 827). Collective.
    /// @param boundaries ids of the surface; @param from, to displacements with ghosts
    template <int dim>
    Tensor<2, dim>
    rotation_of_surface(const Elasticity<dim>              &elasticity,
                        const std::set<types::boundary_id> &boundaries,
                        const LA::Vector                   &from,
                        const LA::Vector                   &to)
    {
      // The number of points, the sums of their positions at both displacements, and of the
      // products of these, relative to the center of the model, which keeps digits.
      constexpr unsigned int n_sums = 1 + 2 * dim + dim * dim;
      std::vector<double>    sums(n_sums, 0.);
      const Point<dim>       origin = elasticity.mesh().extent().center();
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() && boundaries.count(cell->face(f)->boundary_id()) == 1)
              for (const unsigned int k : cell->face(f)->vertex_indices())
                {
                  const unsigned int v = cell->reference_cell().face_to_cell_vertices(f, k, 1);
                  Tensor<1, dim>     a = cell->vertex(v) - origin, b = a;
                  for (unsigned int d = 0; d < dim; ++d)
                    {
                      const auto dof = cell->vertex_dof_index(v, d, cell->active_fe_index());
                      a[d] += from(dof);
                      b[d] += to(dof);
                    }
                  ++sums[0];
                  for (unsigned int d = 0; d < dim; ++d)
                    {
                      sums[1 + d] += a[d];
                      sums[1 + dim + d] += b[d];
                      for (unsigned int e = 0; e < dim; ++e)
                        sums[1 + 2 * dim + d * dim + e] += b[d] * a[e];
                    }
                }
      Utilities::MPI::sum(sums, elasticity.mesh().communicator(), sums);
      Tensor<2, dim> result = unit_symmetric_tensor<dim>();
      if (sums[0] == 0)
        return result;
      Eigen::Matrix<double, dim, dim> covariance;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          covariance(d, e) =
            sums[1 + 2 * dim + d * dim + e] - sums[1 + dim + d] * sums[1 + e] / sums[0];
      // A plane surface leaves the sign of one direction open: that of a rotation.
      const Eigen::JacobiSVD<Eigen::Matrix<double, dim, dim>> svd(covariance,
                                                                  Eigen::ComputeFullU |
                                                                    Eigen::ComputeFullV);
      Eigen::Matrix<double, dim, 1> signs = Eigen::Matrix<double, dim, 1>::Ones();
      signs[dim - 1] = (svd.matrixU() * svd.matrixV().transpose()).determinant();
      const Eigen::Matrix<double, dim, dim> rotation =
        svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          result[d][e] = rotation(d, e);
      return result;
    }

    /// The rotation of an obstacle from one configuration to another.
    template <int dim>
    Tensor<2, dim>
    rotation_of_obstacle(const Obstacle<dim>      &obstacle,
                         const Configuration<dim> &from,
                         const Configuration<dim> &to)
    {
      const RigidPose<dim> before = from.pose(obstacle), after = to.pose(obstacle);
      Tensor<2, dim>       result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          Tensor<1, dim> axis;
          axis[d] = 1;
          result += outer_product(after.to_space(axis), before.to_space(axis));
        }
      return result;
    }

    /// The angle of a rotation, from 0 to pi [radian].
    template <int dim>
    double
    angle_of(const Tensor<2, dim> &rotation)
    {
      // cos from the trace, sin from the skew part: small angles keep their digits.
      const double skew = (rotation - transpose(rotation)).norm() / std::sqrt(8.);
      return std::atan2(skew, dim == 2 ? trace(rotation) / 2 : (trace(rotation) - 1) / 2);
    }
  } // namespace



  // The largest values of the history are those at 16 times of it.
  template <int dim>
  typename Equilibrium<dim>::Loading
  Equilibrium<dim>::loading_at(const double t)
  {
    const auto evaluate = [this](const double time) {
      elasticity.set_time(time);
      LA::Vector prescribed = elasticity.zero_vector();
      elasticity.distribute(prescribed);
      return Loading{{prescribed, elasticity.load()}};
    };
    if (largest_loads[0] == 0 && largest_loads[1] == 0)
      {
        constexpr unsigned int n = 16;
        for (unsigned int i = 0; i <= n; ++i)
          {
            const Loading now = evaluate(scene.load_steps.end_time * i / n);
            for (unsigned int k = 0; k < 2; ++k)
              largest_loads[k] = std::max(largest_loads[k], now[k].linfty_norm());
          }
      }
    return evaluate(t);
  }



  template <int dim>
  double
  Equilibrium<dim>::relative_size(const Loading &loading) const
  {
    double result = 0;
    for (unsigned int k = 0; k < 2; ++k)
      if (largest_loads[k] > 0)
        result = std::max(result, loading[k].linfty_norm() / largest_loads[k]);
    return result;
  }



  // Moving obstacles are prescribed displacements as well. Where gaps are formulas in time, it is
  // not known.
  template <int dim>
  bool
  Equilibrium<dim>::starts_unloaded()
  {
    const double   now     = elasticity.time();
    const bool     is_free = relative_size(loading_at(state.time)) == 0;
    const MPI_Comm comm    = elasticity.mesh().communicator();
    elasticity.set_time(now);
    double least = 0;
    for (const double one : contact.gap_operator().gap(state.displacement))
      least = std::min(least, one);
    constexpr double rounding = 1e-12;
    return is_free && Utilities::MPI::min(least, comm) >= -rounding * elasticity.mesh().size() &&
           std::none_of(decisions.pairs.begin(), decisions.pairs.end(), [&](const auto &pair) {
             return contact.has_time_dependent_gap(pair);
           });
  }



  // Sampled at quarters of the step.
  template <int dim>
  double
  Equilibrium<dim>::turn_of_loads(const double from, const double to)
  {
    const Loading first = loading_at(from), last = loading_at(to);
    double        result = 0;
    for (const double share : {0.25, 0.5, 0.75})
      {
        Loading between = loading_at(from + share * (to - from));
        for (unsigned int k = 0; k < 2; ++k)
          between[k].add(share - 1, first[k], -share, last[k]);
        result = std::max(result, relative_size(between));
      }
    return result;
  }



  // With c from the start to the end of the step and d from the start to a sample, the deviation
  // is d - s c with the s in [s of the sample before, 1] that makes it smallest. The samples are at
  // irregular places, so that loads with a period within the step are seen.
  template <int dim>
  double
  Equilibrium<dim>::deviation_of_loads(const double from, const double to)
  {
    const Loading first = loading_at(from);
    Loading       way   = loading_at(to);
    for (unsigned int k = 0; k < 2; ++k)
      way[k] -= first[k];
    const auto product = [&](const Loading &a, const Loading &b) {
      double sum = 0;
      for (unsigned int k = 0; k < 2; ++k)
        if (largest_loads[k] > 0)
          sum += a[k] * b[k] / (largest_loads[k] * largest_loads[k]);
      return sum;
    };
    const double square = product(way, way);
    double       result = 0, share = 0;
    for (const double place : {0.07, 0.19, 0.31, 0.46, 0.54, 0.69, 0.81, 0.93})
      {
        Loading there = loading_at(from + place * (to - from));
        for (unsigned int k = 0; k < 2; ++k)
          there[k] -= first[k];
        if (square > 0)
          share = std::clamp(product(there, way) / square, share, 1.);
        for (unsigned int k = 0; k < 2; ++k)
          there[k].add(-share, way[k]);
        result = std::max(result, relative_size(there));
      }
    return result;
  }



  // With the reference geometry, slip is that of the points in contact, whatever the turn.
  template <int dim>
  bool
  Equilibrium<dim>::may_follow_turns() const
  {
    return my_uses_current_geometry || scene.contact.geometry == ContactGeometry::updated ||
           elasticity.is_finite_strain();
  }



  template <int dim>
  double
  Equilibrium<dim>::relative_turn_since(const LA::Vector &before)
  {
    if (!may_follow_turns())
      return 0;
    const Mesh<dim> &mesh = elasticity.mesh();
    const LA::Vector from = elasticity.with_ghosts(before),
                     to   = elasticity.with_ghosts(state.displacement);
    const Configuration<dim> start(elasticity, before), now(elasticity, state.displacement);
    const auto               of_surface = [&](const std::string &name) {
      return rotation_of_surface(elasticity, mesh.boundary_ids(name), from, to);
    };
    double result = 0;
    for (const ContactPair<dim> &pair : decisions.pairs)
      if (!pair.friction.is_zero() && pair.slave != pair.master)
        {
          const Obstacle<dim> *obstacle  = scene.obstacle_of(pair);
          const Tensor<2, dim> of_slave  = of_surface(pair.slave),
                               of_master = obstacle ? rotation_of_obstacle(*obstacle, start, now) :
                                                      of_surface(pair.master);
          result = std::max(result, angle_of(transpose(of_master) * of_slave));
        }
    return result;
  }



  // Free rotations are not known before the load step is solved.
  template <int dim>
  double
  Equilibrium<dim>::turn_of_obstacles(const double t)
  {
    if (!may_follow_turns())
      return 0;
    const std::vector<double> before = elasticity.rigid_motion(state.displacement);
    const double              now    = elasticity.time();
    LA::Vector                u      = state.displacement;
    elasticity.set_time(t);
    elasticity.distribute(u);
    const std::vector<double> after = elasticity.rigid_motion(u);
    elasticity.set_time(now);
    constexpr unsigned int n      = RigidPose<dim>::n_dofs;
    double                 result = 0;
    for (unsigned int first = 0; first < after.size(); first += n)
      {
        double square = 0;
        for (unsigned int i = first + dim; i < first + n; ++i)
          square += (after[i] - before[i]) * (after[i] - before[i]);
        result = std::max(result, std::sqrt(square) / elasticity.rotation_length_scale());
      }
    return result;
  }



#define INSTANTIATE(dim)                                                                           \
  template double Equilibrium<dim>::turn_of_loads(double, double);                                 \
  template double Equilibrium<dim>::deviation_of_loads(double, double);                            \
  template bool   Equilibrium<dim>::starts_unloaded();                                             \
  template bool   Equilibrium<dim>::may_follow_turns() const;                                      \
  template double Equilibrium<dim>::relative_turn_since(const LA::Vector &);                       \
  template double Equilibrium<dim>::turn_of_obstacles(double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
