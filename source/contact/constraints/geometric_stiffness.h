// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/gap_operator.h"

#include <algorithm>
#include <array>
#include <vector>

namespace Signorini
{
  /// A contact point with tractions, as a term of the contact geometric stiffness (doc/theory,
  /// (5.9)): v^T G u = sum_ij C_ij (R_i . v) (R_j . u), with the rows R of the four kinds below, in
  /// this order. Nodes and rigid rows refer to degrees of freedom, or, after renaming by the
  /// geometric stiffness, to slots of a local array.
  template <int dim>
  struct LoadedPoint
  {
    FaceShapeFunctions<dim> slave, master;
    /// Directions d of the rows d . (u^S - u^M), with the entry of `rigid` of the same number
    /// added; obstacles have no u^M.
    std::vector<dealii::Tensor<1, dim>> directions;
    /// Rows over an obstacle's rigid-body degrees of freedom, at least as many as directions; empty
    /// for bodies.
    std::vector<SparseRow> rigid;
    /// Directions d of the rows d . du^M/dxi_a, one for each direction and then each a; for bodies
    /// only.
    std::vector<dealii::Tensor<1, dim>> of_master;
    /// Vectors d_a of the rows sum_a d_a . du^S/dxi_a.
    std::vector<std::array<dealii::Tensor<1, dim>, dim - 1>> of_slave;
    /// The matrix C, n_rows() x n_rows() row by row, times the area and the tractions [force, or
    /// force/length by the units of the rows].
    std::vector<double> factors;

    /// The number of rows with directions, or with rigid rows.
    unsigned int
    n_jumps() const
    {
      return std::max(directions.size(), rigid.size());
    }

    /// The number of rows R_i of the second variation.
    unsigned int
    n_rows() const
    {
      return n_jumps() + (dim - 1) * of_master.size() + of_slave.size();
    }

    /// Evaluate the rows: R_i . u. @param u values by slot; @param R set to n_rows() values
    void
    evaluate_rows(const double *u, std::vector<double> &R) const;

    /// Apply the transposed rows: dst += sum_i s_i R_i. @param s n_rows() factors; @param dst
    /// values by slot
    void
    add_rows(const std::vector<double> &s, double *dst) const;
  };

  /// The loaded points of all contact points and segment edge points of this rank that carry
  /// tractions; the sum of their products is the matrix G of geometric_stiffness(). Nodes are
  /// identified by degrees of freedom. Collective.
  /// @param traction tractions of the owned rows [force/length^(dim-1)], one vector for each
  /// component: pressure, then tangential ones if there are any
  template <int dim>
  std::vector<LoadedPoint<dim>>
  loaded_points(const std::vector<ContactSurface<dim>> &surfaces,
                const ContactRows                      &rows,
                const PointVectors                     &traction,
                MPI_Comm                                comm);

  /// The contact geometric stiffness on free degrees of freedom, for given tractions. For pressures
  /// it is G = sum_q p_q w_q d2 g_q/du2 over the contact points and segment edge points; K - G is
  /// the derivative of the residual, in the condensed and in the saddle point form (doc/theory, 5).
  ///
  /// The tangential traction T = sum_a t_a tau_a on the slave does the work T.(dS - dM(xi)) in a
  /// virtual displacement d, S and M being the slave's point and its projection. With the change u
  /// of the displacement, the tangents tau_a rotate with the contact normal n and about it by the
  /// angle omega, and the projection moves by dxi:
  ///
  ///   G(d, u) = w [-(T.dn) n.(dS - dM) + omega T'.(dS - dM) - dxi_b T.dM,b],
  ///
  /// where T' is T rotated by ninety degrees. With the tangents y_a, the metric A, the curvature K
  /// of the master, the gap g, and H = A - g K (Laursen, Computational Contact and Impact
  /// Mechanics, Springer 2002, chapter 5):
  ///
  ///   dxi = H^-1 (w + g m),  w_a = y_a.(uS - uM),  m_a = n.uM,a
  ///   dn  = -y_a A^ab (m_b + K_bc dxi_c),
  ///
  /// and omega, the rotation of the slave's material about n, is that of ConvectedFrame,
  ///
  ///   tr U omega = tau_2.uS,1 - tau_1.uS,2 - (n.F E_1) tau_2.dn + (n.F E_2) tau_1.dn,
  ///
  /// uS,j being derivatives along the reference vectors E_j. The tangential part is not symmetric:
  /// the forces have no potential unless the tractions follow from one.
  ///
  /// No matrix is stored: that of a point between two faces of degree 2 in 3D has 54 x 54 entries,
  /// while its product takes a few hundred operations.
  /// @param rows those of the gap operator
  /// @param traction at the rows: normal pressure, then tangential components [force/length^2]
  template <int dim>
  std::unique_ptr<GeometricStiffness>
  geometric_stiffness(const Elasticity<dim>                  &elasticity,
                      const std::vector<ContactSurface<dim>> &surfaces,
                      const ContactRows                      &rows,
                      const PointVectors                     &traction);
} // namespace Signorini
