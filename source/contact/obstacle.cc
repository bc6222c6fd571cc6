#include <signorini/contact/obstacle.h>
#include <signorini/contact/obstacles/shapes.h>
#include <signorini/parameters/section.h>

#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Registry = std::vector<std::pair<std::string, std::unique_ptr<ObstacleShape<dim>> (*)()>>;

    // The registry: one line a shape.
    template <int dim>
    const Registry<dim> registry = {{"plane", make_plane<dim>},
                                    {"sphere", make_sphere<dim>},
                                    {"cylinder", make_cylinder<dim>},
                                    {"paraboloid", make_paraboloid<dim>},
                                    {"gap function", make_gap_function<dim>},
                                    {"STL", make_stl<dim>}};
  } // namespace



  namespace
  {
    template <int dim>
    bool
    depends_on_place(const VectorExpression<dim> &motion)
    {
      Point<dim> elsewhere;
      for (unsigned int d = 0; d < dim; ++d)
        elsewhere[d] = 1.37 + d;
      for (const double t : {0.31, 1., 2.7})
        if ((motion.value(elsewhere, t) - motion.value(Point<dim>(), t)).norm() > 0)
          return true;
      return false;
    }
  } // namespace



  template <int dim>
  void
  Obstacle<dim>::declare(Section &section)
  {
    std::vector<std::string> names;
    for (const auto &entry : registry<dim>)
      names.push_back(entry.first);
    section.add_choice("Shape", type, names, "shape of the rigid surface");
    if (section.reading() || !shape)
      for (const auto &[name, make] : registry<dim>)
        if (name == type)
          shape = make();
    shape->declare(section);
    section.add(
      "Displacement",
      displacement,
      "motion of the obstacle, one formula in t a component, separated by ';'; empty: at rest [length]");
    if (section.reading() && depends_on_place(displacement))
      section.fail("Displacement",
                   "depends on the place, but an obstacle is rigid; write it in t alone");
  }



  template <int dim>
  Tensor<1, dim>
  Obstacle<dim>::motion(const double t) const
  {
    return displacement.value(Point<dim>(), t);
  }



  template struct Obstacle<2>;
  template struct Obstacle<3>;
} // namespace Signorini
