// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/regions.h"
#include "linear_algebra/types.h"

#include <functional>
#include <memory>
#include <vector>

namespace Signorini
{
  class ContactMethod;

  /// A vector a component at all contact points: [0] along the normal, then along the tangents, if
  /// there are any; or one an internal variable of the contact law.
  using PointVectors = std::vector<LA::Vector>;

  /// What the contact law needs to know of each point.
  struct ContactCoefficients
  {
    LA::Vector bilateral; ///< 1 at points of pairs that never separate, else 0
    LA::Vector stiffness; ///< E/h [force/length^3]
    LA::Vector epsilon;   ///< of the contact law, ContactMethod::penalty(), likewise
  };

  /// Where the points are, for moments and for reports: a vector a component.
  struct PointGeometry
  {
    std::vector<LA::Vector> position;
    std::vector<LA::Vector> normal; ///< mean, not of unit length on curved faces
    std::vector<LA::Vector> moment; ///< of a unit force along the normal: x cross n; 1 (2D), 3 (3D)
    /// The same about the origin of the reaction on the master, whose places at rest may be others;
    /// empty at rest.
    std::vector<LA::Vector> master_moment;
  };

  /// To what the points of this rank belong.
  struct PointOrigin
  {
    std::vector<unsigned int> pair; ///< contact pair of each
    /// Degree of freedom (first component) of the slave node of each; empty for quadrature points.
    std::vector<dealii::types::global_dof_index> node;
    /// Where on the slave faces of this rank the rows are, and these rows, with those of other
    /// ranks.
    std::vector<SurfacePoints> places;
    dealii::IndexSet           readable;
    ContactRegions             regions;
  };

  /// How the forces of the pressures at the contact points change as surfaces move, see
  /// geometric_stiffness().
  class GeometricStiffness
  {
  public:
    virtual ~GeometricStiffness() = default;

    /// dst += factor G v. Collective.
    virtual void
    vmult_add(LA::Vector &dst, const LA::Vector &v, double factor) const = 0;

    /// Calls add(number of a row, of a column, value) for what is between numbered degrees of
    /// freedom, piece by piece. Collective.
    /// @param numbers of those of this rank; negative: none
    virtual void
    for_each_entry(const LA::Vector                                  &numbers,
                   const std::function<void(double, double, double)> &add) const = 0;

    /// Bytes on this rank.
    virtual std::size_t
    memory_consumption() const = 0;
  };

  /// The slip of the slave relative to the master along dim - 1 tangents of each point, B_a u +
  /// offset_a; empty unless the contact law asks for it.
  struct TangentialRows
  {
    std::vector<LA::SparseMatrix> B, B_free; ///< a matrix a tangent, as those of the gap
    PointVectors                  offset;    ///< a vector a tangent, see GapOperator::set_start()
    /// Unit tangents at rest, [a][d]: component d of tangent a at all points.
    std::vector<std::vector<LA::Vector>> at_rest;
  };

  /// Contact on surfaces that have moved by u_k, to first order about that place; empty at rest.
  struct MovedContact
  {
    LA::Vector gap_offset;          ///< what the true gap at u_k is beyond B u_k + reference_gap
    LA::Vector linearisation_point; ///< u_k
    std::unique_ptr<GeometricStiffness> G; ///< null: zero
  };

  /// The discrete gap g = B u + g_0 at the points where the method imposes contact, one row a
  /// point: a quadrature point, or a slave node A with g_A = int psi_A g dA / int psi_A dA. A
  /// pressure p on the points exerts the force B^T W p, where W are the points' areas. Positive
  /// pressure is compression. Knows nothing of the dimension, so that what uses it is compiled
  /// once.
  ///
  /// With Nitsche's method there is also the normal stress s = S u + s_0 of the bodies at the
  /// points, positive in compression, less what loads exert on the surfaces there, since
  /// sigma n = - p n + t, and p exerts B^T W p + theta S^T W (s - p)/eps. s_0 comes
  /// with such loads, with thermal strain, and with large deformation, where S is the derivative of
  /// the stress where the surfaces are; of mixed bodies, with their volumetric stress m, s has T m
  /// beside, and p exerts theta T^T W (s - p)/eps on m.
  struct GapOperator
  {
    dealii::IndexSet dofs; ///< locally owned degrees of freedom
    LA::SparseMatrix B;    ///< columns: all degrees of freedom (hanging nodes condensed)
    /// The same for changes of free degrees of freedom: without the columns of prescribed
    /// displacements, those of tied components added to the ones that move them.
    LA::SparseMatrix B_free;
    LA::SparseMatrix S, S_free; ///< likewise; same entries as B; empty if no method asks for them
    LA::SparseMatrix S_thermal; ///< of s_0, by ThermalStrain::coefficients(); empty: none expands
    LA::Vector       thermal_stress; ///< what that is now; empty: zero
    LA::Vector       fixed_stress;   ///< what else there is of s_0; empty: zero
    LA::SparseMatrix
           S_volumetric; ///< T, by VolumetricStress::coefficients(); empty: no body is mixed
    double theta = 0;    ///< see above
    bool   has_condensed_constraints =
      false;           ///< B refers to components that supports tie to others, see B_free
    LA::Vector weight; ///< area of each point; sums up to the slave area that has a projection
    LA::Vector reference_gap;         ///< from the geometry
    LA::Vector initial_gap;           ///< g_0: the same with the share of overlaps that counts now
    std::vector<double> interference; ///< that share of each pair; empty: all

