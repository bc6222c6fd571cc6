// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/smoothed_aggregation.h"

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>
#include <ml_epetra_utils.h>

#include <algorithm>
#include <memory>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    namespace
    {
      /// Parameters of ML: smoothed aggregation of nodes of n_components unknowns with a given near
      /// null space, levels down to 1000 unknowns, without smoothers.
      Teuchos::ParameterList
      parameters_of(Epetra_MultiVector &null_space, const unsigned int n_components)
      {
        Teuchos::ParameterList parameters;
        ML_Epetra::SetDefaults("SA", parameters);
        parameters.set("ML output", 0);
        parameters.set("PDE equations", static_cast<int>(n_components));
        parameters.set("null space: type", "pre-computed");
        parameters.set("null space: dimension", null_space.NumVectors());
        // ML ignores the null space if the pointer is null, which it would be on ranks without
        // rows.
        static double nothing = 0;
        parameters.set("null space: vectors",
                       null_space.MyLength() > 0 ? null_space.Values() : &nothing);
        parameters.set("aggregation: type", "Uncoupled");
        // No couplings are dropped: in elasticity the weak ones are those of shear, and needed.
        parameters.set("aggregation: threshold", 0.);
        parameters.set("coarse: max size", static_cast<int>(factorised_size));
        // Only the levels are wanted.
        parameters.set("smoother: type", "do-nothing");
        parameters.set("coarse: type", "do-nothing");
        return parameters;
      }

      /// A copy of a matrix of ML in deal.II's format.
      SparseMatrix
      copy(ML_Operator &from)
      {
        Epetra_CrsMatrix *made  = nullptr;
        const int         error = ML_Operator2EpetraCrsMatrix(&from, made);
        AssertThrow(error == 0, ExcTrilinosError(error));
        const std::unique_ptr<Epetra_CrsMatrix> matrix(made);
        SparseMatrix                            result;
        result.reinit(*matrix);
        return result;
      }
    } // namespace



    // Aggregates by the library ML (doc/theory, (7.1)). Modes become the columns of a multivector;
    // the levels are copied, since ML frees its own ones together with the builder. Collective.
    std::vector<CoarseLevel>
    smoothed_aggregation(const SparseMatrix                     &K,
                         const std::vector<std::vector<double>> &modes,
                         const unsigned int                      n_components)
    {
      if (K.m() <= factorised_size)
        return {};
      Epetra_MultiVector null_space(K.trilinos_matrix().DomainMap(), modes.size());
      for (unsigned int m = 0; m < modes.size(); ++m)
        std::copy(modes[m].begin(), modes[m].end(), null_space[m]);
      const ML_Epetra::MultiLevelPreconditioner builder(K.trilinos_matrix(),
                                                        parameters_of(null_space, n_components));
      const ML                                 &levels = *builder.GetML();
      std::vector<CoarseLevel>                  coarse;
      // Level 0 is K itself.
      for (int level = 1; level < levels.ML_num_actual_levels; ++level)
        coarse.push_back({copy(levels.Amat[level]), copy(levels.Pmat[level])});
      return coarse;
    }
  } // namespace LA
} // namespace Signorini
