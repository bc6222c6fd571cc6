# SPDX-License-Identifier: Apache-2.0
"""Bodies whose triangles are kept: scenes of other groups, whose boxes and rings are replaced by files of triangles."""

import itertools
import math
import re
from dataclasses import dataclass, replace

from case import SCENES, Case, force_of, method, number
from convergence import rate_of
from patch import EXACT, SWAPPED, uniform

METHODS = {"multiplier": method("Lagrange multiplier"), "augmented": method("augmented Lagrangian"),
           "nitsche": method("Nitsche"), "penalty": method("penalty", Factor=1e6)}


@dataclass
class Grid:
    """Triangles over a rectangle of nx x ny quadrilaterals with diagonals in turn, mapped by `at`. Sides are named left,
    right, bottom and top by what they are in the rectangle, or by `names`."""

    nx: int
    ny: int
    at: callable  # of a point in [0, 1]^2
    order: int = 2
    names: tuple = ("left", "right", "bottom", "top")
    is_mixed: bool = False  # quadrilaterals in place of pairs of triangles, in turn

    def text(self):
        m, numbers = self.order, {}
        kinds = {6: "CPE6", 8: "CPE8"} if m == 2 else {3: "CPE3", 4: "CPE4"}
        elements = {n_nodes: [] for n_nodes in kinds}
        for j in range(self.ny):
            for i in range(self.nx):
                a, b, c, d = ((m * (i + x), m * (j + y)) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
                triangles = ((a, b, c), (a, c, d)) if (i + j) % 2 == 0 else ((a, b, d), (b, c, d))
                for corners in [(a, b, c, d)] if self.is_mixed and (i + 2 * j) % 3 else triangles:
                    nodes = list(corners)
                    if m == 2:
                        nodes += [tuple((p[k] + q[k]) // 2 for k in (0, 1))
                                  for p, q in zip(corners, corners[1:] + corners[:1])]
                    elements[len(nodes)].append([numbers.setdefault(node, len(numbers) + 1) for node in nodes])
        lines = ["*NODE"]
        for (i, j), number in numbers.items():
            x, y = self.at(i / m / self.nx, j / m / self.ny)
            lines.append(f"{number}, {x!r}, {y!r}")
        element = itertools.count(1)
        for n_nodes, members in elements.items():
            lines += [f"*ELEMENT, TYPE={kinds[n_nodes]}, ELSET=ALL"] if members else []
            lines += [f"{next(element)}, " + ", ".join(map(str, nodes)) for nodes in members]
        for name, (axis, end) in zip(self.names, ((0, 0), (0, m * self.nx), (1, 0), (1, m * self.ny))):
            lines += [f"*NSET, NSET={name}"] + [f"{number}," for node, number in numbers.items() if node[axis] == end]
        return "\n".join(lines) + "\n"


def values_of(key, text):
    return [float(x) for x in re.split("[,:]", re.search(rf"set {key} *= (.*)", text)[1])]


def box(body, order, factor):
    """The grid of a body with corners and subdivisions."""
    x0, y0, x1, y1 = values_of("Corners", body)
    nx, ny = (round(factor * n) for n in values_of("Subdivisions", body))

    def at(s, t):
        return x0 + (x1 - x0) * s, y0 + (y1 - y0) * t
    return Grid(nx, ny, at, order)


def ring(body, order, factor):
    inner, outer = (values_of(f"{which} radius", body)[0] for which in ("Inner", "Outer"))
    around, through = (round(factor * values_of(f"Cells {way}", body)[0]) for way in ("around", "through"))

    def at(s, t):
        radius, angle = inner + (outer - inner) * s, math.pi / 2 * t
        return radius * math.cos(angle), radius * math.sin(angle)
    return Grid(through, around, at, order, ("inner", "outer", "symmetry_y", "symmetry_x"))


def grid_of(keys, order, factor):
    """The grid that replaces the cells of a body, from its keys; None: they stay."""
    if "Cells around" in keys:
        return ring(keys, order, factor)
    return box(keys, order, factor) if "set Corners" in keys else None


def with_triangles(test, scene, order, factor=1, bodies=None, extra="", grid_of=grid_of):
    """The scene with files of triangles, beside the runs. bodies: their names; none: all."""
    text, stem = scene.read_text(), f"{scene.stem}-{order}-{factor:g}-{'-'.join(bodies or ['all'])}"

    def replaced(match):
        body, keys = match[1], match[0]
        grid = None if bodies and body not in bodies else grid_of(keys, order, factor)
        if grid is None:
            return keys
        test.write(f"{stem}-{body}.inp", grid.text())
        kept = re.sub(r" *set (Mesh|Corners|Subdivisions|Inner radius|Outer radius|Height|Part|Cells \w+) .*\n", "", keys)
        return kept.replace(f"subsection {body}\n", f"subsection {body}\n    set Mesh = file\n"
                            f"    set File = {stem}-{body}.inp\n    set Cells = as in file\n", 1)
    text = re.sub(r"subsection (\w+)\n(?: *set .*\n)+", replaced, text)
    text = re.sub(r"(subsection Mesh\n *)set Refinements *= \d+", r"\1set Refinements = 0", text)
    return test.write(f"{stem}.prm", text + extra)


def patch(order, bodies, sets, ranks, penetrates=False):
    def body(test):
        scene = with_triangles(test, SCENES / "patch-2d.prm", order, bodies=bodies)
        uniform(scene.resolve().with_suffix(""), sets, EXACT["patch-2d"], penetrates=penetrates, exact=1e-4 if penetrates else 1e-6, ranks=ranks)(test)
    return body


def mixed(test):
    """Triangles and quadrilaterals of second order become triangles with the nodes of the file and the centres of the
    quadrilaterals: the patch test, and the number of unknowns."""
    def grid(keys, order, factor):
        return replace(box(keys, order, factor), is_mixed=True) if "set Corners" in keys else None
    for i, (name, sets) in enumerate(METHODS.items()):
        scene = with_triangles(test, SCENES / "patch-2d.prm", 2, grid_of=grid)
        uniform(scene.resolve().with_suffix(""), sets, EXACT["patch-2d"], penetrates=name == "penalty",
                exact=1e-4 if name == "penalty" else 1e-6, ranks=1 + i % 2)(test)
    meshes = "".join(file.read_text() for file in test.directory.glob("*.inp"))
    n_points = len(re.findall(r"^\d+(, [^,\n]+){2}$", meshes, re.M)) + len(re.findall(r"^\d+(?:, \d+){8}$", meshes, re.M))
    found = test.results(scene, [])["dofs"]
    test.check(found == 2 * n_points, f"{found} unknowns instead of {2 * n_points}")


def corner_sets(test):
    """A support at the corners of cells holds these nodes alone, not those of the file between them."""
    scene = with_triangles(test, SCENES / "patch-2d.prm", 2)
    file = next(test.directory.glob("*-lower.inp"))
    nodes = {number: (float(x), float(y)) for number, x, y in re.findall(r"^(\d+), (\S+), (\S+)$", file.read_text(), re.M)}
    elements = re.findall(r"^\d+(?:, \d+){6}$", file.read_text(), re.M)
    corners = {word.strip() for line in elements for word in line.split(",")[1:4]}
    bottom = [number for number in nodes if nodes[number][1] == min(y for _, y in nodes.values())]
    chosen = [number for number in bottom if number in corners]
    test.check(1 < len(chosen) < len(bottom), f"{len(chosen)} of {len(bottom)} nodes")
    with file.open("a") as out:
        out.write("*NSET, NSET=corners\n" + ",\n".join(chosen) + "\n*NSET, NSET=all of bottom\n" + ",\n".join(bottom) + "\n")
    support = re.search(r"set Boundaries *= lower.bottom\n", scene.read_text())[0]
    forces = []
    for held in ("lower.corners", ", ".join(f"lower.{number}" for number in chosen), "lower.all of bottom", None):
        changed = scene if held is None else test.write("held.prm", scene.read_text().replace(support, f"set Nodes = {held}\n"))
        forces.append(force_of(test.results(changed, ["Newton/Tolerance=1e-12", f"Title={len(forces)}"]), "interface"))
    test.print(f"forces {forces}")
    test.check(abs(forces[0] / forces[1] - 1) <= 1e-9 < 1e-3 < abs(forces[0] / forces[3] - 1), f"{forces}")
    test.check(abs(forces[2] / forces[3] - 1) <= 1e-9, f"{forces}")


# Two parts of one mesh, pulled apart.
PARTS = """set Dimension = 2
subsection Bodies
  set Names = low, up
""" + "".join(f"""  subsection {part}
    set Mesh            = file
    set File            = parts.inp
    set Part            = {part}
    set Cells           = as in file
    set Young's modulus = 1
    set Poisson's ratio = 0
  end
""" for part in ("low", "up")) + """end
subsection Supports
  set Names = bottom, top
  subsection bottom
    set Boundaries   = low.bottom
    set Displacement = 0; 0
  end
  subsection top
    set Boundaries   = up.top
    set Displacement = 0; 0.1
  end
end
"""
TIE = """subsection Contact pairs
  set Names = tie
  subsection tie
    set Slave  = up.unnamed
    set Master = low.unnamed
    set Law    = tied
  end
end
"""


def common_faces(test):
    """Parts that share faces in their file come apart without a pair, and a note says so."""
    test.write("parts.inp", Grid(2, 2, lambda x, y: (x, y), 1).text() + "*ELSET, ELSET=low\n1, 2, 3, 4\n"
               "*ELSET, ELSET=up\n5, 6, 7, 8\n")
    for name, more, count in (("apart", "", 1), ("tied", TIE, 0)):
        run = test.run(test.write(f"{name}.prm", PARTS + more))
        test.check(run.code == 0, f"{name}: exit code {run.code}: {run.err}")
        test.check((run.out + run.err).count("have common faces in their file") == count, f"{name}: {run.out}")


def converges(model, sizes, quantity, least, last_error=math.inf, reference=None, sets=()):
    """The last order of convergence of an error, over the scenes model(test, size)."""
    def body(test):
        errors = []
        for size in sizes:
            found = number(test.results(model(test, size), sets), quantity)
            errors.append(abs(found) if reference is None else abs(found / reference - 1))
            test.print(f"{size:5g} {found:16.9g} {errors[-1]:12.2e}")
        rate = rate_of(sizes, errors, key="factor")
        test.print(f"rate {rate:.2f}")
        test.check(rate >= least, f"the last rate is {rate:.2f}, at least {least:g} is wanted")
        test.check(errors[-1] <= last_error, f"the last error is {errors[-1]:.2e}, larger than {last_error:g}")
    return body


def finer(scene, order):
    """The scene with meshes of triangles of sizes 1/factor, for converges()."""
    return lambda test, factor: with_triangles(test, SCENES / f"{scene}.prm", order, factor)


def same_expected(model, ranks=1, sets=()):
    """The scene's own expected results hold, on the scene model(test)."""
    def body(test):
        for name, one in test.results(model(test), sets, ranks)["expected"].items():
            test.check(one["holds"], f"{name}: {one['value']:.9g} instead of {one['reference']:.9g}")
    return body


def patches(group, patch, sanitized=()):
    """Patch tests of both bodies or one of them made of simplices, from either side. patch: makes the body of a case from the
    order, the bodies, keys, ranks, and whether the method penetrates; sanitized: orders that run with sanitizers too."""
    for order in (1, 2):
        for bodies in (None, ["lower"], ["upper"]):
            for i, (name, sets) in enumerate(METHODS.items()):
                ranks = 2 if (i + order) % 2 else 1
                where = "-".join(bodies or ["all"])
                degree = [] if bodies is None else [f"Mesh/Degree={order}"]
                labels = {"quick", "sanitized"} if bodies is None and order in sanitized else {"quick"}
                yield Case(group, f"order-{order}/{where}/{name}",
                           patch(order, bodies, sets + degree, ranks, name == "penalty"), ranks, labels)
                if bodies:
                    yield Case(group, f"order-{order}/{where}/{name}-swapped",
                               patch(order, bodies, sets + degree + SWAPPED, ranks, name == "penalty"), ranks)


def cases():
    yield from patches("triangles/patch", patch, sanitized=(2,))
    yield from orders()
    yield from scenes_with_triangles()


def orders():
    """The orders of quadrilaterals, see polynomials() and closed_forms() of convergence.py."""
    for order, scene, quantity, least in ((1, "polynomial", "energy", 0.9), (1, "polynomial", "displacement", 1.8),
                                          (1, "polynomial", "pressure", 0.9), (2, "polynomial", "energy", 1.4),
                                          (2, "polynomial", "pressure", 1.4), (2, "polynomial-smooth", "energy", 1.9),
                                          (2, "polynomial-smooth", "displacement", 2.8)):
        for name in ("multiplier", "nitsche"):
            yield Case(f"triangles/{scene}-{order}", f"{quantity}/{name}", labels={"full"}, body=converges(
                finer(scene, order), (2.5, 4.5, 8.5, 16.5), f"errors/{quantity}", least,
                sets=[*METHODS[name], "Mesh/Refinements=0"]))
    for order, quantity, reference, least, last in ((1, "probes/rim/displacement/0", 0.0277534133, 1.8, 3e-4),
                                                    (2, "probes/rim/displacement/0", 0.0277534133, 1.8, 3e-4)):
        for name in ("multiplier", "nitsche"):
            yield Case("triangles/shrink-fit", f"order-{order}/{name}", labels={"full"}, body=converges(
                finer("shrink-fit", order), (1, 2, 4), quantity, least, last, reference, METHODS[name]))


def scenes_with_triangles():
    """Results that are exact on any mesh, and others to the tolerance of their scenes: friction, temperature, equations,
    ties, finite strain, axial symmetry."""
    scenes = ("coupling-bending", "finite-ramp", "finite-turned-stack", "friction-plate", "friction-travel", "late-tie",
              "led-cylinder", "patch-inclined", "pretension", "thermal-bimetal", "thermal-lift",
              "thermal-rings-axisymmetric", "tied-three")
    for i, scene in enumerate(scenes):
        for order in (1, 2):
            ranks = 1 + (i + order) % 2
            yield Case("triangles/scenes", f"{scene}/order-{order}", same_expected(
                lambda test, scene=scene, order=order: with_triangles(test, SCENES / f"{scene}.prm", order), ranks), ranks)
    yield Case("triangles/mixed", "patch", mixed, ranks=2)
    yield Case("triangles/sets", "corners", corner_sets)
    yield Case("triangles/sets", "common faces", common_faces)
    yield Case("triangles/refusals", "refusals", refusals)


# Two triangles of six nodes, whose common edge has two nodes in its middle.
DOUBLED = """*NODE
1, 0, 0
2, 10, 0
3, 10, 5
4, 0, 5
5, 5, 0
6, 10, 2.5
7, 5, 2.5
8, 5, 5
9, 0, 2.5
10, 5, 2.5
*ELEMENT, TYPE=CPE6, ELSET=ALL
1, 1, 2, 3, 5, 6, 7
2, 1, 3, 4, 10, 8, 9
*NSET, NSET=left
1, 4, 9
*NSET, NSET=bottom
1, 2, 5
*NSET, NSET=top
3, 4, 8
"""


def refusals(test):
    """What cannot be right ends with exit code 2 and a message that says why."""
    scene = with_triangles(test, SCENES / "patch-2d.prm", 2)
    test.write("doubled.inp", DOUBLED)
    test.write("flat.inp", DOUBLED.replace("10, 8, 9", "7, 8, 9").replace("4, 0, 5", "4, 5, 2.5"))
    for scene, sets, words in (
            (scene, ["Bodies/lower/File=doubled.inp"], "where a neighbour has another one"),
            (scene, ["Bodies/lower/File=flat.inp"], "folded or flat"),
            (scene, ["Bodies/lower/Transformation=x + 0.5*sin(0.7*pi*x); y"], "curved edges invert the cell"),
            (scene, ["Mesh/Refinements=1"], "no body beside such a one is refined"),
            (scene, ["Accuracy/Refinement cycles=1"], "triangles are not refined")):
        run = test.run(scene, sets)
        test.check(run.code == 2 and words in run.err, f"{sets}: exit code {run.code}, {run.err}")
