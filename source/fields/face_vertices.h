// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"

#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <memory>
#include <vector>

namespace Signorini
{
  /// The vertices of the slave faces that have contact points, numbered over all ranks, and the
  /// linear functions of the faces. Fields have entries for the vertices alone: what is iterated
  /// costs vectors of the surface.
  template <int dim>
  class FaceVertices
  {
  public:
    static constexpr unsigned int n = dim == 2 ? 2 : 4; ///< of a face

    using Field = dealii::LinearAlgebra::distributed::Vector<double>;

    /// Number the vertices. Collective.
    FaceVertices(const Elasticity<dim> &elasticity, const std::vector<SlaveFace<dim>> &faces);

    /// The entries of the vertices of face f in a field; without meaning if it has no points.
    const std::array<dealii::types::global_dof_index, n> &
    operator[](const unsigned int f) const
    {
      return my_vertices[f];
    }

    Field
    zero() const
    {
      return Field(layout);
    }

    static Field
    with_ghosts(const Field &field)
    {
      Field result = field;
      result.update_ghost_values();
      return result;
    }

    /// The number of a vertex among the nodes of a face.
    static unsigned int
    node(const unsigned int vertex, const unsigned int degree)
    {
      return degree * (vertex % 2) + (vertex / 2) * degree * (degree + 1);
    }

    /// The reference position of a vertex of a slave face.
    static const dealii::Point<dim> &
    position(const SlaveFace<dim> &face, const unsigned int vertex)
    {
      return face.positions[node(vertex, face.degree)];
    }

    /// The linear functions of the vertices of a face and their derivatives, at a parameter.
    struct Functions
    {
      std::array<double, n>                     value;
      std::array<dealii::Tensor<1, dim - 1>, n> slope;

      explicit Functions(const dealii::Point<dim - 1> &xi);
    };

  private:
    std::vector<std::array<dealii::types::global_dof_index, n>> my_vertices;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner>  layout;
  };
} // namespace Signorini
