#!/usr/bin/env python3
"""Does the answer depend on what it must not depend on?

    invariance.py ranks SCENE     1, 2 and 4 ranks, cells distributed by p4est and by METIS: same active points and forces
    invariance.py units SCENE     lengths times --length, stresses times --stress: same steps, iterations, active points,
                                  and scaled forces
    invariance.py swap SCENE      slave and master of the pair exchanged: opposite force
    invariance.py springs SCENE   stabilisation of bodies that contact alone holds, over six decades: same active points
                                  and forces
"""

import argparse
import math
import os
import re
import sys

from run_scene import Runner, add_arguments

# What is a length in a scene file: numbers, or formulas that may contain the coordinates, or else positions where only
# the sign of a formula counts. All other keys are angles, ratios, counts or words.
LENGTHS = {"Corners", "Inner radius", "Outer radius", "Radius", "Height", "Center", "Point", "Apex", "Search distance",
           "Edge radius", "Reference point"}
LENGTH_FORMULAS = {"Displacement", "Normal displacement", "Gap", "Initial gap"}
POSITION_FORMULAS = {"Where"}
STRESSES = {"Young's modulus"}
STRESS_FORMULAS = {"Pressure", "Traction"}
FORCE_FORMULAS = {"Force"}
MOMENT_FORMULAS = {"Moment"}
REFUSED = {"File", "Transformation", "Body force", "Curved boundaries"}


def scaled_numbers(text, factor):
    return re.sub(r"[^,:\s]+", lambda word: repr(float(word[0]) * factor), text)


def scaled_formula(text, length, factor):
    """Of the coordinates, which have grown; each component times the factor."""
    if text in ("from geometry", "closed", "", "0"):
        return text
    text = re.sub(r"\b[xyz]\b", lambda name: f"({name[0]}/{length!r})", text)
    return "; ".join(part if part in ("free", "0") else f"({part})*{factor!r}" for part in re.split(r"\s*;\s*", text))


def scaled(key, value, length, stress, dim):
    if key in REFUSED and value:
        sys.exit(f"'{key}' cannot be scaled")
    if key in LENGTHS:
        return scaled_numbers(value, length)
    if key in STRESSES:
        return scaled_numbers(value, stress)
    if key in LENGTH_FORMULAS:
        return scaled_formula(value, length, length)
    if key in POSITION_FORMULAS:
        return scaled_formula(value, length, 1)
    if key in STRESS_FORMULAS:
        return scaled_formula(value, length, stress)
    if key in FORCE_FORMULAS:
        return scaled_formula(value, length, stress * length ** (dim - 1))
    if key in MOMENT_FORMULAS:
        return scaled_formula(value, length, stress * length ** dim)
    return value


def scaled_scene(scene, name, length, stress, dim):
    """Writes a copy of a resolved scene, without what is expected of it, in other units."""
    with open(scene) as file, open(name, "w") as copy:
        for line in file:
            if line.startswith("subsection Expected results"):
                break
            match = re.match(r"(\s*set (.+?) =)(.*)", line)
            copy.write(f"{match[1]} {scaled(match[2], match[3].strip(), length, stress, dim)}\n" if match else line)


def answers(results):
    """Of each load step and pair: what must be equal, and the force."""
    return [(step["pairs"][pair]["active_points"], step["pairs"][pair]["force"])
            for step in results["load_steps"] for pair in step["pairs"]]


class Comparison:
    def __init__(self, tolerance):
        self.tolerance = tolerance
        self.failed = False

    def row(self, text, found, wanted, factor=1.0, same_points=True):
        """Prints the largest deviation of the forces from `factor` times those wanted."""
        largest = max(math.hypot(*force) for _, force in wanted) * abs(factor)
        deviation = max(math.dist(force, [factor * f for f in want]) for (_, force), (_, want) in zip(found, wanted))
        deviation /= largest
        points, expected = sum(n for n, _ in found), sum(n for n, _ in wanted)
        good = deviation <= self.tolerance and (points == expected or not same_points)
        self.failed |= not good
        print(f"{text:40} {points:10.0f} active points, force deviates by {deviation:8.1e}  {'ok' if good else 'FAILED'}",
              flush=True)


def ranks(runner, compare, _):
    first = None
    for distribution in ("p4est", "METIS"):
        for n in (1, 2, 4):
            found = answers(runner.results([f"Mesh/Distribution={distribution}"], n))
            first = first or found
            compare.row(f"{distribution}, {n} ranks", found, first)


def units(runner, compare, arguments):
    first = runner.results()
    name = os.path.join(arguments.directory, "scaled.prm")
    dim = first["dimension"]
    scaled_scene(os.path.join(first["output_directory"], "scene.prm"), name, arguments.length, arguments.stress, dim)
    second = runner.results(scene=name)
    compare.row("scaled", answers(second), answers(first), arguments.stress * arguments.length ** (dim - 1))
    for key in ("newton_iterations", "krylov_iterations"):
        counts = [[step[key] for step in results["load_steps"]] for results in (first, second)]
        print(f"{key}: {counts[0]}, scaled {counts[1]}")
        compare.failed |= counts[0] != counts[1]


def swap(runner, compare, arguments):
    first = runner.results()
    path = os.path.join(first["output_directory"], "scene.prm")
    with open(path) as file:
        section = file.read().split("subsection Contact pairs")[1]
    name, slave, master = (re.search(pattern, section)[1] for pattern in
                           (r"set Names = (.*)", r"set Slave = (.*)", r"set Master = (.*)"))
    pair = f"Contact pairs/{name}"
    second = runner.results([f"{pair}/Slave={master}", f"{pair}/Master={slave}"])
    compare.row("swapped", answers(second), answers(first), -1.0, same_points=False)


def springs(runner, compare, _):
    first = answers(runner.results())
    for exponent in range(-4, 3):
        compare.row(f"stabilisation 1e{exponent}", answers(runner.results([f"Newton/Stabilisation=1e{exponent}"])), first)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    checks = {"ranks": ranks, "units": units, "swap": swap, "springs": springs}
    parser.add_argument("check", choices=checks)
    add_arguments(parser)
    parser.add_argument("--tolerance", type=float, default=1e-8, help="of the forces, relative to the largest")
    # Powers of two near 1e-3 and 1e6, so that rounding is the same too and counts must be equal, not just close.
    parser.add_argument("--length", type=float, default=2**-10)
    parser.add_argument("--stress", type=float, default=2**20)
    arguments = parser.parse_args()
    compare = Comparison(arguments.tolerance)
    checks[arguments.check](Runner(arguments), compare, arguments)
    if compare.failed:
        sys.exit("the answers differ")


if __name__ == "__main__":
    main()
