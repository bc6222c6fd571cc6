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
  /// The volumetric stress m of bodies in displacement-pressure form (doc/theory, 6.6), tension
  /// positive, an independent unknown: the stress is 2 mu eps + m I (small strain), or that of the
  /// law with lambda = 0 and m ln J added to W (finite strain: m is a Kirchhoff stress), and
  ///
  ///   int phi (theta - m/lambda) dV = 0 for all phi,  theta = tr eps or ln J,
  ///
  /// without thermal strain. lambda may be arbitrarily large or infinite, where a pure displacement
  /// formulation locks.
  ///
  /// In each cell, m is a linear function of the position. With quadratic displacements two such
  /// spaces are inf-sup stable and of second order (Boffi, Brezzi, Fortin, Mixed Finite Element
  /// Methods, 2013, 8.6 to 8.8):
  ///   * on quadrilaterals and hexahedra, m is discontinuous between cells. It is linear in space
  ///     and not in the coordinates of the cell, which keeps the order on cells of any shape (Boffi
  ///     and Gastaldi, Int. J. Numer. Meth. Fluids 39 (2002) 1001). The functions phi of a cell are
  ///     orthogonal.
  ///   * on triangles and tetrahedra, m is determined by its values at the vertices (Taylor and
  ///     Hood): there, discontinuous linear functions are too many, and constants lose an order. A
  ///     vertex has one value for each material around it, since m jumps between materials.
  /// Functions are of the size of mu/h, so that coefficients are lengths and the rows of the
  /// equation are forces.
  template <int dim>
  class VolumetricStress
  {
  public:
    using Cell                                       = dealii::CellAccessor<dim>;
    static constexpr unsigned int functions_per_cell = dim + 1;
    using Functions                                  = std::array<double, functions_per_cell>;
    using MassMatrix                                 = std::array<Functions, functions_per_cell>;

    /// Keeps a reference to the mesh. @param materials by their ids
    VolumetricStress(const Mesh<dim> &mesh, const std::vector<Material> &materials, Model model);

    /// Distribute degrees of freedom and compute the bases after a change of the mesh; sets the
    /// stress to zero. Collective.
    void
    reinit();

    /// True if no body is in displacement-pressure form; then nothing is stored.
    bool
    empty() const
    {
      return mixed.empty();
    }

    /// True if the cell belongs to a body in displacement-pressure form.
    bool
    is_on(const Cell &cell) const
    {
      return !empty() && mixed[cell.material_id()];
    }

    // Functions of a locally owned or ghost cell of a body in displacement-pressure form:

    /// m at a point x of a cell [force/area]; zero on other bodies.
    double
    value(const Cell &cell, const dealii::Point<dim> &x) const;

    /// The same with other coefficients. @param coefficients with ghosts, see with_ghosts()
    double
    value(const Cell &cell, const dealii::Point<dim> &x, const LA::Vector &coefficients) const;

    /// The functions phi of a cell at a point x of the reference configuration [force/volume]; m is
    /// the sum of coefficient times function.
    Functions
    functions(const Cell &cell, const dealii::Point<dim> &x) const;

    /// int phi_i phi_j dV [stress x force]; a multiple of the unit matrix on quadrilaterals and
    /// hexahedra.
    const MassMatrix &
    mass(const Cell &cell) const
    {
      return basis(cell).mass;
    }

    /// The coefficients of the function that is 1 in a cell.
    const Functions &
    one(const Cell &cell) const
    {
      return basis(cell).one;
    }

    /// The global indices of the coefficients of a cell.
    const std::vector<dealii::types::global_dof_index> &
    indices(const Cell &cell) const
    {
      return basis(cell).indices;
    }

    /// The coefficients of a cell [length].
    const Functions &
    coefficients(const Cell &cell) const
    {
      return basis(cell).coefficients;
    }

    // Functions of the coefficients of all cells:

    /// The coefficients that this rank owns.
    const dealii::IndexSet &
    owned() const
    {
      return dofs.locally_owned_dofs();
    }

    /// A zero vector of coefficients; empty if no body is in displacement-pressure form.
    LA::Vector
    zero_vector() const
    {
      return empty() ? LA::Vector() : LA::Vector(owned(), mesh.communicator());
    }

    /// The coefficients of all cells, without ghosts.
    LA::Vector
    coefficients() const;

    /// The same coefficients with those of ghost cells. Collective. @param values without ghosts
    LA::Vector
    with_ghosts(const LA::Vector &values) const;

    /// Set the coefficients. Collective. @param values without ghosts
    void
    set_coefficients(const LA::Vector &values);

  private:
    /// The basis and the coefficients of one cell.
    struct Basis
    {
      /// Centroid of the cell, by the quadrature of its stiffness, or mean of the vertices.
      dealii::Point<dim> center;
      /// Coefficients of each function for 1 and the components of x - center.
      std::array<Functions, functions_per_cell>    rows{};
      MassMatrix                                   mass{};
      Functions                                    one{};
      std::vector<dealii::types::global_dof_index> indices;
      Functions                                    coefficients{};

      /// The functions at a point.
      Functions
      at(const dealii::Point<dim> &x) const;
    };

    /// The basis of an owned or ghost cell with the field.
    const Basis &
    basis(const Cell &cell) const
    {
      return of_cells[number[cell.active_cell_index()]];
    }

    /// Number the degrees of freedom. Collective.
    void
    distribute_dofs();
    /// Make the bases of the owned and ghost cells with the field.
    void
    make_bases();
    /// For the degrees of freedom at vertices, the size of the functions [force/length^3]: mu/h
    /// with the mean size of the cells of their material around them. With ghosts; other entries
    /// are not set. Collective.
    LA::Vector
    units_at_vertices() const;
    /// Set all of a basis but its indices, with orthogonal functions. @param values quadrature of
    /// the cell @param unit size of the functions [force/length^3]
    void
    orthogonalise(const dealii::FEValues<dim> &values, double unit, Basis &basis) const;
    /// Set all of the basis of a simplex but its indices, with one function for each vertex.
    /// @param values quadrature of the cell @param units of the functions
    void
    interpolate_vertices(const dealii::FEValues<dim> &values,
                         const Functions             &units,
                         Basis                       &basis) const;

    const Mesh<dim> &mesh;
    const Model      model;
    /// By material id: true for displacement-pressure form; empty if no material has it.
    std::vector<bool> mixed;
    /// Shear modulus by material id [force/area].
    std::vector<double> mu;
    /// By material id, the component of its values at vertices.
    std::vector<unsigned int>           component;
    const dealii::hp::FECollection<dim> elements;
    dealii::DoFHandler<dim>             dofs; ///< numbers only; of cells of other bodies none
    std::vector<Basis>                  of_cells;
    std::vector<unsigned int>           number; ///< in that list, by the active index of cells
    LA::Vector                          zero_with_ghosts;
  };
} // namespace Signorini
