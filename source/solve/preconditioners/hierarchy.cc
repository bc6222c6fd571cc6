#include <signorini/solve/preconditioners/hierarchy.h>

namespace Signorini
{
  Hierarchy::Hierarchy(const Stiffness                        &stiffness,
                       const std::vector<std::vector<double>> &modes,
                       const unsigned int                      n_components)
    : finest(stiffness.rounded())
  {
    add_aggregates(stiffness.matrix(), modes, n_components);
  }



  Hierarchy::Hierarchy(const Stiffness   &stiffness,
                       DegreeLevel        level,
                       const unsigned int n_components)
    : finest(stiffness.rounded())
    , n_degree_levels(1)
  {
    coarse.push_back(
      std::make_unique<Level>(std::move(level.stiffness), std::move(level.prolongation)));
    add_aggregates(coarse.back()->matrix, level.modes, n_components);
  }



  void
  Hierarchy::add_aggregates(const LA::SparseMatrix                 &matrix,
                            const std::vector<std::vector<double>> &modes,
                            const unsigned int                      n_components)
  {
    for (LA::CoarseLevel &level : LA::smoothed_aggregation(matrix, modes, n_components))
      coarse.push_back(
        std::make_unique<Level>(std::move(level.matrix), std::move(level.prolongation)));
  }
} // namespace Signorini
