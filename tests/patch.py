#!/usr/bin/env python3
"""Is the contact pressure uniform, and does the gap follow from it?

    patch.py SCENE --pressure X [--pair NAME] [--uniform 1e-9] [--penetrates] [--exact 1e-6]

Runs the scene and reads the profile of the contact pair. Fails unless the pressure is the same at all points up to
--uniform, relative, and equals --pressure up to --exact; and unless the gap is zero (measured by what it would be for
a penalty: relative to the largest displacement), or with --penetrates the same negative number everywhere.
"""

import argparse
import csv
import os
import sys

from run_scene import Runner, add_arguments


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser)
    parser.add_argument("--pair", default="interface")
    parser.add_argument("--pressure", type=float, required=True)
    parser.add_argument("--exact", type=float, default=1e-6)
    parser.add_argument("--uniform", type=float, default=1e-9)
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--penetrates", action="store_true")
    return parser.parse_args()


def main():
    arguments = parse()
    runner = Runner(arguments)
    runner.results(["Newton/Tolerance=1e-12"], arguments.ranks)
    with open(os.path.join(runner.last_folder, "profiles", arguments.pair + ".csv")) as file:
        rows = list(csv.DictReader(file))
    pressure = [float(row["pressure"]) for row in rows]
    gap = [float(row["gap"]) for row in rows]
    mean = sum(pressure) / len(pressure)
    spread = (max(pressure) - min(pressure)) / mean
    error = abs(mean / arguments.pressure - 1)
    print(f"{len(rows)} points, pressure {mean:.12g}, error {error:.1e}, spread {spread:.1e}")
    print(f"gap from {min(gap):.3e} to {max(gap):.3e}")
    if not rows or spread > arguments.uniform:
        sys.exit(f"the pressure varies by {spread:.1e}, more than {arguments.uniform:g}")
    if error > arguments.exact:
        sys.exit(f"the pressure is off by {error:.1e}, more than {arguments.exact:g}")
    if arguments.penetrates:
        if max(gap) > 0 or min(gap) / max(gap) - 1 > arguments.uniform:
            sys.exit("the penetration is not uniform")
    elif max(map(abs, gap)) > 1e-10:
        sys.exit("the gap is not closed")


if __name__ == "__main__":
    main()
