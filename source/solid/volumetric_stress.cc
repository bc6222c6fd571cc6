// SPDX-License-Identifier: Apache-2.0
#include "solid/volumetric_stress.h"

#include "geometry/cell_rule.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The elements in the list of elements_for().
    enum Element : unsigned int
    {
      no_cube,
      cube,
      no_simplex,
      first_simplex
    };

    /// An element with the given number of components, of which all but one are empty.
    template <int dim>
    FESystem<dim>
    in_component(const FiniteElement<dim> &element,
                 const unsigned int        component,
                 const unsigned int        n_components)
    {
      const FE_Nothing<dim>                   none(element.reference_cell());
      std::vector<const FiniteElement<dim> *> parts(n_components, &none);
      const std::vector<unsigned int>         multiplicities(n_components, 1);
      parts[component] = &element;
      return FESystem<dim>(parts, multiplicities);
    }

    /// Numbers of degrees of freedom: none in bodies in displacement form, dim + 1 in each cube,
    /// and one at each vertex of simplices, which have a component for each material, so that
    /// neighbours of different materials share none.
    template <int dim>
    hp::FECollection<dim>
    elements_for(const unsigned int n_components)
    {
      const ReferenceCell    simplex = ReferenceCells::get_simplex<dim>();
      const FE_Nothing<dim>  no_function(ReferenceCells::get_hypercube<dim>()), none(simplex);
      const FE_DGP<dim>      discontinuous(1);
      const FE_SimplexP<dim> of_vertices(1);
      hp::FECollection<dim>  result;
      result.push_back(in_component<dim>(no_function, 0, n_components));
      result.push_back(in_component<dim>(discontinuous, 0, n_components));
      result.push_back(in_component<dim>(none, 0, n_components));
      for (unsigned int component = 0; component < n_components; ++component)
        result.push_back(in_component<dim>(of_vertices, component, n_components));
      return result;
    }

    /// The size of a cell as the edge of a cube with the same diagonal.
    template <int dim>
    double
    size_of(const CellAccessor<dim> &cell)
    {
      return cell.diameter() / std::sqrt(double(dim));
    }
  } // namespace



  // If no material is in displacement-pressure form, the lists stay empty, and with them all
  // functions of this class.
  template <int dim>
  VolumetricStress<dim>::VolumetricStress(const Mesh<dim>             &mesh,
                                          const std::vector<Material> &materials,
                                          const Model                  model)
    : mesh(mesh)
    , model(model)
    , elements(elements_for<dim>(std::max<unsigned int>(
        1, std::count_if(materials.begin(), materials.end(), [](const Material &material) {
          return material.is_up_formulation;
        }))))
  {
    if (std::none_of(materials.begin(), materials.end(), [](const Material &material) {
          return material.is_up_formulation;
        }))
      return;
    unsigned int n_components = 0;
    for (const Material &material : materials)
      {
        component.push_back(n_components);
        n_components += material.is_up_formulation ? 1 : 0;
        mixed.push_back(material.is_up_formulation);
        mu.push_back(material.mu());
      }
  }



  // Make degrees of freedom, bases and the ghosted vector for the present mesh; coefficients are
  // zero.
  template <int dim>
  void
  VolumetricStress<dim>::reinit()
  {
    if (empty())
      return;
    distribute_dofs();
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    zero_with_ghosts.reinit(owned(), relevant, mesh.communicator());
    make_bases();
  }



  // Cells of other bodies have the element without functions.
  template <int dim>
  void
  VolumetricStress<dim>::distribute_dofs()
  {
    dofs.reinit(mesh.triangulation());
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int id      = cell->material_id();
          const bool         is_cube = cell->reference_cell().is_hyper_cube();
          cell->set_active_fe_index(mixed[id] ? (is_cube ? cube : first_simplex + component[id]) :
                                                (is_cube ? no_cube : no_simplex));
        }
    dofs.distribute_dofs(elements);
  }



  // Sums over the cells around a vertex, which may belong to several ranks.
  template <int dim>
  LA::Vector
  VolumetricStress<dim>::units_at_vertices() const
  {
    LA::Vector                           units = zero_vector(), count = units;
    std::vector<types::global_dof_index> indices(functions_per_cell);
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned() && is_on(*cell) && !cell->reference_cell().is_hyper_cube())
        {
          cell->get_dof_indices(indices);
          for (const auto i : indices)
            {
              units(i) += size_of<dim>(*cell) / mu[cell->material_id()];
              count(i) += 1;
            }
        }
    for (LA::Vector *sum : {&units, &count})
      sum->compress(VectorOperation::add);
    for (const auto i : owned())
      if (count(i) > 0)
        units(i) = count(i) / units(i);
    units.compress(VectorOperation::insert);
    LA::Vector result = zero_with_ghosts;
    result            = units;
    return result;
  }



  // One basis for each owned and ghost cell of bodies in this form, evaluated with the quadrature
  // of their stiffness.
  template <int dim>
  void
  VolumetricStress<dim>::make_bases()
  {
    hp::FECollection<dim> none;
    hp::QCollection<dim>  rules;
    for (const auto &cell :
         {ReferenceCells::get_hypercube<dim>(), ReferenceCells::get_simplex<dim>()})
      {
        none.push_back(FE_Nothing<dim>(cell));
        rules.push_back(cell_rule<dim>(cell, 3));
      }
    hp::FEValues<dim> all_values(mesh.mappings(),
                                 none,
                                 rules,
                                 update_quadrature_points | update_JxW_values);
    const LA::Vector  units = units_at_vertices();
    of_cells.clear();
    number.assign(mesh.triangulation().n_active_cells(), numbers::invalid_unsigned_int);
    for (const auto &cell : dofs.active_cell_iterators())
      if (!cell->is_artificial() && is_on(*cell))
        {
          number[cell->active_cell_index()] = of_cells.size();
          const unsigned int index          = cell->reference_cell().is_hyper_cube() ? 0 : 1;
          all_values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell),
                            index,
                            0,
                            index);
          const FEValues<dim> &values = all_values.get_present_fe_values();
          Basis                own;
          own.indices.resize(functions_per_cell);
          cell->get_dof_indices(own.indices);
          if (index == 0)
            orthogonalise(values, mu[cell->material_id()] / size_of<dim>(*cell), own);
          else
            {
              Functions at_vertices;
              for (unsigned int v = 0; v < functions_per_cell; ++v)
                at_vertices[v] = units(own.indices[v]);
              interpolate_vertices(values, at_vertices, own);
            }
          of_cells.push_back(own);
        }
  }



  // Gram-Schmidt orthogonalisation of 1 and the coordinates relative to the centroid, with the
  // scalar product of the cell's quadrature (doc/theory, 6.6); then all functions are scaled to the
  // norm unit^2 times the volume, so that mass matrices are diagonal with one value for each cell.
  template <int dim>
  void
  VolumetricStress<dim>::orthogonalise(const FEValues<dim> &values,
                                       const double         unit,
                                       Basis               &own) const
  {
    std::vector<double> weights;
    double              volume = 0;
    Tensor<1, dim>      moment;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &x = values.quadrature_point(q);
        weights.push_back(values.JxW(q) * measure(model, x));
        volume += weights.back();
        moment += weights.back() * Tensor<1, dim>(x);
      }
    own.center        = Point<dim>(moment / volume);
    const double size = unit * unit * volume;

    // A row has the coefficients of 1 and of the coordinates relative to the centroid.
    const auto at = [&](const Functions &row, const unsigned int q) {
      double sum = row[0];
      for (unsigned int d = 0; d < dim; ++d)
        sum += row[d + 1] * (values.quadrature_point(q)[d] - own.center[d]);
      return sum;
    };
    const auto product = [&](const Functions &a, const Functions &b) {
      double sum = 0;
      for (const unsigned int q : values.quadrature_point_indices())
        sum += weights[q] * at(a, q) * at(b, q);
      return sum;
    };
    for (unsigned int i = 0; i < functions_per_cell; ++i)
      {
        Functions &row = own.rows[i];
        row[i]         = 1;
        // Earlier functions are orthogonal to each other and all have the same norm, so that their
        // shares can be subtracted one after the other.
        for (unsigned int j = 0; j < i; ++j)
          {
            const double share = product(row, own.rows[j]) / size;
            for (unsigned int k = 0; k <= j; ++k)
              row[k] -= share * own.rows[j][k];
          }
        const double factor = std::sqrt(size / product(row, row));
        for (double &entry : row)
          entry *= factor;
        own.mass[i][i] = size;
      }
    own.one[0] = 1 / own.rows[0][0];
  }



  // Barycentric coordinates of the vertices, affine functions of x also where cells are curved:
  // with edges e_i = x_i - x_0, the gradients g_i of those of i > 0 are the columns of the inverse
  // of the matrix with the rows e_i, all sum to zero, and all have the same value at the mean of
  // the vertices.
  template <int dim>
  void
  VolumetricStress<dim>::interpolate_vertices(const FEValues<dim> &values,
                                              const Functions     &units,
                                              Basis               &own) const
  {
    const auto     cell = values.get_cell();
    Tensor<2, dim> edges;
    Tensor<1, dim> sum;
    for (unsigned int v = 0; v < functions_per_cell; ++v)
      {
        sum += Tensor<1, dim>(cell->vertex(v));
        if (v > 0)
          edges[v - 1] = cell->vertex(v) - cell->vertex(0);
      }
    own.center                     = Point<dim>(sum / functions_per_cell);
    const Tensor<2, dim> gradients = invert(edges);
    for (unsigned int v = 0; v < functions_per_cell; ++v)
      {
        Functions &row = own.rows[v];
        row[0]         = units[v] / functions_per_cell;
        for (unsigned int d = 0; d < dim; ++d)
          if (v > 0)
            {
              row[d + 1] = units[v] * gradients[d][v - 1];
              own.rows[0][d + 1] -= units[0] * gradients[d][v - 1];
            }
        own.one[v] = 1 / units[v];
      }
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &x   = values.quadrature_point(q);
        const Functions   phi = own.at(x);
        for (unsigned int i = 0; i < functions_per_cell; ++i)
          for (unsigned int j = 0; j < functions_per_cell; ++j)
            own.mass[i][j] += values.JxW(q) * measure(model, x) * phi[i] * phi[j];
      }
  }



  // An affine function of x for each row.
  template <int dim>
  typename VolumetricStress<dim>::Functions
  VolumetricStress<dim>::Basis::at(const Point<dim> &x) const
  {
    const Tensor<1, dim> from = x - center;
    Functions            result;
    for (unsigned int i = 0; i < functions_per_cell; ++i)
      {
        result[i] = rows[i][0];
        for (unsigned int d = 0; d < dim; ++d)
          result[i] += rows[i][d + 1] * from[d];
      }
    return result;
  }



  template <int dim>
  typename VolumetricStress<dim>::Functions
  VolumetricStress<dim>::functions(const Cell &cell, const Point<dim> &x) const
  {
    return basis(cell).at(x);
  }



  // m = sum_i m_i phi_i at a point of a cell, zero in other bodies.
  template <int dim>
  double
  VolumetricStress<dim>::value(const Cell &cell, const Point<dim> &x) const
  {
    if (!is_on(cell))
      return 0;
    const Functions  phi = functions(cell, x);
    const Functions &m   = coefficients(cell);
    return std::inner_product(m.begin(), m.end(), phi.begin(), 0.);
  }



  template <int dim>
  double
  VolumetricStress<dim>::value(const Cell       &cell,
                               const Point<dim> &x,
                               const LA::Vector &coefficients) const
  {
    if (!is_on(cell))
      return 0;
    const Functions phi    = functions(cell, x);
    const auto     &number = indices(cell);
    double          sum    = 0;
    for (unsigned int i = 0; i < number.size(); ++i)
      sum += phi[i] * coefficients(number[i]);
    return sum;
  }



  template <int dim>
  LA::Vector
  VolumetricStress<dim>::with_ghosts(const LA::Vector &values) const
  {
    LA::Vector result = zero_with_ghosts;
    result            = values;
    return result;
  }



  // The coefficients of cells that this rank owns as a distributed vector. Collective.
  template <int dim>
  LA::Vector
  VolumetricStress<dim>::coefficients() const
  {
    LA::Vector result = zero_vector(); // nothing where no body is mixed
    if (empty())
      return result;
    for (const Basis &own : of_cells)
      for (unsigned int i = 0; i < functions_per_cell; ++i)
        if (owned().is_element(own.indices[i]))
          result(own.indices[i]) = own.coefficients[i];
    result.compress(VectorOperation::insert);
    return result;
  }



  // Ghost cells get the coefficients of their owners. Collective.
  template <int dim>
  void
  VolumetricStress<dim>::set_coefficients(const LA::Vector &values)
  {
    if (empty())
      return;
    const LA::Vector all = with_ghosts(values);
    for (Basis &own : of_cells)
      for (unsigned int i = 0; i < functions_per_cell; ++i)
        own.coefficients[i] = all(own.indices[i]);
  }



  template class VolumetricStress<2>;
  template class VolumetricStress<3>;
} // namespace Signorini
