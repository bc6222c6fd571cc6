#include <signorini/contact/discretisation/pairing.h>
#include <signorini/contact/geometry/descent.h>
#include <signorini/contact/geometry/local_faces.h>
#include <signorini/contact/geometry/segments.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double beside       = 1e-3;     // a face, in units of its diameter
    constexpr double covered_once = 1 + 1e-4; // of its area; the rest is the error of quadrature

    // Of degree 2 n - 1 at least on triangles, but for n = 2: products of two bilinear functions
    // are integrated by three points as well as the constant pressure of a patch test needs it.
    template <int dim>
    Quadrature<dim - 1>
    segment_rule(const unsigned int n)
    {
      if constexpr (dim == 3)
        if (n == 2)
          return Quadrature<2>({{1. / 6, 1. / 6}, {2. / 3, 1. / 6}, {1. / 6, 2. / 3}},
                               {1. / 6, 1. / 6, 1. / 6}); // Strang, Fix: degree 2
      return QWitherdenVincentSimplex<dim - 1>(n);
    }

    template <int dim>
    bool
    is_distorted(const FacePatch<dim> &face)
    {
      if constexpr (dim == 2)
        return false;
      else
        {
          // Of the kites in an equilateral triangle it is 0.5.
          constexpr double     most   = 0.2;
          const Tensor<1, dim> defect = (face.position({0, 0}) - face.position({1, 0})) +
                                        (face.position({1, 1}) - face.position({0, 1}));
          return defect.norm() > most * face.diameter();
        }
    }

    template <int dim>
    struct SegmentRules
    {
      Quadrature<dim - 1> usual, distorted;
    };

    // A slave face on its way to the master's faces.
    template <int dim>
    struct TravellingFace
    {
      FacePatch<dim> patch;
      unsigned int   number; // on its own rank

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &patch &number;
      }
    };

    template <int dim>
    Tensor<1, dim>
    tangential_part(const Tensor<1, dim> &v, const Tensor<1, dim> &normal)
    {
      return v - (v * normal) * normal;
    }

    template <int dim>
    Projection<dim>
    project_from(const Point<dim> &x, const FacePatch<dim> &face, const Point<dim - 1> &start)
    {
      Projection<dim> result;
      result.xi                  = start;
      result.converged_by_newton = descend_to_minimum(x, face, result.xi);
      if (!result.converged_by_newton)
        return project(x, face);
      result.position = face.position(result.xi);
      result.distance = x.distance(result.position);
      return result;
    }

    // Segments of slave faces with the master faces of this rank.
    template <int dim>
    class LocalSegments
    {
    public:
      LocalSegments(const MasterFaces<dim>  &master,
                    const SegmentRules<dim> &rules,
                    const double             limit,
                    SearchStatistics        &statistics)
        : master(master)
        , faceted(master.patches.begin(), master.patches.end())
        , faces(master, statistics)
        , rules(rules)
        , limit(limit)
        , statistics(statistics)
      {
        for (const FacePatch<dim> &face : master.patches)
          distorted.push_back(is_distorted(face));
      }

      const RankBox<dim> &
      extent() const
      {
        return faces.extent();
      }

      void
      find(const TravellingFace<dim> &slave, std::vector<PairedPoint<dim>> &found)
      {
        const FacetedFace<dim> own(slave.patch);
        const bool             own_distorted = is_distorted(slave.patch);
        for (const unsigned int face : faces.in(own.extruded_box(reach(slave.patch, limit))))
          for (const SegmentPoint<dim> &point :
               segment_points(own,
                              faceted[face],
                              own_distorted || distorted[face] ? rules.distorted : rules.usual))
            if (auto pair = paired(slave, face, point))
              found.push_back(std::move(*pair));
      }

    private:
      std::optional<PairedPoint<dim>>
      paired(const TravellingFace<dim> &slave,
             const unsigned int         face,
             const SegmentPoint<dim>   &point)
      {
        const FacePatch<dim> &patch = master.patches[face];
        const Point<dim>      x     = slave.patch.position(point.slave);
        const Projection<dim> foot  = project_from(x, patch, point.master);
        ++statistics.projections;
        if (!foot.converged_by_newton)
          ++statistics.fallbacks;

        PairedPoint<dim> pair{slave.number, point.slave, point.weight, {}};
        pair.partner.normal = patch.normal(foot.xi);
        pair.is_beside      = tangential_part(x - foot.position, pair.partner.normal).norm() >
                         beside * patch.diameter();
        if (foot.distance > reach(slave.patch, limit) ||
            !faces_each_other(slave.patch.normal(point.slave), pair.partner.normal))
          return {};
        pair.partner.position    = foot.position;
        pair.partner.distance    = foot.distance;
        pair.partner.face_center = patch.center();
        master.complete(face, foot.xi, pair.partner);
        return pair;
      }

      const MasterFaces<dim>             &master;
      const std::vector<FacetedFace<dim>> faceted;
      LocalFaces<dim>                     faces;
      std::vector<bool>                   distorted; ///< faces of the master
      const SegmentRules<dim>            &rules;
      const double                        limit;
      SearchStatistics                   &statistics;
    };

    // Faces travel to the master faces of other ranks, points come back.
    template <int dim>
    std::vector<PairedPoint<dim>>
    pair_by_segments(const std::vector<FacePatch<dim>> &slave,
                     const MasterFaces<dim>            &master,
                     const SegmentRules<dim>           &rules,
                     const double                       limit,
                     const MPI_Comm                     comm,
                     SearchStatistics                  &statistics)
    {
      LocalSegments<dim>            segments(master, rules, limit, statistics);
      std::vector<PairedPoint<dim>> points;
      for (unsigned int i = 0; i < slave.size(); ++i)
        segments.find({slave[i], i}, points);
      if (Utilities::MPI::n_mpi_processes(comm) == 1)
        return points;

      const auto                    ranks = Utilities::MPI::all_gather(comm, segments.extent());
      std::vector<BoundingBox<dim>> boxes;
      for (const FacePatch<dim> &face : slave)
        boxes.push_back(FacetedFace<dim>(face).extruded_box(reach(face, limit)));
      std::map<unsigned int, std::vector<TravellingFace<dim>>> outgoing;
      for (unsigned int rank = 0; rank < ranks.size(); ++rank)
        if (rank != Utilities::MPI::this_mpi_process(comm) && !ranks[rank].empty)
          for (unsigned int i = 0; i < slave.size(); ++i)
            if (boxes[i].get_neighbor_type(ranks[rank].box) != NeighborType::not_neighbors)
              outgoing[rank].push_back({slave[i], i});

      std::map<unsigned int, std::vector<PairedPoint<dim>>> answers;
      for (const auto &[rank, visitors] : Utilities::MPI::some_to_some(comm, outgoing))
        for (const TravellingFace<dim> &visitor : visitors)
          segments.find(visitor, answers[rank]);
      for (auto &[rank, found] : Utilities::MPI::some_to_some(comm, answers))
        points.insert(points.end(),
                      std::make_move_iterator(found.begin()),
                      std::make_move_iterator(found.end()));
      return points;
    }

    // The same points on each face of a list.
    template <int dim>
    std::vector<LaidPoint<dim>>
    lay(const std::vector<FacePatch<dim>> &slave,
        const std::vector<unsigned int>   &faces,
        const Quadrature<dim - 1>         &rule)
    {
      std::vector<LaidPoint<dim>> points;
      for (const unsigned int i : faces)
        for (unsigned int q = 0; q < rule.size(); ++q)
          points.push_back(
            {i, rule.point(q), rule.weight(q) * slave[i].jacobian(rule.point(q)), {}});
      return points;
    }

    template <int dim>
    std::vector<PairedPoint<dim>>
    pair_by_projection(const std::vector<FacePatch<dim>> &slave,
                       const std::vector<LaidPoint<dim>> &laid,
                       const MasterFaces<dim>            &master,
                       const double                       limit,
                       const MPI_Comm                     comm,
                       SearchStatistics                  &statistics)
    {
      std::vector<Point<dim>>      positions;
      std::vector<Tensor<1, dim>>  normals;
      std::vector<FormerFace<dim>> former;
      double                       largest = 0;
      for (const FacePatch<dim> &face : slave)
        largest = std::max(largest, reach(face, limit));
      for (const LaidPoint<dim> &point : laid)
        {
          positions.push_back(slave[point.face].position(point.xi));
          normals.push_back(slave[point.face].normal(point.xi));
          former.push_back(point.former);
        }
      auto partners = find_partners(
        positions, normals, master, Utilities::MPI::max(largest, comm), comm, &statistics, former);

      std::vector<PairedPoint<dim>> points;
      for (std::size_t i = 0; i < laid.size(); ++i)
        if (partners[i])
          points.push_back({laid[i].face, laid[i].xi, laid[i].weight, std::move(*partners[i])});
      return points;
    }

    // Of points beside their partner's face the partner that is closest, if that is another one.
    template <int dim>
    void
    move_to_closest(const std::vector<FacePatch<dim>> &slave,
                    const MasterFaces<dim>            &master,
                    const MPI_Comm                     comm,
                    SearchStatistics                  &statistics,
                    std::vector<PairedPoint<dim>>     &points)
    {
      constexpr double                closer = 1 - 1e-6; // over an edge two faces are equally close
      std::vector<PairedPoint<dim> *> beside_faces;
      std::vector<Point<dim>>         positions;
      std::vector<Tensor<1, dim>>     normals;
      double                          farthest = 0;
      for (PairedPoint<dim> &point : points)
        if (point.is_beside)
          {
            beside_faces.push_back(&point);
            positions.push_back(slave[point.face].position(point.xi));
            normals.push_back(slave[point.face].normal(point.xi));
            farthest = std::max(farthest, point.partner.distance);
          }
      farthest = Utilities::MPI::max(farthest, comm);
      if (farthest == 0)
        return;
      auto partners = find_partners(positions, normals, master, farthest, comm, &statistics);
      for (std::size_t i = 0; i < partners.size(); ++i)
        if (partners[i] && partners[i]->distance < closer * beside_faces[i]->partner.distance)
          beside_faces[i]->partner = std::move(*partners[i]);
    }

    // One of 3^dim, by the signs of the components that are not small.
    template <int dim>
    unsigned int
    direction(const Tensor<1, dim> &normal)
    {
      constexpr double small  = 0.38; // sin 22.5 degrees
      unsigned int     number = 0;
      for (unsigned int d = 0; d < dim; ++d)
        number = 3 * number + (normal[d] > small ? 2 : normal[d] < -small ? 0 : 1);
      return number;
    }

    // A point behind a face that faces it overlaps with the body if it is inside, and if that is
    // the way out: an overlap is resolved along its least depth. Beyond a plate, points are behind
    // the plate's other side; of two blocks that overlap a little, the left side of the one is
    // behind the right side of the other, as far as these are broad. The way out is where points
    // are about as far from the closest place of the surface as from their partner; near edges they
    // are not, and follow those of the same direction.
    template <int dim>
    void
    drop_false_overlaps(const std::vector<FacePatch<dim>> &slave,
                        const MasterFaces<dim>            &master,
                        const MPI_Comm                     comm,
                        SearchStatistics                  &statistics,
                        std::vector<PairedPoint<dim>>     &points)
    {
      constexpr double         shallow = 0.01; // in diameters of the slave face: taken for true
      std::vector<std::size_t> numbers;
      std::vector<Point<dim>>  positions;
      std::vector<double>      ways;
      for (std::size_t i = 0; i < points.size(); ++i)
        {
          const Partner<dim>   &partner = points[i].partner;
          const FacePatch<dim> &face    = slave[points[i].face];
          const Point<dim>      x       = face.position(points[i].xi);
          const double          way     = (partner.position - x) * partner.normal;
          if (way <= shallow * face.diameter())
            continue;
          numbers.push_back(i);
          positions.push_back(x);
          ways.push_back(way);
        }
      const double farthest =
        Utilities::MPI::max(ways.empty() ? 0. : *std::max_element(ways.begin(), ways.end()), comm);
      if (farthest == 0)
        return;
      const std::vector<double> depth = depths(positions, master, farthest, comm, &statistics);
      std::vector<double>       way_out(Utilities::fixed_power<dim>(3u), 0.); // of each direction
      for (std::size_t i = 0; i < numbers.size(); ++i)
        if (double &way = way_out[direction(points[numbers[i]].partner.normal)];
            depth[i] >= ways[i] / 2)
          way = std::max(way, ways[i]);
      Utilities::MPI::max(way_out, comm, way_out);

      std::vector<bool> is_false(points.size(), false);
      for (std::size_t i = 0; i < numbers.size(); ++i)
        is_false[numbers[i]] =
          depth[i] < 0 || ways[i] > 2 * way_out[direction(points[numbers[i]].partner.normal)];
      std::size_t kept = 0;
      for (std::size_t i = 0; i < points.size(); ++i)
        if (!is_false[i])
          {
            if (kept < i)
              points[kept] = std::move(points[i]);
            ++kept;
          }
      points.resize(kept);
    }

    // Points of one face one after the other, in the order that they were found in. Numbers are
    // sorted, since points are large.
    template <int dim>
    std::vector<PairedPoint<dim>>
    sorted_by_faces(std::vector<PairedPoint<dim>> &&points)
    {
      std::vector<unsigned int> order(points.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return points[a].face < points[b].face;
      });
      std::vector<PairedPoint<dim>> sorted;
      sorted.reserve(points.size());
      for (const unsigned int i : order)
        sorted.push_back(std::move(points[i]));
      return sorted;
    }

    // Take the points of faces that are covered more than once out of the list.
    template <int dim>
    std::vector<unsigned int>
    remove_overcovered(const std::vector<FacePatch<dim>> &slave,
                       std::vector<PairedPoint<dim>>     &points)
    {
      unsigned int degree = 1;
      for (const FacePatch<dim> &face : slave)
        degree = std::max(degree, face.get_degree());
      const QGauss<dim - 1> rule(degree + 2);
      std::vector<double>   covered(slave.size(), 0.);
      for (const PairedPoint<dim> &point : points)
        covered[point.face] += point.weight;

      std::vector<unsigned int> faces;
      std::vector<bool>         more_than_once(slave.size(), false);
      for (unsigned int i = 0; i < slave.size(); ++i)
        {
          double area = 0;
          for (unsigned int q = 0; q < rule.size(); ++q)
            area += rule.weight(q) * slave[i].jacobian(rule.point(q));
          more_than_once[i] = covered[i] > covered_once * area;
          if (more_than_once[i])
            faces.push_back(i);
        }
      points.erase(std::remove_if(points.begin(),
                                  points.end(),
                                  [&](const auto &point) { return more_than_once[point.face]; }),
                   points.end());
      return faces;
    }
  } // namespace



  template <int dim>
  Quadrature<dim - 1>
  face_rule(const Integration &integration)
  {
    if (integration.rule == "nodes")
      return QGaussLobatto<dim - 1>(integration.n_points);
    return QGauss<dim - 1>(integration.n_points);
  }



  template <int dim>
  std::vector<PairedPoint<dim>>
  pair_points(const std::vector<FacePatch<dim>> &slave,
              const MasterFaces<dim>            &master,
              const Integration                 &integration,
              const double                       limit,
              const MPI_Comm                     comm,
              SearchStatistics                  &statistics)
  {
    std::vector<PairedPoint<dim>> points;
    const Quadrature<dim - 1>     rule = face_rule<dim>(integration);
    std::vector<unsigned int>     faces(slave.size());
    std::iota(faces.begin(), faces.end(), 0);
    if (integration.rule == "segments")
      {
        const unsigned int      n     = integration.n_points;
        const unsigned int      more  = std::max(n, integration.n_points_of_distorted);
        const SegmentRules<dim> rules = {segment_rule<dim>(n), segment_rule<dim>(more)};
        points = pair_by_segments(slave, master, rules, limit, comm, statistics);
        faces  = remove_overcovered(slave, points);
        move_to_closest(slave, master, comm, statistics, points);
      }
    if (Utilities::MPI::max(faces.size(), comm) > 0)
      for (auto &point :
           pair_by_projection(slave, lay(slave, faces, rule), master, limit, comm, statistics))
        points.push_back(std::move(point));
    drop_false_overlaps(slave, master, comm, statistics, points);
    keep_near_faces(limit, points);
    return sorted_by_faces(std::move(points));
  }



  template <int dim>
  std::vector<PairedPoint<dim>>
  pair_laid_points(const std::vector<FacePatch<dim>> &slave,
                   const std::vector<LaidPoint<dim>> &laid,
                   const MasterFaces<dim>            &master,
                   const double                       limit,
                   const MPI_Comm                     comm,
                   SearchStatistics                  &statistics)
  {
    auto points = pair_by_projection(slave, laid, master, limit, comm, statistics);
    keep_near_faces(limit, points);
    return points;
  }



  template <int dim>
  void
  keep_near_faces(const double limit, std::vector<PairedPoint<dim>> &points)
  {
    std::vector<double> nearest;
    for (const auto &point : points)
      {
        if (point.face >= nearest.size())
          nearest.resize(point.face + 1, std::numeric_limits<double>::max());
        nearest[point.face] = std::min(nearest[point.face], point.partner.distance);
      }
    points.erase(std::remove_if(points.begin(),
                                points.end(),
                                [&](const auto &point) { return nearest[point.face] > limit; }),
                 points.end());
  }



  template std::vector<PairedPoint<2>>
  pair_laid_points(const std::vector<FacePatch<2>> &,
                   const std::vector<LaidPoint<2>> &,
                   const MasterFaces<2> &,
                   double,
                   MPI_Comm,
                   SearchStatistics &);
  template std::vector<PairedPoint<3>>
  pair_laid_points(const std::vector<FacePatch<3>> &,
                   const std::vector<LaidPoint<3>> &,
                   const MasterFaces<3> &,
                   double,
                   MPI_Comm,
                   SearchStatistics &);
  template void
  keep_near_faces(double, std::vector<PairedPoint<2>> &);
  template void
  keep_near_faces(double, std::vector<PairedPoint<3>> &);
  template Quadrature<1>
  face_rule<2>(const Integration &);
  template Quadrature<2>
  face_rule<3>(const Integration &);
  template std::vector<PairedPoint<2>>
  pair_points<2>(const std::vector<FacePatch<2>> &,
                 const MasterFaces<2> &,
                 const Integration &,
                 double,
                 MPI_Comm,
                 SearchStatistics &);
  template std::vector<PairedPoint<3>>
  pair_points<3>(const std::vector<FacePatch<3>> &,
                 const MasterFaces<3> &,
                 const Integration &,
                 double,
                 MPI_Comm,
                 SearchStatistics &);
} // namespace Signorini
