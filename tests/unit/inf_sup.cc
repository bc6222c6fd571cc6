// SPDX-License-Identifier: Apache-2.0
// Are the pairs of displacement and pressure stable? The smallest beta with
//   sup_v b(v, q) / |v|_E >= beta (sum_faces h/E |q|^2)^(1/2)   for all q
// (the numerical inf-sup test, Chapelle and Bathe, Comput. Struct. 47 (1993) 537-545; El-Abbasi and
// Bathe, ibid. 79 (2001) 1473-1486), from the eigenvalues of (W B) K^-1 (W B)^T and the scaled mass
// matrix of the pressure: it must not fall when both bodies are refined.

#include "linear_algebra/direct_solver.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "two_blocks.h"
#include <Eigen/Dense>

using namespace TestScene;

namespace
{
  struct StabilityCase
  {
    unsigned int degree;
    Basis        basis;
    unsigned int slave_cells, master_cells; ///< a side, times the refinement
    bool         held; ///< the pressure ends where the displacement is prescribed
    double       slave_modulus = 1, master_modulus = 1;
  };

  template <int dim>
  std::string
  repeat(const std::string &x, const std::string &last)
  {
    return dim == 2 ? x + "," + last : x + "," + x + "," + last;
  }

  template <int dim>
  BodyMesh<dim>
  unit_box(const int bottom, const unsigned int cells)
  {
    return box<dim>(repeat<dim>("0", std::to_string(bottom)) + " : " +
                      repeat<dim>("1", std::to_string(bottom + 1)),
                    repeat<dim>(std::to_string(cells), std::to_string(cells)));
  }

  /// x^T K^-1 x for the columns x of forces. These act on the surface alone, so that products are
  /// of their few entries.
  Eigen::MatrixXd
  flexibility(const LA::SparseMatrix &K, const std::vector<LA::Vector> &forces)
  {
    LA::DirectSolver solver(LA::DirectLibrary::KLU);
    REQUIRE(solver.factorise(K) == 0);
    std::vector<std::vector<std::pair<unsigned int, double>>> entries;
    for (const LA::Vector &force : forces)
      {
        entries.emplace_back();
        for (unsigned int i = 0; i < force.locally_owned_size(); ++i)
          if (const double value = force.begin()[i]; value != 0)
            entries.back().emplace_back(i, value);
      }
    Eigen::MatrixXd result(forces.size(), forces.size());
    LA::Vector      x;
    for (unsigned int i = 0; i < forces.size(); ++i)
      {
        x.reinit(forces[i]);
        solver.solve(x, forces[i]);
        for (unsigned int j = 0; j <= i; ++j)
          {
            double product = 0;
            for (const auto &[k, value] : entries[j])
              product += value * x.begin()[k];
            result(i, j) = result(j, i) = product;
          }
      }
    return result;
  }

  /// int h/E psi_A psi_B dA
  template <int dim>
  Eigen::MatrixXd
  pressure_norm(const ContactSurface<dim> &surface, const GapOperator &contact, const double h)
  {
    std::map<types::global_dof_index, unsigned int> row;
    for (const auto node : contact.origin.node)
      row.emplace(node, row.size());
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(row.size(), row.size());
    for (const ContactPoint<dim> &point : surface.points)
      for (const auto &[A, psi_A] : point.multiplier_shape)
        for (const auto &[B, psi_B] : point.multiplier_shape)
          M(row.at(A), row.at(B)) += h * point.weight * psi_A * psi_B;
    return M;
  }

