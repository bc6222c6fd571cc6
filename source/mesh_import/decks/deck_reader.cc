// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"

#include <signorini/parameters/raw.h>

namespace Signorini
{
  // One line for each keyword that is understood. Keywords for output, and those of the mesh, which
  // read_abaqus_deck() has processed before, have no effect here.
  const std::map<std::string, void (DeckReader::*)(), IgnoringBlanks> DeckReader::registry = {
    {"PART", &DeckReader::begin_part},
    {"END PART", &DeckReader::end_part},
    {"MATERIAL", &DeckReader::begin_material},
    {"ELASTIC", &DeckReader::read_elastic},
    {"HYPERELASTIC", &DeckReader::read_hyperelastic},
    {"DENSITY", &DeckReader::read_density},
    {"EXPANSION", &DeckReader::read_expansion},
    {"INITIAL CONDITIONS", &DeckReader::read_initial_conditions},
    {"SOLID SECTION", &DeckReader::read_section},
    {"AMPLITUDE", &DeckReader::read_amplitude},
    {"STEP", &DeckReader::begin_step},
    {"STATIC", &DeckReader::read_static},
    {"DYNAMIC", &DeckReader::read_quasi_static},
    {"MODAL DYNAMIC", &DeckReader::read_quasi_static},
    {"VISCO", &DeckReader::read_quasi_static},
    {"COUPLED TEMPERATURE-DISPLACEMENT", &DeckReader::read_quasi_static},
    {"UNCOUPLED TEMPERATURE-DISPLACEMENT", &DeckReader::read_quasi_static},
    {"FREQUENCY", &DeckReader::skip_step},
    {"COMPLEX FREQUENCY", &DeckReader::skip_step},
    {"BUCKLE", &DeckReader::skip_step},
    {"STEADY STATE DYNAMICS", &DeckReader::skip_step},
    {"HEAT TRANSFER", &DeckReader::skip_step},
    {"SENSITIVITY", &DeckReader::skip_step},
    {"GREEN", &DeckReader::skip_step},
    {"END STEP", &DeckReader::end_step},
    {"BOUNDARY", &DeckReader::read_boundary},
    {"CLOAD", &DeckReader::read_forces},
    {"DLOAD", &DeckReader::read_element_loads},
    {"DSLOAD", &DeckReader::read_surface_loads},
    {"TEMPERATURE", &DeckReader::read_temperatures},
    {"TRANSFORM", &DeckReader::read_transform},
    {"ORIENTATION", &DeckReader::read_orientation},
    {"SURFACE INTERACTION", &DeckReader::begin_interaction},
    {"SURFACE BEHAVIOR", &DeckReader::read_behaviour},
    {"FRICTION", &DeckReader::read_friction},
    {"CHANGE FRICTION", &DeckReader::begin_change_of_friction},
    {"CHANGE SURFACE BEHAVIOR", &DeckReader::begin_change_of_behaviour},
    {"CONTACT PAIR", &DeckReader::read_pairs},
    {"TIE", &DeckReader::read_ties},
    {"CLEARANCE", &DeckReader::read_clearance},
    {"MODEL CHANGE", &DeckReader::read_model_change},
    {"CYCLIC SYMMETRY MODEL", &DeckReader::read_sectors},
    {"RIGID BODY", &DeckReader::read_rigid_body},
    {"COUPLING", &DeckReader::begin_coupling},
    {"KINEMATIC", &DeckReader::end_coupling},
    {"DISTRIBUTING", &DeckReader::end_coupling},
    {"DISTRIBUTING COUPLING", &DeckReader::read_distributing_coupling},
    {"PRE-TENSION SECTION", &DeckReader::read_pretension},
    {"EQUATION", &DeckReader::read_equations},
    {"MPC", &DeckReader::read_mpcs},
    {"KINEMATIC COUPLING", &DeckReader::read_kinematic_coupling},
    {"HEADING", &DeckReader::ignore},
    {"PREPRINT", &DeckReader::ignore},
    {"NODE", &DeckReader::ignore},
    {"ELEMENT", &DeckReader::ignore},
    {"NSET", &DeckReader::ignore},
    {"ELSET", &DeckReader::ignore},
    {"SURFACE", &DeckReader::read_analytical_surface},
    {"NGEN", &DeckReader::ignore},
    {"NFILL", &DeckReader::ignore},
    {"NCOPY", &DeckReader::ignore},
    {"ELGEN", &DeckReader::ignore},
    {"ELCOPY", &DeckReader::ignore},
    {"SYSTEM", &DeckReader::ignore},
    {"ASSEMBLY", &DeckReader::ignore},
    {"END ASSEMBLY", &DeckReader::ignore},
    {"INSTANCE", &DeckReader::ignore},
    {"END INSTANCE", &DeckReader::ignore},
    {"NODE PRINT", &DeckReader::ignore},
    {"NODE FILE", &DeckReader::ignore},
    {"NODE OUTPUT", &DeckReader::ignore},
    {"EL PRINT", &DeckReader::ignore},
    {"EL FILE", &DeckReader::ignore},
    {"ELEMENT OUTPUT", &DeckReader::ignore},
    {"CONTACT PRINT", &DeckReader::ignore},
    {"CONTACT FILE", &DeckReader::ignore},
    {"CONTACT OUTPUT", &DeckReader::ignore},
    {"ENERGY OUTPUT", &DeckReader::ignore},
    {"SECTION PRINT", &DeckReader::ignore},
    {"FILE FORMAT", &DeckReader::ignore},
    {"OUTPUT", &DeckReader::ignore},
    {"PRINT", &DeckReader::ignore},
    {"MONITOR", &DeckReader::ignore},
    {"RESTART", &DeckReader::ignore},
    {"TIME POINTS", &DeckReader::ignore},
    {"CONTROLS", &DeckReader::ignore},
    {"NO ANALYSIS", &DeckReader::ignore},
    {"CONDUCTIVITY", &DeckReader::ignore},
    {"SPECIFIC HEAT", &DeckReader::ignore},
    {"PHYSICAL CONSTANTS", &DeckReader::ignore}};

