# SPDX-License-Identifier: Apache-2.0
"""The answer does not depend on what it must not depend on: ranks, units, slave and master, the springs of free bodies."""

import math
import re

from case import SCENES, VARIED, Case, Failed, method, short

# Of the forces, relative to the largest: solutions with Newton's tolerance of 1e-10, which conditioning multiplies.
TOLERANCE = 1e-8
METHODS = ("penalty", "Lagrange multiplier")
# Powers of two near 1e-3 and 1e6, so that rounding is the same too and counts must be equal, not just close.
LENGTH, STRESS = 2**-10, 2**20

# What is a length in a scene file: numbers, or formulas that may contain the coordinates, or else positions where only
# the sign of a formula counts. All other keys are angles, ratios, counts or words.
LENGTHS = {"Corners", "Inner radius", "Outer radius", "Radius", "Height", "Center", "Point", "Apex", "Search distance",
           "Edge radius", "Reference point"}
LENGTH_FORMULAS = {"Displacement", "Normal displacement", "Gap", "Initial gap"}
POSITION_FORMULAS = {"Inside", "Temperature"}
STRESSES = {"Young's modulus"}
STRESS_FORMULAS = {"Pressure", "Traction"}
FORCE_FORMULAS = {"Force"}
MOMENT_FORMULAS = {"Moment"}
REFUSED = {"File", "Transformation", "Body force", "Curved boundaries"}


def scaled_numbers(text, factor):
    return re.sub(r"[^,:\s]+", lambda word: repr(float(word[0]) * factor), text)


def scaled_formula(text, factor):
    """Of the coordinates, which have grown; each component times the factor."""
    if text in ("from geometry", "closed", "", "0"):
        return text
    text = re.sub(r"\b[xyz]\b", lambda name: f"({name[0]}/{LENGTH!r})", text)
    return "; ".join(part if part in ("free", "0") else f"({part})*{factor!r}" for part in re.split(r"\s*;\s*", text))


def scaled(key, value, dim):
    if key in REFUSED and value:
        raise Failed(f"'{key}' cannot be scaled")
    if key in LENGTHS:
        return scaled_numbers(value, LENGTH)
    if key in STRESSES:
        return scaled_numbers(value, STRESS)
    for keys, factor in ((LENGTH_FORMULAS, LENGTH), (POSITION_FORMULAS, 1), (STRESS_FORMULAS, STRESS),
                         (FORCE_FORMULAS, STRESS * LENGTH ** (dim - 1)), (MOMENT_FORMULAS, STRESS * LENGTH ** dim)):
        if key in keys:
            return scaled_formula(value, factor)
    return value


def scaled_scene(scene, name, dim):
    """Writes a copy of a resolved scene, without what is expected of it, in other units."""
    with open(scene) as file, open(name, "w") as copy:
        for line in file:
            if line.startswith("subsection Expected results"):
                break
            match = re.match(r"(\s*set (.+?) =)(.*)", line)
            copy.write(f"{match[1]} {scaled(match[2], match[3].strip(), dim)}\n" if match else line)


def answers(results):
    """Of each load step and pair: what must be equal, and the force."""
    return [(step["pairs"][pair]["active_points"], step["pairs"][pair]["force"])
            for step in results["load_steps"] for pair in step["pairs"]]


def compare(test, text, found, wanted, factor=1.0, same_points=True, tolerance=TOLERANCE):
    """The forces must be `factor` times those wanted, relative to the largest of them."""
    largest = max(math.hypot(*force) for _, force in wanted) * abs(factor)
    deviation = max(math.dist(force, [factor * f for f in want]) for (_, force), (_, want) in zip(found, wanted)) / largest
    points, expected = sum(n for n, _ in found), sum(n for n, _ in wanted)
    test.print(f"{text:40} {points:10.0f} active points, force deviates by {deviation:8.1e}")
    test.check(largest > 0 and deviation <= tolerance, f"{text}: the force deviates by {deviation:.1e}")
    if same_points:
        test.check(points == expected, f"{text}: {points} active points instead of {expected}")


def ranks(scene, sets):
    def body(test):
        first = answers(test.results(scene, sets))
        for distribution, n in (("p4est", 2), ("p4est", 4), ("METIS", 1), ("METIS", 2), ("METIS", 4)):
            found = answers(test.results(scene, sets + [f"Mesh/Distribution={distribution}"], n))
            compare(test, f"{distribution}, {n} ranks", found, first)
    return body


def counts_of(value):
    return value if isinstance(value, list) else [value]


