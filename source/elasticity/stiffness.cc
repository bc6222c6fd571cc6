#include <signorini/elasticity/stiffness.h>
#include <signorini/linear_algebra/diagonal.h>
#include <signorini/linear_algebra/row_view.h>
#include <signorini/linear_algebra/values.h>

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



  LA::Vector
  AssembledStiffness::diagonal() const
  {
    return LA::diagonal(K);
  }



  LA::Vector
  AssembledStiffness::row_sizes() const
  {
    LA::Vector    sums(K.locally_owned_range_indices(), K.get_mpi_communicator());
    double *const sum = LA::values_of(sums);
    for (unsigned int i = 0; i < sums.locally_owned_size(); ++i)
      {
        const LA::RowView row(K, i);
        for (int k = 0; k < row.size; ++k)
          sum[i] += std::abs(row.values[k]);
      }
    return sums;
  }
} // namespace Signorini