  /// Reasons, for the report, why some keywords are skipped. All others that are not in the
  /// registry are skipped too.
  const std::map<std::string, std::string, IgnoringBlanks> DeckReader::not_modelled = {
    {"PLASTIC", "materials are linear elastic"},
    {"CREEP", "materials are linear elastic"},
    {"SHELL SECTION", "solids alone have stiffness"},
    {"BEAM SECTION", "solids alone have stiffness"},
    {"MEMBRANE SECTION", "solids alone have stiffness"},
    {"SPRING", "solids alone have stiffness"},
    {"MASS", "inertia"},
    {"DAMPING", "inertia"},
    {"CONTACT DAMPING", "inertia"}};

  /// Keywords without data lines, or with a known number of them: further lines are reported.
  const std::set<std::string, IgnoringBlanks> DeckReader::of_known_length = {
    "CLEARANCE", "END PART", "END STEP", "MATERIAL", "PART", "SOLID SECTION"};

  /// Keywords that may have constrained bodies that nothing else constrains.
  const std::set<std::string, IgnoringBlanks> DeckReader::restraints = {"EQUATION",
                                                                        "MPC",
                                                                        "KINEMATIC COUPLING",
                                                                        "SPRING",
                                                                        "MASS",
                                                                        "CONTACT DAMPING",
                                                                        "DAMPING",
                                                                        "DYNAMIC",
                                                                        "MODAL DYNAMIC",
                                                                        "SHELL SECTION",
                                                                        "BEAM SECTION",
                                                                        "MEMBRANE SECTION",
                                                                        "CYCLIC SYMMETRY MODEL",
                                                                        "PRE-TENSION SECTION"};



  DeckReader::DeckReader(const std::string &file_name)
    : in(file_name)
  {
    model.deck = read_abaqus_deck(file_name);
  }



  // The file is read twice: for the mesh by the constructor, and for the model here.
  DeckModel
  DeckReader::read()
  {
    skip_stray_lines("before the first keyword");
    while (in.next_keyword())
      {
        const auto found = registry.find(in.keyword());
        if (found != registry.end())
          (this->*found->second)();
        else
          {
            const auto why = not_modelled.find(in.keyword());
            skip_item(why == not_modelled.end() ? "not known here" : why->second);
          }
        if (of_known_length.count(in.keyword()) > 0)
          skip_stray_lines("that do not belong to *" + in.keyword());
      }
    // Names that the mesh reader did not find are reported with the omissions of the model; they
    // have no position of their own.
    for (const std::string &what : model.deck.missing)
      model.skip_item(what, "", "keyword");
    return std::move(model);
  }



  void
  DeckReader::ignore()
  {}



  // Report the present keyword with a reason.
  // If the keyword is one of `restraints`, bodies may be free to move without it, which the report
  // of the import mentions.
  void
  DeckReader::skip_item(const std::string &why)
  {
    model.skip_item("*" + in.keyword() + " (" + why + ")", in.current_position());
    model.lacks_supports |= restraints.count(in.keyword()) > 0;
  }



