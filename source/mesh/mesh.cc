#include <signorini/mesh/extent.h>
#include <signorini/mesh/mesh.h>
#include <signorini/mesh/transformed_manifold.h>
#include <signorini/parameters/section.h>

#include <deal.II/distributed/fully_distributed_tria.h>
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
  RefinementZone<dim>::declare(Section &section)
  {
    section.add("Where",
                where,
                "cells are refined where this function of the coordinates is positive");
    section.add("Bodies", bodies, "only cells of these bodies; empty: all");
    section.add("Times", times, "how often");
    place = section.place_of("Bodies");
  }



  template <int dim>
  void
  MeshSettings<dim>::declare(Section &section)
  {
    section.add_choice("Distribution",
                       distribution,
                       {"p4est", "METIS"},
                       "who distributes the cells; METIS has a fixed mesh");
    section.add("Refinements", refinements, "how often all cells are halved at the start");
    section.add("Contact refinements",
                contact_refinements,
                "how often cells at contact surfaces are halved, after that");
    section.add(
      "Slave face weight",
      slave_face_weight,
      "work of contact on a slave face, in units of the work on a cell: ranks get equal sums",
      Range{0, 1000});
    section.add("Geometry degree",
                geometry_degree,
                "polynomial degree of the cells' shape; 0: 1 if all is straight, else 2",
                Range{0, 4});
    section.add_named("Zones", zones, "Parts of space that are refined, after that.");
  }



  namespace
  {
    // A fully distributed triangulation ends at its ghost cells: where their neighbours are
    // missing, it has false boundary faces with id 0. None of ours may be taken for them.
    constexpr types::boundary_id first_boundary_id = 1;

    template <typename Object>
    void
    shift(std::vector<Object>     &objects,
          const unsigned int       first_vertex,
          const types::manifold_id first_manifold)
    {
      for (Object &object : objects)
        {
          for (unsigned int &vertex : object.vertices)
            vertex += first_vertex;
          if (object.manifold_id != numbers::flat_manifold_id)
            object.manifold_id += first_manifold;
        }
    }

    template <typename Object>
    void
    shift_boundary(std::vector<Object> &objects, const types::boundary_id first)
    {
      for (Object &object : objects)
        if (object.boundary_id != numbers::internal_face_boundary_id)
          object.boundary_id += first;
    }

    template <typename T>
    void
    append(std::vector<T> &to, const std::vector<T> &from)
    {
      to.insert(to.end(), from.begin(), from.end());
    }

    template <int dim, typename Wanted>
    void
    refine_where(Triangulation<dim> &triangulation, const unsigned int times, const Wanted &wanted)
    {
      for (unsigned int i = 0; i < times; ++i)
        {
          for (const auto &cell : triangulation.active_cell_iterators())
            if (!cell->is_artificial() && wanted(cell))
              cell->set_refine_flag();
          triangulation.execute_coarsening_and_refinement();
        }
    }

    /// Cells count once, and once more per slave face times its weight. A cell that is being
    /// refined is asked for each of its children, half of which are at a face of it.
    template <int dim>
    void
    weigh(Triangulation<dim>                    &triangulation,
          const std::vector<types::boundary_id> &slaves,
          const double                           slave_face_weight)
    {
      constexpr unsigned int unit = 10; // of integer weights, whose sum METIS has 32 bits for
      triangulation.signals.weight.connect(
        [slaves, slave_face_weight](const auto &cell, const auto status) -> unsigned int {
          unsigned int n_slaves = 0;
          if (cell->at_boundary())
            for (const auto &face : cell->face_iterators())
              n_slaves += face->at_boundary() &&
                          std::count(slaves.begin(), slaves.end(), face->boundary_id()) > 0;
          const bool is_itself = status == Triangulation<dim>::CELL_PERSIST ||
                                 status == Triangulation<dim>::CELL_COARSEN;
          return unit * (1 + n_slaves * slave_face_weight * (is_itself ? 1. : 0.5));
        });
    }

    template <int dim>
    bool
    touches(const RefinementZone<dim>                               &zone,
            const typename Triangulation<dim>::active_cell_iterator &cell)
    {
      for (const unsigned int v : cell->vertex_indices())
        if (zone.where.value(cell->vertex(v)) > 0)
          return true;
      return zone.where.value(cell->center()) > 0;
    }
  } // namespace



  template <int dim>
  Mesh<dim>::Mesh(const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
                  const MeshSettings<dim>                                  &settings,
                  const std::vector<std::pair<std::string, std::string>>   &contact_surfaces,
                  const MPI_Comm                                            comm)
  {
    const CoarseMesh<dim> coarse = merge(bodies);
    if (settings.geometry_degree > 0)
      degree = settings.geometry_degree;
    my_mappings.push_back(MappingQ<dim>(degree));
    std::vector<types::boundary_id> slaves;
    for (const auto &[slave, master] : contact_surfaces)
      slaves.push_back(boundary_id(slave));

    if (settings.distribution == "p4est")
      {
        tria = std::make_unique<parallel::distributed::Triangulation<dim>>(comm);
        weigh(*tria, slaves, settings.slave_face_weight);
        create(*tria, coarse);
        refine_initially(*tria, bodies, settings, contact_surfaces);
      }
    else
      {
        Triangulation<dim> serial(Triangulation<dim>::limit_level_difference_at_vertices);
        weigh(serial, slaves, settings.slave_face_weight);
        create(serial, coarse);
        refine_initially(serial, bodies, settings, contact_surfaces);
        std::vector<std::pair<types::boundary_id, types::boundary_id>> pairs;
        for (const auto &[slave, master] : contact_surfaces)
          if (!master.empty())
            pairs.emplace_back(boundary_id(slave), boundary_id(master));
        partition_by_metis(serial, Utilities::MPI::n_mpi_processes(comm), pairs);
        const auto description =
          TriangulationDescription::Utilities::create_description_from_triangulation(serial, comm);
        auto distributed = std::make_unique<parallel::fullydistributed::Triangulation<dim>>(comm);
        for (const auto &[id, manifold] : coarse.manifolds)
          distributed->set_manifold(id, *manifold);
        distributed->create_triangulation(description);
        tria = std::move(distributed);
      }
    measure();
  }



  template <int dim>
  CoarseMesh<dim>
  Mesh<dim>::merge(const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies)
  {
    CoarseMesh<dim> all;
    for (const auto &[name, body] : bodies)
      {
        CoarseMesh<dim> one       = body.generator->generate();
        bool            is_curved = body.generator->curved();
        if (!body.transformation.empty())
          is_curved = transform(one, is_curved, body.transformation);
        if (is_curved)
          degree = 2;

        const types::manifold_id first_manifold =
          all.manifolds.empty() ? 0 : all.manifolds.rbegin()->first + 1;
        for (const auto &[id, manifold] : one.manifolds)
          all.manifolds[first_manifold + id] = manifold;

        shift(one.cells, all.vertices.size(), first_manifold);
        shift(one.faces.boundary_lines, all.vertices.size(), first_manifold);
        shift(one.faces.boundary_quads, all.vertices.size(), first_manifold);
        shift_boundary(one.faces.boundary_lines, first_boundary_id + boundary_names.size());
        shift_boundary(one.faces.boundary_quads, first_boundary_id + boundary_names.size());
        for (CellData<dim> &cell : one.cells)
          cell.material_id = names.size();

        append(all.vertices, one.vertices);
        append(all.cells, one.cells);
        append(all.faces.boundary_lines, one.faces.boundary_lines);
        append(all.faces.boundary_quads, one.faces.boundary_quads);
        for (const std::string &boundary : one.boundaries)
          boundary_names.push_back(name + "." + boundary);
        names.push_back(name);
      }
    return all;
  }



  template <int dim>
  void
  Mesh<dim>::create(Triangulation<dim> &triangulation, const CoarseMesh<dim> &coarse) const
  {
    for (const auto &[id, manifold] : coarse.manifolds)
      triangulation.set_manifold(id, *manifold);
    triangulation.create_triangulation(coarse.vertices, coarse.cells, coarse.faces);
  }



  template <int dim>
  void
  Mesh<dim>::refine_initially(
    Triangulation<dim>                                       &triangulation,
    const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
    const MeshSettings<dim>                                  &settings,
    const std::vector<std::pair<std::string, std::string>>   &contact_surfaces) const
  {
    triangulation.refine_global(settings.refinements);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      refine_where(triangulation, bodies[b].second.refinements, [b](const auto &cell) {
        return cell->material_id() == b;
      });

    std::vector<types::boundary_id> surfaces;
    for (const auto &[slave, master] : contact_surfaces)
      for (const std::string &surface : {slave, master})
        if (!surface.empty())
          surfaces.push_back(boundary_id(surface));
    refine_where(triangulation, settings.contact_refinements, [&](const auto &cell) {
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            std::count(surfaces.begin(), surfaces.end(), cell->face(f)->boundary_id()))
          return true;
      return false;
    });

    for (const RefinementZone<dim> &zone : settings.zones)
      refine_where(triangulation, zone.times, [&](const auto &cell) {
        return touches<dim>(zone, cell) &&
               (zone.bodies.empty() ||
                std::count(zone.bodies.begin(), zone.bodies.end(), names[cell->material_id()]));
      });
  }



  template <int dim>
  types::boundary_id
  Mesh<dim>::boundary_id(const std::string &name) const
  {
    const auto found = std::find(boundary_names.begin(), boundary_names.end(), name);
    if (found == boundary_names.end())
      throw SceneError("there is no boundary '" + name + "'; the boundaries are " +
                       join(boundary_names));
    return first_boundary_id + (found - boundary_names.begin());
  }



  template <int dim>
  const BoundingBox<dim> &
  Mesh<dim>::extent(const unsigned int body) const
  {
    return body == numbers::invalid_unsigned_int ? whole_extent : extents[body];
  }



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
            of_bodies[cell->material_id()].add(cell->vertex(v));
            of_all.add(cell->vertex(v));
          }
    for (const Extent<dim> &one : of_bodies)
      extents.push_back(one.over_ranks(communicator()));
    whole_extent = of_all.over_ranks(communicator());
  }



  template <int dim>
  double
  Mesh<dim>::size() const
  {
    const auto &[low, high] = whole_extent.get_boundary_points();
    return low.distance(high);
  }



  template struct RefinementZone<2>;
  template struct RefinementZone<3>;
  template struct MeshSettings<2>;
  template struct MeshSettings<3>;
  template class Mesh<2>;
  template class Mesh<3>;
} // namespace Signorini
