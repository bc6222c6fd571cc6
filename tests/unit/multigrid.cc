// SPDX-License-Identifier: Apache-2.0
// The multigrid method and the interface multigrid as operators.

#include "contact/laws/normal_contact.h"
#include "linear_algebra/level_matrix.h"
#include "linear_algebra/sparsity_pattern.h"
#include "solid/rigid_body_modes.h"
#include "solver/preconditioners/interface_multigrid.h"

#include <doctest/doctest.h>

#include <cmath>

#include "two_blocks.h"

using namespace TestScene;

namespace
{
  LA::Vector
  every_other(const GapOperator &contact)
  {
    LA::Vector active = contact.zero();
    for (const auto i : active.locally_owned_elements())
      active(i) = i % 2;
    active.compress(VectorOperation::insert);
    return active;
  }

  /// Compare with deal.II's products of a matrix of `n` x `m` blocks on each rank, which couples
  /// neighbours on this and on other ranks. @param full whether blocks have all entries
  void
  check_products(const LA::LevelMatrix::Shape &block,
                 const unsigned int            n,
                 const unsigned int            m,
                 const bool                    full,
                 const LA::LevelMatrix::Shape &expected)
  {
    CAPTURE(block.rows);
    CAPTURE(block.columns);
    CAPTURE(full);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                       me      = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const auto range           = [&](const unsigned int size) {
      IndexSet set(size * n_ranks);
      set.add_range(size * me, size * (me + 1));
      return set;
    };
    const IndexSet      rows = range(n * block.rows), columns = range(m * block.columns);
    LA::SparsityPattern pattern(rows, columns, MPI_COMM_WORLD);
    const auto          for_entries = [&](const auto &visit) {
      for (const auto i : rows)
        for (const unsigned int step : {0u, 1u, 2u, m})
          {
            const unsigned int J = (i / block.rows * m / n + step) % (m * n_ranks);
            for (unsigned int c = 0; c < block.columns; ++c)
              if (full || (i + c + step) % 3 == 0)
                visit(i, J * block.columns + c);
          }
    };
    for_entries([&](const auto i, const auto j) { pattern.add(i, j); });
    pattern.compress();
    LA::SparseMatrix A;
    A.reinit(pattern);
    for_entries([&](const auto i, const auto j) { A.set(i, j, std::sin(1. + 3 * i + 7 * j)); });
    A.compress(VectorOperation::insert);

    const LA::LevelMatrix B(A);
    CHECK(B.shape().rows == expected.rows);
    CHECK(B.shape().columns == expected.columns);
    for (const bool transposed : {false, true})
      {
        LA::Vector x(transposed ? rows : columns, MPI_COMM_WORLD),
          y(transposed ? columns : rows, MPI_COMM_WORLD);
        for (const auto i : x.locally_owned_elements())
          x(i) = std::cos(0.3 * i);
        x.compress(VectorOperation::insert);
        const std::vector<float> in(x.begin(), x.end());
        std::vector<float>       out(y.locally_owned_size());
        if (transposed)
          {
            A.Tvmult(y, x);
            B.Tvmult(out.data(), in.data());
          }
        else
          {
            A.vmult(y, x);
            B.vmult(out.data(), in.data());
          }
        double wrong = 0;
        for (unsigned int i = 0; i < out.size(); ++i)
          wrong = std::max(wrong, std::abs(out[i] - y.begin()[i]));
        CHECK(Utilities::MPI::max(wrong, MPI_COMM_WORLD) < 1e-5);
      }
  }

  /// Degree 2 in space has so many unknowns that there are two levels.
  template <int dim>
  void
  check_v_cycle(const double spring)
  {
    CAPTURE(dim);
    CAPTURE(spring);
    const auto               method = make_method("Lagrange multiplier");
    const TwoBlocks<dim>     scene(*method, 2);
    const AssembledStiffness K(scene.elasticity.stiffness());
    const Hierarchy          hierarchy(K, {}, rigid_body_modes(scene.elasticity), dim);
    AMG                      amg(hierarchy, scene.contact.get());
    LA::Vector               D = every_other(*scene.contact);
    D *= spring;
    amg.set_contact_stiffness({D});

    const LA::Vector x = scene.field(1, 0.3), y = scene.field(1, 1.1);
    LA::Vector       Vx = x, Vy = y;
    amg.vmult(Vx, x);
    amg.vmult(Vy, y);
    CHECK(std::abs(x * Vy - y * Vx) < 1e-5 * std::sqrt((x * Vx) * (y * Vy))); // single precision
    CHECK(x * Vx > 0);
    CHECK(amg.multigrid_cycles() == 2);
  }

  /// Of a condensed system with springs on all points: F-V-F as a stationary iteration converges.
  template <int dim>
  void
  check_interface_multigrid(const double factor)
  {
    CAPTURE(dim);
    CAPTURE(factor);
    const TwoBlocks<dim>     scene(*make_method("penalty"), 1);
    const AssembledStiffness K(scene.elasticity.stiffness());
    const Hierarchy          hierarchy(K, {}, rigid_body_modes(scene.elasticity), dim);
    const NormalContact      law = NormalContact::springs(*scene.contact, factor);
    ContactSystem            system(K, law);
    LA::Vector               active = scene.contact->zero();
    active                          = 1.;
    system.set_status(active);
    InterfaceMultigrid filter(system,
                              hierarchy,
                              Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1 ?
                                LA::DirectLibrary::KLU :
                                LA::DirectLibrary::MUMPS,
                              true);
    filter.update();

    LA::BlockVector u = system.zero(), r = system.zero(), f = system.zero();
    f.block(0)         = scene.field(1, 0.7);
    const double first = f.l2_norm();
    LA::Vector   correction;
    correction.reinit(u.block(0));
    for (unsigned int n = 0; n < 30; ++n)
      {
        system.vmult(r, u);
        r.sadd(-1, 1, f);
        filter.solve(correction, r.block(0));
        u.block(0) += correction;
      }
    system.vmult(r, u);
    r.sadd(-1, 1, f);
    CHECK(r.l2_norm() < 1e-6 * first);
  }
} // namespace



TEST_CASE("products of levels are those of the matrix, in blocks of nodes")
{
  check_products({3, 3}, 20, 20, true, {3, 3});
  check_products({3, 6}, 20, 8, true, {3, 6});
  check_products({6, 6}, 9, 9, true, {6, 6});
  check_products({2, 3}, 11, 5, true, {2, 3});
  check_products({1, 1}, 7, 5, true, {1, 1});
  check_products({3, 3}, 20, 20, false, {1, 1});
}



TEST_CASE("a multigrid cycle with springs is symmetric and positive definite")
{
  for (const double spring : {0., 1., 1e9})
    {
      check_v_cycle<2>(spring);
      check_v_cycle<3>(spring);
    }
}



TEST_CASE("the contact filter alone converges, whatever the springs")
{
  for (const double factor : {1e-2, 1., 1e6})
    {
      check_interface_multigrid<2>(factor);
      check_interface_multigrid<3>(factor);
    }
}
