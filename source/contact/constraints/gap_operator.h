// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/regions.h"
#include "linear_algebra/types.h"
#include <signorini/contact/contact_compliance.h>

#include <functional>
#include <memory>
#include <vector>

namespace Signorini
{
  class ContactMethod;

  /// One vector over the contact points for each component: [0] normal, then the tangential ones if
  /// the law has any. Also used with one vector for each internal variable of the contact law.
  using PointVectors = std::vector<LA::Vector>;

  /// @return the length of a vector at a point.
  /// @param v its components @param i the point
  /// @param first the number of the first component that counts: 1 for the tangential part of a
  /// traction
  double
  length_at(const PointVectors &v, dealii::types::global_dof_index i, unsigned int first = 0);

  /// Coefficients of the contact law, one value for each contact point.
  struct ContactCoefficients
  {
    /// The status that points have at least: stick at those of tied pairs, slip at those of other
    /// pairs without separation, else open.
    LA::Vector least_status;
    LA::Vector stiffness; ///< E/h [force/length^3]
    /// Current area per reference area, to which tractions refer; 1 at small strain.
    LA::Vector area_ratio;
    /// Penalty of the contact law, ContactMethod::penalty() times Decisions::penalty_factor
    /// [force/length^3].
    LA::Vector epsilon;
    /// The friction coefficient mu at the present time, where bound_of is null; else any positive
    /// number where there is friction, and zero where there is none.
    LA::Vector friction;
    /// The bound of the tangential traction by point and positive pressure, if it is not mu p. Both
    /// per reference area, while the user's formula is that of true pressures and stresses.
    std::function<double(dealii::types::global_dof_index, double)> bound_of;

    /// The bound of the tangential traction [force/length^2], and its derivative by the pressure.
    struct FrictionBound
    {
      double value, by_pressure;
    };

    /// The bound at a point for a pressure; zero in tension.
    FrictionBound
    friction_bound(dealii::types::global_dof_index point, double pressure) const;

    /// The compliance of the interface at each point; null: it is rigid.
    std::function<const ContactCompliance &(dealii::types::global_dof_index)> compliance_of;
    /// True if any of them depends on the pressure.
    bool has_nonlinear_compliance = false;

    /// ContactCompliance::overclosure(), for a pressure per reference area.
    ContactCompliance::Value
    overclosure(dealii::types::global_dof_index point, double pressure) const;

    /// ContactCompliance::pressure(), of pressures per reference area.
    ContactCompliance::Value
    pressure(dealii::types::global_dof_index point, double trial, double epsilon) const;

    /// Slip per tangential traction per reference area, of points that stick [length^3/force].
    double
    tangential_compliance(dealii::types::global_dof_index point) const;
  };

  /// Positions and normals of the contact points, one vector for each space component; for moments
  /// of contact forces and for output.
  struct PointGeometry
  {
    /// In the reference configuration [length].
    std::vector<LA::Vector> position;
    /// Weighted mean of the normals; not of unit length on curved faces.
    std::vector<LA::Vector> normal;
    /// Moment x cross n of a unit force along the normal; 1 component in 2D, 3 in 3D.
    std::vector<LA::Vector> moment;
    /// The moment of the reaction on the master, whose point of application differs in displaced
    /// configurations; empty in the reference configuration.
    std::vector<LA::Vector> master_moment;
  };

  /// Which pairs, nodes and faces the contact points of this rank belong to.
  struct PointOrigin
  {
    std::vector<unsigned int> pair; ///< contact pair of each owned point
    /// Degree of freedom (first component) of the slave node of each; empty for quadrature points.
    std::vector<dealii::types::global_dof_index> node;
    /// The positions of the contact points on the slave faces of this rank, and the indices of the
    /// points at these positions, including those of other ranks.
    std::vector<SurfacePoints> places;
    /// The owned points, and those of other ranks that `places` refers to.
    dealii::IndexSet readable;
    /// Connectivity of the points, for the active-set strategy.
    ContactRegions regions;
  };

  /// The contact geometric stiffness G: the derivative of the contact forces with respect to the
  /// displacement at fixed tractions, see geometric_stiffness().
  class GeometricStiffness
  {
  public:
    virtual ~GeometricStiffness() = default;

    /// dst += factor G v. Collective.
    virtual void
    vmult_add(LA::Vector &dst, const LA::Vector &v, double factor) const = 0;

    /// Call add(row number, column number, value) for the entries of G between numbered degrees of
    /// freedom, summand by summand. Collective.
    /// @param numbers the number of each degree of freedom of this rank; negative: not numbered
    virtual void
    for_each_entry(const LA::Vector                                  &numbers,
                   const std::function<void(double, double, double)> &add) const = 0;

    /// @return bytes on this rank
    virtual std::size_t
    memory_consumption() const = 0;
  };

