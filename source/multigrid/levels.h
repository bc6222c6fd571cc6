// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/own_range.h"
#include "matrix_free/cell_space.h"
#include "multigrid/level.h"
#include "multigrid/space_filling_curve.h"
#include "solid/cell_tangents.h"
#include "solid/elasticity.h"

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <unordered_map>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The vertices of a mesh of hexahedra and of its coarser levels, as far as leaves of this rank
  /// or their ancestors have them. A vertex is identified on all levels by its name, its first
  /// degree of freedom in the space of degree one on the finest mesh; those of the other components
  /// follow it.
  class LevelVertices
  {
  public:
    using Index = dealii::types::global_dof_index;

    /// A homogeneous constraint of a degree of freedom.
    struct Line
    {
      std::vector<std::pair<Index, double>> entries;
      /// True for hanging nodes, false for supports.
      bool hangs;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &entries &hangs;
      }
    };

    /// For a mesh that is distributed by p4est. Collective. @param dofs of degree one
    LevelVertices(const dealii::DoFHandler<3>             &dofs,
                  const dealii::AffineConstraints<double> &hanging,
                  const dealii::AffineConstraints<double> &constraints);

    /// The space-filling curve of the cells.
    const SpaceFillingCurve &
    curve() const
    {
      return my_curve;
    }

    /// The name of the vertex at a corner of a cell of this rank, leaf or ancestor.
    Index
    name(const SpaceFillingCurve::Cell &cell, const unsigned int corner) const
    {
      return names[cell->vertex_index(corner)];
    }

    /// The constraint of a degree of freedom of a vertex on this rank; null if it is free.
    const Line *
    line(const Index dof) const
    {
      if (my_names.has(dof) && !has_line[my_names.local_index(dof)])
        return nullptr;
      const auto known = lines.find(dof);
      return known == lines.end() ? nullptr : &known->second;
    }

    /// Add the names of the vertices by which those of the list are constrained.
    void
    add_masters(std::vector<Index> &list) const;

  private:
    /// Request names and constraints that this rank does not have. Collective.
    void
    query_other_ranks(MPI_Comm comm);

    const SpaceFillingCurve my_curve;
    const LA::OwnRange      my_names; ///< degrees of freedom of this rank
    /// Flags of the owned degrees of freedom with a constraint, so that most of them need no
    /// search.
    std::vector<bool> has_line;
    /// The names of vertices, by their number on this rank; invalid: not needed.
    std::vector<Index>              names;
    std::unordered_map<Index, Line> lines;
  };

  /// The degrees of freedom of the vertices of one level: three for each vertex, owned by the rank
  /// that owns those on the finest mesh; those of rigid bodies are last.
  class VertexNumbers
  {
  public:
    using Index = dealii::types::global_dof_index;

    VertexNumbers() = default;

    /// The numbers on the finest mesh itself. @param owned with those of rigid bodies
    explicit VertexNumbers(const dealii::IndexSet &owned)
      : is_finest(true)
      , my_owned(owned)
    {}

    /// Number the vertices of a coarser level. Collective.
    /// @param corners vertices of this rank's cells on the level
    /// @param known vertices whose numbers this rank needs, some of which may not exist on the
    /// level
    /// @param owned degrees of freedom of the finest mesh
    VertexNumbers(const std::vector<Index> &corners,
                  const std::vector<Index> &known,
                  const dealii::IndexSet   &owned,
                  unsigned int              n_rigid,
                  MPI_Comm                  comm);

    /// True if the level has a vertex.
    bool
    has(const Index name) const
    {
      return is_finest || number(name) != dealii::numbers::invalid_dof_index;
    }

    /// The degree of freedom of a vertex of the level.
    Index
    dof(const Index name, const unsigned int component) const
    {
      return is_finest ? name + component : 3 * number(name) + component;
    }

    /// The degrees of freedom of this rank, with those of rigid bodies.
    const dealii::IndexSet &
    owned_dofs() const
    {
      return my_owned;
    }

    /// This rank's vertices, in the order of their numbers; on coarser levels only.
    const std::vector<Index> &
    owned_names() const
    {
      return my_names;
    }

  private:
    /// The number of a vertex on a coarser level; invalid if the level does not have it, or this
    /// rank does not need it.
    Index
    number(const Index name) const
    {
      if (on_finest.has(name))
        return numbers[on_finest.local_index(name) / 3];
      const auto known = numbers_of_others.find(name);
      return known == numbers_of_others.end() ? dealii::numbers::invalid_dof_index : known->second;
    }

    bool                             is_finest = false;
    LA::OwnRange                     on_finest; ///< this rank's degrees of freedom there
    std::vector<Index>               numbers;   ///< of its vertices there
    std::unordered_map<Index, Index> numbers_of_others;
    std::vector<Index>               my_names;
    dealii::IndexSet                 my_owned;
  };

  /// Tangents of the cells of coarser meshes. A derivative in the reference coordinates of a child
  /// is half of that in its parent's: if gradients are constant in the parent, its tangent is a
  /// quarter of the sum of those of its children.
  class LevelTangents
  {
  public:
    /// Refers to the tangents of the leaves. Collective.
    LevelTangents(const CellTangents &of_leaves, const SpaceFillingCurve &curve, MPI_Comm comm);

    /// The tangent of a leaf of this rank, or of a cell with children that this rank owns.
    const CellTangent &
    of(const SpaceFillingCurve::Cell &cell) const;

  private:
    /// Add up the tangents of cells whose leaves are on several ranks. Collective.
    void
    send_to_owners(const SpaceFillingCurve &curve, MPI_Comm comm);

    const CellTangents                               &of_leaves;
    std::vector<std::unordered_map<int, CellTangent>> of_ancestors; ///< [level], by index
  };

  /// The space of displacements of degree one on the finest mesh. Refers to most of its data.
  struct LinearDisplacements
  {
    const dealii::DoFHandler<3>             &dofs;
    const dealii::AffineConstraints<double> &hanging, &constraints;
    const dealii::IndexSet                  &owned;
    LA::Vector                               terms; ///< see CellSpace::diagonal_terms
    NodePositions                            nodes;
    /// Tangents of the cells; null: those of the undeformed materials.
    const CellTangents *tangents;
  };

  /// The space of degree one on the finest mesh as kernels use it.
  CellSpace
  finest_space(const LinearDisplacements &linear, const Elasticity<3> &elasticity);

  /// Spaces of degree one on the meshes that remain when the cells of the finest level are replaced
  /// by their parents, level after level: each is a mesh of its own, with hanging nodes if the
  /// finest one has some (global coarsening: Munch, Heister, Prieto Saavedra, Kronbichler, ACM
  /// Trans. Parallel Comput. 10 (2023) 3; doc/theory, 7.1). Vertices of coarse cells are vertices
  /// of leaves: their degrees of freedom there identify them on all levels, and constraints are the
  /// same on all levels on which they exist. Ends where a support could not be represented, or
  /// where a factorisation is cheap; empty if nothing can be coarsened. Collective.
  Spaces
  mesh_levels(const LinearDisplacements &linear, const Elasticity<3> &elasticity);

  /// Make the geometric levels: degree one on the same mesh if bodies have a higher degree, then
  /// coarser meshes in three dimensions, as far as supports can be represented. There are none at
  /// finite strain if the stiffness does not provide the tangents of cells. Collective.
  /// @param stiffness stiffness of the bodies
  /// @param to_coarser_meshes false: no coarser meshes
  template <int dim>
  Spaces
  make_spaces(const Elasticity<dim> &elasticity,
              const Stiffness       &stiffness,
              bool                   to_coarser_meshes);
} // namespace Signorini
