#pragma once

#include <signorini/elasticity/elasticity.h>

#include <vector>

namespace Signorini
{
  /// The bodies with displacements of degree one on the same mesh, as a coarser level of multigrid.
  struct DegreeLevel
  {
    LA::SparseMatrix stiffness;
    LA::SparseMatrix prolongation;          ///< from its degrees of freedom to those of the bodies
    std::vector<std::vector<double>> modes; ///< rigid-body modes, see rigid_body_modes()
  };

  /// Supports, rigid bodies and springs against free motions are those of the bodies. What is held
  /// at a node that this level has not, is held here by a spring of that node's stiffness.
  /// Collective. @param diagonal of the bodies' stiffness
  template <int dim>
  DegreeLevel
  make_degree_level(const Elasticity<dim> &elasticity, const LA::Vector &diagonal);
} // namespace Signorini
