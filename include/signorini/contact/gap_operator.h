#pragma once

#include <signorini/contact/surface.h>
#include <signorini/linear_algebra.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// Where a method imposes contact.
  enum class Sampling
  {
    quadrature_points, ///< point-wise
    nodes              ///< weighted with the trace shape functions of the slave (mortar)
  };

  /// The discrete gap g = B u + g_0 at the points where the method imposes contact, one row a
  /// point: a quadrature point, or a slave node A with g_A = int psi_A g dA / int psi_A dA. A
  /// pressure p on the points exerts the force B^T W p, where W are the points' areas. Positive
  /// pressure is compression. Knows nothing of the dimension, so that what uses it is compiled
  /// once.
  struct GapOperator
  {
    dealii::IndexSet dofs;   ///< locally owned degrees of freedom
    LA::SparseMatrix B;      ///< columns: all degrees of freedom (hanging nodes resolved)
    LA::SparseMatrix B_free; ///< the same without the columns of prescribed displacements
    LA::Vector       weight; ///< area of each point; sums up to the slave area that has a partner
    LA::Vector       rest_gap;
    LA::Vector       stiffness;       ///< E/h [force/length^3]
    std::vector<LA::Vector> position; ///< dim vectors
    std::vector<LA::Vector>
      normal; ///< dim vectors: mean normal, not of unit length on curved faces
    std::vector<LA::Vector>
      moment; ///< of a unit force along the normal: x cross n; 1 (2D) or 3 (3D)
    std::vector<unsigned int> pair; ///< contact pair of each locally owned point
    /// Degree of freedom (first component) of the slave node of each locally owned point; empty for
    /// quadrature points.
    std::vector<dealii::types::global_dof_index> node;

    LA::Vector initial_gap; ///< rest_gap with the obstacles moved: set by set_obstacle_motion

    /// @param motion displacement of each pair's master (zero for bodies), pair by pair
    void
    set_obstacle_motion(const std::vector<std::vector<double>> &motion);

    /// B u + g_0; u must satisfy its constraints.
    LA::Vector
    gap(const LA::Vector &u) const;

    /// B_free^T W p: the force on the free degrees of freedom.
    LA::Vector
    force(const LA::Vector &p) const;

    /// B^T W p, on prescribed degrees of freedom too.
    LA::Vector
    total_force(const LA::Vector &p) const;

    /// For methods that sample at nodes: copy values of points to the first degree of freedom of
    /// their nodes (other entries are kept), and back. Without nodes nothing happens.
    void
    scatter(const LA::Vector &points, LA::Vector &nodal) const;
    void
    gather(const LA::Vector &nodal, LA::Vector &points) const;

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
  };

  template <int dim>
  std::unique_ptr<GapOperator>
  make_gap_operator(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    Sampling                                sampling);
} // namespace Signorini
