#include "solver/bodies.h"

namespace Signorini
{
  using namespace dealii;

  LinearBodies::LinearBodies(std::unique_ptr<const Stiffness> K,
                             const LA::Vector                &springs,
                             const AffineConstraints<double> &constraints,
                             std::vector<unsigned int>        body_of_dof,
                             std::unique_ptr<BulkEquations>   bulk)
    : K(std::move(K))
    , my_bulk(std::move(bulk))
    , springs(springs)
    , my_constraints(constraints)
    , bodies(std::move(body_of_dof))
    , f(this->K->owned(), this->K->communicator())
  {
    if (my_bulk)
      my_bulk->linearise(f);
  }



  void
  LinearBodies::set_load(LA::Vector load)
  {
    f = std::move(load);
  }



  LA::Vector
  LinearBodies::residual(const LA::Vector &u) const
  {
    LA::Vector r;
    r.reinit(f, true);
    K->vmult(r, u);
    r.sadd(-1, 1, f);
    if (my_bulk)
      my_bulk->subtract_forces(r);
    if (springs.size() > 0)
      {
        LA::Vector of_springs = springs;
        of_springs.scale(u);
        r += of_springs;
      }
    return r;
  }
} // namespace Signorini
