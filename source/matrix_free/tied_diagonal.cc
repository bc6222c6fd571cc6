#include <signorini/elasticity/cell_nodes.h>
#include <signorini/elasticity/kernel.h>
#include <signorini/matrix_free/tied_diagonal.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  add_tied_diagonal(const Elasticity<dim>                                      &elasticity,
                    const std::function<void(types::global_dof_index, double)> &add)
  {
    const AffineConstraints<double> &constraints = elasticity.constraints();
    const auto                       is_tied     = [&](const types::global_dof_index dof) {
      const auto *line = constraints.get_constraint_entries(dof);
      return line && !line->empty();
    };
    StiffnessKernel<dim>                 kernel(elasticity.mesh(),
                                elasticity.finite_elements(),
                                elasticity.model());
    FullMatrix<double>                   K;
    std::vector<types::global_dof_index> indices;
    // Of each degree of freedom that others hang on: those of the cell, and their weights.
    std::map<types::global_dof_index, std::vector<std::pair<unsigned int, double>>> columns;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          if (std::none_of(indices.begin(), indices.end(), is_tied))
            continue;
          columns.clear();
          for (unsigned int r = 0; r < indices.size(); ++r)
            if (is_tied(indices[r]))
              for (const auto &[dof, weight] : *constraints.get_constraint_entries(indices[r]))
                columns[dof].emplace_back(r, weight);
          kernel.assemble(cell, elasticity.material(cell->material_id()), K);
          for (auto &[dof, entries] : columns)
            {
              const auto own = std::find(indices.begin(), indices.end(), dof);
              double     sum = 0;
              if (own != indices.end())
                {
                  const unsigned int j = own - indices.begin();
                  entries.emplace_back(j, 1.);
                  sum -= K(j, j); // is there already
                }
              for (const auto &[r, weight] : entries)
                for (const auto &[s, other] : entries)
                  sum += weight * other * K(r, s);
              add(dof, sum);
            }
        }
  }



  template void
  add_tied_diagonal(const Elasticity<2> &,
                    const std::function<void(types::global_dof_index, double)> &);
  template void
  add_tied_diagonal(const Elasticity<3> &,
                    const std::function<void(types::global_dof_index, double)> &);
} // namespace Signorini
