// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <vector>

namespace Signorini
{
  /// The error of a computed quantity, exact minus computed, in its units, by causes. Signs are
  /// known to first order in the errors.
  struct ErrorParts
  {
    /// Mesh size and degree of the displacement, with supports and nodes without multiplier.
    double discretisation = 0;
    /// Difference between the cells and the true curved bodies, (8.7).
    double geometry = 0;
    /// Gaps that penalties and regularisations leave, (8.10).
    double enforcement = 0;
    /// Contact in the reference configuration, (8.12); a size without sign.
    double model = 0;
    /// Length of the load steps, with friction, (8.18); a size without sign.
    double path = 0;
    /// Points in tension on the active set with which the iteration ended, (8.11).
    double nonlinear = 0;
    /// Residual that the linear solver left, (8.11).
    double algebraic = 0;

    /// @return the sum of the parts that no mesh reduces, and whose signs are not known.
    double
    of_model_and_path() const
    {
      return std::abs(model) + std::abs(path);
    }

    /// @return the sum of the other parts.
    double
    correction() const
    {
      return discretisation + geometry + enforcement + nonlinear + algebraic;
    }

    /// @return a size of this sum in which the part of the geometry does not cancel others: it is
    /// less certain, and changes its sign where levels of refinement meet.
    double
    size_of_correction() const
    {
      return std::abs(correction() - geometry) + std::abs(geometry);
    }
  };

  /// A quantity and its error on one mesh.
  struct QuantityEstimate
  {
    double     value = 0;
    ErrorParts parts;
    /// Sum of the absolute values of the cell errors of the discretisation, in units of the
    /// quantity.
    double absolute = 0;
    /// Size of what is not resolved within a face, such as the edge of contact, (8.9).
    double unresolved = 0;
    /// Bound of the discretisation error by the products of the energy norms of primal and dual
    /// errors, cell by cell.
    double cauchy_schwarz_bound = 0;
    /// See Functional.
    bool is_regularised = false;
    /// Whether the tangent at the solution is not positive definite: then other solutions are near,
    /// and a linearisation tells nothing of the error.
    bool is_unstable = false;
    /// Whether the exact value has no limit.
    bool is_singular = false;
  };

  /// A value whose exact counterpart is expected within +- error_bound.
  struct BoundedValue
  {
    double value = 0, error_bound = 0;
  };

  /// The estimates of a quantity on a sequence of finer meshes. An estimate alone is as reliable as
  /// the stress recovery that it is based on; the changes of the value from mesh to mesh are an
  /// independent measure of the error.
  class ErrorHistory
  {
  public:
    /// Append the estimate on the next mesh.
    /// @param on_next_mesh the estimate
    void
    add(const QuantityEstimate &on_next_mesh)
    {
      meshes.push_back(on_next_mesh);
    }

    /// Replace the estimate on the last mesh.
    /// @param on_last_mesh the estimate of a more accurate solution
    void
    replace_last(const QuantityEstimate &on_last_mesh)
    {
      meshes.back() = on_last_mesh;
    }

    /// Replace the estimate on the last mesh by that with other load steps. The values on other
    /// meshes are taken to change by as much, so that their changes remain those of the meshes.
    /// @param on_last_mesh the estimate of the solution with the other load steps
    void
    follow_path(const QuantityEstimate &on_last_mesh)
    {
      const double change = on_last_mesh.value - last().value;
      for (QuantityEstimate &one : meshes)
        one.value += change;
      meshes.back() = on_last_mesh;
    }

    /// Set the error of the path on the last mesh.
    void
    set_path(const double size)
    {
      meshes.back().parts.path = size;
    }

    /// @return the number of meshes.
    unsigned int
    size() const
    {
      return meshes.size();
    }

    /// @return the estimate on the last mesh; there must be one.
    const QuantityEstimate &
    last() const
    {
      return meshes.back();
    }

    /// @return the last value with its error bound (8.13); infinite at unstable solutions.
    BoundedValue
    last_bounded() const;

    /// @return the same history without nonlinear and algebraic error on the last mesh.
    ErrorHistory
    without_solver() const;

    /// @return the same history without the error of enforcement on the last mesh.
    ErrorHistory
    without_enforcement() const;

    /// @return the last value with its estimated error added, and the bound (8.15); none if the
    /// corrections of the last three meshes are not consistent, or if the bound would not be
    /// smaller by half.
    std::optional<BoundedValue>
    extrapolated() const;

    /// @return whether the value has been far smaller than its bound on several meshes, so that a
    /// bound relative to it has no meaning: it is zero, as far as is known.
    bool
    is_zero() const;

    /// @return whether the value changes by nearly as much on each of several meshes: it has no
    /// limit, or the meshes are far from it.
    bool
    diverges() const;

  private:
    /// @return the factor, below one, by which the discretisation error has decreased from the last
    /// mesh but one to the last.
    double
    reduction() const;
    /// @return the remaining change of the value, extrapolated from its changes so far; 0 if there
    /// is one mesh only.
    double
    by_changes() const;

    std::vector<QuantityEstimate> meshes;
  };
} // namespace Signorini
