// SPDX-License-Identifier: Apache-2.0
// The rows of contact points against how gaps change when bodies move; nodes held by supports.

#include "contact/search/face_patches.h"
#include "linear_algebra/columns.h"
#include "solid/cell_nodes.h"

#include <doctest/doctest.h>

#include <cmath>

#include "contact_cases.h"

using namespace TestScene;

namespace
{
  template <int dim>
  Tensor<1, dim>
  cross(const Values &w, const Tensor<1, dim> &r)
  {
    if constexpr (dim == 2)
      return Tensor<1, 2>({-w[0] * r[1], w[0] * r[0]});
    else
      return cross_product_3d(Tensor<1, 3>({w[0], w[1], w[2]}), r);
  }

  /// An affine displacement without any symmetry, of a body.
  /// @param slope 0: a translation
  template <int dim>
  Tensor<1, dim>
  affine(const Point<dim> &x, const unsigned int body, const double slope = 1)
  {
    Tensor<1, dim> u;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = 0.2 * d + (0.3 + d) * body +
             slope * (-0.5 * x[(d + 1) % dim] + (0.1 + 0.2 * body) * (d + 1) * x[d]);
    return u;
  }

  /// All degrees of freedom of the mesh under affine().
  template <int dim>
  Values
  affine_motion(const SmallScene<dim> &scene, const double slope = 1)
  {
    Values                               u(scene.elasticity->owned().size(), 0.);
    CellNodes<dim>                       nodes_of(*scene.mesh, scene.elasticity->finite_elements());
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : scene.elasticity->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          const auto &nodes = nodes_of(cell);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (scene.elasticity->owned().is_element(indices[i]))
              u[indices[i]] = affine(nodes[i],
                                     cell->material_id(),
                                     slope)[cell->get_fe().system_to_component_index(i).first];
        }
    Utilities::MPI::sum(u, MPI_COMM_WORLD, u);
    return u;
  }

  double
  at(const SparseRow &row, const Values &u)
  {
    double sum = 0;
    for (const auto &[index, value] : row)
      sum += value * u[index];
    return sum;
  }

  /// Obstacles of a block [-1,1]^dim whose top lies at zero, or [0.2,1]^dim for those whose gap has
  /// a kink.
  template <int dim>
  std::vector<Lines>
  shapes()
  {
    const std::string zero = dim == 2 ? "" : "0,", up = dim == 2 ? "0,1" : "0,0,1",
                      down    = dim == 2 ? "0,-1" : "0,0,-1";
    std::vector<Lines> result = {
      {"Shape=plane", "Point=" + zero + "0.1,0.2", "Normal=" + zero + "0.3,-1"},
      {"Shape=sphere", "Center=" + zero + "0.1,2.1", "Radius=2"},
      {"Shape=sphere", "Center=" + zero + "0.1,-3", "Radius=3.2", "Hollow=yes"},
      {"Shape=cylinder", "Center=" + zero + "0.1,2.1", "Radius=2"},
      {"Shape=cone", "Apex=" + zero + "-1.5,-0.1", "Normal=" + down, "Angle=10"},
      {"Shape=punch",
       "Center=" + zero + "-1.9,0.1",
       "Normal=" + down,
       "Radius=0.2",
       "Edge radius=8"}};
    if (dim == 3)
      result[3].push_back("Axis=1,0.2,0.1");
    return result;
  }

  template <int dim>
  Lines
  block_and(const Lines &obstacle)
  {
    const bool plane = dim == 2;
    Lines      lines = {"Dimension=" + std::to_string(dim),
                        "Bodies/Names=block",
                   plane ? "Bodies/block/Corners=-1,-1 : 1,0" :
                                "Bodies/block/Corners=-1,-1,-1 : 1,1,0",
                   plane ? "Bodies/block/Subdivisions=3,1" : "Bodies/block/Subdivisions=3,2,1",
                        "Bodies/block/Young's modulus=10",
                        "Bodies/block/Poisson's ratio=0.3",
                        "Obstacles/Names=tool",
                   plane ? "Obstacles/tool/Reference point=0.3,0.4" :
                                "Obstacles/tool/Reference point=0.3,-0.2,0.4",
                   plane ? "Obstacles/tool/Displacement=free; free" :
                                "Obstacles/tool/Displacement=free; free; free",
                   plane ? "Obstacles/tool/Rotation=free" :
                                "Obstacles/tool/Rotation=free; free; free",
                        "Contact pairs/pair/Search distance=2"};
    for (const std::string &key : obstacle)
      lines.push_back("Obstacles/tool/" + key);
    return lines + pair("block.top", "tool") + fixed("block.bottom", plane ? "0; t" : "0; 0; t");
  }

  template <int dim>
  void
  check_shape(const Lines &obstacle)
  {
    const std::string name = join(obstacle);
    CAPTURE(name);
    SmallScene<dim> scene(block_and<dim>(obstacle));
    scene.use({"Method=penalty", "penalty/Factor=1", "penalty/Weighting=pointwise"});
    const RigidBody<dim> &body = scene.elasticity->rigid_bodies()[0];

    // A translation, and a rotation that counts as the length by which it moves what is one lever
    // away.
    const Values   turn = {0.4, -0.3, 0.2};
    Tensor<1, dim> shift;
    Values         u = affine_motion(scene);
    for (unsigned int d = 0; d < dim; ++d)
      u[scene.elasticity->first_dof(0) + d] = shift[d] = 0.3 - 0.2 * d;
    for (unsigned int i = 0; i < RigidBody<dim>::n_rotations; ++i)
      u[scene.elasticity->first_dof(0) + dim + i] =
        turn[i] * scene.elasticity->rotation_length_scale();

    const auto &points = scene.contact->surfaces()[0].points;
    CHECK(Utilities::MPI::sum(points.size(), MPI_COMM_WORLD) >= (dim == 2 ? 6u : 20u));
    for (const ContactPoint<dim> &point : points)
      {
        const Point<dim>    &x     = point.position;
        const auto           shape = scene.scene.obstacles[0].shape;
        const Tensor<1, dim> speed = affine(x, 0) - shift - cross<dim>(turn, x - body.reference);
        // Outside of the obstacle, and its normal towards the block.
        CHECK(point.gap == doctest::Approx(shape->closest(x).gap));
        CHECK(point.normal[dim - 1] < 0);
        // Central differences; third derivatives of these gaps are of the order of one.
        constexpr double a = 1e-4;
        const double     difference =
          (shape->closest(x + a * speed).gap - shape->closest(x - a * speed).gap) / (2 * a);
        CHECK(std::abs(at(point.row(), u) - difference) < 10 * a * a);
      }

    // Forces and moments do the work of the motion that they drive.
    RigidBody<dim> driven = body;
    driven.force          = VectorExpression<dim>(dim == 2 ? "2; 3*t" : "2; 3*t; 5");
    driven.moment =
      VectorExpression<dim, RigidBody<dim>::n_rotations>(dim == 2 ? "7*t" : "7*t; 11; 13");
    const double rotation_length_scale = scene.elasticity->rotation_length_scale();
    double       work = 0, expected = 2 * shift[0] + 6 * shift[1] + 14 * turn[0];
    if (dim == 3)
      expected += 5 * shift[dim - 1] + 11 * turn[1] + 13 * turn[2];
    for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
      work += driven.load(i, 2, rotation_length_scale) * u[scene.elasticity->first_dof(0) + i];
    CHECK(work == doctest::Approx(expected).epsilon(1e-14));
  }
} // namespace



