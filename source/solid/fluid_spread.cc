// SPDX-License-Identifier: Apache-2.0
#include "solid/fluid_spread.h"

#include "base/solver_failure.h"
#include "solid/fluid_faces.h"
#include "solid/wet_faces.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The faces of a load on this rank, and what flows along them.
    template <int dim>
    class Spread
    {
    public:
      Spread(const Elasticity<dim> &elasticity, const Load<dim> &load)
        : elasticity(elasticity)
        , load(load)
        , geometry(elasticity, load)
        , faces(geometry.all)
        , comm(elasticity.mesh().communicator())
      {}

      /// Find the contact pressures of all faces, and which of them are closed, or tied. Faces
      /// beside closed ones have nodes in common with these: at most half of such a face seems to
      /// touch.
      void
      find_contact(const LA::Vector &u, const PointForces &forces)
      {
        constexpr double half = 0.5;
        const auto       of_faces =
          geometry.pressures(u, {&forces.pressure, &forces.touching, &forces.tied});
        for (unsigned int i = 0; i < faces.size(); ++i)
          {
            faces[i].contact_pressure = of_faces[0][i];
            faces[i].is_closed        = of_faces[1][i] >= half;
            faces[i].is_tied          = of_faces[2][i] >= half;
          }
      }

      /// Let the fluid be nowhere.
      void
      dry()
      {
        load.wet->faces.clear();
        for (FluidFace<dim> &face : faces)
          face.is_wet = false;
      }

      /// True if wet faces have closed that are not at an edge of the wet region. Collective.
      bool
      has_closed_inside() const
      {
        const LA::Vector dry =
          vertices_of([](const FluidFace<dim> &face) { return !face.is_wet && face.is_closed; });
        bool any = false;
        for (const FluidFace<dim> &face : faces)
          any |= face.is_wet && face.is_closed && !touches(face, dry);
        return Utilities::MPI::max(any ? 1 : 0, comm) > 0;
      }

      /// Mark the vertices of the faces at the entries: on each body whose surface is as near as
      /// one of its faces is large.
      void
      start_at_entries()
      {
        const Mesh<dim>  &mesh = elasticity.mesh();
        std::vector<bool> has_entry(mesh.n_bodies(), false), has_faces(mesh.n_bodies(), false);
        for (const Point<dim> &entry : load.fluid_entries)
          {
            bool   is_on_any = false;
            double nearest = std::numeric_limits<double>::max(), its_size = 0;
            for (unsigned int body = 0; body < mesh.n_bodies(); ++body)
              {
                double least = std::numeric_limits<double>::max(), size = 0;
                for (const FluidFace<dim> &face : faces)
                  if (mesh.body(face.cell) == body)
                    {
                      has_faces[body] = true;
                      if (const double d = face.distance(entry); d < least)
                        {
                          least = d;
                          size  = face.cell->face(face.number)->diameter();
                        }
                    }
                const double closest = Utilities::MPI::min(least, comm);
                size                 = Utilities::MPI::max(least == closest ? size : 0., comm);
                if (closest < nearest)
                  {
                    nearest  = closest;
                    its_size = size;
                  }
                if (!(closest <= size))
                  continue;
                is_on_any = has_entry[body] = true;
                for (const FluidFace<dim> &face : faces)
                  if (mesh.body(face.cell) == body && face.distance(entry) <= closest + 1e-9 * size)
                    starts.insert(starts.end(), face.vertices.begin(), face.vertices.end());
              }
            if (!is_on_any)
              throw SceneError(
                beginning() + "a point is " + short_text(nearest) +
                " away from the Boundaries of the load, where faces have a size of " +
                short_text(its_size) + "; write a point on them");
          }
        for (unsigned int body = 0; body < mesh.n_bodies(); ++body)
          if (!has_entry[body] && Utilities::MPI::max(has_faces[body] ? 1 : 0, comm) > 0)
            throw SceneError(beginning() + "no point is on the Boundaries of " +
                             mesh.body_name(body) +
                             ", which the fluid could not reach; add one, separated by ';'");
      }

      /// Wet what can be reached past open faces. Collective.
      /// @param may_enter whether the fluid first forces its way onto faces next to wet ones
      /// @return whether the load has changed on this rank
      bool
      advance(bool may_enter)
      {
        bool has_changed = false;
        for (bool is_growing = true; is_growing; may_enter = false)
          {
            const LA::Vector reached = wet_vertices();
            bool             is_more = false;
            for (FluidFace<dim> &face : faces)
              if (!face.is_wet && !face.is_tied && touches(face, reached) &&
                  (!face.is_closed || (may_enter && is_forced(face))))
                {
                  face.is_wet = is_more = true;
                  load.wet->faces.insert({face.cell->id(), face.number});
                  has_changed |= largest_pressure(face) > 0;
                }
            is_growing = Utilities::MPI::max(is_more ? 1 : 0, comm) > 0;
          }
        return has_changed;
      }

      WetArea
      wet_area()
      {
        start_at_entries();
        const LA::Vector reached = wet_vertices();
        WetArea          result;
        for (const FluidFace<dim> &face : faces)
          {
            result.total += face.area;
            result.wet += face.is_wet ? face.area : 0.;
            if (!face.is_wet && touches(face, reached))
              result.at_edge += largest_pressure(face) * face.area;
          }
        return {Utilities::MPI::sum(result.wet, comm),
                Utilities::MPI::sum(result.total, comm),
                Utilities::MPI::sum(result.at_edge, comm)};
      }

    private:
      std::string
      beginning() const
      {
        return "Loads/" + load.name + "/Fluid entry: ";
      }

      bool
      touches(const FluidFace<dim> &face, const LA::Vector &marks) const
      {
        return std::any_of(face.vertices.begin(), face.vertices.end(), [&](const auto v) {
          return marks(v) > 0;
        });
      }

      /// True if the contact pressure of a face is less than that of the fluid; if they are equal,
      /// rounding does not decide.
      bool
      is_forced(const FluidFace<dim> &face) const
      {
        constexpr double rounding = 1e-6;
        const double     p        = load.pressure.value(face.middle, elasticity.time());
        return face.contact_pressure < (1 - rounding) * p;
      }

      /// The largest size of the pressure at the vertices and in the middle of a face.
      double
      largest_pressure(const FluidFace<dim> &face) const
      {
        const auto &of_mesh = face.cell->face(face.number);
        const auto  size    = [&](const Point<dim> &x) {
          return std::abs(load.pressure.value(x, elasticity.time()));
        };
        double result = size(face.middle);
        for (const unsigned int v : of_mesh->vertex_indices())
          result = std::max(result, size(of_mesh->vertex(v)));
        return result;
      }

      /// 1 or more at the vertices of the faces of all ranks that are chosen, and at some others;
      /// with ghosts. Collective.
      template <typename Choice>
      LA::Vector
      vertices_of(const Choice                               &is_chosen,
                  const std::vector<types::global_dof_index> &more = {}) const
      {
        LA::Vector marks = elasticity.zero_vector();
        const auto mark  = [&](const std::vector<types::global_dof_index> &vertices) {
          for (const auto v : vertices)
            marks(v) += 1.;
        };
        mark(more);
        for (const FluidFace<dim> &face : faces)
          if (is_chosen(face))
            mark(face.vertices);
        marks.compress(VectorOperation::add);
        return elasticity.with_ghosts(marks);
      }

      /// Those of wet faces, and of faces at the entries.
      LA::Vector
      wet_vertices() const
      {
        return vertices_of([](const FluidFace<dim> &face) { return face.is_wet; }, starts);
      }

      const Elasticity<dim>               &elasticity;
      const Load<dim>                     &load;
      FluidFaces<dim>                      geometry;
      std::vector<FluidFace<dim>>         &faces; ///< those of `geometry`
      const MPI_Comm                       comm;
      std::vector<types::global_dof_index> starts; ///< vertices at the entries
    };
  } // namespace



  namespace
  {
    /// Throws SolverFailure on all ranks if two fluids are on one face.
    template <int dim>
    void
    check_that_fluids_are_apart(const Elasticity<dim> &elasticity)
    {
      const auto &loads = elasticity.loads();
      for (auto a = loads.begin(); a != loads.end(); ++a)
        for (auto b = loads.begin(); b != a; ++b)
          if (a->wet && b->wet)
            {
              const bool meet =
                std::any_of(a->wet->faces.begin(), a->wet->faces.end(), [&](const auto &face) {
                  return b->wet->faces.count(face) > 0;
                });
              if (Utilities::MPI::max(meet ? 1 : 0, elasticity.mesh().communicator()) > 0)
                throw SolverFailure("the fluids " + b->name + " and " + a->name +
                                    " meet: what sealed one from the other is open");
            }
    }
  } // namespace



  template <int dim>
  bool
  has_fluids(const std::vector<Load<dim>> &loads)
  {
    return std::any_of(loads.begin(), loads.end(), [](const Load<dim> &load) {
      return !load.fluid_entries.empty();
    });
  }



  // Open faces fill first, for all fluids, since their pressure changes that of contact.
  template <int dim>
  bool
  spread_fluids(const Elasticity<dim> &elasticity,
                const LA::Vector      &u,
                const PointForces     &forces,
                const FluidSpread      how)
  {
    const MPI_Comm comm   = elasticity.mesh().communicator();
    const auto     on_any = [&](const bool x) { return Utilities::MPI::max(x ? 1 : 0, comm) > 0; };
    std::deque<Spread<dim>> fluids;
    for (const Load<dim> &load : elasticity.loads())
      if (load.wet)
        fluids.emplace_back(elasticity, load);
    bool has_changed = false;
    for (Spread<dim> &fluid : fluids)
      {
        if (how == FluidSpread::nowhere)
          {
            fluid.dry();
            continue;
          }
        fluid.find_contact(u, forces);
        fluid.start_at_entries();
        if (how == FluidSpread::open_faces ||
            (how == FluidSpread::without_closed_faces && fluid.has_closed_inside()))
          {
            fluid.dry();
            has_changed = true;
          }
        if (how != FluidSpread::without_closed_faces || has_changed)
          has_changed |= fluid.advance(false);
      }
    has_changed = on_any(has_changed);
    if (!has_changed && how == FluidSpread::next_faces)
      for (Spread<dim> &fluid : fluids)
        has_changed |= fluid.advance(true);
    check_that_fluids_are_apart(elasticity);
    return on_any(has_changed);
  }



  template <int dim>
  void
  check_fluid_entries(const Elasticity<dim> &elasticity)
  {
    for (const Load<dim> &load : elasticity.loads())
      if (load.wet)
        Spread<dim>(elasticity, load).start_at_entries();
  }



  template <int dim>
  WetArea
  wet_area(const Elasticity<dim> &elasticity, const Load<dim> &load)
  {
    return Spread<dim>(elasticity, load).wet_area();
  }



#define INSTANTIATE(dim)                                                                           \
  template bool    spread_fluids(const Elasticity<dim> &,                                          \
                                 const LA::Vector &,                                               \
                                 const PointForces &,                                              \
                                 FluidSpread);                                                     \
  template void    check_fluid_entries(const Elasticity<dim> &);                                   \
  template bool    has_fluids(const std::vector<Load<dim>> &);                                     \
  template WetArea wet_area(const Elasticity<dim> &, const Load<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
