// SPDX-License-Identifier: Apache-2.0
// This file is compiled once for each instruction set by Highway, and the best one is selected at
// run time, so that one executable runs on all processors at their full speed, and functions of one
// instruction set are never linked in place of another's. (GCC's vector types and
// std::experimental::simd have the vector width of the compiler's flags: they would need a file for
// each instruction set, whose inline functions the linker would then mix.)

#include "matrix_free/batches.h"
#include "matrix_free/instruction_sets.h"
#include "matrix_free/tangent_kernel.h"
#include "matrix_free/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "matrix_free/cell_kernel.cc"
// clang-format off
#include <hwy/foreach_target.h> // first
#include <hwy/highway.h>
#include "matrix_free/cell_lattice.h"
#include "matrix_free/cell_simplex.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace Signorini
{
  namespace HWY_NAMESPACE
  {
    namespace hn = hwy::HWY_NAMESPACE;

    /// The stress of isotropic linear elasticity times the weight w of a point, lambda tr(eps) I +
    /// 2 mu eps, from the displacement gradient G[component][direction]. One vector lane for each
    /// cell of the batch.
    template <typename Number>
    struct IsotropicLaw
    {
      Lanes<Number> lambda, mu;

      HWY_INLINE void
      operator()(const Lanes<Number> w,
                 const Lanes<Number> (&G)[3][3],
                 Lanes<Number> (&S)[3][3]) const
      {
        // The moduli are multiplied by the weight first: two products instead of one for each
        // stress component.
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

    /// Products, diagonals and eigenvalues of isotropic linear elastic cells. Affine cells have one
    /// geometry for the whole cell and use Legendre modes (apply_to_modes()) or the gradients at
    /// the vertices (apply_to_vertices()), the others one at each quadrature point. Does not refer
    /// to the cells after construction.
    /// @tparam Cell CellLattice or CellSimplex
    template <typename Number, typename Cell>
    class Kernel final : public CellSweep<Kernel<Number, Cell>, Number, Cell>
    {
    public:
      explicit Kernel(const KernelCells &cells)
        : batches(cells, width<Number>)
      {
        for (std::size_t b = 0; b < batches.size(); ++b)
          set_geometry(b);
        batches.drop_points();
      }

    private:
      using Values                  = typename Cell::Values;
      using Gradients               = typename Cell::Gradients;
      using V                       = typename Cell::V;
      static constexpr int W        = Cell::W;
      static constexpr int n_nodes  = Cell::n_nodes;
      static constexpr int n_points = Cell::n_points;
      static constexpr int degree   = Cell::degree;
      friend Cell;
      friend CellSweep<Kernel, Number, Cell>;

      /// The geometry at a point: inverse[d][c] = dxi_d/dx_c, and the weight: the quadrature weight
      /// times det J; of affine batches det J alone.
      struct Geometry
      {
        V inverse[3][3], weight;
      };

      HWY_INLINE Geometry
      geometry(const std::size_t b, const int q) const
      {
        const Number *from = batches.geometry(b, q);
        Geometry      at;
        // Numbers 0 to 8 of a geometry are dxi_d/dx_c, row by row, number 9 is the weight; each is
        // stored for all lanes in turn.
        for (int k = 0; k < 9; ++k)
          at.inverse[k / 3][k % 3] = load(from + k * W);
        at.weight = load(from + 9 * W);
        return at;
      }

      /// The quadrature weight of a point times det J; affine batches store det J only.
      HWY_INLINE V
      weight(const std::size_t b, const int q, const Geometry &at) const
      {
        return batches.is_affine(b) ? hn::Mul(at.weight, all(reference.unit_weight(q))) : at.weight;
      }

      HWY_INLINE IsotropicLaw<Number>
                 law(const std::size_t b) const
      {
        return {load(batches.material(b)), load(batches.material(b) + W)};
      }

      /// At a point replace the gradient in reference coordinates by the stress times a weight,
      /// transformed back to reference coordinates: G = (du/dxi) J^-1, then (S J^-T) w.
      /// @param g [component][direction][point][cell]
      template <int n>
      static HWY_INLINE void
      to_stress(const Geometry             &at,
                const V                     weight,
                const IsotropicLaw<Number> &stress,
                const int                   q,
                Number (&g)[3][3][n][W])
      {
        V G[3][3], S[3][3];
        // du_c/dx_k from the derivatives in reference coordinates, by the chain rule.
        for (int c = 0; c < 3; ++c)
          for (int k = 0; k < 3; ++k)
            {
              G[c][k] = hn::Mul(load(g[c][0][q]), at.inverse[0][k]);
              G[c][k] = hn::MulAdd(load(g[c][1][q]), at.inverse[1][k], G[c][k]);
              G[c][k] = hn::MulAdd(load(g[c][2][q]), at.inverse[2][k], G[c][k]);
            }
        stress(weight, G, S);
        // The transposed of this, so that the result multiplies derivatives of shape functions in
        // reference coordinates.
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            {
              V sum = hn::Mul(S[c][0], at.inverse[d][0]);
              sum   = hn::MulAdd(S[c][1], at.inverse[d][1], sum);
              sum   = hn::MulAdd(S[c][2], at.inverse[d][2], sum);
              store(sum, g[c][d][q]);
            }
      }

      /// u = K_e u of a batch: gradients at the points, stresses, and their transposed evaluation
      /// (doc/theory, 7.9). O(n^4) operations for n = degree + 1, instead of O(n^6) with element
      /// matrices.
      HWY_INLINE void
      apply(const std::size_t b, Values &u) const
      {
        if (batches.is_affine(b))
          {
            if constexpr (Cell::is_simplex)
              apply_to_vertices(b, u);
            else
              apply_to_modes(b, u);
            return;
          }
        const IsotropicLaw<Number> stress = law(b);
        Gradients                  g;
        reference.evaluate_gradients(u, g);
        for (int q = 0; q < n_points; ++q)
          {
            const Geometry at = geometry(b, q);
            to_stress(at, at.weight, stress, q, g.of);
          }
        reference.integrate_gradients(g, u);
      }

      /// The same product for affine tetrahedra of constant moduli: gradients and stresses are
      /// linear, so that their values at the vertices suffice, and are integrated exactly.
      HWY_INLINE void
      apply_to_vertices(const std::size_t b, Values &u) const
      {
        const Geometry                 at     = geometry(b, 0);
        const IsotropicLaw<Number>     stress = law(b);
        const V                        volume = hn::Mul(at.weight, all(Cell::unit_volume));
        typename Cell::VertexGradients g;
        Cell::evaluate_at_vertices(u, g);
        for (int v = 0; v < Cell::n_vertices; ++v)
          to_stress(at, volume, stress, v, g.of);
        Cell::average(g);
        Cell::integrate_from_vertices(g, u);
      }

      /// The same product for affine cells of constant moduli, in Legendre polynomials: products of
      /// different polynomials integrate to zero, so that the matrix (doc/theory, (7.14)) couples
      /// few coefficients. Half of the operations of sum factorisation, with the same result.
      HWY_INLINE void
      apply_to_modes(const std::size_t b, Values &u) const
      {
        const Geometry at = geometry(b, 0);
        Modes          modes{u, {}, {}, at.weight, law(b)};
        // The derivative of a polynomial of degree i + 1 in one direction has the coefficient
        // `derivatives[i]` for degree i.
        for (int i = 0; i < degree; ++i)
          for (int d = 0; d < 3; ++d)
            for (int k = 0; k < 3; ++k)
              modes.inverse[i][d][k] =
                hn::Mul(at.inverse[d][k], all(Cell::legendre.derivatives[i]));
        Cell::to_all_modes(u);
        Cell::set_zero(modes.f);
        Cell::add_modes(*this, modes);
        Cell::from_all_modes(modes.f, u);
      }

      /// Coefficients of the displacement and of the forces in Legendre polynomials, and what is
      /// the same for all modes of a batch.
      struct Modes
      {
        const Values              &u;
        Values                     f;
        V                          inverse[degree][3][3];
        V                          volume;
        const IsotropicLaw<Number> law;
      };

      /// Add to the forces the contribution of the gradient's component along L_T: collect the
      /// gradient from the coefficients one degree higher in each direction, evaluate the stress
      /// with the weight int L_T^2 dV, and distribute it to the same coefficients.
      template <int T>
      HWY_INLINE void
      add_mode(Modes &modes) const
      {
        constexpr int i[3]      = {Cell::mode_degree(T, 0),
                                   Cell::mode_degree(T, 1),
                                   Cell::mode_degree(T, 2)};
        constexpr int stride[3] = {Cell::mode_stride(0),
                                   Cell::mode_stride(1),
                                   Cell::mode_stride(2)};
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
        modes.law(hn::Mul(modes.volume, all(Cell::mode_weight(T))), G, S);
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

      /// Compute dxi/dx and the weights of a batch from its node positions: the inverse of the
      /// Jacobian matrix by cofactors at each Gauss point, once for affine cells. Cells that only
      /// fill up a batch get the weight zero.
      void
      set_geometry(const std::size_t b)
      {
        Values x;
        for (int i = 0; i < n_nodes; ++i)
          for (int c = 0; c < 3; ++c)
            for (int w = 0; w < W; ++w)
              x.of[c][i][w] = batches.point(b, w, i, c);
        Gradients J; // dx_c/dxi_d
        reference.evaluate_gradients(x, J);
        for (int q = 0; q < (batches.is_affine(b) ? 1 : n_points); ++q)
          {
            Number *const to = batches.geometry(b, q);
            // Indices are cyclic, so that one formula yields all cofactors with their signs.
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
            // Copies that fill up a batch have the factor zero and add nothing to sums.
            const V whole = hn::Mul(det, load(batches.fills(b)));
            store(batches.is_affine(b) ? whole : hn::Mul(whole, all(reference.unit_weight(q))),
                  to + 9 * W);
          }
      }

      /// The diagonals of the element matrices, K_ii = int mu |grad N|^2 + (lambda + mu) (d_c N)^2
      /// for component c of a node, in values by node.
      void
      diagonal(const std::size_t b, Values &d) const
      {
        const IsotropicLaw<Number> material = law(b);
        for (int i = 0; i < n_nodes; ++i)
          {
            V sum[3] = {hn::Zero(Tag<Number>()), hn::Zero(Tag<Number>()), hn::Zero(Tag<Number>())};
            for (int q = 0; q < n_points; ++q)
              {
                const Geometry at = geometry(b, batches.is_affine(b) ? 0 : q);
                Number         unit[3];
                reference.unit_gradient(q, i, unit);
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

      const Cell      reference;
      Batches<Number> batches;
    };

    /// The kernel of the shape and the degree of the cells, 1 or 2.
    template <typename Number>
    std::unique_ptr<CellKernel<Number>>
    make(const KernelCells &cells)
    {
      constexpr int most = largest_kernel_degree;
      if (cells.are_tetrahedra && cells.degree == 1)
        return std::make_unique<Kernel<Number, CellSimplex<Number, 1>>>(cells);
      if (cells.are_tetrahedra)
        return std::make_unique<Kernel<Number, CellSimplex<Number, most>>>(cells);
      if (cells.degree == 1)
        return std::make_unique<Kernel<Number, CellLattice<Number, 1>>>(cells);
      return std::make_unique<Kernel<Number, CellLattice<Number, most>>>(cells);
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

  template <>
  std::unique_ptr<CellKernel<double>>
  CellKernel<double>::create(const KernelCells &cells, const std::string &instruction_set)
  {
    if (cells.has_tangents())
      return make_tangent_kernel<double>(cells, instruction_set);
    const ForcedInstructionSet only(instruction_set);
    return HWY_DYNAMIC_DISPATCH(make_double)(cells);
  }



  template <>
  std::unique_ptr<CellKernel<float>>
  CellKernel<float>::create(const KernelCells &cells, const std::string &instruction_set)
  {
    if (cells.has_tangents())
      return make_tangent_kernel<float>(cells, instruction_set);
    const ForcedInstructionSet only(instruction_set);
    return HWY_DYNAMIC_DISPATCH(make_float)(cells);
  }
} // namespace Signorini

#endif
