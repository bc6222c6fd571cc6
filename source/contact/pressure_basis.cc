#include <signorini/contact/pressure_basis.h>

#include <algorithm>

#include <Eigen/Dense>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Nodes = std::vector<types::global_dof_index>;

    Nodes
    nodes_of(const std::vector<SparseRow> &shapes)
    {
      std::set<types::global_dof_index> nodes;
      for (const SparseRow &shape : shapes)
        for (const auto &entry : shape)
          nodes.insert(entry.first);
      return Nodes(nodes.begin(), nodes.end());
    }

    Eigen::VectorXd
    dense(const SparseRow &shape, const Nodes &nodes)
    {
      Eigen::VectorXd values = Eigen::VectorXd::Zero(nodes.size());
      for (const auto &[node, value] : shape)
        values[std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin()] += value;
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
      if (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .minCoeff() < smallest)
        return identity;
      return D.asDiagonal() * M.inverse();
    }
  } // namespace



  PressureBasis::PressureBasis(const std::vector<SparseRow>            &shapes,
                               const std::vector<double>               &weights,
                               const Basis                              basis,
                               const std::set<types::global_dof_index> &prescribed)
  {
    const Nodes     nodes        = nodes_of(shapes);
    Eigen::MatrixXd coefficients = basis == Basis::dual ?
                                     dual_coefficients(shapes, weights, nodes) :
                                     Eigen::MatrixXd::Identity(nodes.size(), nodes.size());
    const auto      is_free = [&](const unsigned int i) { return prescribed.count(nodes[i]) == 0; };
    unsigned int    n_free  = 0;
    Eigen::RowVectorXd given_away = Eigen::RowVectorXd::Zero(nodes.size());
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (is_free(i))
        ++n_free;
      else
        given_away += coefficients.row(i);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (is_free(i))
        {
          functions.emplace_back(nodes[i], SparseRow());
          for (unsigned int j = 0; j < nodes.size(); ++j)
            if (const double c = coefficients(i, j) + given_away[j] / n_free; c != 0)
              functions.back().second.emplace_back(nodes[j], c);
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
