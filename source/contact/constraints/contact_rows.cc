// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/contact_rows.h"

#include "contact/search/bytes.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Identity of a slave face that survives a new partition or refinement of other cells.
    template <int dim>
    FaceId
    face_id(const unsigned int pair, const SlaveFace<dim> &face)
    {
      return {pair, face.cell, face.face};
    }

    /// The position of a parameter; the second coordinate is 0 in 2D.
    template <int dim>
    SurfacePoint
    place_at(const Point<dim - 1> &xi)
    {
      return {{xi[0], dim == 3 ? xi[dim - 2] : 0.}};
    }

    /// Rows of the segment edge points if there is one row for each integration point: each edge
    /// point has the pressure of the closest integration point of its face, with its whole weight.
    /// Cost: edge points times points of a face.
    template <int dim>
    std::vector<std::vector<Share>>
    shares_of_closest(const ContactSurface<dim> &surface, const types::global_dof_index first_row)
    {
      std::vector<std::vector<Share>> result(surface.edge_points.size());
      std::vector<double> closest(surface.edge_points.size(), std::numeric_limits<double>::max());
      std::map<unsigned int, std::vector<std::size_t>> edge_points_of_face;
      for (std::size_t i = 0; i < surface.edge_points.size(); ++i)
        edge_points_of_face[surface.edge_points[i].face].push_back(i);
      for (std::size_t q = 0; q < surface.points.size(); ++q)
        if (const auto edge_points = edge_points_of_face.find(surface.points[q].face);
            edge_points != edge_points_of_face.end())
          for (const std::size_t i : edge_points->second)
            if (const double distance = surface.edge_points[i].xi.distance(surface.points[q].xi);
                distance < closest[i])
              {
                closest[i] = distance;
                result[i]  = {
                   {types::global_dof_index(first_row + q), surface.edge_points[i].weight}};
              }
      return result;
    }

    /// Rows of pointwise methods, one for each integration point, numbered contiguously over the
    /// ranks in the order of pairs and points. Rows are written by their owner only. Collective.
    template <int dim>
    ContactRows
    quadrature_rows(const std::vector<ContactSurface<dim>> &surfaces, const MPI_Comm comm)
    {
      ContactRows rows;
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        rows.pair.insert(rows.pair.end(), surfaces[p].points.size(), p);
      rows.owned    = LA::contiguous_partition(rows.pair.size(), comm);
      rows.writable = rows.owned;
      auto row      = rows.owned.begin();
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        {
          rows.shares.emplace_back();
          if (!surfaces[p].points.empty())
            rows.edge_point_shares.push_back(shares_of_closest(surfaces[p], *row));
          else
            rows.edge_point_shares.emplace_back(surfaces[p].edge_points.size());
          const unsigned int none = numbers::invalid_unsigned_int;
          unsigned int       face = none;
          for (const auto &point : surfaces[p].points)
            {
              // The only share of the row's area is that of its point.
              rows.shares.back().push_back({{*row, point.weight}});
              if (point.face != face)
                rows.places.push_back({face_id(p, surfaces[p].slave_faces[point.face]), {}});
              face = point.face;
              rows.places.back().places.push_back({place_at<dim>(point.xi), {{*row, 1.}}, true});
              ++row;
            }
        }
      return rows;
    }

    using Index = types::global_dof_index;

    /// The areas around a slave node of a pair on one rank, and their sums on the rank that owns
    /// the node [length^(dim-1)].
    struct NodeOfPair
    {
      unsigned int pair;
      Index        node;
      double       paired, all; ///< area with a projection, and of all faces around it

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        serialize_bytes(ar, *this);
      }
    };

    /// The number of the row of a node, as it is returned to the ranks that have faces around the
    /// node.
    struct RowOfNode
    {
      unsigned int pair;
      Index        node, row;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        serialize_bytes(ar, *this);
      }
    };

    using Key = std::pair<unsigned int, Index>; ///< pair, first degree of freedom of the node

    template <typename T>
    using ByRank = std::map<unsigned int, std::vector<T>>;

    /// The areas around the nodes of slave faces on this rank, sorted by the ranks that own the
    /// nodes. Collective (it gathers the ranges of the ranks).
    template <int dim>
    ByRank<NodeOfPair>
    node_areas(const Elasticity<dim> &elasticity, const std::vector<ContactSurface<dim>> &surfaces)
    {
      std::map<Key, std::array<double, 2>> areas;
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        {
          for (const auto &point : surfaces[p].points)
            // The functions sum up to one, so that the areas of all nodes sum up to the area with a
            // projection. Dual functions are negative in places, hence absolute values below.
            for (const auto &[node, value] : point.multiplier_shape)
              areas[{p, node}][0] += value * point.weight;
          if (!surfaces[p].is_apart)
            for (const auto &[shape, weight] : surfaces[p].full_face_shapes)
              for (const auto &[node, value] : shape)
                areas[{p, node}][1] += std::abs(value) * weight;
        }
      // Each rank owns one range of indices, in the order of the ranks.
      const IndexSet    &owned = elasticity.dof_handler().locally_owned_dofs();
      std::vector<Index> ends =
        Utilities::MPI::all_gather(elasticity.mesh().communicator(), Index(owned.n_elements()));
      std::partial_sum(ends.begin(), ends.end(), ends.begin());
      ByRank<NodeOfPair> result;
      for (const auto &[key, area] : areas)
        {
          const unsigned int owner =
            std::upper_bound(ends.begin(), ends.end(), key.second) - ends.begin();
          result[owner].push_back({key.first, key.second, area[0], area[1]});
        }
      return result;
    }

    /// Give the places of nodes whose normal displacement is prescribed the rows of the nearest
    /// other places, in equal parts, as PressureBasis does with their functions.
    template <int dim>
    void
    complete_places(const SlaveFace<dim> &face, std::vector<SurfacePlace> &places)
    {
      const std::vector<SurfacePlace> known  = places;
      const auto                      square = [&](const SurfacePoint &a, const SurfacePoint &b) {
        const auto at = [&](const SurfacePoint &x) {
          return isotropic_coordinates(face.reference_cell(), Point<2>(x[0], x[1]));
        };
        return at(a).distance_square(at(b));
      };
      for (unsigned int k = 0; k < places.size(); ++k)
        {
          if (!places[k].rows.empty() || !face.without_pressure[k] || face.under_covered[k])
            continue;
          double smallest = std::numeric_limits<double>::max();
          for (const SurfacePlace &other : known)
            if (!other.rows.empty())
              smallest = std::min(smallest, square(other.point, places[k].point));
          unsigned int n = 0;
          for (const SurfacePlace &other : known)
            if (!other.rows.empty() && square(other.point, places[k].point) < smallest + 1e-10)
              {
                ++n;
                places[k].rows.insert(places[k].rows.end(), other.rows.begin(), other.rows.end());
              }
          for (auto &entry : places[k].rows)
            entry.second /= n;
        }
    }

    /// The nodes of slave faces as surface points.
    template <int dim>
    std::vector<SurfacePoints>
    node_surface_points(const Elasticity<dim>                  &elasticity,
                        const std::vector<ContactSurface<dim>> &surfaces,
                        const std::map<Key, Index>             &row_of)
    {
      std::vector<SurfacePoints> result;
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        for (const SlaveFace<dim> &face : surfaces[p].slave_faces)
          {
            if (face.degree == 0)
              continue;
            result.push_back({face_id(p, face), {}});
            std::vector<SurfacePlace> &places = result.back().places;
            const auto lattice = face_lattice<dim>(face.reference_cell(), face.degree);
            for (unsigned int k = 0; k < face.nodes.size(); ++k)
              {
                // A hanging node has the value that its masters give it. Where one of them has no
                // row, since its normal displacement is prescribed or the master does not cover
                // it, the others take its weight.
                SparseRow nodes = {{face.nodes[k], 1.}}, rows;
                condense_hanging_nodes(elasticity.hanging_nodes(), nodes);
                const bool hangs = nodes.front().first != face.nodes[k] || nodes.size() > 1;
                double     found = 0;
                for (const auto &[node, weight] : nodes)
                  if (const auto row = row_of.find({p, node}); row != row_of.end())
                    {
                      rows.emplace_back(row->second, weight);
                      found += weight;
                    }
                for (auto &entry : rows)
                  entry.second += (1 - found) / rows.size();
                places.push_back({place_at<dim>(lattice[k]), rows, !hangs && rows.size() == 1});
              }
            complete_places(face, places);
          }
      return result;
    }

    /// Rows of methods that sample at nodes, one for each node of a pair with enough area. Areas
    /// are summed on the rank that owns the node, which numbers the row; numbers return to all
    /// ranks with faces around the node. Two exchanges between neighbours. The number of a row
    /// depends on the partition, the set of rows does not. Collective.
    template <int dim>
    ContactRows
    node_rows(const Elasticity<dim> &elasticity, const std::vector<ContactSurface<dim>> &surfaces)
    {
      const MPI_Comm comm = elasticity.mesh().communicator();
      const auto received = Utilities::MPI::some_to_some(comm, node_areas(elasticity, surfaces));
      std::map<Key, std::array<double, 2>> areas;
      for (const auto &[rank, nodes] : received)
        for (const NodeOfPair &one : nodes)
          {
            auto &area = areas[{one.pair, one.node}];
            area[0] += one.paired;
            area[1] += one.all;
          }

      ContactRows          rows;
      std::map<Key, Index> numbers; // on this rank
      for (const auto &[key, area] : areas)
        // An area of 1e-10 of that around the node is rounding: the mean gap over it would be
        // meaningless.
        if (area[1] > 0 && area[0] > 1e-10 * area[1])
          {
            numbers[key] = rows.node.size();
            rows.node.push_back(key.second);
            rows.pair.push_back(key.first);
          }
      rows.owned    = LA::contiguous_partition(rows.node.size(), comm);
      rows.writable = rows.owned;

      // Return the row numbers to the ranks that sent areas.
      ByRank<RowOfNode> answers;
      for (const auto &[rank, nodes] : received)
        for (const NodeOfPair &one : nodes)
          if (const auto row = numbers.find({one.pair, one.node}); row != numbers.end())
            answers[rank].push_back({one.pair, one.node, row->second + *rows.owned.begin()});
      std::map<Key, Index> row_of;
      std::set<Index>      foreign;
      for (const auto &[rank, list] : Utilities::MPI::some_to_some(comm, answers))
        for (const RowOfNode &one : list)
          {
            row_of[{one.pair, one.node}] = one.row;
            if (!rows.owned.is_element(one.row))
              foreign.insert(one.row);
          }
      rows.writable.add_indices(foreign.begin(), foreign.end());

      // Row r has the share psi_r(q) w_q of the area of point q (doc/theory, (3.3)); shares may be
      // negative with dual functions.
      const auto shares_of = [&](const unsigned int pair, const auto &points) {
        std::vector<std::vector<Share>> shares;
        for (const auto &point : points)
          {
            shares.emplace_back();
            for (const auto &[node, value] : point.multiplier_shape)
              if (const auto row = row_of.find({pair, node}); row != row_of.end())
                shares.back().push_back({row->second, value * point.weight});
          }
        return shares;
      };
      for (unsigned int p = 0; p < surfaces.size(); ++p)
        {
          rows.shares.push_back(shares_of(p, surfaces[p].points));
          rows.edge_point_shares.push_back(shares_of(p, surfaces[p].edge_points));
        }
      rows.places = node_surface_points(elasticity, surfaces, row_of);
      return rows;
    }
  } // namespace



  template <int dim>
  ContactRows
  make_contact_rows(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    const Sampling                          sampling)
  {
    return sampling == Sampling::nodes ?
             node_rows(elasticity, surfaces) :
             quadrature_rows(surfaces, elasticity.mesh().communicator());
  }



  template ContactRows
  make_contact_rows(const Elasticity<2> &, const std::vector<ContactSurface<2>> &, Sampling);
  template ContactRows
  make_contact_rows(const Elasticity<3> &, const std::vector<ContactSurface<3>> &, Sampling);
} // namespace Signorini
