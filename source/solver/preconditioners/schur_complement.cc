// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioners/schur_complement.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/row_view.h"
#include "solver/interface_solver.h"
#include "solver/linear_solver.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The diagonal of B_a diag(K)^-1 B_a^T for each component a: the flexibility of single points
    /// [length/force, per area]. Collective.
    PointVectors
    point_flexibility(const Stiffness &K, const GapOperator &contact)
    {
      const std::vector<double> diagonal = LA::ColumnExchange(contact.B_free).fetch(K.diagonal());
      PointVectors              flexibility = contact.zeros();
      for (unsigned int a = 0; a < flexibility.size(); ++a)
        {
          int local = 0;
          for (const auto i : flexibility[a].locally_owned_elements())
            {
              const LA::RowView row(contact.free_rows(a), local++);
              double            sum = 0;
              for (int k = 0; k < row.size; ++k)
                sum += row.values[k] * row.values[k] / diagonal[row.columns[k]];
              flexibility[a](i) = sum;
            }
          flexibility[a].compress(VectorOperation::insert);
        }
      return flexibility;
    }

    /// A diagonal approximation, which each derived class fills.
    class Diagonal : public SchurComplement
    {
    public:
      explicit Diagonal(const ContactSystem &system)
        : system(system)
      {}

      /// The blocks of the law change with the active set; the inverse is recomputed from them.
      void
      update() override
      {
        inverse = system.gap_operator().zeros();
        for (unsigned int a = 0; a < inverse.size(); ++a)
          {
            for (const auto i : inverse[a].locally_owned_elements())
              inverse[a](i) = 1 / diagonal(a, i);
            inverse[a].compress(VectorOperation::insert);
          }
      }

      void
      vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override
      {
        for (unsigned int a = 0; a < inverse.size(); ++a)
          {
            dst.block(1 + a) = src.block(1 + a);
            dst.block(1 + a).scale(inverse[a]);
          }
      }

    protected:
      /// The diagonal entry of the approximation of S at a point.
      virtual double
      diagonal(unsigned int component, types::global_dof_index point) const = 0;

      const ContactSystem &system;

    private:
      PointVectors inverse;
    };



    /// The approximation S = diag(C B diag(K)^-1 B^T A) + I.
    class StiffnessDiagonal : public Diagonal
    {
    public:
      explicit StiffnessDiagonal(const ContactSystem &system)
        : Diagonal(system)
        , flexibility(point_flexibility(system.stiffness(), system.gap_operator()))
      {}

    protected:
      double
      diagonal(const unsigned int a, const types::global_dof_index i) const override
      {
        return system.constraint()[a][a](i) * system.coupling()(i) * flexibility[a](i) +
               system.identity()[a][a](i);
      }

    private:
      const PointVectors flexibility;
    };



    /// The approximation C + I, the lumped mass of the multipliers times E/h, since the flexibility
    /// of a cell is of the order h/E.
    class Mass : public Diagonal
    {
    public:
      using Diagonal::Diagonal;

    protected:
      double
      diagonal(const unsigned int a, const types::global_dof_index i) const override
      {
        return system.constraint()[a][a](i) + system.identity()[a][a](i);
      }
    };



    /// The approximation C B K_zz^-1 B^T A + I with the stiffness K_zz of the active interface, by
    /// one factorisation for each active set.
    class InterfaceSchur : public SchurComplement
    {
    public:
      InterfaceSchur(const ContactSystem &system, const LA::DirectLibrary direct_solver)
        : system(system)
        , direct_solver(direct_solver)
      {}

      /// The interface is that of the present active set: one factorisation of a surface problem.
      /// Collective.
      void
      update() override
      {
        interface =
          std::make_unique<InterfaceSolver>(system, active_interface_dofs(system), direct_solver);
        interface->update();
        right    = system.zero();
        solution = right;
      }

      void
      vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override
      {
        // Elimination of the displacement from [K -B^T A; -C B -I] (u, q) = (0, r): -S q = r.
        for (unsigned int b = 1; b <= system.n_multiplier_blocks(); ++b)
          right.block(b) = src.block(b);
        solution = 0;
        interface->add_correction(solution, right);
        for (unsigned int b = 1; b <= system.n_multiplier_blocks(); ++b)
          dst.block(b).equ(-1, solution.block(b));
      }

    private:
      const ContactSystem             &system;
      const LA::DirectLibrary          direct_solver;
      std::unique_ptr<InterfaceSolver> interface;
      mutable LA::BlockVector          right, solution;
    };



    /// C B V B^T A + I with one multigrid cycle V for K^-1, solved to a tenth by at most 20 steps
    /// of CG, or of GMRES if the law is not symmetric. It contains the long-range flexibility of
    /// the bodies, which the other approximations do not; each step costs a multigrid cycle. Not a
    /// linear operation.
    class Multigrid : public SchurComplement
    {
    public:
      Multigrid(const ContactSystem &system, const AMG &amg)
        : system(system)
        , amg(amg)
        , diagonal(system)
      {}

      /// Only the inner preconditioner and workspaces depend on the active set.
      void
      update() override
      {
        diagonal.update();
        from = system.zero();
        to   = from;
      }

      /// CG or GMRES for S in the multiplier blocks; the other blocks of the vectors are zero.
      void
      vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override
      {
        LA::BlockVector right = src;
        right.block(0)        = 0;
        if (system.volumetric())
          right.block(system.volumetric_block()) = 0;
        LA::BlockVector solution = right;
        solution                 = 0;
        if (const double norm = right.l2_norm(); norm > 0)
          {
            IterationNumberControl control(20, 0.1 * norm);
            const Operator         schur{*this};
            const Jacobi           jacobi{*this};
            if (system.is_symmetric())
              SolverCG<LA::BlockVector>(control).solve(schur, solution, right, jacobi);
            else
              SolverGMRES<LA::BlockVector>(control).solve(schur, solution, right, jacobi);
          }
        for (unsigned int b = 1; b <= system.n_multiplier_blocks(); ++b)
          dst.block(b) = solution.block(b);
      }

      bool
      is_linear() const override
      {
        return false;
      }

    private:
      /// The Schur complement as an operator on vectors that are zero but for the multipliers.
      struct Operator
      {
        const Multigrid &schur;

        void
        vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
        {
          // The saddle point without K: (-B^T A q, -I q) of (0, q), then (., -C B u) of (u, 0).
          const ContactSystem &system = schur.system;
          system.contact_terms(dst, src);
          schur.from = 0;
          schur.amg.vmult(schur.from.block(0), dst.block(0));
          system.contact_terms(schur.to, schur.from);
          dst -= schur.to;
          dst.block(0) = 0;
          dst *= -1;
        }
      };

      /// Preconditioner of the inner iteration: the diagonal approximation.
      struct Jacobi
      {
        const Multigrid &schur;

        void
        vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
        {
          dst = src;
          schur.diagonal.vmult(dst, src);
        }
      };

      const ContactSystem    &system;
      const AMG              &amg;
      StiffnessDiagonal       diagonal;
      mutable LA::BlockVector from, to;
    };



    using Pointer = std::unique_ptr<SchurComplement>;
    using Maker =
      std::function<Pointer(const LinearSolverSettings &, const ContactSystem &, const AMG &)>;

    // The registry: one line an approximation.
    const std::vector<std::pair<std::string, Maker>> &
    registry()
    {
      static const std::vector<std::pair<std::string, Maker>> list = {
        {"diagonal",
         [](const auto &, const auto &system, const AMG &) -> Pointer {
           return std::make_unique<StiffnessDiagonal>(system);
         }},
        {"mass",
         [](const auto &, const auto &system, const AMG &) -> Pointer {
           return std::make_unique<Mass>(system);
         }},
        {"interface",
         [](const auto &settings, const auto &system, const AMG &) -> Pointer {
           return std::make_unique<InterfaceSchur>(system, settings.direct_solver.value());
         }},
        {"multigrid", [](const auto &, const auto &system, const AMG &amg) -> Pointer {
           return std::make_unique<Multigrid>(system, amg);
         }}};
      return list;
    }
  } // namespace



  // In the order of the registry.
  std::vector<std::string>
  SchurComplement::names()
  {
    std::vector<std::string> result;
    for (const auto &entry : registry())
      result.push_back(entry.first);
    return result;
  }



  std::unique_ptr<SchurComplement>
  SchurComplement::create(const LinearSolverSettings &settings,
                          const ContactSystem        &system,
                          const AMG                  &amg)
  {
    for (const auto &[known, make] : registry())
      if (known == settings.schur_complement)
        return make(settings, system, amg);
    AssertThrow(false, ExcMessage("unknown Schur complement " + settings.schur_complement));
    return nullptr;
  }
} // namespace Signorini
