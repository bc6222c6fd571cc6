// SPDX-License-Identifier: Apache-2.0
#include "fields/friction_fields.h"
#include "fields/recovered_pressure.h"
#include "output/directory.h"
#include "output/files.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <optional>
#include <string>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr char columns[] = "x,y,z,pressure,gap,status,initial_gap,normal_x,normal_y,normal_z";
    constexpr char friction_columns[] =
      ",tangential_x,tangential_y,tangential_z,slip_x,slip_y,slip_z,stick";

    // One number a column. Without friction the last ones are not used.
    using Line                            = std::array<double, 17>;
    constexpr unsigned int n_frictionless = 10;



    // @return the number of columns of all profiles.
    template <int dim>
    unsigned int
    n_columns_of(const Snapshot<dim> &snapshot)
    {
      return snapshot.contact.n_components() > 1 ? std::tuple_size<Line>::value : n_frictionless;
    }



    // @return the contact points of a pair on this rank, a number a column for each.
    template <int dim>
    std::vector<double>
    own_lines(const Snapshot<dim> &snapshot, const unsigned int pair)
    {
      const GapOperator      &contact = snapshot.contact;
      std::vector<double>     numbers;
      const IndexSet          rows         = snapshot.pressure.locally_owned_elements();
      auto                    row          = rows.begin();
      const LA::Vector       &nodal        = recovered_pressure(snapshot, pair);
      const bool              has_friction = n_columns_of(snapshot) > n_frictionless;
      std::vector<LA::Vector> slip, at_points, at_nodes; // in space
      if (has_friction)
        {
          const PointVectors &t = snapshot.contact_state.traction;
          slip                  = in_space(snapshot, slip_at_points(snapshot));
          at_points             = in_space(snapshot, {t.begin() + 1, t.end()});
          at_nodes              = tangential_traction(snapshot, pair);
        }
      for (unsigned int k = 0; k < contact.origin.pair.size(); ++k, ++row)
        if (contact.origin.pair[k] == pair)
          {
            Tensor<1, dim> normal;
            for (unsigned int d = 0; d < dim; ++d)
              normal[d] = contact.geometry.normal[d](*row);
            if (normal.norm() > 0)
              normal /= normal.norm();
            for (unsigned int d = 0; d < 3; ++d)
              numbers.push_back(d < dim ? contact.geometry.position[d](*row) : 0.);
            numbers.push_back(contact.origin.node.empty() ? snapshot.pressure(*row) :
                                                            nodal(contact.origin.node[k]));
            for (const LA::Vector *v : {&snapshot.gap, &snapshot.active, &contact.reference_gap})
              numbers.push_back((*v)(*row));
            for (unsigned int d = 0; d < 3; ++d)
              numbers.push_back(d < dim ? normal[d] : 0.);
            if (!has_friction)
              continue;
            for (unsigned int d = 0; d < 3; ++d)
              numbers.push_back(d >= dim                    ? 0. :
                                contact.origin.node.empty() ? at_points[d](*row) :
                                                              at_nodes[d](contact.origin.node[k]));
            for (unsigned int d = 0; d < 3; ++d)
              numbers.push_back(d < dim ? slip[d](*row) : 0.);
            numbers.push_back(
              status_of(snapshot.contact_state.status(*row)) == ContactStatus::stick ? 1. : 0.);
          }
      return numbers;
    }



    // @return all contact points of a pair, on rank 0, where they have to fit into memory: some
    // numbers for each point of the surface are little compared with the share of the volume of any
    // rank.
    template <int dim>
    std::vector<Line>
    gather_lines(const Snapshot<dim> &snapshot, const unsigned int pair)
    {
      std::vector<Line>  lines;
      const unsigned int n_values = n_columns_of(snapshot);
      const MPI_Comm     comm     = snapshot.elasticity.mesh().communicator();
      const bool         receives = Utilities::MPI::this_mpi_process(comm) == 0;
      // Not by MPI::gather(), which compresses.
      std::map<unsigned int, std::vector<double>> own = {{0, own_lines(snapshot, pair)}};
      auto of_ranks = Utilities::MPI::some_to_some(comm, receives ? decltype(own)() : own);
      if (receives)
        of_ranks.merge(own);
      for (const auto &[rank, numbers] : of_ranks)
        for (std::size_t i = 0; i < numbers.size(); i += n_values)
          {
            lines.emplace_back();
            std::copy_n(numbers.begin() + i, n_values, lines.back().begin());
          }
      return lines;
    }



    // @return the position of each line in the order of its coordinate d, where coordinates that
    // differ by rounding only have the same position.
    std::vector<unsigned int>
    places(const std::vector<Line> &lines, const unsigned int d, const double tolerance)
    {
      std::vector<unsigned int> order(lines.size()), place(lines.size());
      std::iota(order.begin(), order.end(), 0u);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return lines[a][d] < lines[b][d];
      });
      for (unsigned int i = 1; i < order.size(); ++i)
        place[order[i]] =
          place[order[i - 1]] + (lines[order[i]][d] - lines[order[i - 1]][d] > tolerance ? 1 : 0);
      return place;
    }



    /// @return the largest difference of a coordinate from that of the first line.
    double
    extent(const std::vector<Line> &lines)
    {
      double largest = 0;
      for (const Line &line : lines)
        for (unsigned int d = 0; d < 3; ++d)
          largest = std::max(largest, std::abs(line[d] - lines.front()[d]));
      return largest;
    }



    // @return the lines sorted by x, y, z. Positions of nodes are rounded differently by the cells
    // around them, and which of these counts depends on the partition: neither the order nor zeros
    // may depend on it.
    std::vector<Line>
    sorted(const std::vector<Line> &lines)
    {
      const double                             tolerance = 1e-10 * extent(lines);
      std::vector<std::array<unsigned int, 4>> keys(lines.size());
      for (unsigned int d = 0; d < 3; ++d)
        {
          const std::vector<unsigned int> place = places(lines, d, tolerance);
          for (unsigned int i = 0; i < lines.size(); ++i)
            keys[i][d] = place[i];
        }
      for (unsigned int i = 0; i < lines.size(); ++i)
        keys[i][3] = i;
      std::sort(keys.begin(), keys.end());

      std::vector<Line> result;
      for (const auto &key : keys)
        {
          result.push_back(lines[key[3]]);
          for (unsigned int d = 0; d < 3; ++d)
            if (std::abs(result.back()[d]) <= tolerance)
              result.back()[d] = 0;
        }
      return result;
    }



    /// Append a number with 12 digits.
    void
    append(std::string &text, const double x)
    {
      char digits[32];
      text.append(
        digits,
        std::to_chars(digits, digits + sizeof(digits), x, std::chars_format::general, 12).ptr);
    }



    /// @return the file, with the reference pressure at each point if there is one.
    template <int dim>
    std::string
    as_text(const std::vector<Line>              &lines,
            const unsigned int                    n_values,
            const std::optional<Expression<dim>> &reference,
            const double                          time)
    {
      std::string text = columns;
      text += n_values > n_frictionless ? friction_columns : "";
      text += reference ? ",reference\n" : "\n";
      for (const Line &line : lines)
        {
          for (unsigned int i = 0; i < n_values; ++i)
            {
              text += i > 0 ? "," : "";
              append(text, line[i]);
            }
          Point<dim> x;
          for (unsigned int d = 0; d < dim; ++d)
            x[d] = line[d];
          if (reference)
            append(text += ',', reference->value(x, time));
          text += '\n';
        }
      return text;
    }
  } // namespace



  // Rank 0 gathers the points of one pair after the other, and writes.
  template <int dim>
  void
  write_profiles(const Snapshot<dim> &snapshot,
                 const std::string   &directory,
                 const Formula       &reference_pressure)
  {
    std::optional<Expression<dim>> reference;
    if (!reference_pressure.empty())
      reference.emplace(reference_pressure);
    const unsigned int n_values = n_columns_of(snapshot);
    const bool         writes =
      Utilities::MPI::this_mpi_process(snapshot.elasticity.mesh().communicator()) == 0;
    const std::string of_step = directory + "/step-" + Utilities::int_to_string(snapshot.step, 4);
    if (writes)
      std::filesystem::create_directories(of_step);
    for (unsigned int p = 0; p < snapshot.pairs.size(); ++p)
      {
        const std::vector<Line> lines = gather_lines(snapshot, p);
        if (!writes)
          continue;
        const std::string text = as_text<dim>(sorted(lines), n_values, reference, snapshot.time);
        for (const std::string &folder : {of_step, directory})
          replace_file(folder + "/" + snapshot.pairs[p].name + ".csv", text);
      }
  }



  template void
  write_profiles(const Snapshot<2> &, const std::string &, const Formula &);
  template void
  write_profiles(const Snapshot<3> &, const std::string &, const Formula &);
} // namespace Signorini
