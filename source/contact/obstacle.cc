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
                                    {"punch", make_punch<dim>},
                                    {"cone", make_cone<dim>},
                                    {"gap function", make_gap_function<dim>},
                                    {"STL", make_stl<dim>}};
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
    body.name = name;
    body.declare(section);
  }



  template struct Obstacle<2>;
  template struct Obstacle<3>;
} // namespace Signorini
