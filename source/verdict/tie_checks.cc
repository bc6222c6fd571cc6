// SPDX-License-Identifier: Apache-2.0
// Checks of tied pairs.
#include "verdict/pair_checks.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  namespace
  {
    /// Check that the slave is tied as a whole.
    CheckResult
    check_tied_share(const std::string &name, const double tied_share)
    {
      return make_check_result(
        "untied share of the slave",
        name,
        1 - tied_share,
        0.05,
        "that part of the slave is free: it does not face the master, or is farther from it than a tenth of a "
        "face, or than the Search distance",
        "set a larger Search distance; or make the smaller surface the slave");
    }



    /// Check that the mesh resolves the tractions by which a bond fails. At edges and at the tips
    /// of cracks those of rigid bonds are singular, so that they grow without bound with each
    /// refinement of the mesh.
    CheckResult
    check_bond(const std::string &name, const nlohmann::ordered_json &bond)
    {
      const bool is_loaded = bond["utilisation"] > 0.5 || bond["failed_share"] > 0.;
      return make_check_result(
        "change of the utilisation of the bond across a face",
        name,
        is_loaded ? double(bond["change_across_face"]) : 0.,
        0.1,
        "the traction where the bond is loaded most is not resolved: the load at which it fails is too large by about "
        "0.7 times that; of rigid bonds, tractions at edges and tips of cracks grow with each refinement, without bound",
        "refine the mesh there; give a rigid bond a Normal stiffness and a Tangential stiffness (its fracture energy is "
        "Strength^2/(2 stiffness))");
    }



    /// Check that the image of a master lies on its slave, by the gaps that are kept without
    /// strain. Collective.
    template <int dim>
    CheckResult
    check_image(const std::string &name, const ContactSurface<dim> &surface, const MPI_Comm comm)
    {
      double largest = 0;
      for (const ContactPoint<dim> &point : surface.points)
        largest = std::max(largest, std::abs(point.prescribed_gap));
      largest                  = Utilities::MPI::max(largest, comm);
      CheckResult check_result = make_check_result(
        "gap of the image / face",
        name,
        surface.face_size > 0 ? largest / surface.face_size : 0.,
        1e-3,
        "the image of the master does not lie on the slave: the angle, the axis or the shift may be "
        "wrong, and so may all results be",
        "check Master rotation, Master axis and Master shift; of curved cuts, refine the mesh");
      if (check_result.value > 1e-2)
        check_result.outcome = Outcome::failed;
      return check_result;
    }
  } // namespace



  CheckResult
  check_matching_nodes(const std::string &name, const double share_of_others)
  {
    return make_check_result(
      "non-matching nodes",
      name,
      share_of_others,
      0.01,
      "direct elimination is a node-to-surface method: where slave nodes do not coincide with master nodes, errors of "
      "the pressure exceed 10 %",
      "use matching meshes, or choose another method");
  }



  template <int dim>
  std::vector<CheckResult>
  check_tie(const Snapshot<dim>          &now,
            const unsigned int            pair,
            const bool                    needs_nodes,
            const nlohmann::ordered_json &results)
  {
    const MPI_Comm             comm    = now.elasticity.mesh().communicator();
    const ContactPair<dim>    &its     = now.pairs[pair];
    const ContactSurface<dim> &surface = now.surfaces[pair];
    // Parts that have come off may be anywhere.
    const bool has_failed           = its.strength.given() && results["bond"]["failed_share"] > 0.;
    std::vector<CheckResult> checks = {
      check_tied_share(its.name, has_failed ? 1. : covered_share(surface, comm)),
      check_matching_nodes(its.name, needs_nodes ? surface.non_matching_share : 0)};
    if (!its.image.is_master())
      checks.push_back(check_image(its.name, surface, comm));
    if (its.strength.given())
      checks.push_back(check_bond(its.name, results["bond"]));
    return checks;
  }



  template std::vector<CheckResult>
  check_tie(const Snapshot<2> &, unsigned int, bool, const nlohmann::ordered_json &);
  template std::vector<CheckResult>
  check_tie(const Snapshot<3> &, unsigned int, bool, const nlohmann::ordered_json &);
} // namespace Signorini
