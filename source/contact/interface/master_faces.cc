// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/gap_second_variation.h"
#include "contact/interface/surface_steps.h"
#include "contact/traction/stress_bounds.h"
#include <signorini/contact/methods/method.h>

#include <memory>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Completes projections on the faces of a body by what depends on the cell behind: shape
    /// functions, stiffness E/h, reference position, second variation of the gap, and the stress
    /// with its bound. Keeps a copy of the faces; state of the last cell is reused for the
    /// next point.
    template <int dim>
    class BodyBehind
    {
    public:
      BodyBehind(const Configuration<dim> &configuration,
                 const BoundaryFaces<dim> &boundary,
                 const MasterImage<dim>   &image,
                 const ContactMethod      &method)
        : boundary(boundary)
        , image(image)
        , trace(configuration.elasticity())
        , with_slip(method.uses_slip())
        , bound(boundary, with_slip)
        // The second variation of a gap to a rotated image is left out: it is part of the tangent
        // alone.
        , with_second_variation(!configuration.is_reference() && !image.turns())
      {
        if (method.pressure_shift() == PressureShift::normal_stress)
          {
            stress = std::make_shared<NormalStress<dim>>(configuration);
            loads  = std::make_shared<SurfaceLoads<dim>>(surface_loads(configuration.elasticity()));
          }
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
        // The traction on the slave is the reaction, along n it is -n . sigma N (doc/theory,
        // (2.12)). Stresses are those of the master itself, not of its image.
        stress->reinit(cell);
        auto directions = stress_directions(master_point.normal, with_slip);
        for (Tensor<1, dim> &direction : directions)
          direction = -image.at_master(direction);
        const auto load     = loads->at(*cell, face, image.origin_of(master_point.rest));
        BodyStress now      = stress->at(unit_point<dim>(cell->reference_cell(), face, xi),
                                    directions,
                                    image.at_master(boundary.rest[i].normal(xi)),
                                    load);
        master_point.stress = std::move(now.components);
        master_point.bound  = bound(*stress, i) * now.stiffening;
      }

    private:
      const BoundaryFaces<dim>           boundary;
      const MasterImage<dim>             image;
      Trace<dim>                         trace;
      std::shared_ptr<NormalStress<dim>> stress; ///< null: not used
      std::shared_ptr<SurfaceLoads<dim>> loads;
      const bool                         with_slip;
      StressBounds<dim>                  bound;
      const bool                         with_second_variation;
      std::vector<double>                stiffnesses, moduli, sizes;
    };
  } // namespace



  template <int dim>
  MasterFaces<dim>
  master_faces(const Configuration<dim> &configuration,
               const BoundaryFaces<dim> &boundary,
               const MasterImage<dim>   &image,
               const ContactMethod      &method)
  {
    return {boundary.patches, BodyBehind<dim>(configuration, boundary, image, method)};
  }



  template MasterFaces<2>
  master_faces(const Configuration<2> &,
               const BoundaryFaces<2> &,
               const MasterImage<2> &,
               const ContactMethod &);
  template MasterFaces<3>
  master_faces(const Configuration<3> &,
               const BoundaryFaces<3> &,
               const MasterImage<3> &,
               const ContactMethod &);
} // namespace Signorini
