// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/bytes.h"

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <boost/serialization/vector.hpp>

#include <array>
#include <utility>
#include <vector>

namespace Signorini
{
  /// A sparse row: (degree of freedom, coefficient).
  using SparseRow = std::vector<std::pair<dealii::types::global_dof_index, double>>;

  /// The shape function of a node at a point of a face.
  template <int dim>
  struct NodeShapeFunction
  {
    /// First degree of freedom of the node; the other components follow.
    dealii::types::global_dof_index node;
    double                          value;
    std::array<double, dim - 1>     slopes; ///< derivatives with respect to the face parameters
  };

  /// The shape functions of all nodes of a face at one point, hanging nodes condensed: u = sum
  /// value u(node).
  template <int dim>
  using FaceShapeFunctions = std::vector<NodeShapeFunction<dim>>;

  /// The displacement at the point of the shape functions.
  /// @param u gives the element u(dof) of the displacement vector
  template <int dim, typename Elements>
  dealii::Tensor<1, dim>
  value_at(const FaceShapeFunctions<dim> &functions, const Elements &u)
  {
    dealii::Tensor<1, dim> sum;
    for (const NodeShapeFunction<dim> &function : functions)
      for (unsigned int d = 0; d < dim; ++d)
        sum[d] += function.value * u(function.node + d);
    return sum;
  }

  /// A point on a master surface.
  template <int dim>
  struct MasterPoint
  {
    dealii::Point<dim>     position;
    dealii::Tensor<1, dim> normal;   ///< outward unit normal of the master there
    double                 distance; ///< distance from the slave's point, >= 0 [length]
    /// Center of the face, which identifies it: ties are broken alike on any number of ranks.
    dealii::Point<dim> face_center;
    double             stiffness;   ///< E/h of the master cell [force/length^3]
    double             modulus = 0; ///< E of the master cell; 0: rigid
    double             size    = 0; ///< diameter of the master's face [length]
    double bound = 0; ///< bound of the master cell's normal stress, see NormalStress::bound()
    dealii::Point<dim> rest; ///< position of the material point in the reference configuration
    /// Its position at the start of the load step; set if the method uses the slip.
    dealii::Point<dim> start;
    unsigned int       kind = 0; ///< kind of its face, where the search distinguishes kinds
  };

  /// The second variation of the gap (doc/theory, 5.3 to 5.5), sum_ij C_ij (T_i.d) (T_j.d') for
  /// increments d and d' of the degrees of freedom. With n directions v, of which number 0 is the
  /// contact normal,
  ///
  ///   T_i.d     = v_i.(u^S - u^M) + (rigid_i).d,   i < n; no u^M of obstacles
  ///   T_(n+a).d = (rigid_(n+a)).d                  of obstacles
  ///   T_(n+a).d = normal.du^M/dxi_a                of bodies
  ///
  /// See contact/constraints/gap_second_variation.h.
  template <int dim>
  struct GapSecondVariation
  {
    std::vector<dealii::Tensor<1, dim>> directions; ///< v
    /// Rows of an obstacle's rigid-body degrees of freedom; empty for bodies.
    std::vector<SparseRow> rigid;
    /// C, row by row; empty: the second variation vanishes or is not known.
    std::vector<double> factors;

    /// The number of rows T_i.
    unsigned int
    n_rows() const
    {
      return rigid.empty() ? 2 * directions.size() : rigid.size();
    }

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      // Rows of obstacles are never sent.
      serialize_bytes(ar, directions);
      serialize_bytes(ar, factors);
    }
  };

  /// A component of the traction that the stress of a body exerts on the slave at a contact point,
  /// along a unit vector: stress = displacement.u + thermal.T + volumetric.m + offset.
  struct StressRow
  {
    SparseRow displacement; ///< by degrees of freedom, hanging nodes condensed
    SparseRow thermal;      ///< of temperature changes, over ThermalStrain::coefficients()
    SparseRow volumetric;   ///< of the volumetric stress, over VolumetricStress::coefficients()
    /// Part that depends on no unknown: surface loads, which contact does not carry, and at finite
    /// strain the offset of the linearisation [force/length^2].
    double offset = 0;
    double value  = 0; ///< finite strain: the present Cauchy stress [force/length^2]

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      for (SparseRow *row : {&displacement, &thermal, &volumetric})
        serialize_bytes(ar, *row);
      ar &offset &value;
    }
  };

  /// The projection of a slave point onto the master: the closest point, with the shape functions
  /// and the stress of the master there.
  template <int dim>
  struct MasterProjection : public MasterPoint<dim>
  {
    /// Displacement shape functions of the master's body; empty for obstacles.
    FaceShapeFunctions<dim> functions;
    /// Normal.u of an obstacle at the point, by its rigid-body degrees of freedom.
    SparseRow rigid;
    /// The displacement of an obstacle at the point, component by component, by its rigid-body
    /// degrees of freedom; set if the method uses the slip.
    std::array<SparseRow, dim> rigid_motion;
    /// Components of the master's stress, for Nitsche's method only: normal (positive in
    /// compression), and along vectors_across(normal) if the method uses the slip.
    std::vector<StressRow>  stress;
    GapSecondVariation<dim> second_variation; ///< where surfaces have moved; its factors not yet,
                                              ///< see second_variation_of_bodies()

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      serialize_bytes(ar, static_cast<MasterPoint<dim> &>(*this));
      serialize_bytes(ar, functions);
      serialize_bytes(ar, rigid);
      ar &stress &second_variation;
    }
  };
} // namespace Signorini
