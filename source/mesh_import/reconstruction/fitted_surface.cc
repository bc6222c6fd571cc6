// SPDX-License-Identifier: Apache-2.0
#include "geometry/manifolds.h"
#include "linear_algebra/dense.h"
#include "mesh_import/cells.h"
#include "mesh_import/reconstruction/curved_faces.h"
#include <signorini/base/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <Eigen/Geometry>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Point<dim>
  FittedSurface<dim>::closest(const Point<dim> &p) const
  {
    // With an axis (cylinder, cone) the arm is the component of the position normal to it. The axis
    // of a sphere is zero, so that the arm is the whole vector from the centre, and the height is
    // 0.
    const double         height = (p - center) * axis;
    const Tensor<1, dim> arm    = (p - center) - height * axis;
    return p + arm * ((radius + slope * height) / arm.norm() - 1);
  }



  template <int dim>
  std::unique_ptr<Manifold<dim>>
  FittedSurface<dim>::manifold() const
  {
    // Means of cylindrical coordinates stay on a cone.
    return std::make_unique<RoundManifold<dim>>(center, axis);
  }



  namespace
  {
    /// @return a point as text, with components below 1e-9 of a length written as zero.
    template <int dim>
    std::string
    words(Point<dim> p, const double scale)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(p[d]) < 1e-9 * scale)
          p[d] = 0;
      return text_of(p);
    }
  } // namespace



  template <int dim>
  std::string
  FittedSurface<dim>::description() const
  {
    const std::string about = words(center, radius);
    if (axis.norm() == 0)
      return std::string(dim == 2 ? "a circle" : "a sphere") + " of radius " +
             short_text(radius, 6) + " about " + about;
    const std::string on_axis =
      " about the axis through " + about + " along " + words(Point<dim>(axis), 1);
    if (slope == 0)
      return "a cylinder of radius " + short_text(radius, 6) + on_axis;
    return "a cone" + on_axis;
  }



  namespace
  {
    /// The points to be fitted, shifted to their mean and scaled so that the farthest is at the
    /// distance 1: the least-squares problems below have entries of order one in any unit of
    /// length.
    template <int dim>
    struct PointCloud
    {
      std::vector<Point<dim>> points;
      Point<dim>              middle;
      double                  unit = 0;

      explicit PointCloud(const std::vector<Point<dim>> &given)
        : points(given)
      {
        for (const Point<dim> &p : given)
          middle += p / double(given.size());
        for (const Point<dim> &p : given)
          unit = std::max(unit, p.distance(middle));
        for (Point<dim> &p : points)
          p = Point<dim>((p - middle) / unit);
      }

      /// @return a surface that was fitted to the scaled points, in the units of the given points.
      /// The slope of a cone is a ratio and does not change.
      FittedSurface<dim>
      in_given_units(FittedSurface<dim> surface) const
      {
        surface.center = middle + unit * Tensor<1, dim>(surface.center);
        surface.radius *= unit;
        return surface;
      }
    };

    /// @return the sphere (2D: circle) fitted to points. Its equation |x|^2 = 2 c.x + d with d =
    /// r^2 - |c|^2 is linear in the unknowns c and d, and solved by linear least squares. That
    /// minimises differences of squared distances, which is the same as distances for points that
    /// are on the sphere.
    template <int dim>
    FittedSurface<dim>
    sphere_through(const std::vector<Point<dim>> &points)
    {
      Eigen::MatrixXd A(points.size(), dim + 1);
      Eigen::VectorXd b(points.size());
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          for (unsigned int d = 0; d < dim; ++d)
            A(i, d) = 2 * points[i][d];
          A(i, dim) = 1;
          b(i)      = points[i].square();
        }
      const Eigen::VectorXd x = solve_least_squares(A, b);
      FittedSurface<dim>    result{};
      for (unsigned int d = 0; d < dim; ++d)
        result.center[d] = x(d);
      result.radius = std::sqrt(std::max(0., x(dim) + result.center.square()));
      return result;
    }

    /// @return approximate axes of a cylinder or cone, in the order in which they are tried. The
    /// normals of a cylinder have no component along its axis, those of a cone all have the same:
    /// the axis is the direction in which their components have the least sum of squares, or
    /// differ least, the eigenvector of their second moments about zero, or about their mean, with
    /// the smallest eigenvalue. In a narrow patch the components along the mean normal differ
    /// little, too, so that the second guess alone may be at a right angle to the axis.
    std::array<Tensor<1, 3>, 2>
    guesses_of_axis(const std::vector<Tensor<1, 3>> &normals)
    {
      Tensor<1, 3> mean;
      for (const auto &n : normals)
        mean += n / double(normals.size());
      const auto least = [&](const Tensor<1, 3> &origin) {
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        for (const auto &n : normals)
          {
            const Tensor<1, 3>    arm = n - origin;
            const Eigen::Vector3d v(arm[0], arm[1], arm[2]);
            spread += v * v.transpose();
          }
        const Eigen::Vector3d a = eigenpairs_of_symmetric(spread).vectors.col(0);
        return Tensor<1, 3>({a[0], a[1], a[2]});
      };
      return {{least({}), least(mean)}};
    }

    /// The parameters x of a cylinder or cone, relative to an approximate one: two of the rotation
    /// of the axis, two of the shift of the centre across the axis, the radius, and for cones the
    /// slope. `first`, `second` and `axis` are an orthogonal basis.
    struct Round
    {
      Point<3>     center;
      Tensor<1, 3> axis, first, second;

      Round(const Point<3> &center, const Tensor<1, 3> &axis)
        : center(center)
        , axis(axis)
      {
        unsigned int least = 0;
        for (unsigned int d = 1; d < 3; ++d)
          if (std::abs(axis[d]) < std::abs(axis[least]))
            least = d;
        Tensor<1, 3> e;
        e[least] = 1;
        first    = cross_product_3d(axis, e);
        first /= first.norm();
        second = cross_product_3d(axis, first);
      }

      /// @return the surface with the parameters x, of which there are five (cylinder) or six
      /// (cone).
      FittedSurface<3>
      at(const Eigen::VectorXd &x) const
      {
        Tensor<1, 3> direction = axis + x(0) * first + x(1) * second;
        direction /= direction.norm();
        return {center + x(2) * first + x(3) * second, direction, x(4), x.size() > 5 ? x(5) : 0.};
      }
    };

    /// @return for each point its radial distance from the surface, positive outside. For a cone it
    /// is taken at constant height, not normal to the surface, so that it is larger than the
    /// distance by the factor sqrt(1 + slope^2).
    Eigen::VectorXd
    deviations(const FittedSurface<3> &surface, const std::vector<Point<3>> &points)
    {
      Eigen::VectorXd r(points.size());
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          const Tensor<1, 3> arm    = points[i] - surface.center;
          const double       height = arm * surface.axis;
          r(i) = (arm - height * surface.axis).norm() - surface.radius - surface.slope * height;
        }
      return r;
    }

    /// @return the cylinder (five parameters) or cone (six) that minimises the sum of the squares
    /// of the deviations, by the Gauss-Newton method with finite-difference derivatives. The
    /// iteration ends if the change of the parameters is of the size of rounding, if the
    /// least-squares system has no finite solution, or after 30 steps; the caller checks the result
    /// against its tolerance.
    FittedSurface<3>
    round_through(const std::vector<Point<3>> &points, const Round &guess, Eigen::VectorXd x)
    {
      constexpr double step = 1e-7;
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
        {
          const Eigen::VectorXd r = deviations(guess.at(x), points);
          Eigen::MatrixXd       J(r.size(), x.size());
          for (unsigned int j = 0; j < x.size(); ++j)
            {
              Eigen::VectorXd moved = x;
              moved(j) += step;
              J.col(j) = (deviations(guess.at(moved), points) - r) / step;
            }
          const Eigen::VectorXd change = solve_least_squares(J, r);
          if (!change.allFinite())
            break;
          x -= change;
          if (change.norm() < 1e-13 * (1 + x.norm()))
            break;
        }
      return guess.at(x);
    }

    /// @return the largest distance of the points from the surface; infinite if the fit has failed
    /// (NaN).
    template <int dim>
    double
    largest_distance(const FittedSurface<dim> &surface, const std::vector<Point<dim>> &points)
    {
      double largest = 0;
      for (const Point<dim> &p : points)
        {
          const double distance = surface.distance(p);
          largest               = std::isfinite(distance) ? std::max(largest, distance) :
                                                            std::numeric_limits<double>::infinity();
        }
      return largest;
    }

    /// @return the cylinder through the points whose axis has the direction of the guess: the
    /// circle through the points projected onto the plane normal to it.
    std::pair<Round, double>
    guess_of_cylinder(const std::vector<Point<3>> &points, const Tensor<1, 3> &axis)
    {
      const Round           flat({}, axis);
      std::vector<Point<2>> projected;
      for (const Point<3> &p : points)
        projected.emplace_back(p * flat.first, p * flat.second);
      const FittedSurface<2> circle = sphere_through(projected);
      return {Round(Point<3>(circle.center[0] * flat.first + circle.center[1] * flat.second), axis),
              circle.radius};
    }

    /// @return the cylinder, or else the cone, that is no farther than the tolerance from all
    /// points; none if neither is. Points and tolerance are in the units of the cloud.
    std::optional<FittedSurface<3>>
    fit_round(const PointCloud<3>             &cloud,
              const std::vector<Tensor<1, 3>> &normals,
              const double                     tolerance)
    {
      const std::array<Tensor<1, 3>, 2> axes = guesses_of_axis(normals);
      // A cylinder is tried from all guesses before a cone, which has one parameter more and fits
      // whatever a cylinder fits.
      for (const unsigned int n : {5, 6})
        for (const Tensor<1, 3> &axis : axes)
          {
            const auto [guess, radius] = guess_of_cylinder(cloud.points, axis);
            Eigen::VectorXd x          = Eigen::VectorXd::Zero(n);
            x(4)                       = radius;
            FittedSurface<3> surface   = round_through(cloud.points, guess, x);
            if (!(largest_distance(surface, cloud.points) <= tolerance))
              continue;
            // The centre is the point of the axis that is nearest to the middle of the points, the
            // origin.
            const double height = surface.center * surface.axis;
            surface.center -= height * surface.axis;
            surface.radius -= surface.slope * height;
            return surface;
          }
      return {};
    }
  } // namespace



  // In the order of increasing numbers of parameters: circle or sphere, cylinder, cone. Surfaces
  // with a radius of more than 1e4 times the extent of the points are flat for all purposes.
  template <int dim>
  std::optional<FittedSurface<dim>>
  fit_surface(const std::vector<Point<dim>>     &points,
              const std::vector<Tensor<1, dim>> &normals,
              const double                       tolerance)
  {
    constexpr double         most = 1e4; // radii, in sizes: beyond, it is flat
    const PointCloud<dim>    cloud(points);
    const FittedSurface<dim> sphere = sphere_through(cloud.points);
    if (sphere.radius < most && largest_distance(sphere, cloud.points) <= tolerance / cloud.unit)
      return cloud.in_given_units(sphere);
    if constexpr (dim == 3)
      if (const auto round = fit_round(cloud, normals, tolerance / cloud.unit);
          round && round->radius < most)
        return cloud.in_given_units(*round);
    return {};
  }



#define INSTANTIATE(dim)                                                                           \
  template struct FittedSurface<dim>;                                                              \
  template std::optional<FittedSurface<dim>> fit_surface(const std::vector<Point<dim>> &,          \
                                                         const std::vector<Tensor<1, dim>> &,      \
                                                         double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
