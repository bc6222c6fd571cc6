// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/pressure_basis.h"

#include "linear_algebra/dense.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include <Eigen/LU>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Nodes   = std::vector<FaceNode>;
    using Numbers = std::vector<unsigned int>;

    /// The values of a row at the nodes of the face, as a dense vector in their order; other
    /// indices are ignored.
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

    /// The integrals M_AB = int f_A f_B dA and D_A = int f_A dA of the functions f of a face over
    /// its paired part, by the quadrature of contact.
    struct Integrals
    {
      Eigen::MatrixXd M;
      Eigen::VectorXd D;

      /// The integrals of the functions L f.
      Integrals
      combined(const Eigen::MatrixXd &L) const
      {
        return {L * M * L.transpose(), L * D};
      }

      /// D^(-1/2) M D^(-1/2); none if a function has no positive integral.
      std::optional<Eigen::MatrixXd>
      scaled() const
      {
        if (D.minCoeff() <= 0)
          return {};
        const Eigen::VectorXd scale = D.cwiseSqrt().cwiseInverse();
        return Eigen::MatrixXd(scale.asDiagonal() * M * scale.asDiagonal());
      }

      /// True if the functions are linearly independent beyond rounding: the smallest eigenvalue of
      /// the scaled mass matrix is at least 0.01. On whole faces it is 1/9 for degree 1 and 0.16
      /// for degree 2.
      bool
      are_independent() const
      {
        constexpr double smallest = 0.01;
        const auto       matrix   = scaled();
        return matrix && eigenvalues_of_symmetric(*matrix).minCoeff() >= smallest;
      }
    };

    /// The integrals of the displacement functions, from their values at the points. @param weights
    /// areas of the points
    Integrals
    integrals_of(const std::vector<SparseRow> &shapes,
                 const std::vector<double>    &weights,
                 const Nodes                  &nodes)
    {
      Integrals result{Eigen::MatrixXd::Zero(nodes.size(), nodes.size()),
                       Eigen::VectorXd::Zero(nodes.size())};
      for (unsigned int q = 0; q < shapes.size(); ++q)
        {
          const Eigen::VectorXd phi = dense(shapes[q], nodes);
          result.M += weights[q] * phi * phi.transpose();
          result.D += weights[q] * phi;
        }
      return result;
    }

    /// Square of the distance in isotropic_coordinates() of the face.
    double
    distance2(const FaceNode &a, const FaceNode &b)
    {
      const double x = a.xi[0] - b.xi[0], y = a.xi[1] - b.xi[1];
      return x * x + y * y;
    }

    /// Those of the candidates that are nearest to a node; several if they are equally near up to
    /// rounding.
    Numbers
    nearest(const Nodes &nodes, const Numbers &candidates, const FaceNode &to)
    {
      double smallest = std::numeric_limits<double>::max();
      for (const unsigned int i : candidates)
        smallest = std::min(smallest, distance2(nodes[i], to));
      Numbers result;
      for (const unsigned int i : candidates)
        if (distance2(nodes[i], to) < smallest + 1e-10)
          result.push_back(i);
      return result;
    }

    /// The matrix L of doc/theory, (3.10): the functions of nodes without a multiplier are added to
    /// those of the nearest of the `takers`, in equal parts if several are equally near. Rows:
    /// takers; columns: nodes; columns add up to 1, so that the functions still add up to 1.
    Eigen::MatrixXd
    absorbed_nodes(const Nodes &nodes, const Numbers &takers)
    {
      Eigen::MatrixXd L = Eigen::MatrixXd::Zero(takers.size(), nodes.size());
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          const Numbers near = nearest(nodes, takers, nodes[i]);
          for (unsigned int k = 0; k < takers.size(); ++k)
            if (std::find(near.begin(), near.end(), takers[k]) != near.end())
              L(k, i) = 1. / near.size();
        }
      return L;
    }

    /// The position of the function that depends most on the others, the last pivot of a pivoted
    /// Cholesky factorisation of the scaled mass matrix. Pivots that are equal up to rounding are
    /// taken in their order, so that symmetric faces give the same result everywhere. O(n^3) with n
    /// at most 9.
    unsigned int
    most_dependent(const Integrals &functions)
    {
      const auto scaled = functions.scaled();
      if (!scaled)
        // A function without positive integral is removed first.
        {
          unsigned int least;
          functions.D.minCoeff(&least);
          return least;
        }
      Eigen::MatrixXd rest = *scaled;
      Numbers         left(rest.rows());
      std::iota(left.begin(), left.end(), 0);
      while (left.size() > 1)
        {
          const auto            pivot  = std::max_element(left.begin(),
                                              left.end(),
                                              [&](const unsigned int a, const unsigned int b) {
                                                return rest(a, a) < (1 - 1e-10) * rest(b, b);
                                              });
          const unsigned int    k      = *pivot;
          const Eigen::VectorXd column = rest.col(k);
          rest -= column * column.transpose() / std::max(rest(k, k), 1e-100);
          left.erase(pivot);
        }
      return left.front();
    }

    /// The nodes that carry the pressure of a face of which only a part has a projection
    /// (doc/theory, (3.9)): those of which at least a quarter of the area is covered, or half of
    /// the best share if that is less; then the most dependent function is removed until the others
    /// are independent on the covered part. The loop ends since each pass removes one node and one
    /// function is left.
    /// @param whole integrals of the functions over the whole face
    Numbers
    multiplier_carriers(const Nodes           &nodes,
                        const Eigen::VectorXd &whole,
                        const Integrals       &functions)
    {
      constexpr double      enough = 0.25;
      const Eigen::VectorXd shares = functions.D.cwiseQuotient(whole);
      const double          limit  = std::min(enough, shares.maxCoeff() / 2);
      Numbers               result;
      for (unsigned int i = 0; i < nodes.size(); ++i)
        if (shares[i] >= limit)
          result.push_back(i);
      while (result.size() > 1)
        {
          const Integrals taken = functions.combined(absorbed_nodes(nodes, result));
          if (taken.are_independent())
            break;
          result.erase(result.begin() + most_dependent(taken));
        }
      return result;
    }
  } // namespace



  PressureBasis::PressureBasis(const std::vector<FaceNode>  &nodes,
                               const std::vector<SparseRow> &shapes,
                               const std::vector<double>    &weights,
                               const double                  area,
                               const Basis                   basis)
  {
    // The functions of nodes without a share are added to those of the nodes around from the start.
    Numbers with_share;
    Nodes   carriers;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (nodes[i].share > 0)
        {
          with_share.push_back(i);
          carriers.push_back(nodes[i]);
        }
    const bool            is_lumped = carriers.size() < nodes.size();
    const Eigen::MatrixXd lumped =
      is_lumped ? absorbed_nodes(nodes, with_share) : Eigen::MatrixXd();
    const double covered = std::accumulate(weights.begin(), weights.end(), 0.);
    const bool   is_part = covered < 0.99 * area;
    Numbers      own(carriers.size());
    std::iota(own.begin(), own.end(), 0);
    Eigen::MatrixXd coefficients = Eigen::MatrixXd::Identity(own.size(), own.size());
    // Integrals are needed for the dual basis, and to select nodes on partly covered faces.
    if (is_part || basis == Basis::dual)
      {
        Integrals functions = integrals_of(shapes, weights, nodes);
        if (is_lumped)
          functions = functions.combined(lumped);
        Integrals taken = functions;
        // Nodes with too little covered area are absorbed by their neighbours.
        if (is_part)
          {
            Eigen::VectorXd whole(carriers.size());
            for (unsigned int i = 0; i < carriers.size(); ++i)
              whole[i] = carriers[i].share * area;
            own          = multiplier_carriers(carriers, whole, functions);
            coefficients = absorbed_nodes(carriers, own);
            taken        = functions.combined(coefficients);
          }
        // Dual functions: C = diag(L D) (L M L^T)^-1 L (3.8), (3.10). Where the mass matrix is
        // singular, the standard functions stay.
        if (basis == Basis::dual && taken.are_independent())
          coefficients = (taken.D.asDiagonal() * taken.M.inverse() * coefficients).eval();
      }

    // Nodes with a prescribed normal displacement carry no multiplier: their functions, standard or
    // dual, are added to those of the nearest free nodes.
    Numbers free;
    for (const unsigned int i : own)
      if (!carriers[i].prescribed)
        free.push_back(i);
    for (unsigned int k = 0; k < own.size(); ++k)
      {
        if (!carriers[own[k]].prescribed)
          continue;
        const Numbers takers = nearest(carriers, free, carriers[own[k]]);
        for (unsigned int j = 0; j < own.size(); ++j)
          if (std::find(takers.begin(), takers.end(), own[j]) != takers.end())
            coefficients.row(j) += coefficients.row(k) / takers.size();
      }
    if (is_lumped)
      coefficients = (coefficients * lumped).eval();
    for (unsigned int k = 0; k < own.size(); ++k)
      {
        if (carriers[own[k]].prescribed)
          continue;
        functions.emplace_back(carriers[own[k]].index, SparseRow());
        for (unsigned int j = 0; j < nodes.size(); ++j)
          if (const double c = coefficients(k, j); c != 0)
            functions.back().second.emplace_back(nodes[j].index, c);
      }
  }



  bool
  PressureBasis::has(const types::global_dof_index node) const
  {
    return std::any_of(functions.begin(), functions.end(), [&](const auto &function) {
      return function.first == node;
    });
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
