// SPDX-License-Identifier: Apache-2.0
#include <signorini/contact/pair.h>
#include <signorini/parameters/section.h>

#include <array>
#include <cmath>
#include <utility>

namespace Signorini
{
  template <int dim>
  void
  ContactPair<dim>::declare(Section &section)
  {
    section.add(
      "Slave",
      slave,
      "BODY.BOUNDARY; contact is integrated over it. Choose the softer body or, of bodies of equal stiffness, the one with the finer mesh (up to twice as fine)");
    section.add("Master",
                master,
                "BODY.BOUNDARY, or the name of an obstacle; the same as Slave for self-contact");
    // Former names of keys and choices are accepted for one release, with a note that names the new
    // ones.
    section.add_choice(
      "Law",
      is_tied,
      {{"contact", false}, {"tied", true}},
      "contact: the surfaces press on each other, and slide with the Friction of the pair; tied: they are glued, where they "
      "touch at the start up to a tenth of a face, or lie within the Search distance, and keep the gaps that their meshes "
      "leave, or that of Initial gap");
    section.rename_key("Sides", "Slave choice");
    section.add_choice(
      "Slave choice",
      sides,
      {{"automatic", SideChoice::automatic}, {"as named", SideChoice::as_named}},
      "automatic: slave and master are exchanged if the slave is so much stiffer or finer that the contact pressure "
      "would oscillate (the signs in results.json still refer to Slave and Master as named); as named: never");
    section.add(
      "Initial gap",
      initial_gap,
      "'from geometry', 'closed' (zero everywhere), a formula in x,y,z,t [length], or, of tied surfaces, 'kept' "
      "(gaps that the meshes leave are kept without strain: their default)");
    section.rename_key("Closed up to", "Closure tolerance");
    section.add(
      "Closure tolerance",
      closes_below,
      "initial gaps up to this value, and initial overlaps, are closed without strain, as "
      "by ADJUST in Abaqus; negative: none [length]");
    section.rename_key("Separates", "Separation");
    section.rename_choice("Separation", "yes", "allowed");
    section.rename_choice("Separation", "no", "none");
    section.add_choice(
      "Separation",
      can_separate,
      {{"allowed", true}, {"none", false}},
      "none: no-separation (bilateral) contact. Points that touch at the start, or lie within the "
      "Search distance, keep their gap and may carry tension, as a flat platen under a given force");
    section.rename_key("Interference", "Interference ramp");
    section.add("Interference ramp",
                interference,
                "fraction of the initial overlap (and of the initial gap of a no-separation pair) "
                "that is applied, formula in t: 1: at once; t: linear ramp");
    friction.declare(section);
    compliance.declare(section);
    section.add(
      "Search distance",
      search_distance,
      "radius of the contact search: points with a larger initial gap are no candidates for contact; 0: "
      "estimated from the expected motion, and enlarged if bodies move farther [length]",
      non_negative);
    image.declare(section);
    pretension.declare(section);
    strength.declare(section);
    declare_times(section, "the pair");
    section.rename_key("Directions", "Extent directions");
    section.add("Extent directions",
                directions,
                "directions along which the extent of the contact area is reported, in addition to "
                "the axes: vectors, separated by semicolons");
    if (section.reading())
      check_keys(section);
  }



  // What the combinations of keys imply, and which are invalid.
  template <int dim>
  void
  ContactPair<dim>::check_keys(Section &section)
  {
    for (const dealii::Point<dim> &direction : directions)
      if (direction.norm() == 0)
        section.fail("Extent directions", "the zero vector has no direction; remove it");
    if (slave == master && !image.is_master())
      section.fail(image.turns() ? "Master rotation" : "Master shift",
                   "requires a slave and a master; give the two cuts different boundaries");
    if (is_tied)
      {
        // Keys with their defaults are accepted: the scene that a run writes has all of them.
        const std::array<std::pair<std::string, bool>, 4> other_than_default = {
          {{"Separation", can_separate && section.is_set("Separation")},
           {"Friction", !friction.is_zero() && !strength.given()},
           {"Friction limit", std::isfinite(friction.limit) && !strength.given()},
           {"Closure tolerance", closes_below >= 0}}};
        for (const auto &[key, is_other] : other_than_default)
          if (is_other)
            section.fail(key,
                         "does not apply to tied surfaces" +
                           std::string(key == "Separation" || key == "Closure tolerance" ?
                                         "" :
                                         " whose bond does not fail") +
                           "; remove it, or set Law = contact");
        can_separate = false;
        if (!section.is_set("Initial gap"))
          initial_gap = "kept";
        if (slave == master)
          section.fail("Law", "a surface cannot be tied to itself; set Law = contact");
        if (from > 0 && (initial_gap.text != "kept" || pretension.given()))
          section.fail("Start time",
                       "of tied surfaces requires Initial gap = kept, and no pretension: they are "
                       "glued as they are then");
      }
    pretension.check_keys(section, is_tied);
    strength.check_keys(section, is_tied, pretension.given());
    // The image of a surface that is exchanged would be that of the other one.
    if (!master_is_in_place())
      sides = SideChoice::as_named;
    keeps_gaps = initial_gap.text == "kept";
    if (keeps_gaps && !is_tied)
      section.fail("Initial gap",
                   "'kept' applies to tied surfaces only; write 'from geometry' or 'closed'");
    compliance.check_keys(section, !can_separate, is_tied || !friction.is_zero());
    slave_location  = section.source_of("Slave");
    master_location = section.source_of("Master");
    if (interference.depends_on_place())
      section.fail(
        "Interference ramp",
        "depends on x, y or z, but is one factor for the whole pair; use a formula in t alone");
    if (gap_is_given() && closes_below >= 0)
      section.fail("Closure tolerance",
                   "applies to Initial gap = from geometry only; remove Initial gap or this key");
    // The formula is compiled once for its errors, so that they are reported with the key and not
    // in the middle of a search.
    if (gap_is_given() && initial_gap.text != "closed")
      try
        {
          Expression<dim>{initial_gap};
        }
      catch (const SceneError &error)
        {
          section.fail("Initial gap",
                       std::string(error.what()) + "; or write 'from geometry' or 'closed'");
        }
  }



  template <int dim>
  bool
  ContactPair<dim>::gap_depends_on_time() const
  {
    return gap_is_given() && initial_gap.text != "closed" &&
           Expression<dim>(initial_gap).depends_on_time();
  }



  // Slave and master change their roles; `exchanged` remembers it for results, whose signs refer to
  // the names in the scene.
  template <int dim>
  void
  ContactPair<dim>::exchange()
  {
    std::swap(slave, master);
    std::swap(slave_location, master_location);
    exchanged = !exchanged;
    self_side = -self_side;
  }



  template struct ContactPair<2>;
  template struct ContactPair<3>;
} // namespace Signorini
