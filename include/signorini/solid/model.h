// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/materials/material.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// What the mesh stands for. In 2D, forces are per unit of thickness (plane strain: of a body so
  /// thick that it cannot expand; plane stress: of a sheet), or those on the whole circumference
  /// (axisymmetric: x is the radius, y runs along the axis, z is the direction of the hoop).
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

  /// `name` is one of model_names().
  Model
  model_of(const std::string &name);

  /// What an area or volume of the mesh at x counts for: 2 pi r if axisymmetric, else 1.
  template <int dim>
  double
  measure(Model model, const dealii::Point<dim> &x);

  /// The lambda of sigma = lambda tr(eps) I + 2 mu eps among the strains of the mesh. In plane
  /// stress eps_zz follows from them: lambda* = 2 lambda mu/(lambda + 2 mu).
  double
  in_plane_lambda(Model model, const Material &material);

  /// The strain in space. Axisymmetric: eps_zz = u_r/r, and its limit on the axis; plane stress:
  /// the one that makes sigma_zz zero.
  /// @param gradient of the displacement: [component][derivative]
  /// @param u the displacement at x
  template <int dim>
  dealii::SymmetricTensor<2, 3>
  strain(Model                         model,
         const Material               &material,
         const dealii::Tensor<2, dim> &gradient,
         const dealii::Tensor<1, dim> &u,
         const dealii::Point<dim>     &x);

  /// The strain without the thermal strain, which is given along the axes (axisymmetric: z is the
  /// hoop direction): the argument of stress().
  template <int dim>
  dealii::SymmetricTensor<2, 3>
  elastic_strain(Model                         model,
                 const Material               &material,
                 const dealii::Tensor<2, dim> &gradient,
                 const dealii::Tensor<1, dim> &u,
                 const dealii::Point<dim>     &x,
                 const dealii::Tensor<1, 3>   &thermal_strain);
} // namespace Signorini
