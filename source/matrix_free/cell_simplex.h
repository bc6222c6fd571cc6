// SPDX-License-Identifier: Apache-2.0
// Operations of the kernels on the nodes and quadrature points of a batch of tetrahedra. As
// lattice_lines.h, this file is included once for each instruction set, by the kernels only.

#if defined(SIGNORINI_CELL_SIMPLEX_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SIGNORINI_CELL_SIMPLEX_H
#undef SIGNORINI_CELL_SIMPLEX_H
#else
#define SIGNORINI_CELL_SIMPLEX_H
#endif

#include "geometry/simplex_nodes.h"
#include "matrix_free/cell_values.h"
#include "matrix_free/kernel_tables.h"

HWY_BEFORE_NAMESPACE();
namespace Signorini
{
  namespace HWY_NAMESPACE
  {
    /// The nodes of a batch of tetrahedra: the four vertices, then with degree 2 the middles of the
    /// edges, in the order of deal.II. Gradients of their polynomials are constant, or linear and
    /// given by their values at the vertices: in barycentric coordinates l_a, with u_ab in the
    /// middle of the edge from a to b and u_aa = u_a, du/dl_a at vertex b is 4 u_ab - u_a. Neither
    /// tables nor quadrature are needed for that (doc/theory, 7.9).
    template <typename Number, int of_degree>
    struct CellSimplex : NodeValues<Number, of_degree == 1 ? 4 : 10>
    {
      using Base = NodeValues<Number, of_degree == 1 ? 4 : 10>;
      using Base::n_nodes;
      using Base::W;
      using typename Base::V;
      using typename Base::Values;

      static constexpr bool is_simplex = true;
      static constexpr int  degree     = of_degree;
      /// Gradients at as many vertices determine the gradient everywhere.
      static constexpr int    n_vertices  = degree == 1 ? 1 : 4;
      static constexpr int    n_points    = SimplexTables<Number, degree>::n_points;
      static constexpr Number unit_volume = Number(1. / 6); ///< of the reference cell

      /// [component][direction][point][cell]
      struct Gradients
      {
        alignas(64) Number of[3][3][n_points][W];
      };

      /// [component][direction][vertex][cell]
      struct VertexGradients
      {
        alignas(64) Number of[3][3][n_vertices][W];
      };

      const SimplexTables<Number, degree> tables;

      /// Gradients in reference coordinates at the vertices, from nodal values.
      static HWY_INLINE void
      evaluate_at_vertices(const Values &u, VertexGradients &g)
      {
        for (int c = 0; c < 3; ++c)
          {
            const V origin = load(u.of[c][0]);
            for (int d = 0; d < 3; ++d)
              {
                // The reference coordinate d is l_(d + 1), and l_0 is one minus their sum.
                const V along = hn::Sub(load(u.of[c][d + 1]), origin);
                if constexpr (degree == 1)
                  store(along, g.of[c][d][0]);
                else
                  for (int b = 0; b < 4; ++b)
                    store(hn::MulSub(hn::Sub(load(u.of[c][node_between<3>(d + 1, b)]),
                                             load(u.of[c][node_between<3>(0, b)])),
                                     all(Number(4)),
                                     along),
                          g.of[c][d][b]);
              }
          }
      }

      /// The transpose of evaluate_at_vertices(): nodal values u from g.
      static HWY_INLINE void
      integrate_from_vertices(const VertexGradients &g, Values &u)
      {
        for (int c = 0; c < 3; ++c)
          {
            V of_node[n_nodes];
            for (int i = 0; i < n_nodes; ++i)
              of_node[i] = hn::Zero(Tag<Number>());
            for (int d = 0; d < 3; ++d)
              {
                V sum = hn::Zero(Tag<Number>());
                for (int b = 0; b < n_vertices; ++b)
                  {
                    const V at_vertex = load(g.of[c][d][b]);
                    sum               = hn::Add(sum, at_vertex);
                    if constexpr (degree == 2)
                      {
                        const V four = hn::Mul(at_vertex, all(Number(4)));
                        V      &to   = of_node[node_between<3>(d + 1, b)];
                        V      &from = of_node[node_between<3>(0, b)];
                        to           = hn::Add(to, four);
                        from         = hn::Sub(from, four);
                      }
                  }
                if constexpr (degree == 1)
                  sum = hn::Neg(sum);
                of_node[d + 1] = hn::Sub(of_node[d + 1], sum);
                of_node[0]     = hn::Add(of_node[0], sum);
              }
            for (int i = 0; i < n_nodes; ++i)
              store(of_node[i], u.of[c][i]);
          }
      }

