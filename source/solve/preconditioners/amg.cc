#include <signorini/solve/preconditioners/amg.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  AMG::AMG(const LA::SparseMatrix                 &stiffness,
           const std::vector<std::vector<double>> &modes,
           const unsigned int                      dim)
  {
    Epetra_MultiVector null_space(stiffness.trilinos_matrix().DomainMap(), modes.size());
    for (unsigned int m = 0; m < modes.size(); ++m)
      std::copy(modes[m].begin(), modes[m].end(), null_space[m]);

    Teuchos::ParameterList parameters;
    ML_Epetra::SetDefaults("SA", parameters);
    parameters.set("ML output", 0);
    parameters.set("PDE equations", static_cast<int>(dim));
    parameters.set("null space: type", "pre-computed");
    parameters.set("null space: dimension", static_cast<int>(modes.size()));
    parameters.set("null space: vectors", null_space.Values());
    parameters.set("aggregation: type", "Uncoupled");
    // Dropping weak couplings harms elasticity: what looks weak is shear.
    parameters.set("aggregation: threshold", 0.);
    parameters.set("smoother: type", "Chebyshev");
    parameters.set("smoother: sweeps", 2);
    parameters.set("smoother: Chebyshev alpha", 10.);
    parameters.set("coarse: type", "Amesos-KLU");
    parameters.set("coarse: max size", 1000);
    amg.initialize(stiffness, parameters);
  }



  void
  AMG::vmult(LA::Vector &dst, const LA::Vector &src) const
  {
    ++n_v_cycles;
    amg.vmult(dst, src);
  }
} // namespace Signorini
