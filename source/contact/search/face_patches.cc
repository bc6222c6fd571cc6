// SPDX-License-Identifier: Apache-2.0
#include "contact/search/face_patches.h"

#include <deal.II/fe/fe_nothing.h>


namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The nodes of a face, lexicographic.
    template <int dim>
    Quadrature<dim>
    places_on(const ReferenceCell &cell, const unsigned int face, const unsigned int k)
    {
      std::vector<Point<dim>> points;
      for (const Point<dim - 1> &xi : face_lattice<dim>(shape_of_faces(cell), k))
        points.push_back(unit_point<dim>(cell, face, xi));
      return Quadrature<dim>(points);
    }

    /// The sign that makes the parametric normal of a face point out of the cell. A mapping of
    /// positive Jacobian determinant does not change that of the reference cell.
    template <int dim>
    double
    outward_sign(const ReferenceCell &cell, const unsigned int face)
    {
      Tensor<1, dim> normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(face_direction<dim>(cell, face, 0));
      else
        normal =
          cross_product_3d(face_direction<dim>(cell, face, 0), face_direction<dim>(cell, face, 1));
      return normal * inward_direction<dim>(cell, face) < 0 ? 1 : -1;
    }

    /// True if no curve or surface of the mesh contains a side of the face, or the face itself:
    /// then its vertices determine it.
    template <int dim>
    bool
    is_straight(const typename Triangulation<dim>::cell_iterator &cell, const unsigned int face)
    {
      const auto of_cell = cell->face(face);
      bool       result  = of_cell->manifold_id() == numbers::flat_manifold_id;
      if constexpr (dim == 3)
        for (unsigned int l = 0; l < of_cell->n_lines(); ++l)
          result = result && of_cell->line(l)->manifold_id() == numbers::flat_manifold_id;
      return result;
    }

    /// Halve the degree of a face's nodes as long as its shape does not change; returns the degree.
    template <int dim>
    unsigned int
    lower_degree(const ReferenceCell &shape, std::vector<Point<dim>> &nodes, unsigned int k)
    {
      constexpr double small = 3e-6;
      for (; k % 2 == 0; k /= 2)
        {
          const auto           fewer = every_nth_of_lattice(shape, nodes, k, 2);
          const FacePatch<dim> lower(k / 2, fewer, 1);
          const double         most = small * lower.diameter();
          auto                 node = nodes.begin();
          for (const Point<dim - 1> &xi : face_lattice<dim>(shape, k))
            if (lower.position(xi).distance(*node++) > most)
              return k;
          nodes = fewer;
        }
      return k;
    }
  } // namespace



  template <int dim>
  FacePatches<dim>::FacePatches(const Mesh<dim> &mesh)
    : degree(mesh.surface_degree())
  {
    static const FE_Nothing<dim> nothing(ReferenceCells::get_hypercube<dim>()),
      nothing_on_simplices(ReferenceCells::get_simplex<dim>());
    const auto add = [&](const FE_Nothing<dim> &fe, auto &of_faces) {
      for (const unsigned int face : fe.reference_cell().face_indices())
        of_faces.push_back(std::make_unique<FEValues<dim>>(
          mesh.surface_mapping(),
          fe,
          places_on<dim>(fe.reference_cell(),
                         face,
                         geometry_degree_of(fe.reference_cell(), degree)),
          update_quadrature_points));
    };
    if (mesh.has_hypercubes())
      add(nothing, of_hypercubes);
    if (mesh.has_simplices())
      add(nothing_on_simplices, of_simplices);
  }



  template <int dim>
  FacePatch<dim>
  FacePatches<dim>::operator()(const typename Triangulation<dim>::cell_iterator &cell,
                               const unsigned int                                face)
  {
    const ReferenceCell     reference = cell->reference_cell();
    FEValues<dim>          &values = *(reference.is_simplex() ? of_simplices : of_hypercubes)[face];
    std::vector<Point<dim>> nodes;
    unsigned int            k = 1;
    if (is_straight<dim>(cell, face))
      // Vertices of a face in lexicographic order are vertices of the cell.
      for (const Point<dim - 1> &xi : face_lattice<dim>(shape_of_faces(reference), 1))
        {
          const Point<dim> unit = unit_point<dim>(reference, face, xi);
          unsigned int     v    = 0;
          while (reference.vertex<dim>(v).distance_square(unit) > 0.1)
            ++v;
          nodes.push_back(cell->vertex(v));
        }
    else
      {
        values.reinit(cell);
        nodes = values.get_quadrature_points();
        k = lower_degree(shape_of_faces(reference), nodes, geometry_degree_of(reference, degree));
      }
    return FacePatch<dim>(k, nodes, outward_sign<dim>(reference, face));
  }



  template class FacePatches<2>;
  template class FacePatches<3>;
} // namespace Signorini
