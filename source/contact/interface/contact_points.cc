// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/contact_points.h"

#include "contact/constraints/gap_second_variation.h"
#include "contact/traction/stress_bounds.h"
#include "geometry/lagrange.h"
#include <signorini/contact/methods/method.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <limits>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The reference gap that the settings of a pair prescribe.
    template <int dim>
    class InitialGap
    {
    public:
      InitialGap(const ContactPair<dim> &pair)
        : is_given(pair.gap_is_given())
        , closes_below(pair.closes_below)
        , formula(is_given && pair.initial_gap.text != "closed" ? pair.initial_gap : Formula("0"))
      {}

      /// The gap at x and time t. @param from_geometry the geometric gap there [length]
      double
      operator()(const Point<dim> &x, const double t, const double from_geometry) const
      {
        if (is_given)
          return formula.value(x, t);
        // Gaps up to `closes_below` are closed: they count as zero.
        return closes_below >= 0 && from_geometry <= closes_below ? 0. : from_geometry;
      }

    private:
      const bool            is_given;
      const double          closes_below;
      const Expression<dim> formula;
    };

    /// The geometric part of a contact point: positions, gap, normal, shape functions of both
    /// faces, stiffness E/h of both cells in series (doc/theory, (3.11)) and second variation of
    /// the gap (5.7).
    /// @param patch slave face in the current configuration; @param rest in the reference
    /// configuration
    /// @param stiffness E/h of the slave cell [force/length^3]
    template <int dim>
    ContactPoint<dim>
    contact_point(const FacePatch<dim>   &patch,
                  const FacePatch<dim>   &rest,
                  const PairedPoint<dim> &paired,
                  const double            stiffness,
                  const Trace<dim>       &trace)
    {
      const MasterProjection<dim> &master_point = paired.master_point;
      const Point<dim>             x            = patch.position(paired.xi);
      ContactPoint<dim>            point;
      point.position           = rest.position(paired.xi);
      point.master_position    = master_point.rest;
      point.slave_force_point  = point.position;
      point.master_force_point = master_point.rest;
      point.normal             = master_point.normal;
      point.weight             = paired.weight;
      point.normal_alignment   = -(patch.normal(paired.xi) * master_point.normal);
      point.gap                = gap_of(x, master_point);
      point.stiffness          = 1 / (1 / stiffness + 1 / master_point.stiffness);
      point.direction          = master_point.normal;
      point.slave              = trace.functions(paired.xi);
      point.master             = master_point.functions;
      point.rigid              = master_point.rigid;
      point.second_variation   = master_point.functions.empty() ?
                                   master_point.second_variation :
                                   second_variation_of_bodies(x, master_point);
      point.face               = paired.face;
      point.xi                 = paired.xi;
      return point;
    }

    /// Set the stress to the mean of both bodies' stresses whose bound is the smallest: each is
    /// weighted with the inverse of its bound (doc/theory, (2.13)), so that a stiff body has no
    /// influence beside a soft one, whichever is the slave. The weight of the slave is 1 against a
    /// rigid obstacle and in the unbiased form.
    ///
    /// At finite strain (6.13) it is multiplied by the area ratio j of the slave, since contact
    /// pressures act on reference areas. Its linearisation is j ds + s dj (6.14); the offset makes
    /// it exact at the present displacement.
    template <int dim>
    void
    set_stress(const BodyStress            &own,
               const double                 own_bound,
               const MasterProjection<dim> &master_point,
               const bool                   own_alone,
               ContactPoint<dim>           &point)
    {
      const double    bound = own.stiffening * own_bound;
      const double    share = own_alone || std::isinf(master_point.bound) ?
                                1. :
                                master_point.bound / (bound + master_point.bound);
      const StressRow none;
      point.bound = share * bound;
      for (unsigned int a = 0; a < own.components.size(); ++a)
        {
          const StressRow &of_slave  = own.components[a],
                          &of_master = share < 1 ? master_point.stress[a] : none;
          StressRow &mean            = point.stress.emplace_back();
          for (const auto part :
               {&StressRow::displacement, &StressRow::thermal, &StressRow::volumetric})
            {
              for (const auto &[index, value] : of_slave.*part)
                (mean.*part).emplace_back(index, share * value * own.ratio);
              for (const auto &[index, value] : of_master.*part)
                (mean.*part).emplace_back(index, (1 - share) * value * own.ratio);
            }
          mean.value = share * of_slave.value + (1 - share) * of_master.value;
          // The stress times the derivative of j.
          for (const auto &[index, entry] : own.ratio_row)
            mean.displacement.emplace_back(index, mean.value * entry);
          for (SparseRow *row : {&mean.displacement, &mean.thermal, &mean.volumetric})
            sum_duplicates(*row);
          mean.offset = own.ratio * (share * of_slave.offset + (1 - share) * of_master.offset) +
                        mean.value * (own.ratio_offset - own.ratio);
        }
    }

    /// The current area per reference area at a point of the slave, the ratio of the Jacobians of
    /// the face; axisymmetric: times that of the circumferences, except on the axis.
    template <int dim>
    double
    stretch(const Model           model,
            const FacePatch<dim> &now,
            const FacePatch<dim> &rest,
            const Point<dim - 1> &xi)
    {
      const double along = now.jacobian(xi) / rest.jacobian(xi), radius = rest.position(xi)[0];
      return model == Model::axisymmetric && radius > 1e-10 * std::abs(rest.position(xi)[1]) ?
               along * now.position(xi)[0] / radius :
               along;
    }

    /// The circumference 2 pi r at a point in axisymmetric models, otherwise 1. With nodal
    /// quadrature it is the mean of 2 pi r weighted with the shape function of the node, of degree
    /// k, so that a node on the axis has an area as well (doc/theory, 3.2).
    template <int dim>
    double
    circumference(const Elasticity<dim> &elasticity,
                  const FacePatch<dim>  &patch,
                  const Point<dim - 1>  &xi,
                  const Integration     &integration,
                  const unsigned int     k)
    {
      const Model model = elasticity.model();
      if (model != Model::axisymmetric || integration.rule != Rule::nodes)
        return measure(model, patch.position(xi));
      // Nodes of degrees 1 and 2 are equidistant, so that the parameter tells the number of the
      // node.
      const unsigned int    node = std::lround(xi[0] * k);
      const QGauss<dim - 1> rule(k + 2);
      double                sum = 0, area = 0;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const double share = rule.weight(q) *
                               LagrangePolynomials<dim - 1>(k, rule.point(q)).value(node) *
                               patch.jacobian(rule.point(q));
          area += share;
          sum += share * measure(model, patch.position(rule.point(q)));
        }
      return sum / area;
    }

  } // namespace



  template <int dim>
  double
  gap_of(const Point<dim> &x, const MasterProjection<dim> &master_point)
  {
    // A gap that is rounding of the coordinates counts as closed, so that surfaces that coincide in
    // the scene have no points with gaps of either sign.
    const double gap      = (x - master_point.position) * master_point.normal;
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * x.norm();
    return std::abs(gap) <= rounding ? 0. : gap;
  }



  // Weights that were computed on current faces become those of reference areas, over which
  // pressures are integrated.
  template <int dim>
  void
  weigh_by_reference_area(const BoundaryFaces<dim> &slave, std::vector<PairedPoint<dim>> &paired)
  {
    for (PairedPoint<dim> &point : paired)
      point.weight *=
        slave.rest[point.face].jacobian(point.xi) / slave.patches[point.face].jacobian(point.xi);
  }



  // The points of a pair with all that rows, forces and stresses need of them. Local: what belongs
  // to the master came with the projections.
  template <int dim>
  std::vector<ContactPoint<dim>>
  contact_points(const Configuration<dim>            &configuration,
                 const ContactPair<dim>              &pair,
                 const ContactMethod                 &method,
                 const BoundaryFaces<dim>            &slave,
                 const Integration                   &integration,
                 const std::vector<PairedPoint<dim>> &paired_points,
                 const std::vector<double>           &reference_gaps)
  {
    const Elasticity<dim>         &elasticity = configuration.elasticity();
    std::vector<ContactPoint<dim>> result;
    result.reserve(paired_points.size());
    double                face_depth = 0, face_stiffness = 0;
    Trace<dim>            trace(elasticity);
    const bool            with_stress = method.pressure_shift() == PressureShift::normal_stress;
    StressBounds<dim>     bound(slave, method.uses_slip());
    const InitialGap<dim> initial_gap(pair);
    std::optional<Tensor<2, dim>> turn;
    if (pair.image.turns())
      turn = pair.image.turn();
    std::optional<NormalStress<dim>> of_body;
    std::optional<SurfaceLoads<dim>> loads;
    // Stresses of the slave cells and loads on their faces are evaluated only for methods that use
    // them.
    if (with_stress)
      {
        of_body.emplace(configuration);
        loads.emplace(surface_loads(elasticity));
      }
    for (const PairedPoint<dim> &paired : paired_points)
      {
        const auto &[cell, face] = slave.faces[paired.face];
        const auto &rest         = slave.rest[paired.face];
        // Points are sorted by faces: what depends on the face is computed once for each.
        const bool is_new = result.empty() || result.back().face != paired.face;
        if (is_new)
          {
            trace.reinit(cell, face);
            face_stiffness = slave.stiffness(elasticity, paired.face);
            face_depth     = slave.depth(paired.face);
          }
        result.push_back(
          contact_point(slave.patches[paired.face], rest, paired, face_stiffness, trace));
        ContactPoint<dim> &point = result.back();
        point.depth              = face_depth;
        point.turn               = turn;
        if (elasticity.is_finite_strain())
          {
            point.slave_force_point  = slave.patches[paired.face].position(paired.xi);
            point.master_force_point = paired.master_point.position;
            point.stretch =
              stretch(elasticity.model(), slave.patches[paired.face], rest, paired.xi);
          }
        point.weight *=
          circumference(elasticity, rest, paired.xi, integration, cell->get_fe().degree);
        // The gap has two parts: the reference gap, which settings of the pair may change, and its
        // decrease since.
        if (!reference_gaps.empty())
          {
            point.gap_decrease = reference_gaps[result.size() - 1] - point.gap;
            point.gap          = reference_gaps[result.size() - 1];
          }
        // What the settings prescribe beyond the geometry is kept, for comparison with true gaps
        // later.
        const double of_geometry = point.gap;
        point.gap                = initial_gap(point.position, elasticity.time(), of_geometry);
        point.prescribed_gap     = point.gap - of_geometry;
        if (!with_stress)
          continue;
        NormalStress<dim> &stress = *of_body;
        if (is_new)
          stress.reinit(cell);
        const auto load = loads->at(*cell, face, point.position);
        set_stress(stress.at(unit_point<dim>(cell->reference_cell(), face, paired.xi),
                             stress_directions(paired.master_point.normal, method.uses_slip()),
                             rest.normal(paired.xi),
                             load),
                   bound(stress, paired.face),
                   paired.master_point,
                   method.unbiased(),
                   point);
      }
    return result;
  }



#define INSTANTIATE(dim)                                                                             \
  template double                         gap_of(const Point<dim> &, const MasterProjection<dim> &); \
  template void                           weigh_by_reference_area(const BoundaryFaces<dim> &,        \
                                                                  std::vector<PairedPoint<dim>> &);  \
  template std::vector<ContactPoint<dim>> contact_points(const Configuration<dim> &,                 \
                                                         const ContactPair<dim> &,                   \
                                                         const ContactMethod &,                      \
                                                         const BoundaryFaces<dim> &,                 \
                                                         const Integration &,                        \
                                                         const std::vector<PairedPoint<dim>> &,      \
                                                         const std::vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
