// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"

#include "mesh_import/formats/abaqus_elements.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>

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
    {"SURFACE INTERACTION", &DeckReader::begin_interaction},
    {"SURFACE BEHAVIOR", &DeckReader::read_behaviour},
    {"CONTACT PAIR", &DeckReader::read_pairs},
    {"CLEARANCE", &DeckReader::read_clearance},
    {"HEADING", &DeckReader::ignore},
    {"PREPRINT", &DeckReader::ignore},
    {"NODE", &DeckReader::ignore},
    {"ELEMENT", &DeckReader::ignore},
    {"NSET", &DeckReader::ignore},
    {"ELSET", &DeckReader::ignore},
    {"SURFACE", &DeckReader::ignore},
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
    {"FRICTION", "contact is without friction"},
    {"CHANGE FRICTION", "contact is without friction"},
    {"PLASTIC", "materials are linear elastic"},
    {"CREEP", "materials are linear elastic"},
    {"EQUATION", "nodes are not tied to each other by equations"},
    {"MPC", "nodes are not tied to each other by equations"},
    {"COUPLING", "nodes are not tied to each other by equations"},
    {"KINEMATIC", "nodes are not tied to each other by equations"},
    {"RIGID BODY", "bodies that are meshed are elastic"},
    {"TIE", "surfaces are not tied"},
    {"CYCLIC SYMMETRY MODEL", "cyclic symmetry"},
    {"PRE-TENSION SECTION", "pre-tension"},
    {"MODEL CHANGE", "all elements and contact pairs are there at all times"},
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
  const std::set<std::string, IgnoringBlanks> DeckReader::restraints = {"FRICTION",
                                                                        "CHANGE FRICTION",
                                                                        "EQUATION",
                                                                        "MPC",
                                                                        "COUPLING",
                                                                        "KINEMATIC",
                                                                        "RIGID BODY",
                                                                        "TIE",
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
    for (const std::string &what : model.deck.missing)
      model.skip_item(what, "", "keyword");
    return std::move(model);
  }



  void
  DeckReader::ignore()
  {}



  // Report the present keyword with a reason.
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



  // Ties become contact without separation, which constrains the normal direction only.
  void
  DeckReader::skip_tie()
  {
    skip_item("tied tangentially: the surfaces stay together, but slide freely");
    model.lacks_supports = true;
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



  // Keywords up to the next *MATERIAL belong to this material.
  void
  DeckReader::begin_material()
  {
    material                       = upper_case(in.value("NAME"));
    is_again                       = model.materials.count(material) > 0;
    model.materials[material].name = in.value("NAME");
  }



  // The number in a word of a data line; 0 if it is missing or empty.
  double
  DeckReader::number(const Words &words, const unsigned int i) const
  {
    return i < words.size() ? real_from(in, words[i]) : 0.;
  }



  /// Data line: Young's modulus, Poisson's ratio. Anisotropic materials are replaced by the
  /// isotropic one that has their first constants.
  void
  DeckReader::read_elastic()
  {
    DeckModel::Material &one  = model.materials[material];
    const std::string    type = upper_case(in.value("TYPE"));
    Words                words, more;
    if (!in.next_line(words))
      in.fail("*ELASTIC without data");
    if (is_again && one.youngs_modulus)
      in.fail("the material '" + one.name + "' is there twice");
    // Isotropic: E, nu. Orthotropic and anisotropic: D1111, D1122, ... Others begin with E1, E2,
    // E3, nu12.
    const double a = number(words, 0), b = number(words, 1), d = number(words, 3);
    if (type.empty() || type == "ISO" || type == "ISOTROPIC")
      {
        one.youngs_modulus = a;
        one.poissons_ratio = b;
        if (in.next_line(more))
          skip_item("its dependence on temperature; the first line counts");
        return;
      }
    if (type == "ORTHO" || type == "ORTHOTROPIC" || type == "ANISO" || type == "ANISOTROPIC")
      {
        one.poissons_ratio = b / (a + b);
        one.youngs_modulus = (a - b) * (a + 2 * b) / (a + b);
      }
    else
      {
        one.youngs_modulus = a;
        one.poissons_ratio = d;
      }
    skip_item("its TYPE=" + type + "; the first constants are taken as isotropic");
  }



  namespace
  {
    /// The ratio of bulk and shear modulus for D = 0, as in CalculiX.
    constexpr double nearly_incompressible = 20;

    /// A strain energy of *HYPERELASTIC: its parameter, the law of the program, the number of its
    /// coefficients, which precede the D, and the number of the D.
    struct StrainEnergy
    {
      std::string name, law;
      /// Number of coefficients that precede the D, and number of the D.
      unsigned int n_coefficients, n_terms;
    };
  } // namespace



  // CalculiX and Abaqus have W = sum of C_ij (I1* - 3)^i (I2* - 3)^j, or of 2 mu_i/alpha_i^2
  // (l1*^alpha_i + l2*^alpha_i + l3*^alpha_i - 3), and (J - 1)^2/D1, with the stretches l* without
  // the change of volume (CalculiX 2.20, 6.8.3). Therefore K = 2/D1 and mu = 2 (C10 + C01), or the
  // sum of the mu_i; compare doc/theory, (6.8).
  void
  DeckReader::read_hyperelastic()
  {
    const unsigned int              n = in.has("N") ? number({in.value("N")}, 0) : 1;
    const std::vector<StrainEnergy> energies{{"NEO HOOKE", "polynomial", 1, 1},
                                             {"REDUCED POLYNOMIAL", "polynomial", n, n},
                                             {"YEOH", "polynomial", 3, 3},
                                             {"MOONEY-RIVLIN", "polynomial", 2, 1},
                                             {"POLYNOMIAL", "polynomial", 2, n},
                                             {"OGDEN", "Ogden", 2 * n, n}};
    const auto found         = std::find_if(energies.begin(), energies.end(), [&](const auto &one) {
      return in.has(one.name);
    });
    const bool is_polynomial = !in.has("OGDEN") && found != energies.end();
    if (found == energies.end() || n == 0 || (is_polynomial && n > 3) ||
        (found->name == "POLYNOMIAL" && n > 1))
      {
        skip_item("of which NEO HOOKE, MOONEY-RIVLIN, YEOH, REDUCED POLYNOMIAL with N up to 3, "
                  "POLYNOMIAL with N=1 and OGDEN are there");
        return;
      }
    // All coefficients, also from continuation lines.
    Values      values;
    std::size_t n_all = found->n_coefficients + found->n_terms;
    for (Words words; values.size() < n_all && in.next_line(words);)
      for (unsigned int i = 0; i < words.size() && values.size() < n_all; ++i)
        values.push_back(number(words, i));
    values.resize(n_all, 0.);
    Words more;
    if (in.next_line(more))
      skip_item("its dependence on temperature; the first line counts");
    const double D1 = values[found->n_coefficients];
    if (std::any_of(values.begin() + found->n_coefficients + 1, values.end(), [](const double D) {
          return D != 0;
        }))
      skip_item("its D2, D3, ...; changes of volume are as by D1");
    values.resize(found->n_coefficients);

    // Convert to the coefficients of the program: Ogden's mu_i of CalculiX are 2 mu_i/alpha_i here;
    // polynomials get their missing coefficients as zeros.
    DeckModel::Material &one = model.materials[material];
    one.law                  = found->law;
    one.coefficients         = values;
    double mu                = 0;
    if (one.law == "Ogden")
      for (unsigned int i = 0; i < values.size(); i += 2)
        {
          if (values[i + 1] == 0)
            in.fail("*HYPERELASTIC, OGDEN: no alpha may be zero");
          mu += values[i];
          one.coefficients[i] = 2 * values[i] / values[i + 1];
        }
    else
      {
        if (found->n_coefficients != 2 || found->name == "REDUCED POLYNOMIAL")
          one.coefficients.insert(one.coefficients.begin() + 1, 0.); // C01
        one.coefficients.resize(4, 0.);
        mu = 2 * (one.coefficients[0] + one.coefficients[1]);
      }
    if (!(mu > 0))
      in.fail("*HYPERELASTIC: the shear modulus at rest is not positive");
    // Young's modulus and Poisson's ratio from bulk and shear modulus.
    const double K     = D1 > 0 ? 2 / D1 : nearly_incompressible * mu;
    one.poissons_ratio = (3 * K - 2 * mu) / (2 * (3 * K + mu));
    one.youngs_modulus = 2 * mu * (1 + *one.poissons_ratio);
    if (one.law == "Ogden")
      skip_item("OGDEN has (ln J)^2 here for (J - 1)^2, and stretches with the change of volume");
  }



  // The density of the present material; later lines, for other temperatures, are ignored.
  void
  DeckReader::read_density()
  {
    Words words;
    if (in.next_line(words))
      model.materials[material].density = number(words, 0);
  }



  // Isotropic thermal expansion of the present material.
  void
  DeckReader::read_expansion()
  {
    const std::string type = upper_case(in.value("TYPE"));
    if (!type.empty() && type != "ISO")
      {
        skip_item("its TYPE=" + type);
        return;
      }
    Words words, more;
    if (in.next_line(words))
      model.materials[material].expansion = number(words, 0);
    if (in.next_line(more))
      skip_item("its dependence on temperature; the first line counts");
  }



  // *SOLID SECTION in a part holds for all instances of the part.
  void
  DeckReader::read_section()
  {
    DeckModel::SolidSection section;
    section.material = upper_case(in.value("MATERIAL"));
    std::vector<std::string> instances{""};
    if (!part.empty())
      instances = model.deck.instances_of[part];
    const std::string of = in.value("ELSET");
    for (const std::string &instance : instances)
      {
        model.deck.elements.append(in, of, section.elements, instance);
        const AbaqusSet *set =
          model.deck.elements.find(instance.empty() ? of : instance + "." + of);
        if (set)
          section.sets.push_back(set->name);
      }
    if (in.has("ORIENTATION"))
      skip_item("its ORIENTATION");
    Words words;
    if (in.next_line(words))
      section.thickness = number(words, 0);
    model.sections.push_back(section);
  }



  // Data lines: pairs of time and factor, any number on a line.
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



  // *SURFACE BEHAVIOR up to the next *SURFACE INTERACTION belongs to this interaction.
  void
  DeckReader::begin_interaction()
  {
    interaction = upper_case(in.value("NAME"));
    model.interactions[interaction];
  }



  // PRESSURE-OVERCLOSURE: HARD, LINEAR with a stiffness, or TIED.
  void
  DeckReader::read_behaviour()
  {
    if (in_step)
      {
        skip_item("its change in a step");
        return;
      }
    using Kind                   = DeckModel::Interaction::Kind;
    const std::string       kind = upper_case(in.value("PRESSURE-OVERCLOSURE"));
    DeckModel::Interaction &one  = model.interactions[interaction];
    if (kind == "LINEAR" || kind == "TIED")
      {
        Words words;
        one.kind = kind == "TIED" ? Kind::tied : Kind::linear;
        if (in.next_line(words))
          one.stiffness = number(words, 0);
        if (kind == "LINEAR" && !(one.stiffness > 0))
          in.fail("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR needs a positive slope");
        if (kind == "TIED")
          skip_tie();
        return;
      }
    one.kind = Kind::hard;
    if (!kind.empty() && kind != "HARD")
      skip_item(kind + "; contact is hard");
    if (in.has("NO SEPARATION"))
      {
        one.kind = Kind::tied;
        skip_item("NO SEPARATION; the surfaces stay together from the beginning");
      }
  }



  // Data lines: slave, master. Pairs with TIED get an interaction of their own, with a name that no
  // file can contain.
  void
  DeckReader::read_pairs()
  {
    if (const std::string by = in.value("ADJUST"); !model.deck.nodes.find(by))
      number({by}, 0); // or it fails
    if (in.has("TIED"))
      skip_tie();
    for (Words words; in.next_line(words);)
      if (words.size() < 2 || words[1].empty())
        skip_item("of one surface with itself: " + words[0]);
      else
        model.pairs.push_back(
          {words[0], words[1], in.has("TIED") ? "\"TIED" : upper_case(in.value("INTERACTION"))});
    if (in.has("TIED"))
      model.interactions["\"TIED"].kind = DeckModel::Interaction::Kind::tied;
  }



  // The gap of a pair at the start.
  void
  DeckReader::read_clearance()
  {
    model.clearances.push_back(
      {in.value("SLAVE"), in.value("MASTER"), number({in.value("VALUE")}, 0)});
    if (!in.has("VALUE"))
      in.fail("*CLEARANCE needs VALUE=gap");
  }



  DeckModel
  read_deck_model(const std::string &file_name)
  {
    return DeckReader(file_name).read();
  }
} // namespace Signorini
