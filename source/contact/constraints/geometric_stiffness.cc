// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/geometric_stiffness.h"

#include "linear_algebra/ghost_exchange.h"
#include "linear_algebra/values.h"

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The geometric stiffness G (doc/theory, (5.9)) as a sum over loaded points, sum_ij C_ij R_i^T
    /// R_j, without a matrix. Values of degrees of freedom are stored in slots: first the owned
    /// ones, then those of other ranks that points refer to. Constraints are applied around the
    /// product, as in K: prescribed components are zero, and inclined supports condense one
    /// component of a node into the others.
    template <int dim>
    class PointwiseStiffness : public GeometricStiffness
    {
    public:
      PointwiseStiffness(const Elasticity<dim> &elasticity, std::vector<LoadedPoint<dim>> &&points)
        : points(std::move(points))
        , exchange(elasticity.owned(),
                   dofs(elasticity.owned().size()),
                   elasticity.mesh().communicator())
      {
        use_places();
        find_constraints(elasticity);
      }

      /// dst += factor G v. Collective: ghost values are fetched before, and forces on them are
      /// added to their owners after. Cost: for each point the number of its nodes times that of
      /// its rows.
      void
      vmult_add(LA::Vector &dst, const LA::Vector &v, const double factor) const override
      {
        const std::size_t n_owned = exchange.n_owned();
        // The arrays are members, since products are frequent and their size does not change.
        u.assign(n_owned + exchange.n_ghosts(), 0.);
        std::copy_n(LA::values_of(v), n_owned, u.begin());
        // Extend v to the constrained components.
        for (const auto line : fixed)
          u[line] = 0;
        for (const auto &[line, other, share] : ties)
          u[line] += share * u[other];
        exchange.fetch(u.data(), u.data() + n_owned);

        // Point by point: rows, factors, transposed rows.
        f.assign(u.size(), 0.);
        for (const LoadedPoint<dim> &point : points)
          {
            point.evaluate_rows(u.data(), T);
            CT.assign(T.size(), 0.);
            for (std::size_t i = 0; i < T.size(); ++i)
              for (std::size_t j = 0; j < T.size(); ++j)
                CT[i] += factor * point.factors[i * T.size() + j] * T[j];
            point.add_rows(CT, f.data());
          }

        // Forces on constrained components are condensed into the others.
        exchange.add(f.data() + n_owned, f.data());
        // Forces first return to their owners: ties are between components of one node, which its
        // owner has.
        for (const auto &[line, other, share] : ties)
          f[other] += share * f[line];
        for (const auto line : fixed)
          f[line] = 0;
        double *values = LA::values_of(dst);
        for (std::size_t i = 0; i < n_owned; ++i)
          values[i] += f[i];
      }

      /// Call add(number, number, value) for the entries of G among numbered degrees of freedom.
      /// Points between the same two faces follow each other and are summed up in one dense matrix
      /// before. Collective.
      /// @param numbers number of each degree of freedom in the subset, negative: not in it; owned
      /// entries
      void
      for_each_entry(const LA::Vector                                  &numbers,
                     const std::function<void(double, double, double)> &add) const override
      {
        const std::size_t n_owned = exchange.n_owned();
        Names             names;
        names.numbers.resize(n_owned + exchange.n_ghosts());
        std::copy_n(LA::values_of(numbers), n_owned, names.numbers.begin());
        for (const auto line : fixed)
          names.numbers[line] = -1;
        exchange.fetch(names.numbers.data(), names.numbers.data() + n_owned);
        for (std::vector<double> &shares : names.shares)
          if (has_condensed_dofs)
            shares.assign(names.numbers.size(), 0.);
        for (const auto &[line, other, share] : ties)
          names.shares[other + dim - 1 - line][line] = share;
        for (std::vector<double> &shares : names.shares)
          if (has_condensed_dofs)
            exchange.fetch(shares.data(), shares.data() + n_owned);
        u.assign(names.numbers.size(), 0.);
        std::vector<Named> named, before;
        FullMatrix<double> rows, weighted, sum; // of points between the same two faces
        const auto         hand_on = [&] {
          for (unsigned int k = 0; k < before.size(); ++k)
            for (unsigned int l = 0; l < before.size(); ++l)
              add(before[k].number, before[l].number, sum(k, l));
        };
        for (const LoadedPoint<dim> &point : points)
          {
            // Points whose nodes have no number at all cost nothing; those of one pair of faces
            // have the same names as the point before.
            name_dofs(point, names, named);
            if (named.empty())
              continue;
            if (named != before)
              {
                hand_on();
                before = named;
                sum.reinit(named.size(), named.size());
              }
            const unsigned int       n = point.n_rows();
            const FullMatrix<double> C(n, n, point.factors.data());
            rows.reinit(n, named.size()); // T of the named ones
            weighted.reinit(n, named.size());
            // Column k of `rows`: the rows of the point applied to the unit vector of the degree of
            // freedom.
            for (unsigned int k = 0; k < named.size(); ++k)
              {
                u[named[k].slot] = named[k].share;
                point.evaluate_rows(u.data(), T);
                u[named[k].slot] = 0;
                for (unsigned int i = 0; i < n; ++i)
                  rows(i, k) = T[i];
              }
            C.mmult(weighted, rows);
            rows.Tmmult(sum, weighted, true);
          }
        hand_on();
      }

      std::size_t
      memory_consumption() const override
      {
        std::size_t bytes = 0;
        for (const LoadedPoint<dim> &point : points)
          bytes += sizeof(point) +
                   (point.slave.size() + point.master.size()) * sizeof(NodeShapeFunction<dim>) +
                   point.factors.size() * sizeof(double);
        return bytes;
      }

    private:
      /// A degree of freedom as a share of one that has a number.
      struct Named
      {
        std::uint32_t slot;
        double        share, number;

        bool
        operator==(const Named &other) const
        {
          return std::tie(slot, share, number) == std::tie(other.slot, other.share, other.number);
        }
      };

      /// Numbers of the degrees of freedom on this rank, directly and through inclined supports.
      struct Names
      {
        std::vector<double> numbers; ///< negative: none
        /// The weight of degree of freedom i in degree of freedom i + k + 1 - dim of the same node,
        /// which inclined supports condense: [k][i].
        std::array<std::vector<double>, 2 * dim - 1> shares;
      };

      /// Collect the numbered degrees of freedom of a point, with their weights.
      void
      name_dofs(const LoadedPoint<dim> &point, const Names &names, std::vector<Named> &named) const
      {
        named.clear();
        const auto take = [&](const std::uint32_t slot) {
          const auto name = [&](const std::uint32_t other, const double share) {
            if (names.numbers[other] >= 0)
              named.push_back({slot, share, names.numbers[other]});
          };
          name(slot, 1);
          for (unsigned int k = 0; k < names.shares.size() && has_condensed_dofs; ++k)
            if (const double share = names.shares[k][slot]; share != 0)
              name(slot + k + 1 - dim, share);
        };
        for (const auto *functions : {&point.slave, &point.master})
          for (const NodeShapeFunction<dim> &function : *functions)
            for (unsigned int d = 0; d < dim; ++d)
              take(function.node + d);
        std::vector<std::uint32_t> rigid;
        for (const SparseRow &row : point.rigid)
          for (const auto &entry : row)
            rigid.push_back(entry.first);
        std::sort(rigid.begin(), rigid.end());
        rigid.erase(std::unique(rigid.begin(), rigid.end()), rigid.end());
        std::for_each(rigid.begin(), rigid.end(), take);
      }

      /// All degrees of freedom that points refer to.
      IndexSet
      dofs(const types::global_dof_index n_dofs) const
      {
        std::vector<types::global_dof_index> indices;
        const LoadedPoint<dim>              *before = nullptr;
        for (const LoadedPoint<dim> &point : points)
          {
            if (before == nullptr || !same_nodes(*before, point))
              for (const auto *functions : {&point.slave, &point.master})
                for (const NodeShapeFunction<dim> &function : *functions)
                  for (unsigned int d = 0; d < dim; ++d)
                    indices.push_back(function.node + d);
            before = &point;
            for (const SparseRow &row : point.rigid)
              for (const auto &entry : row)
                indices.push_back(entry.first);
          }
        std::sort(indices.begin(), indices.end());
        indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
        IndexSet result(n_dofs);
        result.add_indices(indices.begin(), indices.end());
        return result;
      }

      void
      use_places()
      {
        for (LoadedPoint<dim> &point : points)
          {
            for (auto *functions : {&point.slave, &point.master})
              for (NodeShapeFunction<dim> &function : *functions)
                function.node = exchange.local_index(function.node);
            for (SparseRow &row : point.rigid)
              for (auto &entry : row)
                entry.first = exchange.local_index(entry.first);
          }
      }

      /// Hanging nodes are left out: points do not refer to them.
      void
      find_constraints(const Elasticity<dim> &elasticity)
      {
        const auto &constraints = elasticity.constraints();
        const auto &owned       = elasticity.owned();
        for (const auto line : owned)
          if (constraints.is_constrained(line))
            fixed.push_back(exchange.local_index(line));
        for (const auto &[first, node] : elasticity.constrained_nodes())
          for (const auto line : node.dofs)
            if (owned.is_element(line) && constraints.is_constrained(line))
              for (const auto &[other, share] : *constraints.get_constraint_entries(line))
                ties.emplace_back(exchange.local_index(line), exchange.local_index(other), share);
        has_condensed_dofs =
          Utilities::MPI::max(ties.empty() ? 0 : 1, elasticity.mesh().communicator()) == 1;
      }

      std::vector<LoadedPoint<dim>>                                 points;
      const LA::GhostExchange<double>                               exchange;
      std::vector<std::uint32_t>                                    fixed; ///< constrained
      std::vector<std::tuple<std::uint32_t, std::uint32_t, double>> ties;
      bool                        has_condensed_dofs = false; ///< any rank
      mutable std::vector<double> u, f, T, CT;                ///< T: rows
    };
  } // namespace



  template <int dim>
  std::unique_ptr<GeometricStiffness>
  geometric_stiffness(const Elasticity<dim>                  &elasticity,
                      const std::vector<ContactSurface<dim>> &surfaces,
                      const ContactRows                      &rows,
                      const PointVectors                     &traction)
  {
    return std::make_unique<PointwiseStiffness<dim>>(
      elasticity, loaded_points(surfaces, rows, traction, elasticity.mesh().communicator()));
  }



  template std::unique_ptr<GeometricStiffness>
  geometric_stiffness(const Elasticity<2> &,
                      const std::vector<ContactSurface<2>> &,
                      const ContactRows &,
                      const PointVectors &);
  template std::unique_ptr<GeometricStiffness>
  geometric_stiffness(const Elasticity<3> &,
                      const std::vector<ContactSurface<3>> &,
                      const ContactRows &,
                      const PointVectors &);
} // namespace Signorini
