// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/pressure_functions.h"

#include "geometry/cell_rule.h"
#include "mesh/face_nodes.h"
#include "solid/cell_nodes.h"
#include <signorini/contact/methods/method.h>
#include <signorini/solid/model.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  bool
  carries_pressure(const Elasticity<dim>        &elasticity,
                   const types::global_dof_index first,
                   const unsigned int            degree,
                   const FacePatch<dim>         &face,
                   const Point<dim - 1>         &xi)
  {
    // A node carries pressure if its displacement has a free component along the normal, and if its
    // function has an area on the axis of axisymmetric models. Hanging nodes move with the nodes
    // that constrain them, which have the same normal up to the curvature of the face.
    if (const auto *entries = elasticity.hanging_nodes().get_constraint_entries(first))
      return std::any_of(entries->begin(), entries->end(), [&](const auto &entry) {
        return carries_pressure(elasticity, entry.first, degree, face, xi);
      });
    const auto node = elasticity.constrained_nodes().find(first);
    if (node != elasticity.constrained_nodes().end() &&
        node->second.free_part(face.normal(xi)).norm() < 0.1)
      return false;
    return elasticity.model() != Model::axisymmetric || degree < 2 ||
           face.position(xi)[0] >= 1e-10 * elasticity.rotation_length_scale();
  }



  namespace
  {
    /// The integral of the function of a node over a face of a given shape, over that of the face.
    /// Lines and squares: the weights of the trapezoidal rule (degree 1) and of Simpson's rule
    /// (degree 2). Functions of degree 2 of the corners of a triangle have no integral, so that
    /// they could carry no pressure: there the pressure is of degree 1, and the nodes between the
    /// corners have the share zero (doc/theory, 3.4).
    template <int n>
    double
    share_of_node(const ReferenceCell &shape, const unsigned int degree, const Point<n> &xi)
    {
      const auto is_between = [&](const double x) { return std::abs(x - 0.5) < 0.25; };
      double     share      = 1;
      if (is_triangle(shape))
        {
          for (unsigned int d = 0; d < n; ++d)
            if (is_between(xi[d]))
              return 0;
          return 1. / 3;
        }
      for (unsigned int d = 0; d < n; ++d)
        share *= degree == 1 ? 1. / 2 : is_between(xi[d]) ? 2. / 3 : 1. / 6;
      return share;
    }

    /// The reference area of a face, with the circumference of axisymmetric models.
    template <int dim>
    double
    area_of(const FacePatch<dim> &patch, const Model model)
    {
      // The area is compared with that of the points with a projection, to see how much of the face
      // is covered; two points in each direction are enough for that.
      const Quadrature<dim - 1> &rule = cell_rule<dim - 1>(patch.reference_cell(), 2);
      double                     area = 0;
      for (unsigned int q = 0; q < rule.size(); ++q)
        area += rule.weight(q) * patch.jacobian(rule.point(q)) *
                measure(model, patch.position(rule.point(q)));
      return area;
    }

    /// Condenses the hanging nodes of pressure functions on one slave face. A hanging node may
    /// depend on a node that carries no pressure: the nodes beside it on the coarser face that do
    /// take its weight in equal parts, so that functions still sum up to one, as PressureBasis does
    /// for nodes of the face itself.
    template <int dim>
    class HangingPressure
    {
    public:
      /// @param degree of the element
      /// @param all_carry also nodes with a prescribed normal displacement carry pressure
      /// @param elsewhere see set_pressure_functions()
      HangingPressure(const Elasticity<dim>       &elasticity,
                      const NodeIndices           &elsewhere,
                      const std::vector<FaceNode> &nodes,
                      const unsigned int           degree,
                      const FacePatch<dim>        &patch,
                      const bool                   all_carry)
      {
        for (const FaceNode &node : nodes)
          if (const auto *entries = elasticity.hanging_nodes().get_constraint_entries(node.index))
            {
              Point<dim - 1> xi;
              for (unsigned int d = 0; d < dim - 1; ++d)
                xi[d] = node.xi[d];
              SparseRow carriers;
              double    others = 0;
              for (const auto &[master, weight] : *entries)
                if ((all_carry || carries_pressure(elasticity, master, degree, patch, xi)) &&
                    elsewhere.count(master) == 0)
                  carriers.emplace_back(master, weight);
                else
                  others += weight;
              for (auto &carrier : carriers)
                carrier.second += others / carriers.size();
              masters.emplace(node.index, carriers);
            }
      }

      /// Replace hanging nodes by carriers of pressure. @param row sorted if it had any
      void
      condense(SparseRow &row) const
      {
        SparseRow result;
        bool      any = false;
        for (const auto &[node, value] : row)
          if (const auto hangs = masters.find(node); hangs != masters.end())
            {
              any = true;
              for (const auto &[master, weight] : hangs->second)
                result.emplace_back(master, weight * value);
            }
          else
            result.emplace_back(node, value);
        if (!any)
          return;
        sum_duplicates(result);
        row = result;
      }

    private:
      std::map<types::global_dof_index, SparseRow> masters;
    };

    /// The nodes of a face, with their parameters, their share of the area of a triangle or
    /// parallelogram, and whether they carry pressure.
    template <int dim>
    std::vector<FaceNode>
    face_nodes(const Elasticity<dim>   &elasticity,
               const CellIterator<dim> &cell,
               const unsigned int       face,
               const FacePatch<dim>    &patch)
    {
      const FiniteElement<dim>            &fe = cell->get_fe();
      std::vector<types::global_dof_index> indices;
      read_indices<dim>(cell, indices);
      std::vector<FaceNode> nodes;
      for (const unsigned int i : nodes_of_face(fe.base_element(0), face))
        {
          FaceNode   node{indices[fe.component_to_system_index(0, i)], {{0, 0}}, false, 1.};
          const auto xi    = face_parameter<dim>(fe.reference_cell(),
                                              face,
                                              fe.base_element(0).unit_support_point(i));
          const auto place = isotropic_coordinates(shape_of_faces(fe.reference_cell()), xi);
          for (unsigned int d = 0; d < dim - 1; ++d)
            node.xi[d] = place[d];
          node.share = share_of_node<dim - 1>(shape_of_faces(fe.reference_cell()), fe.degree, xi);
          node.prescribed = !carries_pressure(elasticity, node.index, fe.degree, patch, xi);
          nodes.push_back(node);
        }
      return nodes;
    }
    /// The nodes that carry the pressure of faces none of whose own nodes can: those of the faces
    /// beside, in equal parts. Such faces are the rule in corners of meshes of triangles, whose
    /// cells have all their corners on the edges of the surface.
    template <int dim>
    class CarriersBeside
    {
    public:
      /// @param ids those of the slave
      CarriersBeside(const Elasticity<dim> &elasticity,
                     const NodeIndices     &elsewhere,
                     const BoundaryIds     &ids)
        : elasticity(elasticity)
        , elsewhere(elsewhere)
        , ids(ids)
      {}

      /// @return the functions of the carriers; none if there are none
      SparseRow
      of(const CellIterator<dim> &cell, const unsigned int face, const FacePatch<dim> &patch)
      {
        if (faces_at.empty())
          find_faces();
        const auto             own = vertices_of(cell, face);
        std::set<unsigned int> seen;
        NodeIndices            carriers;
        for (const unsigned int v : own)
          for (const unsigned int f : faces_at[v])
            if (seen.insert(f).second)
              {
                const auto &[other, of_other] = faces[f];
                const auto vertices           = vertices_of(other, of_other);
                const auto n_common =
                  std::count_if(vertices.begin(), vertices.end(), [&](const unsigned int i) {
                    return own.count(i) > 0;
                  });
                if (n_common != dim - 1)
                  continue;
                for (const FaceNode &node : face_nodes(elasticity, other, of_other, patch))
                  if (!node.prescribed && node.share > 0 && elsewhere.count(node.index) == 0 &&
                      !elasticity.hanging_nodes().is_constrained(node.index))
                    carriers.insert(node.index);
              }
        SparseRow result;
        for (const auto node : carriers)
          result.emplace_back(node, 1. / carriers.size());
        return result;
      }

    private:
      using Vertices = std::set<unsigned int>;

      static Vertices
      vertices_of(const CellIterator<dim> &cell, const unsigned int face)
      {
        Vertices result;
        for (const unsigned int v : cell->face(face)->vertex_indices())
          result.insert(cell->face(face)->vertex_index(v));
        return result;
      }

      /// List the faces of the slave on this rank and on ghost cells.
      void
      find_faces()
      {
        for_each_face(elasticity.dof_handler().active_cell_iterators(),
                      ids,
                      [&](const CellIterator<dim> &cell, const unsigned int face) {
                        for (const unsigned int v : vertices_of(cell, face))
                          faces_at[v].push_back(faces.size());
                        faces.emplace_back(cell, face);
                      });
      }

      const Elasticity<dim>                                  &elasticity;
      const NodeIndices                                      &elsewhere;
      const BoundaryIds                                      &ids;
      std::vector<std::pair<CellIterator<dim>, unsigned int>> faces;
      std::map<unsigned int, std::vector<unsigned int>>       faces_at; ///< vertices
    };
  } // namespace



  // One pressure basis for each slave face with contact points (doc/theory, 3.4). Cost: a small
  // dense problem for each face. Local.
  template <int dim>
  std::vector<PressureNodes>
  set_pressure_functions(const Elasticity<dim>               &elasticity,
                         const ContactMethod                 &method,
                         const Basis                          kind,
                         const BoundaryFaces<dim>            &slave,
                         const BoundaryIds                   &ids,
                         const NodeIndices                   &elsewhere,
                         const std::vector<PairedPoint<dim>> &paired_points,
                         const std::vector<PairedPoint<dim>> &paired_edge_points,
                         std::vector<ContactPoint<dim>>      &points,
                         std::vector<EdgeContactPoint<dim>>  &edge_points)
  {
    // With a multiplier the pressure has to be determined by equilibrium, which is impossible where
    // no node can move; with penalty-like methods the law determines it there too, and the
    // functions are kept.
    const bool must_balance = method.pressure_shift() == PressureShift::multiplier ||
                              method.pressure_shift() == PressureShift::last_pressure;
    Trace<dim>                 trace(elasticity);
    std::vector<SparseRow>     shapes;
    std::vector<double>        weights;
    auto                       edge_point = paired_edge_points.begin();
    std::vector<PressureNodes> result(slave.faces.size());
    CarriersBeside<dim>        beside(elasticity, elsewhere, ids);
    // Points are sorted by faces; the basis is constructed once for each of them.
    for (unsigned int first = 0, last = 0; first < points.size(); first = last)
      {
        const auto &[cell, face] = slave.faces[points[first].face];
        trace.reinit(cell, face);
        shapes.clear();
        weights.clear();
        // Shape functions at the points of the face, with areas.
        for (; last < points.size() && points[last].face == points[first].face; ++last)
          {
            shapes.push_back(trace.unresolved_shape(paired_points[last].xi));
            weights.push_back(points[last].weight);
          }
        const FacePatch<dim> &patch = slave.patches[points[first].face];
        auto                  nodes = face_nodes(elasticity, cell, face, patch);
        const bool all_prescribed   = std::all_of(nodes.begin(), nodes.end(), [](const auto &node) {
          return node.prescribed || node.share == 0;
        });
        if (all_prescribed && !must_balance)
          for (FaceNode &node : nodes)
            node.prescribed = false;
        const auto has_its_own = [&](const FaceNode &node) {
          return !node.prescribed && node.share > 0 && elsewhere.count(node.index) == 0;
        };
        if (std::any_of(nodes.begin(), nodes.end(), has_its_own))
          for (FaceNode &node : nodes)
            node.prescribed = !has_its_own(node);
        const HangingPressure<dim> hanging(elasticity,
                                           elsewhere,
                                           nodes,
                                           cell->get_fe().degree,
                                           patch,
                                           all_prescribed && !must_balance);
        const double        area = area_of(slave.rest[points[first].face], elasticity.model());
        const PressureBasis basis(nodes, shapes, weights, area, kind);
        // The basis in which pressures are evaluated for the output is the standard one also where
        // the dual basis is used.
        const PressureBasis standard(nodes, shapes, weights, area, Basis::standard);
        PressureNodes      &of_face = result[points[first].face];
        of_face.covered             = std::accumulate(weights.begin(), weights.end(), 0.) / area;
        for (const FaceNode &node : nodes)
          if (basis.has(node.index))
            of_face.own.push_back(node.index);
        const SparseRow of_others =
          of_face.own.empty() ? beside.of(cell, face, patch) : SparseRow();
        for (const auto &[node, value] : of_others)
          of_face.own.push_back(node);
        const auto functions_at = [&](const PressureBasis &one, const SparseRow &shape) {
          if (!of_others.empty())
            return of_others;
          SparseRow row = one.at(shape);
          hanging.condense(row);
          return row;
        };
        // Segment edge points of the same face have the same functions.
        edge_point = std::find_if(edge_point, paired_edge_points.end(), [&](const auto &paired) {
          return paired.face >= points[first].face;
        });
        for (; edge_point != paired_edge_points.end() && edge_point->face == points[first].face;
             ++edge_point)
          edge_points[edge_point - paired_edge_points.begin()].multiplier_shape =
            functions_at(basis, trace.unresolved_shape(edge_point->xi));
        for (unsigned int q = first; q < last; ++q)
          {
            points[q].multiplier_shape = functions_at(basis, shapes[q - first]);
            if (kind == Basis::dual && of_others.empty())
              points[q].interpolation = functions_at(standard, shapes[q - first]);
          }
      }
    return result;
  }



  template <int dim>
  NodeIndices
  nodes_of_boundaries(const Elasticity<dim> &elasticity, const std::vector<std::string> &names)
  {
    NodeIndices result;
    BoundaryIds ids;
    for (const std::string &name : names)
      ids.insert(elasticity.mesh().boundary_ids(name).begin(),
                 elasticity.mesh().boundary_ids(name).end());
    std::vector<types::global_dof_index> indices;
    if (!ids.empty())
      for_each_face(elasticity.dof_handler().active_cell_iterators(),
                    ids,
                    [&](const CellIterator<dim> &cell, const unsigned int face) {
                      const FiniteElement<dim> &fe = cell->get_fe();
                      read_indices<dim>(cell, indices);
                      for (const unsigned int i : nodes_of_face(fe.base_element(0), face))
                        result.insert(indices[fe.component_to_system_index(0, i)]);
                    });
    return result;
  }



  template NodeIndices
  nodes_of_boundaries(const Elasticity<2> &, const std::vector<std::string> &);
  template NodeIndices
  nodes_of_boundaries(const Elasticity<3> &, const std::vector<std::string> &);
  template bool
  carries_pressure(const Elasticity<2> &,
                   types::global_dof_index,
                   unsigned int,
                   const FacePatch<2> &,
                   const Point<1> &);
  template bool
  carries_pressure(const Elasticity<3> &,
                   types::global_dof_index,
                   unsigned int,
                   const FacePatch<3> &,
                   const Point<2> &);
  template std::vector<PressureNodes>
  set_pressure_functions(const Elasticity<2> &,
                         const ContactMethod &,
                         Basis,
                         const BoundaryFaces<2> &,
                         const BoundaryIds &,
                         const NodeIndices &,
                         const std::vector<PairedPoint<2>> &,
                         const std::vector<PairedPoint<2>> &,
                         std::vector<ContactPoint<2>> &,
                         std::vector<EdgeContactPoint<2>> &);
  template std::vector<PressureNodes>
  set_pressure_functions(const Elasticity<3> &,
                         const ContactMethod &,
                         Basis,
                         const BoundaryFaces<3> &,
                         const BoundaryIds &,
                         const NodeIndices &,
                         const std::vector<PairedPoint<3>> &,
                         const std::vector<PairedPoint<3>> &,
                         std::vector<ContactPoint<3>> &,
                         std::vector<EdgeContactPoint<3>> &);
} // namespace Signorini
