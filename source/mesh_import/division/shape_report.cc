// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/cells.h"
#include "mesh_import/division/subdivisions.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double       flat = 1e-10, poor = 0.05;
    constexpr unsigned int n_named = 3;



    /// @return the scaled Jacobian at a corner of a triangle, quadrilateral, tetrahedron or
    /// hexahedron in the numbering of MeshFile: the triple product of the unit vectors along its
    /// edges (2D: the z component of the cross product). Negative if the corner is folded, or the
    /// cell is listed the other way round.
    double
    scaled_jacobian(const MeshFile          &file,
                    const MeshFile::Element &cell,
                    const unsigned int       corner,
                    const unsigned int       dim)
    {
      if (cell.shape == MeshFile::Shape::tetrahedron)
        {
          const auto &x  = cell.nodes;
          const auto  a  = file.nodes[x[1]] - file.nodes[x[0]],
                     b   = file.nodes[x[2]] - file.nodes[x[0]],
                     c   = file.nodes[x[3]] - file.nodes[x[0]];
          double lengths = 1;
          for (unsigned int other = 0; other < 4; ++other)
            if (other != corner)
              lengths *= std::max(file.nodes[x[other]].distance(file.nodes[x[corner]]), 1e-100);
          return a * cross_product_3d(b, c) / lengths;
        }
      const unsigned int n     = dim == 2 ? n_corners(cell.shape) : 4; // around
      const unsigned int layer = corner / n * n, i = corner % n;
      const Point<3>    &p    = file.nodes[cell.nodes[corner]];
      const auto         edge = [&](const unsigned int other) {
        const Tensor<1, 3> e = file.nodes[cell.nodes[other]] - p;
        return e / std::max(e.norm(), 1e-300);
      };
      const Tensor<1, 3> normal =
        cross_product_3d(edge(layer + (i + 1) % n), edge(layer + (i + n - 1) % n));
      if (dim == 2)
        return normal[2];
      return layer == 0 ? normal * edge(corner + 4) : -(normal * edge(corner - 4));
    }
  } // namespace



  // The extreme scaled Jacobians over all children of an element.
  void
  ShapeReport::add(const MeshFile::Element &element, const MeshFile::Element &child)
  {
    if (present != &element)
      {
        finish();
        present = &element;
        least   = 2;
        largest = -2;
      }
    for (unsigned int corner = 0; corner < n_corners(child.shape); ++corner)
      {
        const double quality = scaled_jacobian(file, child, corner, dim);
        if (quality < least)
          {
            least             = quality;
            position_of_least = file.nodes[child.nodes[corner]];
          }
        if (quality > largest)
          {
            largest             = quality;
            position_of_largest = file.nodes[child.nodes[corner]];
          }
      }
  }



  // Classify the element whose children have all been added: folded or flat, or how good it is. An
  // element whose scaled Jacobians are all negative is mirrored and valid; orient() reverses it
  // later.
  void
  ShapeReport::finish()
  {
    if (!present)
      return;
    // Nodes that are listed the other way round give the same cells mirrored.
    const bool mirrored = largest < -flat;
    if (least <= flat && !mirrored)
      {
        if (++n_folded == 1)
          first_folded =
            "element " + std::to_string(present->number) + " of type " + present->type + " at " +
            Signorini::text_of(least < -flat && -least > largest ? position_of_largest :
                                                                   position_of_least) +
            (largest <= flat || least > -flat ?
               ", which is flat: its corners lie in one plane or on one line" :
               "") +
            (present->nodes.size() > n_corners(present->shape) ?
               "; Mid-side nodes = no helps if only its mid-side nodes fold it" :
               "");
        return;
      }
    const WorstCell one{present->number,
                        present->type,
                        mirrored ? -largest : least,
                        mirrored ? position_of_largest : position_of_least};
    n_poor += one.quality < poor;
    if (worst.size() == n_named && one.quality >= worst.back().quality)
      return;
    worst.insert(std::upper_bound(worst.begin(),
                                  worst.end(),
                                  one,
                                  [](const WorstCell &a, const WorstCell &b) {
                                    return a.quality < b.quality;
                                  }),
                 one);
    worst.resize(std::min<std::size_t>(worst.size(), n_named), one);
  }



  std::string
  ShapeReport::text_of(const WorstCell &one) const
  {
    std::ostringstream out;
    out << "element " << one.number << " (" << one.type << ") " << std::setprecision(2)
        << one.quality << std::setprecision(4) << " at (" << one.place << ")";
    return out.str();
  }



  // Errors first, then a warning if there are poor elements, otherwise the worst one for
  // information.
  std::vector<std::string>
  ShapeReport::notes()
  {
    finish();
    present = nullptr;
    if (n_folded > 0)
      throw SceneError("has " + std::to_string(n_folded) +
                       (n_folded == 1 ? " cell that is" : " cells that are") +
                       " folded or flat: " + (n_folded == 1 ? "" : "the first is ") + first_folded +
                       "; improve the mesh there, in Gmsh by Mesh.Optimize = 1 or "
                       "Mesh.OptimizeNetgen = 1");
    if (worst.empty())
      return {};
    if (n_poor == 0)
      return {
        "the worst shape has " + text_of(worst[0]) +
        ", the smallest scaled Jacobian of its parts: 1 in a cube, 0.71 in those of a regular "
        "tetrahedron, 0 if flat"};
    std::vector<std::string> names;
    for (const WorstCell &one : worst)
      if (one.quality < poor)
        names.push_back(text_of(one));
    return {"warning: " + std::to_string(n_poor) + (n_poor == 1 ? " cell is" : " cells are") +
            " nearly flat, their smallest scaled Jacobians below 0.05: " + join(names) +
            "; stresses there are poor and the solver slower: improve the mesh, in Gmsh by "
            "Mesh.Optimize = 1 or Mesh.OptimizeNetgen = 1"};
  }



  std::vector<std::string>
  ShapeReport::warnings()
  {
    std::vector<std::string> result = notes();
    if (n_poor == 0)
      result.clear();
    return result;
  }
} // namespace Signorini
