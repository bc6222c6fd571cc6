// SPDX-License-Identifier: Apache-2.0
#include "solver/unconstrained_modes.h"

#include "linear_algebra/dense.h"

#include <algorithm>
#include <cmath>
#include <limits>


namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The elementwise product, that is, a diagonal matrix times a vector.
    LA::Vector
    product(const LA::Vector &a, const LA::Vector &b)
    {
      LA::Vector result = a;
      result.scale(b);
      return result;
    }

    /// Gram-Schmidt with the scalar product z^T S z of the stabilisation S. Collective.
    void
    orthonormalise(std::vector<UnconstrainedMode> &motions, const LA::Vector &stabilisation)
    {
      for (unsigned int i = 0; i < motions.size(); ++i)
        {
          LA::Vector &z = motions[i].motion;
          for (unsigned int j = 0; j < i; ++j)
            z.add(-(product(stabilisation, motions[j].motion) * z), motions[j].motion);
          z /= std::sqrt(product(stabilisation, z) * z);
        }
    }

    /// The matrix (z_a . B^T w B z_b) of the Rayleigh quotient: the stiffness of point springs w
    /// against pairs of modes. Collective.
    Eigen::MatrixXd
    stiffness_against(const std::vector<LA::Vector> &gap_rates, const LA::Vector &spring)
    {
      Eigen::MatrixXd matrix(gap_rates.size(), gap_rates.size());
      for (unsigned int a = 0; a < gap_rates.size(); ++a)
        for (unsigned int b = 0; b <= a; ++b)
          matrix(a, b) = matrix(b, a) = product(spring, gap_rates[a]) * gap_rates[b];
      return matrix;
    }
  } // namespace



  // The rates of the gaps B z are computed once; set_status() then costs scalar products only.
  // Modes that remain unconstrained with all points stuck cannot be constrained at all.
  UnconstrainedModes::UnconstrainedModes(std::vector<UnconstrainedMode> all,
                                         const LA::Vector              &stabilisation,
                                         const GapOperator             &contact)
    : motions(std::move(all))
    , stabilisation(stabilisation)
    , contact(&contact)
  {
    orthonormalise(motions, stabilisation);
    LA::Vector every_point = contact.zero();
    every_point            = static_cast<double>(ContactStatus::stick);
    gap_rates.resize(contact.n_components());
    for (const UnconstrainedMode &one : motions)
      {
        amplitude.push_back(one.motion.linfty_norm());
        for (unsigned int a = 0; a < gap_rates.size(); ++a)
          {
            gap_rates[a].push_back(contact.zero());
            if (!contact.empty())
              contact.free_rows(a).vmult(gap_rates[a].back(), one.motion);
          }
      }
    set_status(every_point);
    my_unconstrainable = unconstrained();
  }



  LA::Vector
  UnconstrainedModes::shares_of_pairs(const LA::Vector &status, const ContactStatus least) const
  {
    const auto     counts = [&](const auto i) { return status(i) >= static_cast<double>(least); };
    const MPI_Comm comm   = stabilisation.get_mpi_communicator();
    const auto    &pair   = contact->origin.pair;
    std::vector<double> area(contact->n_pairs(), 0.);
    auto                which = pair.begin();
    for (const auto i : status.locally_owned_elements())
      area[*which++] += counts(i) ? contact->weight(i) : 0.;
    Utilities::MPI::sum(area, comm, area);
    LA::Vector shares = contact->zero();
    which             = pair.begin();
    for (const auto i : status.locally_owned_elements())
      {
        const double whole = area[*which++];
        shares(i)          = counts(i) && whole > 0 ? contact->weight(i) / whole : 0.;
      }
    shares.compress(VectorOperation::insert);
    return shares;
  }



  std::vector<LA::Vector>
  UnconstrainedModes::rates_across(const PointVectors &traction) const
  {
    std::vector<LA::Vector> result(motions.size(), contact->zero());
    for (const auto i : result[0].locally_owned_elements())
      {
        const double t1 = traction[1](i), t2 = traction[2](i), size = std::hypot(t1, t2);
        for (unsigned int k = 0; k < result.size(); ++k)
          result[k](i) = size > 0 && contact->coefficients.friction(i) > 0 ?
                           (t1 * gap_rates[2][k](i) - t2 * gap_rates[1][k](i)) / size :
                           0.;
      }
    for (LA::Vector &rates : result)
      rates.compress(VectorOperation::insert);
    return result;
  }



  // Solve the eigenvalue problem of the modes for these statuses (doc/theory, 4.10), of the size of
  // the number of modes. Eigenvectors with negligible eigenvalues are the unconstrained modes; they
  // are named by the motions that contribute most.
  void
  UnconstrainedModes::set_status(const LA::Vector &status, const PointVectors &traction)
  {
    // A combination of modes is unconstrained if its eigenvalue vanishes, that is, if it moves
    // along the surface at all closed points. Rotations of round bodies with faceted surfaces have
    // normals slightly off: the bound is the square of that angle, or of the ratio of the width of
    // the contact area and the size of the body.
    constexpr double negligible = 1e-6;
    my_unconstrained.clear();
    const unsigned int n = motions.size();
    if (n == 0)
      return;
    Eigen::MatrixXd stiffness =
      stiffness_against(gap_rates[0], shares_of_pairs(status, ContactStatus::slip));
    for (unsigned int a = 1; a < gap_rates.size(); ++a)
      stiffness += stiffness_against(gap_rates[a], shares_of_pairs(status, ContactStatus::stick));
    if (gap_rates.size() == 3 && traction.size() == 3)
      stiffness +=
        stiffness_against(rates_across(traction), shares_of_pairs(status, ContactStatus::slip));
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = 0; b < n; ++b)
        stiffness(a, b) /= amplitude[a] * amplitude[b];
    const SymmetricEigenpairs pairs   = eigenpairs_of_symmetric(stiffness);
    const Eigen::MatrixXd    &vectors = pairs.vectors;
    for (unsigned int i = 0; i < n; ++i)
      if (pairs.values[i] <= negligible)
        {
          double            largest = 0;
          UnconstrainedMode one;
          one.motion.reinit(stabilisation);
          for (unsigned int j = 0; j < n; ++j)
            {
              one.motion.add(vectors(j, i) / amplitude[j], motions[j].motion);
              largest = std::max(largest, std::abs(vectors(j, i)));
            }
          for (unsigned int j = 0; j < n; ++j)
            if (std::abs(vectors(j, i)) > largest / 2)
              one.name += (one.name.empty() ? "" : " with ") + motions[j].name;
          my_unconstrained.push_back({one, {}});
        }
    orthonormalise_unconstrained();
  }



  // Orthonormal with respect to S, with the forces S z.
  void
  UnconstrainedModes::orthonormalise_unconstrained()
  {
    std::vector<UnconstrainedMode> all;
    for (const UnconstrainedPart &one : my_unconstrained)
      all.push_back(one.free);
    orthonormalise(all, stabilisation);
    for (unsigned int i = 0; i < all.size(); ++i)
      my_unconstrained[i] = {all[i], product(stabilisation, all[i].motion)};
  }



  void
  UnconstrainedModes::subtract_stabilisation(LA::Vector &dst, const LA::Vector &src) const
  {
    if (!empty())
      dst.add(-1, product(stabilisation, src));
  }



  void
  UnconstrainedModes::add_unconstrained_stiffness(LA::Vector &dst, const LA::Vector &src) const
  {
    for (const UnconstrainedPart &one : my_unconstrained)
      dst.add(one.stabilising_force * src, one.stabilising_force);
  }



  std::vector<std::string>
  UnconstrainedModes::unconstrained() const
  {
    std::vector<std::string> names;
    for (const UnconstrainedPart &one : my_unconstrained)
      names.push_back(one.free.name);
    return names;
  }



  std::vector<std::string>
  UnconstrainedModes::loaded(const LA::Vector &r, const double scale) const
  {
    std::vector<std::string> names;
    for (const UnconstrainedPart &one : my_unconstrained)
      if (std::abs(one.free.motion * r) > scale * one.free.motion.linfty_norm())
        names.push_back(one.free.name);
    return names;
  }



  namespace
  {
    /// Sums of the forces on the nodes that a mode moves, over all ranks. The degrees of freedom of
    /// a node are dim consecutive ones. Collective.
    struct ForcesOnMovingParts
    {
      double              sum = 0;   ///< sum of absolute values
      std::vector<double> resultant; ///< sum, component by component

      ForcesOnMovingParts(const LA::Vector &motion, const LA::Vector &force, const unsigned int dim)
        : resultant(dim, 0.)
      {
        const IndexSet owned = motion.locally_owned_elements();
        for (auto i = owned.begin(); i != owned.end();)
          {
            const auto node  = *i / dim;
            auto       first = i;
            bool       moves = false;
            for (; i != owned.end() && *i / dim == node; ++i)
              moves |= motion(*i) != 0;
            for (; moves && first != i; ++first)
              {
                sum += std::abs(force(*first));
                resultant[*first % dim] += force(*first);
              }
          }
        sum = Utilities::MPI::sum(sum, motion.get_mpi_communicator());
        Utilities::MPI::sum(resultant, motion.get_mpi_communicator(), resultant);
      }
    };

  } // namespace



  // Remove z (z.r) from r for each unconstrained mode, if that force is small compared to the
  // contact forces on the nodes that the mode moves. Contact forces of unilateral pairs count with
  // their absolute values, those of bilateral pairs, which may have both signs, with their
  // resultant.
  double
  UnconstrainedModes::project_out(LA::Vector         &r,
                                  const PointVectors &p,
                                  const PointVectors &stress) const
  {
    constexpr double little = 0.01;
    if (my_unconstrained.empty())
      return 0;
    // The tractions of pairs with separation, then those of each pair without.
    std::vector<PointVectors> tractions = {p};
    const LA::Vector         &least     = contact->coefficients.least_status;
    for (LA::Vector &component : tractions[0])
      {
        for (const auto i : component.locally_owned_elements())
          if (is_closed(least(i)))
            component(i) = 0;
        component.compress(VectorOperation::insert);
      }
    const bool         any     = least.linfty_norm() > 0;
    const unsigned int n_pairs = any ? contact->n_pairs() : 0;
    for (unsigned int k = 0; k < n_pairs; ++k)
      {
        tractions.push_back(contact->zeros());
        for (unsigned int a = 0; a < p.size(); ++a)
          {
            auto which = contact->origin.pair.begin();
            for (const auto i : p[a].locally_owned_elements())
              if (*which++ == k)
                tractions.back()[a](i) = is_closed(least(i)) ? p[a](i) : 0;
            tractions.back()[a].compress(VectorOperation::insert);
          }
      }
    std::vector<LA::Vector> forces;
    for (const PointVectors &some : tractions)
      forces.push_back(contact->force(some, stress));

    const unsigned int dim     = contact->geometry.position.size();
    double             largest = 0;
    for (const UnconstrainedPart &one : my_unconstrained)
      {
        const LA::Vector &z     = one.free.motion;
        const double      share = z * r, force = std::abs(share) / z.linfty_norm();
        double            all = ForcesOnMovingParts(z, forces[0], dim).sum;
        for (std::size_t k = 1; k < forces.size(); ++k)
          for (const double component : ForcesOnMovingParts(z, forces[k], dim).resultant)
            all += std::abs(component);
        if (force > little * all)
          continue;
        r.add(-share, one.stabilising_force);
        largest = std::max(largest, force);
      }
    return largest;
  }



  // Move along the combination of unconstrained modes that the forces r excite (doc/theory,
  // (4.20)): the rate of each gap, the first gap that closes, and one more displacement of the same
  // size so that the point becomes active. Collective.
  bool
  UnconstrainedModes::move_into_contact(LA::Vector &u, const LA::Vector &r) const
  {
    LA::Vector motion;
    motion.reinit(u);
    for (const UnconstrainedPart &one : my_unconstrained)
      motion.add(one.free.motion * r, one.free.motion);
    LA::Vector speed = contact->zero();
    if (!contact->empty())
      contact->B_free.vmult(speed, motion);
    const LA::Vector gap = contact->gap(u);
    // Smaller speeds are due to the rounding of normals.
    const double crawls = 1e-8 * motion.linfty_norm();
    double       first  = std::numeric_limits<double>::infinity();
    for (const auto i : gap.locally_owned_elements())
      if (speed(i) < -crawls && contact->coefficients.least_status(i) == 0)
        first = std::min(first, std::max(0., gap(i)) / -speed(i));
    // The first point that closes along the motion determines how far it goes.
    first = Utilities::MPI::min(first, speed.get_mpi_communicator());
    if (std::isinf(first))
      return false;
    if (first > 0)
      u.add(first + 1, motion);
    return true;
  }
} // namespace Signorini
