// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/decks/deck_model.h"
#include "mesh_import/decks/history_groups.h"
#include "mesh_import/pieces.h"

#include <deal.II/base/point.h>

#include <iosfwd>
#include <optional>

namespace Signorini
{
  /// Writes the scene of a deck's model section by section: bodies are found in deck_bodies.cc, and
  /// written with contact pairs in scene_bodies.cc; supports and loads are in scene_loads.cc, sets
  /// in scene_sets.cc.
  class SceneWriter
  {
  public:
    /// Find the bodies. Throws SceneError if no elastic solid is left.
    /// @param model of the deck
    /// @param file its path, to which the scene refers
    SceneWriter(DeckModel model, const std::string &file);

    /// Write the scene. May be called once.
    /// @param scene the stream
    void
    write(std::ostream &scene);

    /// @return what was omitted, one line for each item.
    std::vector<std::string>
    skipped_items() const;

  private:
    /// The material of a set of cells.
    struct MaterialOfCells
    {
      std::string material, cells;
    };

    /// A connected piece of the mesh.
    struct Body
    {
      std::string name, part, material;
      /// Materials of sets of its cells, of which later ones have priority.
      std::vector<MaterialOfCells> others;
      std::vector<bool>            has_node, has_element;
      /// Names of the surfaces and sets that have faces of it.
      std::set<std::string> boundaries;
      double                thickness           = 1;
      bool                  is_quadratic        = false;
      double                initial_temperature = 0;
      /// Its temperature; empty without thermal strain.
      DeckModel::Curve temperature;

      /// Sets that the scene defines in addition to those of the deck, as values of keys of the
      /// body.
      std::vector<std::string> node_sets, face_sets, cell_sets;
    };

    /// @return a name without characters that have a meaning in scene files.
    static std::string
    as_name(std::string name);

    void
    make_bodies();
    bool
    write_material(Body &body, const Piece &piece);
    void
    write_other_materials(Body &body);
    void
    check_plane() const;
    void
    skip_other_elements();
    bool
    switches_to_finite_strain();
    void
    write_temperature(Body &body);
    void
    skip_continuing_amplitudes(const DeckModel::Curve &curve);
    std::set<std::string>
    boundaries_of(const Piece &piece) const;

    std::string
    bodies() const;
    std::vector<std::pair<std::string, std::string>>
    material_keys(const DeckModel::Material &material) const;
    std::string
    supports();
    std::string
    loads();
    std::vector<SceneItem>
    forces();
    std::vector<SceneItem>
    pressures();
    std::vector<SceneItem>
    body_forces();
    std::vector<SceneItem>
    gravity();
    /// Motion, forces and moments of a reference node, formulas by component.
    struct Reference
    {
      std::vector<std::string> place, motion, rotation, force, moment;
      bool                     is_held = false; ///< any component of the motion is prescribed
    };
    Reference
    reference(const DeckModel::Coupling &one);
    std::optional<unsigned int>
    only_axis(const DeckModel::Coupling &one) const;
    std::string
    obstacles();
    /// The whole faces of solids of a coupling, and the number of its nodes that are on none.
    struct CoupledFaces
    {
      std::vector<DeckModel::Face> faces;
      std::size_t                  n_other_nodes = 0;
    };
    CoupledFaces
    coupled_faces(const DeckModel::Coupling &one) const;
    std::string
    coupled_surfaces(const DeckModel::Coupling &one);
    std::string
    component_at(const DeckModel::NodeCurves &curves,
                 unsigned int                 node,
                 unsigned int                 component,
                 const std::string           &otherwise,
                 double                       factor);
    std::string
    equations();
    std::vector<std::string>
    names_of_nodes() const;
    void
    add_mean_equations(const DeckModel::Coupling &one);
    bool
    add_coupling_equations(const DeckModel::Coupling &one, const Reference &acting);
    /// By node, the terms of the components of the force on it, formulas.
    using Forces = std::map<unsigned int, std::array<std::vector<std::string>, 3>>;
    void
    add_forces_on_nodes(const std::string              &of,
                        const Forces                   &forces,
                        const std::vector<std::string> &names);
    double
    mean_distance(const DeckModel::Coupling &one) const;
    bool
    defines_only(const DeckModel::Equation &equation, const DeckModel::EquationTerm &term) const;
    dealii::Tensor<1, 3>
    direction_of(unsigned int node, unsigned int component) const;
    void
    write_pretensions();
    dealii::Tensor<1, 3>
    normal_of(const std::string &surface) const;
    void
    forget_reference_nodes();
    std::string
    pairs();
    std::string
    steps() const;
    std::string
    unconstrained_modes() const;

