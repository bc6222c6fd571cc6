#include <signorini/contact/discretisation/normal_stress.h>
#include <signorini/contact/discretisation/obstacle_points.h>
#include <signorini/contact/discretisation/pressure_functions.h>
#include <signorini/contact/discretisation/surface.h>
#include <signorini/contact/geometry/boundary_faces.h>
#include <signorini/contact/geometry/deep_overlap.h>
#include <signorini/contact/geometry/lagrange.h>
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
    /// Bounds of the normal stress on faces, see NormalStress::bound(), each found when it is first
    /// asked for. Faces of one cell share its energy.
    template <int dim>
    class StressBounds
    {
    public:
      StressBounds(const BoundaryFaces<dim> &boundary)
        : faces(boundary.faces)
        , bounds(faces.size(), -1.)
      {}

      /// @param stress on the cell of face i
      double
      operator()(NormalStress<dim> &stress, const unsigned int i)
      {
        if (bounds[i] < 0)
          bounds[i] = stress.bound(faces[i].second) * faces_of_cell(i);
        return bounds[i];
      }

    private:
      // They are neighbours in the list.
      unsigned int
      faces_of_cell(const unsigned int i) const
      {
        unsigned int first = i, last = i + 1;
        while (first > 0 && faces[first - 1].first == faces[i].first)
          --first;
        while (last < faces.size() && faces[last].first == faces[i].first)
          ++last;
        return last - first;
      }

      const std::vector<std::pair<CellIterator<dim>, unsigned int>> faces;
      std::vector<double>                                           bounds;
    };

    template <int dim>
    MasterFaces<dim>
    master_faces(const Elasticity<dim>    &elasticity,
                 const BoundaryFaces<dim> &boundary,
                 const bool                with_stress)
    {
      MasterFaces<dim> master;
      master.patches = boundary.patches;
      std::vector<double> stiffnesses, moduli, sizes;
      for (unsigned int i = 0; i < boundary.faces.size(); ++i)
        {
          stiffnesses.push_back(boundary.stiffness(elasticity, i));
          moduli.push_back(boundary.modulus(elasticity, i));
          sizes.push_back(boundary.patches[i].diameter());
        }
      master.complete = [faces = boundary.faces,
                         stiffnesses,
                         moduli,
                         sizes,
                         with_stress,
                         trace  = Trace<dim>(elasticity),
                         stress = std::make_shared<NormalStress<dim>>(elasticity),
                         bound  = StressBounds<dim>(boundary)](const unsigned int    i,
                                                              const Point<dim - 1> &xi,
                                                              Partner<dim> &partner) mutable {
        const auto &[cell, face]    = faces[i];
        const Point<dim>      place = unit_point<dim>(face, xi);
        const Tensor<1, dim> &n     = partner.normal;
        trace.reinit(cell, face);
        partner.row       = trace.normal_displacement(place, n);
        partner.stiffness = stiffnesses[i];
        partner.modulus   = moduli[i];
        partner.size      = sizes[i];
        if (!with_stress)
          return;
        stress->reinit(cell);
        partner.stress         = stress->row(place, -n, n);
        partner.thermal_stress = stress->thermal_row(place, -n, n);
        partner.bound          = bound(*stress, i);
      };
      return master;
    }

    /// What a pair says of its gap at rest.
    template <int dim>
    class InitialGap
    {
    public:
      InitialGap(const ContactPair<dim> &pair)
        : is_given(pair.initial_gap.text != "from geometry")
        , formula(is_given && pair.initial_gap.text != "closed" ? pair.initial_gap : Formula("0"))
      {}

      double
      operator()(const Point<dim> &x, const double from_geometry) const
      {
        return is_given ? formula.value(x) : from_geometry;
      }

    private:
      const bool            is_given;
      const Expression<dim> formula;
    };

    /// Between x and its partner. What touches up to the rounding of the coordinates touches:
    /// otherwise that rounding were all that drives a body without loads.
    template <int dim>
    double
    distance(const Point<dim> &x, const Partner<dim> &partner)
    {
      const double gap      = (x - partner.position) * partner.normal;
      const double rounding = 4 * std::numeric_limits<double>::epsilon() * x.norm();
      return std::abs(gap) <= rounding ? 0. : gap;
    }

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
    ContactPoint<dim>
    contact_point(const InitialGap<dim>  &initial_gap,
                  const FacePatch<dim>   &patch,
                  const PairedPoint<dim> &paired,
                  const Point<dim>       &unit_point,
                  const double            stiffness,
                  const Trace<dim>       &trace)
    {
      const Partner<dim> &partner = paired.partner;
      ContactPoint<dim>   point;
      point.position  = patch.position(paired.xi);
      point.normal    = partner.normal;
      point.weight    = paired.weight;
      point.facing    = -(patch.normal(paired.xi) * partner.normal);
      point.gap       = initial_gap(point.position, distance(point.position, partner));
      point.stiffness = 1 / (1 / stiffness + 1 / partner.stiffness);
      point.row       = trace.normal_displacement(unit_point, partner.normal);
      for (const auto &[index, value] : partner.row)
        point.row.emplace_back(index, -value);
      unite(point.row);
      point.face = paired.face;
      point.xi   = paired.xi;
      return point;
    }

    /// The mean of both bodies' stresses whose bound is the smallest: they count by the inverse of
    /// their bounds, so that a stiff body does not matter beside a soft one, whichever is the slave
    /// (Annavarapu, Hautefeuille, Dolbow, Comput. Methods Appl. Mech. Engrg. 225-228 (2012) 44-54).
    template <int dim>
    void
    set_stress(const SparseRow    &own,
               const SparseRow    &own_thermal,
               const double        own_bound,
               const Partner<dim> &partner,
               const bool          own_alone,
               ContactPoint<dim>  &point)
    {
      const double share =
        own_alone || std::isinf(partner.bound) ? 1. : partner.bound / (own_bound + partner.bound);
      const auto mean = [share](const SparseRow &own, const SparseRow &other) {
        SparseRow row;
        for (const auto &[index, value] : own)
          row.emplace_back(index, share * value);
        if (share < 1)
          for (const auto &[index, value] : other)
            row.emplace_back(index, (1 - share) * value);
        unite(row);
        return row;
      };
      point.stress         = mean(own, partner.stress);
      point.thermal_stress = mean(own_thermal, partner.thermal_stress);
      point.bound          = share * own_bound;
    }

    /// Of the circle that a point stands for, or 1. That of a node is the mean over its shape
    /// function, of degree k: on the axis, too, it stands for an area.
    template <int dim>
    double
    circumference(const Elasticity<dim> &elasticity,
                  const FacePatch<dim>  &patch,
                  const Point<dim - 1>  &xi,
                  const Integration     &integration,
                  const unsigned int     k)
    {
      const Model model = elasticity.model();
      if (model != Model::axisymmetric || integration.rule != "nodes")
        return measure(model, patch.position(xi));
      const unsigned int    node = std::lround(xi[0] * k);
      const QGauss<dim - 1> rule(k + 2);
      double                sum = 0, area = 0;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const double share =
            rule.weight(q) * lagrange(k, rule.point(q)[0])[node][0] * patch.jacobian(rule.point(q));
          area += share;
          sum += share * measure(model, patch.position(rule.point(q)));
        }
      return sum / area;
    }

    /// The contact points of paired points, which are sorted by faces; all but the functions of the
    /// pressure.
    template <int dim>
    std::vector<ContactPoint<dim>>
    contact_points(const Elasticity<dim>               &elasticity,
                   const ContactPair<dim>              &pair,
                   const ContactMethod                 &method,
                   const BoundaryFaces<dim>            &slave,
                   const Integration                   &integration,
                   const std::vector<PairedPoint<dim>> &paired_points)
    {
      std::vector<ContactPoint<dim>> result;
      result.reserve(paired_points.size());
      double                face_depth = 0, face_stiffness = 0;
      Trace<dim>            trace(elasticity);
      NormalStress<dim>     stress(elasticity);
      StressBounds<dim>     bound(slave);
      const InitialGap<dim> initial_gap(pair);
      const bool            with_stress = method.predictor() == Predictor::normal_stress;
      for (const PairedPoint<dim> &paired : paired_points)
        {
          const auto &[cell, face] = slave.faces[paired.face];
          const auto      &patch   = slave.patches[paired.face];
          const Point<dim> place   = unit_point<dim>(face, paired.xi);
          const bool       is_new  = result.empty() || result.back().face != paired.face;
          if (is_new)
            {
              trace.reinit(cell, face);
              face_stiffness = slave.stiffness(elasticity, paired.face);
              face_depth     = slave.depth(paired.face);
            }
          result.push_back(contact_point(initial_gap, patch, paired, place, face_stiffness, trace));
          result.back().depth = face_depth;
          result.back().weight *=
            circumference(elasticity, patch, paired.xi, integration, cell->get_fe().degree);
          if (!with_stress)
            continue;
          if (is_new)
            stress.reinit(cell);
          const Tensor<1, dim> n = patch.normal(paired.xi);
          set_stress(stress.row(place, paired.partner.normal, n),
                     stress.thermal_row(place, paired.partner.normal, n),
                     bound(stress, paired.face),
                     paired.partner,
                     method.unbiased(),
                     result.back());
        }
      return result;
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
                face.positions.push_back(slave.patches[point.face].position(xi));
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
                                rule.weight(q) * slave.patches[i].jacobian(rule.point(q)) *
                                  measure(elasticity.model(),
                                          slave.patches[i].position(rule.point(q))));
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
        deepest = std::max(deepest, -point.gap);
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
        if (point.gap <= reach)
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

    /// With the pair's slave and master as they are.
    template <int dim>
    ContactSurface<dim>
    one_sided(const Elasticity<dim>  &elasticity,
              const ContactPair<dim> &pair,
              const Obstacle<dim>    *obstacle,
              const ContactMethod    &method,
              const Integration      &integration,
              const double            reach)
    {
      const MPI_Comm           comm = elasticity.mesh().communicator();
      const BoundaryFaces<dim> slave(elasticity, pair.slave);
      double                   limit = search_limit(elasticity, pair, reach);
      if (const double overlap = overlap_beyond(limit, elasticity, pair, obstacle, slave);
          overlap > 0)
        limit = limit_for(overlap, pair);
      ContactSurface<dim> surface;
      surface.faces     = slave.faces.size();
      surface.separates = pair.separates;
      surface.reach     = pair.search_distance > 0 ? limit : reach;
      // Not the reach: boxes of overlapping bodies may be as far apart as the overlap is deep.
      if (is_apart(elasticity, pair, obstacle, slave, limit))
        {
          surface.is_apart = true;
          return surface;
        }
      auto paired = obstacle ?
                      obstacle_points(elasticity, slave.patches, *obstacle, integration, limit) :
                      pair_points(slave.patches,
                                  master_faces(elasticity,
                                               BoundaryFaces<dim>(elasticity, pair.master),
                                               method.predictor() == Predictor::normal_stress),
                                  integration,
                                  limit,
                                  comm,
                                  surface.statistics);
      drop_empty_points(slave.patches, paired);
      surface.points = contact_points(elasticity, pair, method, slave, integration, paired);
      check_gaps(pair, surface.points, comm);
      const unsigned int n_paired = Utilities::MPI::sum(paired.size(), comm);
      surface.reach = std::max(surface.reach, 2 * deepest_overlap(surface.points, comm));
      if (!pair.separates)
        keep_touching(pair, slave, paired, surface.points);
      else if (surface.reach < limit)
        keep_candidates(surface.reach, slave, paired, surface.points);
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
  make_contact_surface(const Elasticity<dim>  &elasticity,
                       const ContactPair<dim> &pair,
                       const Obstacle<dim>    *obstacle,
                       const ContactMethod    &method,
                       const Integration      &integration,
                       const double            reach)
  {
    ContactSurface<dim> surface = one_sided(elasticity, pair, obstacle, method, integration, reach);
    if (method.unbiased() && !obstacle)
      {
        ContactPair<dim> other = pair;
        std::swap(other.slave, other.master);
        add_other_side(surface,
                       one_sided<dim>(elasticity, other, nullptr, method, integration, reach));
      }
    return surface;
  }



  template double
  covered_share(const ContactSurface<2> &, MPI_Comm);
  template double
  covered_share(const ContactSurface<3> &, MPI_Comm);
  template ContactSurface<2>
  make_contact_surface(const Elasticity<2> &,
                       const ContactPair<2> &,
                       const Obstacle<2> *,
                       const ContactMethod &,
                       const Integration &,
                       double);
  template ContactSurface<3>
  make_contact_surface(const Elasticity<3> &,
                       const ContactPair<3> &,
                       const Obstacle<3> *,
                       const ContactMethod &,
                       const Integration &,
                       double);
} // namespace Signorini
