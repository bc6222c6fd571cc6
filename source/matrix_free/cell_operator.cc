#include <signorini/elasticity/cell_nodes.h>
#include <signorini/linear_algebra/values.h>
#include <signorini/matrix_free/cell_operator.h>
#include <signorini/matrix_free/tied_diagonal.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr int dim = 3;

    std::vector<types::global_dof_index>
    touched_by_cells(const Elasticity<dim> &elasticity)
    {
      std::vector<types::global_dof_index> result, indices;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            read_indices<dim>(cell, indices);
            result.insert(result.end(), indices.begin(), indices.end());
          }
      std::sort(result.begin(), result.end());
      result.erase(std::unique(result.begin(), result.end()), result.end());
      return result;
    }

    /// Of a cell's degrees of freedom, those of the first components of its nodes, in lexicographic
    /// order.
    std::vector<unsigned int>
    lexicographic_nodes(const FiniteElement<dim> &fe)
    {
      const auto               &scalar = dynamic_cast<const FE_Q<dim> &>(fe.base_element(0));
      std::vector<unsigned int> result;
      for (const unsigned int node : scalar.get_poly_space_numbering_inverse())
        {
          result.push_back(fe.component_to_system_index(0, node));
          for (unsigned int c = 1; c < dim; ++c)
            AssertThrow(fe.component_to_system_index(c, node) == result.back() + c,
                        ExcInternalError("Components of a node are not one after the other."));
        }
      return result;
    }

    Quadrature<dim>
    lattice(const unsigned int degree)
    {
      return QIterated<dim>(QTrapezoid<1>(), degree);
    }

    /// The cells of this rank with element number `element`.
    template <typename Number>
    KernelCells
    cells_of(const Elasticity<dim>      &elasticity,
             const unsigned int          element,
             const LocalVectors<Number> &vectors)
    {
      const FiniteElement<dim>       &fe     = elasticity.finite_elements()[element];
      const std::vector<unsigned int> nodes  = lexicographic_nodes(fe);
      const Quadrature<dim>           points = lattice(fe.degree);
      const FE_Nothing<dim>           nothing;
      FEValues<dim> places(elasticity.mesh().mapping(), nothing, points, update_quadrature_points);
      KernelCells   cells;
      cells.degree = fe.degree;
      std::vector<types::global_dof_index> indices;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->active_fe_index() == element)
          {
            read_indices<dim>(cell, indices);
            for (const unsigned int i : nodes)
              cells.nodes.push_back(vectors.place(indices[i]));
            places.reinit(static_cast<const Triangulation<dim>::cell_iterator &>(cell));
            for (const Point<dim> &x : places.get_quadrature_points())
              cells.points.insert(cells.points.end(), x.begin_raw(), x.end_raw());
            const Material &material = elasticity.material(cell->material_id());
            cells.lambda.push_back(material.lambda());
            cells.mu.push_back(material.mu());
          }
      return cells;
    }
  } // namespace



  template <typename Number>
  CellOperator<Number>::CellOperator(const Elasticity<dim> &elasticity)
    : vectors(elasticity.owned(),
              touched_by_cells(elasticity),
              elasticity.constraints(),
              elasticity.mesh().communicator())
    , my_diagonal(elasticity.zero_vector())
    , terms(elasticity.diagonal_terms())
  {
    for (unsigned int e = 0; e < elasticity.finite_elements().size(); ++e)
      kernels.push_back(CellKernel<Number>::create(cells_of(elasticity, e, vectors)));
    make_diagonal(elasticity);
  }



  template <typename Number>
  void
  CellOperator<Number>::make_diagonal(const Elasticity<dim> &elasticity)
  {
    Number *const d = vectors.zero();
    for (const auto &kernel : kernels)
      kernel->add_diagonal(d);
    add_tied_diagonal(elasticity, [&](const types::global_dof_index dof, const double value) {
      d[vectors.place(dof)] += value;
    });
    vectors.sum(my_diagonal);
    my_diagonal += terms;
    double *const t = LA::values_of(terms);
    for (const auto i : vectors.owned_constrained())
      t[i] = LA::values_of(my_diagonal)[i];
  }



  template <typename Number>
  void
  CellOperator<Number>::vmult(LA::Vector &dst, const LA::Vector &src) const
  {
    const Number *const u = vectors.resolve(src);
    Number *const       f = vectors.zero();
    for (const auto &kernel : kernels)
      kernel->add_product(f, u);
    vectors.condense(dst);
    double *const       y = LA::values_of(dst);
    const double *const x = LA::values_of(src), *const t = LA::values_of(terms);
    for (unsigned int i = 0; i < dst.locally_owned_size(); ++i)
      y[i] += t[i] * x[i];
  }



  template <typename Number>
  LA::Vector
  CellOperator<Number>::row_sizes() const
  {
    Number *const largest = vectors.zero();
    for (const auto &kernel : kernels)
      kernel->enlarge_by_eigenvalues(largest);
    LA::Vector result;
    result.reinit(my_diagonal, true);
    vectors.largest(result);
    double *const r = LA::values_of(result);
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      r[i] = std::max(r[i], 1.) * LA::values_of(my_diagonal)[i]; // rigid bodies have no cells
    return result;
  }



  template <typename Number>
  std::size_t
  CellOperator<Number>::memory() const
  {
    std::size_t bytes = vectors.memory() + 2 * sizeof(double) * my_diagonal.locally_owned_size();
    for (const auto &kernel : kernels)
      bytes += kernel->memory();
    return bytes;
  }



  template class CellOperator<float>;
  template class CellOperator<double>;
} // namespace Signorini
