// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/coarse_field.h"
#include <signorini/mesh/body_mesh.h>
#include <signorini/mesh/mesh_settings.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/grid/tria.h>
#include <deal.II/hp/mapping_collection.h>

#include <optional>
#include <set>

namespace Signorini
{
  /// Boundary ids: those of the faces that have a name.
  using BoundaryIds = std::set<dealii::types::boundary_id>;

  /// Cells of one body that are connected with each other, and with no others.
  template <int dim>
  struct BodyPiece
  {
    unsigned int             body;
    std::string              name; ///< of the body, or "BODY, piece 2 of 3 about (x y)"
    dealii::BoundingBox<dim> extent;
  };

  /// The bodies' meshes, apart from each other, in one distributed triangulation. Material ids
  /// count their materials, body by body. Boundary ids count from 1; a boundary has one or more of
  /// them, and may share some with others.
  template <int dim>
  class Mesh
  {
  public:
    /// @param bodies mesh of each body, and its name
    /// @param contact_surfaces boundaries ("body.boundary") that take part in contact, in pairs
    /// (slave, master); the master is empty for an obstacle.
    Mesh(const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
         const MeshSettings<dim>                                  &settings,
         const std::vector<std::pair<std::string, std::string>>   &contact_surfaces,
         MPI_Comm                                                  comm);

    Mesh(Mesh &&) = delete; // the triangulation calls map_cells()

    const dealii::parallel::DistributedTriangulationBase<dim> &
    triangulation() const
    {
      return *tria;
    }

    /// Needed to refine; the distribution METIS has a fixed mesh and refuses.
    dealii::parallel::DistributedTriangulationBase<dim> &
    triangulation()
    {
      return *tria;
    }

    /// The level of the cells that the scene speaks of, by body: coarser ones are there for
    /// multigrid.
    unsigned int
    least_level(const unsigned int body) const
    {
      return my_least_levels[body];
    }

    /// The shape of the cells: no richer than the displacement of their body, so that rigid motions
    /// are free of strain.
    const dealii::Mapping<dim> &
    mapping() const
    {
      return my_mappings[0];
    }

    /// The displacement has other degrees now, one a body: the cells of curved ones follow, if the
    /// scene does not say what they are. Collective.
    void
    set_degrees(const std::vector<unsigned int> &degrees);

    /// The true shape of the boundaries, up to a polynomial of degree surface_degree(): gaps,
    /// normals and loads are those of the surfaces that generators and files describe, not of the
    /// cells.
    const dealii::Mapping<dim> &
    surface_mapping() const
    {
      return my_surface_mappings[0];
    }

    const dealii::hp::MappingCollection<dim> &
    surface_mappings() const
    {
      return my_surface_mappings;
    }

    unsigned int
    surface_degree() const
    {
      return degree_of_surfaces;
    }

    /// The same as a collection, for elements of different degree.
    const dealii::hp::MappingCollection<dim> &
    mappings() const
    {
      return my_mappings;
    }

    unsigned int
    geometry_degree() const
    {
      return degree;
    }

    MPI_Comm
    communicator() const
    {
      return tria->get_communicator();
    }

    /// Bounding box of the vertices of one body, or of all, in the initial mesh.
    const dealii::BoundingBox<dim> &
    extent(unsigned int body = dealii::numbers::invalid_unsigned_int) const;

    /// Diagonal of the bounding box of all bodies.
    double
    size() const;

    unsigned int
    n_bodies() const
    {
      return names.size();
    }

    const std::string &
    body_name(unsigned int body) const
    {
      return names[body];
    }

    /// Material ids, of which a body has one and one more for each of BodyMesh::cells_of_materials.
    unsigned int
    n_materials() const
    {
      return bodies_of_materials.size();
    }

    unsigned int
    body_of_material(const unsigned int id) const
    {
      return bodies_of_materials[id];
    }

    /// The material id of the cells of a body that are in no set with a material of its own.
    unsigned int
    own_material(const unsigned int body) const
    {
      return own_materials[body];
    }

    /// The body that a cell, on any level, belongs to.
    template <typename Cell>
    unsigned int
    body(const Cell &cell) const
    {
      return bodies_of_materials[cell->material_id()];
    }

    /// The body of the boundary "body.boundary"; none if there is no such boundary.
    std::optional<unsigned int>
    body_of(const std::string &boundary) const;

    /// Boundary ids of "body.boundary". Throws SceneError naming the boundaries there are.
    const BoundaryIds &
    boundary_ids(const std::string &name) const;

