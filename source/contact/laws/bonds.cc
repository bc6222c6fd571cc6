// SPDX-License-Identifier: Apache-2.0
#include "contact/laws/bonds.h"

#include "contact/laws/contact_status.h"
#include <signorini/base/scene_error.h>
#include <signorini/contact/bond_strength.h>

#include <algorithm>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The place of a contact point in the reference configuration.
    template <int dim>
    Point<dim>
    position(const GapOperator &contact, const types::global_dof_index point)
    {
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = contact.geometry.position[d](point);
      return x;
    }
  } // namespace



  template <int dim>
  LA::Vector
  bond_utilisation(const std::vector<ContactPair<dim>> &pairs,
                   const GapOperator                   &contact,
                   const PointVectors                  &traction)
  {
    LA::Vector result = contact.zero();
    contact.for_each_point([&](const auto i, const unsigned int pair) {
      if (pairs[pair].strength.given() &&
          status_of(contact.coefficients.least_status(i)) == ContactStatus::stick)
        {
          const double ratio = contact.coefficients.area_ratio(i);
          result(i)          = pairs[pair].strength.utilisation(position<dim>(contact, i),
                                                       traction[0](i) / ratio,
                                                       length_at(traction, i, 1) / ratio);
        }
    });
    result.compress(VectorOperation::insert);
    return result;
  }



  // Points that are loaded alike, as on a line of symmetry, fail together. If all overloaded ones
  // failed at once, a load step that is too long would tear a bond off that the next solution would
  // have relieved.
  template <int dim>
  bool
  break_bonds(const std::vector<ContactPair<dim>> &pairs,
              const GapOperator                   &contact,
              const PointVectors                  &traction,
              LA::Vector                          &intact)
  {
    constexpr double alike       = 0.98;
    const LA::Vector utilisation = bond_utilisation(pairs, contact, traction);
    double           largest     = 0;
    for (const auto i : utilisation.locally_owned_elements())
      largest = std::max(largest, double(utilisation(i)));
    largest = Utilities::MPI::max(largest, utilisation.get_mpi_communicator());
    if (!(largest >= 1))
      return false;
    for (const auto i : utilisation.locally_owned_elements())
      if (utilisation(i) >= std::max(1., alike * largest))
        intact(i) = 0;
    intact.compress(VectorOperation::insert);
    return true;
  }



  template <int dim>
  void
  set_bonds(const std::vector<ContactPair<dim>> &pairs, LA::Vector &intact, GapOperator &contact)
  {
    unsigned int wrong = 0; // one more than the number of a pair
    contact.for_each_point([&](const auto i, const unsigned int pair) {
      if (!pairs[pair].strength.given())
        return;
      bool is_bonded = intact(i) > 0.5 && contact.weight(i) > 0;
      try
        {
          is_bonded = is_bonded && !pairs[pair].strength.is_absent(position<dim>(contact, i));
        }
      catch (const SceneError &)
        {
          wrong = pair + 1;
        }
      intact(i) = is_bonded ? 1. : 0.;
      contact.coefficients.least_status(i) =
        static_cast<double>(is_bonded ? ContactStatus::stick : ContactStatus::open);
    });
    intact.compress(VectorOperation::insert);
    contact.coefficients.least_status.compress(VectorOperation::insert);
    wrong = Utilities::MPI::max(wrong, intact.get_mpi_communicator());
    if (wrong > 0)
      throw SceneError("Contact pairs/" + pairs[wrong - 1].name +
                       "/Strength: it, or the Shear strength, is negative, or no number, at some "
                       "points; correct the formula");
  }



  // Faces see the values of all their points, also of those that belong to other ranks.
  double
  change_across_face(const GapOperator &contact,
                     const unsigned int pair,
                     const LA::Vector  &utilisation)
  {
    const MPI_Comm comm = utilisation.get_mpi_communicator();
    LA::Vector     of_all(contact.weight.locally_owned_elements(), contact.origin.readable, comm);
    of_all = utilisation;
    // The largest value of all faces, and the least one of the face that has it.
    double largest = 0, least = 0;
    for (const SurfacePoints &face : contact.origin.places)
      {
        if (face.id.pair != pair)
          continue;
        double most = 0, fewest = std::numeric_limits<double>::max();
        for (const SurfacePlace &place : face.places)
          if (place.is_row)
            if (const double value = of_all(place.rows.front().first); value > 0)
              {
                most   = std::max(most, value);
                fewest = std::min(fewest, value);
              }
        if (most > largest || (most == largest && fewest < least))
          {
            largest = most;
            least   = fewest;
          }
      }
    const double of_ranks = Utilities::MPI::max(largest, comm);
    if (of_ranks == 0)
      return 0;
    return Utilities::MPI::max(largest == of_ranks ? 1 - least / largest : 0., comm);
  }



#define INSTANTIATE(dim)                                                                           \
  template LA::Vector bond_utilisation(const std::vector<ContactPair<dim>> &,                      \
                                       const GapOperator &,                                        \
                                       const PointVectors &);                                      \
  template bool       break_bonds(const std::vector<ContactPair<dim>> &,                           \
                                  const GapOperator &,                                             \
                                  const PointVectors &,                                            \
                                  LA::Vector &);                                                   \
  template void       set_bonds(const std::vector<ContactPair<dim>> &, LA::Vector &, GapOperator &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
