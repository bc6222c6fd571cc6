# SPDX-License-Identifier: Apache-2.0
"""Bodies whose tetrahedra are kept: scenes of other groups, whose boxes are replaced by files of tetrahedra."""

import itertools
import re
from dataclasses import dataclass

from case import SCENES, Case, number
from convergence import rate_of
from patch import EXACT, SWAPPED, uniform
from triangles import METHODS, values_of, with_triangles


@dataclass
class Grid:
    """Six tetrahedra in each of nx x ny x nz hexahedra, about the diagonal that all of them share; mapped by `at`. Sides
    are named left, right, front, back, bottom and top by what they are in the cube, or by `names`."""

    n: tuple
    at: callable  # of a point in [0, 1]^3
    order: int = 2
    names: tuple = ("left", "right", "front", "back", "bottom", "top")
    is_straight: bool = False  # nodes between corners are in the middle of straight edges

    def place(self, node):
        def image(node):
            return self.at(*(node[k] / self.order / self.n[k] for k in range(3)))
        if not self.is_straight or self.order == 1:
            return image(node)
        ends = (image([c + sign * (c % 2) for c in node]) for sign in (-1, 1))
        return tuple((a + b) / 2 for a, b in zip(*ends))

    def text(self):
        m, numbers, elements = self.order, {}, []
        for cell in itertools.product(*map(range, reversed(self.n))):
            for way in itertools.permutations(range(3)):
                corners = [tuple(m * c for c in reversed(cell))]
                for axis in way:
                    corners.append(tuple(c + m * (d == axis) for d, c in enumerate(corners[-1])))
                if way not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
                    corners[1], corners[2] = corners[2], corners[1]
                nodes = list(corners)
                if m == 2:
                    nodes += [tuple((corners[a][k] + corners[b][k]) // 2 for k in range(3))
                              for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
                elements.append([numbers.setdefault(node, len(numbers) + 1) for node in nodes])
        lines = ["*NODE"]
        for node, number in numbers.items():
            lines.append(f"{number}, " + ", ".join(map(repr, self.place(node))))
        lines.append(f"*ELEMENT, TYPE={'C3D4' if m == 1 else 'C3D10'}, ELSET=ALL")
        lines += [f"{e + 1}, " + ", ".join(map(str, nodes)) for e, nodes in enumerate(elements)]
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
    for order in (1, 2):
        for bodies in (None, ["lower"], ["upper"]):
            for i, (name, sets) in enumerate(METHODS.items()):
                ranks = 2 if (i + order) % 2 else 1
                where = "-".join(bodies or ["all"])
                degree = [] if bodies is None else [f"Mesh/Degree={order}"]
                yield Case("tetrahedra/patch", f"order-{order}/{where}/{name}",
                           patch(order, bodies, sets + degree, ranks, name == "penalty"), ranks)
                if bodies:
                    yield Case("tetrahedra/patch", f"order-{order}/{where}/{name}-swapped",
                               patch(order, bodies, sets + degree + SWAPPED, ranks, name == "penalty"), ranks)
    yield from orders()


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
    """The orders of hexahedra, see polynomials() of convergence.py."""
    for order, scene, quantity, least in ((1, "polynomial", "energy", 0.9), (1, "polynomial", "displacement", 1.8),
                                          (1, "polynomial", "pressure", 0.9), (2, "polynomial-smooth", "energy", 1.9),
                                          (2, "polynomial-smooth", "displacement", 2.8),
                                          (2, "polynomial-smooth", "pressure", 1.4)):
        for name in ("multiplier", "nitsche"):
            yield Case(f"tetrahedra/{scene}-{order}", f"{quantity}/{name}", labels={"full"}, body=converges(
                lambda test, n, scene=scene, order=order: extruded(test, scene, order, n), (4, 8, 16),
                f"errors/{quantity}", least, sets=METHODS[name]))


def converges(model, sizes, quantity, least, reference=None, sets=()):
    """The last order of convergence of an error, over meshes with 1/size."""
    def body(test):
        errors = []
        for n in sizes:
            found = number(test.results(model(test, n), sets), quantity)
            errors.append(abs(found) if reference is None else abs(found / reference - 1))
            test.print(f"{n:5g} {found:16.9g} {errors[-1]:12.2e}")
        rate = rate_of(sizes, errors, key="factor")
        test.print(f"rate {rate:.2f}")
        test.check(rate >= least, f"the last rate is {rate:.2f}, at least {least:g} is wanted")
    return body
