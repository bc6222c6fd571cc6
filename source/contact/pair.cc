#include <signorini/contact/pair.h>
#include <signorini/parameters/section.h>

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
      "BODY.BOUNDARY; contact is integrated over it: the softer side, or the finer one of equal stiffness, up to twice as fine");
    section.add(
      "Master",
      master,
      "BODY.BOUNDARY, or the name of an obstacle; the slave itself, where a surface folds onto itself");
    section.add_choice(
      "Sides",
      sides,
      {{"automatic", SideChoice::automatic}, {"as named", SideChoice::as_named}},
      "automatic: slave and master are exchanged where the slave is so much stiffer or finer that its pressure would "
      "oscillate; results keep the signs of the names");
    section.add("Initial gap",
                initial_gap,
                "'from geometry', 'closed' (zero everywhere), or a formula in x,y,z,t [length]");
    section.add(
      "Closed up to",
      closed_up_to,
      "gaps at the start up to this, and overlaps, are taken for closed, without strain, as "
      "by ADJUST of a deck; negative: none are [length]");
    section.add(
      "Separates",
      separates,
      "yes, or no: what touches at the start, or is within the Search distance, keeps its "
      "distance, slides freely, and may pull: as a flat platen under a given force");
    section.add("Interference",
                interference,
                "share of initial overlaps (and of gaps that a pair closes that never separates) "
                "that counts, formula in t: 1: at once; t: ramped");
    section.add(
      "Search distance",
      search_distance,
      "points that are farther apart at the start never touch; 0: chosen from the motion that is expected, "
      "and widened where bodies move farther [length]",
      non_negative);
    section.add(
      "Directions",
      directions,
      "along which the extent of the contact zone is reported, beside the axes: vectors, separated by "
      "semicolons");
    if (!section.reading())
      return;
    for (const dealii::Point<dim> &direction : directions)
      if (direction.norm() == 0)
        section.fail("Directions", "the zero vector has no direction");
    slave_place  = section.place_of("Slave");
    master_place = section.place_of("Master");
    if (interference.depends_on_place())
      section.fail(
        "Interference",
        "depends on the place, but is one share for the whole pair; write it in t alone");
    if (gap_is_given() && closed_up_to >= 0)
      section.fail("Closed up to", "is of gaps from geometry; take Initial gap out");
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



  template <int dim>
  void
  ContactPair<dim>::exchange()
  {
    std::swap(slave, master);
    std::swap(slave_place, master_place);
    exchanged = !exchanged;
    self_side = -self_side;
  }



  template struct ContactPair<2>;
  template struct ContactPair<3>;
} // namespace Signorini
