// SPDX-License-Identifier: Apache-2.0
// The pressure that is reported for degree 2: exact where it is linear, of fourth order where it is
// smooth, whatever the mesh, the basis and the number of ranks; zero at open nodes.
#include "fields/recovered_pressure.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "small_scene.h"

using namespace Signorini;
using namespace TestScene;
using namespace dealii;

namespace
{
  template <int dim>
  Lines
  block_on_plane(const std::string &cells, const std::string &grading)
  {
    return {"Dimension=" + std::to_string(dim),
            "Mesh/Degree=2",
            "Bodies/Names=block",
            std::string("Bodies/block/Corners=") + (dim == 2 ? "0,0 : 2,1" : "0,0,0 : 2,1,1"),
            "Bodies/block/Subdivisions=" + cells,
            "Bodies/block/Grading=" + grading,
            "Bodies/block/Young's modulus=10",
            "Bodies/block/Poisson's ratio=0.3",
            "Obstacles/Names=ground",
            "Obstacles/ground/Shape=plane",
            "Supports/Names=top",
            "Supports/top/Boundaries=block.top",
            std::string("Supports/top/Displacement=") + (dim == 2 ? "0; -0.1" : "0; 0; -0.1"),
            "Contact pairs/Names=pair",
            "Contact pairs/pair/Slave=block.bottom",
            "Contact pairs/pair/Master=ground"};
  }

  /// The largest deviation at nodes of the pressure that is recovered from what a method with the
  /// dual basis makes of p: its means over the shape functions.
  template <int dim, typename F>
  double
  deviation(const std::string &cells, const std::string &grading, const F &p)
  {
    SmallScene<dim> scene(block_on_plane<dim>(cells, grading));
    scene.use({"Method=Lagrange multiplier", "Pressure basis=dual"});
    const GapOperator &contact = scene.gap_operator();
    const auto        &surface = scene.contact->surfaces()[0];

    LA::Vector value = scene.elasticity->zero_vector(), area = value;
    for (const auto &point : surface.points)
      for (const auto &[node, phi] : point.interpolation)
        {
          value(node) += point.weight * phi * p(point.position);
          area(node) += point.weight * phi;
        }
    for (LA::Vector *v : {&value, &area})
      v->compress(VectorOperation::add);
    ContactState   state    = open_contact(contact);
    LA::Vector    &pressure = state.traction[0], &active = state.status;
    const IndexSet rows = active.locally_owned_elements();
    auto           row  = rows.begin();
    for (const auto node : contact.origin.node)
      {
        pressure(*row) = value(node) / area(node);
        active(*row++) = 1;
      }
    for (LA::Vector *v : {&pressure, &active})
      v->compress(VectorOperation::insert);

    const LA::Vector          u = scene.elasticity->zero_vector(), gap = contact.zero();
    const std::vector<double> no_work;
    const Snapshot<dim>       snapshot{*scene.elasticity,
                                 scene.decisions.pairs,
                                 scene.contact->surfaces(),
                                 contact,
                                 u,
                                 gap,
                                 pressure,
                                 active,
                                 state,
                                 no_work,
                                 no_work,
                                 1.,
                                 1};
    const LA::Vector field   = scene.elasticity->with_ghosts(recovered_pressure(snapshot, 0));
    double           largest = 0;
    for (const auto &face : surface.slave_faces)
      for (unsigned int i = 0; i < face.nodes.size(); ++i)
        largest = std::max(largest, std::abs(field(face.nodes[i]) - p(face.positions[i])));
    return Utilities::MPI::max(largest, MPI_COMM_WORLD);
  }
} // namespace



TEST_CASE("recovered pressures are exact where they are linear")
{
  CHECK(deviation<2>("5,1", "1,1", [](const auto &x) { return 1 + 3 * x[0]; }) < 1e-5);
  CHECK(deviation<2>("6,1", "4,1", [](const auto &x) { return 1 + 3 * x[0]; }) < 1e-5);
  CHECK(deviation<3>("3,2,1", "2,1,1", [](const auto &x) { return 1 + 3 * x[0] - x[1]; }) < 1e-5);
}



TEST_CASE("recovered pressures are of fourth order, at rims of third")
{
  const auto wave  = [](const auto &x) { return 2 + std::sin(3 * x[0] + 0.3); };
  const auto waves = [](const auto &x) {
    return 2 + std::sin(3 * x[0] + 0.3) * std::cos(2 * x[1]);
  };
  const double coarse = deviation<2>("8,1", "1,1", wave), fine = deviation<2>("16,1", "1,1", wave);
  CHECK(fine < 5e-3);
  CHECK(std::log2(coarse / fine) > 2.6); // rims
  const double coarse_3d = deviation<3>("8,4,1", "1,1,1", waves),
               fine_3d   = deviation<3>("16,8,1", "1,1,1", waves);
  CHECK(std::log2(coarse_3d / fine_3d) > 1.7); // corners
}
