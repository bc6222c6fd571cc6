# SPDX-License-Identifier: Apache-2.0
"""Bodies whose tetrahedra are kept: scenes of other groups, whose boxes are replaced by files of tetrahedra."""

import itertools
import re
from dataclasses import dataclass, replace

from case import SCENES, Case
from patch import EXACT, uniform
from triangles import METHODS, converges, patches, same_expected, values_of, with_triangles

STANDARD = [*METHODS["multiplier"], "Contact method/Pressure basis=standard"]


@dataclass
class Grid:
    """Six tetrahedra in each of nx x ny x nz hexahedra, about the diagonal that all of them share; mapped by `at`. Sides
    are named left, right, front, back, bottom and top by what they are in the cube, or by `names`."""

    n: tuple
    at: callable  # of a point in [0, 1]^3
    order: int = 2
    names: tuple = ("left", "right", "front", "back", "bottom", "top")
    is_straight: bool = False  # nodes between corners are in the middle of straight edges
    is_turned: bool = False  # elements begin with any of three corners in turn
    is_mixed: bool = False  # hexahedra of 20 nodes, and pairs of wedges of 15 in their place in turn

    def place(self, node):
        def image(node):
            return self.at(*(node[k] / self.order / self.n[k] for k in range(3)))
        if not self.is_straight or self.order == 1:
            return image(node)
        ends = (image([c + sign * (c % 2) for c in node]) for sign in (-1, 1))
        return tuple((a + b) / 2 for a, b in zip(*ends))

    def other_cells(self):
        """Type and nodes of hexahedra and wedges: corners at the bottom and at the top, the middles of edges there, and between."""
        for cell in itertools.product(*map(range, reversed(self.n))):
            low = [2 * c for c in reversed(cell)]
            square = [(low[0] + 2 * i, low[1] + 2 * j) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
            is_cut = sum(cell[1:]) % 2  # in columns, so that triangles lie on triangles
            for around in ((square[:3], [square[0], *square[2:]]) if is_cut else (square,)):
                middles = [((a[0] + b[0]) // 2, (a[1] + b[1]) // 2) for a, b in zip(around, around[1:] + around[:1])]
                yield f"C3D{5 * len(around)}", [(*x, low[2] + z) for places, heights in ((around, (0, 2)), (middles, (0, 2)), (around, (1,)))
                                               for z in heights for x in places]

    def mixed_text(self):
        numbers, of_type = {}, {}
        for kind, nodes in self.other_cells():
            of_type.setdefault(kind, []).append([numbers.setdefault(node, len(numbers) + 1) for node in nodes])
        lines, number = [], 0
        for kind, elements in of_type.items():
            lines.append(f"*ELEMENT, TYPE={kind}, ELSET=ALL")
            for nodes in elements:
                number += 1
                row = list(map(str, (number, *nodes)))
                lines += [", ".join(row[:16]) + "," * (len(row) > 16)] + [", ".join(row[16:])] * (len(row) > 16)
        return numbers, lines

    def corners_of_cells(self):
        for cell in itertools.product(*map(range, reversed(self.n))):
            for way in itertools.permutations(range(3)):
                corners = [tuple(self.order * c for c in reversed(cell))]
                for axis in way:
                    corners.append(tuple(c + self.order * (d == axis) for d, c in enumerate(corners[-1])))
                if way not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
                    corners[1], corners[2] = corners[2], corners[1]
                yield corners

    def text(self):
        m, numbers, elements = self.order, {}, []
        for corners in () if self.is_mixed else self.corners_of_cells():
            if self.is_turned:
                k = len(elements) % 3
                corners[:3] = corners[k:3] + corners[:k]
            nodes = list(corners)
            if m == 2:
                nodes += [tuple((corners[a][k] + corners[b][k]) // 2 for k in range(3))
                          for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
            elements.append([numbers.setdefault(node, len(numbers) + 1) for node in nodes])
        cells = [f"*ELEMENT, TYPE={'C3D4' if m == 1 else 'C3D10'}, ELSET=ALL"]
        cells += [f"{e + 1}, " + ", ".join(map(str, nodes)) for e, nodes in enumerate(elements)]
        if self.is_mixed:
            numbers, cells = self.mixed_text()
        lines = ["*NODE"]
        for node, number in numbers.items():
            lines.append(f"{number}, " + ", ".join(map(repr, self.place(node))))
        lines += cells
        ends = ((axis, end) for axis in range(3) for end in (0, m * self.n[axis]))
        for name, (axis, end) in zip(self.names, ends):
            lines += [f"*NSET, NSET={name}"] + [f"{number}," for node, number in numbers.items() if node[axis] == end]
        return "\n".join(lines) + "\n"


def box(keys, order, factor):
    x = values_of("Corners", keys)
    n = tuple(max(1, round(factor * k)) for k in values_of("Subdivisions", keys))

    def at(*s):
        return tuple(x[d] + (x[d + 3] - x[d]) * s[d] for d in range(3))
    return Grid(n, at, order)


def grid_of(keys, order, factor):
    return box(keys, order, factor) if "set Corners" in keys else None


def with_tetrahedra(test, scene, order, factor=1, bodies=None, extra=""):
    return with_triangles(test, scene, order, factor, bodies, extra, grid_of)


def patch(order, bodies, sets, ranks, penetrates=False):
    def body(test):
        scene = with_tetrahedra(test, SCENES / "patch-3d.prm", order, bodies=bodies)
        # The penetration is so small that rounding of the coordinates is 1e-7 of it.
        uniform(scene.resolve().with_suffix(""), sets, EXACT["patch-3d"], penetrates=penetrates,
                exact=1e-4 if penetrates else 1e-6, spread=1e-8 if penetrates else 1e-9, ranks=ranks)(test)
    return body


def cases():
    yield from patches("tetrahedra/patch", patch)
    yield from orders()
    yield from scenes_with_tetrahedra()
    for name in ("multiplier", "nitsche", "penalty"):
        yield Case("tetrahedra/hertz", name, hertz(METHODS[name]), labels={"full"})
    yield Case("tetrahedra/hertz", "standard", hertz(STANDARD, (0.2, 0.03)), labels={"full"})
    yield Case("tetrahedra/numbering", "numbering", numbering)
    yield Case("tetrahedra/bars", "bars", bars, 2)
    for i, name in enumerate(("multiplier", "nitsche")):
        yield Case("tetrahedra/mixed", name, mixed(METHODS[name], 1 + i), 1 + i)
    yield Case("tetrahedra/cells", "automatic", automatic)
    yield Case("tetrahedra/operators", "operators", operators, 2)
    yield Case("tetrahedra/locking", "locking", locking)
    yield Case("tetrahedra/refusals", "refusals", refusals)


def scenes_with_tetrahedra():
    """Results that are exact on any mesh: ties, bonds, friction in corners whose faces have no free node, temperature, finite
    strain, resultants."""
    scenes = ("bond", "finite-punch", "finite-stack-3d", "free-turn", "friction-automatic", "friction-cycles", "friction-patch",
              "friction-touch", "friction-turned", "layer-patch", "patch-overhang-3d", "resultants", "thermal-finite",
              "thermal-patch-3d", "tied-patch")
    for i, scene in enumerate(scenes):
        for order in (1, 2):
            ranks = 1 + (i + order) % 2
            yield Case("tetrahedra/scenes", f"{scene}/order-{order}", same_expected(
                lambda test, scene=scene, order=order: with_tetrahedra(test, SCENES / f"{scene}.prm", order), ranks), ranks)


def graded(test, n, **options):
    """The block of hertz-3d, finer towards the point of first contact: n / 2.5 faces across the radius of contact."""
    def at(*s):
        x, y, z = (10 * (0.25 * one + 0.75 * one ** 4) for one in (s[0], s[1], 1 - s[2]))
        return x, y, -z
    test.write(f"block-{n}.inp", Grid((n, n, n), at, 2, is_straight=True, **options).text())
    text = (SCENES / "hertz-3d.prm").read_text()
    for old, new in ((r" *set (Corners|Subdivisions|Grading) .*\n", ""), (r"(?s)subsection Mesh\n.*?\nend\n\n(?=subsection Exp)", ""),
                     (r"set Mesh *= box", f"set Mesh = file\n    set File = block-{n}.inp")):
        text = re.sub(old, new, text)
    return test.write(f"hertz-{n}.prm", text)


def hertz(sets, most=(4e-2, 1e-2)):
    """The largest pressure converges to that of Hertz for the force found. most: the errors with four faces across the radius of
    contact, and with six."""
    def body(test):
        errors = []
        for n in (10, 16):
            one = test.results(graded(test, n), sets)["expected"]["largest pressure of Hertz"]
            errors.append(abs(one["value"] / one["reference"] - 1))
            test.print(f"{n:3} {errors[-1]:.2e}")
        test.check(errors[0] <= most[0] and errors[1] <= most[1], f"errors {errors}, larger than {most}")
    return body


def bars(test):
    """The error bar of the force covers what a finer mesh changes, and is at most three times as wide."""
    sets = METHODS["multiplier"] + ["Accuracy/Quantity=force of contact"]
    coarse, fine = (test.results(graded(test, n), sets, 2)["accuracy"]["quantities"]["force of contact"] for n in (7, 16))
    change, bar = abs(fine["value"] - coarse["value"]), coarse["bar"]
    test.print(f"{coarse['value']:.6g} +- {bar:.3g}, then {fine['value']:.6g}")
    test.check(change <= bar <= 3 * change, f"the force changes by {change:.3g}, the bar is {bar:.3g}")


def mixed(sets, ranks):
    """Wedges and hexahedra of second order become tetrahedra: the patch test."""
    def body(test):
        def grid(keys, order, factor):
            return replace(box(keys, order, factor), is_mixed=True) if "set Corners" in keys else None
        scene = with_triangles(test, SCENES / "patch-3d.prm", 2, grid_of=grid)
        uniform(scene.resolve().with_suffix(""), sets, EXACT["patch-3d"], exact=1e-6, spread=1e-9, ranks=ranks)(test)
    return body


def numbering(test):
    """Elements that begin with other corners change nothing."""
    first, second = (test.results(graded(test, 6, is_turned=turned), METHODS["multiplier"])["load_steps"][-1]["pairs"]["contact"]
                     for turned in (False, True))
    for name in ("max_pressure", "area"):
        test.check(abs(first[name] / second[name] - 1) <= 1e-7, f"{name}: {first[name]:.9g} and {second[name]:.9g}")


def automatic(test):
    """Tetrahedra of second order are kept, unless something needs hexahedra."""
    scene = graded(test, 2)
    for sets, cells in (([], 48), (["Mesh/Degree=1"], 192), (["Mesh/Refinements=1"], 8 * 192), (["Bodies/block/Cells=hexahedra"], 192),
                        (["Bodies/block/Mid-side nodes=no"], 192), (["Bodies/block/Poisson's ratio=0.49"], 48)):
        results = test.results(scene, sets)
        test.check(results["cells"] == cells, f"{sets}: {results['cells']} cells instead of {cells}")


def operators(test):
    """Products without a matrix: the same forces in as many cycles as with one, of both orders, both kinds of deformation, and beside
    hexahedra of degree 2."""
    for scene, order, sets in (("hertz-3d", 2, []), ("finite-punch", 1, []), ("finite-punch", 2, []),
                               ("patch-3d", 2, ["Bodies/upper/Cells=hexahedra", "Bodies/upper/Degree=2"])):
        path = graded(test, 3) if scene == "hertz-3d" else with_tetrahedra(test, SCENES / f"{scene}.prm", order, 0.5)
        first, second = (test.results(path, sets + [f"Solver/Operator={form}"], 2) for form in ("assembled", "matrix-free"))
        forces = [next(iter(one["load_steps"][-1]["pairs"].values()))["force"][2] for one in (first, second)]
        cycles = [sum(step["multigrid_cycles"] for step in one["load_steps"]) for one in (first, second)]
        test.print(f"{scene}, order {order}: forces {forces}, cycles {cycles}")
        test.check(second["preflight"]["operator"] == "matrix-free", "there was a matrix")
        test.check(abs(forces[1] / forces[0] - 1) <= 1e-7, f"forces {forces}")
        test.check(cycles[1] <= 1.2 * cycles[0] + 2, f"{cycles} cycles")


def locking(test):
    """Nearly incompressible tetrahedra of first order lock, and the verdict says so; those of second order much less."""
    shares = []
    for order in (1, 2):
        scene = with_tetrahedra(test, SCENES / "on-edges.prm", order)
        results = test.results(scene, METHODS["multiplier"] + [f"Bodies/{body}/Poisson's ratio=0.45" for body in ("lower", "upper")])
        shares += [one for one in results["verdict"]["checks"] if one["check"] == "volumetric locking"]
    test.print(f"{[one['value'] for one in shares]}")
    test.check(shares[0]["outcome"] == "warned" and shares[1]["value"] < shares[0]["value"] / 3, f"{shares}")


def refusals(test):
    """What cannot be right ends with exit code 2 and a message that says why."""
    scene = with_tetrahedra(test, SCENES / "patch-3d.prm", 2)
    for sets, words in ((["Mesh/Refinements=1"], "no body beside such a one is refined"),
                        (["Accuracy/Refinement cycles=1"], "tetrahedra are not refined"),
                        (["Bodies/lower/Transformation=x + 0.5*sin(0.7*pi*x); y; z"], "curved edges invert the cell")):
        run = test.run(scene, sets)
        test.check(run.code == 2 and words in run.err, f"{sets}: exit code {run.code}, {run.err}")


DEPTH = 0.5  # of extruded() models


def extruded(test, scene, order, n):
    """A plane model of a unit square on a plane, as a slab of tetrahedra between planes of symmetry."""
    text = (SCENES / f"{scene}.prm").read_text()
    grid = Grid((n, n, max(1, n // 2)), lambda x, y, z: (x, y, DEPTH * z), order,
                ("left", "right", "bottom", "top", "front", "back"))
    test.write(f"{scene}-{n}.inp", grid.text())
    for old, new in (("Dimension = 2", "Dimension = 3"), ("    set Point  = 0, 0\n", ""), ("= 0, 1\n", "= 0, 1, 0\n"),
                     (r" *set (Corners|Subdivisions) .*\n", ""),
                     ("  subsection square\n", f"  subsection square\n    set Mesh = file\n    set File = {scene}-{n}.inp\n"
                                               "    set Cells = as in file\n"),
                     ("set Names = rim\n", "set Names = rim, sides\n  subsection sides\n    set Type = symmetry\n"
                                           "    set Boundaries = square.front, square.back\n  end\n"),
                     (r"((?:Displacement|Body force) *= (?:.*\\\n)?.*)", r"\1; 0"),
                     (r" *set (Refinements|Degree) .*\n", ""), (r"(?s)subsection Expected results.*", "")):
        text = re.sub(old, new, text)
    return test.write(f"{scene}-{order}-{n}.prm", text)


def orders():
    """The orders of hexahedra, see polynomials() of convergence.py. On faces of degree 2 the pressure is of degree 1; its
    dual functions contain constant pressures alone, which costs up to half an order. At the ends of the contact surface,
    where nodes are prescribed, pressures are constant in one face, with an error of order 3/2 and of many times that of
    the rest."""
    methods = {"multiplier": METHODS["multiplier"], "standard": STANDARD, "nitsche": METHODS["nitsche"]}
    least = {"polynomial": {"energy": (0.9, 0.9, 0.9), "displacement": (1.8, 1.8, 1.8), "pressure": (0.9, 0.9, 0.9)},
             "polynomial-smooth": {"energy": (1.8, 1.9, 1.9), "displacement": (2.6, 2.8, 2.8), "pressure": (1, 1, 1.8)}}
    for order, scene in ((1, "polynomial"), (2, "polynomial-smooth")):
        for quantity, rates in least[scene].items():
            for (name, sets), rate in zip(methods.items(), rates):
                yield Case(f"tetrahedra/{scene}-{order}", f"{quantity}/{name}", labels={"full"}, body=converges(
                    lambda test, n, scene=scene, order=order: extruded(test, scene, order, n), (4, 8, 16),
                    f"errors/{quantity}", rate, sets=sets))
