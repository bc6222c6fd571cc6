// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"
#include "mesh/mesh.h"
#include <signorini/materials/material.h>
#include <signorini/solid/model.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_collection.h>

#include <array>
#include <vector>

namespace Signorini
{
  /// The volumetric stress m of mixed bodies, tension positive, a field of its own: the stress is
  /// 2 mu eps + m I (small deformation), or that of the law with lambda = 0 and m ln J added to W
  /// (large deformation: m is Kirchhoff's), and
  ///
  ///   int phi (theta - m/lambda) dV = 0 for all phi,  theta = tr eps or ln J,
  ///
  /// without thermal strain. That holds for lambda as large as one likes, infinite included, where
  /// a displacement alone locks.
  ///
  /// In each cell, m is a linear function of the place, whatever it is in the neighbours: with
  /// quadratic displacements that is stable and of second order, on cells of any shape because it
  /// is linear in space, not in coordinates of the cell (Boffi and Gastaldi, Numer. Math. 92 (2002)
  /// 593; Boffi, Brezzi, Fortin, Mixed Finite Element Methods, 2013, 8.6). The functions phi of a
  /// cell are orthogonal, of the size of mu/h: coefficients are lengths, the rows of the equation
  /// forces, and matrices of such functions are diagonal.
  template <int dim>
  class VolumetricStress
  {
  public:
    using Cell                                       = dealii::CellAccessor<dim>;
    static constexpr unsigned int functions_per_cell = dim + 1;
    using Functions                                  = std::array<double, functions_per_cell>;

    /// Keeps a reference to the mesh. @param materials by their ids
    VolumetricStress(const Mesh<dim> &mesh, const std::vector<Material> &materials, Model model);

    /// The mesh has changed: the stress is zero. Collective.
    void
    reinit();

    /// No body is mixed: there is nothing to do, and nothing is stored.
    bool
    empty() const
    {
      return mixed.empty();
    }

    /// Is a cell one of a mixed body?
    bool
    is_on(const Cell &cell) const
    {
      return !empty() && mixed[cell.material_id()];
    }

    // Of a locally owned or ghost cell of a mixed body:

    /// m at a place; zero on other bodies.
    double
    value(const Cell &cell, const dealii::Point<dim> &x) const;

    Functions
    functions(const Cell &cell, const dealii::Point<dim> &x) const;

    /// int phi^2 dV of each of its functions [stress x force]
    double
    size(const Cell &cell) const
    {
      return basis(cell).size;
    }

    /// Of its coefficients.
    const std::vector<dealii::types::global_dof_index> &
    indices(const Cell &cell) const
    {
      return basis(cell).indices;
    }

    /// Its coefficients.
    const Functions &
    coefficients(const Cell &cell) const
    {
      return basis(cell).coefficients;
    }

    // Of all cells:

    /// Those that this rank owns.
    const dealii::IndexSet &
    owned() const
    {
      return dofs.locally_owned_dofs();
    }

    /// An empty one if no body is mixed.
    LA::Vector
    zero_vector() const
    {
      return empty() ? LA::Vector() : LA::Vector(owned(), mesh.communicator());
    }

    /// Without ghosts.
    LA::Vector
    coefficients() const;

    /// Collective.
    void
    set_coefficients(const LA::Vector &values);

  private:
    struct Basis
    {
      dealii::Point<dim>                           center;
      std::array<Functions, functions_per_cell>    rows; ///< by 1 and x - center, lower triangle
      double                                       size = 0;
      std::vector<dealii::types::global_dof_index> indices;
      Functions                                    coefficients{};
    };

    const Basis &
    basis(const Cell &cell) const
    {
      return of_cells[number[cell.active_cell_index()]];
    }

    void
    distribute_dofs();
    void
    make_bases();
    void
    orthogonalise(const dealii::FEValues<dim> &values, double unit, Basis &basis) const;

    const Mesh<dim>                    &mesh;
    const Model                         model;
    std::vector<bool>                   mixed; ///< one a body; empty: none of them
    std::vector<double>                 mu;    ///< of each body
    const dealii::hp::FECollection<dim> elements;
    dealii::DoFHandler<dim>             dofs; ///< numbers only; of cells of other bodies none
    std::vector<Basis>                  of_cells;
    std::vector<unsigned int>           number; ///< in that list, by the active index of cells
    LA::Vector                          zero_with_ghosts;
  };
} // namespace Signorini
