// Highway compiles this file once for each instruction set, so that one executable runs everywhere,
// as fast as the processor can, and no function of one set ends up where another is expected.
// (GCC's vector types and std::experimental::simd have the width of the compiler's flags: they
// would ask for a file per set, whose inline functions the linker then mixes.)

#include <signorini/matrix_free/batches.h>
#include <signorini/matrix_free/kernel_tables.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cstdlib>
#include <type_traits>
#include <utility>

// Those between have vectors of the same width and nothing else that is needed here; those without
// a width at compile time cannot be elements of arrays.
#define HWY_DISABLED_TARGETS                                                                       \
  (HWY_SSE4 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "matrix_free/cell_kernel.cc"
// clang-format off
#include <hwy/foreach_target.h> // first
#include <hwy/highway.h>
#include <signorini/matrix_free/lattice_lines.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace Signorini
{
  namespace HWY_NAMESPACE
  {
    namespace hn = hwy::HWY_NAMESPACE;

    /// Stress of a material point times the weight w of its place, from the gradient of the
    /// displacement: lambda tr(eps) I + 2 mu eps.
    template <typename Number>
    struct IsotropicLaw
    {
      Lanes<Number> lambda, mu;

      HWY_INLINE void
      operator()(const Lanes<Number> w,
                 const Lanes<Number> (&G)[3][3],
                 Lanes<Number> (&S)[3][3]) const
      {
        const Lanes<Number> m = hn::Mul(mu, w);
        const Lanes<Number> trace =
          hn::Mul(hn::Mul(lambda, w), hn::Add(hn::Add(G[0][0], G[1][1]), G[2][2]));
        for (int c = 0; c < 3; ++c)
          {
            S[c][c] = hn::MulAdd(hn::Add(m, m), G[c][c], trace);
            for (int d = 0; d < c; ++d)
              S[c][d] = S[d][c] = hn::Mul(m, hn::Add(G[c][d], G[d][c]));
          }
      }
    };

    template <typename Number, int degree>
    class Kernel final : public CellKernel<Number>
    {
    public:
      explicit Kernel(const KernelCells &cells)
        : batches(cells, width<Number>)
      {
        for (std::size_t b = 0; b < batches.size(); ++b)
          set_geometry(b);
        batches.forget_points();
      }

      void
      add_product(Number *dst, const Number *src) const override
      {
        Values u;
        for (std::size_t b = 0; b < batches.size(); ++b)
          {
            gather(b, src, u);
            apply(b, u);
            scatter(b, u, dst);
          }
      }

      void
      add_diagonal(Number *dst) const override
      {
        Values d;
        for (std::size_t b = 0; b < batches.size(); ++b)
          {
            diagonal(b, d);
            scatter(b, d, dst);
          }
      }

      void
      enlarge_by_eigenvalues(Number *dst) const override
      {
        alignas(64) Number largest[W];
        for (std::size_t b = 0; b < batches.size(); ++b)
          {
            store(eigenvalue(b), largest);
            const std::uint32_t *place = batches.nodes(b);
            for (int k = 0; k < n_nodes * W; ++k)
              for (int c = 0; c < 3; ++c)
                dst[place[k] + c] = HWY_MAX(dst[place[k] + c], largest[k % W]);
          }
      }

      std::size_t
      memory() const override
      {
        return batches.memory();
      }

    private:
      using V                      = Lanes<Number>;
      static constexpr int W       = width<Number>;
      static constexpr int n       = degree + 1;
      static constexpr int n_nodes = n * n * n;

      /// [component][node or point][cell]
      struct Values
      {
        alignas(64) Number of[3][n_nodes][W];
      };

      /// [component][direction][point][cell]
      struct Gradients
      {
        alignas(64) Number of[3][3][n_nodes][W];
      };

      /// Of a point: the derivatives of the unit coordinates by place, and the weight.
      struct Geometry
      {
        V inverse[3][3], weight;
      };

      HWY_INLINE void
      gather(const std::size_t b, const Number *HWY_RESTRICT src, Values &u) const
      {
        const std::uint32_t *place = batches.nodes(b);
#if HWY_TARGET != HWY_SCALAR
        if constexpr (std::is_same<Number, float>::value)
          {
            for (int i = 0; i < n_nodes; ++i)
              gather_nodes(place + i * W, src, u.of[0][i], u.of[1][i], u.of[2][i]);
            return;
          }
#endif
        for (int i = 0; i < n_nodes; ++i)
          for (int w = 0; w < W; ++w)
            {
              const Number *at = src + place[i * W + w];
              u.of[0][i][w]    = at[0];
              u.of[1][i][w]    = at[1];
              u.of[2][i][w]    = at[2];
            }
      }

      // Cells that only fill a batch have no weight: they add nothing.
      HWY_INLINE void
      scatter(const std::size_t b, const Values &u, Number *HWY_RESTRICT dst) const
      {
        const std::uint32_t *place = batches.nodes(b);
        for (int i = 0; i < n_nodes; ++i)
          for (int w = 0; w < W; ++w)
            {
              Number *at = dst + place[i * W + w];
              at[0] += u.of[0][i][w];
              at[1] += u.of[1][i][w];
              at[2] += u.of[2][i][w];
            }
      }

      /// By unit coordinates.
      HWY_INLINE void
      evaluate_gradients(Values &u, Gradients &g) const
      {
        for (int c = 0; c < 3; ++c)
          {
            Number *at = &u.of[c][0][0];
            contract<0, false, false>(tables.values, at, at);
            contract<1, false, false>(tables.values, at, at);
            contract<2, false, false>(tables.values, at, at);
            contract<0, false, false>(tables.derivatives, at, &g.of[c][0][0][0]);
            contract<1, false, false>(tables.derivatives, at, &g.of[c][1][0][0]);
            contract<2, false, false>(tables.derivatives, at, &g.of[c][2][0][0]);
          }
      }

      HWY_INLINE void
      integrate_gradients(const Gradients &g, Values &u) const
      {
        for (int c = 0; c < 3; ++c)
          {
            Number *at = &u.of[c][0][0];
            contract<0, true, false>(tables.derivatives, &g.of[c][0][0][0], at);
            contract<1, true, true>(tables.derivatives, &g.of[c][1][0][0], at);
            contract<2, true, true>(tables.derivatives, &g.of[c][2][0][0], at);
            contract<0, true, false>(tables.values, at, at);
            contract<1, true, false>(tables.values, at, at);
            contract<2, true, false>(tables.values, at, at);
          }
      }

      HWY_INLINE Geometry
      geometry(const std::size_t b, const int q) const
      {
        const Number *from = batches.geometry(b, q);
        Geometry      at;
        for (int k = 0; k < 9; ++k)
          at.inverse[k / 3][k % 3] = load(from + k * W);
        at.weight = load(from + 9 * W);
        return at;
      }

      /// Of the point itself, as the weights of affine batches are those of the whole cell.
      HWY_INLINE V
      weight(const std::size_t b, const int q, const Geometry &at) const
      {
        return batches.is_affine(b) ? hn::Mul(at.weight, all(unit_weight(q))) : at.weight;
      }

      HWY_INLINE Number
      unit_weight(const int q) const
      {
        return tables.weights[q % n] * tables.weights[q / n % n] * tables.weights[q / (n * n)];
      }

      HWY_INLINE IsotropicLaw<Number>
                 law(const std::size_t b) const
      {
        return {load(batches.material(b)), load(batches.material(b) + W)};
      }

      /// Gradients by unit coordinates become stresses, pulled back likewise, times weights. Not
      /// for affine batches.
      HWY_INLINE void
      stresses(const std::size_t b, Gradients &g) const
      {
        const IsotropicLaw<Number> stress = law(b);
        for (int q = 0; q < n_nodes; ++q)
          {
            const Geometry at = geometry(b, q);
            V              G[3][3], S[3][3];
            for (int c = 0; c < 3; ++c)
              for (int k = 0; k < 3; ++k)
                {
                  G[c][k] = hn::Mul(load(g.of[c][0][q]), at.inverse[0][k]);
                  G[c][k] = hn::MulAdd(load(g.of[c][1][q]), at.inverse[1][k], G[c][k]);
                  G[c][k] = hn::MulAdd(load(g.of[c][2][q]), at.inverse[2][k], G[c][k]);
                }
            stress(at.weight, G, S);
            for (int c = 0; c < 3; ++c)
              for (int d = 0; d < 3; ++d)
                {
                  V sum = hn::Mul(S[c][0], at.inverse[d][0]);
                  sum   = hn::MulAdd(S[c][1], at.inverse[d][1], sum);
                  sum   = hn::MulAdd(S[c][2], at.inverse[d][2], sum);
                  store(sum, g.of[c][d][q]);
                }
          }
      }

      /// u = K_e u
      HWY_INLINE void
      apply(const std::size_t b, Values &u) const
      {
        if (batches.is_affine(b))
          return apply_to_modes(b, u);
        Gradients g;
        evaluate_gradients(u, g);
        stresses(b, g);
        integrate_gradients(g, u);
      }

      /// The same for affine cells with a linear law that does not change in them, by Legendre's
      /// polynomials, L_T = L_i(2 xi - 1) L_j(2 eta - 1) L_k(2 zeta - 1): derivatives are other
      /// coefficients, and integrals have no mixed terms. Half of the operations, the same result.
      HWY_INLINE void
      apply_to_modes(const std::size_t b, Values &u) const
      {
        const Geometry at = geometry(b, 0);
        Modes          modes{u, {}, {}, at.weight, law(b)};
        for (int i = 0; i < degree; ++i)
          for (int d = 0; d < 3; ++d)
            for (int k = 0; k < 3; ++k)
              modes.inverse[i][d][k] = hn::Mul(at.inverse[d][k], all(legendre.derivatives[i]));
        for (int c = 0; c < 3; ++c)
          {
            Number *of_c = &u.of[c][0][0];
            to_modes<0, n>(of_c, of_c);
            to_modes<1, n>(of_c, of_c);
            to_modes<2, n>(of_c, of_c);
            for (int i = 0; i < n_nodes; ++i)
              store(hn::Zero(Tag<Number>()), modes.f.of[c][i]);
          }
        add_modes(modes, std::make_integer_sequence<int, n_nodes - 1>());
        for (int c = 0; c < 3; ++c)
          {
            Number *of_c = &modes.f.of[c][0][0];
            from_modes<2, n>(of_c, of_c);
            from_modes<1, n>(of_c, of_c);
            from_modes<0, n>(of_c, &u.of[c][0][0]);
          }
      }

      /// Coefficients of the displacement, of the forces, and what is the same for all.
      struct Modes
      {
        const Values              &u;
        Values                     f;
        V                          inverse[degree][3][3];
        V                          volume;
        const IsotropicLaw<Number> law;
      };

      /// In a function of its own: 26 of them in one take compilers minutes, and are slower.
      template <int T>
      HWY_NOINLINE void
      add_mode_apart(Modes &modes) const
      {
        add_mode<T>(modes);
      }

      template <int... T>
      HWY_INLINE void
      add_modes(Modes &modes, std::integer_sequence<int, T...>) const
      {
        if constexpr (degree == 1)
          (add_mode<T>(modes), ...);
        else
          (add_mode_apart<T>(modes), ...);
      }

      /// What the gradient's part with L_T adds to the forces. Its derivative in direction d comes
      /// from the next higher degree there.
      template <int T>
      HWY_INLINE void
      add_mode(Modes &modes) const
      {
        constexpr int i[3] = {T % n, T / n % n, T / (n * n)}, stride[3] = {1, n, n * n};
        V             G[3][3], S[3][3];
        for (int c = 0; c < 3; ++c)
          for (int k = 0; k < 3; ++k)
            G[c][k] = hn::Zero(Tag<Number>());
        for (int d = 0; d < 3; ++d)
          if (i[d] < degree)
            for (int c = 0; c < 3; ++c)
              {
                const V u = load(modes.u.of[c][T + stride[d]]);
                for (int k = 0; k < 3; ++k)
                  G[c][k] = hn::MulAdd(u, modes.inverse[i[d]][d][k], G[c][k]);
              }
        const Number weight =
          legendre.weights[i[0]] * legendre.weights[i[1]] * legendre.weights[i[2]];
        modes.law(hn::Mul(modes.volume, all(weight)), G, S);
        for (int d = 0; d < 3; ++d)
          if (i[d] < degree)
            for (int c = 0; c < 3; ++c)
              {
                Number *f   = modes.f.of[c][T + stride[d]];
                V       sum = load(f);
                for (int k = 0; k < 3; ++k)
                  sum = hn::MulAdd(S[c][k], modes.inverse[i[d]][d][k], sum);
                store(sum, f);
              }
      }

      void
      set_geometry(const std::size_t b)
      {
        Values x;
        for (int i = 0; i < n_nodes; ++i)
          for (int c = 0; c < 3; ++c)
            for (int w = 0; w < W; ++w)
              x.of[c][i][w] = batches.point(b, w, i, c);
        Gradients J; // dx_c/dxi_d
        evaluate_gradients(x, J);
        for (int q = 0; q < (batches.is_affine(b) ? 1 : n_nodes); ++q)
          {
            Number *const to = batches.geometry(b, q);
            const auto at = [&](const int c, const int d) { return load(J.of[c % 3][d % 3][q]); };
            V          cofactor[3][3], det = hn::Zero(Tag<Number>());
            for (int c = 0; c < 3; ++c)
              for (int d = 0; d < 3; ++d)
                cofactor[c][d] = hn::Sub(hn::Mul(at(c + 1, d + 1), at(c + 2, d + 2)),
                                         hn::Mul(at(c + 1, d + 2), at(c + 2, d + 1)));
            for (int d = 0; d < 3; ++d)
              det = hn::MulAdd(at(0, d), cofactor[0][d], det);
            for (int d = 0; d < 3; ++d)
              for (int c = 0; c < 3; ++c)
                store(hn::Div(cofactor[c][d], det), to + (3 * d + c) * W);
            const V whole = hn::Mul(det, load(batches.fills(b)));
            store(batches.is_affine(b) ? whole : hn::Mul(whole, all(unit_weight(q))), to + 9 * W);
          }
      }

      /// Of the function of a node at a point, by unit coordinates.
      HWY_INLINE void
      unit_gradient(const int q, const int i, Number (&gradient)[3]) const
      {
        const int at[3]   = {q % n, q / n % n, q / (n * n)};
        const int node[3] = {i % n, i / n % n, i / (n * n)};
        for (int d = 0; d < 3; ++d)
          {
            gradient[d] = 0;
            for (int k = 0; k < n; ++k)
              gradient[d] += tables.derivatives[at[d]][k] * tables.values[k][node[d]];
            for (int e = 0; e < 3; ++e)
              if (e != d)
                gradient[d] *= tables.values[at[e]][node[e]];
          }
      }

      /// K_ii = int mu |grad N|^2 + (lambda + mu) (d_c N)^2 for component c of a node.
      void
      diagonal(const std::size_t b, Values &d) const
      {
        const IsotropicLaw<Number> material = law(b);
        for (int i = 0; i < n_nodes; ++i)
          {
            V sum[3] = {hn::Zero(Tag<Number>()), hn::Zero(Tag<Number>()), hn::Zero(Tag<Number>())};
            for (int q = 0; q < n_nodes; ++q)
              {
                const Geometry at = geometry(b, batches.is_affine(b) ? 0 : q);
                Number         unit[3];
                unit_gradient(q, i, unit);
                V G[3], square = hn::Zero(Tag<Number>());
                for (int k = 0; k < 3; ++k)
                  {
                    G[k]   = hn::Mul(at.inverse[0][k], all(unit[0]));
                    G[k]   = hn::MulAdd(at.inverse[1][k], all(unit[1]), G[k]);
                    G[k]   = hn::MulAdd(at.inverse[2][k], all(unit[2]), G[k]);
                    square = hn::MulAdd(G[k], G[k], square);
                  }
                const V w = weight(b, q, at);
                for (int c = 0; c < 3; ++c)
                  sum[c] = hn::MulAdd(w,
                                      hn::MulAdd(hn::Add(material.lambda, material.mu),
                                                 hn::Mul(G[c], G[c]),
                                                 hn::Mul(material.mu, square)),
                                      sum[c]);
              }
            for (int c = 0; c < 3; ++c)
              store(sum[c], d.of[c][i]);
          }
      }

      /// Of D^-1 K of each cell, by a power iteration from something that oscillates.
      V
      eigenvalue(const std::size_t b) const
      {
        constexpr int n_steps = 8;
        Values        d, u, Ku;
        diagonal(b, d);
        Number *const of_d = &d.of[0][0][0], *const of_u = &u.of[0][0][0],
                      *const of_Ku = &Ku.of[0][0][0];
        for (int k = 0; k < 3 * n_nodes; ++k)
          store(all(Number((k * 7919) % 13) - Number(6.25)), of_u + k * W);
        V       quotient = hn::Zero(Tag<Number>());
        const V tiny     = all(Number(1e-30));
        for (int step = 0; step < n_steps; ++step)
          {
            Ku = u;
            apply(b, Ku);
            V energy = hn::Zero(Tag<Number>()), norm = tiny, next = tiny;
            for (int k = 0; k < 3 * n_nodes; ++k)
              {
                const V x = load(of_u + k * W), f = load(of_Ku + k * W), D = load(of_d + k * W);
                energy    = hn::MulAdd(x, f, energy);
                norm      = hn::MulAdd(hn::Mul(D, x), x, norm);
                const V y = hn::Div(f, hn::Max(D, tiny));
                next      = hn::Max(next, hn::Abs(y));
                store(y, of_u + k * W);
              }
            quotient = hn::Div(energy, norm);
            for (int k = 0; k < 3 * n_nodes; ++k)
              store(hn::Div(load(of_u + k * W), next), of_u + k * W);
          }
        return quotient;
      }

      const KernelTables<Number, degree>        tables;
      static constexpr Legendre<Number, degree> legendre{};
      Batches<Number>                           batches;
    };

    template <typename Number>
    std::unique_ptr<CellKernel<Number>>
    make(const KernelCells &cells)
    {
      if (cells.degree == 1)
        return std::make_unique<Kernel<Number, 1>>(cells);
      return std::make_unique<Kernel<Number, largest_kernel_degree>>(cells);
    }

    std::unique_ptr<CellKernel<double>>
    make_double(const KernelCells &cells)
    {
      return make<double>(cells);
    }

    std::unique_ptr<CellKernel<float>>
    make_float(const KernelCells &cells)
    {
      return make<float>(cells);
    }
  } // namespace HWY_NAMESPACE
} // namespace Signorini
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace Signorini
{
  HWY_EXPORT(make_double);
  HWY_EXPORT(make_float);

  namespace
  {
    /// What the environment asks for; empty: nothing.
    std::string
    set_of_environment()
    {
      const char       *value = std::getenv("SIGNORINI_INSTRUCTION_SET");
      const std::string name  = value ? value : "";
      const auto        known = instruction_sets();
      if (name.empty() || std::find(known.begin(), known.end(), name) != known.end())
        return name;
      std::string list;
      for (const std::string &one : known)
        list += " " + one;
      throw SceneError("SIGNORINI_INSTRUCTION_SET = " + name + ": this processor and program have" +
                       list);
    }

    /// Highway's choice, narrowed to one set while there is such an object.
    class OnlySet
    {
    public:
      explicit OnlySet(const std::string &asked_for)
      {
        const std::string name = asked_for.empty() ? set_of_environment() : asked_for;
        if (!name.empty())
          for (const auto target : hwy::SupportedAndGeneratedTargets())
            if (hwy::TargetName(target) == name)
              hwy::SetSupportedTargetsForTest(target);
      }

      ~OnlySet()
      {
        hwy::SetSupportedTargetsForTest(0);
      }
    };
  } // namespace



  template <>
  std::unique_ptr<CellKernel<double>>
  CellKernel<double>::create(const KernelCells &cells, const std::string &instruction_set)
  {
    const OnlySet only(instruction_set);
    return HWY_DYNAMIC_DISPATCH(make_double)(cells);
  }



  template <>
  std::unique_ptr<CellKernel<float>>
  CellKernel<float>::create(const KernelCells &cells, const std::string &instruction_set)
  {
    const OnlySet only(instruction_set);
    return HWY_DYNAMIC_DISPATCH(make_float)(cells);
  }



  std::vector<std::string>
  instruction_sets()
  {
    std::vector<std::string> names;
    for (const auto target : hwy::SupportedAndGeneratedTargets())
      names.push_back(hwy::TargetName(target));
    return names;
  }
} // namespace Signorini

#endif
