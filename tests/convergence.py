#!/usr/bin/env python3
"""Does an error fall at the rate that theory says?

    convergence.py SCENE --quantity PATH --reference X | --is-error --minimum-rate R [--levels N | --values V ...] [--key KEY]

Runs the scene for each value of the key, prints the errors, and fails unless their slope is steep enough. Levels are
refinements 0, 1, ...: the rate is that in the mesh width, which each level halves. Values are numbers: the rate is that
in 1/value.
"""

import argparse
import math
import sys

from run_scene import Runner, add_arguments, number


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser)
    parser.add_argument("--key", default="Mesh/Refinements", help="what is varied")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--levels", type=int, default=4)
    which.add_argument("--values", nargs="+", type=float)
    parser.add_argument("--quantity", required=True, help="path in the results file")
    reference = parser.add_mutually_exclusive_group(required=True)
    reference.add_argument("--reference", type=float)
    reference.add_argument("--reference-run", metavar="SECTION/KEY=VALUE", help="the reference is the quantity of this run")
    reference.add_argument("--is-error", action="store_true", help="the quantity is the relative error itself")
    parser.add_argument("--format", default="{:g}", help="how values are written, e.g. '{0:g},{0:g}'")
    parser.add_argument("--minimum-rate", type=float, required=True)
    parser.add_argument("--last-error", type=float, default=math.inf, help="relative, allowed at the end")
    return parser.parse_args()


def slope(x, y):
    """Of the straight line through the points that fits best."""
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def main():
    arguments = parse()
    runner = Runner(arguments)

    def quantity(override):
        return number(runner.results([override]), arguments.quantity)

    def error(value):
        return value if arguments.is_error else abs(value / reference - 1)

    reference = arguments.reference or 0
    if arguments.reference_run:
        reference = quantity(arguments.reference_run)
    # The logarithm of 1/h, and how the values are written.
    points = [(math.log(v), arguments.format.format(v)) for v in arguments.values or []]
    points = points or [(level * math.log(2), str(level)) for level in range(arguments.levels)]

    print(f"{arguments.quantity}, reference {reference:.9g}\n{arguments.key:>30} {'value':>16} {'error':>12} {'rate':>6}")
    logs = []
    for position, text in points:
        value = quantity(f"{arguments.key}={text}")
        # Where the error is nothing but rounding, its logarithm must exist all the same.
        logs.append(math.log(max(error(value), 1e-15)))
        rate = ""
        if len(logs) > 1:
            rate = f"{(logs[-2] - logs[-1]) / (position - previous):.2f}"
        previous = position
        print(f"{text:>30} {value:16.9g} {math.exp(logs[-1]):12.2e} {rate:>6}", flush=True)

    fitted = -slope([position for position, _ in points], logs)
    print(f"rate {fitted:.2f}, at least {arguments.minimum_rate:g} is wanted")
    if fitted < arguments.minimum_rate:
        sys.exit("the error does not fall as it should")
    if math.exp(logs[-1]) > arguments.last_error:
        sys.exit(f"the last error is larger than {arguments.last_error:g}")


if __name__ == "__main__":
    main()
