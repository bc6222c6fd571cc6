#include "contact/interface/master_faces.h"

#include "contact/constraints/gap_bend.h"
#include "contact/traction/stress_bounds.h"

#include <memory>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// What partners on the faces of a body tell of it.
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
        , is_finite(configuration.elasticity().is_finite())
        , with_bend(!configuration.is_rest())
      {
        const Elasticity<dim> &elasticity = configuration.elasticity();
        for (unsigned int i = 0; i < boundary.faces.size(); ++i)
          {
            stiffnesses.push_back(boundary.stiffness(elasticity, i));
            moduli.push_back(boundary.modulus(elasticity, i));
            sizes.push_back(boundary.patches[i].diameter());
          }
      }

      void
      operator()(const unsigned int i, const Point<dim - 1> &xi, Partner<dim> &partner)
      {
        const auto &[cell, face] = boundary.faces[i];
        trace.reinit(cell, face);
        partner.functions = trace.functions(xi);
        partner.stiffness = stiffnesses[i];
        partner.modulus   = moduli[i];
        partner.size      = sizes[i];
        partner.rest      = boundary.rest[i].position(xi);
        if (!boundary.start.empty())
          partner.start = boundary.start[i].position(xi);
        if (with_bend && is_near_enough(partner.distance, sizes[i]))
          partner.bend = bend_of_master(boundary.patches[i], xi, partner.normal);
        if (!stress)
          return;
        stress->reinit(cell);
        const Point<dim>      place   = unit_point<dim>(face, xi);
        const Tensor<1, dim> &n       = partner.normal;
        const Tensor<1, dim>  at_rest = boundary.rest[i].normal(xi);
        const auto            load    = loads->at(cell->face(face)->boundary_id(), partner.rest);
        partner.bound                 = bound(*stress, i);
        if (is_finite)
          {
            CauchyStress now      = stress->cauchy(place, -n, at_rest, load);
            partner.stress        = std::move(now.stress);
            partner.bulk_stress   = std::move(now.bulk_stress);
            partner.stress_value  = now.value;
            partner.stress_offset = now.offset;
            partner.bound *= now.stiffening;
            return;
          }
        partner.stress         = stress->row(place, -n, at_rest);
        partner.thermal_stress = stress->thermal_row(place, -n, at_rest);
        partner.bulk_stress    = stress->bulk_row(place, -n, at_rest);
        partner.stress_offset  = n * load.on(at_rest);
      }

    private:
      const BoundaryFaces<dim>           boundary;
      Trace<dim>                         trace;
      std::shared_ptr<NormalStress<dim>> stress;
      std::shared_ptr<SurfaceLoads<dim>> loads;
      StressBounds<dim>                  bound;
      const bool                         is_finite, with_bend;
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
