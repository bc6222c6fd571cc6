#include "scene/left_out.h"
#include "verdict/checks.h"

namespace Signorini
{
  template <int dim>
  std::vector<Finding>
  check_left_out(const Scene<dim> &scene, const bool acts)
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
  check_left_out(const Scene<2> &, bool);
  template std::vector<Finding>
  check_left_out(const Scene<3> &, bool);
} // namespace Signorini
