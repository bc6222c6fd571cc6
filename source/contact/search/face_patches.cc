// SPDX-License-Identifier: Apache-2.0
#include "contact/search/face_patches.h"

#include <deal.II/fe/fe_nothing.h>


namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The nodes of a face, lexicographic, then its middle and a point inside of the cell.
    template <int dim>
    Quadrature<dim>
    places_on(const ReferenceCell &cell, const unsigned int face, const unsigned int k)
    {
      const ReferenceCell     shape = shape_of_faces(cell);
      std::vector<Point<dim>> points;
      for (const Point<dim - 1> &xi : face_lattice<dim>(shape, k))
        points.push_back(unit_point<dim>(cell, face, xi));
      points.push_back(unit_point<dim>(cell, face, shape.barycenter<dim - 1>()));
      // A step along the third coordinate line leaves the face to the inside wherever the mapping
      // is valid; the center of a flat or strongly curved cell may lie on the wrong side.
      points.push_back(points.back());
      points.back() += 1e-3 * inward_direction<dim>(cell, face);
      return Quadrature<dim>(points);
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
    const ReferenceCell reference = cell->reference_cell();
    FEValues<dim>      &values    = *(reference.is_simplex() ? of_simplices : of_hypercubes)[face];
    values.reinit(cell);
    std::vector<Point<dim>> nodes    = values.get_quadrature_points();
    const Tensor<1, dim>    outwards = nodes[nodes.size() - 2] - nodes.back();
    nodes.resize(nodes.size() - 2);
    const unsigned int k =
      lower_degree(shape_of_faces(reference), nodes, geometry_degree_of(reference, degree));
    const FacePatch<dim> patch(k, nodes, 1);
    return patch.normal(patch.middle()) * outwards > 0 ? patch : FacePatch<dim>(k, nodes, -1);
  }



  template class FacePatches<2>;
  template class FacePatches<3>;
} // namespace Signorini
