// SPDX-License-Identifier: Apache-2.0
// Solvers on small systems against dense matrices.

#include "contact/laws/normal_contact.h"
#include "solid/rigid_body_modes.h"
#include "solver/linear_solver.h"
#include "solver/preconditioners/factorised.h"

#include <doctest/doctest.h>

#include <cmath>

#include "contact_cases.h"
#include <Eigen/Dense>

using namespace TestScene;

namespace
{
  LA::DirectLibrary
  direct_solver()
  {
    return Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1 ? LA::DirectLibrary::KLU :
                                                                  LA::DirectLibrary::MUMPS;
  }

  Eigen::VectorXd
  dense(const LA::BlockVector &x)
  {
    Values all = everywhere(x.block(0));
    if (x.block(1).size() > 0)
      {
        const Values q = everywhere(x.block(1));
        all.insert(all.end(), q.begin(), q.end());
      }
    return Eigen::Map<Eigen::VectorXd>(all.data(), all.size());
  }

  LA::BlockVector
  distributed_block(const ContactSystem &system, const Eigen::VectorXd &values)
  {
    LA::BlockVector x = system.zero();
    unsigned int    n = 0;
    for (unsigned int b = 0; b < 2; ++b)
      {
        for (const auto i : x.block(b).locally_owned_elements())
          x.block(b)(i) = values[n + i];
        n += x.block(b).size();
      }
    x.compress(VectorOperation::insert);
    return x;
  }

  /// Column by column.
  template <typename F>
  Eigen::MatrixXd
  dense_matrix(const ContactSystem &system, const F &apply)
  {
    const unsigned int n = dense(system.zero()).size();
    Eigen::MatrixXd    A(n, n);
    LA::BlockVector    result = system.zero();
    for (unsigned int j = 0; j < n; ++j)
      {
        apply(result, distributed_block(system, Eigen::VectorXd::Unit(n, j)));
        A.col(j) = dense(result);
      }
    return A;
  }

  LA::Vector
  every_other(const GapOperator &contact)
  {
    LA::Vector active = contact.zero();
    for (const auto i : active.locally_owned_elements())
      active(i) = i % 2 == 0;
    active.compress(VectorOperation::insert);
    return active;
  }

  Eigen::VectorXd
  rough(const unsigned int n)
  {
    Eigen::VectorXd v(n);
    for (unsigned int i = 0; i < n; ++i)
      v[i] = std::sin(1. + 1.3 * i * i);
    return v;
  }

  Lines
  small(const std::string &degree)
  {
    return boxes("0,0 : 1,1", "2,1", "0,1 : 1,2", "3,1") +
           fixed("lower.bottom, upper.top", "0; 0") + Lines{"Mesh/Degree=" + degree};
  }
} // namespace



TEST_CASE("systems of all methods are those of their definitions, the symmetric ones symmetric")
{
  SmallScene<2> scene(small("1"));
  for (const Lines &method : all_methods())
    {
      const std::string how = join(method);
      CAPTURE(how);
      scene.use(method);
      const NormalContact      law(scene.method(), scene.gap_operator());
      const AssembledStiffness stiffness(scene.elasticity->stiffness());
      ContactSystem            system(stiffness, law);
      system.set_status(every_other(scene.gap_operator()));
      const Eigen::MatrixXd A =
        dense_matrix(system, [&](auto &dst, const auto &src) { system.vmult(dst, src); });
      const double skew = (A - A.transpose()).norm() / A.norm();
      CHECK((skew < 1e-14) == system.is_symmetric());
      if (system.is_saddle_point() || !system.is_symmetric())
        continue;
      CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues().minCoeff() > 0);
    }
}



TEST_CASE("the zone solver is the inverse of its part of the system")
{
  for (const std::string degree : {"1", "2"})
    {
      CAPTURE(degree);
      SmallScene<2> scene(small(degree));
      for (const Lines &method : {Lines{"Method=Lagrange multiplier"},
                                  Lines{"Method=perturbed Lagrangian"},
                                  Lines{"Method=penalty"},
                                  Lines{"Method=Nitsche", "Nitsche/Theta=0"}})
        {
          CAPTURE(method[0]);
          scene.use(method);
          const NormalContact      law(scene.method(), scene.gap_operator());
          const AssembledStiffness stiffness(scene.elasticity->stiffness());
          ContactSystem            system(stiffness, law);
          system.set_status(every_other(scene.gap_operator()));
          const LA::Vector interface = active_interface_dofs(system);
          InterfaceSolver  solver(system, interface, direct_solver());
          solver.update();

          const Eigen::MatrixXd A =
            dense_matrix(system, [&](auto &dst, const auto &src) { system.vmult(dst, src); });
          // All multipliers, and what active points touch.
          const Values              marks = everywhere(interface);
          std::vector<unsigned int> in;
          for (unsigned int i = 0; i < A.rows(); ++i)
            if (i >= marks.size() || marks[i] != 0)
              in.push_back(i);
          CHECK(in.size() == solver.size());
          CHECK(in.size() < A.rows());
          Eigen::MatrixXd part(in.size(), in.size());
          for (unsigned int i = 0; i < in.size(); ++i)
            for (unsigned int j = 0; j < in.size(); ++j)
              part(i, j) = A(in[i], in[j]);
          const Eigen::VectorXd r = rough(A.rows()), start = rough(A.rows() + 7).tail(A.rows());
          const auto            corrected = [&](const Eigen::VectorXd &rest, Eigen::VectorXd x) {
            Eigen::VectorXd right(in.size());
            for (unsigned int i = 0; i < in.size(); ++i)
              right[i] = rest[in[i]];
            const Eigen::VectorXd solution = part.partialPivLu().solve(right);
            for (unsigned int i = 0; i < in.size(); ++i)
              x[in[i]] += solution[i];
            return x;
          };
          LA::BlockVector x = distributed_block(system, start);
          solver.add_correction(x, distributed_block(system, r));
          const Eigen::VectorXd added = corrected(r, start);
          CHECK((dense(x) - added).norm() < 1e-10 * added.norm());
          x = distributed_block(system, start);
          solver.correct(x, distributed_block(system, r));
          const Eigen::VectorXd correct = corrected(r - A * start, start);
          CHECK((dense(x) - correct).norm() < 1e-10 * correct.norm());
          // Afterwards no residual is left there.
          const Eigen::VectorXd rest = r - A * dense(x);
          for (const unsigned int i : in)
            CHECK(std::abs(rest[i]) < 1e-10 * r.norm());
        }
    }
}



