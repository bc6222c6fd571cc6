#include <signorini/contact/discretisation/gap_operator.h>
#include <signorini/state/state.h>

namespace Signorini
{
  using namespace dealii;

  SurfaceField
  places_of_rows(const GapOperator &contact,
                 const LA::Vector  &pressure,
                 const LA::Vector  &active,
                 const unsigned int dim)
  {
    const auto with_ghosts = [&](const LA::Vector &rows) {
      LA::Vector result(contact.weight.locally_owned_elements(),
                        contact.origin.readable,
                        contact.weight.get_mpi_communicator());
      result = rows;
      return result;
    };
    SurfaceField result(dim);
    if (contact.empty())
      return result;
    const LA::Vector p = with_ghosts(pressure), a = with_ghosts(active);
    for (const FacePlaces &face : contact.origin.places)
      {
        std::vector<PlaceValue> values;
        for (const auto &[place, rows] : face.places)
          {
            PlaceValue value;
            value.place = place;
            for (const auto &[row, weight] : rows)
              {
                value.pressure += weight * p(row);
                value.active = std::max(value.active, double(a(row)));
              }
            values.push_back(value);
          }
        result.set(face.id, values);
      }
    return result;
  }



  void
  rows_of_places(const SurfaceField &field,
                 const GapOperator  &contact,
                 LA::Vector         &pressure,
                 LA::Vector         &active)
  {
    // Not by copying one to the other: where as many rows lie on other ranks than before, a copy
    // would keep the old layout on some of them.
    pressure = contact.zero();
    active   = contact.zero();
    if (contact.empty())
      return;
    const MPI_Comm      comm = contact.weight.get_mpi_communicator();
    std::vector<FaceId> wanted;
    for (const FacePlaces &face : contact.origin.places)
      wanted.push_back(face.id);
    const SurfaceField known = field.known_at(wanted, comm);

    // Faces around a node all know it. A copy of another vector would bring along what that one had
    // for other ranks.
    const IndexSet          owned = contact.weight.locally_owned_elements();
    std::vector<LA::Vector> sums(3); // number, pressure, active
    for (LA::Vector &sum : sums)
      sum.reinit(owned, comm);
    for (const FacePlaces &face : contact.origin.places)
      for (const auto &[place, rows] : face.places)
        if (rows.size() == 1)
          if (const auto value = known.at(face.id, place))
            {
              const auto row = rows.front().first;
              sums[0](row) += 1;
              sums[1](row) += value->pressure;
              sums[2](row) += value->active;
            }
    for (LA::Vector &sum : sums)
      sum.compress(VectorOperation::add);
    for (const auto i : owned)
      if (const double n = sums[0](i); n > 0)
        {
          pressure(i) = sums[1](i) / n;
          active(i)   = sums[2](i) > 0.5 * n ? 1. : 0.;
        }
    pressure.compress(VectorOperation::insert);
    active.compress(VectorOperation::insert);
  }
} // namespace Signorini
