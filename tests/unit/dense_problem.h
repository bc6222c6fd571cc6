// Contact problems of a few unknowns, given as matrices.
#pragma once

#include <signorini/contact/discretisation/gap_operator.h>
#include <signorini/solve/bodies.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <Eigen/Core>

namespace TestScene
{
  using namespace Signorini;
  using namespace dealii;

  /// K u = f + B^T p with gaps g = B u + g_0 and areas of one; all on the first rank.
  struct DenseProblem
  {
    DenseProblem(const Eigen::MatrixXd &K,
                 const Eigen::VectorXd &f,
                 const Eigen::MatrixXd &B,
                 const Eigen::VectorXd &g_0,
                 const double           epsilon)
      : owned(LA::contiguous_partition(
          Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0 ? K.rows() : 0, MPI_COMM_WORLD))
      , load(owned, MPI_COMM_WORLD)
    {
      constraints.close();
      contact.dofs = owned;
      contact.origin.pair.assign(owned.n_elements(), 0);
      const unsigned int     n = K.rows();
      DynamicSparsityPattern full(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          full.add(i, j);
      stiffness.reinit(owned, full, MPI_COMM_WORLD);
      contact.B.reinit(owned, full, MPI_COMM_WORLD);
      for (LA::Vector *v : {&contact.weight,
                            &contact.rest_gap,
                            &contact.coefficients.stiffness,
                            &contact.coefficients.epsilon})
        v->reinit(owned, MPI_COMM_WORLD);
      contact.weight                 = 1.;
      contact.coefficients.stiffness = 1.;
      contact.coefficients.epsilon   = epsilon;
      for (const auto i : owned)
        {
          for (unsigned int j = 0; j < n; ++j)
            {
              stiffness.set(i, j, K(i, j));
              contact.B.set(i, j, B(i, j));
            }
          load(i)             = f[i];
          contact.rest_gap(i) = g_0[i];
        }
      for (auto *matrix : {&stiffness, &contact.B})
        matrix->compress(VectorOperation::insert);
      load.compress(VectorOperation::insert);
      contact.rest_gap.compress(VectorOperation::insert);
      contact.B_free.copy_from(contact.B);
      contact.initial_gap            = contact.rest_gap;
      contact.coefficients.permanent = contact.zero();
    }

    LinearBodies
    bodies() const
    {
      LinearBodies result(std::make_unique<AssembledStiffness>(stiffness),
                          {},
                          constraints,
                          std::vector<unsigned int>(owned.n_elements(), 0));
      result.set_load(load);
      return result;
    }

    IndexSet                  owned;
    LA::Vector                load;
    LA::SparseMatrix          stiffness;
    AffineConstraints<double> constraints;
    GapOperator               contact;
  };
} // namespace TestScene
