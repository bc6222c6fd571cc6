#include <signorini/scene/left_out.h>
#include <signorini/verdict/checks.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  template <int dim>
  std::vector<Finding>
  check_left_out(const Scene<dim>            &scene,
                 const Snapshot<dim>         &now,
                 const std::vector<Extremes> &extremes,
                 const double                 largest_force)
  {
    Finding finding;
    finding.check = "left out";
    finding.over  = Finding::Over::best; // a history may begin with nothing
    std::string acting;
    for (const LeftOut &one : left_out_of(scene.left_out))
      if (one.acts())
        {
          ++finding.value;
          acting += (acting.empty() ? "" : "; ") + one.kind + ": " + one.what;
        }
    if (finding.value == 0)
      return {};
    // Beside rounding.
    constexpr double rounding = 1e-12;
    const double     size     = now.elasticity.mesh().size();
    const bool       moves    = std::any_of(extremes.begin(), extremes.end(), [&](const auto &one) {
      return one.motion > rounding * size;
    });
    double           stiffest = 0;
    for (const Material &material : now.elasticity.all_materials())
      stiffest = std::max(stiffest, material.youngs_modulus);
    const bool acts = moves || largest_force > rounding * stiffest * std::pow(size, dim - 1);
    finding.outcome = acts ? Outcome::warned : Outcome::failed;
    finding.what =
      (acts ? "the scene was imported without " :
              "nothing moves and nothing acts in this scene, which was imported without ") +
      acting;
    finding.cure = "say it in the scene, as a Support, a Load, an Obstacle or a pair, and take it "
                   "out of Left out";
    return {finding};
  }



  template std::vector<Finding>
  check_left_out(const Scene<2> &, const Snapshot<2> &, const std::vector<Extremes> &, double);
  template std::vector<Finding>
  check_left_out(const Scene<3> &, const Snapshot<3> &, const std::vector<Extremes> &, double);
} // namespace Signorini
