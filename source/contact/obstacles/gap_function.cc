#include <signorini/contact/obstacles/shapes.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class GapFunction : public ObstacleShape<dim>
    {
    public:
      GapFunction()
      {
        normal[dim - 1] = -1;
      }

      void
      declare(Section &section) override
      {
        section.add_required("Normal",
                             normal,
                             "direction in which the gap opens, out of the obstacle; any length");
        section.add("Gap", gap, "formula in x,y,z of the slave point [length]");
        if (normal.norm() == 0)
          section.fail("Normal", "must not be zero");
      }

      ObstaclePlace<dim>
      closest(const Point<dim> &x) const override
      {
        return {gap.value(x), normal / normal.norm()};
      }

    private:
      Point<dim>      normal;
      Expression<dim> gap;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_gap_function()
  {
    return std::make_unique<GapFunction<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_gap_function();
  template std::unique_ptr<ObstacleShape<3>>
  make_gap_function();
} // namespace Signorini
