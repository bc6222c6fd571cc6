// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <string>
#include <vector>

namespace Signorini
{
  /// The loads whose direction and area do not follow the deformation: all at small strain, all but
  /// pressures at finite strain.
  template <int dim>
  std::vector<Load<dim>>
  dead_loads(const Elasticity<dim> &elasticity);

  /// True if there are pressures that follow the surface.
  template <int dim>
  bool
  has_follower_pressures(const Elasticity<dim> &elasticity);

  /// Forces of follower pressures on the faces of one cell (doc/theory, (6.4)): -int p cof(F) N . v
  /// dA over the reference face, since n da = cof(F) N dA with cof(F) = J F^-T (Nanson's formula);
  /// p is that at the reference position. Their derivative for a displacement w is, with G = F^-1
  /// and n = F^-T N, -int p J (tr(Grad w G) n - G^T (Grad w)^T n) . v dA  (6.5). It is not
  /// symmetric if the edge of the loaded surface can move.
  template <int dim>
  class PressureKernel
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Evaluate pressures at the present time of elasticity, to which it keeps a reference.
    /// Collective.
    explicit PressureKernel(const Elasticity<dim> &elasticity);

    /// True if there are no follower pressures.
    bool
    empty() const
    {
      return by_boundary.empty();
    }

    /// Compute the forces on the faces of a cell and their derivative.
    /// @param u displacement at the degrees of freedom of the cell, which is not inverted [length]
    /// @param forces resized to the degrees of freedom of the cell [force]
    /// @param tangent dforces/du, of the same size; null: not wanted
    /// @return false if no pressure acts on the cell; the results are then undefined
    bool
    assemble(const Cell                   &cell,
             const dealii::Vector<double> &u,
             dealii::Vector<double>       &forces,
             dealii::FullMatrix<double>   *tangent = nullptr);

    /// A message about the first pressure that had no finite value on this rank; empty if there is
    /// none.
    const std::string &
    fault() const
    {
      return error_message;
    }

  private:
    using Loads = std::vector<const Load<dim> *>;

    void
    add_face(const Loads                  &loads,
             const dealii::Vector<double> &u,
             dealii::Vector<double>       &forces,
             dealii::FullMatrix<double>   *tangent);
    double
    pressure(const Loads &loads, const dealii::Point<dim> &x);

    const Elasticity<dim>              &elasticity;
    const dealii::hp::FECollection<dim> elements; ///< scalar: the values refer to them
    /// Values on the true surface: reference areas and normals.
    dealii::hp::FEFaceValues<dim> all_values;
    /// Values on the cells: for the deformation gradient, which is exactly a rotation where the
    /// nodes undergo one.
    dealii::hp::FEFaceValues<dim>                all_gradients;
    const std::vector<std::vector<unsigned int>> all_dofs; ///< see dofs_of_nodes()
    std::map<dealii::types::boundary_id, Loads>  by_boundary;
    std::string                                  error_message;

    // Of the present face:
    const dealii::FEFaceValues<dim> *values    = nullptr;
    const dealii::FEFaceValues<dim> *gradients = nullptr;
    const std::vector<unsigned int> *dofs      = nullptr;
  };
} // namespace Signorini
