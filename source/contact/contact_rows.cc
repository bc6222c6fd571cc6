#include <signorini/contact/contact_rows.h>

#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    ContactRows
    quadrature_rows(const std::vector<ContactSurface<dim>> &surfaces, const MPI_Comm comm)
    {
      ContactRows rows;
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        rows.pair.insert(rows.pair.end(), surfaces[p].points.size(), p);
      rows.owned    = LA::contiguous_partition(rows.pair.size(), comm);
      rows.writable = rows.owned;
      auto row      = rows.owned.begin();
      for (const auto &surface : surfaces)
        {
          rows.shares.emplace_back();
          for (const auto &point : surface.points)
            rows.shares.back().push_back({{*row++, point.weight}});
        }
      return rows;
    }

    /// Areas of the nodes of one pair, at their first degree of freedom: with a partner, and all.
    template <int dim>
    std::pair<LA::Vector, LA::Vector>
    node_areas(const Elasticity<dim> &elasticity, const ContactSurface<dim> &surface)
    {
      LA::Vector paired = elasticity.zero_vector(), all = elasticity.zero_vector();
      for (const auto &point : surface.points)
        for (const auto &[node, value] : point.shape)
          paired(node) += value * point.weight;
      for (const auto &[shape, weight] : surface.whole)
        for (const auto &[node, value] : shape)
          all(node) += std::abs(value) * weight;
      paired.compress(VectorOperation::add);
      all.compress(VectorOperation::add);
      return {paired, all};
    }

    template <int dim>
    ContactRows
    node_rows(const Elasticity<dim> &elasticity, const std::vector<ContactSurface<dim>> &surfaces)
    {
      ContactRows             rows;
      std::vector<LA::Vector> numbers; // row of each node, one vector a pair; -1: none
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        {
          const auto [paired, all] = node_areas(elasticity, surfaces[p]);
          numbers.push_back(elasticity.zero_vector());
          numbers.back() = -1.;
          for (const auto i : elasticity.owned())
            // A node beyond the rim of the master, with next to no area, has no gap to speak of.
            if (all(i) > 0 && paired(i) > 0.01 * all(i))
              {
                numbers.back()(i) = rows.node.size();
                rows.node.push_back(i);
                rows.pair.push_back(p);
              }
          numbers.back().compress(VectorOperation::insert);
        }
      rows.owned    = LA::contiguous_partition(rows.node.size(), elasticity.mesh().communicator());
      rows.writable = rows.owned;
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        {
          for (const auto i : elasticity.owned())
            if (numbers[p](i) >= 0)
              numbers[p](i) = numbers[p](i) + *rows.owned.begin();
          numbers[p].compress(VectorOperation::insert);
          const LA::Vector                  number = elasticity.with_ghosts(numbers[p]);
          std::set<types::global_dof_index> foreign;
          rows.shares.emplace_back();
          for (const auto &point : surfaces[p].points)
            {
              rows.shares.back().emplace_back();
              for (const auto &[node, value] : point.shape)
                if (number(node) >= 0)
                  {
                    const auto row = static_cast<types::global_dof_index>(number(node));
                    rows.shares.back().back().push_back({row, value * point.weight});
                    if (!rows.owned.is_element(row))
                      foreign.insert(row);
                  }
            }
          rows.writable.add_indices(foreign.begin(), foreign.end());
        }
      return rows;
    }
  } // namespace



  template <int dim>
  ContactRows
  make_contact_rows(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const Sampling                          sampling)
  {
    return sampling == Sampling::nodes ?
             node_rows(elasticity, surfaces) :
             quadrature_rows(surfaces, elasticity.mesh().communicator());
  }



  template ContactRows
  make_contact_rows(const Elasticity<2> &, const std::vector<ContactSurface<2>> &, Sampling);
  template ContactRows
  make_contact_rows(const Elasticity<3> &, const std::vector<ContactSurface<3>> &, Sampling);
} // namespace Signorini
