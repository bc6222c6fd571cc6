// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/bytes.h"

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <array>
#include <utility>
#include <vector>

namespace Signorini
{
  /// Coefficients of degrees of freedom.
  using SparseRow = std::vector<std::pair<dealii::types::global_dof_index, double>>;

  /// The shape function of a node at a point of a face.
  template <int dim>
  struct NodeShapeFunction
  {
    dealii::types::global_dof_index node; ///< its first degree of freedom; the others follow
    double                          value;
    std::array<double, dim - 1>     slopes; ///< derivatives in the parameters of the face
  };

  /// Those of all nodes of a face, hanging ones condensed: u = sum value u(node).
  template <int dim>
  using FaceShapeFunctions = std::vector<NodeShapeFunction<dim>>;

  /// The displacement there. @param u its elements, u(dof)
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

  /// A place on a master surface.
  template <int dim>
  struct MasterPoint
  {
    dealii::Point<dim>     position;
    dealii::Tensor<1, dim> normal;   ///< outward unit normal of the master there
    double                 distance; ///< closest point distance
    dealii::Point<dim>
           face_center;          ///< identity of the face: breaks ties alike on any number of ranks
    double stiffness;            ///< E/h of the master cell (force / length^3)
    double modulus = 0;          ///< E of the master cell; 0: rigid
    double size    = 0;          ///< of the master's face
    double bound   = 0;          ///< of the master cell's normal stress, see NormalStress::bound()
    dealii::Point<dim> rest;     ///< the position before anything moved
    dealii::Point<dim> start;    ///< that when the load step started, if anybody asks for the slip
    unsigned int       kind = 0; ///< of its face, for who asked for the kinds of faces
  };

  /// How the gap bends: its second variation is sum_ij C_ij (T_i.d) (T_j.d') for changes d and d'
  /// of the degrees of freedom. With n directions v, of which the first is number 0,
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
    std::vector<SparseRow>              rigid;      ///< of an obstacle; empty: none
    std::vector<double>                 factors;    ///< C; empty: it does not bend, or none knows

    unsigned int
    n_rows() const
    {
      return rigid.empty() ? 2 * directions.size() : rigid.size();
    }

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      serialize_bytes(ar, directions); // obstacles' rows do not travel
      serialize_bytes(ar, factors);
    }
  };

  /// The place on a master surface that belongs to a slave point, and how it moves.
  template <int dim>
  struct MasterProjection : public MasterPoint<dim>
  {
    FaceShapeFunctions<dim> functions; ///< of its body there
    SparseRow               rigid;     ///< normal.u of an obstacle there
    /// The normal stress of the master there, positive in compression, by degrees of freedom with
    /// hanging nodes condensed; for methods that ask for it.
    SparseRow stress;
    /// That of the rises of the temperature, in terms of ThermalStrain::coefficients().
    SparseRow thermal_stress;
    SparseRow
      volumetric_stress; ///< that of mixed bodies, in terms of VolumetricStress::coefficients()
    double stress_offset = 0; ///< what it is beyond these rows, with loads on the boundary
    double stress_value  = 0; ///< of large deformation, where it is Cauchy's
    GapSecondVariation<dim> second_variation; ///< where surfaces have moved; its factors not yet,
                                              ///< see second_variation_of_bodies()

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      serialize_bytes(ar, static_cast<MasterPoint<dim> &>(*this));
      serialize_bytes(ar, functions);
      serialize_bytes(ar, rigid);
      serialize_bytes(ar, stress);
      serialize_bytes(ar, thermal_stress);
      serialize_bytes(ar, volumetric_stress);
      ar &stress_value &stress_offset &second_variation;
    }
  };
} // namespace Signorini
