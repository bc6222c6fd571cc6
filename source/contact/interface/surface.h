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
#include <optional>
#include <utility>
#include <vector>

namespace Signorini
{
  class ContactMethod;

  /// A contact point: a point of integration on a slave face, with its projection on the master and
  /// all that the gap operator needs to assemble its rows. Owned by the ContactSurface of its pair,
  /// on the rank that owns the slave cell.
  template <int dim>
  struct ContactPoint
  {
    dealii::Point<dim> position; ///< in the reference configuration
    /// Unit contact normal, out of the master, in the current configuration.
    dealii::Tensor<1, dim> normal;
    double                 weight; ///< quadrature weight times area, in the reference configuration
    double                 stretch = 1; ///< current area per reference area; 1 at small strain
    /// Minus the product of the unit normals of both surfaces; 1: opposite.
    double normal_alignment;
    double gap; ///< reference gap g_0, positive if open: g = (u^S - u^M).n + g_0
    /// Decrease of the gap from `gap` to the current one; 0 in the reference configuration.
    double gap_decrease = 0;
    /// Part of the gap that Initial gap prescribes beyond the geometry.
    double prescribed_gap = 0;
    /// Offset of the linearised gap: g = row . u + gap + gap_offset near the current configuration.
    double gap_offset = 0;
    /// Position of the projection in the reference configuration; unset for obstacles.
    dealii::Point<dim> master_position;
    /// The points of application of the contact force on slave and master: in the reference
    /// configuration at small strain, in the current one at finite strain.
    dealii::Point<dim> slave_force_point, master_force_point;
    double             stiffness; ///< E/h of slave and master in series [force/length^3]
    double             depth;     ///< size h of the slave cell normal to the face [length]
    /// Unit vector along which the gap opens: the normal out of the face that is the master of this
    /// point. Where an unbiased method exchanges the roles of the surfaces, that face belongs to
    /// the slave of the pair.
    dealii::Tensor<1, dim> direction;
    /// Displacement shape functions of the slave and of the master at the point and its projection,
    /// hanging nodes condensed; the master's are empty for obstacles.
    FaceShapeFunctions<dim> slave, master;
    /// The rotation of the master's image, see MasterImage; nothing: none.
    std::optional<dealii::Tensor<2, dim>> turn;
    /// For obstacles: the displacement along `direction`, over rigid-body degrees of freedom.
    SparseRow rigid;
    /// The multiplier shape functions at the point: (first degree of freedom of the node, value),
    /// hanging nodes condensed. For pointwise methods these are the trace shape functions of the
    /// slave.
    SparseRow multiplier_shape;
    /// Shape functions by which a pressure in the dual basis is evaluated, in the standard basis;
    /// empty if both are the same, then `multiplier_shape`.
    SparseRow              interpolation;
    unsigned int           face; ///< number of the slave face on this rank
    dealii::Point<dim - 1> xi;   ///< parameters of the point on the slave face, in [0,1]

    // For methods that predict the traction by the stress of the bodies:
    /// Weighted means of both bodies' stresses per reference area: normal (positive in
    /// compression), and along vectors_across(direction) if the method uses the slip.
    std::vector<StressRow> stress;
    /// Bound of the square of the stress by the strain energy of the cells [force/length^3].
    double bound = 0;

    GapSecondVariation<dim> second_variation; ///< set in displaced configurations only

    /// The gap in the configuration of the search [length]: the reference gap minus its decrease.
    double
    current_gap() const
    {
      return gap - gap_decrease;
    }

    /// A direction at the image of the master, as it is at the master itself: u^M.on_master(v) is
    /// the component of the displacement of the image along v.
    dealii::Tensor<1, dim>
    on_master(const dealii::Tensor<1, dim> &v) const
    {
      return turn ? v * *turn : v;
    }

    /// The row of the point in the gap operator, (u^S - u^M).direction = row . u, with the entries
    /// of all components of displacement. Columns may be degrees of freedom of other ranks.
    SparseRow
    row() const;
  };

