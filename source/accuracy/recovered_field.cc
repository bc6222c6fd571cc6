// SPDX-License-Identifier: Apache-2.0
#include "accuracy/recovered_field.h"

#include "geometry/cell_rule.h"
#include "linear_algebra/dense.h"
#include <signorini/solid/model.h>

#include <algorithm>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The monomials of total degree up to 1, 2 or 3 in dim coordinates.
    template <int dim>
    class Monomials
    {
    public:
      static constexpr unsigned int linear = dim + 1, quadratic = linear * (dim + 2) / 2,
                                    cubic = quadratic * (dim + 3) / 3;
      using Values                        = std::array<double, cubic>;

      explicit Monomials(const unsigned int degree)
        : n(degree == 1 ? linear :
            degree == 2 ? quadratic :
                          cubic)
      {}

      /// @return the n monomials at a point; the remaining entries are undefined.
      Values
      operator()(const Tensor<1, dim> &x) const
      {
        Values value;
        value[0] = 1;
        for (unsigned int d = 0; d < dim; ++d)
          value[1 + d] = x[d];
        unsigned int next = linear;
        if (n >= quadratic)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int e = 0; e <= d; ++e)
              value[next++] = x[d] * x[e];
        if (n == cubic)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int e = 0; e <= d; ++e)
              for (unsigned int f = 0; f <= e; ++f)
                value[next++] = x[d] * x[e] * x[f];
        return value;
      }

      const unsigned int n;
    };

    /// @return the rules with 1 to `most` points in each direction, first of hypercubes, then of
    /// simplices.
    template <int dim>
    hp::QCollection<dim>
    rules_up_to(const unsigned int most)
    {
      hp::QCollection<dim> rules;
      for (const auto &cell :
           {ReferenceCells::get_hypercube<dim>(), ReferenceCells::get_simplex<dim>()})
        for (unsigned int n = 1; n <= most; ++n)
          rules.push_back(cell_rule<dim>(cell, n));
      return rules;
    }

    /// @return the number of sample points in each direction: the superconvergent points are those
    /// of the Gauss rule with `degree` points; at least two across a layer that is one cell thick,
    /// since one point would miss bending.
    template <int dim>
    unsigned int
    points_per_direction(const Elasticity<dim>                                &elasticity,
                         const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      const unsigned int degree = elasticity.degree(elasticity.mesh().body(cell));
      return is_one_cell_thick<dim>(cell) ? std::max(2u, degree) : degree;
    }

    /// @return the degree of the polynomials that are fitted in a cell. A patch is three cells
    /// wide, so that quadratic ones would often differ more from the exact field than its samples
    /// do: where displacements have degree two they are cubic, but not in patches of two cells in
    /// each direction, which are too few to tell what they miss, nor on simplices, whose patches
    /// are smaller.
    /// @param n_samples of the patch
    template <int dim>
    unsigned int
    degree_of_fit(const Elasticity<dim>                                &elasticity,
                  const typename DoFHandler<dim>::active_cell_iterator &cell,
                  const unsigned int                                    n_samples)
    {
      constexpr unsigned int enough = dim == 2 ? 24 : 96;
      const unsigned int     degree = elasticity.degree(elasticity.mesh().body(cell));
      return degree == 2 && n_samples >= enough && !cell->reference_cell().is_simplex() &&
                 !is_one_cell_thick<dim>(cell) ?
               3 :
               degree;
    }

    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// Coefficients that the patch does not determine, such as the slope across a body that is one
    /// cell thick, become zero by this small regularisation.
    void
    regularise(Matrix &N)
    {
      constexpr double rounding = 1e-9;
      for (int i = 0; i < N.rows(); ++i)
        N(i, i) += rounding * N(0, 0);
    }
  } // namespace



  template <int dim>
  bool
  is_one_cell_thick(const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    const auto is_end = [&](const unsigned int face) {
      return cell->face(face)->at_boundary() ||
             cell->neighbor(face)->material_id() != cell->material_id();
    };
    if (!cell->reference_cell().is_simplex())
      for (unsigned int d = 0; d < dim; ++d)
        if (is_end(2 * d) && is_end(2 * d + 1))
          return true;
    return false;
  }



  // The weights are N^-1 times the monomials at the point, with the normal matrix N.
  template <int dim>
  std::vector<RecoverySample<dim>>
  recovery_samples(const Elasticity<dim>                                &elasticity,
                   const typename DoFHandler<dim>::active_cell_iterator &cell,
                   const Point<dim>                                     &x)
  {
    // The patch is that of collect_patch(), found by one pass over the cells: a probe needs one.
    std::vector<bool> is_vertex(elasticity.mesh().triangulation().n_vertices(), false);
    for (const unsigned int v : cell->vertex_indices())
      is_vertex[cell->vertex_index(v)] = true;
    std::vector<RecoverySample<dim>> samples;
    for (const auto &other : elasticity.dof_handler().active_cell_iterators())
      {
        if (other->is_artificial() || other->material_id() != cell->material_id())
          continue;
        const auto vertices = other->vertex_indices();
        if (std::none_of(vertices.begin(), vertices.end(), [&](const unsigned int v) {
              return is_vertex[other->vertex_index(v)];
            }))
          continue;
        const Mapping<dim> &mapping = elasticity.mesh().mapping();
        for (const Point<dim> &unit :
             cell_rule<dim>(other->reference_cell(), points_per_direction(elasticity, other))
               .get_points())
          samples.push_back({other, unit, mapping.transform_unit_to_real_cell(other, unit), 0.});
      }
    // Not cubic: most probes are at boundaries, and beyond the last samples cubic polynomials
    // magnify their errors.
    const Monomials<dim> monomials(elasticity.degree(elasticity.mesh().body(cell)));
    const auto           at = [&](const Point<dim> &place) {
      const auto phi = monomials((place - cell->center()) / cell->diameter());
      return Eigen::VectorXd(Eigen::VectorXd::Map(phi.data(), monomials.n));
    };
    Matrix N = Matrix::Zero(monomials.n, monomials.n);
    for (const RecoverySample<dim> &sample : samples)
      N += at(sample.place) * at(sample.place).transpose();
    regularise(N);
    const Eigen::VectorXd coefficients = solve_symmetric(N, at(x));
    for (RecoverySample<dim> &sample : samples)
      sample.weight = coefficients.dot(at(sample.place));
    return samples;
  }



  // Fields are sampled once in all locally owned and ghost cells; each call of operator() then
  // fits the samples of one patch.
  template <int dim>
  RecoveredField<dim>::RecoveredField(const Elasticity<dim> &elasticity,
                                      const unsigned int     n_values,
                                      Sampler                sampler)
    : elasticity(elasticity)
    , n_values(n_values)
    , sampler(std::move(sampler))
    , rules(rules_up_to<dim>(elasticity.degree() + 1))
    , values(elasticity.mesh().mappings(),
             elasticity.finite_elements(),
             rules,
             update_values | update_gradients | update_quadrature_points | update_JxW_values)
  {
    sample();
    find_neighbours();
  }



  template <int dim>
  unsigned int
  RecoveredField<dim>::rule(const Cell &cell, const unsigned int points_per_direction) const
  {
    return (cell->reference_cell().is_simplex() ? rules.size() / 2 : 0) + points_per_direction - 1;
  }



  // All samples are in one array, cell by cell, point by point, with all components of all fields
  // together: one patch then reads contiguous pieces of memory.
  template <int dim>
  void
  RecoveredField<dim>::sample()
  {
    const auto &triangulation = elasticity.mesh().triangulation();
    first_sample.assign(triangulation.n_active_cells() + 1, 0);
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      {
        first_sample[cell->active_cell_index()] = places.size();
        if (cell->is_artificial())
          continue;
        values.reinit(cell, rule(cell, points_per_direction(elasticity, cell)));
        const FEValues<dim> &at     = values.get_present_fe_values();
        const auto          &points = at.get_quadrature_points();
        places.insert(places.end(), points.begin(), points.end());
        samples.resize(places.size() * n_values);
        sampler(cell, at, &samples[(places.size() - points.size()) * n_values]);
      }
    first_sample.back() = places.size();
  }



  // The cells at each vertex in compressed row storage, by a counting sort.
  template <int dim>
  void
  RecoveredField<dim>::find_neighbours()
  {
    const auto &triangulation = elasticity.mesh().triangulation();
    first_at_vertex.assign(triangulation.n_vertices() + 1, 0);
    const auto for_vertices = [&](const auto &visit) {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
            visit(cell->vertex_index(v), cell->active_cell_index());
    };
    for_vertices([&](const unsigned int v, unsigned int) { ++first_at_vertex[v + 1]; });
    for (unsigned int v = 0; v < triangulation.n_vertices(); ++v)
      first_at_vertex[v + 1] += first_at_vertex[v];
    cells_at_vertex.resize(first_at_vertex.back());
    std::vector<unsigned int> next = first_at_vertex;
    for_vertices(
      [&](const unsigned int v, const unsigned int cell) { cells_at_vertex[next[v]++] = cell; });
    material_of_cell.resize(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
      material_of_cell[cell->active_cell_index()] = cell->material_id();
  }



  // The cell and all cells that share a vertex with it, without those of other materials.
  template <int dim>
  void
  RecoveredField<dim>::collect_patch(const Cell &cell)
  {
    patch.clear();
    for (const unsigned int v : cell->vertex_indices())
      patch.insert(patch.end(),
                   cells_at_vertex.begin() + first_at_vertex[cell->vertex_index(v)],
                   cells_at_vertex.begin() + first_at_vertex[cell->vertex_index(v) + 1]);
    // Stresses are discontinuous between materials.
    patch.erase(std::remove_if(patch.begin(),
                               patch.end(),
                               [&](const unsigned int c) {
                                 return material_of_cell[c] != cell->material_id();
                               }),
                patch.end());
    std::sort(patch.begin(), patch.end());
    patch.erase(std::unique(patch.begin(), patch.end()), patch.end());
  }



  // Equation (8.5) of doc/theory: coordinates are relative to the centre of the cell and scaled by
  // its diameter, all components of all fields are right-hand sides of one normal matrix.
  template <int dim>
  const typename RecoveredField<dim>::Deviations &
  RecoveredField<dim>::operator()(const Cell &cell)
  {
    collect_patch(cell);
    const unsigned int n_samples = std::accumulate(
      patch.begin(), patch.end(), 0u, [&](const unsigned int sum, const unsigned int c) {
        return sum + first_sample[c + 1] - first_sample[c];
      });
    const Monomials<dim> monomials(degree_of_fit<dim>(elasticity, cell, n_samples));
    const unsigned int   n      = monomials.n;
    const Point<dim>     center = cell->center();
    const double         scale  = 1 / cell->diameter();

    // The lower triangle of the normal matrix and the right-hand sides.
    Matrix N = Matrix::Zero(n, n), right = Matrix::Zero(n, n_values);
    for (const unsigned int c : patch)
      for (unsigned int s = first_sample[c]; s < first_sample[c + 1]; ++s)
        {
          const auto          phi   = monomials(scale * (places[s] - center));
          const double *const value = &samples[std::size_t(s) * n_values];
          for (unsigned int i = 0; i < n; ++i)
            {
              for (unsigned int j = 0; j <= i; ++j)
                N(i, j) += phi[i] * phi[j];
              for (unsigned int k = 0; k < n_values; ++k)
                right(i, k) += phi[i] * value[k];
            }
        }
    regularise(N);
    const Matrix coefficients = solve_symmetric(N, right);

    // Deviations at the points of the rule that integrates the energy.
    values.reinit(cell, rule(cell, elasticity.degree(elasticity.mesh().body(cell)) + 1));
    const FEValues<dim> &at     = values.get_present_fe_values();
    const auto          &points = at.get_quadrature_points();
    result.weights.resize(points.size());
    result.computed.resize(points.size() * n_values);
    result.deviation.resize(points.size() * n_values);
    sampler(cell, at, result.computed.data());
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        result.weights[q] = at.JxW(q) * measure(elasticity.model(), points[q]);
        const auto phi    = monomials(scale * (points[q] - center));
        for (unsigned int k = q * n_values; k < (q + 1) * n_values; ++k)
          {
            double recovered = 0;
            for (unsigned int i = 0; i < n; ++i)
              recovered += phi[i] * coefficients(i, k - q * n_values);
            result.deviation[k] = recovered - result.computed[k];
          }
      }
    return result;
  }



  template bool
  is_one_cell_thick<2>(const DoFHandler<2>::active_cell_iterator &);
  template bool
  is_one_cell_thick<3>(const DoFHandler<3>::active_cell_iterator &);
  template std::vector<RecoverySample<2>>
  recovery_samples(const Elasticity<2> &,
                   const DoFHandler<2>::active_cell_iterator &,
                   const Point<2> &);
  template std::vector<RecoverySample<3>>
  recovery_samples(const Elasticity<3> &,
                   const DoFHandler<3>::active_cell_iterator &,
                   const Point<3> &);
  template class RecoveredField<2>;
  template class RecoveredField<3>;
} // namespace Signorini
