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
  /// The vertices of a mesh of hexahedra and of its coarser levels: those of all leaves of this
  /// rank and of all ancestors of these. A vertex is identified by its first degree of freedom in
  /// the space of degree one on the finest mesh; those of the other components follow it.
  class LevelVertices
  {
  public:
    using Index = dealii::types::global_dof_index;

    /// A constraint without inhomogeneity.
    struct Line
    {
      std::vector<std::pair<Index, double>> entries;
      bool                                  hangs; ///< of a hanging node; else of a support

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

    const SpaceFillingCurve &
    curve() const
    {
      return my_curve;
    }

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

    /// Add the vertices by which those of the list are constrained.
    void
    add_masters(std::vector<Index> &list) const;

  private:
    void
    query_other_ranks(MPI_Comm comm);

    const SpaceFillingCurve         my_curve;
    const LA::OwnRange              my_names; ///< degrees of freedom of this rank
    std::vector<bool>               has_line; ///< those of this rank, so that most need no search
    std::vector<Index>              names;    ///< by the number of the vertex on this rank
    std::unordered_map<Index, Line> lines;
  };

  /// The degrees of freedom of the vertices of one level: three a vertex, which the rank owns that
  /// owns those on the finest mesh; those of rigid bodies last.
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

  /// Tangents of the cells of coarser meshes. A derivative in a child's unit coordinates is half of
  /// that in its parent's: where gradients do not change in the parent, its tangent is a quarter of
  /// the sum of those of its children.
  class LevelTangents
  {
  public:
    /// Refers to the tangents of the leaves. Collective.
    LevelTangents(const CellTangents &of_leaves, const SpaceFillingCurve &curve, MPI_Comm comm);

    /// The tangent of a leaf of this rank, or of a cell with children that this rank owns.
    const CellTangent &
    of(const SpaceFillingCurve::Cell &cell) const;

  private:
    void
    send_to_owners(const SpaceFillingCurve &curve, MPI_Comm comm);

    const CellTangents                               &of_leaves;
    std::vector<std::unordered_map<int, CellTangent>> of_ancestors; ///< [level], by index
  };

  /// Displacements of degree one on the finest mesh. Refers to most of them.
  struct LinearDisplacements
  {
    const dealii::DoFHandler<3>             &dofs;
    const dealii::AffineConstraints<double> &hanging, &constraints;
    const dealii::IndexSet                  &owned;
    LA::Vector                               terms; ///< see CellSpace::diagonal_terms
    std::vector<std::vector<double>>         modes; ///< rigid-body modes
    const CellTangents *tangents; ///< of the cells; null: they are of materials at rest
  };

  /// Their space, for kernels.
  CellSpace
  finest_space(const LinearDisplacements &linear, const Elasticity<3> &elasticity);

  /// The same on the meshes that remain when the cells of the finest level are taken back to their
  /// parents, again and again: whatever was refined, each is a mesh of its own with hanging nodes
  /// (global coarsening: Munch, Heister, Prieto Saavedra, Kronbichler, ACM Trans. Parallel Comput.
  /// 10 (2023) 3). Vertices of a coarse cell are vertices of leaves: their degrees of freedom there
  /// name them on all levels, and constraints are the same wherever both are. Ends where a support
  /// would get lost, or where a factorisation is cheap; empty if there is nothing to take back.
  /// Collective.
  Spaces
  mesh_levels(const LinearDisplacements &linear, const Elasticity<3> &elasticity);

  /// Degree one on the same mesh, where bodies have more, then coarser meshes in three dimensions,
  /// as far as supports do not get lost. There may be none: of large deformation, where the
  /// stiffness does not know the tangents of cells. Collective.
  /// @param stiffness of the bodies
  /// @param to_coarser_meshes false: none of these
  template <int dim>
  Spaces
  make_spaces(const Elasticity<dim> &elasticity,
              const Stiffness       &stiffness,
              bool                   to_coarser_meshes);
} // namespace Signorini
