// SPDX-License-Identifier: Apache-2.0
#include "solver/solid_residual.h"

namespace Signorini
{
  using namespace dealii;

  LinearElasticSolid::LinearElasticSolid(std::unique_ptr<const Stiffness>     K,
                                         const LA::Vector                    &stabilisation,
                                         const AffineConstraints<double>     &constraints,
                                         std::vector<unsigned int>            body_of_dof,
                                         std::unique_ptr<VolumetricEquations> volumetric)
    : K(std::move(K))
    , my_volumetric(std::move(volumetric))
    , stabilisation(stabilisation)
    , my_constraints(constraints)
    , bodies(std::move(body_of_dof))
    , f(this->K->owned(), this->K->communicator())
  {
    if (my_volumetric)
      my_volumetric->linearise(f);
  }



  void
  LinearElasticSolid::set_load(LA::Vector load)
  {
    f = std::move(load);
  }



  LA::Vector
  LinearElasticSolid::residual(const LA::Vector &u) const
  {
    LA::Vector r;
    r.reinit(f, true);
    K->vmult(r, u);
    r.sadd(-1, 1, f);
    if (my_volumetric)
      my_volumetric->subtract_forces(r);
    if (stabilisation.size() > 0)
      {
        LA::Vector of_stabilisation = stabilisation;
        of_stabilisation.scale(u);
        r += of_stabilisation;
      }
    return r;
  }
} // namespace Signorini
