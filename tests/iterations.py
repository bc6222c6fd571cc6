#!/usr/bin/env python3
"""Does the linear solver need few iterations, and no more of them on fine meshes?

    iterations.py SCENE --levels N --most M --growth G

Runs the scene with 0, 1, ... refinements and prints the largest number of Krylov iterations of a Newton step. Fails if
one is above M, or the last more than G times that of the second mesh (the first may be hardly larger than its surface).
"""

import argparse
import sys

from run_scene import Runner, add_arguments


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser)
    parser.add_argument("--levels", type=int, default=4)
    parser.add_argument("--most", type=int, required=True)
    parser.add_argument("--growth", type=float, required=True)
    arguments = parser.parse_args()
    runner = Runner(arguments)
    counts = []
    for level in range(arguments.levels):
        results = runner.results([f"Mesh/Refinements={level}"])
        steps = [n for step in results["load_steps"] for n in step["krylov_iterations"]]
        counts.append(max(steps))
        print(f"{results['dofs']:10} dofs: {steps}", flush=True)
    if max(counts) > arguments.most:
        sys.exit(f"more than {arguments.most} iterations")
    if counts[-1] > arguments.growth * counts[1]:
        sys.exit(f"the number of iterations grows by more than {arguments.growth:g}")


if __name__ == "__main__":
    main()
