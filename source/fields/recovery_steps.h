// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "fields/snapshot.h"

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace Signorini
{
  /// The vertices of the slave faces that have contact points, numbered consecutively over all
  /// ranks, with the linear shape functions of the faces. Fields have entries for these vertices
  /// only, so that iterations on them cost vectors of the size of the surface.
  template <int dim>
  class FaceVertices
  {
  public:
    /// Largest number of vertices of a face. Of triangles the last vertex is listed twice, the
    /// second time with the function zero.
    static constexpr unsigned int n = dim == 2 ? 2 : 4;

    using Field = dealii::LinearAlgebra::distributed::Vector<double>;

    /// Number the vertices. Collective.
    /// @param elasticity the model
    /// @param faces the slave faces of this rank
    FaceVertices(const Elasticity<dim> &elasticity, const std::vector<SlaveFace<dim>> &faces);

    /// @return the indices of the vertices of a face in a field; undefined if the face has no
    /// points.
    /// @param f index of the face
    const std::array<dealii::types::global_dof_index, n> &
    operator[](const unsigned int f) const
    {
      return my_vertices[f];
    }

    /// @return a zero field without ghost values.
    Field
    zero() const
    {
      return Field(layout);
    }

    /// @return a copy of a field with readable ghost values.
    /// @param field without ghost values
    static Field
    with_ghosts(const Field &field)
    {
      Field result = field;
      result.update_ghost_values();
      return result;
    }

    /// @return the number of a vertex among the nodes of a face.
    /// @param vertex its number among the vertices
    /// @param face the slave face; triangles are of degree 1
    static unsigned int
    node(const unsigned int vertex, const SlaveFace<dim> &face)
    {
      const unsigned int k = face.degree;
      return is_triangle(face.reference_cell()) ? std::min(vertex, 2u) :
                                                  k * (vertex % 2) + (vertex / 2) * k * (k + 1);
    }

    /// @return the reference position of a vertex.
    /// @param face the slave face
    /// @param vertex its number among the vertices
    static const dealii::Point<dim> &
    position(const SlaveFace<dim> &face, const unsigned int vertex)
    {
      return face.positions[node(vertex, face)];
    }

    /// Values and derivatives by the parameters of the linear functions of all vertices of a face,
    /// at one parameter.
    struct Functions
    {
      std::array<double, n>                     value{};
      std::array<dealii::Tensor<1, dim - 1>, n> slope;

      /// @param shape reference cell of the face
      /// @param xi parameter on it
      Functions(const dealii::ReferenceCell &shape, const dealii::Point<dim - 1> &xi);
    };

  private:
    std::vector<std::array<dealii::types::global_dof_index, n>> my_vertices;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner>  layout;
  };

  /// @return the values at all nodes of a quadratic face from those at its corners: cubic Hermite
  /// interpolation with the gradients on smooth faces, linear at edges; the centre by transfinite
  /// interpolation of the boundary.
  /// @param face the slave face, of degree 2
  /// @param vertices the indices of its vertices in the fields
  /// @param is_smooth whether the face is neither at the edge of contact nor of the master
  /// @param q values at the vertices, with ghost values
  /// @param gradient surface gradients at the vertices, component by component, with ghost values
  template <int dim>
  std::vector<double>
  hermite_values(const SlaveFace<dim>                                                    &face,
                 const std::array<dealii::types::global_dof_index, FaceVertices<dim>::n> &vertices,
                 bool                                                                     is_smooth,
                 const typename FaceVertices<dim>::Field                                 &q,
                 const std::vector<typename FaceVertices<dim>::Field>                    &gradient);

  /// Set the pressures at nodes without pressure function, and at their neighbours that have
  /// adopted their functions. The pressure of such a neighbour is the mean around the centre of
  /// both functions; from there it is extrapolated linearly with the gradients of adjacent parts of
  /// faces. Nodes on the axis of axisymmetric models
  /// are not changed. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param raw pressure as nodal_field(), without ghost values
  /// @param is_positive whether the values are not to be negative
  /// @param pressure whose values at these nodes are changed
  template <int dim>
  void
  extrapolate_to_dirichlet_nodes(const Snapshot<dim> &snapshot,
                                 unsigned int         pair,
                                 const LA::Vector    &raw,
                                 bool                 is_positive,
                                 LA::Vector          &pressure);

  /// Convert a pressure from force per reference area, the unknown of the methods, to Cauchy
  /// pressure, which is reported (doc/theory, 6.5). At small strain both are the same. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param pressure at the nodes, see nodal_field(), which is changed
  template <int dim>
  void
  to_present_areas(const Snapshot<dim> &snapshot, unsigned int pair, LA::Vector &pressure);
} // namespace Signorini
