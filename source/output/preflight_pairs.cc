// SPDX-License-Identifier: Apache-2.0
#include "contact/search/boundary_faces.h"
#include "output/preflight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace Signorini
{
  using namespace dealii;
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// A boundary of a body: its faces on this rank, and number and mean size of all its faces.
    template <int dim>
    struct Side
    {
      BoundaryFaces<dim> own;
      /// Number of faces on all ranks, and their mean size [length].
      double n = 0, size = 0;

      /// The image of the master; that of slaves is the surface itself.
      MasterImage<dim> image;

      /// @param boundary its name
      Side(const Elasticity<dim>  &elasticity,
           const std::string      &boundary,
           const MasterImage<dim> &image)
        : own(elasticity, boundary)
        , image(image)
      {
        const MPI_Comm comm = elasticity.mesh().communicator();
        n                   = own.faces.size();
        for (const FacePatch<dim> &patch : own.patches)
          // The diameter is the diagonal of a face: divided by the square root of dim - 1 it is the
          // side of a square.
          size += patch.diameter() / std::sqrt(dim - 1.);
        n    = Utilities::MPI::sum(n, comm);
        size = Utilities::MPI::sum(size, comm) / std::max(1., n);
      }
    };

    /// @return the range of initial gaps, the shares of the area of the candidates that overlap,
    /// touch and are open, and a histogram. Collective.
    template <int dim>
    Json
    gaps(const ContactSurface<dim> &surface, const double rounding, const MPI_Comm comm)
    {
      constexpr unsigned int n_bins = 10;
      // The range of gaps and the shares of area by their sign.
      std::array<double, 2> range{{std::numeric_limits<double>::max(),
                                   std::numeric_limits<double>::max()}}; // least, minus largest
      std::vector<double>   shares(3, 0.);
      // Of tied surfaces the gaps that are kept are those of the geometry.
      const auto gap_at = [&](const ContactPoint<dim> &point) {
        return point.gap - (surface.is_tied ? point.prescribed_gap : 0.);
      };
      for (const ContactPoint<dim> &point : surface.points)
        {
          const double gap = gap_at(point);
          range[0]         = std::min(range[0], gap);
          range[1]         = std::min(range[1], -gap);
          shares[gap < -rounding ? 0 : gap <= rounding ? 1 : 2] += point.weight;
        }
      const double least = Utilities::MPI::min(range[0], comm),
                   most  = -Utilities::MPI::min(range[1], comm);
      // The histogram needs the range of all ranks.
      std::vector<double> histogram(n_bins, 0.);
      for (const ContactPoint<dim> &point : surface.points)
        {
          // The position of a gap in the range, from 0 to 1; its upper end belongs to the last bin.
          // Points count with their areas, so that the histogram does not depend on the quadrature.
          const double place = most > least ? (gap_at(point) - least) / (most - least) : 0.;
          histogram[std::min<unsigned int>(n_bins * place, n_bins - 1)] += point.weight;
        }
      Utilities::MPI::sum(shares, comm, shares);
      Utilities::MPI::sum(histogram, comm, histogram);
      const double area = shares[0] + shares[1] + shares[2];
      for (auto *numbers : {&shares, &histogram})
        for (double &x : *numbers)
          // Four digits are enough for shares, and make reports easier to compare.
          x = area > 0 ? std::round(1e4 * x / area) / 1e4 : 0.;
      return {{"least", least},
              {"largest", most},
              {"overlapping", shares[0]},
              {"touching", shares[1]},
              {"open", shares[2]},
              {"histogram", histogram}};
    }

    /// @return the largest angle [degrees] between the slave normal and the opposite of the master
    /// normal where surfaces touch or overlap at the start, on all ranks.
    template <int dim>
    double
    largest_angle(const ContactSurface<dim> &surface, const double rounding, const MPI_Comm comm)
    {
      // The alignment is the cosine of the angle; without any touching point the result is zero
      // degrees. The maximum below protects the arc cosine from rounding below -1.
      double smallest = 1;
      for (const ContactPoint<dim> &point : surface.points)
        if (point.gap <= rounding)
          smallest = std::min(smallest, point.normal_alignment);
      return std::acos(std::max(-1., Utilities::MPI::min(smallest, comm))) * 180 / numbers::PI;
    }

    /// @return whether nearly all vertices of the slave are vertices of the master. Coordinates are
    /// rounded to a fiftieth of a face, and compared on the rank that their hash assigns.
    /// Collective.
    template <int dim>
    bool
    match(const Side<dim> &slave, const Side<dim> &master, const MPI_Comm comm)
    {
      // Vertices of both surfaces are sent to the rank of their hash, and compared there.
      using Key = std::array<long, dim>;
      // Vertices of the two surfaces that are nearly at the same position usually get the same
      // integers. If a coordinate is near a limit of rounding they do not, which is why a share of
      // nine tenths is enough.
      const double resolution = 0.02 * std::min(slave.size, master.size);
      const auto   send       = [&](const Side<dim> &side) {
        std::map<unsigned int, std::vector<Key>> keys;
        for (const auto &[cell, face] : side.own.faces)
          for (const unsigned int v : cell->face(face)->vertex_indices())
            {
              Key              key;
              unsigned long    hash  = 0;
              const Point<dim> place = side.image.of(cell->face(face)->vertex(v));
              for (unsigned int d = 0; d < dim; ++d)
                {
                  key[d] = std::lround(place[d] / resolution);
                  // Equal keys have equal hashes, so that equal vertices of both surfaces, wherever
                  // they are owned, arrive at the same rank; vertices that several ranks send are
                  // counted once there.
                  hash = 31 * hash + static_cast<unsigned long>(key[d]);
                }
              keys[hash % Utilities::MPI::n_mpi_processes(comm)].push_back(key);
            }
        std::set<Key> received;
        for (const auto &[rank, list] : Utilities::MPI::some_to_some(comm, keys))
          received.insert(list.begin(), list.end());
        return received;
      };
      const std::set<Key> of_slave = send(slave), of_master = send(master);
      unsigned int        n_same = 0;
      for (const Key &key : of_slave)
        n_same += of_master.count(key);
      return Utilities::MPI::sum(n_same, comm) > 0.9 * Utilities::MPI::sum(of_slave.size(), comm);
    }
  } // namespace



  template <int dim>
  Json
  preflight_of_pairs(const Decisions<dim>                   &decisions,
                     const Elasticity<dim>                  &elasticity,
                     const std::vector<ContactSurface<dim>> &surfaces,
                     Json                                   &warnings)
  {
    const MPI_Comm comm     = elasticity.mesh().communicator();
    const double   rounding = 1e-10 * elasticity.rotation_length_scale();
    Json           result   = Json::object();
    for (unsigned int i = 0; i < surfaces.size(); ++i)
      {
        const ContactPair<dim> &pair = decisions.pairs[i];
        const Side<dim>         slave(elasticity, pair.slave, {});
        Json                    one = {{"slave", pair.slave},
                                       {"slave_faces", slave.n},
                                       {"slave_face_size", slave.size},
                                       {"master", pair.master},
                                       {"separates", pair.can_separate}};
        if (surfaces[i].has_no_projection)
          warnings.push_back(
            "pair " + pair.name + ": no face of " + pair.slave + " faces " + pair.master +
            " within the search distance; if they should touch, choose other boundaries, or set "
            "Search distance of the pair");
        // Surfaces that are too far apart have no candidates.
        // Their gaps are not known, so that the entries about gaps and angles are missing.
        if (surfaces[i].is_apart)
          {
            one["candidates"] = 0;
            result[pair.name] = one;
            continue;
          }
        // The candidates with their gaps and normals.
        one["candidates"]       = Utilities::MPI::sum(surfaces[i].points.size(), comm);
        one["covered_share"]    = covered_share(surfaces[i], comm);
        one["reach"]            = surfaces[i].candidate_gap;
        one["gap"]              = gaps(surfaces[i], rounding, comm);
        one["largest_angle"]    = largest_angle(surfaces[i], rounding, comm);
        const std::string where = "pair " + pair.name + ": ";
        if (const double overlap = -one["gap"]["least"].get<double>(); overlap > slave.size)
          warnings.push_back(
            where + "the initial overlap is larger than a face of the slave; refine the slave, or "
                    "set Interference ramp = t");
        if (one["largest_angle"] > 60)
          warnings.push_back(
            where + "the slave normal deviates by up to " +
            std::to_string(one["largest_angle"].template get<int>()) +
            " degrees from the opposite of the master normal where the surfaces touch; refine "
            "there, or split the surface");
        // A master surface of a body also has a mesh, which is compared with that of the slave.
        if (!decisions.scene.obstacle_of(pair))
          {
            const Side<dim> master(elasticity, pair.master, pair.image);
            one["master_faces"]     = master.n;
            one["master_face_size"] = master.size;
            one["matching"]         = match(slave, master, comm);
            if (slave.size > 8 * master.size)
              warnings.push_back(
                where +
                "the slave mesh is more than 8 times coarser than the master mesh; refine " +
                pair.slave);
            else if (master.size > 8 * slave.size)
              warnings.push_back(
                where +
                "the master mesh is more than 8 times coarser than the slave mesh; refine " +
                pair.master);
          }
        result[pair.name] = one;
      }
    return result;
  }



  template Json
  preflight_of_pairs(const Decisions<2> &,
                     const Elasticity<2> &,
                     const std::vector<ContactSurface<2>> &,
                     Json &);
  template Json
  preflight_of_pairs(const Decisions<3> &,
                     const Elasticity<3> &,
                     const std::vector<ContactSurface<3>> &,
                     Json &);
} // namespace Signorini
