// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace Signorini
{
  /// What a computed quantity lacks: exact minus computed, in its units, by causes. Signs are known
  /// to first order of the errors.
  struct ErrorParts
  {
    double discretisation = 0; ///< the mesh and the degree of the displacement
    double geometry       = 0; ///< curved bodies are made of cells that are not
    double enforcement    = 0; ///< penalties and regularisations let surfaces overlap
    double model          = 0; ///< contact on surfaces at rest; a size, the sign is not known
    double nonlinear      = 0; ///< points that pull, where the active set was left
    double algebraic      = 0; ///< where the linear solver stopped

    /// Without the model's, whose sign is not known.
    double
    correction() const
    {
      return discretisation + geometry + enforcement + nonlinear + algebraic;
    }
  };

  /// A quantity and its error on one mesh.
  struct QuantityEstimate
  {
    double     value = 0;
    ErrorParts parts;
    double     absolute   = 0; ///< the discretisation's, if errors of cells never cancelled
    double     unresolved = 0; ///< by what lies within a face, as the edge of contact does
    double     energy     = 0; ///< norm of the whole error, relative to the solution
    double     cauchy_schwarz_bound = 0;     ///< of the discretisation, by Cauchy and Schwarz
    bool       is_regularised       = false; ///< see Functional
  };

  struct BoundedValue
  {
    double value = 0, error_bound = 0;
  };

  /// A quantity on one mesh after the other, each finer. Estimates alone are as good as the
  /// recovery that they come from; how the value changes from mesh to mesh shows how good that is.
  class ErrorHistory
  {
  public:
    void
    add(const QuantityEstimate &on_next_mesh)
    {
      meshes.push_back(on_next_mesh);
    }

    void
    replace_last(const QuantityEstimate &on_last_mesh)
    {
      meshes.back() = on_last_mesh;
    }

    unsigned int
    size() const
    {
      return meshes.size();
    }

    const QuantityEstimate &
    last() const
    {
      return meshes.back();
    }

    /// The last value with the size of its error: the exact one is expected between value - bar and
    /// value + bar.
    BoundedValue
    last_bounded() const;

    /// With nothing left by Newton's method and the linear solver on the last mesh.
    ErrorHistory
    without_solver() const;

    /// With gaps closed on the last mesh.
    ErrorHistory
    without_enforcement() const;

    /// The last value with its estimated error taken off, if three or more meshes agree on that.
    std::optional<BoundedValue>
    extrapolated() const;

    /// The value moves on by as much from mesh to mesh: it has no limit, or the meshes are far from
    /// it.
    bool
    diverges() const;

  private:
    /// By how much the discretisation's error has fallen from the last mesh but one to the last: a
    /// factor below one.
    double
    reduction() const;
    /// What is left if the value goes on as it has changed; 0 if there is no other mesh.
    double
    by_changes() const;

    std::vector<QuantityEstimate> meshes;
  };
} // namespace Signorini
