// SPDX-License-Identifier: Apache-2.0
#include "driver/state.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The data of all rows that outlive a mesh, as vectors of numbers: tangential tractions and
    /// internal vectors as three components in the reference configuration, then internal scalars;
    /// see SurfacePointValue.
    PointVectors
    history_of(const GapOperator &contact, const ContactState &state)
    {
      const auto &tangents = contact.tangential.at_rest;
      const auto  at_rest  = [&](const PointVectors &components, PointVectors &result) {
        for (unsigned int d = 0; d < 3; ++d)
          {
            result.push_back(contact.zero());
            for (unsigned int a = 0; a < tangents.size() && d < tangents[a].size(); ++a)
              {
                LA::Vector term = components[a];
                term.scale(tangents[a][d]);
                result.back() += term;
              }
          }
      };
      PointVectors result;
      if (!tangents.empty())
        at_rest({state.traction.begin() + 1, state.traction.end()}, result);
      for (const PointVectors &vector : state.internal.vectors)
        at_rest(vector, result);
      result.insert(result.end(), state.internal.scalars.begin(), state.internal.scalars.end());
      return result;
    }

    /// The inverse of history_of(): components along the tangents of the rows from vectors in the
    /// reference configuration.
    void
    copy_history(const GapOperator &contact, const PointVectors &history, ContactState &state)
    {
      const auto  &tangents = contact.tangential.at_rest;
      unsigned int next     = 0;
      const auto   along    = [&](const unsigned int a) {
        LA::Vector result = contact.zero();
        for (unsigned int d = 0; d < tangents[a].size(); ++d)
          {
            LA::Vector term = history[next + d];
            term.scale(tangents[a][d]);
            result += term;
          }
        return result;
      };
      for (unsigned int a = 0; a < tangents.size(); ++a)
        state.traction[a + 1] = along(a);
      next += tangents.empty() ? 0 : 3;
      for (PointVectors &vector : state.internal.vectors)
        {
          for (unsigned int a = 0; a < vector.size(); ++a)
            vector[a] = along(a);
          next += 3;
        }
      for (LA::Vector &scalar : state.internal.scalars)
        scalar = history[next++];
    }
  } // namespace



  // Values at the positions of the slave faces, from rows with ghosts: weighted sums over the rows
  // of a position (several at hanging nodes). The status is the largest of them. Collective.
  SurfaceField
  to_surface_field(const GapOperator &contact, const ContactState &state, const unsigned int dim)
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
    const LA::Vector p = with_ghosts(state.pressure()), s = with_ghosts(state.status);
    PointVectors     history;
    for (const LA::Vector &number : history_of(contact, state))
      history.push_back(with_ghosts(number));
    for (const SurfacePoints &face : contact.origin.places)
      {
        std::vector<SurfacePointValue> values;
        for (const SurfacePlace &place : face.places)
          {
            SurfacePointValue value;
            value.place = place.point;
            value.history.assign(history.size(), 0.);
            for (const auto &[row, weight] : place.rows)
              {
                value.pressure += weight * p(row);
                value.status = std::max(value.status, double(s(row)));
                for (unsigned int k = 0; k < history.size(); ++k)
                  value.history[k] += weight * history[k](row);
              }
            values.push_back(value);
          }
        result.set(face.id, values);
      }
    return result;
  }



  // Values of rows from a field of another mesh or search. Values of all faces around a node are
  // averaged; faces are requested from the ranks that have them. A position between hanging nodes
  // determines no row. Collective.
  ContactState
  from_surface_field(const SurfaceField   &field,
                     const GapOperator    &contact,
                     const InternalFields &internal)
  {
    // The vectors are not copied from each other: a copy would take over the ghost layout of the
    // source, which may differ between ranks.
    ContactState state{contact.zeros(), contact.zero(), internal, {}};
    if (contact.empty())
      return state;
    const MPI_Comm      comm = contact.weight.get_mpi_communicator();
    std::vector<FaceId> wanted;
    for (const SurfacePoints &face : contact.origin.places)
      wanted.push_back(face.id);
    const SurfaceField known = field.gathered_at(wanted, comm);

    // All faces around a node have a value for it. Each vector is initialised on its own, as above.
    const IndexSet    &owned     = contact.weight.locally_owned_elements();
    const unsigned int n_history = history_of(contact, state).size();
    PointVectors       sums(3 + n_history); // number, pressure, status, history
    for (LA::Vector &sum : sums)
      sum.reinit(owned, comm);
    for (const SurfacePoints &face : contact.origin.places)
      for (const SurfacePlace &place : face.places)
        if (place.is_row)
          if (const auto value = known.at(face.id, place.point))
            {
              const auto row = place.rows.front().first;
              sums[0](row) += 1;
              sums[1](row) += value->pressure;
              sums[2](row) += value->status;
              for (unsigned int k = 0; k < n_history && k < value->history.size(); ++k)
                sums[3 + k](row) += value->history[k];
            }
    for (LA::Vector &sum : sums)
      sum.compress(VectorOperation::add);
    PointVectors history(n_history, contact.zero());
    for (const auto i : owned)
      if (const double n = sums[0](i); n > 0)
        {
          state.traction[0](i) = sums[1](i) / n;
          // Where faces around a node do not agree, the node is closed if at least about half of
          // them are.
          state.status(i) = sums[2](i) > 0.5 * n ? std::max(1., std::round(sums[2](i) / n)) : 0.;
          for (unsigned int k = 0; k < n_history; ++k)
            history[k](i) = sums[3 + k](i) / n;
        }
    state.traction[0].compress(VectorOperation::insert);
    state.status.compress(VectorOperation::insert);
    for (LA::Vector &number : history)
      number.compress(VectorOperation::insert);
    copy_history(contact, history, state);
    return state;
  }
} // namespace Signorini
