#include <signorini/contact/discretisation/geometric_stiffness.h>
#include <signorini/contact/discretisation/tangents.h>
#include <signorini/linear_algebra/ghost_exchange.h>
#include <signorini/linear_algebra/values.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A contact point with tractions: sum_ij C_ij R_i.d R_j.u, with rows R of the four kinds, in
    /// this order. Nodes and rigid rows are named by places in an array.
    template <int dim>
    struct PressedPoint
    {
      FaceFunctions<dim> slave, master;
      /// v.(uS - uM) + rigid.u, of each v; no uM of obstacles.
      std::vector<Tensor<1, dim>> directions;
      std::vector<SparseRow>      rigid; ///< of an obstacle, more of them than directions
      /// v.uM,a of each v and then each a; of bodies.
      std::vector<Tensor<1, dim>> of_master;
      /// sum_a v_a.uS,a
      std::vector<std::array<Tensor<1, dim>, dim - 1>> of_slave;
      std::vector<double>                              factors; ///< C, times the area

      unsigned int
      n_rows() const
      {
        return rigid.empty() ? directions.size() + (dim - 1) * of_master.size() + of_slave.size() :
                               rigid.size();
      }
    };

    template <int dim>
    void
    add_force(const FaceFunctions<dim> &functions, const Tensor<1, dim> &force, double *dst)
    {
      for (const NodeFunction<dim> &function : functions)
        for (unsigned int d = 0; d < dim; ++d)
          dst[function.node + d] += function.value * force[d];
    }

    template <int dim>
    double
    along(const Tensor<1, dim> &direction, const NodeFunction<dim> &function, const double *u)
    {
      double result = 0;
      for (unsigned int d = 0; d < dim; ++d)
        result += direction[d] * u[function.node + d];
      return result;
    }

    /// R_i.u
    template <int dim>
    void
    evaluate_rows(const PressedPoint<dim> &point, const double *u, std::vector<double> &R)
    {
      const auto           element = [u](const std::size_t place) { return u[place]; };
      const Tensor<1, dim> jump = value_at(point.slave, element) - value_at(point.master, element);
      R.assign(point.n_rows(), 0.);
      unsigned int next = 0;
      for (const Tensor<1, dim> &direction : point.directions)
        R[next++] = direction * jump;
      for (unsigned int i = 0; i < point.rigid.size(); ++i)
        for (const auto &[place, value] : point.rigid[i])
          R[i] += value * u[place];
      if (!point.rigid.empty())
        return;
      for (const Tensor<1, dim> &direction : point.of_master)
        {
          for (const NodeFunction<dim> &function : point.master)
            {
              const double value = along(direction, function, u);
              for (unsigned int a = 0; a < dim - 1; ++a)
                R[next + a] += function.slopes[a] * value;
            }
          next += dim - 1;
        }
      for (const auto &directions : point.of_slave)
        {
          for (const NodeFunction<dim> &function : point.slave)
            for (unsigned int a = 0; a < dim - 1; ++a)
              R[next] += function.slopes[a] * along(directions[a], function, u);
          ++next;
        }
    }

    /// dst += sum_i s_i R_i
    template <int dim>
    void
    add_rows(const PressedPoint<dim> &point, const std::vector<double> &s, double *dst)
    {
      unsigned int   next = 0;
      Tensor<1, dim> force;
      for (const Tensor<1, dim> &direction : point.directions)
        force += s[next++] * direction;
      add_force(point.slave, force, dst);
      add_force(point.master, -force, dst);
      for (unsigned int i = 0; i < point.rigid.size(); ++i)
        for (const auto &[place, value] : point.rigid[i])
          dst[place] += value * s[i];
      if (!point.rigid.empty())
        return;
      const auto add = [dst](const NodeFunction<dim> &function,
                             const Tensor<1, dim>    &direction,
                             const double             factor) {
        for (unsigned int d = 0; d < dim; ++d)
          dst[function.node + d] += factor * direction[d];
      };
      for (const Tensor<1, dim> &direction : point.of_master)
        {
          for (const NodeFunction<dim> &function : point.master)
            {
              double factor = 0;
              for (unsigned int a = 0; a < dim - 1; ++a)
                factor += s[next + a] * function.slopes[a];
              add(function, direction, factor);
            }
          next += dim - 1;
        }
      for (const auto &directions : point.of_slave)
        {
          for (const NodeFunction<dim> &function : point.slave)
            for (unsigned int a = 0; a < dim - 1; ++a)
              add(function, directions[a], s[next] * function.slopes[a]);
          ++next;
        }
    }

    template <int dim>
    class PointwiseStiffness : public GeometricStiffness
    {
    public:
      PointwiseStiffness(const Elasticity<dim> &elasticity, std::vector<PressedPoint<dim>> &&points)
        : points(std::move(points))
        , exchange(elasticity.owned(),
                   dofs(elasticity.owned().size()),
                   elasticity.mesh().communicator())
      {
        use_places();
        find_constraints(elasticity);
      }

      void
      vmult_add(LA::Vector &dst, const LA::Vector &v, const double factor) const override
      {
        const std::size_t n_owned = exchange.n_owned();
        u.assign(n_owned + exchange.n_ghosts(), 0.);
        std::copy_n(LA::values_of(v), n_owned, u.begin());
        for (const auto line : fixed)
          u[line] = 0;
        for (const auto &[line, other, share] : ties)
          u[line] += share * u[other];
        exchange.fetch(u.data(), u.data() + n_owned);

        f.assign(u.size(), 0.);
        for (const PressedPoint<dim> &point : points)
          {
            evaluate_rows(point, u.data(), T);
            CT.assign(T.size(), 0.);
            for (std::size_t i = 0; i < T.size(); ++i)
              for (std::size_t j = 0; j < T.size(); ++j)
                CT[i] += factor * point.factors[i * T.size() + j] * T[j];
            add_rows(point, CT, f.data());
          }

        exchange.add(f.data() + n_owned, f.data());
        for (const auto &[line, other, share] : ties)
          f[other] += share * f[line];
        for (const auto line : fixed)
          f[line] = 0;
        double *values = LA::values_of(dst);
        for (std::size_t i = 0; i < n_owned; ++i)
          values[i] += f[i];
      }

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
          if (has_ties)
            shares.assign(names.numbers.size(), 0.);
        for (const auto &[line, other, share] : ties)
          names.shares[other + dim - 1 - line][line] = share;
        for (std::vector<double> &shares : names.shares)
          if (has_ties)
            exchange.fetch(shares.data(), shares.data() + n_owned);
        u.assign(names.numbers.size(), 0.);
        std::vector<Named> named, before;
        FullMatrix<double> rows, weighted, sum; // of points between the same two faces
        const auto         hand_on = [&] {
          for (unsigned int k = 0; k < before.size(); ++k)
            for (unsigned int l = 0; l < before.size(); ++l)
              add(before[k].number, before[l].number, sum(k, l));
        };
        for (const PressedPoint<dim> &point : points)
          {
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
            for (unsigned int k = 0; k < named.size(); ++k)
              {
                u[named[k].place] = named[k].share;
                evaluate_rows(point, u.data(), T);
                u[named[k].place] = 0;
                for (unsigned int i = 0; i < n; ++i)
                  rows(i, k) = T[i];
              }
            C.mmult(weighted, rows);
            rows.Tmmult(sum, weighted, true);
          }
        hand_on();
      }

      std::size_t
      memory() const override
      {
        std::size_t bytes = 0;
        for (const PressedPoint<dim> &point : points)
          bytes += sizeof(point) +
                   (point.slave.size() + point.master.size()) * sizeof(NodeFunction<dim>) +
                   point.factors.size() * sizeof(double);
        return bytes;
      }

    private:
      /// A degree of freedom as a share of one that has a number.
      struct Named
      {
        std::uint32_t place;
        double        share, number;

        bool
        operator==(const Named &other) const
        {
          return std::tie(place, share, number) == std::tie(other.place, other.share, other.number);
        }
      };

      /// Of degrees of freedom here.
      struct Names
      {
        std::vector<double> numbers; ///< negative: none
        /// That one has of another one of its node, which is so many places farther, less dim - 1.
        std::array<std::vector<double>, 2 * dim - 1> shares;
      };

      /// Those of a point.
      void
      name_dofs(const PressedPoint<dim> &point, const Names &names, std::vector<Named> &named) const
      {
        named.clear();
        const auto take = [&](const std::uint32_t place) {
          const auto name = [&](const std::uint32_t other, const double share) {
            if (names.numbers[other] >= 0)
              named.push_back({place, share, names.numbers[other]});
          };
          name(place, 1);
          for (unsigned int k = 0; k < names.shares.size() && has_ties; ++k)
            if (const double share = names.shares[k][place]; share != 0)
              name(place + k + 1 - dim, share);
        };
        for (const auto *functions : {&point.slave, &point.master})
          for (const NodeFunction<dim> &function : *functions)
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

      /// All that points refer to.
      IndexSet
      dofs(const types::global_dof_index n_dofs) const
      {
        std::vector<types::global_dof_index> indices;
        const PressedPoint<dim>             *before = nullptr;
        for (const PressedPoint<dim> &point : points)
          {
            if (before == nullptr || !same_nodes(*before, point))
              for (const auto *functions : {&point.slave, &point.master})
                for (const NodeFunction<dim> &function : *functions)
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
        for (PressedPoint<dim> &point : points)
          {
            for (auto *functions : {&point.slave, &point.master})
              for (NodeFunction<dim> &function : *functions)
                function.node = exchange.place(function.node);
            for (SparseRow &row : point.rigid)
              for (auto &entry : row)
                entry.first = exchange.place(entry.first);
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
            fixed.push_back(exchange.place(line));
        for (const auto &[first, node] : elasticity.held_nodes())
          for (const auto line : node.dofs)
            if (owned.is_element(line) && constraints.is_constrained(line))
              for (const auto &[other, share] : *constraints.get_constraint_entries(line))
                ties.emplace_back(exchange.place(line), exchange.place(other), share);
        has_ties = Utilities::MPI::max(ties.empty() ? 0 : 1, elasticity.mesh().communicator()) == 1;
      }

      std::vector<PressedPoint<dim>>                                points;
      const LA::GhostExchange<double>                               exchange;
      std::vector<std::uint32_t>                                    fixed; ///< constrained
      std::vector<std::tuple<std::uint32_t, std::uint32_t, double>> ties;
      bool                                                          has_ties = false; ///< any rank
      mutable std::vector<double>                                   u, f, T, CT;      ///< T: rows
    };
  } // namespace



  namespace
  {
    /// Of a pressure.
    template <int dim>
    PressedPoint<dim>
    pressed(const FaceFunctions<dim> &slave,
            const FaceFunctions<dim> &master,
            const Tensor<1, dim>     &normal,
            const GapBend<dim>       &bend,
            const double              force)
    {
      PressedPoint<dim> point{
        slave, master, bend.directions, bend.rigid, {normal}, {}, bend.factors};
      for (double &factor : point.factors)
        factor *= force;
      return point;
    }

    /// Adds what a tangential traction T, times the area, does where a pressure is already. The
    /// rows become
    ///
    ///   y_a.(uS - uM), n.(uS - uM), n.uM,a, T.uM,a, and in space tau_2.uS,1 - tau_1.uS,2.
    template <int dim>
    void
    add_tangential(const Tensor<1, dim>    &T,
                   const Tensor<1, dim>    &n,
                   const GapBend<dim>      &bend,
                   const SurfaceFrame<dim> &frame,
                   PressedPoint<dim>       &point)
    {
      constexpr unsigned int m = dim - 1, w = 0, jump = m, n_M = m + 1, T_M = 2 * m + 1,
                             spin = 3 * m + 1, size = 3 * m + 1 + (dim == 3 ? 1 : 0);
      const auto &y = bend.directions;
      // What bend_of_bodies() made its factors of.
      Tensor<2, m> A, G, AKG; // metric, H^-1, A^-1 K H^-1
      for (unsigned int a = 0; a < m; ++a)
        for (unsigned int b = 0; b < m; ++b)
          {
            A[a][b]   = y[a] * y[b];
            G[a][b]   = -bend.factors[a * 2 * m + m + b];
            AKG[a][b] = -bend.factors[a * 2 * m + b];
          }
      const double       gap       = -bend.factors[m * 2 * m + m] / G[0][0];
      const Tensor<2, m> inverse   = invert(A);
      const auto         covariant = [&](const Tensor<1, dim> &v) {
        Tensor<1, m> result;
        for (unsigned int a = 0; a < m; ++a)
          result[a] = v * y[a];
        return result;
      };

      FullMatrix<double> C(size, size);
      const auto         place = [&](const unsigned int i) { return i < m ? i : i + 1; };
      for (unsigned int a = 0; a < 2 * m; ++a)
        for (unsigned int b = 0; b < 2 * m; ++b)
          C(place(a), place(b)) = point.factors[a * 2 * m + b];
      // Row i times v.dn, of a vector v along the master.
      const auto add_dn = [&](const unsigned int i, const Tensor<1, dim> &v, const double factor) {
        const Tensor<1, m> v_a = covariant(v), v_b = inverse * v_a, by_dxi = transpose(AKG) * v_a;
        for (unsigned int b = 0; b < m; ++b)
          {
            C(i, n_M + b) -= factor * (v_b[b] + gap * by_dxi[b]);
            C(i, w + b) -= factor * by_dxi[b];
          }
      };

      add_dn(jump, T, -1);
      for (unsigned int b = 0; b < m; ++b)
        for (unsigned int c = 0; c < m; ++c)
          {
            C(T_M + b, w + c) -= G[b][c];
            C(T_M + b, n_M + c) -= gap * G[b][c];
          }
      point.directions.push_back(n);
      point.of_master.push_back(T);
      if constexpr (dim == 3)
        {
          const ConvectedFrame<3> frame_now(frame.normal, frame.deformation, n);
          const auto             &tau    = frame_now.vectors;
          const auto              E      = vectors_across(frame.normal);
          const Tensor<1, 3>      turned = (T * tau[0]) * tau[1] - (T * tau[1]) * tau[0];
          const Tensor<1, m>      by_w   = inverse * covariant(turned) / frame_now.stretch;
          for (unsigned int a = 0; a < m; ++a)
            {
              C(w + a, spin) += by_w[a];
              add_dn(w + a, tau[1], -by_w[a] * (n * (frame.deformation * E[0])));
              add_dn(w + a, tau[0], by_w[a] * (n * (frame.deformation * E[1])));
            }
          point.of_slave.emplace_back();
          for (unsigned int a = 0; a < m; ++a)
            point.of_slave.back()[a] =
              frame.parameters[0][a] * tau[1] - frame.parameters[1][a] * tau[0];
        }
      point.factors.assign(size * size, 0.);
      for (unsigned int i = 0; i < size; ++i)
        for (unsigned int j = 0; j < size; ++j)
          point.factors[i * size + j] = C(i, j);
    }

    /// The tractions at points of integration, from those of rows.
    template <int dim>
    class TractionsAtPoints
    {
    public:
      /// Collective.
      TractionsAtPoints(const ContactRows                      &rows,
                        const std::vector<ContactSurface<dim>> &surfaces,
                        const PointVectors                     &traction,
                        const MPI_Comm                          comm)
      {
        for (const LA::Vector &component : traction)
          {
            components.emplace_back(rows.owned, rows.writable, comm);
            components.back() = component;
          }
        if (traction.size() > 1)
          tangents.emplace(rows, surfaces, comm);
      }

      /// Times the area.
      double
      pressure(const std::vector<Share> &shares) const
      {
        double sum = 0;
        for (const auto &[row, weight] : shares)
          sum += weight * components[0](row);
        return sum;
      }

      /// Likewise. @param n contact normal
      Tensor<1, dim>
      tangential(const std::vector<Share> &shares,
                 const SurfaceFrame<dim>  &frame,
                 const Tensor<1, dim>     &n) const
      {
        Tensor<1, dim> sum;
        for (const auto &[row, weight] : shares)
          {
            const auto tau = tangents->at(row, frame, n);
            for (unsigned int a = 0; a < dim - 1; ++a)
              sum += weight * components[a + 1](row) * tau[a];
          }
        return sum;
      }

      bool
      has_tangential() const
      {
        return tangents.has_value();
      }

    private:
      PointVectors                 components;
      std::optional<Tangents<dim>> tangents;
    };
  } // namespace



  template <int dim>
  std::unique_ptr<GeometricStiffness>
  geometric_stiffness(const Elasticity<dim>                  &elasticity,
                      const std::vector<ContactSurface<dim>> &surfaces,
                      const ContactRows                      &rows,
                      const PointVectors                     &traction)
  {
    const TractionsAtPoints<dim>   tractions(rows,
                                           surfaces,
                                           traction,
                                           elasticity.mesh().communicator());
    std::vector<PressedPoint<dim>> result;
    for (unsigned int s = 0; s < surfaces.size(); ++s)
      {
        const ContactSurface<dim> &surface = surfaces[s];
        for (unsigned int q = 0; q < surface.points.size(); ++q)
          {
            const ContactPoint<dim>  &point  = surface.points[q];
            const Tensor<1, dim>     &n      = point.direction;
            const std::vector<Share> &shares = rows.shares[s][q];
            const double              force  = tractions.pressure(shares);
            Tensor<1, dim>            T;
            if (tractions.has_tangential())
              T = tractions.tangential(shares, surface.frames[q], n);
            if ((force == 0 && T.norm_square() == 0) || point.bend.factors.empty())
              continue;
            result.push_back(pressed(point.slave, point.master, n, point.bend, force));
            if (T.norm_square() > 0)
              add_tangential(T, n, point.bend, surface.frames[q], result.back());
          }
        for (unsigned int q = 0; q < surface.seams.size(); ++q)
          {
            const Seam<dim>          &seam   = surface.seams[q];
            const std::vector<Share> &shares = rows.seam_shares[s][q];
            const double              force  = tractions.pressure(shares);
            if (seam.bend.factors.empty())
              continue;
            // The end of the segment moves by v.(uM - uS), see bend_of_seam().
            const Tensor<1, dim> &n = seam.bend.directions[0], &v = seam.bend.directions[1];
            if (force != 0)
              {
                const double half = force * seam.bend.factors[1];
                result.push_back(
                  {seam.slave, seam.master, {n, v}, {}, {}, {}, {0., half, half, 0.}});
              }
            if (!tractions.has_tangential())
              continue;
            const Tensor<1, dim> T = tractions.tangential(shares, surface.seam_frames[q], n);
            if (T.norm_square() > 0)
              result.push_back({seam.slave, seam.master, {T, v}, {}, {}, {}, {0., -1., 0., 0.}});
          }
      }
    return std::make_unique<PointwiseStiffness<dim>>(elasticity, std::move(result));
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
