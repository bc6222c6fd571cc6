// SPDX-License-Identifier: Apache-2.0
#include "solid/stiffness.h"

#include "linear_algebra/diagonal.h"
#include "linear_algebra/row_view.h"
#include "linear_algebra/values.h"

#include <cmath>

namespace Signorini
{
  const Choices<StiffnessForm> &
  stiffness_forms()
  {
    static const Choices<StiffnessForm> list = {{"assembled", StiffnessForm::assembled},
                                                {"matrix-free", StiffnessForm::matrix_free}};
    return list;
  }



  // The matrix of K itself is in double precision; smoothers use a copy in single precision, which
  // halves the memory that a product reads.
  AssembledOperator::AssembledOperator(const LA::SparseMatrix &K)
    : K(K)
    , K_single(K)
    , result(K.locally_owned_range_indices().n_elements())
  {}



  std::vector<float>
  AssembledOperator::diagonal() const
  {
    const LA::Vector    exact = LA::diagonal(K);
    const double *const first = LA::values_of(exact);
    return std::vector<float>(first, first + exact.locally_owned_size());
  }



  // Sums of absolute values by row: bounds of the eigenvalues by Gershgorin's theorem.
  std::vector<float>
  AssembledOperator::row_l1_norms() const
  {
    std::vector<float> sums;
    for (unsigned int i = 0; i < result.size(); ++i)
      {
        const LA::RowView row(K, i);
        double            sum = 0;
        for (int k = 0; k < row.size; ++k)
          sum += std::abs(row.values[k]);
        sums.push_back(sum);
      }
    return sums;
  }



  LA::Vector
  AssembledStiffness::diagonal() const
  {
    return LA::diagonal(K);
  }



  // The copy is made when it is asked for first, since direct solvers do not need it.
  const StiffnessOperator<float> &
  AssembledStiffness::single_precision() const
  {
    if (!my_single_precision)
      my_single_precision = std::make_unique<const AssembledOperator>(K);
    return *my_single_precision;
  }
} // namespace Signorini
