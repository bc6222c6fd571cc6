// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/diagonal.h"
#include "matrix_free/tangent_stiffness.h"
#include "solid/cell_nodes.h"
#include "solver/folded_cells.h"
#include "solver/nonlinear_solid.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The tangent of bodies and follower pressures as an assembled matrix, in any dimension.
    template <int dim>
    class Assembled : public Linearisation<dim>
    {
    public:
      Assembled(Elasticity<dim>        &elasticity,
                DeformationKernel<dim> &kernel,
                PressureKernel<dim>    &pressures)
        : elasticity(elasticity)
        , kernel(kernel)
        , pressures(pressures)
        , my_stiffness(K)
      {
        elasticity.assemble();
        K.reinit(elasticity.stiffness());
        K.copy_from(elasticity.stiffness());
      }

      // Cell by cell; if one is inverted, the matrix is not complete and SolverFailure is thrown on
      // all ranks.
      void
      linearise(const LA::Vector &u) override
      {
        std::vector<types::global_dof_index> indices;
        Vector<double>                       values, of_cell, push;
        FullMatrix<double>                   tangent, of_push;
        std::string                          folded;
        K = 0;
        for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned())
            {
              read_indices<dim>(cell, indices);
              values.reinit(indices.size());
              cell->get_dof_values(u, values);
              const Material &material = elasticity.material(cell->material_id());
              if (!kernel.assemble(cell, material, values, of_cell, &tangent))
                {
                  folded = elasticity.mesh().body_name(elasticity.mesh().body(cell));
                  break;
                }
              if (pressures.assemble(cell, values, push, &of_push))
                tangent.add(-1, of_push);
              elasticity.constraints().distribute_local_to_global(tangent, indices, K);
            }
        K.compress(VectorOperation::add);
        check_folds(folded, K.get_mpi_communicator());
        LA::add_to_diagonal(K, elasticity.diagonal_terms());
        my_stiffness.has_changed();
      }

      const Stiffness &
      stiffness() const override
      {
        return my_stiffness;
      }

    private:
      const Elasticity<dim>  &elasticity;
      DeformationKernel<dim> &kernel;
      PressureKernel<dim>    &pressures;
      LA::SparseMatrix        K;
      AssembledStiffness      my_stiffness;
    };

    /// The tangent by products cell by cell, in space and without follower pressures.
    class MatrixFree : public Linearisation<3>
    {
    public:
      MatrixFree(const Elasticity<3> &elasticity, DeformationKernel<3> &kernel)
        : my_stiffness(elasticity, kernel)
      {}

      void
      linearise(const LA::Vector &u) override
      {
        check_folds(my_stiffness.evaluate(u), my_stiffness.communicator());
        my_stiffness.update();
      }

      const Stiffness &
      stiffness() const override
      {
        return my_stiffness;
      }

    private:
      TangentStiffness my_stiffness;
    };
  } // namespace



  template <int dim>
  std::unique_ptr<Linearisation<dim>>
  Linearisation<dim>::create(const StiffnessForm     form,
                             Elasticity<dim>        &elasticity,
                             DeformationKernel<dim> &kernel,
                             PressureKernel<dim>    &pressures)
  {
    if constexpr (dim == 3)
      if (form == StiffnessForm::matrix_free)
        return std::make_unique<MatrixFree>(elasticity, kernel);
    return std::make_unique<Assembled<dim>>(elasticity, kernel, pressures);
  }



  template class Linearisation<2>;
  template class Linearisation<3>;
} // namespace Signorini