  /// The slip of the slave relative to the master along dim - 1 tangents of each point, B_a u +
  /// offset_a; empty unless the contact law depends on the slip.
  struct TangentialRows
  {
    /// One matrix for each tangent, with the columns of GapOperator::B and B_free.
    std::vector<LA::SparseMatrix> B, B_free;
    PointVectors offset; ///< one vector for each tangent, see GapOperator::set_start()
    /// Unit tangents in the reference configuration, [a][d]: component d of tangent a at all
    /// points.
    std::vector<std::vector<LA::Vector>> at_rest;
    /// Weighted mean of the present tangents, as PointGeometry::normal; and the moments of unit
    /// forces along them on the slave and of the reactions on the master, as of PointGeometry,
    /// which differ from each other in displaced configurations only. [a][d]
    std::vector<std::vector<LA::Vector>> direction, moment, master_moment;
  };

  /// The linearisation of contact about a displaced configuration u_k; empty in the reference
  /// configuration.
  struct MovedContact
  {
    LA::Vector gap_offset;                 ///< true gap at u_k minus (B u_k + reference_gap)
    LA::Vector linearisation_point;        ///< u_k
    std::unique_ptr<GeometricStiffness> G; ///< null: zero
  };

  /// The discrete gap g = B u + g_0 at the contact points, where the method imposes contact:
  /// quadrature points, or slave nodes A with the weighted gap g_A = int psi_A g dA / int psi_A dA.
  /// A contact pressure p (positive in compression) exerts the force B^T W p on the bodies, where W
  /// is the diagonal matrix of the points' areas. Does not depend on the space dimension, so that
  /// solvers are compiled only once.
  ///
  /// Nitsche's method also needs the stress s = S u + s_0 of the bodies at the points, with the
  /// components of the traction on the slave: the normal one, positive in compression, and the
  /// tangential ones if the law depends on the slip, less the surface loads there. Its forces are
  /// B^T W p + theta S^T W (s - p)/eps, summed over the components. s_0 collects surface loads,
  /// thermal strain and, at finite strain, the offset of the linearisation, S being the derivative
  /// of the stress. Bodies in displacement-pressure form add T m to s, with their volumetric stress
  /// m, and get the force theta T^T W (s - p)/eps on m.
  struct GapOperator
  {
    dealii::IndexSet dofs; ///< locally owned degrees of freedom
    LA::SparseMatrix B;    ///< columns: all degrees of freedom (hanging nodes condensed)
    /// B for changes of free degrees of freedom: columns of prescribed ones are dropped, and those
    /// that inclined supports eliminate are added to the ones that determine them.
    LA::SparseMatrix B_free;
    /// S of each component, and its columns for free degrees of freedom, with the same sparsity
    /// pattern as B; empty unless the method uses the stress.
    std::vector<LA::SparseMatrix> S, S_free;
    /// Of s_0, by ThermalStrain::coefficients(); empty: none expands.
    std::vector<LA::SparseMatrix> S_thermal;
    PointVectors thermal_stress; ///< S_thermal times the present temperature changes; empty: zero
    PointVectors fixed_stress;   ///< the remaining part of s_0; empty: zero
    /// T, by VolumetricStress::coefficients(); empty: no body is mixed.
    std::vector<LA::SparseMatrix> S_volumetric;
    double theta = 0; ///< 1, 0 or -1: variant of Nitsche's method; 0 for other methods
    bool   has_condensed_constraints =
      false; ///< B refers to components that supports tie to others, see B_free
    /// Area of each point; their sum is the slave area that has a projection.
    LA::Vector weight;
    LA::Vector reference_gap; ///< reference gap of each point, from the geometry [length]
    /// The gap g_0 of (5.2): reference_gap, times the present share of initial penetrations at
    /// overlapping and bilateral points, plus moved.gap_offset in displaced configurations.
    LA::Vector initial_gap;
    /// The gap from which that of ties which begin late is measured [length]; empty: zero.
    LA::Vector gap_at_start;
    /// Present share of initial penetrations, for each pair; empty: 1.
    std::vector<double> interference;

    TangentialRows      tangential;
    MovedContact        moved;
    ContactCoefficients coefficients;
    PointGeometry       geometry;
    PointOrigin         origin;

    /// Set the initial gap from the reference gap for present interference factors (doc/theory,
    /// (5.2)).
    /// @param shares factor of initial penetrations, for each pair
    void
    set_interference(const std::vector<double> &shares);

    /// Set the displacement from which the slip is measured, that at the end of the last load step.
    /// In displaced configurations it has no effect: there the slip is measured from
    /// Configuration::start().
    void
    set_start(const LA::Vector &u);

    /// Set the thermal part of the stress. Collective.
    /// @param temperature_change ThermalStrain::coefficients(); ignored without S_thermal
    void
    set_temperature_change(const LA::Vector &temperature_change);

