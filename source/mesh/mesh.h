// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/coarse_field.h"
#include <signorini/mesh/body_mesh.h>
#include <signorini/mesh/mesh_settings.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/grid/tria.h>
#include <deal.II/hp/mapping_collection.h>

#include <algorithm>
#include <optional>
#include <set>

namespace Signorini
{
  /// The boundary ids of the faces that have a name.
  using BoundaryIds = std::set<dealii::types::boundary_id>;

  /// A connected component of a body.
  template <int dim>
  struct BodyPiece
  {
    unsigned int body;
    /// Name of the body, or "BODY, piece 2 of 3 about (x y)".
    std::string              name;
    dealii::BoundingBox<dim> extent;
  };

  /// The meshes of all bodies, without common nodes, in one distributed triangulation. Material ids
  /// number the materials, body by body. Boundary ids begin with 1; a boundary has one or more of
  /// them, and may share some with others.
  template <int dim>
  class Mesh
  {
  public:
    /// Create and refine the mesh. Throws SceneError if bodies cannot be meshed, or names do not
    /// exist. Collective.
    /// @param bodies name and mesh of each body
    /// @param settings of the mesh
    /// @param contact_surfaces boundaries ("body.boundary") that take part in contact, in pairs
    /// (slave, master); the master is empty for an obstacle
    /// @param comm the ranks among which the mesh is distributed
    Mesh(const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
         const MeshSettings<dim>                                  &settings,
         const std::vector<std::pair<std::string, std::string>>   &contact_surfaces,
         MPI_Comm                                                  comm);

    Mesh(Mesh &&) = delete; // the triangulation calls map_cells()

    /// @return the triangulation.
    const dealii::parallel::TriangulationBase<dim> &
    triangulation() const
    {
      return *tria;
    }

    /// @return the triangulation for refinement, which METIS does not allow.
    dealii::parallel::TriangulationBase<dim> &
    triangulation()
    {
      return *tria;
    }

    /// @return the level of the cells that correspond to the coarse cells of the scene; coarser
    /// cells exist for multigrid only.
    /// @param body its index
    unsigned int
    least_level(const unsigned int body) const
    {
      return my_least_levels[body];
    }

    /// @return the shape of the cells, which is not of higher degree than the displacement of their
    /// body, so that rigid-body motions cause no strain.
    const dealii::Mapping<dim> &
    mapping() const
    {
      return my_mappings[0];
    }

    /// Change the polynomial degrees of the displacement, which the cells of curved bodies follow
    /// unless the scene prescribes their degree. Collective.
    /// @param degrees one for each body
    void
    set_degrees(const std::vector<unsigned int> &degrees);

    /// @return the true shape of the boundaries, up to a polynomial of degree surface_degree():
    /// gaps, normals and loads are those of the surfaces that generators and files describe, not of
    /// the cells.
    const dealii::Mapping<dim> &
    surface_mapping() const
    {
      return my_surface_mappings[0];
    }

    /// @return surface_mapping() as a collection.
    const dealii::hp::MappingCollection<dim> &
    surface_mappings() const
    {
      return my_surface_mappings;
    }

    /// @return the polynomial degree of surfaces.
    unsigned int
    surface_degree() const
    {
      return degree_of_surfaces;
    }

    /// @return mapping() as a collection, for elements of different degree.
    const dealii::hp::MappingCollection<dim> &
    mappings() const
    {
      return my_mappings;
    }

    /// @return the largest polynomial degree of cells.
    unsigned int
    geometry_degree() const
    {
      return degree;
    }

    /// @return the ranks among which the mesh is distributed.
    MPI_Comm
    communicator() const
    {
      return tria->get_communicator();
    }

    /// @return the bounding box of the vertices of one body, or of all, in the initial mesh.
    /// @param body its index; invalid: all bodies
    const dealii::BoundingBox<dim> &
    extent(unsigned int body = dealii::numbers::invalid_unsigned_int) const;

    /// @return the diagonal [length] of the bounding box of all bodies.
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

    /// @return the number of material ids: each body has one, and one more for each of
    /// BodyMesh::cells_of_materials.
    unsigned int
    n_materials() const
    {
      return bodies_of_materials.size();
    }

    /// @return the index of the body to which a material id belongs.
    unsigned int
    body_of_material(const unsigned int id) const
    {
      return bodies_of_materials[id];
    }

    /// @return the material id of the cells of a body that are in no set with a material of its
    /// own.
    /// @param body its index
    unsigned int
    own_material(const unsigned int body) const
    {
      return own_materials[body];
    }

    /// @return the index of the body of a cell.
    /// @param cell on any level
    template <typename Cell>
    unsigned int
    body(const Cell &cell) const
    {
      return bodies_of_materials[cell->material_id()];
    }

    /// @return the shape of the cells of a body: a quadrilateral or hexahedron, or a triangle or
    /// tetrahedron.
    /// @param body its index
    dealii::ReferenceCell
    reference_cell(const unsigned int body) const
    {
      return is_of_simplices[body] ? dealii::ReferenceCells::get_simplex<dim>() :
                                     dealii::ReferenceCells::get_hypercube<dim>();
    }

    /// @return the shape of a coarse cell.
    /// @param id of the coarse cell
    dealii::ReferenceCell
    reference_cell_of(const dealii::types::coarse_cell_id id) const
    {
      return reference_cell(my_pieces[piece_of_coarse_cell[id]].body);
    }

