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
  /// In each cell the rise T - T_0 is replaced by its L2 projection onto polynomials in x of one
  /// degree less than the displacement, as strains are: constant for degree 1, linear for degree 2.
  /// With a higher degree, stresses within cells would oscillate, since the strain cannot follow
  /// (Prathap, Naganarayana, Computers & Structures 54 (1995); doc/theory, 6.4); a body with such a
  /// temperature that expands freely is free of stress at all points.
  template <int dim>
  class ThermalStrain
  {
  public:
    using Cell = dealii::CellAccessor<dim>;

    /// Keeps a reference to the mesh.
    /// @param expansions by material id, or none
    /// @param degrees of the displacement, by material id
    ThermalStrain(const Mesh<dim>                          &mesh,
                  const std::vector<ThermalExpansion<dim>> &expansions,
                  const std::vector<unsigned int>          &degrees,
                  Model                                     model);

    /// True if a body expands; otherwise nothing is stored.
    bool
    any() const;

    /// Discard all values after a change of the mesh; to be called before set_time().
    void
    reinit();

    /// Evaluate the temperatures at time t, unless they are those of that time already. Throws
    /// SceneError on all ranks where a temperature is not a number. Collective.
    void
    set_time(double t);

    /// T - T_0 at a point of a locally owned or ghost cell.
    double
    temperature_change(const Cell &cell, const dealii::Point<dim> &x) const;

    /// The temperature at a quadrature point minus the projection there, at the time of set_time().
    /// @param values on a locally owned or ghost cell
    double
    projection_error(const dealii::FEValues<dim> &values, unsigned int q) const;

    /// Thermal expansion coefficients along the axes of a material that expands.
    dealii::Tensor<1, 3>
    alpha(const unsigned int id) const
    {
      return expansions[id].alpha();
    }

    /// alpha_i (T - T_0) at a point of a locally owned or ghost cell.
    dealii::Tensor<1, 3>
    strain(const Cell &cell, const dealii::Point<dim> &x) const;

    /// The volume of free expansion at finite strain over that at T_0, at a point of a locally
    /// owned or ghost cell.
    double
    volume_ratio(const Cell &cell, const dealii::Point<dim> &x) const;

    /// A number that changes with the temperatures.
    unsigned int
    version() const
    {
      return my_version;
    }

    /// The stress C : alpha along the axes that suppresses a rise of one [force/(area
    /// temperature)].
    /// @param id of the material
    dealii::Tensor<1, 3>
    stress_of_unit_rise(const Material &material, unsigned int id) const;

    /// True if the material with this id expands.
    bool
    expands(const unsigned int id) const
    {
      return any() && expansions[id].given();
    }

    // The rise as a global vector, for matrices that refer to cells of other ranks:

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

    /// The polynomials at a point of a cell: 1, then the scaled coordinates.
    Monomials
    monomials(const Cell &cell, const dealii::Point<dim> &x) const;
    /// Compute the coefficients of the cell that `values` refer to. @param result n_coefficients
    /// numbers
    void
    fit(const dealii::FEValues<dim> &values, double t, unsigned int degree, double *result);
    /// The temperature at quadrature point q.
    double
    temperature(const dealii::FEValues<dim> &values, unsigned int q, double t) const;
    /// Throws SceneError on all ranks where a body would shrink to nothing. Collective.
    void
    throw_if_vanishing(unsigned int id) const;
    /// Throws SceneError on all ranks if any rank has a bad point. Collective.
    void
    throw_if_invalid(unsigned int id, double t, const std::vector<dealii::Point<dim>> &bad) const;

    const Mesh<dim>                         &mesh;
    const std::vector<ThermalExpansion<dim>> expansions;
    const std::vector<unsigned int>          degrees;
    const Model                              model;
    /// Number of coefficients of each cell.
    unsigned int n_coefficients;
    /// The coefficients of owned and ghost cells, by active cell index.
    std::vector<double> of_cells;
    /// The time of the present values, by material id; NaN: none.
    std::vector<double> times;
    unsigned int        my_version = 0;
  };

  /// The forces of thermal strain, int (C : eps_T) : eps(v) dV, cell by cell (the last term of
  /// doc/theory, (1.4)). They are integrated as the stiffness is, so that both are in equilibrium
  /// for the displacement of free expansion. Bodies with a constitutive law have them in their
  /// internal forces. Keeps references to its arguments.
  template <int dim>
  class ThermalLoad
  {
  public:
    using DofCell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    ThermalLoad(const Mesh<dim>                     &mesh,
                const dealii::hp::FECollection<dim> &elements,
                const ThermalStrain<dim>            &thermal,
                Model                                model);

    /// Add the forces to a vector of the size of the cell. Returns false if there are none.
    bool
    add(const DofCell &cell, const Material &material, dealii::Vector<double> &cell_load);

  private:
    const ThermalStrain<dim> &thermal;
    const Model               model;
    dealii::hp::FEValues<dim> all_values;
  };
} // namespace Signorini