  /// The local geometry of the slave surface at a contact point, for contact laws that depend on
  /// the slip. Set only if ContactMethod::uses_slip().
  template <int dim>
  struct SurfaceFrame
  {
    /// N, outward unit normal of the slave in the reference configuration.
    dealii::Tensor<1, dim> normal;
    /// Deformation gradient F of the slave's surface: maps tangential vectors and the normal of the
    /// reference configuration to those of the current one.
    dealii::Tensor<2, dim> deformation;
    dealii::Tensor<1, dim> apart; ///< vector from the projection to the slave's point [length]
    /// `deformation` and `apart` at the start of the load step; equal to the present ones in the
    /// reference configuration.
    dealii::Tensor<2, dim> deformation_at_start;
    dealii::Tensor<1, dim> apart_at_start;
    /// E_j = sum_a parameters[j][a] dX/dxi_a: orthonormal vectors along the slave at rest.
    std::array<dealii::Tensor<1, dim - 1>, dim - 1> parameters;
    /// The displacement of an obstacle at the projection, component by component, by its
    /// rigid-body degrees of freedom; empty for bodies and for obstacles at rest.
    std::array<SparseRow, dim> rigid_motion;
  };

  /// A quadrature point of a segment edge, where the contact segment ends because its master face
  /// ends. It contributes to the geometric stiffness alone, not to gaps, see
  /// second_variation_of_edge().
  template <int dim>
  struct EdgeContactPoint
  {
    /// Reference area that an outward shift of the edge by 1 adds [length^(dim-1) per length].
    double weight;
    /// Displacement shape functions at the point, as those of a ContactPoint.
    FaceShapeFunctions<dim> slave, master;
    GapSecondVariation<dim> second_variation;
    /// Multiplier shape functions at the point, as of a ContactPoint.
    SparseRow              multiplier_shape;
    unsigned int           face; ///< number of the slave face on this rank
    dealii::Point<dim - 1> xi;
  };

  /// Which components of the displacement take part.
  using Components = std::array<bool, 3>;

  /// Call add(column, value) for the entries of the row of a contact point in the given components.
  /// Entries of one column may come in several calls.
  template <int dim, typename Add>
  void
  for_each_entry(const ContactPoint<dim> &point, const Components &components, const Add &add)
  {
    for (const double sign : {1., -1.})
      {
        const dealii::Tensor<1, dim> n =
          sign > 0 ? point.direction : point.on_master(point.direction);
        for (const NodeShapeFunction<dim> &function : sign > 0 ? point.slave : point.master)
          if (std::abs(function.value) > 1e-14)
            for (unsigned int d = 0; d < dim; ++d)
              if (components[d])
                add(function.node + d, sign * function.value * n[d]);
      }
    for (const auto &[column, value] : point.rigid)
      add(column, -value);
  }

  /// True if the shape functions of two points belong to the same nodes in the same order.
  /// Successive points mostly lie between the same two faces, so that work for the nodes can be
  /// reused.
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

  /// A node of a face of degree 2 between two nodes whose pressures determine the one there.
  struct NodeBetween
  {
    dealii::types::global_dof_index node; ///< first degree of freedom
    std::array<unsigned int, 2>     ends; ///< numbers among the nodes of the face
  };

  /// The nodes of a slave face that carry the pressure, in lexicographic order of the face
  /// parameters; hanging nodes are listed themselves.
  template <int dim>
  struct SlaveFace
  {
    dealii::CellId cell;
    unsigned int   face = 0; ///< of the cell
    /// Of the pressure: that of the element, or 1 on triangles; 0: the face has no points.
    unsigned int                                 degree = 0;
    std::vector<dealii::types::global_dof_index> nodes; ///< first degrees of freedom
    /// Positions of the nodes: reference at small strain, current at finite strain.
    std::vector<dealii::Point<dim>> positions;
    /// Flags of the nodes, in their order: nodes without a multiplier of their own on this face
    /// (see PressureBasis), and those among them that have none because the master covers too
    /// little of their area.
    std::vector<bool> without_pressure, under_covered;
    /// The further nodes of triangles of degree 2.
    std::vector<NodeBetween> between;
    /// Share of the face's area that has a projection on the master, in [0,1].
    double covered = 0;

    /// The reference cell of the face.
    dealii::ReferenceCell
    reference_cell() const
    {
      return shape_of_lattice(dim, degree, nodes.size());
    }
  };

