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
    /// Formula of the temperature T; empty: the field of the mesh.
    Formula temperature;
    /// Reference temperature T_0, at which there is no thermal strain.
    double reference = 0;
    /// Location of the temperature in the scene file, for messages.
    std::string place;

    /// Declare the keys. @param mesh_has_field true if the mesh file has a temperature field, which
    /// the formula may use as `field`
    void
    declare(Section &section, bool mesh_has_field);

    /// True if the body has a thermal expansion.
    bool
    given() const
    {
      return !coefficients.empty();
    }

    /// The coefficients along x, y and z [1/temperature]; zero if there are none.
    dealii::Tensor<1, 3>
    alpha() const;

    /// The temperature T at a point and time. @param field value of the mesh's temperature field
    /// there
    double
    value(const dealii::Point<dim> &x, double t, double field) const;

    /// True if the formula depends on t.
    bool
    depends_on_time() const;

    /// True if temperature or expansion depend on the position.
    bool
    depends_on_place() const;

    /// True if the temperature depends on the field of the mesh.
    bool
    depends_on_field() const;

  private:
    std::shared_ptr<const CompiledFormula> compiled; ///< null: the field
    bool                                   with_field = false;
  };
} // namespace Signorini
