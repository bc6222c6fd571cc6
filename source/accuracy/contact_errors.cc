// SPDX-License-Identifier: Apache-2.0
#include "accuracy/error_parts.h"
#include "accuracy/traction_errors.h"
#include "contact/constraints/gap_increments.h"
#include "fields/friction_fields.h"
#include "fields/nodal_fields.h"
#include "fields/point_values.h"
#include "fields/recovered_pressure.h"
#include "linear_algebra/row_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return whether a row of the gap operator has entries in free degrees of freedom.
    bool
    can_move(const LA::SparseMatrix &B_free, const int row)
    {
      const LA::RowView view(B_free, row);
      return std::any_of(view.values, view.values + view.size, [](const double value) {
        return std::abs(value) > 1e-12;
      });
    }

    /// @return for each pair the mean pressure over its active points; 0 where there are none.
    /// Collective.
    template <int dim>
    std::vector<double>
    mean_pressures(const Snapshot<dim> &s)
    {
      std::vector<double> sums(2 * s.pairs.size(), 0.);
      auto                pair = s.contact.origin.pair.begin();
      for (const auto i : s.pressure.locally_owned_elements())
        {
          if (s.pressure(i) > 0)
            {
              sums[2 * *pair] += s.contact.weight(i) * s.pressure(i);
              sums[2 * *pair + 1] += s.contact.weight(i);
            }
          ++pair;
        }
      Utilities::MPI::sum(sums, s.elasticity.mesh().communicator(), sums);
      std::vector<double> result;
      for (unsigned int i = 0; i < s.pairs.size(); ++i)
        result.push_back(sums[2 * i + 1] > 0 ? sums[2 * i] / sums[2 * i + 1] : 0.);
      return result;
    }
  } // namespace



  // The size of contact points without free degrees of freedom, doc/theory, end of 8.4.
  template <int dim>
  double
  undetermined_contact(const Snapshot<dim> &s, const Functional &functional, const LA::Vector &z)
  {
    if (s.contact.empty() || !samples_nodes(s.contact))
      return 0;
    const double              closed = 1e-12 * s.elasticity.mesh().size();
    const std::vector<double> mean   = mean_pressures(s);
    PointVectors              felt(s.contact.n_components(), s.contact.zero());
    for (unsigned int a = 0; a < felt.size(); ++a)
      s.contact.rows(a).vmult(felt[a], z);
    double sum  = 0;
    int    row  = 0;
    auto   pair = s.contact.origin.pair.begin();
    // What a unit of a component of the traction at a point changes. A reaction is written with a
    // lift: its derivative by tractions is contained in that.
    const auto change = [&](const auto i, const unsigned int a) {
      const double direct = functional.lift.size() > 0 ? 0. : functional.of_traction[a](i);
      return std::abs(s.contact.weight(i) * felt[a](i) + direct);
    };
    for (const auto i : s.gap.locally_owned_elements())
      {
        const double pressure = std::max(mean[*pair], s.pressure(i));
        if (s.gap(i) <= closed && !can_move(s.contact.B_free, row))
          sum += change(i, 0) * pressure;
        // Points that are held along the surface alone, as on a plane of symmetry, stick, and may
        // have any tangential traction up to the bound.
        if (s.pressure(i) > 0)
          for (unsigned int a = 1; a < felt.size(); ++a)
            if (!can_move(s.contact.free_rows(a), row))
              sum += change(i, a) * (s.contact.coefficients.friction_bound(i, pressure).value +
                                     std::abs(s.contact_state.traction[a](i)));
        ++row;
        ++pair;
      }
    return Utilities::MPI::sum(sum, s.elasticity.mesh().communicator());
  }



  namespace
  {
    /// @return a field that is positive at nodes without pressure function and at the nodes that
    /// take their functions over, zero elsewhere; with ghost values.
    template <int dim>
    LA::Vector
    about_dirichlet_nodes(const Snapshot<dim> &s, const unsigned int pair)
    {
      LA::Vector result = s.elasticity.zero_vector();
      for (const SlaveFace<dim> &face : s.surfaces[pair].slave_faces)
        for (unsigned int i = 0; i < face.nodes.size(); ++i)
          if (face.without_pressure[i])
            for (const unsigned int near : nearest_free(face, i))
              {
                result(face.nodes[i]) += 1;
                result(face.nodes[near]) += 1;
              }
      result.compress(VectorOperation::add);
      return s.elasticity.with_ghosts(result);
    }

    /// Add (8.8) of one pair, over the points of all faces near nodes without multiplier: there the
    /// whole recovered traction is missing.
    template <int dim>
    void
    add_dirichlet_contact(const Snapshot<dim> &s,
                          const Functional    &functional,
                          const LA::Vector    &z,
                          const unsigned int   pair,
                          std::vector<double> &of_cells)
    {
      const ContactSurface<dim> &surface = s.surfaces[pair];
      const LA::Vector           near    = about_dirichlet_nodes(s, pair),
                       pressure          = s.elasticity.with_ghosts(recovered_pressure(s, pair));
      const std::vector<LA::Vector> tangential = recovered_traction(s, pair);
      TractionErrors<dim>           missing;
      for (unsigned int q = 0; q < surface.points.size(); ++q)
        {
          const ContactPoint<dim> &point = surface.points[q];
          const auto              &nodes = surface.slave_faces[point.face].nodes;
          if (std::any_of(nodes.begin(), nodes.end(), [&](const auto n) { return near(n) > 0; }))
            {
              missing.points.push_back(q);
              missing.pressure.push_back(value_at(surface, point, pressure));
              missing.tangential.push_back(vector_at(surface, point, tangential));
            }
        }
      add_traction_errors(s, functional, z, pair, missing, of_cells);
    }

    /// Add (8.21) of one pair: over all points, with the difference of the recovered traction and
    /// that at the point, whose rows are the points themselves.
    template <int dim>
    void
    add_pointwise_contact(const Snapshot<dim> &s,
                          const Functional    &functional,
                          const LA::Vector    &z,
                          const unsigned int   pair,
                          std::vector<double> &of_cells)
    {
      const ContactSurface<dim> &surface  = s.surfaces[pair];
      const LA::Vector           pressure = s.elasticity.with_ghosts(recovered_pressure(s, pair));
      const std::vector<double>  computed = point_values(s, pair).pressure;
      const std::vector<LA::Vector> tangential = recovered_traction(s, pair);
      std::vector<LA::Vector>       at_rows;
      if (!tangential.empty())
        at_rows =
          in_space(s, {s.contact_state.traction.begin() + 1, s.contact_state.traction.end()});
      TractionErrors<dim> errors;
      auto                row = first_row(s, pair);
      for (unsigned int q = 0; q < surface.points.size(); ++q, ++row)
        {
          const ContactPoint<dim> &point = surface.points[q];
          errors.points.push_back(q);
          errors.pressure.push_back(value_at(surface, point, pressure) - computed[q]);
          errors.tangential.push_back(vector_at(surface, point, tangential));
          for (unsigned int d = 0; d < at_rows.size(); ++d)
            errors.tangential.back()[d] -= at_rows[d](row) / point.stretch;
        }
      add_traction_errors(s, functional, z, pair, errors, of_cells);
    }

    /// @return whether a face has both nodes in contact and others.
    template <int dim>
    bool
    is_crossed_by_edge(const SlaveFace<dim> &face, const LA::Vector &status)
    {
      const auto n = std::count_if(face.nodes.begin(), face.nodes.end(), [&](const auto node) {
        return status(node) > 0.5;
      });
      return n > 0 && n < static_cast<int>(face.nodes.size());
    }

    /// Add (8.9) of one pair for each face that the edge of the contact zone crosses.
    template <int dim>
    void
    add_unresolved_contact_error(const Snapshot<dim> &s,
                                 const Functional    &functional,
                                 const LA::Vector    &z,
                                 const unsigned int   pair,
                                 std::vector<double> &of_cells)
    {
      // Half of the standard deviation of a position that is uniformly distributed over a face of
      // unit size.
      const double share = 0.5 / std::sqrt(12.);

      const ContactSurface<dim> &surface = s.surfaces[pair];
      const LA::Vector           status  = s.elasticity.with_ghosts(nodal_field(s, s.active, pair));
      const std::vector<double>  all_pressures = point_values(s, pair).pressure;
      std::vector<const ContactPoint<dim> *> points; // of crossed faces
      std::vector<double>                    pressure;
      for (unsigned int q = 0; q < surface.points.size(); ++q)
        if (is_crossed_by_edge(surface.slave_faces[surface.points[q].face], status))
          {
            points.push_back(&surface.points[q]);
            pressure.push_back(all_pressures[q]);
          }
      const std::vector<double> opened  = gap_increments(points, z);
      const LA::Vector          density = by_pressure(s, functional, pair);
      // The points of one face are consecutive: accumulate the force and the range of omega on each
      // face.
      for (unsigned int first = 0, last = 0; first < points.size(); first = last)
        {
          double force = 0, low = std::numeric_limits<double>::max(), high = -low;
          for (; last < points.size() && points[last]->face == points[first]->face; ++last)
            {
              const double felt = opened[last] + value_at(surface, *points[last], density);
              force += points[last]->weight * points[last]->stretch * std::abs(pressure[last]);
              low  = std::min(low, felt);
              high = std::max(high, felt);
            }
          const auto cell = s.elasticity.mesh().triangulation().create_cell_iterator(
            surface.slave_faces[points[first]->face].cell);
          of_cells[cell->active_cell_index()] += share * force * (high - low);
        }
    }
  } // namespace



  template <int dim>
  std::vector<double>
  unresolved_contact(const Snapshot<dim> &s, const Functional &functional, const LA::Vector &z)
  {
    std::vector<double> result(s.elasticity.mesh().triangulation().n_active_cells(), 0.);
    if (!s.contact.empty())
      for (unsigned int pair = 0; pair < s.pairs.size(); ++pair)
        add_unresolved_contact_error(s, functional, z, pair, result);
    return result;
  }



  template <int dim>
  std::vector<double>
  pointwise_contact_errors(const Snapshot<dim> &s,
                           const Functional    &functional,
                           const LA::Vector    &z)
  {
    std::vector<double> result(s.elasticity.mesh().triangulation().n_active_cells(), 0.);
    if (s.contact.has_stress())
      for (unsigned int pair = 0; pair < s.pairs.size(); ++pair)
        add_pointwise_contact(s, functional, z, pair, result);
    return result;
  }



  template <int dim>
  std::vector<double>
  dirichlet_contact_errors(const Snapshot<dim> &s,
                           const Functional    &functional,
                           const LA::Vector    &z)
  {
    std::vector<double> result(s.elasticity.mesh().triangulation().n_active_cells(), 0.);
    if (!s.contact.empty() && samples_nodes(s.contact))
      for (unsigned int pair = 0; pair < s.pairs.size(); ++pair)
        if (s.surfaces[pair].has_dirichlet_nodes && s.pairs[pair].compliance.is_rigid())
          add_dirichlet_contact(s, functional, z, pair, result);
    return result;
  }



  template std::vector<double>
  unresolved_contact(const Snapshot<2> &, const Functional &, const LA::Vector &);
  template std::vector<double>
  unresolved_contact(const Snapshot<3> &, const Functional &, const LA::Vector &);
  template std::vector<double>
  pointwise_contact_errors(const Snapshot<2> &, const Functional &, const LA::Vector &);
  template std::vector<double>
  pointwise_contact_errors(const Snapshot<3> &, const Functional &, const LA::Vector &);
  template std::vector<double>
  dirichlet_contact_errors(const Snapshot<2> &, const Functional &, const LA::Vector &);
  template std::vector<double>
  dirichlet_contact_errors(const Snapshot<3> &, const Functional &, const LA::Vector &);
  template double
  undetermined_contact(const Snapshot<2> &, const Functional &, const LA::Vector &);
  template double
  undetermined_contact(const Snapshot<3> &, const Functional &, const LA::Vector &);
} // namespace Signorini