    /// The steepest facet of "body.boundary" that stands for a curved surface; height 0: none does.
    FacetHeight
    facet_height(const std::string &boundary) const;

    const std::vector<std::string> &
    boundaries() const
    {
      return boundary_names;
    }

    /// One more than the largest boundary id.
    unsigned int
    end_of_boundary_ids() const
    {
      return n_ids + 1;
    }

    /// The connected pieces of all bodies, body by body.
    const std::vector<BodyPiece<dim>> &
    pieces() const
    {
      return my_pieces;
    }

    /// The number of the piece that a cell, coarse or not, belongs to.
    template <typename Cell>
    unsigned int
    piece(const Cell &cell) const
    {
      return piece_of_coarse_cell[cell->id().get_coarse_cell_id()];
    }

    /// The nodes of the set "body.SET", by their places in coarse cells. Throws SceneError naming
    /// the sets there are.
    NodeSet<dim>
    node_set(const std::string &name) const;

    /// The coarse cells of "body", or of the set "body.SET", by their ids. Throws SceneError if
    /// there is no such set.
    std::set<dealii::types::coarse_cell_id>
    cell_set(const std::string &name) const;

    /// The temperatures of the bodies whose generators provide them.
    const CoarseField<dim> &
    temperature() const
    {
      return my_temperature;
    }

  private:
    /// @param merges_cells as far as generators can, see MeshGenerator::possible_merges()
    CoarseMesh<dim>
    merge(const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies, bool merges_cells);
    void
    number_materials(std::vector<dealii::CellData<dim>> &cells, const BodyMesh<dim> &body);
    void
    create(dealii::Triangulation<dim> &triangulation, const CoarseMesh<dim> &coarse) const;
    void
    refine_initially(
      dealii::Triangulation<dim>                               &triangulation,
      const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
      const MeshSettings<dim>                                  &settings,
      const std::vector<std::pair<std::string, std::string>>   &contact_surfaces) const;

    void
    measure();

    /// Makes mapping() of degree_of_body, and of the cells that there are. Collective.
    void
    map_cells();

    void
    find_pieces(const CoarseMesh<dim> &coarse);
    /// The ids by which cells know their coarse cells: p4est has an order of its own.
    void
    number_coarse_cells(const dealii::Triangulation<dim> &triangulation);
    void
    check_slaves_and_masters(
      const std::vector<std::pair<std::string, std::string>> &contact_surfaces) const;

    std::vector<std::string>                               names, boundary_names;
    std::vector<unsigned int>                              bodies_of_materials; ///< by their ids
    std::vector<unsigned int>                              own_materials;       ///< of bodies
    std::vector<BoundaryIds>                               ids_of_names;
    std::vector<FacetHeight>                               facets;           ///< of boundaries
    std::vector<unsigned int>                              body_of_boundary; ///< of names
    unsigned int                                           n_ids = 0;
    std::vector<BodyPiece<dim>>                            my_pieces;
    std::vector<dealii::types::coarse_cell_id>             coarse_ids;           ///< of all bodies
    std::vector<unsigned int>                              piece_of_coarse_cell; ///< by its id
    std::vector<unsigned int>                              first_cells; ///< of the bodies, coarse
    std::vector<std::shared_ptr<const MeshGenerator<dim>>> generators;
    CoarseField<dim>                                       my_temperature;
    unsigned int                                           degree = 1, degree_of_surfaces = 1;
    std::vector<unsigned int>                              degree_of_body; ///< of its cells
    std::vector<bool>                                      is_curved; ///< body, with cells to match
    std::vector<unsigned int>                              my_least_levels;
    std::vector<dealii::BoundingBox<dim>>                  extents; ///< of the bodies
    dealii::BoundingBox<dim>                               whole_extent;

    std::unique_ptr<dealii::parallel::DistributedTriangulationBase<dim>> tria;
    dealii::hp::MappingCollection<dim> my_mappings, my_surface_mappings;
  };

  /// Partition a serial triangulation by METIS into `n_parts`, so that cells that face each other
  /// across a contact pair stay together where possible: such pairs are edges of the graph as
  /// neighbours are.
  template <int dim>
  void
  partition_by_metis(dealii::Triangulation<dim>                             &triangulation,
                     unsigned int                                            n_parts,
                     const std::vector<std::pair<BoundaryIds, BoundaryIds>> &pairs);
} // namespace Signorini
