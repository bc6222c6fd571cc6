// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/condensed_columns.h"
#include "contact/constraints/contact_rows.h"
#include "contact/constraints/gap_operator.h"
#include "contact/constraints/tangents.h"
#include "contact/laws/contact_status.h"
#include "contact/traction/normal_stress.h"
#include "linear_algebra/diagonal.h"
#include "linear_algebra/entries.h"
#include "linear_algebra/sparsity_pattern.h"
#include "solid/cell_nodes.h"
#include "solid/resultant.h"
#include <signorini/contact/methods/method.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Assemble the rows of the slip (doc/theory, (3.13)), one matrix for each tangent with the
    /// sparsity pattern of B, still weighted by the areas of the rows; and the offsets sigma_a, the
    /// true slip (5.16) since the start of the load step, as sums over points. normalise() divides
    /// both by the areas. Collective.
    template <int dim>
    void
    assemble_slip(GapOperator                            &contact,
                  const ContactRows                      &rows,
                  const std::vector<ContactSurface<dim>> &surfaces,
                  const std::vector<FaceMatrix>          &matrices,
                  const LA::SparsityPattern              &pattern,
                  const Tangents<dim>                    &tangents,
                  const MPI_Comm                          comm)
    {
      TangentialRows  &tangential = contact.tangential;
      const LA::Vector zero(rows.owned, comm);
      // The tangents of each row on the undeformed surface, for the output and for the transfer of
      // tractions between meshes.
      tangential.offset.assign(dim - 1, zero);
      tangential.at_rest.assign(dim - 1, std::vector<LA::Vector>(dim, zero));
      for (unsigned int a = 0; a < dim - 1; ++a)
        {
          LA::SparseMatrix &B = tangential.B.emplace_back();
          B.reinit(pattern);
          for (const FaceMatrix &matrix : matrices)
            // All components have the columns of the normal gap, so that solvers combine them entry
            // by entry.
            B.add(matrix.rows, matrix.columns, matrix.slip[a]);
          B.compress(VectorOperation::add);
          for (const auto row : rows.owned)
            for (unsigned int d = 0; d < dim; ++d)
              tangential.at_rest[a][d](row) = tangents.at_rest(row)[a][d];
          for (LA::Vector &component : tangential.at_rest[a])
            component.compress(VectorOperation::insert);
        }
      // Offsets: the slip at each point, distributed to the rows with their shares of its area.
      // Directions and moments likewise.
      constexpr unsigned int n_moments = dim == 2 ? 1 : 3;
      tangential.direction.assign(dim - 1, std::vector<LA::Vector>(dim, zero));
      tangential.moment.assign(dim - 1, std::vector<LA::Vector>(n_moments, zero));
      tangential.master_moment = tangential.moment;
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        for (unsigned int q = 0; q < surfaces[p].frames.size(); ++q)
          for (const auto &[row, weight] : rows.shares[p][q])
            {
              const ContactPoint<dim> &point = surfaces[p].points[q];
              const SurfaceFrame<dim> &frame = surfaces[p].frames[q];
              const auto               slip  = tangents.slip(row, frame, point.direction);
              const auto               tau   = tangents.at(row, frame, point.direction);
              // Where an unbiased method exchanges the surfaces, tractions act on the pair's
              // master.
              const double side = point.normal * point.direction < 0 ? -weight : weight;
              for (unsigned int a = 0; a < dim - 1; ++a)
                {
                  tangential.offset[a](row) += weight * slip[a];
                  const Tensor<1, 3> moment    = moment_of(point.slave_force_point, tau[a]),
                                     on_master = moment_of(point.master_force_point, tau[a]);
                  for (unsigned int d = 0; d < dim; ++d)
                    tangential.direction[a][d](row) += side * tau[a][d];
                  for (unsigned int d = 0; d < n_moments; ++d)
                    {
                      tangential.moment[a][d](row) += side * moment[d];
                      tangential.master_moment[a][d](row) += side * on_master[d];
                    }
                }
            }
      for (LA::Vector &offset : tangential.offset)
        offset.compress(VectorOperation::add);
    }

    /// Assemble B (doc/theory, (3.4)), the rows of the slip, and S of s = S u + s_0 for Nitsche's
    /// method, as sums over face matrices and still weighted by areas. Rows of another rank receive
    /// contributions; so this is collective. Cost: proportional to the number of contact points.
    /// @param tangents null: the method does not use the slip
    template <int dim>
    void
    assemble_matrices(GapOperator                            &contact,
                      const ContactRows                      &rows,
                      const std::vector<ContactSurface<dim>> &surfaces,
                      const ContactMethod                    &method,
                      const Tangents<dim>                    *tangents,
                      const Elasticity<dim>                  &elasticity)
    {
      const MPI_Comm comm = elasticity.mesh().communicator();
      // One dense matrix for each slave face (or group of points with the same nodes): its rows and
      // columns define the pattern too.
      const std::vector<FaceMatrix> matrices = face_matrices(
        rows, surfaces, method.sampling(), tangents, elasticity.has_inclined_supports());
      LA::SparsityPattern pattern(rows.owned, contact.dofs, rows.writable, comm, 0u);
      for (const FaceMatrix &matrix : matrices)
        {
          const auto others = columns_by_equations(elasticity, matrix.columns);
          for (const auto row : matrix.rows)
            {
              pattern.add_entries(row, matrix.columns.begin(), matrix.columns.end(), true);
              pattern.add_entries(row, others.begin(), others.end(), true);
            }
        }
      pattern.compress();
      contact.B.reinit(pattern);
      for (const FaceMatrix &matrix : matrices)
        contact.B.add(matrix.rows, matrix.columns, matrix.displacement);
      contact.B.compress(VectorOperation::add);
      if (tangents)
        assemble_slip(contact, rows, surfaces, matrices, pattern, *tangents, comm);
      if (method.pressure_shift() != PressureShift::normal_stress)
        return;
      // The term with theta S^T is consistent if s = p at each point, which another pair at the
      // same points may invalidate; the method with theta = 0 is always consistent.
      const bool are_shared =
        Utilities::MPI::max(have_coinciding_points(surfaces) ? 1 : 0, comm) > 0;
      contact.theta = are_shared ? 0. : method.theta();
      for (unsigned int a = 0; a < contact.n_components(); ++a)
        {
          LA::SparseMatrix &S = contact.S.emplace_back();
          S.reinit(pattern);
          for (const FaceMatrix &matrix : matrices)
            S.add(matrix.rows, matrix.columns, matrix.stress[a]);
          S.compress(VectorOperation::add);
        }
    }

    /// Sum up areas W (3.3), gaps, offsets, stiffness, penalty parameters and geometry of the rows
    /// over the points, with the share of each row as weight. Collective.
    /// @param size size of the model [length]; @param moved true in displaced configurations
    template <int dim>
    void
    assemble_vectors(GapOperator                            &contact,
                     const ContactRows                      &rows,
                     const std::vector<ContactSurface<dim>> &surfaces,
                     const ContactMethod                    &method,
                     const double                            size,
                     const bool                              moved,
                     const MPI_Comm                          comm)
    {
      const unsigned int n_moments = dim == 2 ? 1 : 3;
      contact.weight.reinit(rows.owned, comm);
      contact.reference_gap.reinit(contact.weight);
      contact.coefficients.stiffness.reinit(contact.weight);
      contact.coefficients.area_ratio.reinit(contact.weight);
      contact.coefficients.least_status.reinit(contact.weight);
      contact.coefficients.friction.reinit(contact.weight);
      contact.coefficients.epsilon.reinit(contact.weight);
      // Moments have one component in the plane and three in space.
      contact.geometry.position.assign(dim, contact.zero());
      contact.geometry.normal.assign(dim, contact.zero());
      contact.geometry.moment.assign(n_moments, contact.zero());
      if (moved)
        {
          contact.moved.gap_offset = contact.zero();
          contact.geometry.master_moment.assign(n_moments, contact.zero());
        }

      for (unsigned int p = 0; p < surfaces.size(); ++p)
        for (unsigned int q = 0; q < surfaces[p].points.size(); ++q)
          {
            const ContactPoint<dim> &point  = surfaces[p].points[q];
            const Tensor<1, 3>       moment = moment_of(point.slave_force_point, point.normal),
                               on_master    = moment_of(point.master_force_point, point.normal);
            // The penalty parameter epsilon of the point [force/length^3] (doc/theory, (2.2)).
            const double epsilon =
              method.penalty({point.stiffness, size / point.depth, point.bound});
            // Moments are those of a unit force along the normal; the traction times the area
            // multiplies them later.
            for (const auto &[row, weight] : rows.shares[p][q])
              {
                contact.weight(row) += weight;
                contact.reference_gap(row) += weight * point.gap;
                if (moved)
                  contact.moved.gap_offset(row) += weight * point.gap_offset;
                contact.coefficients.stiffness(row) += weight * point.stiffness;
                contact.coefficients.area_ratio(row) += weight * point.stretch;
                contact.coefficients.epsilon(row) += weight * epsilon;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    contact.geometry.position[d](row) += weight * point.position[d];
                    contact.geometry.normal[d](row) += weight * point.normal[d];
                  }
                for (unsigned int d = 0; d < n_moments; ++d)
                  {
                    contact.geometry.moment[d](row) += weight * moment[d];
                    if (moved)
                      contact.geometry.master_moment[d](row) += weight * on_master[d];
                  }
              }
          }
    }

    /// Set the positions of rows to those of their nodes; the weighted mean of the surroundings
    /// would be off the node at rims of the contact surface. Loops over the cells of this rank,
    /// since a node may have no slave face on the rank that owns it.
    template <int dim>
    void
    move_to_nodes(GapOperator &contact, const Elasticity<dim> &elasticity)
    {
      // A node that is slave in two pairs has two rows.
      std::multimap<types::global_dof_index, types::global_dof_index> rows_of;
      auto row = contact.origin.node.begin();
      for (const auto i : contact.weight.locally_owned_elements())
        rows_of.emplace(*row++, i);

      // Several cells around a node write the same position; inserting it twice does no harm.
      CellNodes<dim> nodes_of(elasticity.mesh(), elasticity.finite_elements());
      std::vector<types::global_dof_index> indices;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            read_indices<dim>(cell, indices);
            if (std::none_of(indices.begin(), indices.end(), [&](const auto i) {
                  return rows_of.count(i);
                }))
              continue;
            const std::vector<Point<dim>> &nodes = nodes_of(cell);
            for (unsigned int i = 0; i < indices.size(); ++i)
              for (auto [at, last] = rows_of.equal_range(indices[i]); at != last; ++at)
                for (unsigned int d = 0; d < dim; ++d)
                  contact.geometry.position[d](at->second) = nodes[i][d];
          }
      for (LA::Vector &v : contact.geometry.position)
        v.compress(VectorOperation::insert);
    }

    /// Divide all sums over points by the area W of their row, so that gaps, stresses and matrices
    /// are means (doc/theory, (3.3)). Collective.
    void
    normalise(GapOperator &contact)
    {
      contact.weight.compress(VectorOperation::add);
      // Nodes whose area is rounding have no row (contact_rows.cc), and cause no division by zero.
      LA::Vector inverse = contact.zero();
      for (const auto i : inverse.locally_owned_elements())
        inverse(i) = 1 / contact.weight(i);
      inverse.compress(VectorOperation::insert);

      std::vector<LA::Vector *> means = {&contact.reference_gap,
                                         &contact.coefficients.stiffness,
                                         &contact.coefficients.area_ratio,
                                         &contact.coefficients.epsilon};
      if (contact.moved.gap_offset.size() > 0)
        means.push_back(&contact.moved.gap_offset);
      for (auto *group : {&contact.geometry.position,
                          &contact.geometry.normal,
                          &contact.geometry.moment,
                          &contact.geometry.master_moment})
        for (LA::Vector &v : *group)
          means.push_back(&v);
      for (auto *group : {&contact.tangential.direction,
                          &contact.tangential.moment,
                          &contact.tangential.master_moment})
        for (std::vector<LA::Vector> &of_tangent : *group)
          for (LA::Vector &v : of_tangent)
            means.push_back(&v);
      for (LA::Vector *v : means)
        {
          v->compress(VectorOperation::add);
          v->scale(inverse);
        }
      LA::scale_rows(contact.B, inverse);
      for (unsigned int a = 0; a < contact.tangential.B.size(); ++a)
        {
          LA::scale_rows(contact.tangential.B[a], inverse);
          contact.tangential.offset[a].scale(inverse);
        }
      for (LA::SparseMatrix &S : contact.S)
        LA::scale_rows(S, inverse);
    }
  } // namespace



  template <int dim>
  std::unique_ptr<GapOperator>
  make_gap_operator(const Configuration<dim>               &configuration,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const ContactRows                      &rows,
                    const ContactMethod                    &method)
  {
    const Elasticity<dim> &elasticity = configuration.elasticity();
    const MPI_Comm         comm       = elasticity.mesh().communicator();
    auto                   result     = std::make_unique<GapOperator>();
    GapOperator           &contact    = *result;
    // Rows, nodes and places of the rows.
    contact.dofs            = elasticity.owned();
    contact.origin.pair     = rows.pair;
    contact.origin.node     = rows.node;
    contact.origin.places   = rows.places;
    contact.origin.readable = rows.writable;
    contact.origin.regions  = ContactRegions(elasticity, surfaces, rows, method.sampling());
    // Sums over points, then means.
    std::optional<Tangents<dim>> along;
    if (method.uses_slip())
      along.emplace(rows, surfaces, comm);
    const Tangents<dim> *const tangents = along ? &*along : nullptr;
    assemble_matrices(contact, rows, surfaces, method, tangents, elasticity);
    assemble_vectors(contact,
                     rows,
                     surfaces,
                     method,
                     elasticity.mesh().size(),
                     !configuration.is_reference(),
                     comm);
    normalise(contact);
    LA::Vector free = elasticity.zero_vector();
    free            = 1.;
    elasticity.constraints().set_zero(free);
    if (tangents && method.sampling() == Sampling::nodes && !contact.empty())
      {
        remove_slip_across_symmetry_planes(elasticity, *tangents, contact);
        align_slip_with_supports(elasticity, *tangents, free, contact);
      }
    if (contact.has_stress())
      assemble_field_stress(elasticity, rows, surfaces, tangents, contact);
    // Points of pairs without separation are active whatever the sign of their pressure, those of
    // tied ones stick whatever their traction.
    auto pair = rows.pair.begin();
    for (const auto i : rows.owned)
      {
        const ContactSurface<dim> &surface   = surfaces[*pair++];
        const ContactStatus        least     = contact.weight(i) == 0 ? ContactStatus::open :
                                               surface.is_tied        ? ContactStatus::stick :
                                               surface.can_separate   ? ContactStatus::open :
                                                                        ContactStatus::slip;
        contact.coefficients.least_status(i) = static_cast<double>(least);
      }
    contact.coefficients.least_status.compress(VectorOperation::insert);
    if (method.sampling() == Sampling::nodes)
      move_to_nodes(contact, elasticity);
    // The offset makes the slip exact in the displaced configuration.
    for (unsigned int a = 0; a < contact.tangential.B.size() && !configuration.is_reference(); ++a)
      {
        LA::Vector linear = contact.zero();
        contact.tangential.B[a].vmult(linear, configuration.displacement());
        contact.tangential.offset[a] -= linear;
      }

    // B_free: columns of prescribed displacements removed, for forces and linear systems; condensed
    // columns of inclined supports are added below.
    // Copies share the sparsity pattern: columns of prescribed displacements are set to zero, not
    // removed.
    contact.B_free.copy_from(contact.B);
    LA::scale_columns(contact.B_free, free);
    const auto free_columns = [&](const std::vector<LA::SparseMatrix> &from,
                                  std::vector<LA::SparseMatrix>       &to) {
      for (const LA::SparseMatrix &matrix : from)
        {
          to.emplace_back().copy_from(matrix);
          LA::scale_columns(to.back(), free);
        }
    };
    free_columns(contact.tangential.B, contact.tangential.B_free);
    free_columns(contact.S, contact.S_free);
    // Overlaps count in full until the load step sets other shares.
    contact.set_interference(std::vector<double>(surfaces.size(), 1.));
    contact.has_condensed_constraints = elasticity.has_inclined_supports();
    if (contact.has_condensed_constraints)
      add_condensed_columns(elasticity, contact);
    return result;
  }



  template <int dim>
  std::unique_ptr<GapOperator>
  make_gap_operator(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const ContactMethod                    &method)
  {
    return make_gap_operator(Configuration<dim>(elasticity),
                             surfaces,
                             make_contact_rows(elasticity, surfaces, method.sampling()),
                             method);
  }



#define INSTANTIATE(dim)                                                                           \
  template std::unique_ptr<GapOperator> make_gap_operator(                                         \
    const Configuration<dim> &,                                                                    \
    const std::vector<ContactSurface<dim>> &,                                                      \
    const ContactRows &,                                                                           \
    const ContactMethod &);                                                                        \
  template std::unique_ptr<GapOperator> make_gap_operator(                                         \
    const Elasticity<dim> &, const std::vector<ContactSurface<dim>> &, const ContactMethod &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
