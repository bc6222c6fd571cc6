// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/regions.h"

#include "contact/search/bytes.h"
#include "geometry/connected.h"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Index = types::global_dof_index;

    /// The sum over a region, as it is sent to the rank that adds it up.
    struct Sum
    {
      Index  region;
      double value;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        serialize_bytes(ar, *this);
      }
    };

    /// Sort a list of numbers and keep each of them once.
    void
    sort_and_remove_duplicates(std::vector<unsigned int> &numbers)
    {
      std::sort(numbers.begin(), numbers.end());
      numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    }
  } // namespace



  template <int dim>
  ContactRegions::ContactRegions(const Elasticity<dim>                  &elasticity,
                                 const std::vector<ContactSurface<dim>> &surfaces,
                                 const ContactRows                      &rows,
                                 const Sampling                          sampling)
    : at_nodes(sampling == Sampling::nodes)
  {
    // Regions are sets of nodes. With rows at nodes these are the rows themselves; with rows at
    // quadrature points, rows of nodes are made in addition.
    const ContactRows nodes =
      at_nodes ? rows : make_contact_rows(elasticity, surfaces, Sampling::nodes);
    if (nodes.owned.size() == 0)
      return;
    IndexSet others = nodes.writable;
    others.subtract_set(nodes.owned);
    layout = std::make_shared<Utilities::MPI::Partitioner>(nodes.owned,
                                                           others,
                                                           elasticity.mesh().communicator());
    // The nodes of each face, as local numbers, from the shares of its points.
    for (unsigned int p = 0; p < surfaces.size(); ++p)
      {
        const std::size_t first = faces.size();
        faces.resize(first + surfaces[p].slave_faces.size());
        for (unsigned int q = 0; q < surfaces[p].points.size(); ++q)
          {
            Numbers &face = faces[first + surfaces[p].points[q].face];
            for (const Share &maximise_over_ranks : nodes.shares[p][q])
              face.push_back(layout->global_to_local(maximise_over_ranks.row));
          }
        for (std::size_t f = first; f < faces.size(); ++f)
          sort_and_remove_duplicates(faces[f]);
        if (!at_nodes)
          for (const ContactPoint<dim> &point : surfaces[p].points)
            points.push_back(faces[first + point.face]);
      }
    if (at_nodes)
      for (unsigned int i = 0; i < layout->locally_owned_size(); ++i)
        points.push_back({i});
  }



  /// Connected components across ranks, by propagation of the largest number. Each node of an
  /// active point starts with its own global number plus one (zero: not active). On a rank, nodes
  /// of one face are connected (union-find); then in turn all nodes of a local component take its
  /// largest number, and each node the largest number of all ranks that have it. Numbers only grow
  /// and are bounded, so that the loop ends, after about as many rounds as the chain of ranks along
  /// a region is long. Collective.
  /// @return number of the region of each local node, owned and ghosted; 0 outside
  std::vector<ContactRegions::Index>
  ContactRegions::regions(const LA::Vector &in) const
  {
    const unsigned int n = layout->locally_owned_size() + layout->n_ghost_indices();
    std::vector<Index> number(n, 0);
    auto               point = points.begin();
    for (const auto i : in.locally_owned_elements())
      {
        if (in(i) > 0)
          for (const unsigned int node : *point)
            number[node] = layout->local_to_global(node) + 1;
        ++point;
      }

    maximise_over_ranks(number);

    // Two active nodes of a face are connected on each rank that has the face.
    Connected sets(n);
    for (const Numbers &face : faces)
      {
        const auto inside = [&](const unsigned int node) { return number[node] > 0; };
        const auto first  = std::find_if(face.begin(), face.end(), inside);
        for (auto node = first; node != face.end(); ++node)
          if (inside(*node))
            sets.connect(*first, *node);
      }

    // Repeat until no number on any rank has changed.
    while (true)
      {
        std::vector<Index> largest(n, 0);
        for (unsigned int i = 0; i < n; ++i)
          largest[sets.first_of(i)] = std::max(largest[sets.first_of(i)], number[i]);
        bool has_changed = false;
        for (unsigned int i = 0; i < n; ++i)
          if (number[i] > 0 && largest[sets.first_of(i)] > number[i])
            {
              number[i]   = largest[sets.first_of(i)];
              has_changed = true;
            }
        if (Utilities::MPI::max<unsigned int>(has_changed, layout->get_mpi_communicator()) == 0)
          return number;
        maximise_over_ranks(number);
      }
  }



  // Exchange by a ghosted vector: its owner takes the maximum of all ranks and returns it. Numbers
  // are exact as doubles.
  void
  ContactRegions::maximise_over_ranks(std::vector<Index> &number) const
  {
    LinearAlgebra::distributed::Vector<double> field(layout);
    for (unsigned int i = 0; i < number.size(); ++i)
      field.local_element(i) = number[i];
    field.compress(VectorOperation::max);
    field.update_ghost_values();
    const auto &values = field;
    for (unsigned int i = 0; i < number.size(); ++i)
      number[i] = values.local_element(i);
  }



  // Sums of values over the points of each region, given to all of its points; zero at points that
  // are not in. Collective.
  LA::Vector
  ContactRegions::sums(const LA::Vector &in, const LA::Vector &values) const
  {
    const std::vector<Index> number = regions(in);
    const auto               at     = [&](const Numbers &point) {
      return point.empty() ? Index(0) : number[point.front()];
    };
    std::map<Index, double> sum_of;
    auto                    point = points.begin();
    for (const auto i : in.locally_owned_elements())
      {
        // A point of a face none of whose nodes has a row belongs to no region.
        if (in(i) > 0 && at(*point) > 0)
          sum_of[at(*point)] += values(i);
        ++point;
      }
    add_other_ranks(sum_of);

    LA::Vector result;
    result.reinit(in);
    point = points.begin();
    for (const auto i : in.locally_owned_elements())
      {
        if (const auto sum = sum_of.find(at(*point)); in(i) > 0 && sum != sum_of.end())
          result(i) = sum->second;
        ++point;
      }
    result.compress(VectorOperation::insert);
    return result;
  }



  LA::Vector
  ContactRegions::with_neighbours(const LA::Vector &in) const
  {
    LA::Vector result;
    result.reinit(in);
    if (empty())
      return result;
    std::vector<Index> inside(layout->locally_owned_size() + layout->n_ghost_indices(), 0);
    auto               point = points.begin();
    for (const auto i : in.locally_owned_elements())
      {
        if (in(i) > 0)
          for (const unsigned int node : *point)
            inside[node] = 1;
        ++point;
      }
    maximise_over_ranks(inside);
    std::vector<Index> grown = inside;
    // Faces of integration points share the nodes themselves.
    if (at_nodes)
      for (const Numbers &face : faces)
        if (std::any_of(face.begin(), face.end(), [&](const auto node) { return inside[node]; }))
          for (const unsigned int node : face)
            grown[node] = 1;
    maximise_over_ranks(grown);
    point = points.begin();
    for (const auto i : in.locally_owned_elements())
      {
        const auto is_in = [&](const unsigned int node) { return grown[node] > 0; };
        result(i)        = std::any_of(point->begin(), point->end(), is_in) ? 1. : 0.;
        ++point;
      }
    result.compress(VectorOperation::insert);
    return result;
  }



  // Mean of the values at the neighbours of each node, those on its faces that are `in`. A
  // neighbour counts once for each face that both share. `complete` is 1 where all neighbours are
  // in.
  LA::Vector
  ContactRegions::means_of_neighbours(const LA::Vector &in,
                                      const LA::Vector &values,
                                      LA::Vector       &complete) const
  {
    using Field = LinearAlgebra::distributed::Vector<double>;
    Field        inside(layout), value(layout), sum(layout), count(layout), missing(layout);
    unsigned int own = 0;
    for (const auto i : in.locally_owned_elements())
      {
        inside.local_element(own)  = in(i);
        value.local_element(own++) = values(i);
      }
    inside.update_ghost_values();
    value.update_ghost_values();
    const Field &is_in = inside, &at = value;
    for (const Numbers &face : faces)
      for (const unsigned int node : face)
        for (const unsigned int other : face)
          if (other != node && is_in.local_element(other) > 0)
            {
              sum.local_element(node) += at.local_element(other);
              count.local_element(node) += 1;
            }
          else if (other != node)
            missing.local_element(node) += 1;
    for (Field *field : {&sum, &count, &missing})
      field->compress(VectorOperation::add);

    LA::Vector result;
    result.reinit(in);
    own = 0;
    for (const auto i : in.locally_owned_elements())
      {
        const double n = count.local_element(own);
        complete(i)    = in(i) > 0 && n > 0 && missing.local_element(own) == 0 ? 1. : 0.;
        result(i)      = in(i) > 0 && n > 0 ? sum.local_element(own) / n : 0.;
        ++own;
      }
    complete.compress(VectorOperation::insert);
    result.compress(VectorOperation::insert);
    return result;
  }



  void
  ContactRegions::add_other_ranks(std::map<Index, double> &sum_of) const
  {
    // The rank that owns the node whose number is that of the region adds up the sums of all ranks
    // and returns the total to them. Collective.
    const MPI_Comm comm = layout->get_mpi_communicator();
    IndexSet       wanted(layout->size());
    for (const auto &[region, value] : sum_of)
      wanted.add_index(region - 1);
    const auto owners =
      Utilities::MPI::compute_index_owner(layout->locally_owned_range(), wanted, comm);
    std::map<unsigned int, std::vector<Sum>> sums;
    for (const auto &[region, value] : sum_of)
      sums[owners[wanted.index_within_set(region - 1)]].push_back({region, value});
    auto                    received = Utilities::MPI::some_to_some(comm, sums);
    std::map<Index, double> totals;
    for (const auto &[rank, list] : received)
      for (const Sum &sum : list)
        totals[sum.region] += sum.value;
    for (auto &[rank, list] : received)
      for (Sum &sum : list)
        sum.value = totals[sum.region];
    for (const auto &[rank, list] : Utilities::MPI::some_to_some(comm, received))
      for (const Sum &sum : list)
        sum_of[sum.region] = sum.value;
  }



  template ContactRegions::ContactRegions(const Elasticity<2> &,
                                          const std::vector<ContactSurface<2>> &,
                                          const ContactRows &,
                                          Sampling);
  template ContactRegions::ContactRegions(const Elasticity<3> &,
                                          const std::vector<ContactSurface<3>> &,
                                          const ContactRows &,
                                          Sampling);
} // namespace Signorini
