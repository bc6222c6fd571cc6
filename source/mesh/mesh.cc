// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.h"

#include "base/compatibility.h"
#include "geometry/extent.h"
#include "mesh/any_cell_mapping.h"
#include "mesh/cell_mapping.h"
#include <signorini/parameters/section.h>

#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  RefinementRegion<dim>::declare(Section &section)
  {
    section.rename_key("Where", "Inside");
    section.add("Inside",
                where,
                "indicator of the region: cells are refined where this function of the coordinates "
                "is positive");
    if (where.depends_on_time())
      section.fail(
        "Inside",
        "depends on t, but these cells are refined once, at the start; use a function of "
        "the coordinates that is positive wherever the mesh is to be fine at any time");
    section.add("Bodies", bodies, "only cells of these bodies; empty: all");
    section.rename_key("Times", "Levels");
    section.add("Levels", times, "number of refinements of the cells in the region");
    place = section.source_of("Bodies");
  }



  template <int dim>
  void
  MeshSettings<dim>::declare(Section &section)
  {
    section.add_choice(
      "Distribution",
      distribution,
      or_auto<Distribution>({{"p4est", Distribution::p4est}, {"METIS", Distribution::METIS}}),
      "partitioner of the mesh; METIS cannot refine; auto: p4est, but METIS for more than 30,000 coarse cells without Refinements and Refinement cycles");
    section.add("Refinements", refinements, "number of uniform refinements at the start");
    section.add("Contact refinements",
                contact_refinements,
                "number of refinements of the cells at contact surfaces, after the uniform ones");
    section.add(
      "Slave face weight",
      slave_face_weight,
      "weight of a slave face in the load balance between ranks, in units of the weight of a cell",
      Range{0, 1000});
    section.add(
      "Geometry degree",
      geometry_degree,
      "polynomial degree of the cell mapping, and of curved surfaces in gaps; 0: the degree of the displacement for cells, 4 for surfaces; triangles and tetrahedra have at most 2",
      Range{0, 4});
    section.rename_section("Zones", "Refinement regions");
    section.add_named("Refinement regions",
                      refinement_regions,
                      "Regions of space whose cells are refined, after the uniform refinements.");
  }



  // Without a choice p4est is used if the coarse mesh is small or is refined uniformly, otherwise
  // METIS.
  template <int dim>
  bool
  MeshSettings<dim>::by_p4est(const std::size_t n_coarse_cells) const
  {
    constexpr std::size_t many = 30000;
    return distribution == Distribution::p4est ||
           (!distribution && (n_coarse_cells <= many || refinements > 0));
  }



  namespace
  {
    /// Define the weights of cells for the load balance: one for each cell, and in addition the
    /// given weight for each slave face. The weight of a cell that is being refined is requested
    /// for each of its children, of which half are at a given face.
    template <int dim>
    void
    weigh(Triangulation<dim> &triangulation,
          const BoundaryIds  &slaves,
          const double        slave_face_weight)
    {
      constexpr unsigned int unit = 10; // of integer weights, whose sum METIS has 32 bits for
      triangulation.signals.weight.connect(
        [slaves, slave_face_weight](const auto &cell, const auto status) -> unsigned int {
          unsigned int n_slaves = 0;
          if (cell->at_boundary())
            for (const auto &face : cell->face_iterators())
              n_slaves += face->at_boundary() && slaves.count(face->boundary_id()) > 0;
          const bool is_itself = status == Compatibility::cell_will_persist<dim> ||
                                 status == Compatibility::children_will_be_coarsened<dim>;
          return unit * (1 + n_slaves * slave_face_weight * (is_itself ? 1. : 0.5));
        });
    }
  } // namespace



  // The mapping depends on the hanging nodes, and is created anew after each refinement.
  template <int dim>
  void
  Mesh<dim>::map_cells()
  {
    degree = *std::max_element(degree_of_body.begin(), degree_of_body.end());
    std::vector<unsigned int> by_material;
    for (const unsigned int body : bodies_of_materials)
      by_material.push_back(degree_of_body[body]);
    my_mappings =
      hp::MappingCollection<dim>(CellMapping<dim>(degree, by_material, *tria, has_simplices()));
  }



  // Straight bodies, and all bodies with a geometry degree of the scene, keep theirs.
  template <int dim>
  void
  Mesh<dim>::set_degrees(const std::vector<unsigned int> &degrees)
  {
    for (unsigned int body = 0; body < degrees.size(); ++body)
      if (is_curved[body])
        degree_of_body[body] = degrees[body];
    map_cells();
  }



  // With p4est each rank refines its own part of the mesh. With METIS each rank has the whole mesh
  // until it is partitioned, and it cannot be refined later; a single rank keeps the whole one as
  // it is, which costs half of the time and memory.
  template <int dim>
  Mesh<dim>::Mesh(const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
                  const MeshSettings<dim>                                  &settings,
                  const std::vector<std::pair<std::string, std::string>>   &contact_surfaces,
                  const MPI_Comm                                            comm)
  {
    // With simplices the mesh is partitioned by METIS: p4est knows none.
    const bool is_refinable = settings.distribution != Distribution::METIS &&
                              std::none_of(bodies.begin(), bodies.end(), [](const auto &body) {
                                return body.second.generator->has_simplices();
                              });
    const CoarseMesh<dim> coarse = merge(bodies, is_refinable);
    // A geometry degree of the scene replaces the degrees of all bodies and of the surfaces in
    // gaps.
    if (settings.geometry_degree > 0)
      {
        degree_of_surfaces = settings.geometry_degree;
        degree_of_body.assign(bodies.size(), settings.geometry_degree);
        is_curved.assign(bodies.size(), false);
      }
    my_surface_mappings.push_back(
      AnyCellMapping<dim>(degree_of_surfaces,
                          has_simplices() ?
                            std::make_shared<const SimplexMapping<dim>>(
                              std::min(degree_of_surfaces, 2u), std::vector<unsigned int>()) :
                            nullptr));
    if (has_simplices())
      check_for_simplices(bodies, settings);
    find_pieces(coarse);
    check_slaves_and_masters(contact_surfaces);
    BoundaryIds slaves;
    for (const auto &[slave, master] : contact_surfaces)
      slaves.insert(boundary_ids(slave).begin(), boundary_ids(slave).end());

    // Weights must be defined before the first partitioning, and slaves known before the weights.
    const auto make = [&](Triangulation<dim> &triangulation) {
      weigh(triangulation, slaves, settings.slave_face_weight);
      create(triangulation, coarse);
      number_coarse_cells(triangulation);
      refine_initially(triangulation, bodies, settings, contact_surfaces);
    };
    constexpr auto smoothing = Triangulation<dim>::limit_level_difference_at_vertices;
    if (!has_simplices() && settings.by_p4est(coarse.cells.size()))
      {
        tria = std::make_unique<parallel::distributed::Triangulation<dim>>(comm);
        make(*tria);
      }
    else if (Utilities::MPI::n_mpi_processes(comm) == 1)
      {
        tria = std::make_unique<parallel::shared::Triangulation<dim>>(comm, smoothing);
        make(*tria);
      }
    else
      {
        Triangulation<dim> serial(smoothing);
        make(serial);
        // Cells on both sides of a pair should be on the same rank.
        std::vector<std::pair<BoundaryIds, BoundaryIds>> pairs;
        for (const auto &[slave, master] : contact_surfaces)
          if (!master.empty())
            pairs.emplace_back(boundary_ids(slave), boundary_ids(master));
        partition_by_metis(serial, Utilities::MPI::n_mpi_processes(comm), pairs);
        // Each rank keeps its own part with ghost cells. Manifolds are not a part of the
        // description.
        const auto description =
          TriangulationDescription::Utilities::create_description_from_triangulation(serial, comm);
        auto distributed = std::make_unique<parallel::fullydistributed::Triangulation<dim>>(comm);
        for (const auto &[id, manifold] : coarse.manifolds)
          distributed->set_manifold(id, *manifold);
        distributed->create_triangulation(description);
        tria = std::move(distributed);
      }
    map_cells();
    tria->signals.post_distributed_refinement.connect([this] { map_cells(); });
    measure();
  }



  // Manifolds must exist before cells refer to them.
  template <int dim>
  void
  Mesh<dim>::create(Triangulation<dim> &triangulation, const CoarseMesh<dim> &coarse) const
  {
    for (const auto &[id, manifold] : coarse.manifolds)
      triangulation.set_manifold(id, *manifold);
    triangulation.create_triangulation(coarse.vertices, coarse.cells, coarse.faces);
  }



  template <int dim>
  const BoundaryIds &
  Mesh<dim>::boundary_ids(const std::string &name) const
  {
    const auto found = std::find(boundary_names.begin(), boundary_names.end(), name);
    if (found == boundary_names.end())
      throw SceneError("there is no boundary '" + name + "'; the boundaries are " +
                       join(boundary_names));
    return ids_of_names[found - boundary_names.begin()];
  }



  template <int dim>
  std::optional<unsigned int>
  Mesh<dim>::body_of(const std::string &boundary) const
  {
    const auto found = std::find(boundary_names.begin(), boundary_names.end(), boundary);
    if (found == boundary_names.end())
      return {};
    return body_of_boundary[found - boundary_names.begin()];
  }



  template <int dim>
  FacetHeight
  Mesh<dim>::facet_height(const std::string &boundary) const
  {
    const auto found = std::find(boundary_names.begin(), boundary_names.end(), boundary);
    return found == boundary_names.end() ? FacetHeight() : facets[found - boundary_names.begin()];
  }



  // Sets of nodes are those of the generators; indices of coarse cells become ids of the
  // triangulation.
  template <int dim>
  NodeSet<dim>
  Mesh<dim>::node_set(const std::string &name) const
  {
    std::vector<std::string> known;
    for (unsigned int body = 0; body < n_bodies(); ++body)
      {
        const std::string start = names[body] + ".";
        for (const std::string &set : generators[body]->node_sets())
          known.push_back(start + set);
        if (name.compare(0, start.size(), start) != 0)
          continue;
        // Names of sets have the form BODY.SET. A set without nodes counts as unknown.
        NodeSet<dim> nodes = generators[body]->node_set(name.substr(start.size()));
        for (auto &places : nodes.nodes)
          for (NodeLocation<dim> &place : places)
            place.cell = coarse_ids[first_cells[body] + place.cell];
        for (NodeLocation<dim> &place : nodes.left_out)
          place.cell = coarse_ids[first_cells[body] + place.cell];
        if (!nodes.nodes.empty())
          return nodes;
      }
    throw SceneError("there is no set of nodes '" + name + "'; " +
                     (known.empty() ? "no body has any" : "there are " + join(known)));
  }



  // A body itself, or a set of cells of its generator.
  template <int dim>
  std::set<types::coarse_cell_id>
  Mesh<dim>::cell_set(const std::string &name) const
  {
    std::set<types::coarse_cell_id> result;
    for (unsigned int body = 0; body < n_bodies(); ++body)
      {
        const std::string start = names[body] + ".";
        // The coarse cells of a body are consecutive in the order of creation.
        const unsigned int first = first_cells[body],
                           end = body + 1 < n_bodies() ? first_cells[body + 1] : coarse_ids.size();
        if (name == names[body])
          result.insert(coarse_ids.begin() + first, coarse_ids.begin() + end);
        else if (name.compare(0, start.size(), start) == 0)
          for (const unsigned int cell : generators[body]->cell_set(name.substr(start.size())))
            result.insert(coarse_ids[first + cell]);
      }
    if (result.empty())
      throw SceneError("there is no body and no set of cells '" + name + "'");
    return result;
  }



  // p4est reorders coarse cells. Lists by the order of creation become lists by coarse-cell ids.
  template <int dim>
  void
  Mesh<dim>::number_coarse_cells(const Triangulation<dim> &triangulation)
  {
    std::vector<unsigned int> of_ids(piece_of_coarse_cell.size());
    coarse_ids.resize(of_ids.size());
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      {
        // The index of a cell on level 0 is its number in the order of creation; with p4est, the id
        // of a coarse cell is the number of its tree.
        coarse_ids[cell->index()]         = cell->id().get_coarse_cell_id();
        of_ids[coarse_ids[cell->index()]] = piece_of_coarse_cell[cell->index()];
      }
    piece_of_coarse_cell = of_ids;
    my_temperature.number(coarse_ids);
  }



  template <int dim>
  const BoundingBox<dim> &
  Mesh<dim>::extent(const unsigned int body) const
  {
    return body == numbers::invalid_unsigned_int ? whole_extent : extents[body];
  }



  // Bounding boxes of the vertices of all ranks, in the reference configuration.
  template <int dim>
  void
  Mesh<dim>::measure()
  {
    std::vector<Extent<dim>> of_bodies(n_bodies());
    Extent<dim>              of_all;
    for (const auto &cell : tria->active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          {
            of_bodies[body(cell)].add(cell->vertex(v));
            of_all.add(cell->vertex(v));
          }
    for (const Extent<dim> &one : of_bodies)
      extents.push_back(one.reduce_over_ranks(communicator()));
    whole_extent = of_all.reduce_over_ranks(communicator());
  }



  template <int dim>
  double
  Mesh<dim>::size() const
  {
    const auto &[low, high] = whole_extent.get_boundary_points();
    return low.distance(high);
  }



  template struct RefinementRegion<2>;
  template struct RefinementRegion<3>;
  template struct MeshSettings<2>;
  template struct MeshSettings<3>;
  template class Mesh<2>;
  template class Mesh<3>;
} // namespace Signorini
