// SPDX-License-Identifier: Apache-2.0
#include "contact/history/surface_field.h"

#include "geometry/face_functions.h"
#include "mesh/cells_by_name.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>

namespace Signorini
{
  using namespace dealii;

  /// The hash by which owners of faces are found: that of the cell, since all faces of a cell are
  /// stored by the same rank.
  static std::uint64_t
  hash_of(const FaceId &id)
  {
    return hash_of(id.cell);
  }



  namespace
  {
    using Values = std::vector<SurfacePointValue>;

    /// The half of a face, 0 or 1 along each of its parameters, that a child of its cell has.
    std::array<unsigned int, 2>
    halves(const unsigned int child, const unsigned int face, const unsigned int dim)
    {
      std::array<unsigned int, 2> result{};
      // Parameter d of face f is the coordinate (f/2 + 1 + d) modulo dim of the cell: bit by bit
      // the number of the child is the half in each coordinate.
      for (unsigned int d = 0; d + 1 < dim; ++d)
        result[d] = (child >> ((face / 2 + 1 + d) % dim)) & 1;
      return result;
    }

    /// The child of a cell that has given halves of a face.
    unsigned int
    child_at(const unsigned int                 face,
             const std::array<unsigned int, 2> &half,
             const unsigned int                 dim)
    {
      unsigned int child = (face % 2) << (face / 2);
      for (unsigned int d = 0; d + 1 < dim; ++d)
        child |= half[d] << ((face / 2 + 1 + d) % dim);
      return child;
    }

    /// The face of the parent cell that contains a face.
    FaceId
    parent_of(const FaceId &id)
    {
      return {id.pair, Signorini::parent_of(id.cell), id.face};
    }

    /// The face of a child cell.
    FaceId
    child_of(const FaceId &id, const unsigned int child)
    {
      return {id.pair, Signorini::child_of(id.cell, child), id.face};
    }

    double
    distance_square(const SurfacePoint &a, const SurfacePoint &b)
    {
      return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
    }

    /// Parameters that are computed in different ways agree up to this.
    constexpr double rounding = 1e-9;

    /// The face whose face_lattice() has the points of the values, and its degree; 0 if they are
    /// at other points.
    std::pair<ReferenceCell, unsigned int>
    lattice_of(const Values &values, const unsigned int dim)
    {
      const auto fits = [&](const ReferenceCell &shape, const unsigned int k) {
        bool         result = true;
        unsigned int n      = 0;
        for_each_lattice_node(shape, k, [&](const unsigned int i, const unsigned int j) {
          const SurfacePoint node = {{double(i) / k, double(j) / k}};
          result                  = result && n < values.size() &&
                   distance_square(values[n].place, node) <= rounding * rounding;
          ++n;
        });
        return result && n == values.size();
      };
      for (unsigned int k = 1; k <= max_degree; ++k)
        if (fits(dim == 2 ? ReferenceCells::Line : ReferenceCells::Quadrilateral, k))
          return {dim == 2 ? ReferenceCells::Line : ReferenceCells::Quadrilateral, k};
      for (unsigned int k = 1; dim == 3 && k <= 2; ++k)
        if (fits(ReferenceCells::Triangle, k))
          return {ReferenceCells::Triangle, k};
      return {ReferenceCells::Invalid, 0};
    }

    /// The k-th number of a point that is interpolated: the pressure, then the history.
    double
    entry(const SurfacePointValue &value, const unsigned int k)
    {
      return k == 0 ? value.pressure : value.history[k - 1];
    }

    /// The polynomial through the values of a lattice, at a point.
    template <int dim>
    double
    polynomial(const Values        &values,
               const ReferenceCell &shape,
               const unsigned int   degree,
               const SurfacePoint  &place,
               const unsigned int   k)
    {
      Point<dim - 1> xi;
      for (unsigned int d = 0; d < dim - 1; ++d)
        xi[d] = place[d];
      const FaceFunctions<dim> functions(shape, degree, xi);
      double                   sum = 0;
      for (unsigned int i = 0; i < values.size(); ++i)
        sum += entry(values[i], k) * functions.value(i);
      return sum;
    }