  /// The discretised contact surface of one pair: the contact points of locally owned slave faces
  /// that have a projection on the master.
  template <int dim>
  struct ContactSurface
  {
    /// The contact points of the faces of this rank, sorted by face.
    std::vector<ContactPoint<dim>> points;
    /// The frames of the points and of the segment edge points, in their order. Empty unless
    /// ContactMethod::uses_slip().
    std::vector<SurfaceFrame<dim>> frames, edge_point_frames;
    /// The points of segment edges; set in displaced configurations with integration by segments.
    std::vector<EdgeContactPoint<dim>> edge_points;
    /// (multiplier shape functions, weight) at quadrature points of whole slave faces, with or
    /// without projection: the integrals that the nodes would have if the master covered every
    /// slave face.
    std::vector<std::pair<SparseRow, double>> full_face_shapes;
    /// The nodes of each slave face, indexed by the number of the face; default entries for faces
    /// without points.
    std::vector<SlaveFace<dim>> slave_faces;
    /// True if any node on any rank has no multiplier because its normal displacement is
    /// prescribed.
    bool has_dirichlet_nodes = false;
    /// Counters of the search on this rank.
    SearchStatistics statistics;
    /// Number of slave faces on this rank, with those that unbiased methods add from the pair's
    /// master.
    unsigned int faces = 0;
    /// Number of slave faces of the pair's slave alone.
    unsigned int own_faces = 0;
    /// False for pairs without separation (bilateral contact).
    bool can_separate = true;
    bool is_tied      = false; ///< see ContactPair
    /// Faces with larger gaps are no candidates [length].
    double candidate_gap = 0;
    double overlap       = 0;     ///< largest penetration at any point, over all ranks [length]
    bool   is_apart      = false; ///< true if no face is a candidate for contact, on any rank
    /// True if no point has a projection within the search radius.
    bool has_no_projection = false;
    /// Mean diameter of the slave faces with points, weighted by their areas.
    double face_size = 0;
    /// Share of the area whose projections do not coincide with master nodes.
    double non_matching_share = 0;
    Sides  sides; ///< comparison of slave and master; both alike if the master is an obstacle
    /// In displaced configurations: all integration points, before candidates were selected, so
    /// that a later update of the configuration can project the same ones again.
    std::vector<FixedIntegrationPoint<dim>> fixed_points, fixed_points_on_master;
  };

  /// Tolerances of the contact search of one pair.
  struct SearchTolerance
  {
    /// Gap up to which faces are candidates for contact [length]. The surface uses at least twice
    /// the largest penetration, and in the reference configuration at most the search distance of
    /// the pair, if it has one.
    double candidate_gap = 0;
    /// Lower bound of the search radius [length]: the largest penetration to be found.
    double limit = 0;
    /// In the reference configuration: true if the displacements and penetrations are known from an
    /// earlier solution, so that nothing has to be searched for beyond the two values above.
    bool is_final = false;
  };

  /// The share of the slave's area, in [0,1], that has a projection on the master. Collective.
  template <int dim>
  double
  covered_share(const ContactSurface<dim> &surface, MPI_Comm comm);

  /// Integrate over the slave and project its points onto the master. With an unbiased method
  /// either surface is slave of the other with half of its area; all normals still point out of the
  /// pair's master. Collective.
  /// @param configuration where the surfaces are
  /// @param obstacle the rigid master; null if the master is a boundary of a body
  /// @param range how far to search
  /// @param former an earlier surface whose integration points are to be projected again; null: new
  /// points
  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Configuration<dim>  &configuration,
                       const ContactPair<dim>    &pair,
                       const Obstacle<dim>       *obstacle,
                       const ContactMethod       &method,
                       const Integration         &integration,
                       const SearchTolerance     &range,
                       const ContactSurface<dim> *former);

  /// The contact surface of a pair in the reference configuration, with the search tolerances that
  /// its settings imply. Collective.
  template <int dim>
  ContactSurface<dim>
  make_contact_surface(const Elasticity<dim>  &elasticity,
                       const ContactPair<dim> &pair,
                       const Obstacle<dim>    *obstacle,
                       const ContactMethod    &method,
                       const Integration      &integration);
} // namespace Signorini
