// SPDX-License-Identifier: Apache-2.0
#include "solid/thermal_strain.h"

#include "geometry/cell_rule.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // No time compares equal to it: temperatures are not evaluated yet.
    constexpr double never = std::numeric_limits<double>::quiet_NaN();

    /// Finite element values on the cells of a material, with points and weights only, by the rule
    /// that integrates loads.
    template <int dim>
    FEValues<dim>
    points_in_cells(const Mesh<dim> &mesh, const unsigned int id, const unsigned int degree)
    {
      const ReferenceCell          shape = mesh.reference_cell(mesh.body_of_material(id));
      static const FE_Nothing<dim> cubes(ReferenceCells::get_hypercube<dim>()),
        simplices(ReferenceCells::get_simplex<dim>());
      return FEValues<dim>(mesh.mapping(),
                           shape.is_simplex() ? simplices : cubes,
                           cell_rule<dim>(shape, degree + 2),
                           update_quadrature_points | update_JxW_values);
    }

    /// Call visit(cell) for the locally owned and ghost cells of a material.
    template <int dim, typename Visit>
    void
    for_known_cells(const Mesh<dim> &mesh, const unsigned int id, const Visit &visit)
    {
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        if (!cell->is_artificial() && cell->material_id() == id)
          visit(cell);
    }
  } // namespace



  // Coefficients are stored for all cells with the same stride: the constant alone if all bodies
  // have degree 1, otherwise the constant and one slope for each direction, of which cells of
  // degree 1 use the first only.
  template <int dim>
  ThermalStrain<dim>::ThermalStrain(const Mesh<dim>                          &mesh,
                                    const std::vector<ThermalExpansion<dim>> &expansions,
                                    const std::vector<unsigned int>          &degrees,
                                    const Model                               model)
    : mesh(mesh)
    , expansions(expansions)
    , degrees(degrees)
    , model(model)
    , n_coefficients(*std::max_element(degrees.begin(), degrees.end()) > 1 ? dim + 1 : 1)
    , times(expansions.size(), never)
  {}



  template <int dim>
  bool
  ThermalStrain<dim>::any() const
  {
    return std::any_of(expansions.begin(), expansions.end(), [](const auto &one) {
      return one.given();
    });
  }



  // Discard all coefficients, since they belong to another mesh.
  template <int dim>
  void
  ThermalStrain<dim>::reinit()
  {
    if (any())
      of_cells.assign(mesh.triangulation().n_active_cells() * n_coefficients, 0.);
    std::fill(times.begin(), times.end(), never);
  }



  // The polynomials 1 and (x - center)/diameter of a cell; degree 1 of the displacement has the
  // constant only.
  template <int dim>
  typename ThermalStrain<dim>::Monomials
  ThermalStrain<dim>::monomials(const Cell &cell, const Point<dim> &x) const
  {
    Monomials result{{1.}};
    if (n_coefficients == 1)
      return result;
    // Scaled to the cell, so that the mass matrix of the fit is well conditioned whatever the unit
    // of length and the distance from the origin are.
    const Tensor<1, dim> place = (x - cell.center()) / cell.diameter();
    for (unsigned int d = 0; d < dim; ++d)
      result[1 + d] = place[d];
    return result;
  }



  // The temperature at a quadrature point: the formula of the material, with the value of the field
  // from the mesh file if it refers to one.
  template <int dim>
  double
  ThermalStrain<dim>::temperature(const FEValues<dim> &values,
                                  const unsigned int   q,
                                  const double         t) const
  {
    const auto                   cell  = values.get_cell();
    const ThermalExpansion<dim> &one   = expansions[cell->material_id()];
    const double                 field = one.depends_on_field() ?
                                           mesh.temperature().value(cell->id(), values.get_quadrature().point(q)) :
                                           0.;
    return one.value(values.quadrature_point(q), t, field);
  }



  // A formula may fail on one rank only; the positions are gathered, so that all ranks throw the
  // same error together. Collective.
  template <int dim>
  void
  ThermalStrain<dim>::throw_if_invalid(const unsigned int             id,
                                       const double                   t,
                                       const std::vector<Point<dim>> &bad) const
  {
    for (const auto &of_rank : Utilities::MPI::all_gather(mesh.communicator(), bad))
      if (!of_rank.empty())
        {
          std::ostringstream where;
          where << "at (" << of_rank[0] << "), t = " << t;
          throw SceneError(expansions[id].place + ": the temperature is not a number " +
                           where.str() + "; correct the formula");
        }
  }



  // L2 projection of T - T_0 onto polynomials of one degree less than the displacement (doc/theory,
  // (6.12)), by the normal equations of the cell. Missing coefficients of degree 1 stay zero.
  template <int dim>
  void
  ThermalStrain<dim>::fit(const FEValues<dim> &values,
                          const double         t,
                          const unsigned int   degree,
                          double              *result)
  {
    const auto         cell = values.get_cell();
    const unsigned int n    = degree > 1 ? n_coefficients : 1;
    FullMatrix<double> mass(n, n);
    Vector<double>     rhs(n), coefficients(n);
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &x      = values.quadrature_point(q);
        const Monomials   phi    = monomials(*cell, x);
        const double      weight = values.JxW(q) * measure(model, x);
        const double      temperature_change =
          temperature(values, q, t) - expansions[cell->material_id()].reference;
        for (unsigned int i = 0; i < n; ++i)
          {
            rhs[i] += weight * phi[i] * temperature_change;
            for (unsigned int j = 0; j < n; ++j)
              mass(i, j) += weight * phi[i] * phi[j];
          }
      }
    mass.gauss_jordan();
    mass.vmult(coefficients, rhs);
    std::copy(coefficients.begin(), coefficients.end(), result);
  }



  template <int dim>
  void
  ThermalStrain<dim>::set_time(const double t)
  {
    // Each material is evaluated only if its time has changed and its temperature depends on time
    // or has never been evaluated. Ghost cells are evaluated as well, which needs no exchange.
    for (unsigned int id = 0; id < expansions.size(); ++id)
      {
        const ThermalExpansion<dim> &one = expansions[id];
        if (!one.given() || times[id] == t || (!std::isnan(times[id]) && !one.depends_on_time()))
          continue;
        times[id] = t;
        ++my_version;
        std::vector<Point<dim>> bad;
        FEValues<dim>           values = points_in_cells(mesh, id, degrees[id]);
        // A uniform temperature needs no projection.
        const double uniform = one.depends_on_place() ? 0. : one.value({}, t, 0);
        for_known_cells(mesh, id, [&](const auto &cell) {
          double *own = &of_cells[cell->active_cell_index() * n_coefficients];
          if (one.depends_on_place())
            {
              values.reinit(cell);
              fit(values, t, degrees[id], own);
            }
          else
            own[0] = uniform - one.reference;
          if (!std::all_of(own, own + n_coefficients, [](const double c) {
                return std::isfinite(c);
              }))
            bad.assign(1, cell->center());
        });
        throw_if_invalid(id, t, bad);
        throw_if_vanishing(id);
      }
  }



  // Stretches 1 + alpha_i (T - T_0) must be positive.
  template <int dim>
  void
  ThermalStrain<dim>::throw_if_vanishing(const unsigned int id) const
  {
    double least = 0;
    for_known_cells(mesh, id, [&](const auto &cell) {
      const Tensor<1, 3> of_axes = strain(*cell, cell->center());
      for (unsigned int i = 0; i < 3; ++i)
        least = std::min(least, of_axes[i]);
    });
    least = Utilities::MPI::min(least, mesh.communicator());
    if (least <= -0.9)
      throw SceneError(
        expansions[id].place + ": the thermal strain " + short_text(least) +
        " would leave nothing of the body; correct Thermal expansion, Temperature or "
        "Reference temperature");
  }



  // The fitted polynomial at a point [temperature], zero in materials that do not expand. This, and
  // not the formula itself, is the temperature that loads, stresses and errors see.
  template <int dim>
  double
  ThermalStrain<dim>::temperature_change(const Cell &cell, const Point<dim> &x) const
  {
    if (!expands(cell.material_id()))
      return 0;
    const Monomials phi = monomials(cell, x);
    const double   *own = &of_cells[cell.active_cell_index() * n_coefficients];
    double          sum = 0;
    for (unsigned int i = 0; i < n_coefficients; ++i)
      sum += own[i] * phi[i];
    return sum;
  }



  template <int dim>
  double
  ThermalStrain<dim>::projection_error(const FEValues<dim> &values, const unsigned int q) const
  {
    const auto                   cell = values.get_cell();
    const ThermalExpansion<dim> &one  = expansions[cell->material_id()];
    if (!one.given() || !one.depends_on_place())
      return 0;
    return temperature(values, q, times[cell->material_id()]) - one.reference -
           temperature_change(*cell, values.quadrature_point(q));
  }



  // Normal components along x, y, z (axisymmetric: radial, axial, hoop); thermal expansion causes
  // no shear.
  template <int dim>
  Tensor<1, 3>
  ThermalStrain<dim>::strain(const Cell &cell, const Point<dim> &x) const
  {
    if (!expands(cell.material_id()))
      return {};
    return temperature_change(cell, x) * expansions[cell.material_id()].alpha();
  }



  // The stretches of the axes are 1 + alpha_i (T - T_0).
  template <int dim>
  double
  ThermalStrain<dim>::volume_ratio(const Cell &cell, const Point<dim> &x) const
  {
    const Tensor<1, 3> of_axes = strain(cell, x);
    return (1 + of_axes[0]) * (1 + of_axes[1]) * (1 + of_axes[2]);
  }



  // sigma_i = lambda sum_j alpha_j + 2 mu alpha_i. In plane stress the thickness expands freely, so
  // that only in-plane components contribute and act.
  template <int dim>
  Tensor<1, 3>
  ThermalStrain<dim>::stress_of_unit_rise(const Material &material, const unsigned int id) const
  {
    const bool         is_sheet = model == Model::plane_stress;
    const Tensor<1, 3> alpha    = expansions[id].alpha();
    const double       sum      = alpha[0] + alpha[1] + (is_sheet ? 0 : alpha[2]);
    Tensor<1, 3>       result;
    for (unsigned int i = 0; i < (is_sheet ? 2 : 3); ++i)
      result[i] = in_plane_lambda(model, material) * sum + 2 * material.mu() * alpha[i];
    return result;
  }



  // The temperature rise at a point as a linear combination of the coefficients of all cells, by
  // their global numbers. With it the thermal part of the normal stress is a matrix, and a load
  // step only multiplies it by new coefficients.
  template <int dim>
  std::vector<std::pair<types::global_dof_index, double>>
  ThermalStrain<dim>::row(const Cell &cell, const Point<dim> &x) const
  {
    const Monomials                                         phi = monomials(cell, x);
    std::vector<std::pair<types::global_dof_index, double>> result;
    for (unsigned int i = 0; i < n_coefficients; ++i)
      result.emplace_back(cell.global_active_cell_index() * n_coefficients + i, phi[i]);
    return result;
  }



  // The coefficients of active cells are numbered as the cells are globally, rank by rank.
  template <int dim>
  IndexSet
  ThermalStrain<dim>::owned() const
  {
    // Active cells are numbered rank by rank.
    unsigned int n = 0;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      n += cell->is_locally_owned();
    return LA::contiguous_partition(n * n_coefficients, mesh.communicator());
  }



  // The vector that the rows of row() refer to: in the order of the cells, those that this rank
  // owns. Collective.
  template <int dim>
  LA::Vector
  ThermalStrain<dim>::coefficients() const
  {
    // Local arrays are numbered by active cells of this rank, including ghosts; the vector by the
    // cells of all ranks.
    LA::Vector result(owned(), mesh.communicator());
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        for (unsigned int i = 0; i < n_coefficients; ++i)
          result(cell->global_active_cell_index() * n_coefficients + i) =
            of_cells[cell->active_cell_index() * n_coefficients + i];
    result.compress(VectorOperation::insert);
    return result;
  }



  // Uniform temperatures are known without the cells; others are sampled at the quadrature points,
  // with two reductions.
  template <int dim>
  std::pair<double, double>
  ThermalStrain<dim>::range(const unsigned int id, const double t) const
  {
    if (!expansions[id].depends_on_place())
      {
        const double T = expansions[id].value({}, t, 0);
        throw_if_invalid(id, t, std::vector<Point<dim>>(std::isfinite(T) ? 0 : 1));
        return {T, T};
      }
    // The highest value is stored with the opposite sign, so that both are reduced by the same
    // function.
    std::array<double, 2>   extremes{{std::numeric_limits<double>::max(),
                                      std::numeric_limits<double>::max()}}; // lowest, minus highest
    std::vector<Point<dim>> bad;
    FEValues<dim>           values = points_in_cells(mesh, id, degrees[id]);
    for_known_cells(mesh, id, [&](const auto &cell) {
      values.reinit(cell);
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const double T = temperature(values, q, t);
          if (!std::isfinite(T))
            bad.assign(1, values.quadrature_point(q));
          extremes[0] = std::min(extremes[0], T);
          extremes[1] = std::min(extremes[1], -T);
        }
    });
    throw_if_invalid(id, t, bad);
    return {Utilities::MPI::min(extremes[0], mesh.communicator()),
            -Utilities::MPI::min(extremes[1], mesh.communicator())};
  }



  template class ThermalStrain<2>;
  template class ThermalStrain<3>;
} // namespace Signorini
