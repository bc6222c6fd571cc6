# SPDX-License-Identifier: Apache-2.0
"""Bodies whose tetrahedra are kept: scenes of other groups, whose boxes are replaced by files of tetrahedra."""

import itertools
from dataclasses import dataclass

from case import SCENES, Case
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
            place = self.at(*(node[k] / m / self.n[k] for k in range(3)))
            lines.append(f"{number}, " + ", ".join(map(repr, place)))
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