TEST_CASE("the contact filter keeps all constraints")
{
  SmallScene<2> scene(small("2"));
  scene.use({"Method=Lagrange multiplier"});
  const AssembledStiffness stiffness(scene.elasticity->stiffness());
  const Hierarchy          hierarchy(stiffness, {}, rigid_body_modes(*scene.elasticity), 2);
  const NormalContact      law(scene.method(), scene.gap_operator());
  ContactSystem            system(stiffness, law);
  system.set_status(every_other(scene.gap_operator()));
  InterfaceMultigrid filter(system, hierarchy, direct_solver(), true);
  filter.update();
  const unsigned int    n = dense(system.zero()).size(), n_u = scene.elasticity->owned().size();
  const Eigen::VectorXd r = rough(n);
  LA::BlockVector       x = system.zero(), Ax = x;
  filter.start(x, distributed_block(system, r));
  system.vmult(Ax, x);
  CHECK((dense(Ax) - r).tail(n - n_u).norm() < 1e-11 * r.norm());
  // Then corrections of residuals that vanish there change no gap.
  const LA::BlockVector rest = distributed_block(system, r - dense(Ax));
  filter.vmult(x, rest);
  system.vmult(Ax, x);
  CHECK((dense(Ax) - dense(rest)).tail(n - n_u).norm() < 1e-11 * r.norm());
}



TEST_CASE("Schur complements are those of their definitions")
{
  SmallScene<2> scene(small("1"));
  for (const Lines &method :
       {Lines{"Method=Lagrange multiplier"}, Lines{"Method=perturbed Lagrangian"}})
    {
      CAPTURE(method[0]);
      scene.use(method);
      const AssembledStiffness stiffness(scene.elasticity->stiffness());
      const Hierarchy          hierarchy(stiffness, {}, rigid_body_modes(*scene.elasticity), 2);
      const NormalContact      law(scene.method(), scene.gap_operator());
      ContactSystem            system(stiffness, law);
      system.set_status(every_other(scene.gap_operator()));
      const AMG             amg(hierarchy, nullptr);
      const Eigen::MatrixXd A =
        dense_matrix(system, [&](auto &dst, const auto &src) { system.vmult(dst, src); });
      const unsigned int    n_u = scene.elasticity->owned().size(), n_q = A.rows() - n_u;
      const Eigen::MatrixXd K = A.topLeftCorner(n_u, n_u), AB = A.bottomLeftCorner(n_q, n_u),
                            I     = -A.bottomRightCorner(n_q, n_q);
      const Eigen::MatrixXd exact = AB * K.inverse() * AB.transpose() + I;
      // Here the zone is all that is free.
      const Values    interface    = everywhere(active_interface_dofs(system));
      Eigen::MatrixXd in_interface = Eigen::MatrixXd::Zero(n_u, n_u);
      for (unsigned int i = 0; i < n_u; ++i)
        for (unsigned int j = 0; j < n_u; ++j)
          in_interface(i, j) = interface[i] != 0 && interface[j] != 0 ? K(i, j) : i == j;
      const Eigen::MatrixXd diagonal =
        (AB * K.diagonal().asDiagonal().inverse() * AB.transpose()).diagonal().asDiagonal();
      const Values area    = everywhere(scene.gap_operator().weight),
                   k       = everywhere(scene.gap_operator().coefficients.stiffness),
                   active  = everywhere(every_other(scene.gap_operator()));
      Eigen::MatrixXd mass = I;
      for (unsigned int i = 0; i < n_q; ++i)
        mass(i, i) += active[i] * k[i] * area[i];
      const std::vector<std::pair<std::string, Eigen::MatrixXd>> definitions = {
        {"diagonal", diagonal + I},
        {"mass", mass},
        {"interface", AB * in_interface.inverse() * AB.transpose() + I}};
      LinearSolverSettings settings;
      settings.direct_solver      = direct_solver();
      const Eigen::VectorXd r     = rough(n_q);
      const auto            apply = [&](const std::string &name) {
        settings.schur_complement = name;
        const auto schur          = SchurComplement::create(settings, system, amg);
        schur->update();
        Eigen::VectorXd whole = Eigen::VectorXd::Zero(n_u + n_q);
        whole.tail(n_q)       = r;
        LA::BlockVector src = distributed_block(system, whole), dst = system.zero();
        schur->vmult(dst, src);
        return Eigen::VectorXd(dense(dst).tail(n_q));
      };
      for (const auto &[name, S] : definitions)
        {
          CAPTURE(name);
          const Eigen::VectorXd expected = S.partialPivLu().solve(r);
          CHECK((apply(name) - expected).norm() < 1e-10 * expected.norm());
        }
      // Multigrid stops inner iterations at a tenth of the residual, of an operator near the exact
      // one.
      const Eigen::VectorXd q = apply("multigrid");
      CHECK((exact * q - r).norm() < 0.3 * r.norm());
    }
}
