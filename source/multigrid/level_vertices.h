// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/own_range.h"
#include "multigrid/space_filling_curve.h"

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
} // namespace Signorini