      /// From fields with the values g at the vertices, constant or linear, to their means over the
      /// cell with the functions l_b of the vertices: the matrix (1 + delta_ab)/20 of the means of
      /// l_a l_b.
      static HWY_INLINE void
      average(VertexGradients &g)
      {
        if constexpr (degree == 2)
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d)
              {
                V sum = hn::Zero(Tag<Number>());
                for (int b = 0; b < 4; ++b)
                  sum = hn::Add(sum, load(g.of[c][d][b]));
                for (int b = 0; b < 4; ++b)
                  store(hn::Mul(hn::Add(sum, load(g.of[c][d][b])), all(Number(1. / 20))),
                        g.of[c][d][b]);
              }
      }

      /// Gradients in reference coordinates at the quadrature points, from nodal values u.
      HWY_INLINE void
      evaluate_gradients(const Values &u, Gradients &g) const
      {
        VertexGradients at;
        evaluate_at_vertices(u, at);
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            for (int q = 0; q < n_points; ++q)
              {
                V sum = hn::Zero(Tag<Number>());
                for (int b = 0; b < n_vertices; ++b)
                  sum = hn::MulAdd(load(at.of[c][d][b]), all(tables.values[q][b]), sum);
                store(sum, g.of[c][d][q]);
              }
      }

      /// The transpose of evaluate_gradients().
      HWY_INLINE void
      integrate_gradients(const Gradients &g, Values &u) const
      {
        VertexGradients at;
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            for (int b = 0; b < n_vertices; ++b)
              {
                V sum = hn::Zero(Tag<Number>());
                for (int q = 0; q < n_points; ++q)
                  sum = hn::MulAdd(load(g.of[c][d][q]), all(tables.values[q][b]), sum);
                store(sum, at.of[c][d][b]);
              }
        integrate_from_vertices(at, u);
      }

      /// The weight of a point in the reference cell.
      HWY_INLINE Number
      unit_weight(const int q) const
      {
        return tables.weights[q];
      }

      /// The gradient in reference coordinates of the shape function of node i at point q.
      HWY_INLINE void
      unit_gradient(const int q, const int i, Number (&gradient)[3]) const
      {
        for (int d = 0; d < 3; ++d)
          gradient[d] = 0;
        for (int v = 0; v < n_vertices; ++v)
          {
            Number at_vertex[3];
            unit_gradient_at_vertex(v, i, at_vertex);
            for (int d = 0; d < 3; ++d)
              gradient[d] += tables.values[q][v] * at_vertex[d];
          }
      }

      /// The gradient of the shape function of node i at a vertex.
      static void
      unit_gradient_at_vertex(const int v, const int i, Number (&gradient)[3])
      {
        // Derivatives with respect to barycentric coordinates, as above.
        Number by[4] = {0, 0, 0, 0};
        for (int a = 0; a < 4; ++a)
          if constexpr (degree == 1)
            by[a] = i == a ? 1 : 0;
          else
            by[a] = (int(node_between<3>(a, v)) == i ? 4 : 0) - (i == a ? 1 : 0);
        for (int d = 0; d < 3; ++d)
          gradient[d] = by[d + 1] - by[0];
      }
    };
  } // namespace HWY_NAMESPACE
} // namespace Signorini
HWY_AFTER_NAMESPACE();

#endif