    TangentialRows      tangential;
    MovedContact        moved;
    ContactCoefficients coefficients;
    PointGeometry       geometry;
    PointOrigin         origin;

    /// @param shares of initial overlaps that count, pair by pair
    void
    set_interference(const std::vector<double> &shares);

    /// The slip counts from there on: the displacement at the end of the last load step. Where
    /// surfaces have moved, it counts from Configuration::start() of that place.
    void
    set_start(const LA::Vector &u);

    /// @param temperature_change ThermalStrain::coefficients(); ignored without S_thermal
    void
    set_temperature_change(const LA::Vector &temperature_change);

    /// B u + g_0; u must satisfy its constraints.
    LA::Vector
    gap(const LA::Vector &u) const;

    /// gap(), and the slip along the tangents.
    PointVectors
    gaps(const LA::Vector &u) const;

    /// S u + s_0 + T m, the normal stress of the bodies; zero if there is no S.
    /// @param m VolumetricStress::coefficients(); ignored without T
    LA::Vector
    stress(const LA::Vector &u, const LA::Vector &m = LA::Vector()) const;

    /// The force of the tractions p on the free degrees of freedom.
    /// @param s normal stress; ignored without theta
    LA::Vector
    force(const PointVectors &p, const LA::Vector &s) const;

    /// The one on the volumetric stress of mixed bodies, which must be there.
    LA::Vector
    force_on_volumetric_stress(const PointVectors &p, const LA::Vector &s) const;

    /// The same as force() on prescribed degrees of freedom too.
    LA::Vector
    total_force(const PointVectors &p, const LA::Vector &s) const;

    /// dst += G (u - u_k): what B^T W p lacks where surfaces have moved on from u_k.
    void
    add_moved_force(LA::Vector &dst, const LA::Vector &u) const;

    /// dst -= G v
    void
    subtract_geometric(LA::Vector &dst, const LA::Vector &v) const;

    /// See GeometricStiffness.
    void
    for_each_geometric_entry(const LA::Vector                                  &numbers,
                             const std::function<void(double, double, double)> &add) const;

    LA::Vector
    zero() const
    {
      LA::Vector v;
      v.reinit(weight);
      return v;
    }

    bool
    empty() const
    {
      return weight.size() == 0;
    }

    /// Rows a point: 1, or with those of the slip as many as the dimension.
    unsigned int
    n_components() const
    {
      return 1 + tangential.B.size();
    }

    /// The rows of component a, see B and B_free: all of them have the same columns.
    const LA::SparseMatrix &
    rows(const unsigned int a) const
    {
      return a == 0 ? B : tangential.B[a - 1];
    }
    const LA::SparseMatrix &
    free_rows(const unsigned int a) const
    {
      return a == 0 ? B_free : tangential.B_free[a - 1];
    }

    PointVectors
    zeros() const
    {
      return PointVectors(n_components(), zero());
    }

    /// One more than the largest number of a pair that has points, on any rank. Collective.
    unsigned int
    n_pairs() const;

    /// Bytes of its matrices and vectors on this rank.
    std::size_t
    memory_consumption() const;

    /// False: contact was looked for on surfaces that have moved.
    bool
    at_rest() const
    {
      return moved.gap_offset.size() == 0;
    }

    bool
    has_stress() const
    {
      return S.m() > 0;
    }

    /// It depends on the volumetric stress of mixed bodies.
    bool
    has_volumetric_stress() const
    {
      return S_volumetric.m() > 0;
    }

  private:
    /// What S^T is applied to: theta W (s - p)/eps. @param p pressure
    LA::Vector
    nitsche_residual(const LA::Vector &p, const LA::Vector &s) const;
    LA::Vector
    transposed(bool is_free, const PointVectors &p, const LA::Vector &s) const;
  };

  /// @param rows make_contact_rows() of the surfaces, which are those of the configuration
  template <int dim>
  std::unique_ptr<GapOperator>
  make_gap_operator(const Configuration<dim>               &configuration,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const ContactRows                      &rows,
                    const ContactMethod                    &method);

  /// At rest.
  template <int dim>
  std::unique_ptr<GapOperator>
  make_gap_operator(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const ContactMethod                    &method);
} // namespace Signorini
