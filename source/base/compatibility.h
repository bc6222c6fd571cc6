// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/config.h>
#include <deal.II/base/data_out_base.h>
#include <deal.II/base/index_set.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

namespace Signorini
{
  /// Common names for what is called differently in the supported versions of deal.II (9.4 to 9.7);
  /// the newer name where there is one.
  namespace Compatibility
  {
#if DEAL_II_VERSION_GTE(9, 6, 0)
    /// The state of a cell in the signal of weights.
    template <int dim>
    constexpr dealii::CellStatus cell_will_persist = dealii::CellStatus::cell_will_persist;
    template <int dim>
    constexpr dealii::CellStatus children_will_be_coarsened =
      dealii::CellStatus::children_will_be_coarsened;

    constexpr auto compression_best_speed = dealii::DataOutBase::CompressionLevel::best_speed;
#else
    template <int dim>
    constexpr auto cell_will_persist = dealii::Triangulation<dim>::CELL_PERSIST;
    template <int dim>
    constexpr auto children_will_be_coarsened = dealii::Triangulation<dim>::CELL_COARSEN;

    constexpr auto compression_best_speed = dealii::DataOutBase::VtkFlags::best_speed;
#endif

    /// Remove all constraints.
    /// @param constraints which are cleared
    /// @param locally_owned degrees of freedom of this rank
    /// @param locally_relevant degrees of freedom that this rank may need
    inline void
    reinit(dealii::AffineConstraints<double>       &constraints,
           [[maybe_unused]] const dealii::IndexSet &locally_owned,
           const dealii::IndexSet                  &locally_relevant)
    {
#if DEAL_II_VERSION_GTE(9, 6, 0)
      constraints.reinit(locally_owned, locally_relevant);
#else
      constraints.reinit(locally_relevant);
#endif
    }
  } // namespace Compatibility
} // namespace Signorini
