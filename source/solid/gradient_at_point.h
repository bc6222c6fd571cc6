// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/deformation.h"

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Signorini
{
  /// The deformation gradient F = I + Grad u in three dimensions at point q of a cell or face.
  /// @param values of the scalar element: values, gradients and quadrature points
  /// @param dofs degrees of freedom node by node, see dofs_of_nodes()
  /// @param u displacement at the degrees of freedom of the cell
  template <int dim>
  dealii::Tensor<2, 3>
  gradient_at_point(const Model                      model,
                    const dealii::FEValuesBase<dim> &values,
                    const std::vector<unsigned int> &dofs,
                    const unsigned int               q,
                    const dealii::Vector<double>    &u)
  {
    dealii::Tensor<2, dim> gradient;
    dealii::Tensor<1, dim> value;
    for (unsigned int i = 0; i < dofs.size() / dim; ++i)
      for (unsigned int a = 0; a < dim; ++a)
        {
          const double at_node = u(dofs[i * dim + a]);
          gradient[a] += at_node * values.shape_grad(i, q);
          value[a] += at_node * values.shape_value(i, q);
        }
    return deformation_gradient(model, gradient, value, values.quadrature_point(q));
  }
} // namespace Signorini
