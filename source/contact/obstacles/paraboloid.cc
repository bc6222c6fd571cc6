#include <signorini/contact/obstacles/shapes.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class Paraboloid : public ObstacleShape<dim>
    {
    public:
      Paraboloid()
      {
        normal[dim - 1] = -1;
      }

      void
      declare(Section &section) override
      {
        section.add("Apex", apex, "the point that sticks out most [length]");
        section.add_required("Normal",
                             normal,
                             "axis at the apex, out of the obstacle, towards the body; any length");
        section.add("Radius", radius, "of curvature at the apex [length]", positive);
        if (normal.norm() == 0)
          section.fail("Normal", "must not be zero");
      }

      ObstaclePlace<dim>
      closest(const Point<dim> &x) const override
      {
        const Tensor<1, dim> n      = normal / normal.norm();
        const Tensor<1, dim> r      = x - apex;
        const double         height = r * n;
        return {height + (r.norm_square() - height * height) / (2 * radius), n};
      }

    private:
      Point<dim> apex, normal;
      double     radius = 1;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_paraboloid()
  {
    return std::make_unique<Paraboloid<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_paraboloid();
  template std::unique_ptr<ObstacleShape<3>>
  make_paraboloid();
} // namespace Signorini
