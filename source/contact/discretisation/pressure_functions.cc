#include <signorini/contact/discretisation/pressure_functions.h>
#include <signorini/contact/methods/method.h>
#include <signorini/elasticity/cell_nodes.h>
#include <signorini/mesh/face_nodes.h>

#include <algorithm>

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
    const auto node = elasticity.held_nodes().find(first);
    if (node != elasticity.held_nodes().end() &&
        node->second.free_part(face.normal(xi)).norm() < 0.1)
      return false;
    return elasticity.model() != Model::axisymmetric || degree < 2 ||
           face.position(xi)[0] >= 1e-10 * elasticity.lever();
  }



  namespace
  {
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
          FaceNode   node{indices[fe.component_to_system_index(0, i)], {{0, 0}}, false};
          const auto xi = face_parameter<dim>(face, fe.base_element(0).unit_support_point(i));
          for (unsigned int d = 0; d < dim - 1; ++d)
            node.xi[d] = xi[d];
          node.prescribed = !carries_pressure(elasticity, node.index, fe.degree, patch, xi);
          nodes.push_back(node);
        }
      return nodes;
    }
  } // namespace



  template <int dim>
  unsigned int
  set_pressure_functions(const Elasticity<dim>               &elasticity,
                         const ContactMethod                 &method,
                         const Basis                          kind,
                         const BoundaryFaces<dim>            &slave,
                         const std::vector<PairedPoint<dim>> &paired_points,
                         const std::vector<PairedPoint<dim>> &paired_seams,
                         std::vector<ContactPoint<dim>>      &points,
                         std::vector<Seam<dim>>              &seams)
  {
    // Otherwise a law says what the pressure is, even where nothing can move.
    const bool must_balance =
      method.predictor() == Predictor::multiplier || method.predictor() == Predictor::last_pressure;
    Trace<dim>             trace(elasticity);
    std::vector<SparseRow> shapes;
    std::vector<double>    weights;
    unsigned int           n_prescribed = 0;
    auto                   seam         = paired_seams.begin();
    for (unsigned int first = 0, last = 0; first < points.size(); first = last)
      {
        const auto &[cell, face] = slave.faces[points[first].face];
        trace.reinit(cell, face);
        shapes.clear();
        weights.clear();
        for (; last < points.size() && points[last].face == points[first].face; ++last)
          {
            shapes.push_back(trace.unresolved_shape(paired_points[last].xi));
            weights.push_back(points[last].weight);
          }
        auto       nodes = face_nodes(elasticity, cell, face, slave.patches[points[first].face]);
        const bool all_prescribed =
          std::all_of(nodes.begin(), nodes.end(), [](const auto &node) { return node.prescribed; });
        if (all_prescribed && !must_balance)
          for (FaceNode &node : nodes)
            node.prescribed = false;
        const PressureBasis basis(nodes, shapes, weights, kind);
        const PressureBasis standard(nodes, shapes, weights, Basis::standard);
        n_prescribed += basis.empty();
        seam = std::find_if(seam, paired_seams.end(), [&](const auto &paired) {
          return paired.face >= points[first].face;
        });
        for (; seam != paired_seams.end() && seam->face == points[first].face; ++seam)
          {
            SparseRow &shape = seams[seam - paired_seams.begin()].shape;
            shape            = basis.at(trace.unresolved_shape(seam->xi));
            resolve(elasticity.hanging_nodes(), shape);
          }
        for (unsigned int q = first; q < last; ++q)
          {
            points[q].shape = basis.at(shapes[q - first]);
            resolve(elasticity.hanging_nodes(), points[q].shape);
            if (kind == Basis::standard)
              continue;
            points[q].interpolation = standard.at(shapes[q - first]);
            resolve(elasticity.hanging_nodes(), points[q].interpolation);
          }
      }
    return n_prescribed;
  }



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
  template unsigned int
  set_pressure_functions(const Elasticity<2> &,
                         const ContactMethod &,
                         Basis,
                         const BoundaryFaces<2> &,
                         const std::vector<PairedPoint<2>> &,
                         const std::vector<PairedPoint<2>> &,
                         std::vector<ContactPoint<2>> &,
                         std::vector<Seam<2>> &);
  template unsigned int
  set_pressure_functions(const Elasticity<3> &,
                         const ContactMethod &,
                         Basis,
                         const BoundaryFaces<3> &,
                         const std::vector<PairedPoint<3>> &,
                         const std::vector<PairedPoint<3>> &,
                         std::vector<ContactPoint<3>> &,
                         std::vector<Seam<3>> &);
} // namespace Signorini