TEST_CASE("gaps to rigid obstacles change as rows say, for all motions of both")
{
  for (const Lines &shape : shapes<2>())
    check_shape<2>(shape);
  for (const Lines &shape : shapes<3>())
    check_shape<3>(shape);
}



namespace
{
  /// @param largest distance of the surfaces
  /// @param slope of displacements: 0 where faces have kinks between them, on which projections lie
  /// beside the normal
  template <int dim>
  void
  check_pair(const Case &which, const double largest, const double slope)
  {
    CAPTURE(which.name);
    SmallScene<dim> scene(which.lines + Lines{"Dimension=" + std::to_string(dim), "Mesh/Degree=2"});
    const Values    u = affine_motion(scene, slope);
    for (const std::string integration : {"segments", "quadrature"})
      {
        CAPTURE(integration);
        scene.use({"Method=penalty", "Integration=" + integration});
        const std::string  slave = scene.decisions.pairs[0].slave;
        const unsigned int slave_body =
          slave.substr(0, slave.find('.')) == scene.mesh->body_name(0) ? 0 : 1;
        CHECK(Utilities::MPI::sum(scene.contact->surfaces()[0].points.size(), MPI_COMM_WORLD) > 0);
        for (const ContactPoint<dim> &point : scene.contact->surfaces()[0].points)
          {
            const Point<dim>     master_point = point.position - point.gap * point.normal;
            const Tensor<1, dim> opening      = affine(point.position, slave_body, slope) -
                                           affine(master_point, 1 - slave_body, slope);
            CHECK(std::abs(point.gap) < largest);
            CHECK(std::abs(at(point.row(), u) - opening * point.normal) < 1e-10);
            // E/h of both in series: larger than neither.
            CHECK(point.stiffness > 0);
          }
      }
  }

  Case
  from_geometry(Case which)
  {
    which.lines.push_back("Contact pairs/pair/Initial gap=from geometry");
    return which;
  }
} // namespace

TEST_CASE("gaps between bodies change as rows say")
{
  for (const unsigned int i : {0, 2, 3})
    {
      check_pair<2>(from_geometry(cases_2d()[i]), 1e-12, 1);
      check_pair<3>(from_geometry(cases_3d()[i]), 1e-12, 1);
    }
  // Clearance 0.001, and chords of faces that are no circles.
  check_pair<2>(from_geometry(cases_2d()[1]), 0.01, 0);
  check_pair<3>(from_geometry(cases_3d()[1]), 0.02, 0);
}



