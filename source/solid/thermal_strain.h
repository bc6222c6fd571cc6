// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"
#include "mesh/mesh.h"
#include <signorini/solid/model.h>
#include <signorini/solid/thermal_expansion.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/fe_values.h>

#include <array>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The thermal strain of bodies on the present mesh, at one time: alpha_i (T - T_0) along the
  /// axes, so that sigma = C : (eps(u) - eps_thermal).
  ///
  /// In each cell, the rise T - T_0 is taken for the polynomial in x that fits it best (L2), of one
  /// degree less than the displacement, as strains are: constant with degree 1, linear with
  /// degree 2. With more, stresses within cells would oscillate where the strain cannot follow
  /// (Prathap, Naganarayana, Computers & Structures 54 (1995)); a free body with
  /// such a temperature is free of stress at all points.
  template <int dim>
  class ThermalStrain
  {
  public:
    using Cell = dealii::CellAccessor<dim>;

    /// Keeps a reference to the mesh. @param expansions by material ids, or none
    /// @param degrees of the displacement, by material ids too
    ThermalStrain(const Mesh<dim>                          &mesh,
                  const std::vector<ThermalExpansion<dim>> &expansions,
                  const std::vector<unsigned int>          &degrees,
                  Model                                     model);

    /// False if no body expands: then there is nothing to do, and nothing is stored.
    bool
    any() const;

    /// To be called when the mesh has changed, before set_time().
    void
    reinit();

    /// Evaluate the temperatures at time t, unless they are known. Throws SceneError, on all ranks,
    /// where a temperature is not a number. Collective.
    void
    set_time(double t);

    /// T - T_0 at a point of a locally owned or ghost cell.
    double
    temperature_change(const Cell &cell, const dealii::Point<dim> &x) const;

    /// alpha_i (T - T_0) at a point of a locally owned or ghost cell.
    dealii::Tensor<1, 3>
    strain(const Cell &cell, const dealii::Point<dim> &x) const;

    /// The stress that takes a rise by 1 to suppress, with the sign of C : alpha, along the axes.
    dealii::Tensor<1, 3>
    stress_of_unit_rise(const Material &material, unsigned int id) const;

    bool
    expands(const unsigned int id) const
    {
      return any() && expansions[id].given();
    }

    // For what refers to rises on other ranks:

    /// temperature_change() as a combination of coefficients(), by their indices.
    std::vector<std::pair<dealii::types::global_dof_index, double>>
    row(const Cell &cell, const dealii::Point<dim> &x) const;

    /// The coefficients of all temperature changes at the present time.
    LA::Vector
    coefficients() const;

    /// The indices of the coefficients that this rank owns.
    dealii::IndexSet
    owned() const;

    /// Lowest and highest T in the cells of a material at time t, at points in its cells. Throws
    /// SceneError, on all ranks, if it is not a number somewhere. Collective.
    std::pair<double, double>
    range(unsigned int id, double t) const;

  private:
    using Monomials = std::array<double, dim + 1>;

    Monomials
    monomials(const Cell &cell, const dealii::Point<dim> &x) const;
    void
    fit(const dealii::FEValues<dim> &values, double t, unsigned int degree, double *result);
    double
    temperature(const dealii::FEValues<dim> &values, unsigned int q, double t) const;
    void
    throw_if_invalid(unsigned int id, double t, const std::vector<dealii::Point<dim>> &bad) const;

    const Mesh<dim>                         &mesh;
    const std::vector<ThermalExpansion<dim>> expansions;
    const std::vector<unsigned int>          degrees;
    const Model                              model;
    unsigned int                             n_coefficients; ///< of a cell
    std::vector<double>                      of_cells;       ///< by their active indices
    std::vector<double>                      times;          ///< of each body's values
  };

  /// The forces of thermal strain, int (C : eps_thermal) : eps(v) dV, cell by cell. Integrated as
  /// the stiffness is, so that the two are in balance for the displacement of a body that expands
  /// freely. Keeps references to its arguments.
  template <int dim>
  class ThermalLoad
  {
  public:
    using DofCell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    ThermalLoad(const Mesh<dim>                     &mesh,
                const dealii::hp::FECollection<dim> &elements,
                const ThermalStrain<dim>            &thermal,
                Model                                model);

    /// Add them to the vector, which has the size of the cell. Returns false if there are none.
    bool
    add(const DofCell &cell, const Material &material, dealii::Vector<double> &cell_load);

  private:
    const ThermalStrain<dim> &thermal;
    const Model               model;
    dealii::hp::FEValues<dim> all_values;
  };
} // namespace Signorini
