// SPDX-License-Identifier: Apache-2.0
#include "fields/peak.h"

#include "linear_algebra/dense.h"

#include <algorithm>
#include <map>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Node = types::global_dof_index;

    /// A node of the slave surface with its pressure, as it is sent to other ranks.
    template <int dim>
    struct NodeValue
    {
      Node       node;
      Point<dim> position;
      double     pressure;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &node &position &pressure;
      }
    };

    /// @return the nodes, by number, of all faces that have one of some nodes, from all ranks.
    /// Collective.
    template <int dim>
    std::map<Node, NodeValue<dim>>
    nodes_around(const std::set<Node>              &nodes,
                 const std::vector<SlaveFace<dim>> &faces,
                 const LA::Vector                  &pressure,
                 const MPI_Comm                     comm)
    {
      std::vector<NodeValue<dim>> own;
      for (const SlaveFace<dim> &face : faces)
        if (std::any_of(face.nodes.begin(), face.nodes.end(), [&](const Node node) {
              return nodes.count(node) > 0;
            }))
          for (unsigned int k = 0; k < face.nodes.size(); ++k)
            own.push_back({face.nodes[k], face.positions[k], pressure(face.nodes[k])});
      std::map<Node, NodeValue<dim>> result;
      for (const auto &some : Utilities::MPI::all_gather(comm, own))
        for (const NodeValue<dim> &value : some)
          result.insert({value.node, value});
      return result;
    }

    /// @return the value at `center` of the linear function along the surface that fits the values
    /// around it best, with weights of the inverse squared distance.
    template <int dim>
    double
    linear_continuation(const Point<dim> &center, const std::vector<NodeValue<dim>> &values)
    {
      Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(dim, dim);
      for (const NodeValue<dim> &value : values)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            spread(c, d) += (value.position - center)[c] * (value.position - center)[d];
      // The principal axes of the positions; the one with the least extent is normal to the surface
      // and not used, since heights over a curved surface are quadratic, as pressures are.
      const SymmetricEigenpairs axes = eigenpairs_of_symmetric(spread);
      const double              size = std::sqrt(axes.values(dim - 1));
      Eigen::MatrixXd           A    = Eigen::MatrixXd::Zero(dim, dim);
      Eigen::VectorXd           b    = Eigen::VectorXd::Zero(dim);
      for (const NodeValue<dim> &value : values)
        {
          Eigen::VectorXd linear = Eigen::VectorXd::Ones(dim);
          for (unsigned int t = 1; t < dim; ++t)
            {
              linear(t) = 0;
              for (unsigned int d = 0; d < dim; ++d)
                linear(t) += axes.vectors(d, dim - t) * (value.position - center)[d] / size;
            }
          const double weight = size * size / (value.position - center).norm_square();
          A += weight * linear * linear.transpose();
          b += weight * value.pressure * linear;
        }
      // The pseudo-inverse: where all nodes are on a line through the centre, the gradient across
      // it does not matter.
      const SymmetricEigenpairs modes  = eigenpairs_of_symmetric(A);
      double                    result = 0;
      for (unsigned int m = 0; m < dim; ++m)
        if (modes.values(m) > 1e-8 * modes.values(dim - 1))
          result += modes.vectors(0, m) * modes.vectors.col(m).dot(b) / modes.values(m);
      return result;
    }
  } // namespace



  // The node with the largest pressure (of equal ones the first), and the nodes of two rings of
  // faces around it.
  template <int dim>
  double
  sharpness_of_peak(const Snapshot<dim> &s, const unsigned int pair, const LA::Vector &pressure)
  {
    const MPI_Comm comm    = s.elasticity.mesh().communicator();
    double         largest = 0;
    for (const auto i : pressure.locally_owned_elements())
      largest = std::max(largest, pressure(i));
    largest = Utilities::MPI::max(largest, comm);
    if (largest == 0)
      return 0;
    Node peak = pressure.size();
    for (const auto i : pressure.locally_owned_elements())
      if (pressure(i) == largest)
        peak = std::min<Node>(peak, i);
    peak = Utilities::MPI::min(peak, comm);

    const LA::Vector nodal = s.elasticity.with_ghosts(pressure);
    const auto      &faces = s.surfaces[pair].slave_faces;
    std::set<Node>   near;
    for (const auto &[node, value] : nodes_around<dim>({peak}, faces, nodal, comm))
      near.insert(node);
    auto around = nodes_around(near, faces, nodal, comm);
    if (around.count(peak) == 0)
      return 0; // hanging, and no node of any face
    const Point<dim> center = around.at(peak).position;
    around.erase(peak);
    // Only nodes in contact, other than the peak itself, are continued linearly.
    std::vector<NodeValue<dim>> values;
    for (const auto &[node, value] : around)
      if (value.pressure > 0 && value.position.distance(center) > 0)
        values.push_back(value);
    if (values.size() < dim) // too few for a linear function
      return 0;
    return std::abs(1 - linear_continuation(center, values) / largest);
  }



  template double
  sharpness_of_peak(const Snapshot<2> &, unsigned int, const LA::Vector &);
  template double
  sharpness_of_peak(const Snapshot<3> &, unsigned int, const LA::Vector &);
} // namespace Signorini
