#include <signorini/contact/discretisation/contact_points.h>
#include <signorini/contact/discretisation/gaps_at_rest.h>
#include <signorini/contact/discretisation/master_faces.h>
#include <signorini/contact/discretisation/obstacle_points.h>
#include <signorini/contact/discretisation/pressure_functions.h>
#include <signorini/contact/discretisation/surface.h>
#include <signorini/contact/geometry/deep_overlap.h>
#include <signorini/contact/geometry/reach.h>
#include <signorini/contact/methods/method.h>
#include <signorini/parameters/section.h>
#include <signorini/parameters/text.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Segments that touch a face in a line only have no area, and their points no say.
    template <int dim>
    void
    drop_empty_points(const std::vector<FacePatch<dim>> &slave,
                      std::vector<PairedPoint<dim>>     &points)
    {
      const auto is_empty = [&](const PairedPoint<dim> &point) {
        return point.weight < 1e-13 * slave[point.face].jacobian(point.xi);
      };
      points.erase(std::remove_if(points.begin(), points.end(), is_empty), points.end());
    }

    template <int dim>
    bool
    has_shapes(const std::vector<ContactPoint<dim>> &points)
    {
      return std::any_of(points.begin(), points.end(), [](const auto &point) {
        return !point.shape.empty();
      });
    }

    template <int dim>
    void
    check_gaps(const ContactPair<dim>               &pair,
               const std::vector<ContactPoint<dim>> &points,
               const MPI_Comm                        comm)
    {
      const bool bad = std::any_of(points.begin(), points.end(), [](const auto &point) {
        return !std::isfinite(point.gap);
      });
      if (Utilities::MPI::max(bad ? 1 : 0, comm) > 0)
        throw SceneError(pair.slave_place + ": Initial gap = " + pair.initial_gap.text +
                         " is not a number somewhere on '" + pair.slave + "'; correct the formula");
    }

    template <int dim>
    std::vector<SlaveFace<dim>>
    slave_faces(const Elasticity<dim>                &elasticity,
                const BoundaryFaces<dim>             &slave,
                const std::vector<ContactPoint<dim>> &points)
    {
      std::vector<SlaveFace<dim>> result(slave.faces.size());
      Trace<dim>                  trace(elasticity);
      for (const ContactPoint<dim> &point : points)
        if (SlaveFace<dim> &face = result[point.face]; face.degree == 0)
          {
            const auto &[cell, f] = slave.faces[point.face];
            trace.reinit(cell, f);
            face.cell            = cell->id();
            face.face            = f;
            const unsigned int k = face.degree = cell->get_fe().degree;
            for (const Point<dim - 1> &xi : face_lattice<dim>(k))
              {
                const SparseRow shape = trace.unresolved_shape(unit_point<dim>(f, xi));
                face.nodes.push_back(
                  std::max_element(shape.begin(), shape.end(), [](const auto &a, const auto &b) {
                    return a.second < b.second;
                  })->first);
                face.positions.push_back(slave.rest[point.face].position(xi));
              }
          }
      return result;
    }

    template <int dim>
    std::vector<std::pair<SparseRow, double>>
    whole_faces(const Elasticity<dim> &elasticity, const BoundaryFaces<dim> &slave)
    {
      std::vector<std::pair<SparseRow, double>> result;
      Trace<dim>                                trace(elasticity);
      for (unsigned int i = 0; i < slave.faces.size(); ++i)
        {
          const QGauss<dim - 1> rule(slave.faces[i].first->get_fe().degree + 1);
          trace.reinit(slave.faces[i].first, slave.faces[i].second);
          for (unsigned int q = 0; q < rule.size(); ++q)
            result.emplace_back(trace.shape(unit_point<dim>(slave.faces[i].second, rule.point(q))),
                                rule.weight(q) * slave.rest[i].jacobian(rule.point(q)) *
                                  measure(elasticity.model(),
                                          slave.rest[i].position(rule.point(q))));
        }
      return result;
    }

    /// Of normals from opposite [degrees].
    template <int dim>
    double
    largest_angle(const BoundaryFaces<dim>            &slave,
                  const std::vector<PairedPoint<dim>> &paired,
                  const MPI_Comm                       comm)
    {
      double smallest = 1;
      for (const PairedPoint<dim> &point : paired)
        smallest =
          std::min(smallest, -(slave.patches[point.face].normal(point.xi) * point.partner.normal));
      return std::acos(Utilities::MPI::min(smallest, comm)) * 180 / numbers::PI;
    }

    /// At a node of the master, one function is one and all others are zero.
    template <int dim>
    bool
    is_at_node(const Partner<dim> &partner)
    {
      double squares = 0; // of n_d phi_j
      for (const auto &entry : partner.row)
        squares += entry.second * entry.second;
      return squares > 0.95;
    }

    /// What the faces with points have of each other.
    template <int dim>
    void
    compare(const Elasticity<dim>               &elasticity,
            const BoundaryFaces<dim>            &slave,
            const std::vector<PairedPoint<dim>> &paired,
            const bool                           is_obstacle,
            const MPI_Comm                       comm,
            ContactSurface<dim>                 &surface)
    {
      std::vector<double> sums(5, 0.); // area, size, area off nodes, logarithms of the ratios
      for (const PairedPoint<dim> &point : paired)
        {
          const double size = slave.patches[point.face].diameter();
          sums[0] += point.weight;
          sums[1] += point.weight * size;
          if (is_obstacle)
            continue;
          sums[2] += is_at_node(point.partner) ? 0. : point.weight;
          sums[3] +=
            point.weight * std::log(slave.modulus(elasticity, point.face) / point.partner.modulus);
          sums[4] += point.weight * std::log(size / point.partner.size);
        }
      Utilities::MPI::sum(sums, comm, sums);
      if (sums[0] == 0)
        return;
      surface.face_size = sums[1] / sums[0];
      surface.off_nodes = sums[2] / sums[0];
      surface.sides     = {std::exp(sums[3] / sums[0]), std::exp(sums[4] / sums[0])};
    }

    template <int dim>
    double
    deepest_overlap(const std::vector<ContactPoint<dim>> &points, const MPI_Comm comm)
    {
      double deepest = 0;
      for (const ContactPoint<dim> &point : points)
        deepest = std::max(deepest, -point.gap_now());
      return Utilities::MPI::max(deepest, comm);
    }

    /// Faces that are farther away than the reach are no candidates; overlapping ones always are.
    template <int dim>
    void
    keep_candidates(const double                    reach,
                    const BoundaryFaces<dim>       &slave,
                    std::vector<PairedPoint<dim>>  &paired,
                    std::vector<ContactPoint<dim>> &points)
    {
      std::vector<bool> is_near(slave.faces.size(), false);
      for (const ContactPoint<dim> &point : points)
        if (point.gap_now() <= reach)
          is_near[point.face] = true;
      const auto is_far = [&](const auto &point) { return !is_near[point.face]; };
      paired.erase(std::remove_if(paired.begin(), paired.end(), is_far), paired.end());
      points.erase(std::remove_if(points.begin(), points.end(), is_far), points.end());
    }

    /// Of surfaces that are never to separate, what touches at the start up to the error of the
    /// mesh, or what is within the search distance. Their gaps stay, their overlaps do not.
    template <int dim>
    void
    keep_touching(const ContactPair<dim>         &pair,
                  const BoundaryFaces<dim>       &slave,
                  std::vector<PairedPoint<dim>>  &paired,
                  std::vector<ContactPoint<dim>> &points)
    {
      constexpr double error_of_mesh = 0.1; // in face sizes
      const bool       is_given      = pair.initial_gap.text != "from geometry";
      unsigned int     n             = 0;
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          const double most = error_of_mesh * slave.patches[points[i].face].diameter();
          if (!is_given && pair.search_distance == 0 && points[i].gap > most)
            continue;
          if (!is_given)
            points[i].gap = std::min(points[i].gap, 0.);
          if (n < i)
            {
              points[n] = std::move(points[i]);
              paired[n] = std::move(paired[i]);
            }
          ++n;
        }
      points.resize(n);
      paired.resize(n);
    }

    /// That an initial overlap asks for.
    template <int dim>
    double
    limit_for(const double overlap, const ContactPair<dim> &pair)
    {
      if (pair.search_distance > 0)
        throw SceneError(
          pair.slave_place + ": '" + pair.slave + "' lies up to " + short_text(overlap, 4) +
          " deep in '" + pair.master + "' at the start, deeper than its Search distance of " +
          short_text(pair.search_distance, 4) + "; enlarge that, or move the bodies apart");
      return 1.1 * overlap;
    }

    template <int dim>
    void
    check_obstacle(const Configuration<dim> &configuration,
                   const ContactPair<dim>   &pair,
                   const Obstacle<dim>      &obstacle,
                   const BoundaryFaces<dim> &slave)
    {
      if (configuration.is_rest())
        return;
      const double length = configuration.elasticity().lever();
      const bool   bad =
        std::any_of(slave.rest.begin(), slave.rest.end(), [&](const FacePatch<dim> &face) {
          return !obstacle.shape->has_closest_point(face.center(), length);
        });
      if (Utilities::MPI::max(bad ? 1 : 0, configuration.elasticity().mesh().communicator()) > 0)
        throw SceneError(
          pair.master_place + ": the Gap of '" + obstacle.name +
          "' does not rise by 1 along its Normal: that is the gap of a surface at rest, and nobody "
          "knows where the obstacle is beside it; write the formula for every place, as in y - "
          "x^2/20 for Normal = 0, 1, or take Contact method/Contact geometry = reference");
    }

    /// So that the gap is true where the surfaces are: less row . u, which is how far slave and
    /// master have moved along the normal.
    template <int dim>
    void
    set_drift(const LA::Vector                    &u,
              const BoundaryFaces<dim>            &slave,
              const std::vector<PairedPoint<dim>> &paired,
              const bool                           is_obstacle,
              std::vector<ContactPoint<dim>>      &points)
    {
      std::vector<const SparseRow *> rigid_rows;
      for (const PairedPoint<dim> &point : paired)
        if (is_obstacle)
          rigid_rows.push_back(&point.partner.row);
      const std::vector<double> rigid = row_values(rigid_rows, u);
      for (std::size_t i = 0; i < points.size(); ++i)
        {
          const PairedPoint<dim> &pair = paired[i];
          const Tensor<1, dim>   &n    = pair.partner.normal;
          const Point<dim>        x    = slave.patches[pair.face].position(pair.xi);
          const double            master =
            is_obstacle ? rigid[i] : (pair.partner.position - points[i].master_position) * n;
          points[i].drift = -points[i].closing - (x - points[i].position) * n + master;
        }
    }

    /// With the pair's slave and master as they are.
    template <int dim>
    ContactSurface<dim>
    one_sided(const Configuration<dim>          &configuration,
              const ContactPair<dim>            &pair,
              const Obstacle<dim>               *obstacle,
              const ContactMethod               &method,
              const Integration                 &integration,
              const double                       reach,
              const double                       least_limit,
              const std::vector<LaidPoint<dim>> &laid)
    {
      const Elasticity<dim>   &elasticity = configuration.elasticity();
      const bool               at_rest    = configuration.is_rest();
      const MPI_Comm           comm       = elasticity.mesh().communicator();
      const BoundaryFaces<dim> slave(configuration, pair.slave);
      double limit = at_rest ? search_limit(elasticity, pair, reach) : std::max(reach, least_limit);
      if (at_rest)
        if (const double overlap = overlap_beyond(limit, elasticity, pair, obstacle, slave);
            overlap > 0)
          limit = limit_for(overlap, pair);
      ContactSurface<dim> surface;
      surface.faces = surface.own_faces = slave.faces.size();
      surface.separates                 = pair.separates;
      surface.reach                     = at_rest && pair.search_distance > 0 ? limit : reach;
      // Not the reach: boxes of overlapping bodies may be as far apart as the overlap is deep.
      if (at_rest && is_apart(elasticity, pair, obstacle, slave, limit))
        {
          surface.is_apart = true;
          return surface;
        }
      if (obstacle)
        check_obstacle(configuration, pair, *obstacle, slave);
      const bool is_laid = Utilities::MPI::max(laid.size(), comm) > 0;
      const auto master  = [&] {
        return master_faces(elasticity,
                            BoundaryFaces<dim>(configuration, pair.master),
                            method.predictor() == Predictor::normal_stress,
                            !at_rest);
      };
      auto paired =
        obstacle ?
          obstacle_points(configuration, slave.patches, *obstacle, integration, limit) :
        is_laid ?
          pair_laid_points(slave.patches, laid, master(), limit, comm, surface.statistics) :
          pair_points(slave.patches, master(), integration, limit, comm, surface.statistics);
      drop_empty_points(slave.patches, paired);
      std::vector<double> gaps;
      if (!at_rest)
        {
          if (!is_laid || obstacle)
            weigh_at_rest(slave, paired);
          surface.laid = laid;
          if (!is_laid)
            for (const PairedPoint<dim> &point : paired)
              surface.laid.push_back({point.face,
                                      point.xi,
                                      point.weight,
                                      {point.partner.face_center, point.partner.size}});
          if (needs_gaps_at_rest(pair))
            gaps = gaps_at_rest(elasticity, pair, obstacle, slave, limit, paired);
        }
      surface.points =
        contact_points(configuration, pair, method, slave, integration, paired, gaps);
      check_gaps(pair, surface.points, comm);
      const unsigned int n_paired = Utilities::MPI::sum(paired.size(), comm);
      surface.overlap             = deepest_overlap(surface.points, comm);
      surface.reach               = std::max(surface.reach, 2 * surface.overlap);
      if (!pair.separates)
        keep_touching(pair, slave, paired, surface.points);
      else if (surface.reach < limit)
        keep_candidates(surface.reach, slave, paired, surface.points);
      if (!at_rest)
        set_drift(configuration.displacement(), slave, paired, obstacle != nullptr, surface.points);
      surface.largest_angle = largest_angle(slave, paired, comm);
      surface.sees_nothing  = n_paired == 0;
      compare(elasticity, slave, paired, obstacle != nullptr, comm, surface);
      surface.is_apart        = Utilities::MPI::sum(surface.points.size(), comm) == 0;
      const auto n_prescribed = set_pressure_functions(
        elasticity, method, integration.basis, slave, paired, surface.points);
      const bool some_prescribed = Utilities::MPI::max(n_prescribed, comm) > 0,
                 some_free = Utilities::MPI::max(has_shapes(surface.points) ? 1 : 0, comm) > 0;
      if (some_prescribed && (!obstacle || !some_free))
        throw SceneError(
          pair.slave_place + ": the displacement of faces of '" + pair.slave +
          "' is prescribed along the normal at all their nodes, so that they cannot carry an "
          "unknown pressure; exchange Slave and Master, or take Contact method/Method = penalty");
      surface.whole       = whole_faces(elasticity, slave);
      surface.slave_faces = slave_faces(elasticity, slave, surface.points);
      return surface;
    }

    /// Adds the points of the master as slave.
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
      surface.whole.insert(surface.whole.end(), other.whole.begin(), other.whole.end());
      for (ContactPoint<dim> &point : surface.points)
        point.weight /= 2;
      for (auto &entry : surface.whole)
        entry.second /= 2;
      surface.slave_faces.resize(surface.faces);
      surface.slave_faces.insert(surface.slave_faces.end(),
                                 other.slave_faces.begin(),
                                 other.slave_faces.end());
      surface.faces += other.faces;
      surface.is_apart = surface.is_apart && other.is_apart;
    }
  } // namespace



  template <int dim>
  double
  covered_share(const ContactSurface<dim> &surface, const MPI_Comm comm)
  {
    double covered = 0, whole = 0;
    for (const auto &point : surface.points)
      covered += point.weight;
    for (const auto &[shape, weight] : surface.whole)
      whole += weight;
    whole = Utilities::MPI::sum(whole, comm);
    return whole > 0 ? Utilities::MPI::sum(covered, comm) / whole : 0.;
  }



  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Configuration<dim>  &configuration,
                       const ContactPair<dim>    &pair,
                       const Obstacle<dim>       *obstacle,
                       const ContactMethod       &method,
                       const Integration         &integration,
                       const double               reach,
                       const double               limit,
                       const ContactSurface<dim> *former)
  {
    const std::vector<LaidPoint<dim>> none;
    ContactSurface<dim>               surface = one_sided(configuration,
                                            pair,
                                            obstacle,
                                            method,
                                            integration,
                                            reach,
                                            limit,
                                            former ? former->laid : none);
    if (method.unbiased() && !obstacle)
      {
        ContactPair<dim> other = pair;
        std::swap(other.slave, other.master);
        auto of_master         = one_sided<dim>(configuration,
                                        other,
                                        nullptr,
                                        method,
                                        integration,
                                        reach,
                                        limit,
                                        former ? former->laid_on_master : none);
        surface.laid_on_master = of_master.laid;
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
                       const Integration      &integration,
                       const double            reach)
  {
    return make_contact_surface<dim>(
      Configuration<dim>(elasticity), pair, obstacle, method, integration, reach, 0, nullptr);
  }



#define INSTANTIATE(dim)                                                                           \
  template double              covered_share(const ContactSurface<dim> &, MPI_Comm);               \
  template ContactSurface<dim> make_contact_surface(const Configuration<dim> &,                    \
                                                    const ContactPair<dim> &,                      \
                                                    const Obstacle<dim> *,                         \
                                                    const ContactMethod &,                         \
                                                    const Integration &,                           \
                                                    double,                                        \
                                                    double,                                        \
                                                    const ContactSurface<dim> *);                  \
  template ContactSurface<dim> make_contact_surface(const Elasticity<dim> &,                       \
                                                    const ContactPair<dim> &,                      \
                                                    const Obstacle<dim> *,                         \
                                                    const ContactMethod &,                         \
                                                    const Integration &,                           \
                                                    double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
