#include <signorini/linear_algebra/diagonal.h>
#include <signorini/linear_algebra/values.h>
#include <signorini/solve/preconditioners/amg.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Something that has all frequencies, times a function that is largest where the rows are
    /// heavy beside their diagonal. There are the few badly shaped cells to which the largest
    /// eigenvalue of the scaled matrix belongs; from a start that is the same everywhere, one among
    /// millions is not found in time.
    LA::Vector
    stiff_oscillation(const LA::Vector &row_sizes, const LA::Vector &inverse_diagonal)
    {
      constexpr double power = 16, everywhere = 0.01;
      LA::Vector       result = row_sizes;
      result.scale(inverse_diagonal);
      const double  largest = result.linfty_norm();
      const double *inverse = LA::values_of(inverse_diagonal);
      double       *r       = LA::values_of(result);
      for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
        r[i] = std::sin(1. + 1.7 * i * i) * (everywhere + std::pow(r[i] / largest, power)) /
               std::sqrt(inverse[i]);
      return result;
    }
  } // namespace



  AMG::AMG(const Hierarchy &hierarchy, const GapOperator *contact)
    : coarsest_K(hierarchy.coarsest_matrix())
    , direct(LA::DirectLibrary::KLU)
  {
    if (contact && !contact->empty())
      springs.emplace(hierarchy, *contact);
    for (unsigned int l = 0; l < hierarchy.n_levels(); ++l)
      {
        levels.push_back(std::make_unique<Level>());
        Level &level           = *levels.back();
        level.number           = l;
        level.K                = &hierarchy.stiffness(l);
        level.diagonal_K       = level.K->diagonal();
        level.smoothing_degree = hierarchy.smoothing_degree(l);
        level.n_visits         = hierarchy.n_visits(l);
        if (l + 1 < hierarchy.n_levels())
          level.P = &hierarchy.prolongation(l);
        for (LA::Vector *v : {&level.x, &level.right, &level.rest, &level.step, &level.first})
          v->reinit(level.diagonal_K);
      }
    // With springs everywhere eigenvalues are largest: these bounds hold for any active set.
    if (springs)
      springs->stiffen();
    for (auto &level : levels)
      {
        update_diagonal(*level);
        if (level->P)
          estimate_eigenvalue(*level);
      }
    if (springs)
      springs->remove();
    update();
  }



  void
  AMG::set_springs(const LA::Vector &values)
  {
    if (springs)
      springs->set(values);
    update();
  }



  void
  AMG::update()
  {
    for (auto &level : levels)
      update_diagonal(*level);
    factorise();
  }



  void
  AMG::update_diagonal(Level &level)
  {
    level.inverse_diagonal = level.diagonal_K;
    if (springs)
      springs->add_diagonal(level.number, level.inverse_diagonal);
    LA::invert(level.inverse_diagonal);
  }



  void
  AMG::estimate_eigenvalue(Level &level)
  {
    // By the numbers that conjugate gradients leave behind. (A power iteration of twice as many
    // products underestimates so much that the smoothers may diverge.)
    LA::Vector row_sizes = level.K->row_sizes();
    if (springs)
      springs->add_row_sums(level.number, row_sizes);
    const LA::Vector right = stiff_oscillation(row_sizes, level.inverse_diagonal);
    LA::Vector       x;
    x.reinit(right);
    struct Operator
    {
      const AMG   &amg;
      const Level &level;

      void
      vmult(LA::Vector &dst, const LA::Vector &src) const
      {
        amg.multiply(level, dst, src);
      }
    };
    struct Diagonal
    {
      const LA::Vector &inverse;

      void
      vmult(LA::Vector &dst, const LA::Vector &src) const
      {
        dst = src;
        dst.scale(inverse);
      }
    };
    IterationNumberControl control(10, 1e-10 * right.l2_norm());
    SolverCG<LA::Vector>   cg(control);
    cg.connect_eigenvalues_slot([&level](const std::vector<double> &eigenvalues) {
      level.largest_eigenvalue = eigenvalues.back();
    });
    cg.solve(Operator{*this, level}, x, right, Diagonal{level.inverse_diagonal});
  }



  void
  AMG::factorise()
  {
    const Level &last = *levels.back();
    direct.clear();
    coarsest.reset();
    if (springs && springs->any())
      coarsest = std::make_unique<LA::SparseMatrix>(springs->added_to(coarsest_K, last.number));
    const int error = direct.factorise(coarsest ? *coarsest : coarsest_K);
    AssertThrow(error == 0, ExcTrilinosError(error));
  }



  void
  AMG::multiply(const Level &level, LA::Vector &dst, const LA::Vector &src) const
  {
    level.K->vmult(dst, src);
    if (springs)
      springs->add_product(level.number, dst, src);
  }



  void
  AMG::smooth(const Level      &level,
              LA::Vector       &x,
              const LA::Vector &right,
              const bool        from_zero) const
  {
    // Chebyshev polynomial on the upper part of the spectrum (Saad, Iterative Methods for Sparse
    // Linear Systems, algorithm 12.1).
    const double largest = 1.1 * level.largest_eigenvalue, smallest = largest / 20;
    const double theta = (largest + smallest) / 2, delta = (largest - smallest) / 2;
    const double sigma = theta / delta;
    double       rho   = 1 / sigma;

    level.rest = right;
    if (from_zero)
      x = 0;
    else
      {
        multiply(level, level.rest, x);
        level.rest.sadd(-1, 1, right);
      }
    level.step = level.rest;
    level.step.scale(level.inverse_diagonal);
    level.step /= theta;
    x += level.step;
    for (unsigned int k = 1; k < level.smoothing_degree; ++k)
      {
        multiply(level, level.rest, x);
        level.rest.sadd(-1, 1, right);
        level.rest.scale(level.inverse_diagonal);
        const double next = 1 / (2 * sigma - rho);
        level.step *= next * rho;
        level.step.add(2 * next / delta, level.rest);
        x += level.step;
        rho = next;
      }
  }



  void
  AMG::cycle(const unsigned int l, LA::Vector &x, const LA::Vector &right) const
  {
    const Level &level = *levels[l];
    if (!level.P)
      {
        direct.solve(x, right);
        return;
      }
    smooth(level, x, right, true);
    multiply(level, level.rest, x);
    level.rest.sadd(-1, 1, right);
    const Level &next = *levels[l + 1];
    level.P->Tvmult(next.right, level.rest);
    cycle(l + 1, next.x, next.right);
    if (next.P && next.n_visits == 2) // what is left, once more
      {
        next.first = next.x;
        multiply(next, next.rest, next.first);
        next.right -= next.rest;
        cycle(l + 1, next.x, next.right);
        next.x += next.first;
      }
    level.P->vmult(level.rest, next.x);
    x += level.rest;
    smooth(level, x, right, false);
  }



  void
  AMG::vmult(LA::Vector &dst, const LA::Vector &src) const
  {
    ++n_cycles;
    cycle(0, dst, src);
  }
} // namespace Signorini
