// SPDX-License-Identifier: Apache-2.0
// Load steps with friction, whose solution depends on the path.
#include "driver/simulation.h"
#include "fields/friction_fields.h"
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  // Load steps are chosen for the accuracy of the path.
  template <int dim>
  bool
  Simulation<dim>::controls_path() const
  {
    return scene.load_steps.is_automatic && scene.contact.chosen().has_friction;
  }



  template <int dim>
  PathControl::Solution
  Simulation<dim>::solution_of_path() const
  {
    // The share of the work of all normal forces over the largest displacement below which the work
    // of friction is rounding, or none that matters.
    constexpr double      none = 1e-6;
    PathControl::Solution result;
    if (problem.state.time > 0)
      {
        const Snapshot<dim> now = problem.equilibrium->snapshot(0);
        result.tractions        = tractions_of_path(now);
        for (unsigned int pair = 0; pair < now.pairs.size(); ++pair)
          result.change_of_friction =
            std::max(result.change_of_friction, change_of_friction(now, pair));
        LA::Vector forces = now.pressure;
        forces.scale(now.contact.weight);
        result.negligible_work = none * forces.l1_norm() * now.displacement.linfty_norm();
      }
    const std::vector<double> &work = problem.state.friction_work;
    result.work                     = std::accumulate(work.begin(), work.end(), 0.);
    return result;
  }



  // The largest ones at the ends of load steps that follow the changes of supports only. Without
  // convergence what has been found up to there counts.
  template <int dim>
  PathControl::Size
  Simulation<dim>::largest_of_path(const std::vector<double> &ends, const double tolerance)
  {
    out << "  the path: size of tangential tractions" << std::endl;
    const State       before = problem.state;
    PathControl::Size result = PathControl::distance(solution_of_path(), {});
    for (const double end : ends)
      if (end > problem.state.time)
        {
          if (!problem.solve(end, tolerance))
            break;
          const PathControl::Size there = PathControl::distance(solution_of_path(), {});
          result.tractions              = std::max(result.tractions, there.tractions);
          result.work                   = std::max(result.work, there.work);
        }
    problem.equilibrium->return_to(before);
    return result;
  }



  // The solution after one load step is compared with that after two of half the length, which is
  // kept. Without tangential tractions there is no path. Where the load step before was to be
  // halved, the first half has been solved already.
  template <int dim>
  bool
  Simulation<dim>::solve_step(const double t, const double tolerance, const bool may_be_halved)
  {
    my_path_error.reset();
    my_deviation = 0;
    if (!problem.equilibrium->is_path_dependent())
      return problem.solve(t, tolerance);
    if (!controls_path())
      return solve_in_parts(t, refinement.path_parts, tolerance);
    const State before = problem.state;
    // Loads that turn within the step, as from pulling to pushing, would not be followed.
    if (may_be_halved &&
        problem.equilibrium->turn_of_loads(before.time, t) > 0.25 * scene.load_steps.path_error)
      {
        my_path_error = std::numeric_limits<double>::infinity();
        return false;
      }
    const PathControl::Solution    at_start = solution_of_path();
    const std::optional<FirstHalf> known    = std::exchange(first_half, {});
    PathControl::Solution          coarse;
    if (known && known->from == before.time && std::abs(known->to - t) <= 1e-12 * t)
      coarse = known->solution;
    else
      {
        if (!solve_following_turn(t, tolerance))
          return false;
        coarse = solution_of_path();
        if (!has_tangential_forces(problem.equilibrium->snapshot(0)))
          return true;
        problem.equilibrium->return_to(before);
      }
    const double middle = (before.time + t) / 2;
    if (solve_following_turn(middle, tolerance))
      {
        first_half = FirstHalf{before.time, middle, solution_of_path()};
        if (solve_following_turn(t, tolerance))
          {
            const bool is_accurate = path_control.judge(at_start, coarse, solution_of_path());
            my_path_error          = path_control.error();
            if (is_accurate || !may_be_halved)
              {
                path_control.accept();
                return true;
              }
          }
      }
    problem.equilibrium->return_to(before);
    return false;
  }



  // An angle of 0.1 between the directions of slip at the start and at the end of a step changes
  // its length by less than 0.2 percent. How far prescribed obstacles turn is known before, all
  // else after the load step has been solved; that one is repeated in parts then.
  template <int dim>
  bool
  Simulation<dim>::solve_following_turn(const double t, const double tolerance)
  {
    constexpr double largest_turn = 0.1, close = 1.05;
    const State      before   = problem.state;
    const auto       parts_of = [](const double turn) {
      return static_cast<unsigned int>(std::max(1., std::ceil(turn / largest_turn - 1e-9)));
    };
    const auto solve_parts = [&](const unsigned int parts, const double turn) {
      if (parts > 1)
        out << "  surfaces turn against each other by " << short_text(turn, 3) << ": " << parts
            << " parts of the load step follow the direction of slip" << std::endl;
      for (unsigned int k = 1; k <= parts; ++k)
        if (!solve_from_touch(k == parts ? t : before.time + k * (t - before.time) / parts,
                              tolerance))
          return false;
      return true;
    };
    const double       deviation = my_deviation;
    double             turn      = problem.equilibrium->turn_of_obstacles(t);
    const unsigned int parts     = parts_of(turn);
    if (!solve_parts(parts, turn))
      return false;
    if (parts > 1)
      return true;
    turn = problem.equilibrium->relative_turn_since(before.displacement);
    if (turn <= close * largest_turn)
      return true;
    problem.equilibrium->return_to(before);
    my_deviation = deviation;
    return solve_parts(parts_of(turn), turn);
  }



  namespace
  {
    /// @return the smallest gap of each pair with friction [length], zero or less where it is in
    /// contact, and infinity where it has no points; zero for pairs without friction.
    /// Collective.
    /// @param gap at the points
    template <int dim>
    std::vector<double>
    smallest_gaps(const std::vector<ContactPair<dim>> &pairs,
                  const GapOperator                   &contact,
                  const LA::Vector                    &gap)
    {
      std::vector<double> result;
      for (const ContactPair<dim> &pair : pairs)
        result.push_back(pair.friction.is_zero() ? 0. : std::numeric_limits<double>::infinity());
      contact.for_each_point([&](const auto i, const unsigned int pair) {
        result[pair] = std::min(result[pair], double(gap(i)));
      });
      for (double &least : result)
        least = Utilities::MPI::min(least, gap.get_mpi_communicator());
      return result;
    }
  } // namespace



  // Slip counts from the place of the first touch, not from the start of the load step in which
  // surfaces meet: that one is divided where they do. Until then the motion mostly is linear in
  // time, so that two solutions without contact tell when that is.
  template <int dim>
  bool
  Simulation<dim>::solve_from_touch(const double t, const double tolerance)
  {
    // Gaps relative to the way of the load step up to which pairs are in contact at its ends, and
    // within it; the gap relative to the first one that is left; and the number of halvings.
    constexpr double       small = 1e-3, tiny = 1e-6, close = 1e-3;
    constexpr unsigned int most   = 12;
    const State            before = problem.state;
    if (!controls_path())
      my_deviation =
        std::max(my_deviation, problem.equilibrium->deviation_of_loads(before.time, t));
    const auto gaps = [this] {
      const GapOperator &contact = problem.contact->gap_operator();
      return smallest_gaps(problem.decisions.pairs,
                           contact,
                           contact.gap(problem.state.displacement));
    };
    const std::vector<double> at_start = gaps();
    if (!problem.solve(t, tolerance))
      return false;
    LA::Vector motion = problem.state.displacement;
    motion -= before.displacement;
    const double              way    = motion.linfty_norm();
    const std::vector<double> at_end = gaps();
    // The smallest gap of the pairs that come into contact in this load step.
    const auto gap_of_new_contact = [&](const std::vector<double> &gaps) {
      double result = std::numeric_limits<double>::infinity();
      for (unsigned int p = 0; p < gaps.size(); ++p)
        if (at_start[p] > small * way && at_end[p] <= small * way)
          result = std::min(result, gaps[p]);
      return result;
    };
    if (std::isinf(gap_of_new_contact(at_end)) ||
        !has_tangential_forces(problem.equilibrium->snapshot(0)))
      return true;

    // An infinite gap is one beyond the reach of the search.
    State  open  = before;
    double first = gap_of_new_contact(at_start);
    double gap = first, next = (before.time + t) / 2, closed = t;
    for (unsigned int n = 0; n < most && (std::isinf(gap) || gap > close * first); ++n)
      {
        problem.equilibrium->return_to(open);
        // Bodies that nothing but contact holds have no solution without it.
        if (!problem.solve(next, tolerance))
          break;
        const double gap_there = gap_of_new_contact(gaps());
        if (gap_there <= tiny * way)
          closed = next;
        else
          {
            // A little before the touch of a motion that is linear in time.
            const double speed = (gap - gap_there) / (next - open.time);
            open               = problem.state;
            gap                = gap_there;
            if (std::isinf(first))
              first = gap;
            next = open.time + (1 - close / 2) * gap / speed;
            if (std::isfinite(speed) && speed > 0 && next < closed)
              continue;
          }
        next = (open.time + closed) / 2;
      }
    problem.equilibrium->return_to(open);
    if (open.time > before.time)
      out << "  surfaces meet at t = " << short_text(open.time) << ", from where slip is counted"
          << std::endl;
    return problem.solve(t, tolerance);
  }



#define INSTANTIATE(dim)                                                                           \
  template bool              Simulation<dim>::controls_path() const;                               \
  template PathControl::Size Simulation<dim>::largest_of_path(const std::vector<double> &,         \
                                                              double);                             \
  template bool              Simulation<dim>::solve_following_turn(double, double);                \
  template bool              Simulation<dim>::solve_step(double, double, bool);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
