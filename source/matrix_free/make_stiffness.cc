// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/make_stiffness.h"

#include "matrix_free/cell_stiffness.h"
#include "solid/pressure_kernel.h"
#include <signorini/parameters/raw.h>

namespace Signorini
{
  template <int dim>
  StiffnessForm
  choose_form(const std::optional<StiffnessForm> &wanted,
              const bool                          needs_matrix,
              const Elasticity<dim>              &elasticity)
  {
    // Kernels do not have the tangent of follower pressures. Without a wish: matrix-free in space
    // where kernels exist and are fast, or the bodies are nonlinear, unless the preconditioner
    // needs the matrix.
    const bool is_possible = dim == 3 && elasticity.degree() <= largest_kernel_degree &&
                             !has_follower_pressures(elasticity),
               // Tetrahedra of degree one have fast products with a matrix.
      is_fast = elasticity.degree() > 1 || !elasticity.mesh().has_simplices();
    if (wanted == StiffnessForm::matrix_free && !is_possible)
      throw SceneError("Solver/Operator = matrix-free is available in 3D only, for degree 1 and 2, "
                       "without follower pressures; set auto or assembled");
    return wanted.value_or(is_possible && (is_fast || elasticity.is_nonlinear()) && !needs_matrix ?
                             StiffnessForm::matrix_free :
                             StiffnessForm::assembled);
  }



  template <int dim>
  std::unique_ptr<const Stiffness>
  make_stiffness(const StiffnessForm form, Elasticity<dim> &elasticity)
  {
    if constexpr (dim == 3)
      if (form == StiffnessForm::matrix_free)
        return std::make_unique<MatrixFreeStiffness>(elasticity);
    // A product with the matrix refers to the matrix in `elasticity`, which must outlive the
    // result.
    elasticity.assemble();
    return std::make_unique<AssembledStiffness>(elasticity.stiffness());
  }



  template StiffnessForm
  choose_form(const std::optional<StiffnessForm> &, bool, const Elasticity<2> &);
  template StiffnessForm
  choose_form(const std::optional<StiffnessForm> &, bool, const Elasticity<3> &);
  template std::unique_ptr<const Stiffness>
  make_stiffness(StiffnessForm, Elasticity<2> &);
  template std::unique_ptr<const Stiffness>
  make_stiffness(StiffnessForm, Elasticity<3> &);
} // namespace Signorini
