// SPDX-License-Identifier: Apache-2.0
#include "contact/search/boundary_faces.h"

#include "contact/search/face_patches.h"
#include "geometry/cell_size.h"
#include "geometry/face_parameter.h"

#include <algorithm>
#include <map>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  BoundaryFaces<dim>::BoundaryFaces(const Elasticity<dim> &elasticity, const std::string &boundary)
    : BoundaryFaces(Configuration<dim>(elasticity), boundary)
  {}



  // Faces whose boundary id belongs to the name.
  template <int dim>
  BoundaryFaces<dim>::BoundaryFaces(const Configuration<dim> &configuration,
                                    const std::string        &boundary)
    : BoundaryFaces(configuration,
                    [&ids = configuration.elasticity().mesh().boundary_ids(
                       boundary)](const CellIterator<dim> &cell, const unsigned int f) {
                      return ids.count(cell->face(f)->boundary_id()) > 0;
                    })
  {}



  template <int dim>
  BoundaryFaces<dim>::BoundaryFaces(const Configuration<dim> &configuration, const Choice &choice)
  {
    // Faces of locally owned cells only, in the order of the cells. The current (patches),
    // reference (rest) and start-of-step geometry have the same order.
    const Elasticity<dim> &elasticity = configuration.elasticity();
    FacePatches<dim>       patch_of(elasticity.mesh());
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && choice(cell, f))
            {
              faces.emplace_back(cell, f);
              rest.push_back(patch_of(cell, f));
              rest.back().piece = elasticity.mesh().piece(cell);
              patches.push_back(configuration.moved(rest.back(), cell, f));
              if (configuration.start())
                start.push_back(configuration.start()->moved(rest.back(), cell, f));
            }
  }



  template <int dim>
  BoundaryFaces<dim>
  BoundaryFaces<dim>::of_master(const Configuration<dim> &configuration,
                                const ContactPair<dim>   &pair)
  {
    BoundaryFaces result(configuration, pair.master);
    if (!pair.image.is_master())
      for (auto *faces : {&result.patches, &result.rest, &result.start})
        for (FacePatch<dim> &face : *faces)
          face = face.moved([&](const Point<dim> &x) { return pair.image.of(x); });
    const auto shift = [&](const Configuration<dim> &there, std::vector<FacePatch<dim>> &faces) {
      const Tensor<1, dim> by =
        there.motion_of(pair.pretension.body_name(pair.name))[0] * pair.pretension.direction;
      if (by.norm() > 0)
        for (FacePatch<dim> &face : faces)
          face = face.moved([&](const Point<dim> &x) { return x + by; });
    };
    shift(configuration, result.patches);
    if (configuration.start())
      shift(*configuration.start(), result.start);
    return result;
  }



  // All lists are reduced alike, so that the numbers of faces stay consistent.
  template <int dim>
  BoundaryFaces<dim>
  BoundaryFaces<dim>::among(const std::vector<bool> &chosen) const
  {
    BoundaryFaces result;
    for (unsigned int i = 0; i < faces.size(); ++i)
      if (chosen[i])
        {
          result.faces.push_back(faces[i]);
          result.patches.push_back(patches[i]);
          result.rest.push_back(rest[i]);
          if (!start.empty())
            result.start.push_back(start[i]);
        }
    return result;
  }



  // Faces are weighted with their areas, by the normals in their middles.
  template <int dim>
  Tensor<1, dim>
  BoundaryFaces<dim>::mean_normal(const MPI_Comm comm) const
  {
    Tensor<1, dim> sum;
    double         area = 0;
    for (const FacePatch<dim> &face : rest)
      {
        // The area of the parameters of a triangle is one half.
        const double of_face = face.jacobian(face.middle()) * face.reference_cell().volume();
        sum += of_face * face.normal(face.middle());
        area += of_face;
      }
    area = Utilities::MPI::sum(area, comm);
    return area > 0 ? Utilities::MPI::sum(sum, comm) / area : sum;
  }



  // The size h of the cell normal to its face [length].
  template <int dim>
  double
  BoundaryFaces<dim>::depth(const unsigned int i) const
  {
    const auto &[cell, face] = faces[i];
    return depth_behind(cell, face);
  }



  template <int dim>
  double
  BoundaryFaces<dim>::modulus(const Elasticity<dim> &elasticity, const unsigned int i) const
  {
    return elasticity.material(faces[i].first->material_id()).youngs_modulus;
  }



  // E/h, the stiffness scale of a face [force/length^3] (doc/theory, 3.5).
  template <int dim>
  double
  BoundaryFaces<dim>::stiffness(const Elasticity<dim> &elasticity, const unsigned int i) const
  {
    return modulus(elasticity, i) / depth(i);
  }



  namespace
  {
    /// Counts the faces at each vertex (2D) or edge (3D), to find the sides that two faces share.
    template <int dim>
    class SharedSides
    {
    public:
      using Cell = typename Triangulation<dim>::active_cell_iterator;

      /// Add a face: each of its sides, with the halves that finer neighbours have.
      void
      add(const Cell &cell, const unsigned int face)
      {
        for (unsigned int side = 0; side < n_sides(cell); ++side)
          for (const unsigned int i : with_parts(cell, face, side))
            ++count[i];
      }

      /// True if a second face has this side, or a half of it.
      bool
      is_shared(const Cell &cell, const unsigned int face, const unsigned int side) const
      {
        for (const unsigned int i : with_parts(cell, face, side))
          if (count.at(i) > 1)
            return true;
        return false;
      }

      static unsigned int
      n_sides(const Cell &cell)
      {
        return dim == 2 ? 2 : shape_of_faces(cell->reference_cell()).n_faces();
      }

    private:
      /// The keys of a side of a face, together with those of its halves, which finer neighbours
      /// have.
      static std::vector<unsigned int>
      with_parts(const Cell &cell, const unsigned int face, const unsigned int side)
      {
        // The end points of the side in the reference cell, as numbers of vertices.
        const auto                        reference = cell->reference_cell();
        std::array<unsigned int, dim - 1> ends;
        for (unsigned int i = 0; i < ends.size(); ++i)
          {
            Point<dim - 1> xi;
            if constexpr (dim == 2)
              xi[0] = side;
            else
              xi = ends_of_side<dim>(shape_of_faces(reference), side)[i];
            const Point<dim> x = unit_point<dim>(reference, face, xi);
            ends[i]            = 0;
            while (reference.template vertex<dim>(ends[i]).distance(x) > 1e-10)
              ++ends[i];
          }
        if constexpr (dim == 2)
          return {cell->vertex_index(ends[0])};
        // In 3D the side is the line of the cell between these two vertices.
        else
          for (const unsigned int l : cell->line_indices())
            {
              const auto         line  = cell->line(l);
              const unsigned int first = cell->vertex_index(ends[0]),
                                 last  = cell->vertex_index(ends[1]);
              if (std::minmax(line->vertex_index(0), line->vertex_index(1)) !=
                  std::minmax(first, last))
                continue;
              std::vector<unsigned int> result = {static_cast<unsigned int>(line->index())};
              if (line->has_children())
                for (unsigned int c = 0; c < 2; ++c)
                  result.push_back(line->child(c)->index());
              return result;
            }
        return {}; // each side is a line
      }

      std::map<unsigned int, unsigned int> count; ///< of faces at vertices or lines
    };
  } // namespace



  template <int dim>
  std::vector<SidesOfFace<dim>>
  inner_sides(const Mesh<dim> &mesh, const std::string &boundary, const BoundaryFaces<dim> &faces)
  {
    // Ghost cells are counted too, so that sides on the boundary of a rank's partition are found
    // without communication.
    const BoundaryIds &ids = mesh.boundary_ids(boundary);
    SharedSides<dim>   sides;
    for_each_face(mesh.triangulation().active_cell_iterators(),
                  ids,
                  [&](const auto &cell, const unsigned int face) { sides.add(cell, face); });
    std::vector<SidesOfFace<dim>> result;
    for (const auto &[cell, face] : faces.faces)
      {
        result.push_back({});
        for (unsigned int side = 0; side < SharedSides<dim>::n_sides(cell); ++side)
          result.back()[side] = sides.is_shared(cell, face, side);
      }
    return result;
  }



  template struct BoundaryFaces<2>;
  template struct BoundaryFaces<3>;
  template std::vector<SidesOfFace<2>>
  inner_sides(const Mesh<2> &, const std::string &, const BoundaryFaces<2> &);
  template std::vector<SidesOfFace<3>>
  inner_sides(const Mesh<3> &, const std::string &, const BoundaryFaces<3> &);
} // namespace Signorini
