// SPDX-License-Identifier: Apache-2.0
#include "driver/scene_setup.h"
#include <signorini/parameters/section.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Scene<dim>
  read_scene(RawSection &raw, const std::string &name, const std::string &folder)
  {
    Section    section(raw);
    Scene<dim> scene;
    scene.declare(section);
    section.close();
    scene.notes = section.notes();
    scene.given = raw;
    scene.name  = name;
    scene.read_files(folder);
    scene.check();
    return scene;
  }



  template <int dim>
  std::unique_ptr<Mesh<dim>>
  make_mesh(const Decisions<dim> &decisions, const MPI_Comm comm)
  {
    const Scene<dim>                                  &scene = decisions.scene;
    std::vector<std::pair<std::string, BodyMesh<dim>>> bodies;
    for (const Body<dim> &body : scene.bodies)
      {
        bodies.emplace_back(body.name, body.mesh);
        bodies.back().second.degree = decisions.degrees[bodies.size() - 1];
      }
    // Contact surfaces are weighted in the distribution of the mesh; obstacles have none.
    std::vector<std::pair<std::string, std::string>> contact_surfaces;
    for (const ContactPair<dim> &pair : decisions.pairs)
      contact_surfaces.emplace_back(pair.slave, scene.obstacle_of(pair) ? "" : pair.master);
    // Meshes that are to be refined are distributed by p4est.
    MeshSettings<dim> settings = scene.mesh;
    if (!settings.distribution && scene.maximum_cycles() > 0)
      settings.distribution = Distribution::p4est;
    return std::make_unique<Mesh<dim>>(bodies, settings, contact_surfaces, comm);
  }



  template <int dim>
  std::unique_ptr<Elasticity<dim>>
  make_elasticity(const Decisions<dim> &decisions, const Mesh<dim> &mesh)
  {
    const Scene<dim> &scene = decisions.scene;
    // One material, and one thermal expansion, for each material id: those of the body, then those
    // of its cell sets.
    std::vector<Material>              materials;
    std::vector<ThermalExpansion<dim>> expansions;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        for (const Material &material : decisions.materials(b))
          materials.push_back(material);
        for (const ThermalExpansion<dim> &expansion : decisions.expansions(b))
          expansions.push_back(expansion);
      }
    // Only obstacles that can move have degrees of freedom.
    std::vector<RigidBody<dim>> rigid_bodies;
    for (const Obstacle<dim> &obstacle : scene.obstacles)
      if (obstacle.body.can_move())
        rigid_bodies.push_back(obstacle.body);
    for (const ContactPair<dim> &pair : scene.named_pairs())
      if (pair.pretension.given())
        rigid_bodies.push_back(pair.pretension.body(pair.name));
    return std::make_unique<Elasticity<dim>>(mesh,
                                             materials,
                                             scene.supports,
                                             scene.loads,
                                             decisions.degrees,
                                             model_of(scene.model),
                                             rigid_bodies,
                                             scene.newton.stabilisation,
                                             expansions,
                                             scene.equations);
  }



  template Scene<2>
  read_scene(RawSection &, const std::string &, const std::string &);
  template Scene<3>
  read_scene(RawSection &, const std::string &, const std::string &);
  template std::unique_ptr<Mesh<2>>
  make_mesh(const Decisions<2> &, MPI_Comm);
  template std::unique_ptr<Mesh<3>>
  make_mesh(const Decisions<3> &, MPI_Comm);
  template std::unique_ptr<Elasticity<2>>
  make_elasticity(const Decisions<2> &, const Mesh<2> &);
  template std::unique_ptr<Elasticity<3>>
  make_elasticity(const Decisions<3> &, const Mesh<3> &);
} // namespace Signorini
