#pragma once

#include <signorini/contact/surface.h>

#include <vector>

namespace Signorini
{
  /// Where a method imposes contact.
  enum class Sampling
  {
    quadrature_points, ///< point-wise
    nodes              ///< weighted with the pressure's functions of the slave (mortar)
  };

  /// A share of a contact point that goes to a row of the gap operator.
  struct Share
  {
    dealii::types::global_dof_index row;
    double                          weight;
  };

  /// Which rows there are, and which shares of each contact point they take.
  struct ContactRows
  {
    dealii::IndexSet owned;
    dealii::IndexSet writable; ///< owned, and those that points of this rank contribute to
    std::vector<std::vector<std::vector<Share>>> shares; ///< [pair][point]
    std::vector<unsigned int>                    pair;
    std::vector<dealii::types::global_dof_index> node;
  };

  template <int dim>
  ContactRows
  make_contact_rows(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    Sampling                                sampling);
} // namespace Signorini
