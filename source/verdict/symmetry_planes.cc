// SPDX-License-Identifier: Apache-2.0
#include "contact/search/boundary_faces.h"
#include "verdict/undetected_penetration.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return whether a support may represent a plane of symmetry with a normal: at all times it
    /// constrains the normal component to zero, and no other.
    template <int dim>
    bool
    may_be_symmetry(const Support<dim> &support, const Tensor<1, dim> &normal)
    {
      // A support that begins or ends is no property of the geometry.
      if (support.is_limited() || !support.axes.are_global())
        return false;
      if (support.type != SupportType::displacement)
        return support.type == SupportType::symmetry;
      for (unsigned int d = 0; d < dim; ++d)
        {
          // Prescribed components are along the global axes, so that only planes normal to an axis
          // qualify.
          const bool is_normal = std::abs(normal[d]) > 1 - 1e-6;
          if (support.displacement.prescribed(d) != is_normal || !support.displacement.is_zero(d))
            return false;
        }
      return true;
    }
  } // namespace



  // A boundary is plane if the mean of its normals has length one.
  template <int dim>
  std::vector<SymmetryPlane<dim>>
  symmetry_planes(const Scene<dim> &scene, const Elasticity<dim> &elasticity)
  {
    const MPI_Comm                  comm = elasticity.mesh().communicator();
    std::vector<SymmetryPlane<dim>> result;
    for (const Support<dim> &support : scene.supports)
      for (const std::string &boundary : support.boundaries)
        {
          const BoundaryFaces<dim> faces(elasticity, boundary);
          Point<dim>               centers;
          Tensor<1, dim>           normals;
          for (const FacePatch<dim> &patch : faces.rest)
            {
              centers += patch.center();
              normals += patch.normal(Point<dim - 1>());
            }
          // Without faces n is zero, and the comparison below is false for NaN. All faces count
          // alike, whatever their area is: the mean of unit vectors is shorter than one unless all
          // agree.
          const double n = Utilities::MPI::sum(faces.rest.size(), comm);
          normals        = Utilities::MPI::sum(normals, comm) / n;
          centers =
            Point<dim>(Utilities::MPI::sum(static_cast<const Tensor<1, dim> &>(centers), comm) / n);
          if (normals.norm() > 1 - 1e-9 && may_be_symmetry(support, normals))
            result.push_back({boundary, *elasticity.mesh().body_of(boundary), centers, normals});
        }
    return result;
  }



  template std::vector<SymmetryPlane<2>>
  symmetry_planes(const Scene<2> &, const Elasticity<2> &);
  template std::vector<SymmetryPlane<3>>
  symmetry_planes(const Scene<3> &, const Elasticity<3> &);
} // namespace Signorini
