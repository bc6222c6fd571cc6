// SPDX-License-Identifier: Apache-2.0
#include "accuracy/quantities/singular_vertices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The faces of the boundary at one vertex. Those of contact surfaces and with loads are free:
    /// tractions do not bound stresses at the end of a support.
    template <int dim>
    struct FacesAtVertex
    {
      bool has_held = false, has_free = false;
      /// Centres and outward normals of plane faces.
      std::vector<std::pair<Point<dim>, Tensor<1, dim>>> planes;
    };

    /// @return the outward normal at the centre of a face, which is nearly plane.
    template <int dim>
    Tensor<1, dim>
    outward_normal(const typename DoFHandler<dim>::active_cell_iterator &cell,
                   const unsigned int                                    face)
    {
      const auto     of = cell->face(face);
      Tensor<1, dim> normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(of->vertex(1) - of->vertex(0));
      else
        normal = cross_product_3d(of->vertex(1) - of->vertex(0), of->vertex(2) - of->vertex(0));
      normal /= normal.norm();
      return normal * (of->center() - cell->center()) > 0 ? normal : -normal;
    }

    /// @return whether a support prescribes a displacement along a face.
    template <int dim>
    bool
    holds_along(const Support<dim> &support, const Point<dim> &x, const Tensor<1, dim> &normal)
    {
      constexpr double nearly_one = 0.99;
      if (support.type == SupportType::symmetry)
        return false;
      if (support.type == SupportType::roller)
        return support.direction.norm() > 0 &&
               std::abs(support.direction * normal) < nearly_one * support.direction.norm();
      const Tensor<2, dim> axes = support.axes.at(x);
      for (unsigned int d = 0; d < dim; ++d)
        if (support.displacement.prescribed(d) && std::abs(axes[d] * normal) < nearly_one)
          return true;
      return false;
    }

    /// @return whether two of the faces enclose a re-entrant corner: the centre of one is on the
    /// outer side of the other one.
    template <int dim>
    bool
    is_reentrant(const FacesAtVertex<dim> &faces)
    {
      constexpr double sine = 0.45;
      for (const auto &[center, normal] : faces.planes)
        for (const auto &other : faces.planes)
          if ((other.first - center) * normal > sine * (other.first - center).norm())
            return true;
      return false;
    }
  } // namespace



  // Where a surface that is held along itself meets a free one, stresses grow like the distance to
  // a power between -1/2 (a plane surface) and 0, for angles of the body above 60 degrees or so; at
  // a right angle they are bounded only for a Poisson's ratio of zero (Williams 1952). At the
  // re-entrant corner of a free surface they grow for any ratio. The exponents are not computed:
  // that there is no limit is all that a bar has to know.
  //
  // Supports are those of the present time. Faces of other cells count as well, since a support may
  // end beside the cell.
  template <int dim>
  std::vector<Point<dim>>
  singular_vertices(const Elasticity<dim>                                &elasticity,
                    const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    std::map<types::boundary_id, std::vector<const Support<dim> *>> supports;
    for (const Support<dim> &support : elasticity.supports())
      if (support.acts(elasticity.time_of_supports()))
        for (const std::string &boundary : support.boundaries)
          if (elasticity.mesh().body_of(boundary))
            for (const types::boundary_id id : elasticity.mesh().boundary_ids(boundary))
              supports[id].push_back(&support);
    std::map<unsigned int, FacesAtVertex<dim>> at_vertex;
    for (const unsigned int v : cell->vertex_indices())
      at_vertex[cell->vertex_index(v)];
    for (const auto &other : elasticity.dof_handler().active_cell_iterators())
      if (!other->is_artificial() && other->at_boundary())
        for (const unsigned int f : other->face_indices())
          {
            const auto face = other->face(f);
            if (!face->at_boundary())
              continue;
            for (const unsigned int v : face->vertex_indices())
              if (const auto found = at_vertex.find(face->vertex_index(v));
                  found != at_vertex.end())
                {
                  const Tensor<1, dim> normal = outward_normal<dim>(other, f);
                  const auto           of     = supports.find(face->boundary_id());
                  if (of == supports.end())
                    found->second.has_free = true;
                  else
                    found->second.has_held |=
                      std::any_of(of->second.begin(), of->second.end(), [&](const auto *support) {
                        return holds_along(*support, face->center(), normal);
                      });
                  if (face->manifold_id() == numbers::flat_manifold_id)
                    found->second.planes.emplace_back(face->center(), normal);
                }
          }
    const bool bulges = elasticity.material(cell->material_id()).poissons_ratio > 0 ||
                        elasticity.material(cell->material_id()).constitutive_law;
    std::vector<Point<dim>> result;
    for (const unsigned int v : cell->vertex_indices())
      {
        const FacesAtVertex<dim> &faces = at_vertex[cell->vertex_index(v)];
        if ((faces.has_held && faces.has_free && bulges) || is_reentrant(faces))
          result.push_back(cell->vertex(v));
      }
    return result;
  }



  template std::vector<Point<2>>
  singular_vertices(const Elasticity<2> &, const DoFHandler<2>::active_cell_iterator &);
  template std::vector<Point<3>>
  singular_vertices(const Elasticity<3> &, const DoFHandler<3>::active_cell_iterator &);
} // namespace Signorini
