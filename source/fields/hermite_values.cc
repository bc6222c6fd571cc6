// SPDX-License-Identifier: Apache-2.0
#include "fields/recovery_steps.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the number of the vertex of a node at a corner.
    unsigned int
    corner_of_node(const unsigned int node, const unsigned int degree)
    {
      return (node % (degree + 1) > 0 ? 1 : 0) + (node > degree ? 2 : 0);
    }
  } // namespace



  template <int dim>
  std::vector<double>
  hermite_values(const SlaveFace<dim>                                            &face,
                 const std::array<types::global_dof_index, FaceVertices<dim>::n> &vertices,
                 const bool                                                       is_smooth,
                 const typename FaceVertices<dim>::Field                         &q,
                 const std::vector<typename FaceVertices<dim>::Field>            &gradient)
  {
    // Nodes are numbered lexicographically: node i + j (k + 1) is the i-th of row j, with k = 2.
    const unsigned int k = face.degree, rows = dim == 3 ? k + 1 : 1;
    // Corners first, then the middles of the edges (Hermite interpolation adds an eighth of the
    // change of slope times the length), then the centre.
    std::vector<double> values(face.nodes.size());
    for (unsigned int c = 0; c < FaceVertices<dim>::n; ++c)
      values[FaceVertices<dim>::node(c, face)] = q(vertices[c]);
    const auto middle = [&](const unsigned int a, const unsigned int b, const unsigned int m) {
      double               bend = 0;
      const Tensor<1, dim> way  = face.positions[b] - face.positions[a];
      for (unsigned int d = 0; d < dim; ++d)
        bend += (gradient[d](vertices[corner_of_node(a, k)]) -
                 gradient[d](vertices[corner_of_node(b, k)])) *
                way[d];
      // At its middle, a cubic with end values q_a, q_b and end slopes q_a', q_b' over the length L
      // has the value (q_a + q_b)/2 + L (q_a' - q_b')/8. The scalar products of gradients and edge
      // are L q'.
      values[m] = (values[a] + values[b]) / 2 + (is_smooth ? bend / 8 : 0.);
    };
    for (unsigned int j = 0; j < rows; j += k)
      middle(j * (k + 1), j * (k + 1) + k, j * (k + 1) + 1);
    if (dim == 3)
      {
        for (unsigned int i = 0; i <= k; i += k)
          middle(i, k * (k + 1) + i, k + 1 + i);
        // The Coons patch in the middle of a face: half of the four mid-side values minus a quarter
        // of the four corners.
        values[4] = (values[1] + values[3] + values[5] + values[7]) / 2 -
                    (values[0] + values[2] + values[6] + values[8]) / 4;
      }
    return values;
  }



  template std::vector<double>
  hermite_values(const SlaveFace<2> &,
                 const std::array<types::global_dof_index, FaceVertices<2>::n> &,
                 bool,
                 const FaceVertices<2>::Field &,
                 const std::vector<FaceVertices<2>::Field> &);
  template std::vector<double>
  hermite_values(const SlaveFace<3> &,
                 const std::array<types::global_dof_index, FaceVertices<3>::n> &,
                 bool,
                 const FaceVertices<3>::Field &,
                 const std::vector<FaceVertices<3>::Field> &);
} // namespace Signorini