    /// @return whether any body consists of triangles or tetrahedra.
    bool
    has_simplices() const
    {
      return std::count(is_of_simplices.begin(), is_of_simplices.end(), true) > 0;
    }

    /// @return whether any body consists of quadrilaterals or hexahedra.
    bool
    has_hypercubes() const
    {
      return std::count(is_of_simplices.begin(), is_of_simplices.end(), false) > 0;
    }

    /// @return the index of the body of a boundary; none if there is no such boundary.
    /// @param boundary "body.boundary"
    std::optional<unsigned int>
    body_of(const std::string &boundary) const;

    /// @return the boundary ids of a boundary. Throws SceneError, listing the boundaries, if there
    /// is none of that name.
    /// @param name "body.boundary"
    const BoundaryIds &
    boundary_ids(const std::string &name) const;

    /// @return the steepest facet that approximates a curved surface; height 0 if there is none.
    /// @param boundary "body.boundary"
    FacetHeight
    facet_height(const std::string &boundary) const;

    /// @return the names of all boundaries.
    const std::vector<std::string> &
    boundaries() const
    {
      return boundary_names;
    }

    /// @return one more than the largest boundary id.
    unsigned int
    end_of_boundary_ids() const
    {
      return n_ids + 1;
    }

    /// @return the connected pieces of all bodies, body by body.
    const std::vector<BodyPiece<dim>> &
    pieces() const
    {
      return my_pieces;
    }

    /// @return the number of the piece of a cell.
    /// @param cell on any level
    template <typename Cell>
    unsigned int
    piece(const Cell &cell) const
    {
      return piece_of_coarse_cell[cell->id().get_coarse_cell_id()];
    }

    /// @return the nodes of a set, with their positions in coarse cells. Throws SceneError, listing
    /// the sets, if there is none of that name.
    /// @param name "body.SET"
    NodeSet<dim>
    node_set(const std::string &name) const;

    /// @return the ids of the coarse cells of a body or set. Throws SceneError if there is none of
    /// that name.
    /// @param name "body" or "body.SET"
    std::set<dealii::types::coarse_cell_id>
    cell_set(const std::string &name) const;

    /// @return the temperatures of the bodies whose generators provide them.
    const CoarseField<dim> &
    temperature() const
    {
      return my_temperature;
    }

  private:
    /// @return the coarse meshes of all bodies in one.
    /// @param merges_cells whether cells are merged as far as generators can, see
    /// MeshGenerator::possible_merges()
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

    /// Compute the bounding boxes. Collective.
    void
    measure();

    /// Create mapping() from degree_of_body and the present cells. Collective.
    void
    map_cells();

    void
    find_pieces(const CoarseMesh<dim> &coarse);
    /// Determine the ids of coarse cells, since p4est reorders them.
    void
    number_coarse_cells(const dealii::Triangulation<dim> &triangulation);
    void
    check_for_simplices(const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
                        const MeshSettings<dim>                                  &settings) const;
    void
    check_slaves_and_masters(
      const std::vector<std::pair<std::string, std::string>> &contact_surfaces) const;

    std::vector<std::string> names, boundary_names;
    /// Index of the body, by material id.
    std::vector<unsigned int> bodies_of_materials;
    /// Material id of each body.
    std::vector<unsigned int> own_materials;
    std::vector<BoundaryIds>  ids_of_names;
    /// Steepest facet of each boundary.
    std::vector<FacetHeight> facets;
    /// Index of the body of each boundary.
    std::vector<unsigned int>   body_of_boundary;
    unsigned int                n_ids = 0;
    std::vector<BodyPiece<dim>> my_pieces;
    /// Ids of the coarse cells of all bodies, in their original order.
    std::vector<dealii::types::coarse_cell_id> coarse_ids;
    /// Number of the piece, by coarse cell id.
    std::vector<unsigned int> piece_of_coarse_cell;
    /// Index of the first coarse cell of each body.
    std::vector<unsigned int>                              first_cells;
    std::vector<std::shared_ptr<const MeshGenerator<dim>>> generators;
    CoarseField<dim>                                       my_temperature;
    unsigned int                                           degree = 1, degree_of_surfaces = 1;
    /// Degree of the cells of each body.
    std::vector<unsigned int> degree_of_body;
    /// Whether the cells of a body follow the degree of its displacement.
    std::vector<bool>         is_curved;
    std::vector<bool>         is_of_simplices; // by body
    std::vector<unsigned int> my_least_levels;
    /// Bounding box of each body.
    std::vector<dealii::BoundingBox<dim>> extents;
    dealii::BoundingBox<dim>              whole_extent;

    std::unique_ptr<dealii::parallel::TriangulationBase<dim>> tria;
    dealii::hp::MappingCollection<dim>                        my_mappings, my_surface_mappings;
  };

  /// Partition a serial triangulation by METIS, such that cells that face each other across a
  /// contact pair stay together where possible: such pairs are edges of the graph in the same way
  /// as neighbours are.
  /// @param triangulation whose subdomain ids are set
  /// @param n_parts number of parts
  /// @param pairs boundary ids of slave and master of each contact pair
  template <int dim>
  void
  partition_by_metis(dealii::Triangulation<dim>                             &triangulation,
                     unsigned int                                            n_parts,
                     const std::vector<std::pair<BoundaryIds, BoundaryIds>> &pairs);
} // namespace Signorini
