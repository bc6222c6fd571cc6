// SPDX-License-Identifier: Apache-2.0
// Scenes with each of the things that a contact point may meet: curved faces that do not match,
// hanging nodes, inclined supports at the rim, rigid bodies with unconstrained rigid-body modes,
// the axis.
#pragma once

#include "small_scene.h"
#include "source_directory.h"

namespace TestScene
{
  struct Case
  {
    std::string name;
    Lines       lines;
  };

  inline Lines
  materials(const std::string &one, const std::string &other)
  {
    return {"Bodies/Names=" + one + "," + other,
            "Bodies/" + one + "/Young's modulus=10",
            "Bodies/" + one + "/Poisson's ratio=0.3",
            "Bodies/" + other + "/Young's modulus=20",
            "Bodies/" + other + "/Poisson's ratio=0.2"};
  }

  /// Slave on master.
  inline Lines
  pair(const std::string &slave, const std::string &master)
  {
    return {"Contact pairs/Names=pair",
            "Contact pairs/pair/Slave=" + slave,
            "Contact pairs/pair/Master=" + master};
  }

  inline Lines
  fixed(const std::string &boundaries, const std::string &displacement)
  {
    return {"Supports/Names=base",
            "Supports/base/Boundaries=" + boundaries,
            "Supports/base/Displacement=" + displacement};
  }

  /// Two boxes one on the other, with a gap that is negative here and positive there.
  inline Lines
  boxes(const std::string &lower,
        const std::string &lower_cells,
        const std::string &upper,
        const std::string &upper_cells)
  {
    return materials("lower", "upper") + pair("upper.bottom", "lower.top") +
           Lines{"Bodies/lower/Corners=" + lower,
                 "Bodies/lower/Subdivisions=" + lower_cells,
                 "Bodies/upper/Corners=" + upper,
                 "Bodies/upper/Subdivisions=" + upper_cells,
                 "Contact pairs/pair/Search distance=0.5",
                 "Contact pairs/pair/Initial gap=0.01*cos(5*x)"};
  }

  inline std::vector<Case>
  cases_2d()
  {
    const Lines base   = fixed("lower.bottom, upper.top", "0.001*t*x; -0.001*t");
    const Lines turned = {
      "Bodies/lower/Transformation=x*cos(0.5)-y*sin(0.5); x*sin(0.5)+y*cos(0.5)",
      "Bodies/upper/Transformation=x*cos(0.5)-y*sin(0.5); x*sin(0.5)+y*cos(0.5)"};
    return {{"flat, matching", boxes("0,0 : 1,1", "3,2", "0,1 : 1,2", "3,2") + base},
            {"curved, not matching",
             materials("pin", "eye") + pair("pin.outer", "eye.inner") +
               fixed("pin.inner, eye.outer", "0.001*t; -0.001*t") +
               Lines{"Dimension=2",
                     "Bodies/pin/Mesh=ring",
                     "Bodies/pin/Inner radius=0.5",
                     "Bodies/pin/Outer radius=1",
                     "Bodies/pin/Cells around=8",
                     "Bodies/pin/Cells through=1",
                     "Bodies/eye/Mesh=ring",
                     "Bodies/eye/Inner radius=1.001",
                     "Bodies/eye/Outer radius=2",
                     "Bodies/eye/Cells around=12",
                     "Bodies/eye/Cells through=1",
                     "Contact pairs/pair/Search distance=0.5",
                     "Contact pairs/pair/Initial gap=0.01*cos(3*x)"}},
            {"hanging nodes",
             boxes("0,0 : 1,1", "3,2", "0,1 : 1,2", "2,2") + base +
               Lines{"Mesh/Refinement regions/Names=near",
                     "Mesh/Refinement regions/near/Inside=min(0.4 - x, 0.3 - abs(y - 1))",
                     "Mesh/Refinement regions/near/Levels=2"}},
            {"inclined supports",
             boxes("0,0 : 1,1", "3,2", "0,1 : 1,2", "2,2") + turned +
               Lines{"Supports/Names=sides, press",
                     "Supports/sides/Type=symmetry",
                     "Supports/sides/Boundaries=lower.left, upper.left, lower.bottom",
                     "Supports/press/Type=roller",
                     "Supports/press/Boundaries=upper.top",
                     "Supports/press/Normal displacement=-0.001*t",
                     "Loads/Names=side",
                     "Loads/side/Boundaries=upper.right",
                     "Loads/side/Pressure=0.1*(1+t*y)"}},
            {"a rigid punch with force and moment",
             Lines{"Bodies/Names=block",
                   "Bodies/block/Corners=-1,-1 : 1,0",
                   "Bodies/block/Subdivisions=4,2",
                   "Bodies/block/Young's modulus=10",
                   "Bodies/block/Poisson's ratio=0.3",
                   "Obstacles/Names=punch",
                   "Obstacles/punch/Shape=cylinder",
                   "Obstacles/punch/Center=0.1,2",
                   "Obstacles/punch/Radius=2.05",
                   "Obstacles/punch/Reference point=0.2,0.1",
                   "Obstacles/punch/Displacement=0; free",
                   "Obstacles/punch/Rotation=free",
                   "Obstacles/punch/Force=0; -0.1*t",
                   "Obstacles/punch/Moment=0.02*t",
                   "Mesh/Refinement regions/Names=near",
                   "Mesh/Refinement regions/near/Inside=min(0.3 - x, 0.3 + y)"} +
               pair("block.top", "punch") + Lines{"Contact pairs/pair/Search distance=1"} +
               fixed("block.bottom", "0; 0")},
            {"a plate that never separates",
             Lines{"Bodies/Names=block",
                   "Bodies/block/Corners=-1,-1 : 1,0",
                   "Bodies/block/Subdivisions=3,2",
                   "Bodies/block/Young's modulus=10",
                   "Bodies/block/Poisson's ratio=0.3",
                   "Obstacles/Names=plate",
                   "Obstacles/plate/Shape=plane",
                   "Obstacles/plate/Point=0,0",
                   "Obstacles/plate/Normal=0,-1",
                   "Obstacles/plate/Displacement=0; free",
                   "Obstacles/plate/Rotation=free",
                   "Obstacles/plate/Force=0; 0.1*t"} +
               pair("block.top", "plate") + Lines{"Contact pairs/pair/Separation=none"} +
               fixed("block.bottom", "0; 0")},
            {"axisymmetric",
             boxes("0,0 : 1,1", "3,2", "0,1 : 1,2", "4,2") +
               fixed("lower.bottom, upper.top", "free; -0.001*t") +
               Lines{"Model=axisymmetric",
                     "Loads/Names=weight, side",
                     "Loads/weight/Bodies=lower, upper",
                     "Loads/weight/Body force=0; -0.1*t",
                     "Loads/side/Boundaries=upper.right",
                     "Loads/side/Traction=0.1; 0.1*t"}}};
  }

