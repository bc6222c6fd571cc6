// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/gap_operator.h"

#include <array>
#include <vector>

namespace Signorini
{
  /// A contact point with tractions: sum_ij C_ij R_i.d R_j.u, with rows R of the four kinds, in
  /// this order. Nodes and rigid rows are named by places in an array.
  template <int dim>
  struct LoadedPoint
  {
    FaceShapeFunctions<dim> slave, master;
    /// v.(uS - uM) + rigid.u, of each v; no uM of obstacles.
    std::vector<dealii::Tensor<1, dim>> directions;
    std::vector<SparseRow>              rigid; ///< of an obstacle, more of them than directions
    /// v.uM,a of each v and then each a; of bodies.
    std::vector<dealii::Tensor<1, dim>> of_master;
    /// sum_a v_a.uS,a
    std::vector<std::array<dealii::Tensor<1, dim>, dim - 1>> of_slave;
    std::vector<double>                                      factors; ///< C, times the area

    unsigned int
    n_rows() const
    {
      return rigid.empty() ? directions.size() + (dim - 1) * of_master.size() + of_slave.size() :
                             rigid.size();
    }

    /// R_i.u
    void
    evaluate_rows(const double *u, std::vector<double> &R) const;

    /// dst += sum_i s_i R_i
    void
    add_rows(const std::vector<double> &s, double *dst) const;
  };

  /// The loaded points of all contact points and segment edge points of this rank that carry
  /// tractions: the sum of their products is G, see geometric_stiffness(). Nodes are identified by
  /// degrees of freedom. Collective.
  /// @param traction at the rows
  template <int dim>
  std::vector<LoadedPoint<dim>>
  loaded_points(const std::vector<ContactSurface<dim>> &surfaces,
                const ContactRows                      &rows,
                const PointVectors                     &traction,
                MPI_Comm                                comm);
} // namespace Signorini