    std::string
    kind_at_no_solid(const MemberGroup &group, const std::string &what);
    std::string
    nodes_of(const MemberGroup &group, const std::string &target, const std::string &what);
    std::string
    faces_of(const std::vector<DeckModel::Face> &faces, const std::string &name);
    std::string
    cells_of(const std::vector<unsigned int> &elements, const std::string &name);
    std::map<DeckModel::Face, unsigned int>
    cells_at_faces() const;
    void
    skip_internal_pressures();
    std::vector<double>
    densities() const;
    bool
    is_a_node(const DeckModel::AtNodes &at) const;
    std::string
    surfaces(const std::string &surface, const std::string &what);
    std::vector<std::string>
    masters_on(const DeckModel::Coupling &one) const;
    bool
    add_rigid_surfaces(const DeckModel::Coupling &one,
                       const Reference           &at,
                       SetNames                  &names,
                       std::vector<SceneItem>    &items);
    bool
    is_removed(const std::string &surface) const;
    double
    thickness_at(const std::vector<unsigned int> &nodes) const;
    std::string
    formula(const DeckModel::Points &points, double factor = 1) const;
    std::optional<std::vector<std::pair<std::string, std::string>>>
    axes_keys(const DeckModel::AtNodes &at, const std::string &what);
    std::string
    plane_or_space(const std::array<double, 3> &v) const;
    std::vector<std::pair<std::string, std::string>>
    sector_keys(const DeckModel::Pair &pair) const;
    dealii::Point<3>
    middle_of(const std::string &surface) const;
    std::vector<std::pair<std::string, std::string>>
    interaction_keys(const DeckModel::Interaction &one) const;
    void
    divide_by_times(const DeckModel::Pair  &pair,
                    double                  begin,
                    double                  end,
                    SetNames               &names,
                    std::vector<SceneItem> &items) const;
    std::string
    vector_formula(const MemberGroup &group, const std::string &otherwise, double factor = 1) const;
    const DeckModel::History &
    history(unsigned int id);
    bool
    has_content(const MemberGroup &group);
    void
    limit_steps_at_kinks();
    void
    skip_paths_of_late_supports();
    void
    end_steps_at_kinks(const DeckModel::History &history);

    DeckModel         model;
    const std::string file;
    unsigned int      dim = 3;
    /// The two-dimensional model: "plane strain", "plane stress" or "axisymmetric".
    std::string       kind;
    unsigned int      n_pieces         = 0;
    bool              is_finite_strain = false;
    std::vector<Body> all;

    /// The histories of the model.
    Histories histories;
    /// Names of the sets of the deck and of the scene.
    SetNames set_names;
    /// Times within steps at which loads and supports have kinks.
    std::set<double> kinks;
    /// Pairs of rigid couplings, loads of distributing ones.
    std::vector<SceneItem> coupled_pairs, coupled_loads;
    /// Obstacles by the masters, in upper case, that are surfaces of rigid bodies.
    std::map<std::string, std::string> rigid_masters;
    /// Nodes on no body whose motions or forces equations contain.
    std::set<unsigned int> nodes_in_equations;
    /// Supports that begin in a later step, with their times.
    std::vector<std::pair<std::string, double>> late_supports;
  };
} // namespace Signorini
