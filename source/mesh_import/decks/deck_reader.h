// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/decks/deck_model.h"

#include <set>

namespace Signorini
{
  /// Reads the keywords that make the model, after those of the mesh: a small function each, in the
  /// registry of deck_reader.cc; those of supports and loads stand in deck_loads.cc.
  class DeckReader
  {
  public:
    explicit DeckReader(const std::string &file_name);

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
    skip_tie();
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
    read_surface_loads();
    void
    read_transform();
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
    read_behaviour();
    void
    read_pairs();
    void
    read_clearance();

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
    counts();
    /// Other parameters of the present keyword are left out.
    void
    check_parameters(const std::set<std::string> &known);
    bool
    accepts_type();
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

    KeywordFile            in;
    DeckModel              model;
    std::string            material, part, interaction;
    bool                   in_step = false, step_counts = false;
    bool                   is_again        = false; ///< the material stands above too
    unsigned int           n_element_loads = 0;
    std::set<unsigned int> transformed; ///< nodes with axes of their own
    /// Where the entry of a node or set is in a list of the model.
    std::map<std::pair<const void *, std::string>, std::size_t> places;
    std::set<std::string>
      reported_kinds; ///< kinds of loads and supports of which this step has cards
  };
} // namespace Signorini
