// SPDX-License-Identifier: Apache-2.0
// A block is pressed onto wavy rigid ground whose shape is a class of this program. The largest
// pressure is compared with the closed form of Westergaard (J. Appl. Mech. 6 (1939) A49).
#include <signorini/driver/solve.h>

#include <cmath>
#include <iostream>

using namespace dealii;

constexpr double amplitude = 1e-3, k = 2 * numbers::PI; // of y = amplitude cos(k x)

class WavyGround : public Signorini::ObstacleShape<2>
{
public:
  void
  declare(Signorini::Section &) override
  {} // no keys: the shape is not read from a file

  Signorini::ObstaclePoint<2>
  closest(const Point<2> &x) const override
  {
    Tensor<1, 2> up;
    up[0] = amplitude * k * std::sin(k * x[0]);
    up[1] = 1;
    return {(x[1] - amplitude * std::cos(k * x[0])) / up.norm(), up / up.norm(), {}};
  }
};

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const double                     E = 1000, nu = 0.3, p_mean = 1;

  Signorini::Scene<2> scene =
    Signorini::scene_of<2>({"Bodies/Names=block",
                            "Bodies/block/Corners=-0.5,0 : 0.5,1.5",
                            "Bodies/block/Subdivisions=32,48",
                            "Bodies/block/Young's modulus=1000",
                            "Bodies/block/Poisson's ratio=0.3",
                            "Obstacles/Names=ground",
                            "Obstacles/ground/Shape=plane",
                            "Obstacles/ground/Normal=0,1",
                            "Supports/Names=sides",
                            "Supports/sides/Boundaries=block.left, block.right",
                            "Supports/sides/Type=symmetry",
                            "Loads/Names=weight",
                            "Loads/weight/Boundaries=block.top",
                            "Loads/weight/Pressure=1",
                            "Contact pairs/Names=foot",
                            "Contact pairs/foot/Slave=block.bottom",
                            "Contact pairs/foot/Master=ground",
                            "Mesh/Contact refinements=2",
                            "Mesh/Degree=2",
                            "Contact method/Contact geometry=reference"},
                           "wavy-ground");
  scene.obstacles[0].shape = std::make_shared<WavyGround>();

  double     largest = 0, force = 0; // of the last load step
  const auto read = [&](const Signorini::LoadStepResult<2> &result) {
    largest = force = 0;
    for (const Signorini::ContactValue<2> &point : result.contact)
      {
        largest = std::max(largest, point.pressure);
        force += point.pressure * point.area * point.normal[1];
      }
    largest = Utilities::MPI::max(largest, MPI_COMM_WORLD);
    force   = Utilities::MPI::sum(force, MPI_COMM_WORLD);
  };
  const int code = Signorini::solve<2>(scene, MPI_COMM_WORLD, std::cout, read);

  // All is closed beyond p_flat; below, contact is where |x| < a with sin^2(k a/2) = p_mean/p_flat.
  const double p_flat = k * amplitude * E / (1 - nu * nu) / 2,
               exact  = 2 * std::sqrt(p_mean * p_flat);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << "force " << force << ", largest pressure " << largest << ", by Westergaard "
              << exact << std::endl;
  return code != 0 || std::abs(force - p_mean) > 1e-6 || std::abs(largest - exact) > 0.01 * exact;
}
