#include <signorini/output/point_values.h>
#include <signorini/parameters/text.h>
#include <signorini/verdict/checks.h>

#include <cmath>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Areas of one pair.
    struct Zone
    {
      double active = 0, candidates = 0;       ///< of all faces that were looked at
      double touched_faces = 0, n_touched = 0; ///< faces that carry pressure
      double smallest_gap = std::numeric_limits<double>::max();
    };

    template <int dim>
    Zone
    zone_of(const Snapshot<dim> &s, const unsigned int pair)
    {
      Zone zone;
      auto which = s.contact.pair.begin();
      for (const auto i : s.active.locally_owned_elements())
        if (*which++ == pair)
          {
            zone.active += s.active(i) * s.contact.weight(i);
            zone.candidates += s.contact.weight(i);
            zone.smallest_gap = std::min(zone.smallest_gap, s.gap(i));
          }
      const PointValues values = point_values(s, pair);
      struct Face
      {
        double area    = 0;
        bool   touched = false;
      };
      std::map<unsigned int, Face> faces;
      for (std::size_t q = 0; q < values.pressure.size(); ++q)
        {
          Face &face = faces[s.surfaces[pair].points[q].face];
          face.area += s.surfaces[pair].points[q].weight;
          face.touched |= values.pressure[q] > 0;
        }
      for (const auto &[number, face] : faces)
        if (face.touched)
          {
            zone.touched_faces += face.area;
            zone.n_touched += 1;
          }
      const MPI_Comm comm = s.elasticity.mesh().communicator();
      for (double *sum : {&zone.active, &zone.candidates, &zone.touched_faces, &zone.n_touched})
        *sum = Utilities::MPI::sum(*sum, comm);
      zone.smallest_gap = Utilities::MPI::min(zone.smallest_gap, comm);
      return zone;
    }

    Finding
    acts(const std::string &name, const Zone &zone)
    {
      Finding finding;
      finding.check   = "acts";
      finding.where   = "pair " + name;
      finding.over    = Finding::Over::best;
      finding.value   = zone.active > 0;
      finding.limit   = 1;
      finding.outcome = zone.active > 0 ? Outcome::passed : Outcome::warned;
      finding.what    = "its surfaces never touch";
      finding.cure = "look at the gaps that --check prints, at signs of loads and supports, and at "
                     "Slave and Master";
      return finding;
    }

    Finding
    stands(const std::string &name, const Sides &sides)
    {
      constexpr double percents = 4;
      Finding          finding;
      finding.check   = "sides";
      finding.where   = "pair " + name;
      finding.value   = sides.risk();
      finding.limit   = percents;
      finding.outcome = finding.value <= percents ? Outcome::passed : Outcome::warned;
      finding.what    = "the slave is so much stiffer or finer than the master (" +
                     short_text(sides.modulus, 2) + " times as stiff, faces " +
                     short_text(sides.size, 2) +
                     " times as large) that its pressure may oscillate by percents";
      finding.cure = "exchange Slave and Master (Sides = automatic does), or refine the master";
      return finding;
    }

    /// Unless all that may touch does: then its edges are those of the surfaces.
    template <int dim>
    Finding
    resolved(const std::string &name, const unsigned int degree, const Zone &zone)
    {
      constexpr double few = 5, whole = 0.95;
      Finding          finding;
      finding.check = "faces across the contact zone";
      finding.where = "pair " + name;
      finding.over  = Finding::Over::last;
      finding.limit = few;
      if (zone.n_touched == 0)
        return finding;
      const double faces  = zone.active / (zone.touched_faces / zone.n_touched);
      const double across = dim == 2 ? faces : std::sqrt(faces * 4 / numbers::PI);
      finding.value       = degree * across;
      const bool is_whole = zone.active >= whole * zone.candidates;
      finding.outcome     = finding.value < few && !is_whole ? Outcome::warned : Outcome::passed;
      finding.what        = "too few: the largest pressure may be off by tens of percent";
      finding.cure =
        "refine there (Mesh/Contact refinements, Zones) to 5 faces or more, nodes with degree 2";
      return finding;
    }
  } // namespace



  template <int dim>
  std::vector<Finding>
  check_pairs(const Scene<dim> &scene, const Snapshot<dim> &now)
  {
    std::vector<Finding> findings;
    for (unsigned int i = 0; i < now.pairs.size(); ++i)
      {
        const Zone zone = zone_of(now, i);
        if (!now.pairs[i].found)
          findings.push_back(acts(now.pairs[i].name, zone));
        if (zone.active > 0 && scene.obstacle_of(now.pairs[i]) == nullptr)
          findings.push_back(stands(now.pairs[i].name, now.surfaces[i].sides));
        if (const Finding finding =
              resolved<dim>(now.pairs[i].name, scene.degree_of(now.pairs[i].slave), zone);
            zone.active > 0)
          findings.push_back(finding);
      }
    return findings;
  }



  template std::vector<Finding>
  check_pairs(const Scene<2> &, const Snapshot<2> &);
  template std::vector<Finding>
  check_pairs(const Scene<3> &, const Snapshot<3> &);
} // namespace Signorini
