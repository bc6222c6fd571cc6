// SPDX-License-Identifier: Apache-2.0
#include "fields/friction_fields.h"
#include "geometry/cell_rule.h"
#include "solid/cell_displacement.h"
#include "verdict/checks.h"
#include "verdict/pair_checks.h"
#include <signorini/base/text.h>
#include <signorini/solid/model.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // Values are taken at the centres of cells, where singularities at edges do not dominate.
  template <int dim>
  std::vector<Extremes>
  extremes_of_bodies(const Snapshot<dim> &s)
  {
    const Elasticity<dim> &elasticity = s.elasticity;
    const LA::Vector       ghosted    = elasticity.with_ghosts(s.displacement);
    hp::QCollection<dim>   centers;
    for (const auto &fe : elasticity.finite_elements())
      centers.push_back(cell_rule<dim>(fe.reference_cell(), 1));
    CellDisplacement<dim>       at(elasticity, ghosted, centers);
    std::vector<Extremes>       largest(elasticity.mesh().n_bodies());
    std::vector<Tensor<2, dim>> rotations(largest.size()); // times volume
    std::vector<double>         volumes(largest.size(), 0.);
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const FEValues<dim> &values = at.reinit(cell);
          // The hoop strain u_r/r is a component of the gradient in axisymmetric models. Centres of
          // cells are not on the axis.
          double square = at.gradient[0].norm_square();
          if (elasticity.model() == Model::axisymmetric)
            square += std::pow(at.u[0][0] / values.quadrature_point(0)[0], 2);
          Extremes &of_body = largest[elasticity.mesh().body(cell)];
          of_body.motion    = std::max(of_body.motion, at.u[0].norm());
          of_body.gradient  = std::max(of_body.gradient, std::sqrt(square));
          // The norm of the antisymmetric tensor counts each component twice.
          const Tensor<2, dim> rotation = (at.gradient[0] - transpose(at.gradient[0])) / 2;
          of_body.largest_rotation =
            std::max(of_body.largest_rotation, rotation.norm() / std::sqrt(2));
          rotations[elasticity.mesh().body(cell)] += values.JxW(0) * rotation;
          volumes[elasticity.mesh().body(cell)] += values.JxW(0);
          of_body.strain =
            std::max(of_body.strain, std::sqrt(std::max(0., square - rotation.norm_square())));
        }
    const MPI_Comm comm = elasticity.mesh().communicator();
    Utilities::MPI::sum(volumes, comm, volumes);
    for (unsigned int body = 0; body < largest.size(); ++body)
      {
        Extremes &of_body = largest[body];
        of_body.mean_rotation =
          Utilities::MPI::sum(rotations[body], comm).norm() / (std::sqrt(2) * volumes[body]);
        of_body.motion           = Utilities::MPI::max(of_body.motion, comm);
        of_body.gradient         = Utilities::MPI::max(of_body.gradient, comm);
        of_body.largest_rotation = Utilities::MPI::max(of_body.largest_rotation, comm);
        of_body.strain           = Utilities::MPI::max(of_body.strain, comm);
      }
    return largest;
  }



  namespace
  {
    /// @return the largest value of all bodies, with the name of the body as message.
    /// The scale converts a value to the unit of its limit.
    template <int dim>
    CheckResult
    worst(const Snapshot<dim>         &s,
          const std::vector<Extremes> &largest,
          double Extremes::*member,
          const double      scale)
    {
      CheckResult check_result;
      for (unsigned int body = 0; body < largest.size(); ++body)
        if (const double value = largest[body].*member / scale;
            value > check_result.value || body == 0)
          {
            check_result.value   = value;
            check_result.message = s.elasticity.mesh().body_name(body);
          }
      return check_result;
    }
  } // namespace



  namespace
  {
    /// Where the contact geometry is updated, pressures p act along normals that have turned with
    /// the body by an angle a, but at lever arms R of the body before: their moment p R sin(a) is
    /// an error, which is a/mu of the largest moment of friction.
    template <int dim>
    void
    add_moment_checks(const Snapshot<dim>         &s,
                      const std::vector<Extremes> &largest,
                      std::vector<CheckResult>    &result)
    {
      if (s.contact.n_components() == 1)
        return;
      const std::vector<double> bounds = bound_of_friction(s);
      std::vector<double>       forces(s.pairs.size(), 0.);
      s.contact.for_each_point([&](const auto i, const unsigned int pair) {
        forces[pair] += s.contact.weight(i) * std::max(0., double(s.pressure(i)));
      });
      Utilities::MPI::sum(forces, s.elasticity.mesh().communicator(), forces);
      for (unsigned int p = 0; p < s.pairs.size(); ++p)
        {
          double turn = 0;
          for (const std::string &side : {s.pairs[p].slave, s.pairs[p].master})
            if (const auto body = s.elasticity.mesh().body_of(side))
              turn = std::max(turn, largest[*body].mean_rotation);
          if (bounds[p] > 0)
            result.push_back(make_check_result(
              "rotation / friction",
              s.pairs[p].name,
              turn * forces[p] / bounds[p],
              0.03,
              "a body of the pair rotates by that fraction of the friction coefficient: in small-strain theory pressures "
              "act along normals that turn, but at the places before, and moments of friction are wrong by up to that "
              "fraction",
              "set Deformation = finite, or Contact method/Contact geometry = reference"));
        }
    }
  } // namespace



  // At finite strain the displacement only is limited; rotations and sliding may make it larger
  // than the model.
  template <int dim>
  std::vector<CheckResult>
  check_motions(const Snapshot<dim> &now, const std::vector<Extremes> &largest)
  {
    constexpr double small = 0.1; // the squares that are neglected are half of that, relative

    CheckResult motion = worst(now, largest, &Extremes::motion, now.elasticity.mesh().size());
    motion.check       = "displacement / model size";
    motion.limit =
      now.elasticity.is_finite_strain() ? 20 : 1; // large rotations and sliding are allowed
    motion.outcome = motion.value > motion.limit ? Outcome::failed : Outcome::passed;
    motion.message = "'" + motion.message + "' moves farther than the size of the model";
    motion.advice =
      "check its supports, the contact pairs that constrain it, and their initial gaps";

    // Finite strain has no limit of strains and rotations.
    if (now.elasticity.is_finite_strain())
      return {motion};

    CheckResult strain = worst(now, largest, &Extremes::gradient, 1);
    strain.check       = "displacement gradient";
    strain.limit       = small;
    strain.outcome     = strain.value > strain.limit ? Outcome::warned : Outcome::passed;
    strain.message =
      "strains or rotations of '" + strain.message + "', which rotates by up to " +
      short_text(worst(now, largest, &Extremes::largest_rotation, numbers::PI / 180).value, 2) +
      " degrees, are not small: small-strain theory neglects terms of half that size, relative to the strains";
    strain.advice =
      "set Deformation = automatic or finite, or accept forces and pressures with that error";
    if (now.contact.at_rest())
      return {motion, strain};

    // A rotation by the angle a turns lengths into 1 + a^2/2, or shortens them as much if supports
    // prescribe it exactly.
    CheckResult rotation;
    rotation.check = "rotation / strain";
    rotation.limit = 0.2;
    for (unsigned int body = 0; body < largest.size(); ++body)
      if (const Extremes &one = largest[body]; one.strain > 0)
        if (const double swelling = std::pow(one.largest_rotation, 2) / 2;
            swelling / one.strain > rotation.value)
          {
            rotation.value   = swelling / one.strain;
            rotation.message = now.elasticity.mesh().body_name(body);
          }
    rotation.outcome = rotation.value > rotation.limit ? Outcome::warned : Outcome::passed;
    rotation.message =
      "small-strain theory changes lengths of '" + rotation.message +
      "' by half of the square of its rotation, that much relative to its strains: where the contact geometry is "
      "updated, gaps and pressures contain it";
    rotation.advice = "set Deformation = finite, or Contact method/Contact geometry = reference";
    std::vector<CheckResult> result = {motion, strain, rotation};
    add_moment_checks(now, largest, result);
    return result;
  }



  template std::vector<CheckResult>
  check_motions(const Snapshot<2> &, const std::vector<Extremes> &);
  template std::vector<Extremes>
  extremes_of_bodies(const Snapshot<2> &);
  template std::vector<CheckResult>
  check_motions(const Snapshot<3> &, const std::vector<Extremes> &);
  template std::vector<Extremes>
  extremes_of_bodies(const Snapshot<3> &);
} // namespace Signorini
