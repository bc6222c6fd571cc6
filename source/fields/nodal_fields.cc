// SPDX-License-Identifier: Apache-2.0
#include "fields/nodal_fields.h"

#include "geometry/face_functions.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return values of rows that are nodes, at the nodes of one pair; zero elsewhere. Collective.
    template <int dim>
    LA::Vector
    from_nodes(const Snapshot<dim> &snapshot, const LA::Vector &values, const unsigned int pair)
    {
      LA::Vector     field = snapshot.elasticity.zero_vector();
      const IndexSet rows  = values.locally_owned_elements();
      auto           row   = rows.begin();
      for (unsigned int k = 0; k < snapshot.contact.origin.node.size(); ++k, ++row)
        if (snapshot.contact.origin.pair[k] == pair)
          field(snapshot.contact.origin.node[k]) = values(*row);
      field.compress(VectorOperation::insert);
      return field;
    }



    // For each node the integrals of psi v, psi, and |psi| over the slave surface.
    template <int dim>
    struct Integrals
    {
      LA::Vector value, area, size;

      Integrals(const Elasticity<dim> &elasticity)
        : value(elasticity.zero_vector())
        , area(elasticity.zero_vector())
        , size(elasticity.zero_vector())
      {}

      /// Add a point with the value v.
      void
      add(const ContactPoint<dim> &point, const double v)
      {
        for (const auto &[node, psi] : point.multiplier_shape)
          {
            value(node) += psi * point.weight * v;
            area(node) += psi * point.weight;
            size(node) += std::abs(psi) * point.weight;
          }
      }

      /// Sum over ranks. Collective.
      void
      finish()
      {
        for (LA::Vector *v : {&value, &area, &size})
          v->compress(VectorOperation::add);
      }
    };



    /// @return at each node the mean of values at points, weighted with its shape function.
    /// Collective.
    template <int dim>
    LA::Vector
    from_points(const Snapshot<dim> &snapshot, const LA::Vector &values, const unsigned int pair)
    {
      Integrals<dim> integrals(snapshot.elasticity);
      auto           row = first_row(snapshot, pair);
      for (const ContactPoint<dim> &point : snapshot.surfaces[pair].points)
        integrals.add(point, values(row++));
      integrals.finish();

      LA::Vector field = snapshot.elasticity.zero_vector();
      for (const auto i : snapshot.elasticity.owned())
        // Shape functions of higher degree are partly negative: where few points have a projection,
        // the integral of psi may be nearly zero, and the mean would be meaningless.
        if (integrals.size(i) > 0 && integrals.area(i) > 1e-6 * integrals.size(i))
          field(i) = integrals.value(i) / integrals.area(i);
      field.compress(VectorOperation::insert);
      return field;
    }
  } // namespace



  namespace
  {
    /// Means of values that are added at nodes, on any rank.
    struct NodalMeans
    {
      LA::Vector sum, count;

      /// @param zero a zero vector of the displacement
      explicit NodalMeans(const LA::Vector &zero)
        : sum(zero)
        , count(zero)
      {}

      void
      add(const types::global_dof_index node, const double value)
      {
        sum(node) += value;
        count(node) += 1;
      }

      /// Sum over ranks. Collective.
      void
      finish()
      {
        for (LA::Vector *v : {&sum, &count})
          v->compress(VectorOperation::add);
      }

      /// Set the entries of a field that have values and that are wanted to their means.
      /// Collective.
      /// @param is_wanted a function of the index of an owned entry
      template <typename Choice>
      void
      set(LA::Vector &field, const Choice &is_wanted) const
      {
        for (const auto i : field.locally_owned_elements())
          if (count(i) > 0 && is_wanted(i))
            field(i) = sum(i) / count(i);
        field.compress(VectorOperation::insert);
      }
    };



    /// Set the values of nodes all of whose faces have no node with a pressure function, in corners
    /// of the surface, to the mean of those of the other nodes there. Collective.
    /// @param count,free at nodes: the number of values, and of faces with a pressure function
    template <int dim>
    void
    fill_corners(const Snapshot<dim> &s,
                 const unsigned int   pair,
                 const LA::Vector    &count,
                 const LA::Vector    &free,
                 LA::Vector          &field)
    {
      // Most surfaces have no such corner.
      const auto &faces     = s.surfaces[pair].slave_faces;
      const bool  is_corner = std::any_of(faces.begin(), faces.end(), [](const auto &face) {
        return !face.nodes.empty() && std::all_of(face.without_pressure.begin(),
                                                  face.without_pressure.end(),
                                                  [](const bool without) { return without; });
      });
      if (Utilities::MPI::max(is_corner ? 1 : 0, s.elasticity.mesh().communicator()) == 0)
        return;
      LA::Vector known = count;
      known += free;
      const LA::Vector is_known = s.elasticity.with_ghosts(known),
                       now      = s.elasticity.with_ghosts(field);
      NodalMeans means(s.elasticity.zero_vector());
      for (const SlaveFace<dim> &face : faces)
        for (const auto i : face.nodes)
          for (const auto other : face.nodes)
            if (is_known(i) == 0 && is_known(other) > 0)
              means.add(i, now(other));
      means.finish();
      means.set(field, [](const auto) { return true; });
    }
  } // namespace



  // Distances are counted in steps of the lattice of nodes, up to rounding.
  template <int dim>
  std::vector<unsigned int>
  nearest_free(const SlaveFace<dim> &face, const unsigned int dirichlet_node)
  {
    const auto shape   = face.reference_cell();
    const auto lattice = face_lattice<dim>(shape, face.degree);
    const auto place   = [&](const unsigned int i) {
      return isotropic_coordinates(shape, lattice[i]);
    };
    double                    least = std::numeric_limits<double>::max();
    std::vector<unsigned int> result;
    for (unsigned int i = 0; i < face.nodes.size(); ++i)
      if (!face.without_pressure[i])
        {
          const double distance = place(i).distance_square(place(dirichlet_node));
          if (distance < least - 1e-10)
            result.clear();
          if (distance < least + 1e-10)
            result.push_back(i);
          least = std::min(least, distance);
        }
    return result;
  }



  // Nodes that carry a pressure on another face (count `free`) are not changed.
  template <int dim>
  void
  fill_dirichlet_nodes(const Snapshot<dim>            &s,
                       const unsigned int              pair,
                       const PrescribedNodeValue<dim> &value,
                       LA::Vector                     &field)
  {
    if (!s.surfaces[pair].has_dirichlet_nodes)
      return;
    NodalMeans means(s.elasticity.zero_vector());
    LA::Vector free = means.count;
    for (const SlaveFace<dim> &face : s.surfaces[pair].slave_faces)
      for (unsigned int i = 0; i < face.nodes.size(); ++i)
        if (face.without_pressure[i])
          for (const unsigned int near : nearest_free(face, i))
            means.add(face.nodes[i], value(face, i, near));
        else
          free(face.nodes[i]) += 1;
    means.finish();
    free.compress(VectorOperation::add);
    means.set(field, [&](const auto i) { return free(i) == 0; });
    fill_corners(s, pair, means.count, free, field);
  }



  template <int dim>
  types::global_dof_index
  first_row(const Snapshot<dim> &snapshot, const unsigned int pair)
  {
    types::global_dof_index first = snapshot.pressure.local_range().first;
    for (unsigned int p = 0; p < pair; ++p)
      first += snapshot.surfaces[p].points.size();
    return first;
  }



  bool
  samples_nodes(const GapOperator &contact)
  {
    return Utilities::MPI::max(contact.origin.node.empty() ? 0u : 1u,
                               contact.weight.get_mpi_communicator()) == 1;
  }



  template <int dim>
  void
  fill_between(const Snapshot<dim> &s, const unsigned int pair, LA::Vector &field)
  {
    if (dim == 2 || !s.elasticity.mesh().has_simplices() || s.elasticity.degree() < 2)
      return;
    const LA::Vector now = s.elasticity.with_ghosts(field);
    NodalMeans       means(s.elasticity.zero_vector());
    for (const SlaveFace<dim> &face : s.surfaces[pair].slave_faces)
      for (const NodeBetween &between : face.between)
        {
          const auto &[a, b] = between.ends;
          means.add(between.node, (now(face.nodes[a]) + now(face.nodes[b])) / 2);
        }
    means.finish();
    means.set(field, [](const auto) { return true; });
  }



  // Dirichlet nodes and hanging nodes are filled after the values of all ranks are known.
  template <int dim>
  LA::Vector
  nodal_field(const Snapshot<dim> &snapshot, const LA::Vector &values, const unsigned int pair)
  {
    LA::Vector field = samples_nodes(snapshot.contact) ? from_nodes(snapshot, values, pair) :
                                                         from_points(snapshot, values, pair);
    if (snapshot.surfaces[pair].has_dirichlet_nodes)
      {
        const LA::Vector now = snapshot.elasticity.with_ghosts(field);
        fill_dirichlet_nodes<dim>(
          snapshot,
          pair,
          [&](const SlaveFace<dim> &face, unsigned int, const unsigned int near) {
            return now(face.nodes[near]);
          },
          field);
      }
    fill_between(snapshot, pair, field);
    snapshot.elasticity.hanging_nodes().distribute(field);
    return field;
  }



  template <int dim>
  double
  value_at(const ContactSurface<dim> &surface,
           const ContactPoint<dim>   &point,
           const LA::Vector          &field)
  {
    const SlaveFace<dim>    &face = surface.slave_faces[point.face];
    const FaceFunctions<dim> shape(face.reference_cell(), face.degree, point.xi);
    double                   value = 0;
    for (unsigned int i = 0; i < shape.size(); ++i)
      value += shape.value(i) * field(face.nodes[i]);
    return value;
  }



  template <int dim>
  LA::Vector
  nodal_coverage(const Snapshot<dim> &snapshot, const unsigned int pair)
  {
    LA::Vector ones = snapshot.contact.zero();
    ones            = 1.;
    return nodal_field(snapshot, ones, pair);
  }



  template double
  value_at(const ContactSurface<2> &, const ContactPoint<2> &, const LA::Vector &);
  template double
  value_at(const ContactSurface<3> &, const ContactPoint<3> &, const LA::Vector &);
  template std::vector<unsigned int>
  nearest_free(const SlaveFace<2> &, unsigned int);
  template std::vector<unsigned int>
  nearest_free(const SlaveFace<3> &, unsigned int);
  template void
  fill_dirichlet_nodes(const Snapshot<2> &,
                       unsigned int,
                       const PrescribedNodeValue<2> &,
                       LA::Vector &);
  template void
  fill_dirichlet_nodes(const Snapshot<3> &,
                       unsigned int,
                       const PrescribedNodeValue<3> &,
                       LA::Vector &);
  template void
  fill_between(const Snapshot<2> &, unsigned int, LA::Vector &);
  template void
  fill_between(const Snapshot<3> &, unsigned int, LA::Vector &);
  template types::global_dof_index
  first_row(const Snapshot<2> &, unsigned int);
  template LA::Vector
  nodal_field(const Snapshot<2> &, const LA::Vector &, unsigned int);
  template types::global_dof_index
  first_row(const Snapshot<3> &, unsigned int);
  template LA::Vector
  nodal_field(const Snapshot<3> &, const LA::Vector &, unsigned int);
  template LA::Vector
  nodal_coverage(const Snapshot<2> &, unsigned int);
  template LA::Vector
  nodal_coverage(const Snapshot<3> &, unsigned int);
} // namespace Signorini
