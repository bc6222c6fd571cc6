// SPDX-License-Identifier: Apache-2.0
#include "solid/fluid_spread.h"

#include "solid/cell_nodes.h"
#include "solid/gradient_at_point.h"
#include "solid/scalar_elements.h"
#include "solid/wet_faces.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <deal.II/base/mpi.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using FluidCell = typename DoFHandler<dim>::active_cell_iterator;

    /// A face of a load on this rank.
    template <int dim>
    struct FluidFace
    {
      FluidCell<dim> cell;
      unsigned int   number;
      /// The first degree of freedom of each vertex, which stands for the vertex.
      std::vector<types::global_dof_index> vertices;
      Point<dim>                           middle;
      double                               area;
      bool                                 is_wet, is_tied = false;
    };



    /// The faces of a load on this rank, and what flows along them.
    template <int dim>
    class Spread
    {
    public:
      Spread(const Elasticity<dim> &elasticity, const Load<dim> &load)
        : elasticity(elasticity)
        , load(load)
        , elements(scalar_elements(elasticity.finite_elements()))
        , all_values(elasticity.mesh().surface_mappings(),
                     elements,
                     gauss_rules<dim, dim - 1>(elasticity.finite_elements(), 2),
                     update_values | update_quadrature_points | update_normal_vectors |
                       update_JxW_values)
        , all_gradients(elasticity.mesh().mappings(),
                        elements,
                        gauss_rules<dim, dim - 1>(elasticity.finite_elements(), 2),
                        update_values | update_gradients | update_quadrature_points)
        , all_dofs(dofs_of_nodes(elasticity.finite_elements()))
        , comm(elasticity.mesh().communicator())
      {
        const BoundaryIds ids = boundaries_of(elasticity.mesh(), load);
        for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned() && cell->at_boundary())
            for (const unsigned int f : cell->face_indices())
              if (cell->face(f)->at_boundary() && ids.count(cell->face(f)->boundary_id()) > 0)
                add_face(cell, f);
      }

      /// Find the contact pressures of all faces, and which of them are tied.
      void
      find_contact(const LA::Vector &u,
                   const LA::Vector &contact_force,
                   const LA::Vector &tied_force)
      {
        contact_pressures  = pressures(u, contact_force);
        const auto shares  = pressures(u, tied_force);
        double     largest = 0;
        for (unsigned int i = 0; i < faces.size(); ++i)
          {
            largest          = std::max(largest, contact_pressures[i]);
            faces[i].is_tied = shares[i] > least_share;
          }
        rounding = relative_rounding * Utilities::MPI::max(largest, comm);
      }

      /// Mark the vertices of the faces at the entries.
      void
      start_at_entries()
      {
        for (const Point<dim> &entry : load.fluid_entries)
          {
            double least = std::numeric_limits<double>::max(), size = 0;
            for (const FluidFace<dim> &face : faces)
              if (const double d = distance(face, entry); d < least)
                {
                  least = d;
                  size  = face.cell->face(face.number)->diameter();
                }
            const double closest = Utilities::MPI::min(least, comm);
            size                 = Utilities::MPI::max(least == closest ? size : 0., comm);
            if (!(closest <= size))
              throw SceneError("Loads/" + load.name + "/Fluid entry: a point is " +
                               short_text(closest) + " away from the Boundaries of the load, " +
                               "where faces have a size of " + short_text(size) +
                               "; write a point on them");
            for (const FluidFace<dim> &face : faces)
              if (distance(face, entry) <= closest + 1e-9 * size)
                starts.insert(starts.end(), face.vertices.begin(), face.vertices.end());
          }
      }

      /// Wet what can be reached. Collective.
      /// @return whether the load has changed on this rank
      bool
      advance(const FluidSpread how)
      {
        bool may_enter = how == FluidSpread::next_faces, has_changed = false;
        for (bool is_growing = true; is_growing;)
          {
            const LA::Vector reached = wet_vertices();
            bool             is_more = false;
            for (unsigned int i = 0; i < faces.size(); ++i)
              {
                FluidFace<dim> &face       = faces[i];
                const bool      is_reached = std::any_of(face.vertices.begin(),
                                                    face.vertices.end(),
                                                    [&](const auto v) { return reached(v) > 0; });
                if (face.is_wet || face.is_tied || !is_reached)
                  continue;
                const double p = load.pressure.value(face.middle, elasticity.time());
                if (contact_pressures[i] <= rounding || (may_enter && contact_pressures[i] < p))
                  {
                    face.is_wet = is_more = true;
                    load.wet->faces.insert({face.cell->id(), face.number});
                    has_changed |= p != 0;
                  }
              }
            may_enter  = false;
            is_growing = Utilities::MPI::max(is_more ? 1 : 0, comm) > 0;
          }
        return has_changed;
      }

      WetArea
      wet_area()
      {
        WetArea result;
        for (const FluidFace<dim> &face : faces)
          {
            result.total += face.area;
            result.wet += face.is_wet ? face.area : 0.;
          }
        return {Utilities::MPI::sum(result.wet, comm), Utilities::MPI::sum(result.total, comm)};
      }

    private:
      void
      add_face(const FluidCell<dim> &cell, const unsigned int f)
      {
        FluidFace<dim> face{cell, f, {}, cell->face(f)->center(), 0, pressure_acts(load, *cell, f)};
        for (const unsigned int v : cell->face(f)->vertex_indices())
          face.vertices.push_back(cell->vertex_dof_index(
            cell->reference_cell().face_to_cell_vertices(f, v, 1), 0, cell->active_fe_index()));
        all_values.reinit(cell, f, 0, 0, 0);
        const FEFaceValues<dim> &values = all_values.get_present_fe_values();
        for (const unsigned int q : values.quadrature_point_indices())
          face.area += values.JxW(q) * measure(elasticity.model(), values.quadrature_point(q));
        faces.push_back(face);
      }

      /// The mean pressures on the faces of forces on nodes, along the normals of the faces: nodes
      /// have the force on them over their share of the surface, both along the normal. Collective.
      std::vector<double>
      pressures(const LA::Vector &u, LA::Vector force)
      {
        std::vector<double> result;
        const LA::Vector    ghosted = elasticity.with_ghosts(u);
        LA::Vector          area    = elasticity.zero_vector();
        visit(ghosted, [&](const FluidFace<dim> &face, const auto &dofs, const auto &areas) {
          Vector<double> of_cell(face.cell->get_fe().n_dofs_per_cell());
          for (unsigned int i = 0; i < areas.size(); ++i)
            for (unsigned int d = 0; d < dim; ++d)
              of_cell(dofs[i * dim + d]) = areas[i][d];
          read_indices<dim>(face.cell, indices);
          elasticity.hanging_nodes().distribute_local_to_global(of_cell, indices, area);
        });
        area.compress(VectorOperation::add);
        // Hanging nodes have no forces of their own: they get the means of their neighbours, of
        // both, before these are divided.
        elasticity.hanging_nodes().distribute(force);
        elasticity.hanging_nodes().distribute(area);
        const LA::Vector forces   = elasticity.with_ghosts(force),
                         of_nodes = elasticity.with_ghosts(area);
        visit(ghosted, [&](const FluidFace<dim> &face, const auto &dofs, const auto &areas) {
          read_indices<dim>(face.cell, indices);
          double         pressure = 0;
          Tensor<1, dim> sum;
          for (const Tensor<1, dim> &one : areas)
            sum += one;
          const Tensor<1, dim> n = sum / sum.norm();
          for (unsigned int i = 0; i < areas.size(); ++i)
            {
              double pushed = 0, extent = 0;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const auto at = indices[dofs[i * dim + d]];
                  pushed -= forces(at) * n[d];
                  extent += of_nodes(at) * n[d];
                }
              if (areas[i].norm() > 0 && extent > 0)
                pressure += (areas[i] * n) / (sum * n) * pushed / extent;
            }
          result.push_back(pressure);
        });
        return result;
      }

      /// The shortest distance of a point from vertices and middle of a face.
      double
      distance(const FluidFace<dim> &face, const Point<dim> &x) const
      {
        const auto &of_mesh = face.cell->face(face.number);
        double      result  = face.middle.distance(x);
        for (const unsigned int v : of_mesh->vertex_indices())
          result = std::min(result, of_mesh->vertex(v).distance(x));
        return result;
      }

      /// Call act(face, dofs, areas) for each face of this rank: the degrees of freedom of its cell
      /// node by node, and for each node int N n da over the current face.
      template <typename Act>
      void
      visit(const LA::Vector &ghosted, const Act &act)
      {
        Vector<double> values_of_u;
        for (FluidFace<dim> &face : faces)
          {
            const unsigned int                                i = face.cell->active_fe_index();
            const typename Triangulation<dim>::cell_iterator &of_mesh = face.cell;
            all_values.reinit(of_mesh, face.number, i, 0, i);
            all_gradients.reinit(of_mesh, face.number, i, 0, i);
            const FEFaceValues<dim> &values    = all_values.get_present_fe_values();
            const auto              &gradients = all_gradients.get_present_fe_values();
            const auto              &dofs      = all_dofs[i];
            values_of_u.reinit(dofs.size());
            face.cell->get_dof_values(ghosted, values_of_u);
            std::vector<Tensor<1, dim>> areas(dofs.size() / dim);
            for (const unsigned int q : values.quadrature_point_indices())
              {
                Tensor<1, dim> n = values.normal_vector(q);
                if (elasticity.is_finite_strain())
                  {
                    // Nanson: n da = J F^-T N dA.
                    const Tensor<2, 3> F =
                      gradient_at_point(elasticity.model(), gradients, dofs, q, values_of_u);
                    const Tensor<2, 3> G = determinant(F) * invert(F);
                    n                    = 0;
                    for (unsigned int a = 0; a < dim; ++a)
                      for (unsigned int K = 0; K < dim; ++K)
                        n[a] += G[K][a] * values.normal_vector(q)[K];
                  }
                const double dA =
                  values.JxW(q) * measure(elasticity.model(), values.quadrature_point(q));
                for (unsigned int k = 0; k < areas.size(); ++k)
                  areas[k] += values.shape_value(k, q) * dA * n;
              }
            act(face, dofs, areas);
          }
      }

      /// 1 or more at the vertices of wet faces of all ranks, and of faces at the entries; with
      /// ghosts. Collective.
      LA::Vector
      wet_vertices() const
      {
        LA::Vector marks = elasticity.zero_vector();
        const auto mark  = [&](const std::vector<types::global_dof_index> &vertices) {
          for (const auto v : vertices)
            marks(v) += 1.;
        };
        mark(starts);
        for (const FluidFace<dim> &face : faces)
          if (face.is_wet)
            mark(face.vertices);
        marks.compress(VectorOperation::add);
        return elasticity.with_ghosts(marks);
      }

      const Elasticity<dim>                       &elasticity;
      const Load<dim>                             &load;
      const hp::FECollection<dim>                  elements;
      hp::FEFaceValues<dim>                        all_values, all_gradients;
      const std::vector<std::vector<unsigned int>> all_dofs;
      const MPI_Comm                               comm;
      std::vector<FluidFace<dim>>                  faces;
      std::vector<double>                          contact_pressures;
      std::vector<types::global_dof_index>         starts, indices;
      double                                       rounding = 0; ///< of contact pressures

      static constexpr double relative_rounding = 1e-9, least_share = 1e-3;
    };
  } // namespace



  template <int dim>
  bool
  has_fluids(const std::vector<Load<dim>> &loads)
  {
    return std::any_of(loads.begin(), loads.end(), [](const Load<dim> &load) {
      return !load.fluid_entries.empty();
    });
  }



  template <int dim>
  bool
  spread_fluids(const Elasticity<dim> &elasticity,
                const LA::Vector      &u,
                const LA::Vector      &contact_force,
                const LA::Vector      &tied_force,
                const FluidSpread      how)
  {
    bool has_advanced = false;
    for (const Load<dim> &load : elasticity.loads())
      if (load.wet)
        {
          if (how == FluidSpread::open_faces)
            {
              has_advanced |= !load.wet->faces.empty();
              load.wet->faces.clear();
            }
          Spread<dim> spread(elasticity, load);
          spread.find_contact(u, contact_force, tied_force);
          spread.start_at_entries();
          has_advanced |= spread.advance(how);
        }
    return Utilities::MPI::max(has_advanced ? 1 : 0, elasticity.mesh().communicator()) > 0;
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
                                 const LA::Vector &,                                               \
                                 const LA::Vector &,                                               \
                                 FluidSpread);                                                     \
  template void    check_fluid_entries(const Elasticity<dim> &);                                   \
  template bool    has_fluids(const std::vector<Load<dim>> &);                                     \
  template WetArea wet_area(const Elasticity<dim> &, const Load<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
