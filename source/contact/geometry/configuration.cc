#include <signorini/contact/geometry/configuration.h>
#include <signorini/elasticity/cell_nodes.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Configuration<dim>::Configuration(const Elasticity<dim> &elasticity)
    : my_elasticity(elasticity)
    , at_rest(true)
    , rigid_motion(elasticity.rigid_bodies().size() * RigidBody<dim>::n_dofs, 0.)
  {}



  template <int dim>
  Configuration<dim>::Configuration(const Elasticity<dim> &elasticity, const LA::Vector &u)
    : my_elasticity(elasticity)
    , at_rest(false)
    , u(u)
    , ghosted(elasticity.with_ghosts(u))
    , rigid_motion(elasticity.rigid_motion(u))
  {}



  template <int dim>
  const typename Configuration<dim>::ShapesAtNodes &
  Configuration<dim>::shapes_at_nodes(const unsigned int element,
                                      const unsigned int face,
                                      const unsigned int degree) const
  {
    ShapesAtNodes &result = shapes[{element, face, degree}];
    if (result.empty())
      {
        const FiniteElement<dim> &fe = my_elasticity.finite_elements()[element].base_element(0);
        for (const Point<dim - 1> &xi : face_lattice<dim>(degree))
          {
            result.emplace_back();
            for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
              if (const double value = fe.shape_value(i, unit_point<dim>(face, xi));
                  std::abs(value) > 1e-14)
                result.back().emplace_back(i, value);
          }
      }
    return result;
  }



  template <int dim>
  FacePatch<dim>
  Configuration<dim>::moved(const FacePatch<dim>    &rest,
                            const CellIterator<dim> &cell,
                            const unsigned int       face) const
  {
    if (at_rest)
      return rest;
    const FiniteElement<dim>            &fe = cell->get_fe();
    const unsigned int                   k  = std::max(rest.get_degree(), fe.degree);
    std::vector<types::global_dof_index> indices;
    read_indices<dim>(cell, indices);
    std::vector<Point<dim>> nodes;
    auto                    node = shapes_at_nodes(cell->active_fe_index(), face, k).begin();
    for (const Point<dim - 1> &xi : face_lattice<dim>(k))
      {
        nodes.push_back(rest.position(xi));
        for (const auto &[i, value] : *node)
          for (unsigned int d = 0; d < dim; ++d)
            nodes.back()[d] += value * ghosted(indices[fe.component_to_system_index(d, i)]);
        ++node;
      }
    return FacePatch<dim>(k, nodes, rest.get_outward());
  }



  template <int dim>
  RigidPose<dim>
  Configuration<dim>::pose(const Obstacle<dim> &obstacle) const
  {
    return pose(obstacle, rigid_motion);
  }



  template <int dim>
  RigidPose<dim>
  Configuration<dim>::pose(const Obstacle<dim>       &obstacle,
                           const std::vector<double> &rigid_motion) const
  {
    std::array<double, RigidBody<dim>::n_dofs> motion{};
    const auto                                &bodies = my_elasticity.rigid_bodies();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (bodies[b].name == obstacle.name)
        std::copy_n(rigid_motion.begin() + b * motion.size(), motion.size(), motion.begin());
    return {obstacle.body.reference, motion, my_elasticity.lever()};
  }



  template <int dim>
  ObstaclePlace<dim>
  Configuration<dim>::closest(const Obstacle<dim>  &obstacle,
                              const RigidPose<dim> &pose,
                              const Point<dim>     &x) const
  {
    if (at_rest)
      return obstacle.shape->closest(x);
    ObstaclePlace<dim> place =
      obstacle.shape->closest_point(pose.to_body(x), my_elasticity.lever());
    place.normal    = pose.to_space(place.normal);
    place.curvature = pose.to_space(place.curvature);
    return place;
  }



  template class Configuration<2>;
  template class Configuration<3>;
} // namespace Signorini
