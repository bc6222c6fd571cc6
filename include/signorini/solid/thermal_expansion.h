// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/definitions.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class CompiledFormula;
  class Section;

  /// The thermal expansion of a body as the input defines it: strains alpha (T - T_0) along the
  /// axes, at any position and time.
  template <int dim>
  struct ThermalExpansion
  {
    /// alpha [1/temperature]; empty: the body does not expand; one for all directions, or three
    /// along x, y, z (axisymmetric: z is the hoop).
    std::vector<double> coefficients;
    Formula             temperature;   ///< T; empty: the field
    double              reference = 0; ///< T_0, without strain
    std::string         place;         ///< of the temperature in the scene file

    /// @param mesh_has_field the mesh comes with temperatures of its own, which the formula may
    /// call `field`
    void
    declare(Section &section, bool mesh_has_field);

    /// True if the body has a thermal expansion.
    bool
    given() const
    {
      return !coefficients.empty();
    }

    dealii::Tensor<1, 3>
    alpha() const;

    /// T at a place and time. @param field the temperature there that came with the mesh
    double
    value(const dealii::Point<dim> &x, double t, double field) const;

    bool
    depends_on_time() const;

    /// True if temperature or expansion depend on the position.
    bool
    depends_on_place() const;

    bool
    depends_on_field() const;

  private:
    std::shared_ptr<const CompiledFormula> compiled; ///< null: the field
    bool                                   with_field = false;
  };
} // namespace Signorini
