// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/master_projection.h"
#include "solid/elasticity.h"

#include <utility>
#include <vector>

namespace Signorini
{
  /// Sort the entries of a row by index and sum those of the same index.
  void
  sum_duplicates(SparseRow &row);

  /// Replace hanging nodes by the nodes that constrain them. If the row contains any, its entries
  /// are sorted and duplicates are summed.
  void
  condense_hanging_nodes(const dealii::AffineConstraints<double> &hanging, SparseRow &row);

  /// Shape functions of a cell at points of one of its faces, by nodes. Keeps a reference to its
  /// argument.
  template <int dim>
  class Trace
  {
  public:
    using Cell      = typename dealii::DoFHandler<dim>::active_cell_iterator;
    using Parameter = dealii::Point<dim - 1>;

    Trace(const Elasticity<dim> &elasticity);

    /// Set the face for the functions below.
    void
    reinit(const Cell &cell, unsigned int face);

    /// The shape functions at a point of the face, with derivatives in the face parameters, hanging
    /// nodes condensed. @param xi face parameters in [0,1]
    FaceShapeFunctions<dim>
    functions(const Parameter &xi) const;

    /// The values of the shape functions at a point, hanging nodes condensed, without zeros.
    SparseRow
    shape(const Parameter &xi) const;

    /// The values of the shape functions at a point, of hanging nodes themselves, without zeros.
    SparseRow
    unresolved_shape(const Parameter &xi) const;

  private:
    /// A node of a face: which of the cell's degrees of freedom is its first one, and its number
    /// in the lattice of nodes of the face.
    struct Node
    {
      unsigned int dof, place;
    };

    /// Data of a finite element that all its cells share.
    struct Element
    {
      unsigned int                   degree;
      dealii::ReferenceCell          shape; ///< of the faces
      std::vector<std::vector<Node>> nodes; ///< of each face of a cell
    };

    /// The data of an element: its degree, and the nodes of its faces.
    static Element
    element_of(const dealii::FiniteElement<dim> &fe);

    /// Values and derivatives of the shape functions at a point, hanging nodes not condensed.
    FaceShapeFunctions<dim>
    unresolved(const Parameter &xi) const;

    const dealii::AffineConstraints<double> &hanging;
    std::vector<Element>                     elements;

    // Of the present face.
    Cell                                         cell;
    unsigned int                                 face    = dealii::numbers::invalid_unsigned_int;
    const Element                               *element = nullptr;
    std::vector<dealii::types::global_dof_index> indices; ///< of the cell
    std::vector<dealii::types::global_dof_index> nodes;   ///< of the face
  };
} // namespace Signorini
