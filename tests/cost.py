#!/usr/bin/env python3
"""Does contact cost few multigrid cycles more than the linear problem without it?

    cost.py SCENE --newton N --cycles W [--ranks P]

Runs the scene with Output/Linear reference. Fails if the last load step took more than N Newton steps, or its mesh more
than W times the cycles of the linear solve. Neither depends on the clock.
"""

import argparse
import sys

from run_scene import Runner, add_arguments


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser)
    parser.add_argument("--newton", type=int, required=True)
    parser.add_argument("--cycles", type=float, required=True)
    parser.add_argument("--ranks", type=int, default=2)
    arguments = parser.parse_args()
    results = Runner(arguments).results(["Output/Linear reference=yes", "Newton/Tolerance=1e-8"], arguments.ranks)
    step, linear = results["load_steps"][-1], results["linear_reference"]
    print(f"{results['dofs']} dofs, {step['newton_iterations']} Newton steps {step['krylov_iterations']}, "
          f"{linear['contact_multigrid_cycles']} cycles, W = {linear['W']:.2f}, residual {step['residual']:.1e}")
    if step["residual"] > 1e-8:
        sys.exit("the residual is above 1e-8")
    if step["newton_iterations"] > arguments.newton:
        sys.exit(f"more than {arguments.newton} Newton steps")
    if linear["W"] > arguments.cycles:
        sys.exit(f"more than {arguments.cycles:g} times the cycles of the linear solve")


if __name__ == "__main__":
    main()
