// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

// The part of the reader for materials and the sections that assign them to elements.

namespace Signorini
{
  // Keywords up to the next *MATERIAL belong to this material.
  void
  DeckReader::begin_material()
  {
    material = upper_case(in.value("NAME"));
    // Whether this is an error is known only when it gets elastic constants for the second time.
    is_again                       = model.materials.count(material) > 0;
    model.materials[material].name = in.value("NAME");
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
        // For an isotropic material D1111 = lambda + 2 mu and D1122 = lambda, with Lame's
        // constants. Solved for nu = lambda / (2 (lambda + mu)) and E = mu (3 lambda + 2 mu) /
        // (lambda + mu), these are the formulas below with a = D1111 and b = D1122.
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
    Values values;
    // Only as many numbers are read as the law has, however they are distributed over the lines;
    // missing ones count as zero. Further lines would be those of other temperatures.
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
          // Only MOONEY-RIVLIN and POLYNOMIAL with N = 1 have a coefficient of the second
          // invariant.
          one.coefficients.insert(one.coefficients.begin() + 1, 0.); // C01
        one.coefficients.resize(4, 0.);
        mu = 2 * (one.coefficients[0] + one.coefficients[1]);
      }
    if (!(mu > 0))
      in.fail("*HYPERELASTIC: the shear modulus at rest is not positive");
    // Young's modulus and Poisson's ratio from bulk and shear modulus.
    // D1 = 0 stands for an incompressible material, which gets a finite bulk modulus. The
    // conversions are those of isotropic linear elasticity, since the law is linearised at rest.
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
    Words words;
    if (in.next_line(words))
      section.thickness = number(words, 0);
    model.sections.push_back(section);
  }
} // namespace Signorini
