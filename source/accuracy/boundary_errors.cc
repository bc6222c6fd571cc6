// SPDX-License-Identifier: Apache-2.0
#include "accuracy/error_parts.h"
#include "solid/scalar_elements.h"
#include "solid/stress_state.h"
#include <signorini/solid/model.h>

#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Displacement, its gradient and stress at the quadrature points of a face, one entry for
    /// each; the stress is that of the first Piola and Kirchhoff, or its change for dual fields.
    template <int dim>
    struct AtFace
    {
      std::vector<Tensor<1, dim>> u;
      std::vector<Tensor<2, dim>> gradient_in_plane;
      std::vector<Tensor<2, 3>>   gradient, stress;

      /// @return the product of the stress, or of the gradient, with n at point q, in the plane or
      /// space of the model.
      static Tensor<1, dim>
      product(const Tensor<2, 3> &tensor, const Tensor<1, dim> &n)
      {
        Tensor<1, dim> result;
        for (unsigned int a = 0; a < dim; ++a)
          for (unsigned int b = 0; b < dim; ++b)
            result[a] += tensor[a][b] * n[b];
        return result;
      }

      Tensor<1, dim>
      traction(const unsigned int q, const Tensor<1, dim> &n) const
      {
        return product(stress[q], n);
      }

      Tensor<1, dim>
      slope(const unsigned int q, const Tensor<1, dim> &n) const
      {
        return product(gradient[q], n);
      }
    };

    /// Integrates (8.7) of doc/theory over the locally owned cells. Each function evaluates one
    /// face, so that the FEFaceValues objects are reinitialised often; the cost is proportional to
    /// the number of boundary faces.
    template <int dim>
    class Boundaries
    {
    public:
      Boundaries(const Elasticity<dim>        &elasticity,
                 const LA::Vector             &displacement,
                 const std::vector<DualField> &duals);

      BoundaryErrors
      errors();

    private:
      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      /// @return displacement and gradient of a field at the points of a face.
      AtFace<dim>
      values_of(const LA::Vector &ghosted, const FEFaceValues<dim> &at) const;
      /// @return the solution at the points of a face.
      /// @param states of stress there: out
      AtFace<dim>
      solution_at(const Cell               &cell,
                  const FEFaceValues<dim>  &at,
                  std::vector<StressState> &states) const;
      /// @return a dual field there.
      AtFace<dim>
      dual_at(const DualField                &dual,
              const Cell                     &cell,
              const FEFaceValues<dim>        &at,
              const std::vector<StressState> &states) const;
      /// @return at each point the thickness of the strip between the cell and the true boundary,
      /// along the normal of the cell; positive where the cell omits a part of the body. Values of
      /// the size of rounding are zero.
      std::vector<double>
      thickness(const Cell &cell, const unsigned int face, const FEFaceValues<dim> &at);
      /// @return at each point of a face towards a coarser neighbour the distance to the face of
      /// that neighbour, along the normal: a hanging node is on the curved surface, of which the
      /// straight face of the neighbour cuts off a part.
      std::vector<double>
      distance_to_neighbour(const Cell &cell, const unsigned int face, const FEFaceValues<dim> &at);
      /// Add the error of a strip of the given thickness at each point.
      void
      add_strip(const Cell                &cell,
                const unsigned int         face,
                const std::vector<double> &strip,
                BoundaryErrors            &errors);
      /// Add the errors of one boundary face: its strip, and its supports.
      void
      add_boundary(const Cell &cell, const unsigned int face, BoundaryErrors &errors);
      /// @return values at the points of a face; valid until the next call.
      const FEFaceValues<dim> &
      reinit(const Cell &cell, const unsigned int face)
      {
        return reinit(cell, face, values);
      }
      static const FEFaceValues<dim> &
      reinit(const Cell &cell, const unsigned int face, hp::FEFaceValues<dim> &of)
      {
        const auto i = cell->active_fe_index();
        of.reinit(cell, face, i, 0, i); // one mapping for all
        return of.get_present_fe_values();
      }
      /// @return the prescribed minus the computed displacement at each point, in the components
      /// that supports prescribe; zero in the others.
      std::vector<Tensor<1, dim>>
      boundary_residual(const std::vector<const Support<dim> *> &supports,
                        const AtFace<dim>                       &u,
                        const FEFaceValues<dim>                 &at) const;

      const Elasticity<dim> &elasticity;
      /// The displacement with ghost values.
      const LA::Vector displacement;
      /// The dual fields with ghost values.
      std::vector<DualField>         duals;
      const hp::QCollection<dim - 1> all_rules;
      hp::FEFaceValues<dim>          values, true_values;
      /// At more points, that show what supports prescribe between the usual ones.
      hp::FEFaceValues<dim>                                           values_at_supports;
      hp::FESubfaceValues<dim>                                        neighbour_values;
      std::map<types::boundary_id, std::vector<const Support<dim> *>> supports;
    };



    template <int dim>
    Boundaries<dim>::Boundaries(const Elasticity<dim>        &elasticity,
                                const LA::Vector             &u,
                                const std::vector<DualField> &z)
      : elasticity(elasticity)
      , displacement(elasticity.with_ghosts(u))
      , all_rules(gauss_rules_of_faces(elasticity.finite_elements(), 1))
      , values(elasticity.mesh().mappings(),
               elasticity.finite_elements(),
               all_rules,
               update_values | update_gradients | update_quadrature_points | update_normal_vectors |
                 update_JxW_values)
      , true_values(elasticity.mesh().surface_mappings(),
                    elasticity.finite_elements(),
                    all_rules,
                    update_quadrature_points)
      , values_at_supports(elasticity.mesh().mappings(),
                           elasticity.finite_elements(),
                           gauss_rules_of_faces(elasticity.finite_elements(), 4),
                           values.get_update_flags())
      , neighbour_values(elasticity.mesh().mappings(),
                         elasticity.finite_elements(),
                         all_rules,
                         update_quadrature_points)
    {
      for (const DualField &one : z)
        duals.push_back(with_ghosts(elasticity, one));
      for (const Support<dim> &support : elasticity.supports())
        if (support.type != SupportType::symmetry && support.acts(elasticity.time_of_supports()))
          for (const std::string &boundary : support.boundaries)
            if (elasticity.mesh().body_of(boundary))
              for (const types::boundary_id id : elasticity.mesh().boundary_ids(boundary))
                supports[id].push_back(&support);
    }



    template <int dim>
    AtFace<dim>
    Boundaries<dim>::values_of(const LA::Vector &ghosted, const FEFaceValues<dim> &at) const
    {
      const FEValuesExtractors::Vector v(0);
      const unsigned int               n = at.n_quadrature_points;
      AtFace<dim>                      result;
      result.u.resize(n);
      result.gradient_in_plane.resize(n);
      at[v].get_function_values(ghosted, result.u);
      at[v].get_function_gradients(ghosted, result.gradient_in_plane);
      for (unsigned int q = 0; q < n; ++q)
        result.gradient.push_back(gradient_of_change(
          elasticity.model(), result.gradient_in_plane[q], result.u[q], at.quadrature_point(q)));
      return result;
    }



    template <int dim>
    AtFace<dim>
    Boundaries<dim>::solution_at(const Cell               &cell,
                                 const FEFaceValues<dim>  &at,
                                 std::vector<StressState> &states) const
    {
      AtFace<dim> result = values_of(displacement, at);
      states.clear();
      for (const unsigned int q : at.quadrature_point_indices())
        {
          states.push_back(stress_state(
            elasticity, *cell, result.gradient_in_plane[q], result.u[q], at.quadrature_point(q)));
          result.stress.push_back(states[q].stress);
        }
      return result;
    }



    // Stresses of dual fields are linearised at the solution, so that its states are needed, and
    // thermal strain, which does not change with the displacement, is not in them.
    template <int dim>
    AtFace<dim>
    Boundaries<dim>::dual_at(const DualField                &dual,
                             const Cell                     &cell,
                             const FEFaceValues<dim>        &at,
                             const std::vector<StressState> &states) const
    {
      AtFace<dim> result = values_of(dual.displacement, at);
      for (const unsigned int q : at.quadrature_point_indices())
        result.stress.push_back(
          states[q].change_of_stress(result.gradient[q],
                                     states[q].is_mixed ?
                                       elasticity.volumetric_stress().value(
                                         *cell, at.quadrature_point(q), dual.volumetric_stress) :
                                       0.));
      return result;
    }



    template <int dim>
    std::vector<double>
    Boundaries<dim>::thickness(const Cell              &cell,
                               const unsigned int       face,
                               const FEFaceValues<dim> &at)
    {
      const auto i = cell->active_fe_index();
      true_values.reinit(
        static_cast<const typename Triangulation<dim>::cell_iterator &>(cell), face, i, 0, i);
      const FEFaceValues<dim> &surface = true_values.get_present_fe_values();
      std::vector<double>      result;
      for (const unsigned int q : at.quadrature_point_indices())
        {
          const double d =
            (surface.quadrature_point(q) - at.quadrature_point(q)) * at.normal_vector(q);
          result.push_back(std::abs(d) > 1e-13 * cell->diameter() ? d : 0.);
        }
      return result;
    }



    // Roller supports prescribe one direction, others components.
    template <int dim>
    std::vector<Tensor<1, dim>>
    Boundaries<dim>::boundary_residual(const std::vector<const Support<dim> *> &of_face,
                                       const AtFace<dim>                       &u,
                                       const FEFaceValues<dim>                 &at) const
    {
      std::vector<Tensor<1, dim>> result(at.n_quadrature_points);
      const double                t = elasticity.time();
      for (const unsigned int q : at.quadrature_point_indices())
        for (const Support<dim> *support : of_face)
          {
            const Point<dim> &x = at.quadrature_point(q);
            if (support->type == SupportType::roller)
              {
                const Tensor<1, dim> n = support->direction.norm() > 0 ?
                                           support->direction / support->direction.norm() :
                                           at.normal_vector(q);
                result[q] = (support->normal_displacement.value(x, t) - u.u[q] * n) * n;
                continue;
              }
            const Tensor<1, dim> wanted = support->displacement_at(x, t);
            const Tensor<2, dim> axes   = support->axes.at(x);
            for (unsigned int d = 0; d < dim; ++d)
              if (support->displacement.prescribed(d))
                result[q] += ((wanted - u.u[q]) * axes[d] - result[q] * axes[d]) * axes[d];
          }
      return result;
    }



    // The same quadrature points on the subface of the coarser neighbour, by its own mapping.
    template <int dim>
    std::vector<double>
    Boundaries<dim>::distance_to_neighbour(const Cell              &cell,
                                           const unsigned int       face,
                                           const FEFaceValues<dim> &at)
    {
      const auto [number, part] = cell->neighbor_of_coarser_neighbor(face);
      const auto neighbour      = cell->neighbor(face);
      const auto i              = cell->active_fe_index(); // of the same body
      neighbour_values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(
                                neighbour),
                              number,
                              part,
                              i,
                              0,
                              i);
      const auto         &there = neighbour_values.get_present_fe_values();
      std::vector<double> result;
      for (const unsigned int q : at.quadrature_point_indices())
        {
          const double d =
            (there.quadrature_point(q) - at.quadrature_point(q)) * at.normal_vector(q);
          result.push_back(std::abs(d) > 1e-13 * cell->diameter() ? d : 0.);
        }
      return result;
    }



    /// Subtract the integral of d (sigma(u):eps(z) - sigma(u) n.dz/dn - sigma(z) n.du/dn) over the
    /// face, the second of (8.7): the change of the bilinear form by the strip (Hadamard's
    /// formula), less what tractions and supports on its two sides contribute; and (8.22).
    template <int dim>
    void
    Boundaries<dim>::add_strip(const Cell                &cell,
                               const unsigned int         face,
                               const std::vector<double> &strip,
                               BoundaryErrors            &errors)
    {
      if (std::all_of(strip.begin(), strip.end(), [](const double d) { return d == 0; }))
        return;
      const FEFaceValues<dim> &at = reinit(cell, face);
      std::vector<StressState> states;
      const AtFace<dim>        u = solution_at(cell, at, states);
      for (const unsigned int q : at.quadrature_point_indices())
        errors.of_energy[cell->active_cell_index()] +=
          at.JxW(q) * measure(elasticity.model(), at.quadrature_point(q)) * strip[q] *
          (states[q].energy - u.traction(q, at.normal_vector(q)) * u.slope(q, at.normal_vector(q)));
      for (unsigned int k = 0; k < duals.size(); ++k)
        {
          const AtFace<dim> z = dual_at(duals[k], cell, at, states);
          for (const unsigned int q : at.quadrature_point_indices())
            {
              const Tensor<1, dim> &n = at.normal_vector(q);
              errors.of_geometry[k][cell->active_cell_index()] -=
                at.JxW(q) * measure(elasticity.model(), at.quadrature_point(q)) * strip[q] *
                (scalar_product(u.stress[q], z.gradient[q]) - u.traction(q, n) * z.slope(q, n) -
                 z.traction(q, n) * u.slope(q, n));
            }
        }
    }



    // Formulas of supports may have more between the nodes than the usual points show, such as a
    // bump that is narrower than a cell: hence a rule with more points than that of the strips.
    // Conditions of supports are compared with the computed displacement on the boundary of the
    // cells.
    template <int dim>
    void
    Boundaries<dim>::add_boundary(const Cell &cell, const unsigned int face, BoundaryErrors &errors)
    {
      add_strip(cell, face, thickness(cell, face, reinit(cell, face)), errors);
      const auto of_face = supports.find(cell->face(face)->boundary_id());
      if (of_face == supports.end())
        return;
      const FEFaceValues<dim>          &at = reinit(cell, face, values_at_supports);
      std::vector<StressState>          states;
      const AtFace<dim>                 u       = solution_at(cell, at, states);
      const std::vector<Tensor<1, dim>> lacking = boundary_residual(of_face->second, u, at);
      for (unsigned int k = 0; k < duals.size(); ++k)
        {
          const AtFace<dim> z = dual_at(duals[k], cell, at, states);
          for (const unsigned int q : at.quadrature_point_indices())
            errors.of_supports[k][cell->active_cell_index()] -=
              at.JxW(q) * measure(elasticity.model(), at.quadrature_point(q)) *
              (lacking[q] * z.traction(q, at.normal_vector(q)));
        }
    }



    // Only faces at the boundary and faces towards coarser neighbours contribute.
    template <int dim>
    BoundaryErrors
    Boundaries<dim>::errors()
    {
      const unsigned int n = elasticity.mesh().triangulation().n_active_cells();
      BoundaryErrors     result;
      result.of_supports.assign(duals.size(), std::vector<double>(n, 0.));
      result.of_geometry = result.of_supports;
      result.of_energy.assign(n, 0.);
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            {
              if (cell->face(f)->at_boundary())
                add_boundary(cell, f, result);
              else if (cell->neighbor_is_coarser(f))
                add_strip(cell, f, distance_to_neighbour(cell, f, reinit(cell, f)), result);
            }
      return result;
    }
  } // namespace



  template <int dim>
  BoundaryErrors
  boundary_errors(const Elasticity<dim>        &elasticity,
                  const LA::Vector             &displacement,
                  const std::vector<DualField> &duals)
  {
    return Boundaries<dim>(elasticity, displacement, duals).errors();
  }



  template BoundaryErrors
  boundary_errors(const Elasticity<2> &, const LA::Vector &, const std::vector<DualField> &);
  template BoundaryErrors
  boundary_errors(const Elasticity<3> &, const LA::Vector &, const std::vector<DualField> &);
} // namespace Signorini
