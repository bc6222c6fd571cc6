#include <signorini/contact/surface.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /// E/h of a cell behind a face, h being the depth of the cell.
    template <int dim>
    double
    stiffness(const Elasticity<dim> &elasticity, const Cell<dim> &cell, const unsigned int face)
    {
      return elasticity.material(cell->material_id()).youngs_modulus * cell->face(face)->measure() /
             cell->measure();
    }

    template <int dim>
    using Faces = std::vector<std::pair<Cell<dim>, unsigned int>>;

    template <int dim>
    Faces<dim>
    owned_faces(const Elasticity<dim> &elasticity, const std::string &boundary)
    {
      Faces<dim> faces;
      const auto id = elasticity.mesh().boundary_id(boundary);
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == id)
              faces.emplace_back(cell, f);
      return faces;
    }

    template <int dim>
    std::vector<FacePatch<dim>>
    patches(const Elasticity<dim> &elasticity, const Faces<dim> &faces)
    {
      std::vector<FacePatch<dim>> result;
      for (const auto &[cell, face] : faces)
        result.emplace_back(elasticity.mesh().mapping(),
                            elasticity.mesh().geometry_degree(),
                            cell,
                            face);
      return result;
    }

    template <int dim>
    MasterFaces<dim>
    master_faces(const Elasticity<dim> &elasticity, const Faces<dim> &faces)
    {
      MasterFaces<dim> master;
      master.patches = patches(elasticity, faces);
      master.complete =
        [&elasticity, faces, trace = Trace<dim>(elasticity)](const unsigned int    i,
                                                             const Point<dim - 1> &xi,
                                                             Partner<dim> &partner) mutable {
          const auto &[cell, face] = faces[i];
          trace.reinit(cell);
          partner.row       = trace.normal_displacement(unit_point<dim>(face, xi), partner.normal);
          partner.stiffness = stiffness(elasticity, cell, face);
        };
      return master;
    }

    template <int dim>
    double
    initial_gap(const ContactPair<dim> &pair, const Point<dim> &x, const double from_geometry)
    {
      if (pair.initial_gap == "from geometry")
        return from_geometry;
      return pair.initial_gap == "closed" ? 0. : Expression<dim>(pair.initial_gap).value(x);
    }

    /// Partners on a rigid obstacle: no mesh, no search, no segments.
    template <int dim>
    std::vector<PairedPoint<dim>>
    obstacle_points(const std::vector<FacePatch<dim>> &slave,
                    const Obstacle<dim>               &obstacle,
                    const Integration                 &integration,
                    const double                       reach)
    {
      const Quadrature<dim - 1>     rule = face_rule<dim>(integration);
      std::vector<PairedPoint<dim>> points;
      for (unsigned int i = 0; i < slave.size(); ++i)
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const Point<dim - 1>    &xi    = rule.point(q);
            const Point<dim>         x     = slave[i].position(xi);
            const ObstaclePlace<dim> place = obstacle.shape->closest(x);
            if (std::abs(place.gap) > reach || !faces_each_other(slave[i].normal(xi), place.normal))
              continue;
            PairedPoint<dim> point{i, xi, rule.weight(q) * slave[i].jacobian(xi), {}};
            point.partner.position  = x - place.gap * place.normal;
            point.partner.normal    = place.normal;
            point.partner.distance  = std::abs(place.gap);
            point.partner.stiffness = std::numeric_limits<double>::infinity();
            points.push_back(std::move(point));
          }
      return points;
    }

    template <int dim>
    double
    largest_diameter(const std::vector<FacePatch<dim>> &faces, const MPI_Comm comm)
    {
      double largest = 0;
      for (const FacePatch<dim> &face : faces)
        largest = std::max(largest, face.diameter());
      return Utilities::MPI::max(largest, comm);
    }

    /// Faces take part as a whole or not at all: a shape function on a part of a face would be a
    /// weight that changes its sign.
    template <int dim>
    void
    drop_far_faces(const double limit, std::vector<PairedPoint<dim>> &points)
    {
      std::map<unsigned int, double> nearest;
      for (const auto &point : points)
        {
          const auto [at, is_new] = nearest.emplace(point.face, point.partner.distance);
          at->second              = std::min(at->second, point.partner.distance);
        }
      points.erase(std::remove_if(points.begin(),
                                  points.end(),
                                  [&](const auto &point) { return nearest[point.face] > limit; }),
                   points.end());
    }

    template <int dim>
    ContactPoint<dim>
    contact_point(const ContactPair<dim> &pair,
                  const FacePatch<dim>   &patch,
                  const PairedPoint<dim> &paired,
                  const Point<dim>       &unit_point,
                  const double            stiffness,
                  const Trace<dim>       &trace)
    {
      const Partner<dim> &partner = paired.partner;
      ContactPoint<dim>   point;
      point.position = patch.position(paired.xi);
      point.normal   = partner.normal;
      point.weight   = paired.weight;
      point.gap =
        initial_gap(pair, point.position, (point.position - partner.position) * partner.normal);
      point.stiffness = 1 / (1 / stiffness + 1 / partner.stiffness);
      point.row       = trace.normal_displacement(unit_point, partner.normal);
      for (const auto &[index, value] : partner.row)
        point.row.emplace_back(index, -value);
      unite(point.row);
      point.shape = trace.shape(unit_point);
      point.face  = paired.face;
      return point;
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
    return Utilities::MPI::sum(covered, comm) / Utilities::MPI::sum(whole, comm);
  }



  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Elasticity<dim>  &elasticity,
                       const ContactPair<dim> &pair,
                       const Obstacle<dim>    *obstacle,
                       const Integration      &integration)
  {
    const MPI_Comm      comm = elasticity.mesh().communicator();
    ContactSurface<dim> surface;
    const Faces<dim>    faces = owned_faces(elasticity, pair.slave);
    const auto          slave = patches(elasticity, faces);
    const double        limit =
      pair.search_distance > 0 ? pair.search_distance : elasticity.mesh().size() / 10;
    // Distances change by no more than its diameter on a face: this reach finds all points of each
    // face that has one within the limit.
    const double reach  = limit + largest_diameter(slave, comm);
    auto         points = obstacle ?
                            obstacle_points(slave, *obstacle, integration, reach) :
                            pair_points(slave,
                                master_faces(elasticity, owned_faces(elasticity, pair.master)),
                                integration,
                                reach,
                                comm,
                                surface.statistics);
    drop_far_faces(limit, points);
    std::stable_sort(points.begin(), points.end(), [](const auto &a, const auto &b) {
      return a.face < b.face;
    });

    Trace<dim> trace(elasticity);
    surface.faces = faces.size();
    for (const PairedPoint<dim> &point : points)
      {
        const auto &[cell, face] = faces[point.face];
        trace.reinit(cell);
        surface.points.push_back(contact_point(pair,
                                               slave[point.face],
                                               point,
                                               unit_point<dim>(face, point.xi),
                                               stiffness(elasticity, cell, face),
                                               trace));
      }
    const QGauss<dim - 1> rule(elasticity.finite_element().degree + 1);
    for (unsigned int i = 0; i < faces.size(); ++i)
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const Point<dim - 1> &xi = rule.point(q);
          trace.reinit(faces[i].first);
          surface.whole.emplace_back(trace.shape(unit_point<dim>(faces[i].second, xi)),
                                     rule.weight(q) * slave[i].jacobian(xi));
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
                       const Integration &);
  template ContactSurface<3>
  make_contact_surface(const Elasticity<3> &,
                       const ContactPair<3> &,
                       const Obstacle<3> *,
                       const Integration &);
} // namespace Signorini