  // Report data lines where there should be none.
  void
  DeckReader::skip_stray_lines(const std::string &which)
  {
    for (Words words; in.next_line(words);)
      model.skip_item("data lines " + which, in.current_position(), "keyword");
  }



  void
  DeckReader::begin_part()
  {
    part = upper_case(in.value("NAME"));
  }



  void
  DeckReader::end_part()
  {
    part.clear();
  }



  // The number in a word of a data line; 0 if it is missing or empty.
  double
  DeckReader::number(const Words &words, const unsigned int i) const
  {
    return i < words.size() ? real_from(in, words[i]) : 0.;
  }



  // Three numbers, the first of them at a position of a data line.
  std::array<double, 3>
  DeckReader::triple(const Words &words, const unsigned int first) const
  {
    return {{number(words, first), number(words, first + 1), number(words, first + 2)}};
  }



  // Data lines: pairs of time and factor, any number on a line.
  // An amplitude of another kind is not stored at all, so that check_parameters() reports each
  // keyword that refers to it.
  void
  DeckReader::read_amplitude()
  {
    const std::string definition = upper_case(in.value("DEFINITION"));
    if (!definition.empty() && definition != "TABULAR")
      {
        skip_item("its DEFINITION=" + definition + "; what refers to it is ramped");
        return;
      }
    check_parameters({"NAME", "TIME", "DEFINITION", "VALUE", "INPUT"});
    if (upper_case(in.value("VALUE")) == "ABSOLUTE")
      skip_item("its VALUE=ABSOLUTE; values are factors");
    DeckModel::Amplitude &amplitude = model.amplitudes[upper_case(in.value("NAME"))];
    amplitude.is_total              = upper_case(in.value("TIME")) == "TOTAL TIME";
    DeckModel::Points  &points      = amplitude.points;
    std::vector<double> values;
    for (Words words; in.next_line(words);)
      for (const std::string &word : words)
        if (!word.empty())
          values.push_back(real_from(in, word));
    // A time without a factor at the end of the list is ignored.
    for (unsigned int i = 0; i + 1 < values.size(); i += 2)
      points.emplace_back(values[i], values[i + 1]);
  }



  // Each step lasts from the end of the previous one, by default for one unit of time. Perturbation
  // steps are skipped.
  void
  DeckReader::begin_step()
  {
    in_step              = true;
    step_counts          = !in.has("PERTURBATION");
    const bool is_finite = in.has("NLGEOM") && upper_case(in.value("NLGEOM")) != "NO";
    // Strain is small or finite for the whole scene, so that the first step with NLGEOM decides.
    if (is_finite && model.nlgeom.empty())
      {
        model.nlgeom = in.current_position();
        if (!model.steps.empty())
          skip_item("that strains are small in the steps before NLGEOM; they are large in all");
      }
    if (in.has("PERTURBATION"))
      model.skip_item("*STEP, PERTURBATION (the whole step)", in.current_position());
    if (step_counts)
      {
        const double begin = model.steps.empty() ? 0. : model.steps.back().end;
        model.steps.push_back({begin, begin + 1, upper_case(in.value("AMPLITUDE")) == "STEP"});
        reported_kinds.clear();
      }
  }



  // Data line: initial increment, duration of the step.
  // The initial increment is not used: the program chooses its own load steps within a step of the
  // deck. A duration that is missing or not positive leaves the default of one unit of time.
  void
  DeckReader::read_static()
  {
    for (const std::string other : {"RIKS", "TIME RESET", "TOTAL TIME AT START"})
      if (step_counts && in.has(other))
        model.skip_item("*STATIC (its " + other + ")", in.current_position(), "load");
    Words words;
    if (step_counts && in.next_line(words) && number(words, 1) > 0)
      model.steps.back().end = model.steps.back().begin + number(words, 1);
  }



  // Other analyses are computed as static ones, which is reported.
  void
  DeckReader::read_quasi_static()
  {
    skip_item("what depends on velocities and temperatures; its loads are static");
    read_static();
  }



  // Eigenvalue analyses and the like are skipped as a whole.
  // The keyword of the analysis follows *STEP, which has already added the step to the list; it is
  // removed again, so that times and numbers of later steps are as if it were not in the file.
  void
  DeckReader::skip_step()
  {
    skip_item("the whole step");
    if (step_counts)
      model.steps.pop_back();
    step_counts = false;
  }



  void
  DeckReader::end_step()
  {
    in_step = false;
  }



  DeckModel
  read_deck_model(const std::string &file_name)
  {
    return DeckReader(file_name).read();
  }
} // namespace Signorini