def small_overlaps(*sets):
    """Overlaps of bodies that are held: nothing else acts, so nothing but the gap tells what is small."""
    def body(test):
        for edge, modulus in ((1, 1), (1e-12, 1e-3), (2**-10, 2**-10), (1e-9, 2e11), (1e6, 1e12)):
            results = test.results(VARIED / "small-overlap.prm", [*sets, f"Definitions/a={edge}", f"Definitions/E={modulus}"])
            pressure = results["load_steps"][-1]["pairs"]["joint"]["max_pressure"]
            test.check(abs(pressure / (modulus / 2000) - 1) < 1e-8, f"edge {edge}, E {modulus}: pressure {pressure}")
    return body


def units(scene, sets, counts_differ=0):
    """counts_differ: where rounding is not quite the same, a solve may need that many iterations more or less."""
    def body(test):
        first = test.results(scene, sets)
        name, dim = test.directory / f"scaled-{test.n_runs}.prm", first["dimension"]
        scaled_scene(f"{first['output_directory']}/scene.prm", name, dim)
        second = test.results(name, sets)
        compare(test, "scaled", answers(second), answers(first), STRESS * LENGTH ** (dim - 1))
        for key in ("newton_iterations", "krylov_iterations"):
            one, other = ([n for step in results["load_steps"] for n in counts_of(step[key])] for results in (first, second))
            test.check(len(one) == len(other) and all(abs(a - b) <= counts_differ for a, b in zip(one, other)),
                       f"{key}: {one}, scaled {other}")
    return body


def swap(scene, sets):
    def body(test):
        first = test.results(scene, sets)
        with open(f"{first['output_directory']}/scene.prm") as file:
            section = file.read().split("subsection Contact pairs")[1]
        name, slave, master = (re.search(pattern, section)[1] for pattern in
                               (r"set Names = (.*)", r"set Slave = (.*)", r"set Master = (.*)"))
        pair = f"Contact pairs/{name}"
        second = test.results(scene, sets + [f"{pair}/Slave={master}", f"{pair}/Master={slave}"])
        compare(test, "swapped", answers(second), answers(first), -1.0, same_points=False, tolerance=1e-9)
    return body


def springs(scene, sets):
    """The stabilisation of bodies that contact alone holds, over six decades."""
    def body(test):
        first = answers(test.results(scene, sets))
        for exponent in range(-4, 3):
            found = answers(test.results(scene, sets + [f"Newton/Stabilisation=1e{exponent}"]))
            compare(test, f"stabilisation 1e{exponent}", found, first)
    return body


def operators(scene, sets):
    """How products with the stiffness are made, and by which levels systems are solved."""
    def body(test):
        def found(operator, coarsening):
            return answers(test.results(scene, [*sets, f"Solver/Operator={operator}", f"Solver/Coarsening={coarsening}"]))
        first = found("assembled", "algebraic")
        for operator, coarsening in (("assembled", "degree"), ("matrix-free", "geometric"), ("matrix-free", "algebraic")):
            compare(test, f"{operator}, {coarsening}", found(operator, coarsening), first)
    return body


def shifted(scene, pairs, distances, sets):
    """Coordinates have 16 digits: far from the origin that many less are left of what bodies do."""
    def body(test):
        def forces(distance):
            pairs_now = test.results(VARIED / f"{scene}.prm", [*sets, f"Definitions/s={distance!r}"])["load_steps"][-1]["pairs"]
            return [pairs_now[pair]["normal_force"] for pair in pairs]
        here = forces(0.0)
        for distance in distances:
            for pair, force, wanted in zip(pairs, forces(distance), here):
                deviation, limit = abs(force / wanted - 1), 1e-8 + 1e-13 * abs(distance)
                test.print(f"{pair} at {distance:8.1e}: {force:.12g}, {deviation:8.1e} off")
                test.check(deviation <= limit, f"{pair} at {distance:g}: {force:.12g} instead of {wanted:.12g}")
    return body


