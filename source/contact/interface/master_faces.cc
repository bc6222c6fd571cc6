// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/gap_second_variation.h"
#include "contact/interface/surface_steps.h"
#include "contact/traction/stress_bounds.h"

#include <memory>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Completes projections on the faces of a body by what depends on the cell behind: shape
    /// functions, stiffness E/h, reference position, second variation of the gap, and the normal
    /// stress with its bound. Keeps a copy of the faces; state of the last cell is reused for the
    /// next point.
    template <int dim>
    class BodyBehind
    {
    public:
      BodyBehind(const Configuration<dim> &configuration,
                 const BoundaryFaces<dim> &boundary,
                 const bool                with_stress)
        : boundary(boundary)
        , trace(configuration.elasticity())
        , stress(with_stress ? std::make_shared<NormalStress<dim>>(configuration) : nullptr)
        , loads(with_stress ?
                  std::make_shared<SurfaceLoads<dim>>(surface_loads(configuration.elasticity())) :
                  nullptr)
        , bound(boundary)
        , is_finite_strain(configuration.elasticity().is_finite_strain())
        , with_second_variation(!configuration.is_reference())
      {
        const Elasticity<dim> &elasticity = configuration.elasticity();
        for (unsigned int i = 0; i < boundary.faces.size(); ++i)
          {
            stiffnesses.push_back(boundary.stiffness(elasticity, i));
            moduli.push_back(boundary.modulus(elasticity, i));
            sizes.push_back(boundary.patches[i].diameter());
          }
      }

      /// @param i number of the face; @param xi parameter of the projection, whose position, normal
      /// and distance are set
      void
      operator()(const unsigned int     i,
                 const Point<dim - 1>  &xi,
                 MasterProjection<dim> &master_point)
      {
        const auto &[cell, face] = boundary.faces[i];
        trace.reinit(cell, face);
        master_point.functions = trace.functions(xi);
        master_point.stiffness = stiffnesses[i];
        master_point.modulus   = moduli[i];
        master_point.size      = sizes[i];
        master_point.rest      = boundary.rest[i].position(xi);
        if (!boundary.start.empty())
          master_point.start = boundary.start[i].position(xi);
        if (with_second_variation && may_carry_pressure(master_point.distance, sizes[i]))
          master_point.second_variation =
            second_variation_of_master(boundary.patches[i], xi, master_point.normal);
        if (!stress)
          return;
        // The contact normal points out of the master, so that the stress of the master, positive
        // in compression, is -n . sigma N (doc/theory, (2.12)).
        stress->reinit(cell);
        const Point<dim>      place   = unit_point<dim>(face, xi);
        const Tensor<1, dim> &n       = master_point.normal;
        const Tensor<1, dim>  at_rest = boundary.rest[i].normal(xi);
        const auto            load = loads->at(cell->face(face)->boundary_id(), master_point.rest);
        master_point.bound         = bound(*stress, i);
        if (is_finite_strain)
          {
            CauchyStress now               = stress->cauchy(place, -n, at_rest, load);
            master_point.stress            = std::move(now.stress);
            master_point.volumetric_stress = std::move(now.volumetric_stress);
            master_point.stress_value      = now.value;
            master_point.stress_offset     = now.offset;
            master_point.bound *= now.stiffening;
            return;
          }
        master_point.stress            = stress->row(place, -n, at_rest);
        master_point.thermal_stress    = stress->thermal_row(place, -n, at_rest);
        master_point.volumetric_stress = stress->volumetric_row(place, -n, at_rest);
        master_point.stress_offset     = n * load.on(at_rest);
      }

    private:
      const BoundaryFaces<dim>           boundary;
      Trace<dim>                         trace;
      std::shared_ptr<NormalStress<dim>> stress;
      std::shared_ptr<SurfaceLoads<dim>> loads;
      StressBounds<dim>                  bound;
      const bool                         is_finite_strain, with_second_variation;
      std::vector<double>                stiffnesses, moduli, sizes;
    };
  } // namespace



  template <int dim>
  MasterFaces<dim>
  master_faces(const Configuration<dim> &configuration,
               const BoundaryFaces<dim> &boundary,
               const bool                with_stress)
  {
    return {boundary.patches, BodyBehind<dim>(configuration, boundary, with_stress)};
  }



  template MasterFaces<2>
  master_faces(const Configuration<2> &, const BoundaryFaces<2> &, bool);
  template MasterFaces<3>
  master_faces(const Configuration<3> &, const BoundaryFaces<3> &, bool);
} // namespace Signorini
