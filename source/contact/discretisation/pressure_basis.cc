#include <signorini/contact/discretisation/pressure_basis.h>
#include <signorini/linear_algebra/dense.h>

#include <limits>

#include <Eigen/LU>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Nodes = std::vector<FaceNode>;

    Eigen::VectorXd
    dense(const SparseRow &shape, const Nodes &nodes)
    {
      Eigen::VectorXd values = Eigen::VectorXd::Zero(nodes.size());
      for (const auto &[index, value] : shape)
        for (unsigned int i = 0; i < nodes.size(); ++i)
          if (nodes[i].index == index)
            values[i] += value;
      return values;
    }

    /// D M^-1 with M = int phi phi^T dA, D = diag(int phi dA), whose rows are the dual functions;
    /// the identity where these would be too large.
    Eigen::MatrixXd
    dual_coefficients(const std::vector<SparseRow> &shapes,
                      const std::vector<double>    &weights,
                      const Nodes                  &nodes)
    {
      const auto      identity = Eigen::MatrixXd::Identity(nodes.size(), nodes.size());
      Eigen::MatrixXd M        = Eigen::MatrixXd::Zero(nodes.size(), nodes.size());
      Eigen::VectorXd D        = Eigen::VectorXd::Zero(nodes.size());
      for (unsigned int q = 0; q < shapes.size(); ++q)
        {
          const Eigen::VectorXd phi = dense(shapes[q], nodes);
          M += weights[q] * phi * phi.transpose();
          D += weights[q] * phi;
        }
      if (D.minCoeff() <= 0)
        return identity;
      // On whole faces the smallest eigenvalue is 1/9 for degree 1 and 0.16 for degree 2.
      constexpr double      smallest = 0.01;
      const Eigen::VectorXd scale    = D.cwiseSqrt().cwiseInverse();
      const Eigen::MatrixXd scaled   = scale.asDiagonal() * M * scale.asDiagonal();
      if (eigenvalues_of_symmetric(scaled).minCoeff() < smallest)
        return identity;
      return D.asDiagonal() * M.inverse();
    }

    double
    distance2(const FaceNode &a, const FaceNode &b)
    {
      const double x = a.xi[0] - b.xi[0], y = a.xi[1] - b.xi[1];
      return x * x + y * y;
    }

    /// The nearest of the nodes; several if they are equally near.
    std::vector<unsigned int>
    nearest(const Nodes &nodes, const std::vector<unsigned int> &candidates, const FaceNode &to)
    {
      double smallest = std::numeric_limits<double>::max();
      for (const unsigned int i : candidates)
        smallest = std::min(smallest, distance2(nodes[i], to));
      std::vector<unsigned int> result;
      for (const unsigned int i : candidates)
        if (distance2(nodes[i], to) < smallest + 1e-10)
          result.push_back(i);
      return result;
    }
  } // namespace



  PressureBasis::PressureBasis(const std::vector<FaceNode>  &nodes,
                               const std::vector<SparseRow> &shapes,
                               const std::vector<double>    &weights,
                               const Basis                   basis)
  {
    Eigen::MatrixXd coefficients = Eigen::MatrixXd::Identity(nodes.size(), nodes.size());
    if (basis == Basis::dual)
      coefficients = dual_coefficients(shapes, weights, nodes);

    std::vector<unsigned int> free;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (!nodes[i].prescribed)
        free.push_back(i);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (nodes[i].prescribed)
        {
          const std::vector<unsigned int> takers = nearest(nodes, free, nodes[i]);
          for (const unsigned int j : takers)
            coefficients.row(j) += coefficients.row(i) / takers.size();
        }
    for (const unsigned int i : free)
      {
        functions.emplace_back(nodes[i].index, SparseRow());
        for (unsigned int j = 0; j < nodes.size(); ++j)
          if (const double c = coefficients(i, j); c != 0)
            functions.back().second.emplace_back(nodes[j].index, c);
      }
  }



  SparseRow
  PressureBasis::at(const SparseRow &shape) const
  {
    SparseRow result;
    for (const auto &[node, function] : functions)
      {
        double value = 0;
        for (const auto &[other, coefficient] : function)
          for (const auto &[index, phi] : shape)
            if (index == other)
              value += coefficient * phi;
        if (value != 0)
          result.emplace_back(node, value);
      }
    return result;
  }
} // namespace Signorini
