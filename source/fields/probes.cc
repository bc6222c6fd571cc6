// SPDX-License-Identifier: Apache-2.0
#include "fields/probes.h"

#include "fields/surface_probes.h"
#include "solid/cell_nodes.h"
#include "solid/stress.h"
#include <signorini/parameters/raw.h>
#include <signorini/solid/model.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    // Distances are in reference coordinates of a cell. Points closer than this to a face belong to
    // both cells.
    constexpr double same = 1e-6;

    /// The properties of a cell by which one of several candidates for a probe is chosen. They do
    /// not depend on the partition, so that the choice is the same for any number of ranks.
    template <int dim>
    struct Claim
    {
      /// Distance from the reference cell, 0 inside.
      double       distance = std::numeric_limits<double>::infinity();
      unsigned int body     = numbers::invalid_unsigned_int;
      Point<dim>   center;
      double       size = 0;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &distance &body &center &size;
      }
    };

    /// A candidate cell of this rank.
    template <int dim>
    struct CellLocation
    {
      Claim<dim> claim;
      Cell<dim>  cell;
      Point<dim> unit;
    };



    /// @return whether candidate a is preferred: the closest cell, then the first body, then the
    /// lowest centre.
    template <int dim>
    bool
    takes_precedence(const Claim<dim> &a, const Claim<dim> &b)
    {
      if (a.distance != b.distance)
        return a.distance < b.distance;
      if (a.body != b.body)
        return a.body < b.body;
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(a.center[d] - b.center[d]) > same * (a.size + b.size))
          return a.center[d] < b.center[d];
      return false;
    }



    /// @return a point in the coordinates of a cell; with infinite distance if it is farther than
    /// `farthest`.
    template <int dim>
    CellLocation<dim>
    place_in(const Mapping<dim> &mapping,
             const Cell<dim>    &cell,
             const Point<dim>   &x,
             const double        farthest)
    {
      CellLocation<dim> location;
      try
        {
          const Point<dim> unit     = mapping.transform_real_to_unit_cell(cell, x);
          const double     distance = GeometryInfo<dim>::distance_to_unit_cell(unit);
          if (distance <= farthest)
            {
              location.cell  = cell;
              location.unit  = GeometryInfo<dim>::project_to_unit_cell(unit);
              location.claim = {distance <= same ? 0 : distance,
                                cell->material_id(),
                                cell->center(),
                                cell->diameter()};
            }
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
          // The mapping could not be inverted: the point is far from the cell.
        }
      return location;
    }



    /// @return whether a probe belongs to this body, and its point is in the box.
    template <int dim>
    bool
    may_be_in(const Probe<dim> &probe, const std::string &body, const BoundingBox<dim> &box)
    {
      return (probe.body.empty() || probe.body == body) && box.point_inside(probe.point);
    }



    /// @return the preferred cell of this rank for each probe. Cost: number of cells times number
    /// of probes, by boxes.
    template <int dim>
    std::vector<CellLocation<dim>>
    own_places(const Elasticity<dim>         &elasticity,
               const std::vector<Probe<dim>> &probes,
               const double                   farthest)
    {
      const Mesh<dim>               &mesh = elasticity.mesh();
      std::vector<CellLocation<dim>> best(probes.size());
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            // The box is that of the vertices; an edge that is a quarter of a circle extends beyond
            // it by a fifth of its length.
            BoundingBox<dim> box = cell->bounding_box();
            box.extend(0.25 * cell->diameter());
            for (unsigned int i = 0; i < probes.size(); ++i)
              if (may_be_in(probes[i], mesh.body_name(mesh.body(cell)), box))
                {
                  const CellLocation<dim> location =
                    place_in<dim>(mesh.mapping(), cell, probes[i].point, farthest);
                  if (takes_precedence(location.claim, best[i].claim))
                    best[i] = location;
                }
          }
      return best;
    }



    /// @return the extent of a body for messages.
    template <int dim>
    std::string
    extent_of_body(const Mesh<dim> &mesh, const unsigned int body)
    {
      const auto &[low, high] = mesh.extent(body).get_boundary_points();
      return "from " + point_text(low) + " to " + point_text(high);
    }



    /// Throw SceneError: the point is outside of all bodies, or of its body, which does perhaps not
    /// exist.
    template <int dim>
    [[noreturn]] void
    refuse(const Probe<dim> &probe, const Mesh<dim> &mesh)
    {
      std::vector<std::string> extents, names;
      for (unsigned int b = 0; b < mesh.n_bodies(); ++b)
        {
          names.push_back(mesh.body_name(b));
          if (probe.body.empty() || probe.body == names.back())
            extents.push_back("'" + names.back() + "' extends " + extent_of_body(mesh, b));
        }
      const std::string which = "probe '" + probe.name + "' at " + point_text(probe.point) + ": ";
      if (extents.empty())
        throw SceneError(which + "there is no body '" + probe.body + "'; the bodies are " +
                         join(names));
      throw SceneError(which + "the point is outside of " +
                       (probe.body.empty() ? "all bodies" : "its body") + "; " +
                       join(extents, ", "));
    }



    /// @return the cells that contain the point x, with its reference coordinates in each of them.
    /// They are found from face to face, so that the other side of a slit is not among them. All
    /// are locally owned or ghost cells.
    template <int dim>
    std::vector<CellLocation<dim>>
    cells_about(const Mapping<dim> &mapping, const CellLocation<dim> &first, const Point<dim> &x)
    {
      std::vector<CellLocation<dim>> locations = {first};
      std::set<Cell<dim>>            seen      = {first.cell};
      const auto                     visit     = [&](const Cell<dim> &cell) {
        if (!cell->is_artificial() && seen.insert(cell).second)
          if (const CellLocation<dim> location =
                place_in<dim>(mapping, cell, x, first.claim.distance + same);
              location.claim.distance <= first.claim.distance + same)
            locations.push_back(location);
      };
      for (unsigned int i = 0; i < locations.size(); ++i)
        {
          const Cell<dim> cell = locations[i].cell;
          for (const unsigned int f : cell->face_indices())
            if (!cell->at_boundary(f))
              {
                if (!cell->neighbor(f)->has_children())
                  visit(cell->neighbor(f));
                else
                  for (unsigned int c = 0; c < cell->face(f)->n_children(); ++c)
                    visit(cell->neighbor_child_on_subface(f, c));
              }
        }
      return locations;
    }



    /// Compute displacement and stress at a point as means over the cells that share it.
    template <int dim>
    void
    evaluate(const Elasticity<dim>                &elasticity,
             const LA::Vector                     &displacement,
             const std::vector<CellLocation<dim>> &locations,
             const Point<dim>                     &x,
             Tensor<1, dim>                       &u,
             SymmetricTensor<2, 3>                &stress)
    {
      const double share = 1. / locations.size();
      for (const CellLocation<dim> &location : locations)
        {
          FEValues<dim> values(elasticity.mesh().mapping(),
                               location.cell->get_fe(),
                               Quadrature<dim>(location.unit),
                               update_values | update_gradients);
          values.reinit(location.cell);
          std::vector<Tensor<1, dim>> us(1);
          std::vector<Tensor<2, dim>> gradients(1);
          values[FEValuesExtractors::Vector(0)].get_function_values(displacement, us);
          values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement, gradients);
          u += share * us[0];
          stress += share * elasticity.stress(*location.cell, gradients[0], us[0], x);
        }
    }



    /// @return the rank with the preferred cell of probe i.
    template <int dim>
    unsigned int
    winner(const std::vector<std::vector<Claim<dim>>> &claims, const unsigned int i)
    {
      return std::min_element(claims.begin(),
                              claims.end(),
                              [i](const auto &a, const auto &b) {
                                return takes_precedence(a[i], b[i]);
                              }) -
             claims.begin();
    }

    /// @return the candidates of all ranks, [rank][probe]. Collective.
    template <int dim>
    std::vector<std::vector<Claim<dim>>>
    all_claims(const std::vector<CellLocation<dim>> &locations, const MPI_Comm comm)
    {
      std::vector<Claim<dim>> claims;
      for (const CellLocation<dim> &location : locations)
        claims.push_back(location.claim);
      return Utilities::MPI::all_gather(comm, claims);
    }
  } // namespace



  namespace
  {
    /// Throw SceneError for a probe outside of its body. Collective.
    template <int dim>
    void
    check_in_bodies(const Elasticity<dim>         &elasticity,
                    const std::vector<Probe<dim>> &probes,
                    const double                   tolerance)
    {
      const auto claims =
        all_claims(own_places(elasticity, probes, tolerance), elasticity.mesh().communicator());
      for (unsigned int i = 0; i < probes.size(); ++i)
        if (claims[winner(claims, i)][i].distance > tolerance)
          refuse(probes[i], elasticity.mesh());
    }
  } // namespace



  template <int dim>
  unsigned int
  pair_of(const Probe<dim> &probe, const std::vector<ContactPair<dim>> &pairs)
  {
    std::vector<std::string> names;
    for (const ContactPair<dim> &pair : pairs)
      names.push_back(pair.name);
    const auto found = std::find(names.begin(), names.end(), probe.pair);
    if (found == names.end())
      throw SceneError(probe.title() + "there is no contact pair '" + probe.pair + "'" +
                       (names.empty() ? "" : "; the pairs are " + join(names)));
    return found - names.begin();
  }



  template <int dim>
  void
  check_probes(const Elasticity<dim>               &elasticity,
               const std::vector<ContactPair<dim>> &pairs,
               const std::vector<Probe<dim>>       &probes,
               const double                         tolerance)
  {
    std::vector<Probe<dim>> in_bodies;
    for (const Probe<dim> &probe : probes)
      if (probe.is_on_pair())
        check_on_surface(
          elasticity, pairs[pair_of(probe, pairs)].slave, probe.points(), tolerance, probe.title());
      else
        for (const Probe<dim> &one : probe.single())
          in_bodies.push_back(one);
    check_in_bodies(elasticity, in_bodies, tolerance);
  }



  // The rank with the preferred cell evaluates each probe; the sum over ranks distributes the
  // values.
  template <int dim>
  std::vector<ProbeValue<dim>>
  evaluate_probes(const Elasticity<dim>         &elasticity,
                  const LA::Vector              &displacement,
                  const std::vector<Probe<dim>> &probes)
  {
    const MPI_Comm                       comm    = elasticity.mesh().communicator();
    const LA::Vector                     ghosted = elasticity.with_ghosts(displacement);
    const std::vector<CellLocation<dim>> locations =
      own_places(elasticity, probes, probe_tolerance);
    // Each rank proposes its closest cell for each probe. All ranks know all proposals, and so the
    // same winner, without further communication.
    const auto claims = all_claims(locations, comm);

    std::vector<ProbeValue<dim>> result(probes.size());
    for (unsigned int i = 0; i < probes.size(); ++i)
      {
        const unsigned int rank  = winner(claims, i);
        const Claim<dim>  &claim = claims[rank][i];
        if (claim.distance > probe_tolerance)
          refuse(probes[i], elasticity.mesh());

        Tensor<1, dim>        u;
        SymmetricTensor<2, 3> stress;
        if (rank == Utilities::MPI::this_mpi_process(comm))
          evaluate(elasticity,
                   ghosted,
                   cells_about(elasticity.mesh().mapping(), locations[i], probes[i].point),
                   probes[i].point,
                   u,
                   stress);
        result[i].name         = probes[i].name;
        result[i].found        = true;
        result[i].displacement = Utilities::MPI::sum(u, comm);
        result[i].stress       = Utilities::MPI::sum(stress, comm);
        result[i].von_mises    = von_mises(result[i].stress);
      }
    return result;
  }



  // The transpose of evaluate_probes() for one probe: the values and stresses of all shape
  // functions of the cells that share the point.
  template <int dim>
  LA::Vector
  probe_functional(const Elasticity<dim>       &elasticity,
                   const Probe<dim>            &probe,
                   const Tensor<1, dim>        &of_displacement,
                   const SymmetricTensor<2, 3> &of_stress)
  {
    const MPI_Comm comm      = elasticity.mesh().communicator();
    const auto     locations = own_places<dim>(elasticity, {probe}, probe_tolerance);
    const auto     claims    = all_claims(locations, comm);
    const auto    &fes       = elasticity.finite_elements();
    LA::Vector     result    = elasticity.zero_vector();
    if (winner(claims, 0) == Utilities::MPI::this_mpi_process(comm))
      {
        // Values are means over the cells that share the point, so that each cell has the
        // weight one over their number.
        const auto cells = cells_about(elasticity.mesh().mapping(), locations[0], probe.point);
        std::vector<types::global_dof_index> indices;
        Vector<double>                       weights;
        for (const CellLocation<dim> &location : cells)
          {
            FEValues<dim> values(elasticity.mesh().mapping(),
                                 fes[location.cell->active_fe_index()],
                                 Quadrature<dim>(location.unit),
                                 update_values | update_gradients);
            values.reinit(location.cell);
            read_indices<dim>(location.cell, indices);
            weights.reinit(indices.size());
            const FEValuesExtractors::Vector u(0);
            const Material &material = elasticity.material(location.cell->material_id());
            for (unsigned int i = 0; i < indices.size(); ++i)
              {
                const auto eps = strain(elasticity.model(),
                                        material,
                                        values[u].gradient(i, 0),
                                        values[u].value(i, 0),
                                        probe.point);
                weights[i]     = (of_displacement * values[u].value(i, 0) +
                              of_stress * Signorini::stress(material, eps)) /
                             cells.size();
              }
            elasticity.constraints().distribute_local_to_global(weights, indices, result);
          }
      }
    result.compress(VectorOperation::add);
    return result;
  }



  template unsigned int
  pair_of(const Probe<2> &, const std::vector<ContactPair<2>> &);
  template unsigned int
  pair_of(const Probe<3> &, const std::vector<ContactPair<3>> &);
  template void
  check_probes(const Elasticity<2> &,
               const std::vector<ContactPair<2>> &,
               const std::vector<Probe<2>> &,
               double);
  template void
  check_probes(const Elasticity<3> &,
               const std::vector<ContactPair<3>> &,
               const std::vector<Probe<3>> &,
               double);
  template LA::Vector
  probe_functional(const Elasticity<2> &,
                   const Probe<2> &,
                   const Tensor<1, 2> &,
                   const SymmetricTensor<2, 3> &);
  template LA::Vector
  probe_functional(const Elasticity<3> &,
                   const Probe<3> &,
                   const Tensor<1, 3> &,
                   const SymmetricTensor<2, 3> &);
  template std::vector<ProbeValue<2>>
  evaluate_probes(const Elasticity<2> &, const LA::Vector &, const std::vector<Probe<2>> &);
  template std::vector<ProbeValue<3>>
  evaluate_probes(const Elasticity<3> &, const LA::Vector &, const std::vector<Probe<3>> &);
} // namespace Signorini