def sectors(test):
    """A sector with cyclic ties against the whole ring, of the same mesh."""
    scene = VARIED / "sectors.prm"
    whole = ["Bodies/ring/Part=full", "Bodies/ring/Cells around=32"]
    alone = ["Bodies/Names=ring", "Supports/Names=bore, position"]
    for degree in (1, 2):
        sets = [f"Mesh/Degree={degree}", *alone, *method("Lagrange multiplier")]
        parts = [test.results(scene, [*sets, "Contact pairs/Names=ring sectors"])["load_steps"][-1]["probes"],
                 test.results(scene, [*sets, *whole, "Contact pairs/Names="])["load_steps"][-1]["probes"]]
        for probe in parts[0]:
            u, v = (part[probe]["displacement"] for part in parts)
            test.check(math.dist(u, v) <= 1e-9 * math.hypot(*v), f"{probe}: {u} instead of {v}")
    # Where contact meets the cut, pressures of its two nodes are two unknowns and not one: an error of the mesh.
    fit = ["Supports/Names=drive, outside"]
    for name in ("Lagrange multiplier", "penalty", "Nitsche"):
        sector = test.results(scene, [*fit, *method(name)])
        ring = test.results(scene, [*fit, *whole, "Bodies/shaft/Part=full", "Bodies/shaft/Cells around=24",
                                    "Contact pairs/Names=fit", *method(name)])
        for one, all_of_it in zip(sector["load_steps"], ring["load_steps"]):
            part, wanted = one["pairs"]["fit"], all_of_it["pairs"]["fit"]
            for key, factor, tolerance in (("normal_force", 4, 1e-3), ("max_pressure", 1, 0.1)):
                deviation = abs(factor * part[key] / wanted[key] - 1)
                test.print(f"{name:20} {key:13} {wanted[key]:9.4f} of the ring, {deviation:8.1e} off")
                test.check(deviation <= tolerance, f"{name}, {key}: {factor * part[key]} instead of {wanted[key]}")
            test.check(one["force_balance"] < 1e-8, f"{name}: forces of the sector are not in balance")


def cases():
    def table(check, scenes, ranks=1, label="quick", methods=METHODS, sets=()):
        for scene in scenes:
            for one in methods:
                name = f"{scene}{'-' + sets[0].split('/')[-1] if sets else ''}/{short(one)}"
                yield Case(f"invariance/{check.__name__}", name, check(SCENES / f"{scene}.prm", [*sets, *method(one)]),
                           ranks, {label})

    for degree, on_ranks, name, scenes in ((1, 1, "penalty", ["cone-force"]), (2, 1, "Lagrange multiplier", []),
                                           (2, 2, "Nitsche", [])):
        yield from table(operators, ("patch-3d", "patch-3d-distorted", "platen-3d", *scenes), on_ranks,
                         methods=(name,), sets=(f"Mesh/Degree={degree}",))
    yield from table(units, ("shrink-fit", "hertz-2d", "tube-clearance", "hertz-2d-force", "tilted-punch", "patch-3d"))
    yield Case("invariance/units", "hertz-3d/multiplier", labels={"full"},
               body=units(SCENES / "hertz-3d.prm", method(METHODS[1]), counts_differ=1))
    yield from table(springs, ("layer", "hertz-2d-force"))
    yield from table(swap, ("patch-2d", "patch-3d"))
    for name, scene, sets in (("blocks", "far-blocks", method("Lagrange multiplier")),
                              ("blocks, degree 2", "far-blocks", ["Mesh/Degree=2", "Mesh/Refinements=0", *method("Nitsche")]),
                              ("disc", "far-disc", ["Contact method/Contact geometry=reference", *method("penalty")])):
        yield Case("invariance/shifted", name, shifted(scene, ["c"] if scene == "far-blocks" else ["contact", "rest"],
                                                       (1e5, -1e6, 5e6), sets))
    for name, sets in (("large deformation", ["Deformation=finite", *method("Nitsche")]),
                       ("updated", ["Contact method/Contact geometry=updated", "Newton/Geometry tolerance=1e-5", *method("penalty")])):
        yield Case("invariance/shifted", f"disc on a bend, {name}",
                   shifted("far-disc", ["contact", "rest"], (1e5, -1e5), ["Obstacles/ground/Gap=y - s + 1 + (x - s)^2/4", *sets]))
    yield from table(ranks, ("patch-3d-distorted", "hertz-2d", "layer", "patch-inclined"), 4, "full", METHODS[:1])
    yield from table(ranks, ("shrink-fit", "hertz-axisymmetric", "tilted-punch", "patch-3d-distorted"), 4, "full", METHODS[1:])
    yield from table(ranks, ("patch-3d-distorted",), 4, "full", METHODS[1:], ["Bodies/upper/Degree=2"])
    for name in ("Lagrange multiplier", "augmented Lagrangian"):
        yield Case("invariance/units", f"small-overlap/{short(name)}", small_overlaps(*method(name)))
    yield Case("invariance/sectors", "rings", sectors)
    # A body whose cells are merged for p4est, and not for METIS.
    yield Case("invariance/ranks", "merged-cells", labels={"full"}, ranks=4,
               body=ranks(SCENES / "patch-3d.prm", ["Bodies/lower/Subdivisions=12,12,12", "Bodies/upper/Subdivisions=8,8,8",
                                                    "Contact pairs/interface/Initial gap=0.02*(x/10)^2",
                                                    "Contact method/Contact geometry=updated", *method(METHODS[1])]))