  template <int dim>
  double
  inf_sup(const StabilityCase &which, const unsigned int refinement)
  {
    const unsigned int cells  = which.slave_cells * refinement;
    const auto         method = make_method("Lagrange multiplier");
    const Mesh<dim>    mesh({{"lower", unit_box<dim>(0, which.master_cells * refinement)},
                             {"upper", unit_box<dim>(1, cells)}},
                         MeshSettings<dim>(),
                         {{"upper.bottom", "lower.top"}},
                         MPI_COMM_WORLD);
    Support<dim>       support;
    support.boundaries = {"lower.bottom", "upper.top"};
    if (which.held)
      support.boundaries.insert(support.boundaries.end(), {"lower.left", "upper.left"});
    support.displacement = VectorExpression<dim>(dim == 2 ? "0;0" : "0;0;0");
    Elasticity<dim> elasticity(mesh,
                               {{which.master_modulus, 0.3}, {which.slave_modulus, 0.3}},
                               {support},
                               {},
                               {which.degree});
    elasticity.setup();
    elasticity.assemble();
    ContactPair<dim> pair;
    pair.slave                                      = "upper.bottom";
    pair.master                                     = "lower.top";
    pair.initial_gap                                = "closed";
    const std::vector<ContactSurface<dim>> surfaces = {make_contact_surface<dim>(
      elasticity, pair, nullptr, *method, {Rule::segments, 2 * which.degree + 1, which.basis})};
    const auto contact = make_gap_operator<dim>(elasticity, surfaces, *method);

    std::vector<LA::Vector> forces;
    LA::Vector              p = contact->zero();
    for (const auto i : p.locally_owned_elements())
      {
        p    = 0.;
        p(i) = 1;
        p.compress(VectorOperation::insert);
        forces.push_back(contact->force({p}, {p}));
      }
    return std::sqrt(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
                       flexibility(elasticity.stiffness(), forces),
                       pressure_norm(surfaces[0], *contact, 1. / cells))
                       .eigenvalues()
                       .minCoeff());
  }

  template <int dim>
  void
  check(const StabilityCase &which, const std::vector<unsigned int> &refinements)
  {
    std::ostringstream  row;
    std::vector<double> beta;
    row << dim << "D, degree " << which.degree << ", "
        << (which.basis == Basis::dual ? "dual" : "standard") << ", " << which.slave_cells << " on "
        << which.master_cells << (which.held ? ", held" : "") << ":";
    for (const unsigned int refinement : refinements)
      {
        beta.push_back(inf_sup<dim>(which, refinement));
        row << " " << beta.back();
      }
    MESSAGE(row.str());
    CHECK(beta.back() > 0.1);
    CHECK(beta.back() > 0.95 * beta[beta.size() - 2]);
  }

  template <int dim>
  void
  check_all(const unsigned int degree, const std::vector<unsigned int> &refinements)
  {
    for (const Basis basis : {Basis::standard, Basis::dual})
      for (const unsigned int slave_cells : {2, 3})
        for (const bool held : {false, true})
          check<dim>({degree, basis, slave_cells, 5 - slave_cells, held}, refinements);
  }
} // namespace

TEST_CASE("inf-sup constants, 2D")
{
  for (const unsigned int degree : {1, 2})
    check_all<2>(degree, {1, 2, 4, 8, 16});
}

TEST_CASE("inf-sup constants, 3D")
{
  check_all<3>(1, {1, 2, 3, 4});
  check_all<3>(2, {1, 2});
}



// What the program makes of contrast: in the norm of the softer body, |q|^2 = int h/min(E) q^2, h
// of the slave's faces, the pairs whose risk it takes without a word must be stable.
TEST_CASE("inf-sup constants of bodies of different modulus, 2D")
{
  for (const unsigned int degree : {1, 2})
    for (const double modulus : {1e-6, 1e-3, 0.1, 1., 10., 1e3, 1e6})
      {
        std::ostringstream row;
        row << "degree " << degree << ", E slave/master " << modulus << ":";
        for (const auto &[slave, master] :
             {std::pair(4u, 16u), {8u, 16u}, {16u, 16u}, {16u, 8u}, {16u, 4u}})
          {
            const auto beta = [&, degree = degree](const double       of_slave,
                                                   const unsigned int n_slave,
                                                   const unsigned int n_master) {
              const double soft = std::min(1., of_slave);
              return inf_sup<2>(
                {degree, Basis::dual, n_slave, n_master, false, of_slave / soft, 1 / soft}, 1);
            };
            const Sides  named{modulus, double(master) / slave};
            const double as_named = beta(modulus, slave, master);
            row << "  " << as_named;
            if (named.should_be_exchanged())
              row << " -> " << beta(1 / modulus, master, slave);
            else if (named.pressure_error() <= 10)
              CHECK(as_named > 0.05);
          }
        MESSAGE(row.str());
      }
}