  /// Tetrahedra of first order below those of second order.
  inline Lines
  tetrahedra()
  {
    Lines result = materials("lower", "upper") + pair("upper.upper_bottom", "lower.lower_top") +
                   fixed("lower.base, upper.press", "0.001*t; 0; -0.001*t");
    for (const std::string body : {"lower", "upper"})
      result =
        result + Lines{"Bodies/" + body + "/Mesh=file",
                       "Bodies/" + body + "/File=" + source_directory() + "/meshes/tetrahedra.inp",
                       "Bodies/" + body + "/Part=" + body,
                       "Bodies/" + body + "/Cells=as in file"};
    return result;
  }

  inline std::vector<Case>
  cases_3d()
  {
    const Lines base   = fixed("lower.bottom, upper.top", "0.001*t; 0; -0.001*t");
    const Lines turned = {
      "Bodies/lower/Transformation=x*cos(0.5)-z*sin(0.5); y; x*sin(0.5)+z*cos(0.5)",
      "Bodies/upper/Transformation=x*cos(0.5)-z*sin(0.5); y; x*sin(0.5)+z*cos(0.5)"};
    return {
      {"flat, matching", boxes("0,0,0 : 1,1,1", "2,2,1", "0,0,1 : 1,1,2", "2,2,1") + base},
      {"curved, not matching",
       materials("ball", "shell") + pair("ball.sphere", "shell.inner") +
         Lines{"Bodies/ball/Mesh=sphere",
               "Bodies/ball/Radius=1",
               "Bodies/ball/Part=lower quarter",
               "Bodies/shell/Mesh=shell",
               "Bodies/shell/Inner radius=1.001",
               "Bodies/shell/Outer radius=2",
               "Bodies/shell/Part=lower quarter",
               "Bodies/shell/Cells along 45 degrees=2",
               "Bodies/shell/Cells through=1",
               "Contact pairs/pair/Search distance=0.5",
               "Contact pairs/pair/Initial gap=0.01*cos(3*x)",
               "Supports/Names=cuts, base",
               "Supports/cuts/Type=symmetry",
               "Supports/cuts/Boundaries=ball.symmetry_x, ball.symmetry_y, shell.symmetry_x, "
               "shell.symmetry_y",
               "Supports/base/Boundaries=ball.top, shell.outer",
               "Supports/base/Displacement=0; 0; -0.001*t"}},
      {"hanging nodes",
       boxes("0,0,0 : 1,1,1", "2,2,1", "0,0,1 : 1,1,2", "3,1,1") + base +
         Lines{"Mesh/Refinement regions/Names=near",
               "Mesh/Refinement regions/near/Inside=min(0.3 - x, min(0.3 - y, 0.3 - abs(z - 1)))"}},
      {"inclined supports",
       boxes("0,0,0 : 1,1,1", "2,1,1", "0,0,1 : 1,1,2", "1,2,1") + turned +
         Lines{"Supports/Names=sides, press",
               "Supports/sides/Type=symmetry",
               "Supports/sides/Boundaries=lower.left, upper.left, lower.front, upper.front, "
               "lower.bottom",
               "Supports/press/Type=roller",
               "Supports/press/Boundaries=upper.top",
               "Supports/press/Normal displacement=-0.001*t",
               "Loads/Names=side",
               "Loads/side/Boundaries=upper.right",
               "Loads/side/Pressure=0.1*(1+t*y)"}},
      {"a rigid ball with force and moments",
       Lines{"Bodies/Names=block",
             "Bodies/block/Corners=-1,-1,-1 : 1,1,0",
             "Bodies/block/Subdivisions=3,3,1",
             "Bodies/block/Young's modulus=10",
             "Bodies/block/Poisson's ratio=0.3",
             "Obstacles/Names=punch",
             "Obstacles/punch/Shape=sphere",
             "Obstacles/punch/Center=0.1,0,3",
             "Obstacles/punch/Radius=3.15",
             "Obstacles/punch/Reference point=0.2,0.1,0.1",
             "Obstacles/punch/Displacement=0; 0; free",
             "Obstacles/punch/Rotation=free; free; 0.001*t",
             "Obstacles/punch/Force=0; 0; -0.1*t",
             "Obstacles/punch/Moment=0.02*t; 0.01*t; 0"} +
         pair("block.top", "punch") + Lines{"Contact pairs/pair/Search distance=1"} +
         fixed("block.bottom", "0; 0; 0")}};
  }
} // namespace TestScene
