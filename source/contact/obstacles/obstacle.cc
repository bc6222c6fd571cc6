// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shapes.h"
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/parameters/section.h>

#include <deal.II/base/exceptions.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Registry = std::vector<std::pair<std::string, std::unique_ptr<ObstacleShape<dim>> (*)()>>;

    // The registry: one line for each shape.
    template <int dim>
    const Registry<dim> registry = {{"plane", make_plane<dim>},
                                    {"sphere", make_sphere<dim>},
                                    {"cylinder", make_cylinder<dim>},
                                    {"paraboloid", make_paraboloid<dim>},
                                    {"punch", make_punch<dim>},
                                    {"cone", make_cone<dim>},
                                    {"profile", make_profile<dim>},
                                    {"gap function", make_gap_function<dim>},
                                    {"STL", make_stl<dim>},
                                    {"attached", make_attached<dim>}};
  } // namespace



  template <int dim>
  std::vector<std::string>
  obstacle_names()
  {
    std::vector<std::string> names;
    for (const auto &entry : registry<dim>)
      names.push_back(entry.first);
    return names;
  }



  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_shape(const std::string &name)
  {
    for (const auto &[known, make] : registry<dim>)
      if (known == name)
        return make();
    AssertThrow(false, ExcMessage("unknown shape " + name));
    return nullptr;
  }



  template <int dim>
  void
  Obstacle<dim>::declare(Section &section)
  {
    section.add_choice("Shape", type, obstacle_names<dim>(), "shape of the rigid surface");
    if (section.reading() || !shape)
      shape = make_shape<dim>(type);
    shape->declare(section);
    body.name = name;
    body.declare(section);
  }



  template struct Obstacle<2>;
  template struct Obstacle<3>;
  template std::unique_ptr<ObstacleShape<2>>
  make_shape(const std::string &);
  template std::unique_ptr<ObstacleShape<3>>
  make_shape(const std::string &);
  template std::vector<std::string>
  obstacle_names<2>();
  template std::vector<std::string>
  obstacle_names<3>();
} // namespace Signorini
