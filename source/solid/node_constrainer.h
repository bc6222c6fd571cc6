// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/face_parameter.h"
#include "mesh/face_nodes.h"
#include "solid/cell_nodes.h"
#include "solid/constrained_nodes.h"
#include "solid/node_location.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/utilities.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace Signorini
{
  /// The unit vector of axis d.
  template <int dim>
  dealii::Tensor<1, dim>
  axis(const unsigned int d)
  {
    dealii::Tensor<1, dim> e;
    e[d] = 1;
    return e;
  }

  /// Set a unit vector that is an axis up to rounding to that axis exactly, so that faces along
  /// the axes constrain one component and couple none.
  template <int dim>
  dealii::Tensor<1, dim>
  without_rounding(dealii::Tensor<1, dim> n)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (std::abs(n[d]) > 1 - 1e-14)
        n = n[d] > 0 ? axis<dim>(d) : -axis<dim>(d);
    return n;
  }

  /// The nodes on one face of the reference cell, and the evaluation of the normals there.
  template <int dim>
  struct FaceNodes
  {
    std::vector<unsigned int>                  nodes;   ///< numbers in the scalar element
    std::unique_ptr<dealii::FEFaceValues<dim>> normals; ///< at these, then in the middle

    FaceNodes(const dealii::Mapping<dim>       &mapping,
              const dealii::FiniteElement<dim> &scalar,
              const unsigned int                f)
      : nodes(nodes_of_face(scalar, f))
    {
      std::vector<dealii::Point<dim - 1>> points;
      for (const unsigned int i : nodes)
        points.push_back(
          face_parameter<dim>(scalar.reference_cell(), f, scalar.unit_support_point(i)));
      points.push_back(
        scalar.reference_cell().face_reference_cell(f).template barycenter<dim - 1>());
      normals = std::make_unique<dealii::FEFaceValues<dim>>(mapping,
                                                            scalar,
                                                            dealii::Quadrature<dim - 1>(points),
                                                            dealii::update_normal_vectors);
    }

    /// The normal at node k of the face. Where two edges of a cell are on one arc, their angle is
    /// 180 degrees and the Jacobian zero up to rounding, which decides the sign of the normal: that
    /// in the middle of the face is right.
    dealii::Tensor<1, dim>
    normal(const unsigned int k) const
    {
      const dealii::Tensor<1, dim> n = normals->normal_vector(k);
      return n * normals->normal_vector(nodes.size()) < 0 ? -n : n;
    }
  };

  /// Finds the constrained nodes of supports by boundaries, node sets and points. Visits locally
  /// owned and ghost cells, so that the constraints of all relevant degrees of freedom are found
  /// without communication. Hanging nodes are skipped. Refers to its arguments.
  template <int dim>
  class NodeConstrainer
  {
  public:
    NodeConstrainer(const Mesh<dim>                         &mesh,
                    const dealii::DoFHandler<dim>           &dofs,
                    const dealii::AffineConstraints<double> &hanging)
      : mesh(mesh)
      , dofs(dofs)
      , hanging(hanging)
      , nodes_of(mesh, dofs.get_fe_collection())
    {
      for (const auto &fe : dofs.get_fe_collection())
        {
          faces.emplace_back();
          for (const unsigned int f : fe.reference_cell().face_indices())
            faces.back().emplace_back(mesh.surface_mapping(), fe.base_element(0), f);
        }
    }

    /// Call visit(node, normal) for the nodes of the faces of a boundary, face by face; the
    /// normal is that of the true surface at the node, zero if not wanted. A node is visited once
    /// for each face that has it.
    template <typename Visit>
    void
    on_boundary(const BoundaryIds &ids, const bool with_normals, const Visit &visit)
    {
      for (const auto &cell : dofs.active_cell_iterators())
        if (!cell->is_artificial() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() && ids.count(cell->face(f)->boundary_id()) > 0)
              {
                const FaceNodes<dim> &face = faces[cell->active_fe_index()][f];
                read(cell);
                if (with_normals)
                  face.normals->reinit(
                    static_cast<const typename dealii::Triangulation<dim>::cell_iterator &>(cell),
                    f);
                for (unsigned int k = 0; k < face.nodes.size(); ++k)
                  if (ConstrainedNode<dim> *node = constrained_node(face.nodes[k]))
                    visit(*node,
                          with_normals ? without_rounding<dim>(face.normal(k)) :
                                         dealii::Tensor<1, dim>());
              }
    }

    /// Call visit(node) for the nodes of a set of the coarse mesh, and for the nodes on edges,
    /// faces and cells all of whose nodes in the file are in the set. Throws SceneError if nodes of
    /// the set do not exist in the finite-element mesh. Collective.
    /// @param place location of the key in the scene, for messages
    template <typename Visit>
    void
    on_set(const std::string &name, const std::string &place, const Visit &visit)
    {
      ListedNodes<dim> listed(mesh, mesh.node_set(name));
      for (const auto &cell : dofs.active_cell_iterators())
        if (!cell->is_artificial() && listed.has_some(cell->id().get_coarse_cell_id()))
          {
            read(cell);
            for (unsigned int i = 0; i < fe->base_element(0).n_dofs_per_cell(); ++i)
              if (listed.contains(cell->id(), fe->base_element(0).unit_support_point(i)))
                if (ConstrainedNode<dim> *node = constrained_node(i))
                  visit(*node);
          }
      if (const unsigned int n = listed.n_missing(mesh.communicator()); n > 0)
        throw SceneError(place + ": " + std::to_string(n) + " nodes of '" + name +
                         "' at mid-sides are not nodes of the finite-element mesh; refine it, set "
                         "Degree = 2 for this body, or use a set that contains the corners");
    }

    /// Call visit(node) for the node at a point, within 1e-6 of the cell's diameter. Throws
    /// SceneError on all ranks if there is none, or if several bodies have a node there and none
    /// is named. Collective.
    template <typename Visit>
    void
    on_point(const NodeChoice &choice, const Visit &visit)
    {
      dealii::Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = choice.point[d];
      // Flags by body, which are reduced over the ranks, so that all of them throw or none.
      std::vector<unsigned int> found(mesh.n_bodies(), 0);
      double                    nearest = std::numeric_limits<double>::max();
      for (const auto &cell : dofs.active_cell_iterators())
        if (!cell->is_artificial() &&
            (choice.body.empty() || mesh.body_name(mesh.body(cell)) == choice.body))
          {
            const double reach = 1e-6 * cell->diameter(), far = cell->center().distance(x);
            nearest = std::min(nearest, far);
            // Cells whose center is farther away than their diameter cannot have the point.
            if (far > cell->diameter())
              continue;
            read(cell);
            for (unsigned int i = 0; i < fe->base_element(0).n_dofs_per_cell(); ++i)
              {
                nearest = std::min(nearest, position(i).distance(x));
                if (position(i).distance(x) <= reach)
                  {
                    found[mesh.body(cell)] = 1;
                    if (ConstrainedNode<dim> *node = constrained_node(i))
                      visit(*node);
                  }
              }
          }
      dealii::Utilities::MPI::max(found, mesh.communicator(), found);
      nearest      = dealii::Utilities::MPI::min(nearest, mesh.communicator());
      const auto n = std::count(found.begin(), found.end(), 1u);
      if (n == 0)
        throw SceneError(choice.point_location + ": there is no node of the mesh; the nearest is " +
                         std::to_string(nearest) + " away");
      if (n > 1)
        throw SceneError(choice.point_location +
                         ": several bodies have a node there; say which one by 'Point body'");
    }

    /// Call visit(node) for all nodes of a support that are named by sets and points. Collective.
    template <typename Visit>
    void
    on_nodes(const NodeChoice &choice, const Visit &visit)
    {
      for (const std::string &set : choice.sets)
        on_set(set, choice.sets_location, visit);
      if (!choice.point.empty())
        on_point(choice, visit);
    }

    /// Constrain the radial displacement of nodes on the axis of axisymmetric models. Throws
    /// SceneError on all ranks if a body extends to negative radii. Collective.
    void
    constrain_axis()
    {
      const double on_axis = 1e-10 * mesh.size();
      double       lowest  = 0;
      for (const auto &cell : dofs.active_cell_iterators())
        if (!cell->is_artificial() && cell->at_boundary())
          {
            bool near = false;
            // Only cells that touch the axis have nodes there; the lowest radius of all vertices
            // tells whether a body crosses it.
            for (const unsigned int v : cell->vertex_indices())
              {
                near |= cell->vertex(v)[0] < on_axis;
                lowest = std::min(lowest, cell->vertex(v)[0]);
              }
            if (!near)
              continue;
            read(cell);
            for (unsigned int i = 0; i < fe->base_element(0).n_dofs_per_cell(); ++i)
              if (position(i)[0] < on_axis)
                if (ConstrainedNode<dim> *node = constrained_node(i);
                    node && node->prescribed_directions.empty())
                  node->prescribed_directions.push_back({axis<dim>(0), nullptr});
          }
      lowest = dealii::Utilities::MPI::min(lowest, mesh.communicator());
      if (lowest < -on_axis)
        throw SceneError("Model = axisymmetric: a body reaches x = " + std::to_string(lowest) +
                         ", but x is the radius; keep the bodies at x >= 0");
    }

    ConstrainedNodes<dim> result;

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Set the present cell.
    void
    read(const Cell &cell)
    {
      fe    = &cell->get_fe();
      piece = mesh.piece(cell);
      read_indices<dim>(cell, indices);
      positions = &nodes_of(cell);
    }

    /// The position of the cell's node i.
    const dealii::Point<dim> &
    position(const unsigned int i) const
    {
      return (*positions)[fe->component_to_system_index(0, i)];
    }

    /// The entry of the present cell's node i in the result, which is created if there is none;
    /// null if the node hangs.
    ConstrainedNode<dim> *
    constrained_node(const unsigned int i)
    {
      ConstrainedNode<dim> node;
      for (unsigned int d = 0; d < dim; ++d)
        node.dofs[d] = indices[fe->component_to_system_index(d, i)];
      if (hanging.is_constrained(node.dofs[0]))
        return nullptr;
      node.position = position(i);
      node.piece    = piece;
      return &result.emplace(node.dofs[0], node).first->second;
    }

    const Mesh<dim>                         &mesh;
    const dealii::DoFHandler<dim>           &dofs;
    const dealii::AffineConstraints<double> &hanging;
    CellNodes<dim>                           nodes_of;
    std::vector<std::vector<FaceNodes<dim>>> faces; ///< of each element

    // Of the present cell.
    const dealii::FiniteElement<dim>            *fe        = nullptr;
    unsigned int                                 piece     = 0;
    const std::vector<dealii::Point<dim>>       *positions = nullptr;
    std::vector<dealii::types::global_dof_index> indices;
  };

  /// Constrain the normal direction of a symmetry plane or roller, or the given direction of a
  /// roller. Normals of the faces around a node are summed up for each smooth part of the
  /// surface, and the constraint is along their mean.
  /// @param finder to which the constraints are added
  /// @param mesh the mesh
  /// @param support of type symmetry or roller
  template <int dim>
  void
  constrain_normals(NodeConstrainer<dim> &finder,
                    const Mesh<dim>      &mesh,
                    const Support<dim>   &support);
} // namespace Signorini