    /// The value at a point of the plane fitted to the values with weights 1/distance^4 (moving
    /// least squares: Lancaster, Salkauskas, Math. Comp. 37 (1981) 141; doc/theory, 3.8); a
    /// weighted mean where the points do not determine a plane.
    double
    plane(const Values &values, const SurfacePoint &place, const unsigned int k)
    {
      Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
      Eigen::Vector3d b = Eigen::Vector3d::Zero();
      for (const SurfacePointValue &value : values)
        {
          // The summand keeps the weight of points at nearly the same position finite.
          const double          square = distance_square(value.place, place) + 1e-6;
          const double          weight = 1 / (square * square);
          const Eigen::Vector3d terms(1, value.place[0] - place[0], value.place[1] - place[1]);
          A += weight * terms * terms.transpose();
          b += weight * entry(value, k) * terms;
        }
      // A small regularisation: slopes that the points do not determine become zero.
      const double least = 1e-12 * (A(1, 1) + A(2, 2)) + 1e-15 * A(0, 0);
      A(1, 1) += least;
      A(2, 2) += least;
      return A.ldlt().solve(b)[0];
    }

    /// The values at a point of a face: those stored there, or interpolated ones.
    SurfacePointValue
    interpolate(const Values &values, const SurfacePoint &place, const unsigned int dim)
    {
      for (const SurfacePointValue &value : values)
        if (distance_square(value.place, place) < rounding * rounding)
          return value;
      SurfacePointValue result;
      result.place = place;
      if (values.empty())
        return result;
      const auto lattice = lattice_of(values, dim);
      const auto at      = [&](const unsigned int k) {
        const auto &[shape, degree] = lattice;
        return degree == 0 ? plane(values, place, k) :
                    dim == 2    ? polynomial<2>(values, shape, degree, place, k) :
                                  polynomial<3>(values, shape, degree, place, k);
      };
      result.pressure = at(0);
      for (unsigned int k = 0; k < values.front().history.size(); ++k)
        result.history.push_back(at(k + 1));
      // The point is closed if its pressure is positive, and then has the status of the nearest
      // closed point.
      double closest = std::numeric_limits<double>::max();
      for (const SurfacePointValue &value : values)
        if (const double distance = distance_square(value.place, place);
            result.pressure > 0 && value.status > 0 && distance < closest)
          {
            closest       = distance;
            result.status = value.status;
          }
      if (result.pressure > 0 && result.status == 0)
        result.status = 1;
      return result;
    }
  } // namespace



  // Faces, their parents and children are requested from the ranks that store them, so that at()
  // needs no communication. Collective.
  SurfaceField
  SurfaceField::gathered_at(const std::vector<FaceId> &wanted, const MPI_Comm comm) const
  {
    std::vector<FaceId> names;
    for (const FaceId &id : wanted)
      {
        names.push_back(id);
        if (has_parent(id.cell))
          names.push_back(parent_of(id));
        for (unsigned int half = 0; half < (dim == 3 ? 4u : 2u); ++half)
          names.push_back(child_of(id, child_at(id.face, {{half % 2, half / 2}}, dim)));
      }
    SurfaceField result(dim);
    result.faces = gather_values(faces, names, comm);
    return result;
  }



  // The face itself, its parent (after a refinement), or the child that has the point (after
  // coarsening).
  std::optional<SurfacePointValue>
  SurfaceField::at(const FaceId &face, const SurfacePoint &place) const
  {
    if (const auto own = faces.find(face); own != faces.end())
      return interpolate(own->second, place, dim);

    if (has_parent(face.cell))
      if (const auto parent = faces.find(parent_of(face)); parent != faces.end())
        {
          const auto half = halves(number_of_child(face.cell), face.face, dim);
          return interpolate(parent->second,
                             {{(place[0] + half[0]) / 2, dim == 3 ? (place[1] + half[1]) / 2 : 0.}},
                             dim);
        }

    std::array<unsigned int, 2> half{};
    SurfacePoint                there{};
    for (unsigned int d = 0; d + 1 < dim; ++d)
      {
        half[d]  = place[d] < 0.5 ? 0 : 1;
        there[d] = 2 * place[d] - half[d];
      }
    const auto child = faces.find(child_of(face, child_at(face.face, half, dim)));
    if (child == faces.end())
      return {};
    return interpolate(child->second, there, dim);
  }
} // namespace Signorini
