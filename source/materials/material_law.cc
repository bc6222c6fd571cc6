// SPDX-License-Identifier: Apache-2.0
#include "materials/material_law.h"

#include "materials/stored_energies.h"
#include <signorini/base/text.h>
#include <signorini/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Signorini
{
  namespace
  {
    using Values = std::vector<double>;

    /// @return a law that needs lambda and mu only.
    template <typename Law>
    std::shared_ptr<const ConstitutiveLaw>
    of_moduli(const Material &material)
    {
      return std::make_shared<Law>(material.lambda(), material.mu());
    }

    /// Throws std::domain_error unless there are n coefficients.
    void
    check_number(const Values &c, const unsigned int n)
    {
      if (c.size() != n)
        throw std::domain_error("there must be " + std::to_string(n));
    }

    /// @return the pairs (mu, alpha) of the coefficients. Throws std::domain_error.
    std::vector<std::pair<double, double>>
    ogden_terms(const Values &c)
    {
      if (c.empty() || c.size() % 2 != 0)
        throw std::domain_error("each term requires two coefficients");
      std::vector<std::pair<double, double>> terms;
      for (unsigned int i = 0; i < c.size(); i += 2)
        {
          if (c[i + 1] == 0)
            throw std::domain_error("no alpha may be zero");
          terms.emplace_back(c[i], c[i + 1]);
        }
      return terms;
    }

    /// @return the shear modulus in the reference configuration, half of the sum of mu alpha.
    double
    shear_of_ogden(const Values &c)
    {
      double sum = 0;
      for (const auto &[mu, alpha] : ogden_terms(c))
        sum += mu * alpha / 2;
      return sum;
    }
  } // namespace



  // New laws are added here: name, description, coefficients, shear modulus, constructor.
  const std::vector<MaterialLaw> &
  material_laws()
  {
    static const std::vector<MaterialLaw> laws = {
      {"neo-Hooke", "W = mu/2 (I1 - 3) - mu ln J + lambda/2 (ln J)^2", "", {}, of_moduli<NeoHooke>},
      {"Mooney-Rivlin",
       "W = c10 (I1 - 3) + c01 (I2 - 3) + volumetric terms such that the reference configuration is stress-free",
       "c10, c01",
       [](const Values &c) {
         check_number(c, 2);
         return 2 * (c[0] + c[1]);
       },
       [](const Material &m) {
         return std::make_shared<MooneyRivlin>(m.lambda(), m.coefficients[0], m.coefficients[1]);
       }},
      {"Yeoh",
       "W = c10 i + c20 i^2 + c30 i^3 + K/2 (ln J)^2 with i = J^(-2/3) I1 - 3",
       "c10, c20, c30",
       [](const Values &c) {
         check_number(c, 3);
         return 2 * c[0];
       },
       [](const Material &m) {
         return std::make_shared<Yeoh>(m.bulk_modulus(),
                                       m.coefficients[0],
                                       m.coefficients[1],
                                       m.coefficients[2]);
       }},
      {"polynomial",
       "W = c10 i1 + c01 i2 + c20 i1^2 + c30 i1^3 + K/2 (J - 1)^2 with i1 = J^(-2/3) I1 - 3, i2 = J^(-4/3) I2 - 3, as "
       "in CalculiX and Abaqus",
       "c10, c01, c20, c30",
       [](const Values &c) {
         check_number(c, 4);
         return 2 * (c[0] + c[1]);
       },
       [](const Material &m) {
         const Values &c = m.coefficients;
         return std::make_shared<Polynomial>(m.bulk_modulus(), c[0], c[1], c[2], c[3]);
       }},
      {"Ogden",
       "W = sum of mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3) - mu ln J, and lambda/2 (ln J)^2",
       "mu1, alpha1, mu2, alpha2, ...",
       shear_of_ogden,
       [](const Material &m) {
         return std::make_shared<Ogden>(m.lambda(), ogden_terms(m.coefficients));
       }},
      {"Hencky", "linear elasticity of the logarithmic strains", "", {}, of_moduli<Hencky>},
      {"Saint Venant-Kirchhoff",
       "linear elasticity of the Green strain, which is unstable in strong compression",
       "",
       {},
       of_moduli<SaintVenantKirchhoff>}};
    return laws;
  }



  const MaterialLaw &
  law_of(const Material &material)
  {
    return *std::find_if(material_laws().begin(), material_laws().end(), [&](const auto &law) {
      return law.name == material.law;
    });
  }



  // Coefficients determine the shear modulus; Young's modulus follows from it and Poisson's ratio,
  // and may be given in addition only if it agrees.
  void
  Material::declare(Section &section)
  {
    std::vector<std::string> names;
    for (const MaterialLaw &one : material_laws())
      names.push_back(one.name);
    section.add_choice(
      "Law",
      law,
      names,
      "constitutive law for finite strain; with small strain all bodies are linear elastic");
    section.add(
      "Coefficients",
      coefficients,
      "of the law, instead of Young's modulus: Mooney-Rivlin c10, c01; Yeoh c10, c20, c30; polynomial c10, c01, c20, c30; Ogden mu1, alpha1, mu2, "
      "alpha2, ... [stress; alpha: -]");
    if (coefficients.empty())
      section.add_required("Young's modulus", youngs_modulus, "E [stress]", positive);
    else
      section.add("Young's modulus", youngs_modulus, "E [stress]", positive);
    section.add_required("Poisson's ratio", poissons_ratio, "nu [-]", Range{-1, 0.5, false, true});
    section.add_choice(
      "Formulation",
      formulation,
      {{"automatic", Formulation::automatic},
       {"displacement", Formulation::displacement},
       {"mixed", Formulation::mixed}},
      "mixed: displacement-pressure formulation, in which the volumetric stress is an independent "
      "unknown; nearly incompressible bodies neither lock nor need more iterations, and Poisson's "
      "ratio = 0.5 is allowed; requires Degree = 2, which is the default then; automatic: mixed from "
      "nu = 0.48 on, if the degree, the model and the contact method allow it");
    if (!section.reading())
      return;
    // Laws with coefficients need them, the others refuse them.
    const MaterialLaw &chosen = law_of(*this);
    if (chosen.coefficients.empty() != coefficients.empty())
      section.fail("Coefficients",
                   chosen.coefficients.empty() ?
                     "are not for Law = " + law + ", which has E and nu" :
                     "are " + chosen.coefficients + " of Law = " + law);
    if (coefficients.empty())
      return;
    double shear = 0;
    try
      {
        shear = chosen.shear_modulus(coefficients);
      }
    catch (const std::domain_error &error)
      {
        section.fail("Coefficients", "are " + chosen.coefficients + ": " + error.what());
      }
    if (!(shear > 0))
      section.fail("Coefficients",
                   "have a shear modulus of " + short_text(shear) +
                     " in the reference configuration, which is not positive");
    // E = 2 mu (1 + nu) of the reference configuration.
    const double young = 2 * shear * (1 + poissons_ratio);
    if (section.is_set("Young's modulus") && std::abs(youngs_modulus - young) > 1e-6 * young)
      section.fail("Young's modulus",
                   "is " + short_text(young, 8) +
                     " by the Coefficients and Poisson's ratio; leave it out");
    youngs_modulus = young;
  }
} // namespace Signorini
