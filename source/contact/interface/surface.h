// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/pressure_basis.h"
#include "contact/interface/pairing.h"
#include "contact/interface/sides.h"
#include "contact/search/configuration.h"
#include "solid/elasticity.h"
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/contact/pair.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace Signorini
{
  class ContactMethod;

  /// A point of integration on a slave face with its projection on the master, ready for assembly.
  template <int dim>
  struct ContactPoint
  {
    dealii::Point<dim>     position;         ///< at rest
    dealii::Tensor<1, dim> normal;           ///< unit, out of the master, where it is now
    double                 weight;           ///< area at rest that the point stands for
    double                 stretch = 1;      ///< area now per area at rest, of large deformation
    double                 normal_alignment; ///< minus the product of both surfaces' unit normals
    double                 gap;              ///< at rest: g = (u^S - u^M).n + g_0
    double gap_decrease   = 0; ///< by which it is less where the surfaces are now; at rest 0
    double prescribed_gap = 0; ///< gap beyond that of the geometry, by Initial gap
    double gap_offset     = 0; ///< to be added there: g = row . d + gap + gap offset about it
    dealii::Point<dim> master_position; ///< of the projection at rest; not of obstacles
    /// Where forces act on slave and master: at rest, or, of large deformation, now.
    dealii::Point<dim> slave_force_point, master_force_point;
    double             stiffness; ///< E/h of slave and master in series [force/length^3]
    double             depth;     ///< of the slave's cell behind the face: h
    /// Along which the gap opens: the normal, out of the face that is the master of this point,
    /// which is the pair's slave at some points of unbiased methods.
    dealii::Tensor<1, dim>  direction;
    FaceShapeFunctions<dim> slave, master; ///< of displacements; obstacles have none
    SparseRow               rigid;         ///< direction.u of an obstacle
    /// The functions of the pressure at the point: (first degree of freedom of the node, value),
    /// hanging nodes condensed. For point-wise methods the trace shape functions.
    SparseRow    multiplier_shape;
    SparseRow    interpolation; ///< of a pressure in the dual basis; empty: `multiplier_shape`
    unsigned int face;          ///< number of the slave face on this rank
    dealii::Point<dim - 1> xi;  ///< the parameter there

    // For methods that predict the pressure by the stress of the bodies:
    SparseRow stress; ///< normal stress by area at rest of both bodies, positive in compression
    SparseRow thermal_stress;    ///< likewise that of rises, of ThermalStrain::coefficients()
    SparseRow volumetric_stress; ///< likewise that of VolumetricStress::coefficients()
    double    stress_offset = 0; ///< what it is beyond: of loads there, and of large deformation
    double    bound         = 0; ///< of its square by the energy of the cells [force/length^3]

    GapSecondVariation<dim> second_variation; ///< where surfaces have moved

    double
    current_gap() const
    {
      return gap - gap_decrease;
    }

    /// (u^S - u^M).direction = sum row . d, of all components. The degrees of freedom may be on
    /// other ranks.
    SparseRow
    row() const;
  };

  /// The slave surface at a contact point, for laws that ask for the slip.
  template <int dim>
  struct SurfaceFrame
  {
    dealii::Tensor<1, dim> normal; ///< N, outward unit normal of the slave at rest
    /// F: what vectors along the slave at rest have become, and its normal.
    dealii::Tensor<2, dim> deformation;
    dealii::Tensor<1, dim> apart; ///< the slave's point less its projection
    /// Both at the start of the load step, where surfaces have moved from there; else as now.
    dealii::Tensor<2, dim> deformation_at_start;
    dealii::Tensor<1, dim> apart_at_start;
    /// E_j = sum_a parameters[j][a] dX/dxi_a: orthonormal vectors along the slave at rest.
    std::array<dealii::Tensor<1, dim - 1>, dim - 1> parameters;
  };

  /// A point where a segment ends with its master face, see second_variation_of_edge(). It has no
  /// share in gaps.
  template <int dim>
  struct EdgeContactPoint
  {
    double                  weight; ///< area at rest that an outward step of 1 adds
    FaceShapeFunctions<dim> slave, master;
    GapSecondVariation<dim> second_variation;
    SparseRow               multiplier_shape; ///< as that of contact points
    unsigned int            face;             ///< likewise
    dealii::Point<dim - 1>  xi;
  };

  /// Components of displacements, by number.
  using Components = std::array<bool, 3>;

  /// Calls add(column, value) for what the row of a point has in these components.
  template <int dim, typename Add>
  void
  for_each_entry(const ContactPoint<dim> &point, const Components &components, const Add &add)
  {
    for (const double sign : {1., -1.})
      for (const NodeShapeFunction<dim> &function : sign > 0 ? point.slave : point.master)
        if (std::abs(function.value) > 1e-14)
          for (unsigned int d = 0; d < dim; ++d)
            if (components[d])
              add(function.node + d, sign * function.value * point.direction[d]);
    for (const auto &[column, value] : point.rigid)
      add(column, -value);
  }

  /// Are their functions those of the same nodes? Points one after the other are between the same
  /// two faces, most of the time.
  template <typename Point>
  bool
  same_nodes(const Point &a, const Point &b)
  {
    const auto same = [](const auto &of_a, const auto &of_b) {
      return std::equal(of_a.begin(),
                        of_a.end(),
                        of_b.begin(),
                        of_b.end(),
                        [](const auto &x, const auto &y) { return x.node == y.node; });
    };
    return same(a.slave, b.slave) && same(a.master, b.master);
  }

  /// The nodes of a slave face, lexicographic in its parameter; hanging ones as they are.
  template <int dim>
  struct SlaveFace
  {
    dealii::CellId                               cell;
    unsigned int                                 face   = 0; ///< of the cell
    unsigned int                                 degree = 0; ///< 0: the face has no points
    std::vector<dealii::types::global_dof_index> nodes;      ///< first degrees of freedom
    std::vector<dealii::Point<dim>> positions; ///< at rest; of large deformation as they are now
    /// Nodes without a pressure of their own on this face, see PressureBasis; and those of them of
    /// whose area here the master covers too little.
    std::vector<bool> without_pressure, under_covered;
    double            covered = 0; ///< share of the area that has a projection
  };

  /// The contact points of one pair on this rank (of locally owned slave faces) that have a
  /// projection.
  template <int dim>
  struct ContactSurface
  {
    std::vector<ContactPoint<dim>> points; ///< face by face
    /// Of the points and of the segment edges, if the law asks for the slip.
    std::vector<SurfaceFrame<dim>>     frames, edge_point_frames;
    std::vector<EdgeContactPoint<dim>> edge_points;
    /// (shape, weight) at points of whole slave faces, with or without projections: what the nodes
    /// would have if the master were everywhere.
    std::vector<std::pair<SparseRow, double>> full_face_shapes;
    std::vector<SlaveFace<dim>>               slave_faces; ///< by their numbers
    bool             has_dirichlet_nodes = false;          ///< any node, on any rank
    SearchStatistics statistics;
    unsigned int     faces         = 0;
    unsigned int     own_faces     = 0;     ///< without those of the master of unbiased methods
    bool             can_separate  = true;  ///< as its pair says
    double           candidate_gap = 0;     ///< faces with larger gaps are no candidates
    double           overlap       = 0;     ///< the deepest one, on any rank
    bool             is_apart      = false; ///< none is one
    bool   has_no_projection  = false; ///< no point has a projection within the search distance
    double face_size          = 0;     ///< of slave faces with points, the mean over their areas
    double non_matching_share = 0; ///< share of the area whose projections are not at master nodes
    Sides  sides;                  ///< alike if the master is an obstacle
    /// Where surfaces have moved, the points of integration, before candidates were chosen.
    std::vector<FixedIntegrationPoint<dim>> fixed_points, fixed_points_on_master;
  };

  /// How far contact is looked for.
  struct SearchTolerance
  {
    /// The gap up to which faces are candidates; at least twice the deepest overlap, and at rest no
    /// more than the search distance of the pair, if there is one.
    double candidate_gap = 0;
    /// At least so far projections are looked for: as deep as surfaces may overlap.
    double limit = 0;
    /// At rest: nothing has to be looked for beyond these two, since displacements and overlaps are
    /// known by now.
    bool is_final = false;
  };

  /// Share of the slave's area that has a projection. Collective.
  template <int dim>
  double
  covered_share(const ContactSurface<dim> &surface, MPI_Comm comm);

  /// Integrate the slave and find the projections. Collective. Unbiased methods get both surfaces,
  /// as slaves of each other with half their areas; all normals point out of the pair's master.
  /// @param obstacle null if the master is a boundary of a body
  /// @param former if the points of integration are to be those of a surface before, though the
  /// bodies have moved since
  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Configuration<dim>  &configuration,
                       const ContactPair<dim>    &pair,
                       const Obstacle<dim>       *obstacle,
                       const ContactMethod       &method,
                       const Integration         &integration,
                       const SearchTolerance     &range,
                       const ContactSurface<dim> *former);

  /// At rest.
  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Elasticity<dim>  &elasticity,
                       const ContactPair<dim> &pair,
                       const Obstacle<dim>    *obstacle,
                       const ContactMethod    &method,
                       const Integration      &integration);
} // namespace Signorini
