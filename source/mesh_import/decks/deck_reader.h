// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/decks/deck_model.h"

#include <set>

namespace Signorini
{
  /// Reads the keywords that define the model, after those of the mesh, each by a function of its
  /// own. The registry in deck_reader.cc maps keywords to functions; those of materials, supports,
  /// loads and contact are in files of their own (deck_materials.cc and so on).
  class DeckReader
  {
  public:
    /// Read the mesh. Throws SceneError with file and line.
    /// @param file_name path of the file
    explicit DeckReader(const std::string &file_name);

    /// Read the model. May be called once.
    /// @return mesh and model, which are moved out of the reader
    DeckModel
    read();

  private:
    using Words   = std::vector<std::string>;
    using Values  = std::vector<double>;
    using Members = std::vector<unsigned int>;
    using Curve   = DeckModel::Curve;

    void
    ignore();
    void
    skip_item(const std::string &why);
    void
    read_ties();
    void
    skip_stray_lines(const std::string &which);
    void
    begin_part();
    void
    end_part();

    // Materials
    void
    begin_material();
    void
    read_elastic();
    void
    read_hyperelastic();
    void
    read_density();
    void
    read_expansion();
    void
    read_section();

    // Steps
    void
    read_amplitude();
    void
    begin_step();
    void
    read_static();
    void
    read_quasi_static();
    void
    skip_step();
    void
    end_step();

    // Supports and loads
    void
    read_boundary();
    void
    add_symmetry(const std::string &target, const std::string &kind);
    void
    read_forces();
    void
    read_element_loads();
    void
    remove_distributed();
    void
    add_pressure(const std::string &surface, double value);
    void
    add_body_load(const Words &words);
    void
    add_gravity(const Words &words);
    void
    add_centrifugal_load(const Words &words);
    std::array<double, 3>
    direction(const Words &words, unsigned int first) const;
    void
    add_body_load(DeckModel::BodyLoad load, double size);
    void
    read_surface_loads();
    void
    read_transform();
    void
    read_orientation();
    void
    read_initial_conditions();
    void
    read_temperatures();
    void
    read_temperatures_of_nodes(DeckModel::Temperatures &temperatures);

    // Contact
    void
    begin_interaction();
    void
    begin_change_of_behaviour();
    std::string
    present_interaction(const std::string &name) const;
    void
    read_behaviour();
    void
    read_soft_contact(bool is_table, const std::vector<Words> &lines, DeckModel::Interaction &one);
    void
    read_friction();
    void
    begin_change_of_friction();
    void
    change_friction();
    void
    read_pairs();
    void
    read_model_change();
    void
    read_sectors();
    std::array<double, 3>
    triple(const Words &words, unsigned int first) const;
    std::optional<unsigned int>
    axes_of(const std::vector<unsigned int> &nodes) const;
    void
    read_clearance();

    // Couplings
    void
    read_rigid_body();
    void
    read_analytical_surface();
    void
    begin_coupling();
    void
    end_coupling();
    void
    add_components(const Words &words, unsigned int at, DeckModel::Coupling &to) const;
    void
    read_kinematic_coupling();
    void
    read_distributing_coupling();
    void
    read_equations();
    void
    add_equations(const Words &terms);
    void
    read_mpcs();
    void
    add_mpc(const std::string &kind, const std::vector<unsigned int> &nodes);
    void
    read_pretension();
    void
    lock_pretensions();
    unsigned int
    node_of(const std::string &parameter);

    double
    number(const Words &words, unsigned int i) const;
    unsigned int
    component(const Words &words, unsigned int i) const;
    std::vector<unsigned int>
    nodes_of(const std::string &target);
    Members
    elements_of(const std::string &target);
    void
    skip_repetitions(const std::string &target, Members members);
    DeckModel::AtNodes *
    at_nodes(std::vector<DeckModel::AtNodes> &list, const std::string &target);
    void
    hold(const std::string &target, const std::vector<unsigned int> &components, double value);
    bool
    adds_moments(const std::string &target, unsigned int d, double value);
    bool
    holds_rotations(const std::string &target, unsigned int first, unsigned int last, double value);
    bool
    counts();
    /// Report parameters of the present keyword that are not among the known ones.
    void
    check_parameters(const std::set<std::string> &known);
    bool
    accepts_type();
    /// @return the number of the present step from 1; 0 for the model before all steps.
    unsigned int
    present_step() const
    {
      return in_step ? model.steps.size() : 0;
    }
    DeckModel::Change
    change_to(double value) const;
    void
    replace(Curve &curve, double value) const;
    void
    add(Curve &curve, double value) const;
    bool
    removes_old(const std::string &kind);
    void
    remove_old(Curve &curve) const;

    static const std::map<std::string, void (DeckReader::*)(), IgnoringBlanks> registry;
    static const std::map<std::string, std::string, IgnoringBlanks>            not_modelled;
    static const std::set<std::string, IgnoringBlanks> of_known_length, restraints;

    KeywordFile in;
    DeckModel   model;
    std::string material, part, interaction;
    /// The next *SURFACE BEHAVIOR is that of *CHANGE SURFACE BEHAVIOR.
    bool changes_behaviour = false;
    /// Of the last *COUPLING, whose kind the next keyword gives.
    DeckModel::Coupling coupling;
    bool                in_step = false, step_counts = false;
    /// Whether the present material has been defined before.
    bool         is_again        = false;
    unsigned int n_element_loads = 0;
    /// Index of the entry of a node or set in a list of the model, by list and name.
    std::map<std::pair<const void *, std::string>, std::size_t> places;
    std::set<std::string>
      /// Kinds of loads and supports for which the present step has had a keyword.
      reported_kinds;
  };
} // namespace Signorini
