#include <signorini/body_setup.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  std::unique_ptr<Mesh<dim>>
  make_mesh(const Scene<dim> &scene, const MPI_Comm comm)
  {
    std::vector<std::pair<std::string, BodyMesh<dim>>> bodies;
    for (const Body<dim> &body : scene.bodies)
      {
        bodies.emplace_back(body.name, body.mesh);
        bodies.back().second.degree = scene.degrees()[bodies.size() - 1];
      }
    std::vector<std::pair<std::string, std::string>> contact_surfaces;
    for (const ContactPair<dim> &pair : scene.known_pairs())
      contact_surfaces.emplace_back(pair.slave, scene.obstacle_of(pair) ? "" : pair.master);
    MeshSettings<dim> settings = scene.mesh;
    if (!settings.distribution && scene.most_cycles() > 0)
      settings.distribution = Distribution::p4est;
    return std::make_unique<Mesh<dim>>(bodies, settings, contact_surfaces, comm);
  }



  template <int dim>
  std::unique_ptr<Elasticity<dim>>
  make_elasticity(const Scene<dim> &scene, const Mesh<dim> &mesh)
  {
    std::vector<Material>              materials;
    std::vector<ThermalExpansion<dim>> expansions;
    for (const Body<dim> &body : scene.bodies)
      {
        for (const Material *material : body.materials())
          materials.push_back(*material);
        expansions.push_back(body.expansion);
        for (const MaterialOfCells &one : body.others)
          {
            expansions.push_back(body.expansion);
            if (!one.expansion.empty())
              expansions.back().coefficients = one.expansion;
          }
      }
    std::vector<RigidBody<dim>> rigid_bodies;
    for (const Obstacle<dim> &obstacle : scene.obstacles)
      if (obstacle.body.can_move())
        rigid_bodies.push_back(obstacle.body);
    return std::make_unique<Elasticity<dim>>(mesh,
                                             materials,
                                             scene.supports,
                                             scene.loads,
                                             scene.degrees(),
                                             model_of(scene.model),
                                             rigid_bodies,
                                             scene.newton.stabilisation,
                                             expansions);
  }



  template std::unique_ptr<Mesh<2>>
  make_mesh(const Scene<2> &, MPI_Comm);
  template std::unique_ptr<Mesh<3>>
  make_mesh(const Scene<3> &, MPI_Comm);
  template std::unique_ptr<Elasticity<2>>
  make_elasticity(const Scene<2> &, const Mesh<2> &);
  template std::unique_ptr<Elasticity<3>>
  make_elasticity(const Scene<3> &, const Mesh<3> &);
} // namespace Signorini
