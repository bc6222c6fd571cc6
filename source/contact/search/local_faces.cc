// SPDX-License-Identifier: Apache-2.0
#include "contact/search/local_faces.h"

#include "contact/search/self_contact.h"
#include "geometry/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Distances and centers are equal if they differ by less, in diameters of a face.
    constexpr double same = 1e-9;
    /// Rounding of rims of faces that match, in diameters of a face.
    constexpr double rim_tolerance = 1e-6;
    /// A point overhangs a face only if its tangential over its normal distance is larger.
    constexpr double widest_wedge = 0.3;
    /// The distance between the centers of a former face and of the present one that counts as the
    /// same face, in multiples of the distance of `staying`.
    constexpr double same_face = 100;

    /// The difference of distances and of centers that is due to rounding [length].
    template <int dim>
    double
    rounding_of(const FacePatch<dim> &patch)
    {
      return same * patch.diameter() +
             16 * std::numeric_limits<double>::epsilon() * patch.center().norm();
    }

    /// Lexicographic comparison of the centers of two faces up to rounding: an order that does not
    /// depend on the partition or the numbering of faces.
    template <int dim>
    bool
    center_is_smaller(const Candidate<dim> &a, const Candidate<dim> &b)
    {
      const double tolerance = std::max(a.tolerance, b.tolerance);
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double difference = a.master_point.face_center[d] - b.master_point.face_center[d];
          if (std::abs(difference) > tolerance)
            return difference < 0;
        }
      return false;
    }

    template <int dim>
    std::vector<BoundingBox<dim>>
    boxes_of(const std::vector<FacePatch<dim>> &patches)
    {
      std::vector<BoundingBox<dim>> boxes;
      boxes.reserve(patches.size());
      for (const FacePatch<dim> &patch : patches)
        boxes.push_back(patch.box());
      return boxes;
    }
  } // namespace



  // Choose among candidates by distance, then by position above the face, then by center. Being
  // equally near within a tolerance is not transitive, so that pairwise comparisons would depend on
  // their order: the least distance is computed first, and all candidates within the tolerance of
  // it count as equals. Among these the former face of the point is kept; otherwise a face above
  // which the point lies precedes one that it overhangs (over a convex edge the point is above one
  // face and beside the other), and then the lexicographically smaller center decides.
  template <int dim>
  const Candidate<dim> *
  nearest(const std::vector<Candidate<dim>> &candidates)
  {
    double least = std::numeric_limits<double>::max();
    for (const Candidate<dim> &c : candidates)
      least = std::min(least, c.master_point.distance);

    const Candidate<dim> *best = nullptr;
    for (const Candidate<dim> &c : candidates)
      if (c.master_point.distance <= least + c.tolerance)
        {
          if (c.is_former && !c.overhangs)
            return &c;
          if (best == nullptr || c.overhangs < best->overhangs ||
              (c.overhangs == best->overhangs && center_is_smaller(c, *best)))
            best = &c;
        }
    return best;
  }



  template <int dim>
  LocalFaces<dim>::LocalFaces(const MasterFaces<dim> &master, SearchStatistics &statistics)
    : master(master)
    , statistics(statistics)
    , boxes(boxes_of(master.patches))
    , tree(pack_rtree_of_indices(boxes))
  {
    // The box of all faces of the rank is announced to the other ranks; the cone of normals of each
    // face allows rejecting it without a projection.
    for (const FacePatch<dim> &patch : master.patches)
      {
        if (rank_box.empty)
          rank_box.box = patch.box();
        rank_box.box.merge_with(patch.box());
        rank_box.empty     = false;
        rank_box.tolerance = std::max(rank_box.tolerance, rounding_of(patch));
        normals.push_back(normals_of(patch));
      }
  }



  // Bound of the variation of the normal over a face. A tangent differs from that in the middle by
  // at most the bound of the second derivatives times half of the diagonal, and the unit normal by
  // at most the change of both tangents over the smallest stretch (singular value of the Jacobian
  // matrix).
  template <int dim>
  typename LocalFaces<dim>::Normals
  LocalFaces<dim>::normals_of(const FacePatch<dim> &face)
  {
    const Point<dim - 1> middle  = face.middle();
    double               squares = 0;
    for (const Tensor<1, dim> &tangent : face.tangents(middle))
      squares += tangent.norm_square();
    // The least stretch: the area is the product of the largest and the least one.
    const double area    = face.jacobian(middle),
                 stretch = dim == 2 ? area : area / std::sqrt(squares);
    return {face.normal(middle), 2 * face.second_derivative_bound() / stretch};
  }



  // Project the point onto one face and accept the face if the projection is within the limit, if
  // it faces the point, and, on a self-contact surface, if the two material points can touch.
  template <int dim>
  std::optional<Candidate<dim>>
  LocalFaces<dim>::candidate(const Query<dim> &query, const unsigned int face)
  {
    const bool any_orientation = query.normal.norm_square() == 0;
    // A face all of whose normals point the same way as that of the point is rejected without a
    // projection.
    if (const auto &[middle, spread] = normals[face];
        !any_orientation && query.normal * middle - spread > 0)
      return {};
    const FacePatch<dim> &patch      = master.patches[face];
    const Projection<dim> projection = project(query.point, patch);
    ++statistics.projections;
    if (!projection.converged_by_newton)
      ++statistics.fallbacks;

    Candidate<dim> c;
    c.master_point.normal = patch.normal(projection.xi);
    if (!(projection.distance <= query.limit) ||
        (!any_orientation && !faces_each_other(query.normal, c.master_point.normal)))
      return {};
    if (!master.rest.empty() &&
        cannot_self_contact(query.rest,
                            reference_point(master.rest[face], projection.xi),
                            master.rest[face].diameter()))
      return {};
    c.master_point.position    = projection.position;
    c.master_point.distance    = projection.distance;
    c.master_point.face_center = patch.center();
    c.master_point.stiffness   = 0;
    // The former face has moved a little since; it is recognised by its center.
    c.is_former = patch.center().distance(query.former_center) < same_face * query.staying;
    c.tolerance = c.is_former ? query.staying : rounding_of(patch);
    c.face      = face;
    c.xi        = projection.xi;

    // Inside of a face the tangential offset is zero. At a convex edge of a faceted surface the
    // points of the wedge above the edge project onto neither face in the normal direction; up to a
    // ratio of tangential to normal distance they count as above the face. A point with a larger
    // offset is beside the face, and possibly beside the whole body.
    const double offset = projection.tangential_offset;
    const double above  = std::abs((query.point - projection.position) * c.master_point.normal);
    const double rim    = c.is_former ? query.staying : rim_tolerance * patch.diameter();
    c.overhangs         = offset > rim && offset > widest_wedge * above;
    return c;
  }



  // The first radius of find(): the projection usually lies on the face with the nearest bounding
  // box or on a neighbour of it, which a quarter of the face's diameter beyond that box reaches.
  template <int dim>
  double
  LocalFaces<dim>::first_radius(const Point<dim> &x) const
  {
    const auto nearest = tree.qbegin(boost::geometry::index::nearest(x, 1));
    return distance(x, boxes[*nearest]) + master.patches[*nearest].diameter() / 4;
  }



  // The faces whose boxes are at a distance in (inner, outer] of x, nearest first. The R-tree is
  // queried with a box and the result is sorted; the nearest-neighbour iterator of Boost keeps a
  // sorted list of all visited faces, which costs several times as much.
  template <int dim>
  const std::vector<std::pair<double, unsigned int>> &
  LocalFaces<dim>::ring(const Point<dim> &x, const double inner, const double outer)
  {
    Point<dim> lower = x, upper = x;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] -= outer;
        upper[d] += outer;
      }
    in_ring.clear();
    const auto near = boost::geometry::index::intersects(BoundingBox<dim>({lower, upper}));
    for (auto face = tree.qbegin(near); face != tree.qend(); ++face)
      if (const double d = distance(x, boxes[*face]); d > inner && d <= outer)
        in_ring.emplace_back(d, *face);
    std::sort(in_ring.begin(), in_ring.end());
    return in_ring;
  }



  // Best candidate of this rank by branch and bound: faces are visited in the order of the distance
  // of their boxes, a lower bound of the distance of the face, until the bound exceeds the distance
  // of the best projection. Each round doubles the radius, so that the loop ends once the radius
  // reaches the limit of the query. A point costs a few projections on average, whatever the number
  // of faces.
  template <int dim>
  std::optional<Candidate<dim>>
  LocalFaces<dim>::find(const Query<dim> &query)
  {
    // The search tree has no nearest entry if it is empty.
    if (boxes.empty())
      return {};
    candidates.clear();
    double limit = query.limit;
    // All faces whose boxes are not farther than this have been examined.
    double inner = -1;
    double outer = first_radius(query.point);
    // Search in rings of doubled radius. Each projection found reduces the limit to its distance
    // plus the tolerance within which ties are broken.
    while (inner < limit)
      {
        outer = std::min(outer, limit);
        for (const auto &[box_distance, face] : ring(query.point, inner, outer))
          {
            if (box_distance > limit)
              break;
            if (std::optional<Candidate<dim>> c = candidate(query, face))
              {
                limit =
                  std::min(limit,
                           c->master_point.distance + std::max(rank_box.tolerance, query.staying));
                candidates.push_back(std::move(*c));
              }
          }
        inner = outer;
        outer *= 2;
      }

    const Candidate<dim> *best = nearest(candidates);
    if (best == nullptr)
      return {};
    Candidate<dim> result = *best;
    // Shape functions and stresses are evaluated only for the one projection that may be used.
    if (!result.overhangs)
      master.complete(result.face, result.xi, result.master_point);
    return result;
  }



  template <int dim>
  std::vector<unsigned int>
  LocalFaces<dim>::in(const BoundingBox<dim> &box) const
  {
    std::vector<unsigned int> faces;
    const auto                meeting = boost::geometry::index::intersects(box);
    for (auto face = tree.qbegin(meeting); face != tree.qend(); ++face)
      faces.push_back(*face);
    std::sort(faces.begin(), faces.end());
    return faces;
  }



  template class LocalFaces<2>;
  template const Candidate<2> *
  nearest<2>(const std::vector<Candidate<2>> &);
  template class LocalFaces<3>;
  template const Candidate<3> *
  nearest<3>(const std::vector<Candidate<3>> &);
} // namespace Signorini
