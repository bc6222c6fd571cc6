// SPDX-License-Identifier: Apache-2.0
// This file is compiled once for each instruction set, as cell_kernel.cc.

#include "matrix_free/tangent_kernel.h"

#include "matrix_free/batches.h"
#include "matrix_free/instruction_sets.h"
#include "matrix_free/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "matrix_free/tangent_kernel.cc"
// clang-format off
#include <hwy/foreach_target.h> // first
#include <hwy/highway.h>
#include "matrix_free/cell_lattice.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace Signorini
{
  namespace HWY_NAMESPACE
  {
    namespace hn = hwy::HWY_NAMESPACE;

    /// Load tangents, which are stored in single precision for both precisions of the products.
    template <typename Number>
    HWY_INLINE Lanes<Number>
               load_single_precision(const float *from)
    {
      if constexpr (std::is_same<Number, float>::value)
        return load(from);
      else
        return hn::PromoteTo(Tag<double>(), hn::Load(hn::Rebind<float, Tag<double>>(), from));
    }

    /// Products with one mean tangent for each cell (in reference coordinates, with weights), in
    /// Legendre polynomials: for multigrid levels, in single precision.
    template <typename Number, int degree>
    class MeanTangentKernel final
      : public CellSweep<MeanTangentKernel<Number, degree>, Number, degree>
    {
    public:
      explicit MeanTangentKernel(const KernelCells &cells)
        : batches(cells, W)
      // Integrals for diagonals; they are over the unit cell.
      {
        for (int i = 0; i < n_nodes; ++i)
          for (int d = 0; d < 3; ++d)
            for (int e = 0; e < 3; ++e)
              {
                products[i][d][e] = 0;
                for (int q = 0; q < n_nodes; ++q)
                  {
                    Number gradient[3];
                    lattice.unit_gradient(q, i, gradient);
                    products[i][d][e] += lattice.unit_weight(q) * gradient[d] * gradient[e];
                  }
              }
      }

    private:
      using Lattice                = CellLattice<Number, degree>;
      using Values                 = typename Lattice::Values;
      using V                      = typename Lattice::V;
      static constexpr int W       = Lattice::W;
      static constexpr int n_nodes = Lattice::n_nodes;
      friend Lattice;
      friend CellSweep<MeanTangentKernel, Number, degree>;

      struct Modes
      {
        const Values &u;
        Values        f;
        const float  *tangent;
      };

      HWY_INLINE void
      apply(const std::size_t b, Values &u) const
      {
        // To coefficients in Legendre polynomials, the contribution of each polynomial of the
        // gradient, and back by the transposed transformation.
        Modes modes{u, {}, batches.tangent(b, 0)};
        Lattice::to_all_modes(u);
        Lattice::set_zero(modes.f);
        Lattice::add_modes(*this, modes);
        Lattice::from_all_modes(modes.f, u);
      }

      /// Add to f the gradient's component along L_T, see Kernel::add_mode().
      template <int T>
      HWY_INLINE void
      add_mode(Modes &modes) const
      {
        constexpr int i[3]      = {Lattice::mode_degree(T, 0),
                                   Lattice::mode_degree(T, 1),
                                   Lattice::mode_degree(T, 2)};
        constexpr int stride[3] = {Lattice::mode_stride(0),
                                   Lattice::mode_stride(1),
                                   Lattice::mode_stride(2)};
        const V       weight    = all(Lattice::mode_weight(T));
        // The nine coefficients of du_c/dxi_d along L_T: the derivative in direction d of the
        // polynomial that has one degree more in that direction. Polynomials of the highest degree
        // have no such neighbour; the coefficient is zero, and is skipped here and below.
        V G[9];
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            if (i[d] < degree)
              G[3 * c + d] = hn::Mul(load(modes.u.of[c][T + stride[d]]),
                                     hn::Mul(weight, all(Lattice::legendre.derivatives[i[d]])));
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            if (i[d] < degree)
              {
                V sum = hn::Zero(Tag<Number>());
                for (int m = 0; m < 9; ++m)
                  // The stress of component (c, d) is the row 3 c + d of the mean tangent times the
                  // gradient. It is tested by the same derivative, so that the matrix of the cell
                  // is symmetric.
                  if (i[m % 3] < degree)
                    sum = hn::MulAdd(load_single_precision<Number>(
                                       modes.tangent + tangent_number(3 * c + d, m) * W),
                                     G[m],
                                     sum);
                Number *f = modes.f.of[c][T + stride[d]];
                store(hn::MulAdd(sum, all(Lattice::legendre.derivatives[i[d]]), load(f)), f);
              }
      }

      void
      diagonal(const std::size_t b, Values &diagonal) const
      {
        // A diagonal entry tests a function with itself: of the tangent only the 3 x 3 block of the
        // same component c is needed, weighted with the integrals of products of derivatives.
        const float *const tangent = batches.tangent(b, 0);
        for (int i = 0; i < n_nodes; ++i)
          for (int c = 0; c < 3; ++c)
            {
              V sum = hn::Zero(Tag<Number>());
              for (int d = 0; d < 3; ++d)
                for (int e = 0; e < 3; ++e)
                  sum = hn::MulAdd(load_single_precision<Number>(
                                     tangent + tangent_number(3 * c + d, 3 * c + e) * W),
                                   all(products[i][d][e]),
                                   sum);
              store(sum, diagonal.of[c][i]);
            }
      }

      const Lattice        lattice;
      const TangentBatches batches;

      /// int dN_i/dxi_d dN_i/dxi_e over the unit cell: [node][d][e].
      Number products[n_nodes][3][3];
    };

    /// Products with one tangent for each Gauss point, by sum factorisation: the consistent tangent
    /// of Newton's method at finite strain.
    template <typename Number, int degree>
    class PointTangentKernel final
      : public CellSweep<PointTangentKernel<Number, degree>, Number, degree>
    {
    public:
      explicit PointTangentKernel(const KernelCells &cells)
        : batches(cells, W)
      {}

    private:
      using Lattice                = CellLattice<Number, degree>;
      using Values                 = typename Lattice::Values;
      using V                      = typename Lattice::V;
      static constexpr int W       = Lattice::W;
      static constexpr int n_nodes = Lattice::n_nodes;
      friend Lattice;
      friend CellSweep<PointTangentKernel, Number, degree>;

      HWY_INLINE void
      apply(const std::size_t b, Values &u) const
      {
        // Gradients in reference coordinates at all Gauss points, the stress of each point in place
        // of its gradient, and the transposed evaluation. Geometry and quadrature weights are in
        // the tangents, so that the kernel has no data of the mesh.
        typename Lattice::Gradients g;
        lattice.evaluate_gradients(u, g);
        for (int q = 0; q < n_nodes; ++q)
          {
            const float *const tangent = batches.tangent(b, q);
            V                  G[9];
            for (int m = 0; m < 9; ++m)
              G[m] = load(g.of[m / 3][m % 3][q]);
            for (int m = 0; m < 9; ++m)
              {
                V sum = hn::Zero(Tag<Number>());
                for (int k = 0; k < 9; ++k)
                  sum =
                    hn::MulAdd(load_single_precision<Number>(tangent + tangent_number(m, k) * W),
                               G[k],
                               sum);
                store(sum, g.of[m / 3][m % 3][q]);
              }
          }
        lattice.integrate_gradients(g, u);
      }

      void
      diagonal(const std::size_t b, Values &diagonal) const
      {
        for (int i = 0; i < n_nodes; ++i)
          {
            V sum[3] = {hn::Zero(Tag<Number>()), hn::Zero(Tag<Number>()), hn::Zero(Tag<Number>())};
            for (int q = 0; q < n_nodes; ++q)
              {
                Number gradient[3];
                lattice.unit_gradient(q, i, gradient);
                const float *const tangent = batches.tangent(b, q);
                for (int c = 0; c < 3; ++c)
                  for (int d = 0; d < 3; ++d)
                    for (int e = 0; e < 3; ++e)
                      sum[c] = hn::MulAdd(load_single_precision<Number>(
                                            tangent + tangent_number(3 * c + d, 3 * c + e) * W),
                                          all(gradient[d] * gradient[e]),
                                          sum[c]);
              }
            for (int c = 0; c < 3; ++c)
              store(sum[c], diagonal.of[c][i]);
          }
      }

      const Lattice        lattice;
      const TangentBatches batches;
    };

    // All instruction sets of both files are in one namespace, so that names of templates here must
    // differ from those in cell_kernel.cc.
    template <typename Number, int degree>
    std::unique_ptr<CellKernel<Number>>
    make_tangent_kernel_of_degree(const KernelCells &cells)
    {
      // One tangent for each cell is a mean; otherwise there is one for each Gauss point.
      if (cells.tangents.size() == cells.size())
        return std::make_unique<MeanTangentKernel<Number, degree>>(cells);
      return std::make_unique<PointTangentKernel<Number, degree>>(cells);
    }

    template <typename Number>
    std::unique_ptr<CellKernel<Number>>
    make_tangent_kernel_of(const KernelCells &cells)
    {
      if (cells.degree == 1)
        return make_tangent_kernel_of_degree<Number, 1>(cells);
      return make_tangent_kernel_of_degree<Number, largest_kernel_degree>(cells);
    }

    std::unique_ptr<CellKernel<double>>
    make_double_tangents(const KernelCells &cells)
    {
      return make_tangent_kernel_of<double>(cells);
    }

    std::unique_ptr<CellKernel<float>>
    make_float_tangents(const KernelCells &cells)
    {
      return make_tangent_kernel_of<float>(cells);
    }
  } // namespace HWY_NAMESPACE
} // namespace Signorini
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace Signorini
{
  HWY_EXPORT(make_double_tangents);
  HWY_EXPORT(make_float_tangents);



  template <>
  std::unique_ptr<CellKernel<double>>
  make_tangent_kernel(const KernelCells &cells, const std::string &instruction_set)
  {
    const ForcedInstructionSet only(instruction_set);
    return HWY_DYNAMIC_DISPATCH(make_double_tangents)(cells);
  }



  template <>
  std::unique_ptr<CellKernel<float>>
  make_tangent_kernel(const KernelCells &cells, const std::string &instruction_set)
  {
    const ForcedInstructionSet only(instruction_set);
    return HWY_DYNAMIC_DISPATCH(make_float_tangents)(cells);
  }
} // namespace Signorini

#endif