namespace
{
  template <int dim>
  void
  check_constrained_node(const SmallScene<dim> &scene, const double t)
  {
    scene.elasticity->set_time(t);
    LA::Vector u = scene.rough_field(1, 0.6);
    scene.elasticity->distribute(u);
    const Values all = everywhere(u);
    unsigned int n   = 0;
    for (const auto &[first, node] : scene.elasticity->constrained_nodes())
      {
        // Others may lie on faces that this rank does not see.
        if (!scene.elasticity->owned().is_element(first))
          continue;
        Tensor<1, dim> at_node;
        for (unsigned int d = 0; d < dim; ++d)
          at_node[d] = all[node.dofs[d]];
        for (const DirectionConstraint<dim> &constraint_at_node : node.prescribed_directions)
          {
            ++n;
            const double wanted =
              constraint_at_node.support->type == SupportType::displacement ?
                constraint_at_node.support->displacement.value(node.position, t) *
                  constraint_at_node.direction :
                constraint_at_node.support->normal_displacement.value(node.position, t);
            CHECK(std::abs(at_node * constraint_at_node.direction - wanted) < 1e-13);
            CHECK(constraint_at_node.direction.norm() == doctest::Approx(1));
            CHECK(std::abs(node.free_part(constraint_at_node.direction).norm()) < 1e-6);
          }
      }
    CHECK(Utilities::MPI::sum(n, MPI_COMM_WORLD) > 0);
  }
} // namespace

TEST_CASE("nodes on supports of any direction move as these say")
{
  for (const unsigned int i : {0, 3})
    {
      check_constrained_node(SmallScene<2>(cases_2d()[i].lines), 3);
      check_constrained_node(SmallScene<3>(cases_3d()[i].lines + Lines{"Dimension=3"}), 3);
    }
  // A roller on a circle: outward by 0.1 t (1 + x).
  const SmallScene<2> ring({"Bodies/Names=ring",
                            "Bodies/ring/Mesh=ring",
                            "Bodies/ring/Inner radius=1",
                            "Bodies/ring/Outer radius=2",
                            "Bodies/ring/Young's modulus=1",
                            "Bodies/ring/Poisson's ratio=0.3",
                            "Supports/Names=rim",
                            "Supports/rim/Type=roller",
                            "Supports/rim/Boundaries=ring.outer",
                            "Supports/rim/Normal displacement=0.1*t*(1+x)"});
  check_constrained_node(ring, 2);
  for (const auto &[first, node] : ring.elasticity->constrained_nodes())
    if (ring.elasticity->owned().is_element(first))
      CHECK(node.prescribed_directions[0].direction * node.position ==
            doctest::Approx(2).epsilon(1e-3));
}



TEST_CASE("values at the columns of contact rows are added to those of their owners")
{
  SmallScene<2> scene(cases_2d()[0].lines);
  scene.use({"Method=penalty"});
  const LA::SparseMatrix  &B = scene.gap_operator().B_free;
  const LA::ColumnExchange columns(B);
  LA::Vector               v = scene.elasticity->zero_vector();
  v                          = 2.;
  const double before        = v.l1_norm();
  columns.add(std::vector<double>(columns.size(), 1.).data(), v);
  const unsigned int n = Utilities::MPI::sum(columns.size(), MPI_COMM_WORLD);
  REQUIRE(n > 0);
  CHECK(v.l1_norm() == doctest::Approx(before + n));
}

namespace
{
  /// Faces by their vertices, or by the mapping where they are curved, against the mapping alone.
  template <int dim>
  unsigned int
  check_face_patches(const SmallScene<dim> &scene)
  {
    const Mesh<dim> &mesh = *scene.mesh;
    FacePatches<dim> patch_of(mesh);
    unsigned int     n_curved = 0;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              const FacePatch<dim> patch = patch_of(cell, f),
                                   exact(mesh.surface_mapping(), mesh.surface_degree(), cell, f);
              n_curved += exact.get_degree() > 1;
              for (const Point<dim - 1> &xi : face_lattice<dim>(patch.reference_cell(), 2))
                {
                  // As far as lower degrees reproduce the face.
                  CHECK(patch.position(xi).distance(exact.position(xi)) < 3e-6 * exact.diameter());
                  CHECK((patch.normal(xi) - exact.normal(xi)).norm() < 1e-4);
                }
            }
    return Utilities::MPI::sum(n_curved, MPI_COMM_WORLD);
  }
} // namespace

TEST_CASE("faces of a mesh are those of its mapping, and their normals point outward")
{
  unsigned int n_curved = 0;
  for (const Case &one : cases_2d())
    n_curved += check_face_patches(SmallScene<2>(one.lines));
  CHECK(n_curved > 0);
  n_curved = 0;
  for (const Case &one : cases_3d())
    n_curved += check_face_patches(SmallScene<3>(one.lines + Lines{"Dimension=3"}));
  CHECK(n_curved > 0);
}
