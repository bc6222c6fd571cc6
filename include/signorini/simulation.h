#pragma once

#include <signorini/output/results.h>
#include <signorini/output/writer.h>
#include <signorini/scene/scene.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <memory>
#include <set>

namespace Signorini
{
  /// Exit codes of the program.
  enum ExitCode
  {
    solved         = 0,
    internal_error = 1,
    bad_scene      = 2, ///< or bad command line
    not_converged  = 3,
    missed         = 4 ///< solved, but an expected result of the scene is missed
  };

  /// One run: scene -> mesh -> solve -> estimate -> refine -> load history -> results.
  template <int dim>
  class Simulation
  {
  public:
    Simulation(const Scene<dim> &scene, MPI_Comm comm);

    /// Print what will be solved, and solve nothing.
    void
    preflight();

    ExitCode
    run();

  private:
    // In the order in which they happen.
    void
    set_up();
    void
    find_contact_pairs();
    /// How far surfaces may come closer.
    double
    guess() const;
    void
    set_reach();
    void
    report_set_up();
    void
    build_contact();
    bool
    solve(double t, double tolerance);
    void
    solve_with_candidates(double t, double tolerance);
    /// Returns true if surfaces have moved so far that others than the candidates may touch; then
    /// these are candidates now.
    bool
    widen_reach();
    /// Look farther for what may stop loose bodies. Returns false if that is far enough.
    bool
    reach_farther();
    void
    set_interference(double t);
    /// Throws SceneError for motions that nothing can stop.
    FreeMotions
    make_free_motions();
    /// As a field, to be carried over to other candidates or another mesh.
    LA::Vector
    nodal_pressure() const;
    void
    refine_mesh();
    void
    run_load_history();
    /// A step of the history. If it fails, the state before it is restored.
    bool
    attempt(double t);
    void
    record_step(unsigned int step, double t);
    void
    compare_with_linear_solve();
    ExitCode
    finish();

    Scene<dim>                 scene;
    const MPI_Comm             comm;
    dealii::ConditionalOStream out;
    dealii::TimerOutput        timer;
    dealii::Timer              clock, mesh_clock; ///< since the start, of the solves on this mesh

    std::unique_ptr<Mesh<dim>>       mesh;
    std::unique_ptr<Elasticity<dim>> elasticity;
    std::vector<ContactSurface<dim>> surfaces;
    std::unique_ptr<GapOperator>     contact;
    std::unique_ptr<Newton>          newton;
    std::vector<double>              reach; ///< of each pair: gaps of candidates
    bool                             assembled = false;
    std::set<std::string>            warned; ///< pairs that have moved too far

    LA::Vector displacement, pressure;

    std::unique_ptr<Writer<dim>> writer;
    NewtonReport                 report;
    Json                         results;
  };
} // namespace Signorini
