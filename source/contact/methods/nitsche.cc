#include <signorini/contact/methods/nitsche.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  Nitsche::declare(Section &section)
  {
    section.add_choice("Theta",
                       theta_name,
                       {"1", "0", "-1"},
                       "1: symmetric systems; 0: fewest terms; -1: stable for any Factor");
    section.add(
      "Factor",
      safety_factor,
      "of the smallest parameter that is stable, which follows from an eigenvalue problem "
      "on each face",
      positive);
    section.add("Unbiased",
                two_sided,
                "treat both surfaces of a pair alike: either is slave to the other, by half");
  }



  double
  Nitsche::theta() const
  {
    return std::stod(theta_name);
  }
} // namespace Signorini
