#include <signorini/contact/geometry/boundary_faces.h>
#include <signorini/contact/geometry/face_patches.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  BoundaryFaces<dim>::BoundaryFaces(const Elasticity<dim> &elasticity, const std::string &boundary)
    : BoundaryFaces(Configuration<dim>(elasticity), boundary)
  {}



  template <int dim>
  BoundaryFaces<dim>::BoundaryFaces(const Configuration<dim> &configuration,
                                    const std::string        &boundary)
  {
    const Elasticity<dim> &elasticity = configuration.elasticity();
    const Mesh<dim>       &mesh       = elasticity.mesh();
    const BoundaryIds     &ids        = mesh.boundary_ids(boundary);
    FacePatches<dim>       patch_of(mesh);
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && ids.count(cell->face(f)->boundary_id()) > 0)
            {
              faces.emplace_back(cell, f);
              rest.push_back(patch_of(cell, f));
              patches.push_back(configuration.moved(rest.back(), cell, f));
            }
  }



  template <int dim>
  double
  BoundaryFaces<dim>::depth(const unsigned int i) const
  {
    const auto &[cell, face] = faces[i];
    return cell->measure() / cell->face(face)->measure();
  }



  template <int dim>
  double
  BoundaryFaces<dim>::modulus(const Elasticity<dim> &elasticity, const unsigned int i) const
  {
    return elasticity.material(faces[i].first->material_id()).youngs_modulus;
  }



  template <int dim>
  double
  BoundaryFaces<dim>::stiffness(const Elasticity<dim> &elasticity, const unsigned int i) const
  {
    return modulus(elasticity, i) / depth(i);
  }



  template struct BoundaryFaces<2>;
  template struct BoundaryFaces<3>;
} // namespace Signorini
