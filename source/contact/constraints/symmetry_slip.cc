// SPDX-License-Identifier: Apache-2.0
// The slip at nodes that supports hold along the surface, on planes of symmetry for example.
#include "contact/constraints/tangents.h"
#include "linear_algebra/columns.h"
#include "linear_algebra/row_view.h"
#include "linear_algebra/values.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return whether a support holds a node in this direction at all times, without moving it.
    template <int dim>
    bool
    holds(const DirectionConstraint<dim> &constraint)
    {
      const Support<dim> *const support = constraint.support;
      if (!support || support->type == SupportType::symmetry)
        return true; // null: the axis
      if (support->type != SupportType::displacement || support->is_limited())
        return false;
      // The direction of a component of other axes may have several global components.
      for (unsigned int d = 0; d < dim; ++d)
        if ((std::abs(constraint.direction[d]) > 1e-6 || !support->axes.are_global()) &&
            !support->displacement.is_zero(d))
          return false;
      return true;
    }

    /// @return whether supports hold any slave node of a row. Collective.
    template <int dim>
    bool
    holds_any_row(const Elasticity<dim> &elasticity, const GapOperator &contact)
    {
      const auto &constrained = elasticity.constrained_nodes();
      const bool  any =
        std::any_of(contact.origin.node.begin(), contact.origin.node.end(), [&](const auto index) {
          const auto node = constrained.find(index);
          return node != constrained.end() &&
                 std::any_of(node->second.prescribed_directions.begin(),
                             node->second.prescribed_directions.end(),
                             holds<dim>);
        });
      return Utilities::MPI::max(any ? 1 : 0, elasticity.mesh().communicator()) > 0;
    }

    /// For each degree of freedom, what is known of its node: the number of the piece of its body,
    /// plus 1, and up to dim directions n in which it is held, component by component, with n.X.
    template <int dim>
    struct HeldNodes
    {
      LA::Vector              piece;
      std::vector<LA::Vector> directions, places;

      /// Collective.
      explicit HeldNodes(const Elasticity<dim> &elasticity)
        : piece(elasticity.zero_vector())
        , directions(dim, elasticity.zero_vector())
        , places(directions)
      {
        for (const auto &[first, node] : elasticity.constrained_nodes())
          {
            if (!elasticity.owned().is_element(first))
              continue;
            unsigned int k = 0;
            for (const DirectionConstraint<dim> &one : node.prescribed_directions)
              {
                if (k == dim || !holds(one))
                  continue;
                // Of n and -n the one whose largest component is positive.
                unsigned int largest = 0;
                for (unsigned int d = 1; d < dim; ++d)
                  if (std::abs(one.direction[d]) > std::abs(one.direction[largest]) + 1e-6)
                    largest = d;
                const Tensor<1, dim> n =
                  one.direction[largest] > 0 ? one.direction : -one.direction;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    piece(first + d)         = node.piece + 1;
                    directions[k](first + d) = n[d];
                    places[k](first + d)     = n * node.position;
                  }
                ++k;
              }
          }
        piece.compress(VectorOperation::insert);
        for (unsigned int k = 0; k < dim; ++k)
          {
            directions[k].compress(VectorOperation::insert);
            places[k].compress(VectorOperation::insert);
          }
      }
    };

    /// The values of HeldNodes at the local columns of a matrix.
    struct HeldColumns
    {
      std::vector<types::global_dof_index> dofs;
      std::vector<double>                  piece;
      std::vector<std::vector<double>>     directions, places;

      /// @return whether the row has a node of another piece that is held in the same direction, at
      /// the same place along it.
      /// @param n,place,piece of the slave's node @param close distance that counts as none
      template <int dim>
      bool
      has_partner(const LA::RowView    &row,
                  const Tensor<1, dim> &n,
                  const double          place_of_node,
                  const double          piece_of_node,
                  const double          close) const
      {
        for (int k = 0; k < row.size; ++k)
          {
            const int          column = row.columns[k];
            const unsigned int d      = dofs[column] % dim;
            if (piece[column] == 0 || piece[column] == piece_of_node || std::abs(n[d]) < 0.3)
              continue;
            for (unsigned int l = 0; l < directions.size(); ++l)
              if (std::abs(directions[l][column] - n[d]) < 1e-6 &&
                  std::abs(places[l][column] - place_of_node) < close)
                return true;
          }
        return false;
      }
    };
  } // namespace



  // The components of the slip of a row are multiplied by I - q q^T, where q are those of the
  // normal of the plane along the tangents of the row.
  template <int dim>
  void
  remove_slip_across_symmetry_planes(const Elasticity<dim> &elasticity,
                                     const Tangents<dim>   &tangents,
                                     GapOperator           &contact)
  {
    // The vectors of HeldNodes are as long as the displacement: most scenes need none of them.
    if (contact.empty() || !holds_any_row(elasticity, contact))
      return;
    const HeldNodes<dim>     held(elasticity);
    const LA::ColumnExchange columns(contact.B);
    HeldColumns              at{LA::global_columns(contact.B), columns.fetch(held.piece), {}, {}};
    for (unsigned int k = 0; k < dim; ++k)
      {
        at.directions.push_back(columns.fetch(held.directions[k]));
        at.places.push_back(columns.fetch(held.places[k]));
      }
    const double close = 1e-6 * elasticity.mesh().size();
    int          row   = 0;
    for (const auto i : contact.weight.locally_owned_elements())
      {
        const LA::RowView view(contact.B, row);
        const auto        node  = contact.origin.node[row];
        const auto        frame = tangents.at_rest(i);
        for (unsigned int k = 0; k < dim; ++k)
          {
            Tensor<1, dim> n;
            for (unsigned int d = 0; d < dim; ++d)
              n[d] = held.directions[k](node + d);
            Tensor<1, dim - 1> q;
            for (unsigned int a = 0; a < dim - 1; ++a)
              q[a] = frame[a] * n;
            // A plane of symmetry cuts surfaces at right angles.
            if (q.norm() < 0.9 ||
                !at.has_partner(view, n, held.places[k](node), held.piece(node), close))
              continue;
            q /= q.norm();
            std::array<double *, dim - 1> values;
            for (unsigned int a = 0; a < dim - 1; ++a)
              values[a] = LA::RowView(contact.tangential.B[a], row).values;
            const auto project = [&](const auto &component) {
              double along = 0;
              for (unsigned int a = 0; a < dim - 1; ++a)
                along += q[a] * component(a);
              for (unsigned int a = 0; a < dim - 1; ++a)
                component(a) -= along * q[a];
            };
            for (int entry = 0; entry < view.size; ++entry)
              project([&](const unsigned int a) -> double & { return values[a][entry]; });
            project([&](const unsigned int a) -> double & {
              return LA::values_of(contact.tangential.offset[a])[row];
            });
          }
        ++row;
      }
  }



  // With the components q of the direction n of a support along the tangents of a row, the row of
  // the slip along n is sum_a q_a B_a. In it the entry w of the node itself becomes n (n.w), and
  // entries of free degrees of freedom vanish.
  template <int dim>
  void
  align_slip_with_supports(const Elasticity<dim> &elasticity,
                           const Tangents<dim>   &tangents,
                           const LA::Vector      &is_free,
                           GapOperator           &contact)
  {
    // The sine of about 17 degrees: more than tangents differ from those of the body on meshes
    // that show its shape.
    constexpr double small = 0.3;
    const auto      &nodes = elasticity.constrained_nodes();
    // Most scenes hold no slave node.
    const bool any = std::any_of(contact.origin.node.begin(),
                                 contact.origin.node.end(),
                                 [&](const auto node) { return nodes.count(node) > 0; });
    if (Utilities::MPI::max(any ? 1 : 0, elasticity.mesh().communicator()) == 0)
      return;
    const auto dofs = LA::global_columns(contact.B);
    const auto free = LA::ColumnExchange(contact.B).fetch(is_free);
    int        row  = -1;
    for (const auto i : contact.weight.locally_owned_elements())
      {
        const auto first = contact.origin.node[++row];
        const auto node  = nodes.find(first);
        if (node == nodes.end())
          continue;
        const auto frame = tangents.at_rest(i);
        for (const DirectionConstraint<dim> &one : node->second.prescribed_directions)
          {
            const Tensor<1, dim> &n = one.direction;
            Tensor<1, dim - 1>    q;
            for (unsigned int a = 0; a < dim - 1; ++a)
              q[a] = frame[a] * n;
            if (q.norm() < std::sqrt(1 - small * small))
              continue;
            q /= q.norm();
            const LA::RowView             shape(contact.B, row);
            std::array<double *, dim - 1> values;
            for (unsigned int a = 0; a < dim - 1; ++a)
              values[a] = LA::RowView(contact.tangential.B[a], row).values;
            // The row along n, and what is to remain of it.
            std::vector<double> along(shape.size, 0.), kept(shape.size, 0.);
            for (unsigned int a = 0; a < dim - 1; ++a)
              for (int k = 0; k < shape.size; ++k)
                along[k] += q[a] * values[a][k];
            double held = 0, rest = 0;
            for (int k = 0; k < shape.size; ++k)
              {
                const auto dof = dofs[shape.columns[k]];
                if (dof >= first && dof < first + dim)
                  {
                    for (int l = 0; l < shape.size; ++l)
                      if (const auto other = dofs[shape.columns[l]];
                          other >= first && other < first + dim)
                        kept[k] += n[dof - first] * n[other - first] * along[l];
                  }
                else if (free[shape.columns[k]] == 0)
                  kept[k] = along[k];
                held += std::abs(kept[k]);
                rest += std::abs(along[k] - kept[k]);
              }
            // Other free motion makes slip of its own: that of the master, or of neighbours.
            if (rest > small * held)
              continue;
            for (unsigned int a = 0; a < dim - 1; ++a)
              for (int k = 0; k < shape.size; ++k)
                values[a][k] += q[a] * (kept[k] - along[k]);
          }
      }
  }



  template void
  align_slip_with_supports(const Elasticity<2> &,
                           const Tangents<2> &,
                           const LA::Vector &,
                           GapOperator &);
  template void
  align_slip_with_supports(const Elasticity<3> &,
                           const Tangents<3> &,
                           const LA::Vector &,
                           GapOperator &);
  template void
  remove_slip_across_symmetry_planes(const Elasticity<2> &, const Tangents<2> &, GapOperator &);
  template void
  remove_slip_across_symmetry_planes(const Elasticity<3> &, const Tangents<3> &, GapOperator &);
} // namespace Signorini
