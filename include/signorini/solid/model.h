// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/materials/material.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// The relation of the mesh to the body. In 2D, forces are per unit of thickness (plane strain: a
  /// body so thick that it cannot expand; plane stress: a thin sheet), or those on the whole
  /// circumference (axisymmetric: x is the radius, y runs along the axis, z is the hoop direction).
  enum class Model
  {
    solid,
    plane_strain,
    plane_stress,
    axisymmetric
  };

  /// The models of a dimension as the user writes them; the first is the default.
  template <int dim>
  const std::vector<std::string> &
  model_names();

  /// The model of a name. @param name one of model_names()
  Model
  model_of(const std::string &name);

  /// The measure of area or volume of the mesh at x: 2 pi r in axisymmetric models [length],
  /// else 1.
  template <int dim>
  double
  measure(Model model, const dealii::Point<dim> &x);

  /// The lambda of sigma = lambda tr(eps) I + 2 mu eps for the in-plane strains [force/area]. In
  /// plane stress it is lambda* = 2 lambda mu/(lambda + 2 mu), since eps_zz follows from sigma_zz =
  /// 0.
  double
  in_plane_lambda(Model model, const Material &material);

  /// The strain in three dimensions (doc/theory, (1.6)). Axisymmetric: eps_zz = u_r/r, or its limit
  /// on the axis; plane stress: eps_zz such that sigma_zz = 0.
  /// @param gradient gradient of the displacement: [component][derivative]
  /// @param u displacement at x
  template <int dim>
  dealii::SymmetricTensor<2, 3>
  strain(Model                         model,
         const Material               &material,
         const dealii::Tensor<2, dim> &gradient,
         const dealii::Tensor<1, dim> &u,
         const dealii::Point<dim>     &x);

  /// The strain minus the thermal strain: the argument of stress().
  /// @param thermal_strain along the axes; axisymmetric: z is the hoop direction
  template <int dim>
  dealii::SymmetricTensor<2, 3>
  elastic_strain(Model                         model,
                 const Material               &material,
                 const dealii::Tensor<2, dim> &gradient,
                 const dealii::Tensor<1, dim> &u,
                 const dealii::Point<dim>     &x,
                 const dealii::Tensor<1, 3>   &thermal_strain);
} // namespace Signorini
