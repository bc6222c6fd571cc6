#include <signorini/contact/discretisation/obstacle_points.h>
#include <signorini/contact/discretisation/trace.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Number of the obstacle among the bodies with degrees of freedom; one more if it is at rest.
    template <int dim>
    unsigned int
    rigid_body(const Elasticity<dim> &elasticity, const Obstacle<dim> &obstacle)
    {
      const auto &bodies = elasticity.rigid_bodies();
      return std::find_if(bodies.begin(),
                          bodies.end(),
                          [&](const auto &body) { return body.name == obstacle.name; }) -
             bodies.begin();
    }

    /// n . u of an obstacle.
    template <int dim>
    SparseRow
    rigid_row(const Elasticity<dim>  &elasticity,
              const unsigned int      body,
              const MasterPlace<dim> &place)
    {
      SparseRow row;
      if (body == elasticity.rigid_bodies().size())
        return row;
      const auto values = elasticity.rigid_bodies()[body].normal_displacement(place.position,
                                                                              place.normal,
                                                                              elasticity.lever());
      for (unsigned int i = 0; i < values.size(); ++i)
        if (values[i] != 0)
          row.emplace_back(elasticity.first_dof(body) + i, values[i]);
      return row;
    }
  } // namespace



  template <int dim>
  std::vector<PairedPoint<dim>>
  obstacle_points(const Elasticity<dim>             &elasticity,
                  const std::vector<FacePatch<dim>> &slave,
                  const Obstacle<dim>               &obstacle,
                  const Integration                 &integration,
                  const double                       limit)
  {
    const unsigned int            body = rigid_body(elasticity, obstacle);
    const Quadrature<dim - 1>     rule = face_rule<dim>(integration);
    std::vector<PairedPoint<dim>> points;
    for (unsigned int i = 0; i < slave.size(); ++i)
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const Point<dim - 1>    &xi    = rule.point(q);
          const Point<dim>         x     = slave[i].position(xi);
          const ObstaclePlace<dim> place = obstacle.shape->closest(x);
          if (std::abs(place.gap) > reach(slave[i], limit) ||
              !faces_each_other(slave[i].normal(xi), place.normal))
            continue;
          PairedPoint<dim> point{i, xi, rule.weight(q) * slave[i].jacobian(xi), {}};
          point.partner.position  = x - place.gap * place.normal;
          point.partner.normal    = place.normal;
          point.partner.distance  = std::abs(place.gap);
          point.partner.stiffness = std::numeric_limits<double>::infinity();
          point.partner.bound     = std::numeric_limits<double>::infinity();
          point.partner.row       = rigid_row(elasticity, body, point.partner);
          points.push_back(std::move(point));
        }
    keep_near_faces(limit, points);
    return points;
  }



  template std::vector<PairedPoint<2>>
  obstacle_points(const Elasticity<2> &,
                  const std::vector<FacePatch<2>> &,
                  const Obstacle<2> &,
                  const Integration &,
                  double);
  template std::vector<PairedPoint<3>>
  obstacle_points(const Elasticity<3> &,
                  const std::vector<FacePatch<3>> &,
                  const Obstacle<3> &,
                  const Integration &,
                  double);
} // namespace Signorini
