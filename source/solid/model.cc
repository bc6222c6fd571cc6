// SPDX-License-Identifier: Apache-2.0
#include <signorini/solid/model.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const std::vector<std::pair<std::string, Model>> models = {
      {"plane strain", Model::plane_strain},
      {"plane stress", Model::plane_stress},
      {"axisymmetric", Model::axisymmetric},
      {"solid", Model::solid}};
  } // namespace



  // The names that a scene may use: the three models of two dimensions, or the one of three.
  template <int dim>
  const std::vector<std::string> &
  model_names()
  {
    static const std::vector<std::string> names = [] {
      std::vector<std::string> list;
      for (const auto &[name, model] : models)
        if ((model == Model::solid) == (dim == 3))
          list.push_back(name);
      return list;
    }();
    return names;
  }



  Model
  model_of(const std::string &name)
  {
    const auto found =
      std::find_if(models.begin(), models.end(), [&](const auto &m) { return m.first == name; });
    AssertThrow(found != models.end(), ExcMessage("unknown model " + name));
    return found->second;
  }



  // Volumes and areas of axisymmetric models are those of rings around the axis, so that forces are
  // those of the whole circumference; in plane models they are per unit of thickness.
  template <int dim>
  double
  measure(const Model model, const Point<dim> &x)
  {
    return model == Model::axisymmetric ? 2 * numbers::PI * x[0] : 1.;
  }



  // Plane stress eliminates eps_zz, which changes lambda to 2 lambda mu/(lambda + 2 mu)
  // (doc/theory, 1.2).
  double
  in_plane_lambda(const Model model, const Material &material)
  {
    const double lambda = material.lambda(), mu = material.mu();
    return model == Model::plane_stress ? 2 * lambda * mu / (lambda + 2 * mu) : lambda;
  }



  // The full strain tensor of the displacement gradient, as seen by the law: with eps_zz = 0 in
  // plane strain, u_r/r in axisymmetric models, and the value that makes sigma_zz vanish in plane
  // stress (doc/theory, 1.2).
  template <int dim>
  SymmetricTensor<2, 3>
  strain(const Model           model,
         const Material       &material,
         const Tensor<2, dim> &gradient,
         const Tensor<1, dim> &u,
         const Point<dim>     &x)
  {
    SymmetricTensor<2, 3> result;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        result[i][j] = (gradient[i][j] + gradient[j][i]) / 2;
    if (model == Model::axisymmetric)
      // Close to the axis u_r/r is a quotient of rounding errors; its limit is du_r/dr.
      result[2][2] = x[0] > 1e-10 * std::abs(x[1]) ? u[0] / x[0] : gradient[0][0];
    else if (model == Model::plane_stress)
      result[2][2] = -material.lambda() / (material.lambda() + 2 * material.mu()) * trace(result);
    return result;
  }



  // The strain that produces stress, eps - eps_T.
  template <int dim>
  SymmetricTensor<2, 3>
  elastic_strain(const Model           model,
                 const Material       &material,
                 const Tensor<2, dim> &gradient,
                 const Tensor<1, dim> &u,
                 const Point<dim>     &x,
                 const Tensor<1, 3>   &thermal_strain)
  {
    // In plane stress eps_zz follows from sigma_zz = 0 with the in-plane elastic strains, whatever
    // the thermal strain across is.
    Tensor<2, dim> elastic = gradient;
    for (unsigned int d = 0; d < dim; ++d)
      elastic[d][d] -= thermal_strain[d];
    SymmetricTensor<2, 3> result = strain(model, material, elastic, u, x);
    if (model == Model::plane_strain)
      result[2][2] = -thermal_strain[2];
    else if (model == Model::axisymmetric)
      result[2][2] = strain(model, material, gradient, u, x)[2][2] - thermal_strain[2];
    return result;
  }



  template const std::vector<std::string> &
  model_names<2>();
  template const std::vector<std::string> &
  model_names<3>();
  template double
  measure(Model, const Point<2> &);
  template double
  measure(Model, const Point<3> &);
  template SymmetricTensor<2, 3>
  strain(Model, const Material &, const Tensor<2, 2> &, const Tensor<1, 2> &, const Point<2> &);
  template SymmetricTensor<2, 3>
  strain(Model, const Material &, const Tensor<2, 3> &, const Tensor<1, 3> &, const Point<3> &);
  template SymmetricTensor<2, 3>
  elastic_strain(Model,
                 const Material &,
                 const Tensor<2, 2> &,
                 const Tensor<1, 2> &,
                 const Point<2> &,
                 const Tensor<1, 3> &);
  template SymmetricTensor<2, 3>
  elastic_strain(Model,
                 const Material &,
                 const Tensor<2, 3> &,
                 const Tensor<1, 3> &,
                 const Point<3> &,
                 const Tensor<1, 3> &);
} // namespace Signorini
