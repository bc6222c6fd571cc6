#include <signorini/linear_algebra/columns.h>
#include <signorini/linear_algebra/row_view.h>
#include <signorini/solve/linear_solver.h>
#include <signorini/solve/preconditioners/schur_complement.h>
#include <signorini/solve/zone_solver.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// diag(B diag(K)^-1 B^T)
    LA::Vector
    point_flexibility(const Stiffness &K, const GapOperator &contact)
    {
      const std::vector<double> diagonal = LA::ColumnExchange(contact.B_free).fetch(K.diagonal());
      LA::Vector                flexibility = contact.zero();
      int                       local       = 0;
      for (const auto i : flexibility.locally_owned_elements())
        {
          const LA::RowView row(contact.B_free, local++);
          double            sum = 0;
          for (int k = 0; k < row.size; ++k)
            sum += row.values[k] * row.values[k] / diagonal[row.columns[k]];
          flexibility(i) = sum;
        }
      flexibility.compress(VectorOperation::insert);
      return flexibility;
    }

    /// A diagonal approximation, which each derived class fills.
    class Diagonal : public SchurComplement
    {
    public:
      void
      vmult(LA::Vector &dst, const LA::Vector &src) const override
      {
        dst = src;
        dst.scale(inverse);
      }

    protected:
      LA::Vector inverse;
    };



    /// diag(A B diag(K)^-1 B^T A) + I
    class StiffnessDiagonal : public Diagonal
    {
    public:
      StiffnessDiagonal(const ContactSystem &system)
        : system(system)
        , flexibility(point_flexibility(system.stiffness(), system.gap_operator()))
      {}

      void
      update() override
      {
        inverse = system.gap_operator().zero();
        for (const auto i : inverse.locally_owned_elements())
          {
            const double A = system.coupling()(i);
            inverse(i)     = 1 / (A * A * flexibility(i) + system.identity()(i));
          }
        inverse.compress(VectorOperation::insert);
      }

    private:
      const ContactSystem &system;
      const LA::Vector     flexibility;
    };



    /// A + I: the multipliers' lumped mass times E/h, which is how the flexibility of a cell
    /// scales.
    class Mass : public Diagonal
    {
    public:
      Mass(const ContactSystem &system)
        : system(system)
      {}

      void
      update() override
      {
        inverse = system.gap_operator().zero();
        for (const auto i : inverse.locally_owned_elements())
          inverse(i) = 1 / (system.coupling()(i) + system.identity()(i));
        inverse.compress(VectorOperation::insert);
      }

    private:
      const ContactSystem &system;
    };



    /// A B K_zz^-1 B^T A + I with the stiffness K_zz of the contact zone.
    class Zone : public SchurComplement
    {
    public:
      Zone(const ContactSystem &system, const LA::DirectLibrary direct_solver)
        : system(system)
        , direct_solver(direct_solver)
      {}

      void
      update() override
      {
        zone = std::make_unique<ZoneSolver>(system, contact_zone(system), direct_solver);
        zone->update();
        right    = system.zero();
        solution = right;
      }

      void
      vmult(LA::Vector &dst, const LA::Vector &src) const override
      {
        // Elimination of the displacement from [K -B^T A; -A B -I] (u, q) = (0, r): -S q = r.
        right.block(1) = src;
        solution       = 0;
        zone->add_correction(solution, right);
        dst = solution.block(1);
        dst *= -1;
      }

    private:
      const ContactSystem        &system;
      const LA::DirectLibrary     direct_solver;
      std::unique_ptr<ZoneSolver> zone;
      mutable LA::BlockVector     right, solution;
    };



    /// A B V B^T A + I with one multigrid cycle for K^-1, solved by a few steps of CG. It sees that
    /// the flexibility of the bodies reaches far, which the others do not, at a multigrid cycle a
    /// step.
    class Multigrid : public SchurComplement
    {
    public:
      Multigrid(const ContactSystem &system, const AMG &amg)
        : system(system)
        , amg(amg)
        , diagonal(system)
      {}

      void
      update() override
      {
        diagonal.update();
        force = system.zero().block(0);
        u     = force;
      }

      void
      vmult(LA::Vector &dst, const LA::Vector &src) const override
      {
        dst               = 0;
        const double norm = src.l2_norm();
        if (norm == 0)
          return;
        IterationNumberControl control(20, 0.1 * norm);
        SolverCG<LA::Vector>(control).solve(Operator{*this}, dst, src, diagonal);
      }

      bool
      is_linear() const override
      {
        return false;
      }

    private:
      struct Operator
      {
        const Multigrid &schur;

        void
        vmult(LA::Vector &dst, const LA::Vector &src) const
        {
          const ContactSystem &system = schur.system;
          LA::Vector           scaled = src;
          scaled.scale(system.coupling());
          system.gap_operator().B_free.Tvmult(schur.force, scaled);
          schur.amg.vmult(schur.u, schur.force);
          system.gap_operator().B_free.vmult(dst, schur.u);
          dst.scale(system.coupling());
          scaled = src;
          scaled.scale(system.identity());
          dst += scaled;
        }
      };

      const ContactSystem &system;
      const AMG           &amg;
      StiffnessDiagonal    diagonal;
      mutable LA::Vector   force, u;
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
        {"zone",
         [](const auto &settings, const auto &system, const AMG &) -> Pointer {
           return std::make_unique<Zone>(system, settings.direct_solver.value());
         }},
        {"multigrid", [](const auto &, const auto &system, const AMG &amg) -> Pointer {
           return std::make_unique<Multigrid>(system, amg);
         }}};
      return list;
    }
  } // namespace



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
