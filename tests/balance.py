#!/usr/bin/env python3
"""Do all forces and all moments add up to nothing?

    balance.py SCENE [--most-moment M]

Contact forces on slave and master, reactions of supports, loads: their sum relative to the largest, in each load step; and
the sum of their moments, relative to that force times the size of the scene.
"""

import argparse
import sys

from run_scene import Runner, add_arguments


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser)
    parser.add_argument("--most-moment", type=float, default=1e-9)
    parser.add_argument("--ranks", type=int, default=1)
    arguments = parser.parse_args()
    for step in Runner(arguments).results(ranks=arguments.ranks)["load_steps"]:
        forces, moments = step["force_balance"], step["moment_balance"]
        print(f"t = {step['time']:<8g} forces {forces:8.1e}, moments {moments:8.1e}")
        if not (forces <= 1e-9 and moments <= arguments.most_moment):
            sys.exit("they do not balance")


if __name__ == "__main__":
    main()
