#!/usr/bin/env python3
"""Is the active set found in a few Newton steps?

    active_set.py SCENE --most M [--mirrored]

Runs the scene and prints the Newton steps of each load step; of methods that augment, those of each augmentation. Fails
if one of them takes more than M. --mirrored: the second half of the load steps goes back the way of the first, and
without friction the forces must be the same.
"""

import argparse
import math
import sys

from run_scene import Runner, add_arguments


def newton_steps(step):
    """From one solution to the next."""
    before = step["newton_iterations_before_augmentations"]
    return [*before, step["newton_iterations"] - sum(before)]


def check_mirrored(steps):
    """Load steps 1 ... n-1 of 2n stand for the same states as 2n-1 ... n+1."""
    forces = [[pair["force"] for pair in step["pairs"].values()] for step in steps]
    half = len(steps) // 2
    largest = max(math.hypot(*force) for force in forces[half - 1])
    for k in range(half - 1):
        for up, down in zip(forces[k], forces[2 * half - 2 - k]):
            if math.dist(up, down) > 1e-7 * largest:
                sys.exit(f"forces on the way there and back differ: {up}, {down}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser)
    parser.add_argument("--most", type=int, default=10)
    parser.add_argument("--mirrored", action="store_true")
    arguments = parser.parse_args()
    steps = Runner(arguments).results()["load_steps"]
    counts = [newton_steps(step) for step in steps]
    for step, count in zip(steps, counts):
        print(f"t = {step['time']:<8g} {step['active_points']:6} active points, Newton steps: "
              + " + ".join(map(str, count)))
    if arguments.mirrored:
        check_mirrored(steps)
    if max(map(max, counts)) > arguments.most:
        sys.exit(f"more than {arguments.most} Newton steps")


if __name__ == "__main__":
    main()
