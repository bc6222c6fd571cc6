// SPDX-License-Identifier: Apache-2.0
#include "fields/cross_sections.h"

#include "fields/contact_force.h"
#include "solid/cell_forces.h"
#include "solid/cell_nodes.h"
#include "solid/kernel.h"
#include "solid/pressure_kernel.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>
#include <signorini/fields/probe.h>
#include <signorini/parameters/section.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  CrossSection<dim>::declare(Section &section)
  {
    section.add("Bodies", bodies, "bodies that the plane cuts; empty: all");
    section.add(
      "Point",
      point,
      "a point of the plane, about which the moment is; the plane is one of the undeformed "
      "bodies [length]");
    section.add_noted(
      "Normal",
      normal,
      "into the part whose force on the other one is reported, so that tension along "
      "it is positive; any length");
    if (normal.norm() == 0)
      section.fail("Normal", "must not be zero");
  }



  namespace
  {
    /// A cross section on the mesh.
    template <int dim>
    class Cut
    {
    public:
      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      /// Throws SceneError where a body does not exist.
      Cut(const Elasticity<dim> &elasticity, const CrossSection<dim> &section)
        : mesh(elasticity.mesh())
        , section(section)
        , normal(section.normal / section.normal.norm())
        , is_cut(mesh.n_bodies(), section.bodies.empty())
      {
        for (const std::string &name : section.bodies)
          {
            unsigned int body = 0;
            while (body < mesh.n_bodies() && mesh.body_name(body) != name)
              ++body;
            if (body == mesh.n_bodies())
              throw SceneError(place() + "/Bodies = " + name + ": there is no such body");
            is_cut[body] = true;
          }
      }

      /// True if the point is beyond the plane. Nodes on the plane are before it, whatever their
      /// rounding errors are.
      bool
      is_beyond(const Point<dim> &x) const
      {
        constexpr double rounding = 1e-9;
        return (x - section.point) * normal > rounding * mesh.size();
      }

      /// True if the cell is on both sides. The values at hanging nodes follow from nodes of the
      /// parent of the cell, which therefore counts with it.
      /// @param nodes positions of the nodes of the cell
      bool
      cuts(const Cell &cell, const std::vector<Point<dim>> &nodes) const
      {
        if (!is_cut[mesh.body(cell)])
          return false;
        std::array<bool, 2> found{{false, false}};
        for (const Point<dim> &x : nodes)
          found[is_beyond(x)] = true;
        if (cell->level() > 0)
          for (const unsigned int v : cell->parent()->vertex_indices())
            found[is_beyond(cell->parent()->vertex(v))] = true;
        return found[0] && found[1];
      }

      /// Its place in the scene, for messages.
      std::string
      place() const
      {
        return "Output/Cross sections/" + section.name;
      }

      const Mesh<dim>         &mesh;
      const CrossSection<dim> &section;
      const Tensor<1, dim>     normal;

    private:
      std::vector<bool> is_cut; ///< by body
    };



    /// The contact forces as tractions at the contact points, and what Nitsche's method adds, which
    /// is no traction and has no resultant. Collective.
    template <int dim>
    std::pair<LA::Vector, LA::Vector>
    parts_of_contact(const Snapshot<dim> &s)
    {
      const PointVectors &p = s.contact_state.traction;
      PointVectors        stress =
        s.contact.stress(s.displacement, s.elasticity.volumetric_stress().coefficients());
      std::copy_n(p.begin(), std::min(p.size(), stress.size()), stress.begin());
      LA::Vector tractions = s.contact.total_force(p, stress), others = contact_force(s);
      others -= tractions;
      return {tractions, others};
    }



    /// The sizes of the forces on nodes from loads on a cell.
    template <int dim>
    class LoadsOfCells
    {
    public:
      explicit LoadsOfCells(const Elasticity<dim> &e)
        : dead(dead_loads(e))
        , of_loads(e.mesh(), e.finite_elements(), e.model(), dead, e.time())
        , of_pressures(e)
      {}

      double
      size(const typename DoFHandler<dim>::active_cell_iterator &cell, const LA::Vector &ghosted)
      {
        of_loads.assemble(cell, load);
        values.reinit(load.size());
        if (!of_pressures.empty())
          {
            cell->get_dof_values(ghosted, values);
            if (of_pressures.assemble(cell, values, pressure))
              load += pressure;
          }
        double sum = 0;
        for (unsigned int i = 0; i < load.size(); ++i)
          if (const auto [component, node] = cell->get_fe().system_to_component_index(i);
              component == 0)
            {
              Tensor<1, dim> force;
              for (unsigned int d = 0; d < dim; ++d)
                force[d] = load(cell->get_fe().component_to_system_index(d, node));
              sum += force.norm();
            }
        return sum;
      }

    private:
      const std::vector<Load<dim>> dead;
      LoadKernel<dim>              of_loads;
      PressureKernel<dim>          of_pressures;
      Vector<double>               load, values, pressure;
    };



    /// The internal forces of the cells that a plane cuts, hanging nodes condensed. Collective.
    /// @param cut_dofs receives the owned degrees of freedom of these cells
    /// @param loads receives the sizes of the loads on these cells of this rank
    template <int dim>
    LA::Vector
    forces_of_cut_cells(const Elasticity<dim>             &elasticity,
                        const LA::Vector                  &ghosted,
                        const Cut<dim>                    &cut,
                        CellNodes<dim>                    &nodes_of,
                        std::set<types::global_dof_index> &cut_dofs,
                        double                            &loads)
    {
      LA::Vector                           result = elasticity.zero_vector();
      CellForces<dim>                      forces(elasticity);
      LoadsOfCells<dim>                    loads_of(elasticity);
      std::vector<types::global_dof_index> indices;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cut.cuts(cell, nodes_of(cell)))
          {
            read_indices<dim>(cell, indices);
            elasticity.hanging_nodes().distribute_local_to_global(forces.internal(cell, ghosted),
                                                                  indices,
                                                                  result);
            loads += loads_of.size(cell, ghosted);
            for (const auto i : indices)
              if (elasticity.owned().is_element(i))
                cut_dofs.insert(i);
          }
      result.compress(VectorOperation::add);
      return result;
    }



    /// The resultant of forces at the owned nodes beyond the plane, each of which counts once.
    template <int dim>
    Resultant<dim>
    resultant_beyond(const Elasticity<dim> &elasticity,
                     const LA::Vector      &ghosted,
                     const LA::Vector      &forces,
                     const Cut<dim>        &cut,
                     CellNodes<dim>        &nodes_of)
    {
      const IndexSet                      &owned        = elasticity.owned();
      const bool                           axisymmetric = elasticity.model() == Model::axisymmetric;
      Resultant<dim>                       result;
      std::vector<bool>                    counted(owned.n_elements(), false);
      std::vector<types::global_dof_index> indices;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        {
          if (!cell->is_locally_owned())
            continue;
          read_indices<dim>(cell, indices);
          if (std::none_of(indices.begin(), indices.end(), [&](const auto i) {
                return owned.is_element(i) && forces(i) != 0;
              }))
            continue;
          const FiniteElement<dim>      &fe    = cell->get_fe();
          const std::vector<Point<dim>> &nodes = nodes_of(cell);
          for (unsigned int i = 0; i < nodes.size(); ++i)
            {
              const auto [component, node] = fe.system_to_component_index(i);
              if (component != 0 || !owned.is_element(indices[i]) ||
                  counted[owned.index_within_set(indices[i])] || !cut.is_beyond(nodes[i]))
                continue;
              counted[owned.index_within_set(indices[i])] = true;
              Point<dim>     x                            = nodes[i];
              Tensor<1, dim> force;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const auto dof = indices[fe.component_to_system_index(d, node)];
                  if (!axisymmetric || d > 0)
                    force[d] = forces(dof);
                  if (elasticity.is_finite_strain())
                    x[d] += ghosted(dof);
                }
              result += resultant_of(Point<dim>(x - cut.section.point), force);
            }
        }
      const MPI_Comm comm = elasticity.mesh().communicator();
      result.force        = Utilities::MPI::sum(result.force, comm);
      result.moment = axisymmetric ? Tensor<1, 3>() : Utilities::MPI::sum(result.moment, comm);
      return result;
    }
  } // namespace



  template <int dim>
  void
  check_cross_sections(const Elasticity<dim>                &elasticity,
                       const std::vector<CrossSection<dim>> &sections)
  {
    CellNodes<dim> nodes_of(elasticity.mesh(), elasticity.finite_elements());
    for (const CrossSection<dim> &section : sections)
      {
        const Cut<dim> cut(elasticity, section);
        if (elasticity.model() == Model::axisymmetric && cut.normal[0] != 0)
          throw SceneError(cut.place() +
                           "/Normal: planes of axisymmetric models are perpendicular to the axis; "
                           "set Normal = 0, 1");
        bool cuts = false;
        for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
          cuts = cuts || (cell->is_locally_owned() && cut.cuts(cell, nodes_of(cell)));
        if (!Utilities::MPI::logical_or(cuts, elasticity.mesh().communicator()))
          throw SceneError(cut.place() + "/Point = " + point_text(section.point) +
                           ": the plane cuts none of the bodies" +
                           (section.bodies.empty() ? "" : " " + join(section.bodies)) +
                           "; move the Point into one of them");
      }
  }



  template <int dim>
  std::vector<SectionForce<dim>>
  section_forces(const Snapshot<dim> &s, const std::vector<CrossSection<dim>> &sections)
  {
    std::vector<SectionForce<dim>> result;
    if (sections.empty())
      return result;
    const Elasticity<dim> &elasticity = s.elasticity;
    CellNodes<dim>         nodes_of(elasticity.mesh(), elasticity.finite_elements());
    const LA::Vector       ghosted      = elasticity.with_ghosts(s.displacement);
    const auto [tractions, no_traction] = parts_of_contact(s);
    for (const CrossSection<dim> &section : sections)
      {
        const Cut<dim>                    cut(elasticity, section);
        std::set<types::global_dof_index> cut_dofs;
        double                            sizes = 0;
        LA::Vector                        forces =
          forces_of_cut_cells(elasticity, ghosted, cut, nodes_of, cut_dofs, sizes);
        for (const auto i : cut_dofs)
          {
            forces(i) -= no_traction(i);
            sizes += std::abs(tractions(i));
          }
        forces.compress(VectorOperation::add);
        result.push_back({resultant_beyond(elasticity, ghosted, forces, cut, nodes_of),
                          Utilities::MPI::sum(sizes, elasticity.mesh().communicator())});
      }
    return result;
  }



#define INSTANTIATE(dim)                                                                                \
  template struct CrossSection<dim>;                                                                    \
  template void                           check_cross_sections(const Elasticity<dim> &,                 \
                                                               const std::vector<CrossSection<dim>> &); \
  template std::vector<SectionForce<dim>> section_forces(const Snapshot<dim> &,                         \
                                                         const std::vector<CrossSection<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
