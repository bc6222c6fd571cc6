#include <signorini/scene/formulation.h>

namespace Signorini
{
  namespace
  {
    /// From here on degree 1 is too stiff by several per cent, and multigrid takes twice the
    /// iterations.
    constexpr double nearly_incompressible = 0.48;

    /// What keeps a body from being mixed, and the cure; empty: nothing.
    template <int dim>
    std::string
    obstacle_to_mixed(const Scene<dim> &scene,
                      const Body<dim>  &body,
                      const Material   &material,
                      const bool        has_degree)
    {
      if (model_of(scene.model) == Model::plane_stress)
        return "the mixed formulation is not available for Model = plane stress, which does not lock";
      if (body.degree == 1 || (body.degree == 0 && has_degree && scene.degree == 1))
        return "the pressure of degree 1 is not stable (inf-sup condition); set Degree = 2";
      if (!(material.poissons_ratio > 0))
        return "requires a Poisson's ratio above 0";
      if (scene.deformation != Deformation::small && material.law == "Saint Venant-Kirchhoff")
        return "Law = Saint Venant-Kirchhoff has no volumetric part; set Law = neo-Hooke";
      if (!scene.goals.quantities.empty() || scene.goals.has_targets())
        return "errors of the volumetric stress are not estimated; remove Accuracy/Quantity and Target error";
      return {};
    }

    /// Nothing but cells of degree 1 that lock would be refined for a quantity, without end.
    template <int dim>
    bool
    needs_degree_2(const Scene<dim> &scene, const Material &material)
    {
      return model_of(scene.model) != Model::plane_stress &&
             material.poissons_ratio >= nearly_incompressible && !scene.goals.quantities.empty();
    }

    /// One of the materials of a body. @param place in the scene
    template <int dim>
    void
    choose_formulation(Scene<dim>        &scene,
                       Body<dim>         &body,
                       Material          &material,
                       const std::string &place,
                       const bool         has_degree)
    {
      const std::string obstacle = obstacle_to_mixed(scene, body, material, has_degree);
      if (material.formulation == Formulation::mixed && !obstacle.empty())
        throw SceneError(place + "/Formulation = mixed: " + obstacle);
      material.is_mixed = material.formulation == Formulation::mixed ||
                          (material.formulation == Formulation::automatic &&
                           material.poissons_ratio >= nearly_incompressible && obstacle.empty());
      if (!material.is_mixed && material.poissons_ratio == 0.5)
        throw SceneError(place + "/Poisson's ratio = 0.5 requires Formulation = mixed" +
                         (obstacle.empty() ? "" : ", but " + obstacle) +
                         "; or set a Poisson's ratio below 0.5");
      const bool is_open = body.degree == 0 && (!has_degree || scene.degree == 0);
      if (is_open && (material.is_mixed || needs_degree_2(scene, material)))
        body.degree = 2;
    }
  } // namespace



  template <int dim>
  void
  choose_formulations(Scene<dim> &scene, const bool has_degree)
  {
    for (Body<dim> &body : scene.bodies)
      {
        const std::string place = "Bodies/" + body.name;
        choose_formulation(scene, body, body.material, place, has_degree);
        for (MaterialOfCells &one : body.others)
          choose_formulation(
            scene, body, one.material, place + "/Materials/" + one.name, has_degree);
      }
  }



  template void
  choose_formulations(Scene<2> &, bool);
  template void
  choose_formulations(Scene<3> &, bool);
} // namespace Signorini