    /// The gaps B u + g_0 [length], positive if open. @param u must satisfy its constraints
    LA::Vector
    gap(const LA::Vector &u) const;

    /// gap(), followed by the slip along each tangent [length].
    PointVectors
    gaps(const LA::Vector &u) const;

    /// The stress of the bodies S u + s_0 + T m, its normal component positive in compression
    /// [force/length^2]; zero if no method needs it.
    /// @param m VolumetricStress::coefficients(); ignored without T
    PointVectors
    stress(const LA::Vector &u, const LA::Vector &m = LA::Vector()) const;

    /// The contact forces of the tractions on free degrees of freedom, zero on all others.
    /// @param p normal pressure (positive in compression) and tangential tractions [force/length^2]
    /// @param s stress; ignored if theta is 0
    LA::Vector
    force(const PointVectors &p, const PointVectors &s) const;

    /// The contact forces on the volumetric stress, theta T^T W (s - p)/eps. Requires
    /// has_volumetric_stress().
    LA::Vector
    force_on_volumetric_stress(const PointVectors &p, const PointVectors &s) const;

    /// The contact forces as of force(), on prescribed degrees of freedom too: for reactions.
    LA::Vector
    total_force(const PointVectors &p, const PointVectors &s) const;

    /// dst += G (u - u_k): the change of the contact forces since the linearisation at u_k that B^T
    /// W p does not contain.
    void
    add_moved_force(LA::Vector &dst, const LA::Vector &u) const;

    /// dst -= G v, in the tangent K - G. Collective.
    void
    subtract_geometric(LA::Vector &dst, const LA::Vector &v) const;

    /// GeometricStiffness::for_each_entry() of G; no calls if G is zero.
    void
    for_each_geometric_entry(const LA::Vector                                  &numbers,
                             const std::function<void(double, double, double)> &add) const;

    /// A zero vector over the contact points, without ghosts.
    LA::Vector
    zero() const
    {
      LA::Vector v;
      v.reinit(weight);
      return v;
    }

    /// True if there are no contact points on any rank.
    bool
    empty() const
    {
      return weight.size() == 0;
    }

    /// Components of a contact point: 1, or as many as the dimension if the law depends on the
    /// slip.
    unsigned int
    n_components() const
    {
      return 1 + tangential.B.size();
    }

    /// The matrix of component a of the points, 0 being normal, for all degrees of freedom. All
    /// components have the same columns.
    const LA::SparseMatrix &
    rows(const unsigned int a) const
    {
      return a == 0 ? B : tangential.B[a - 1];
    }
    /// The same rows without the columns of prescribed displacements, with those of inclined
    /// supports condensed.
    const LA::SparseMatrix &
    free_rows(const unsigned int a) const
    {
      return a == 0 ? B_free : tangential.B_free[a - 1];
    }

    /// A zero vector for each component.
    PointVectors
    zeros() const
    {
      return PointVectors(n_components(), zero());
    }

    /// Call act(i, pair) for the points of this rank: their number, and that of their pair.
    template <typename Action>
    void
    for_each_point(const Action &act) const
    {
      auto pair = origin.pair.begin();
      for (const auto i : weight.locally_owned_elements())
        act(i, *pair++);
    }

    /// One more than the largest number of a pair that has contact points on any rank. Collective.
    unsigned int
    n_pairs() const;

    /// @return bytes of the matrices and vectors on this rank
    std::size_t
    memory_consumption() const;

    /// True if contact was searched for in the reference configuration, false in a displaced one.
    bool
    at_rest() const
    {
      return moved.gap_offset.size() == 0;
    }

    /// True for Nitsche's method.
    bool
    has_stress() const
    {
      return !S.empty();
    }

    /// True if the stress depends on the volumetric stress of bodies in
    /// displacement-pressure form.
    bool
    has_volumetric_stress() const
    {
      return !S_volumetric.empty();
    }

  private:
    /// The residual term of Nitsche's method to which S^T is applied: theta W (s - p)/eps.
    /// @param p a component of the traction @param s that of the stress
    LA::Vector
    nitsche_residual(const LA::Vector &p, const LA::Vector &s) const;
    /// B^T W p + theta S^T W (s - p)/eps with the rows for free degrees of freedom, or for all.
    LA::Vector
    transposed(bool is_free, const PointVectors &p, const PointVectors &s) const;
  };

  /// Assemble the gap operator. Collective.
  /// @param surfaces one for each contact pair, made in `configuration`
  /// @param rows make_contact_rows() of the surfaces
  template <int dim>
  std::unique_ptr<GapOperator>
  make_gap_operator(const Configuration<dim>               &configuration,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const ContactRows                      &rows,
                    const ContactMethod                    &method);

  /// The gap operator in the reference configuration, with rows made for its surfaces. Collective.
  template <int dim>
  std::unique_ptr<GapOperator>
  make_gap_operator(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const ContactMethod                    &method);
} // namespace Signorini
