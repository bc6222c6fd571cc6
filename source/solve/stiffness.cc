#include <signorini/solve/stiffness.h>

namespace Signorini
{
  using namespace dealii;

  LA::Vector
  AssembledStiffness::diagonal() const
  {
    LA::Vector result(owned(), communicator());
    for (const auto i : result.locally_owned_elements())
      result(i) = K.diag_element(i);
    result.compress(VectorOperation::insert);
    return result;
  }
} // namespace Signorini
