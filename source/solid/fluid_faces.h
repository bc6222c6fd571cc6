// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <deal.II/hp/fe_values.h>

#include <vector>

namespace Signorini
{
  /// A face of a load with a fluid, on this rank.
  template <int dim>
  struct FluidFace
  {
    typename dealii::DoFHandler<dim>::active_cell_iterator cell;
    unsigned int                                           number;
    /// The first degree of freedom of each vertex, which stands for the vertex.
    std::vector<dealii::types::global_dof_index> vertices;
    dealii::Point<dim>                           middle;
    double                                       area; ///< [reference area]
    bool                                         is_wet, is_closed = false, is_tied = false;
    double                                       contact_pressure = 0;

    /// The shortest distance of a point from vertices and middle of the face.
    double
    distance(const dealii::Point<dim> &x) const;
  };

  /// The faces of a load with a fluid, on this rank. Keeps a reference to its argument.
  template <int dim>
  class FluidFaces
  {
  public:
    FluidFaces(const Elasticity<dim> &elasticity, const Load<dim> &load);

    std::vector<FluidFace<dim>> all;

    /// The mean pressures on the faces of forces on nodes, along the normals of the faces: nodes
    /// have the force on them over their share of the surface, both along the normal (doc/theory,
    /// (2.39)). Collective.
    /// @param u displacement @param forces each on all degrees of freedom
    /// @return for each force the pressure of each face
    std::vector<std::vector<double>>
    pressures(const LA::Vector &u, const std::vector<const LA::Vector *> &forces);

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    void
    add_face(const Cell &cell, unsigned int f, bool is_wet);
    /// A vector with means of their neighbours at hanging nodes, with ghosts. Collective.
    LA::Vector
    with_hanging_nodes(LA::Vector v) const;
    /// Call act(face, dofs, areas) for each face: the degrees of freedom of its cell node by node,
    /// and for each node int N n da over the current face.
    template <typename Act>
    void
    visit(const LA::Vector &ghosted, const Act &act);

    const Elasticity<dim>                       &elasticity;
    const dealii::hp::FECollection<dim>          elements;
    dealii::hp::FEFaceValues<dim>                all_values, all_gradients;
    const std::vector<std::vector<unsigned int>> all_dofs;
    std::vector<dealii::types::global_dof_index> indices;
  };
} // namespace Signorini
