#!/usr/bin/env python3
"""Write flange-sector.inp (Abaqus, C3D8): one of eight sectors of two pipe flanges with a bolt; see README.md.

    make-flange-sector.py FILE

z is the axis of the pipe, and the joint of the flanges is z = 0. The sector is symmetric to y = 0. The bolt has a head
at either end, and a section in its middle, along which *PRE-TENSION SECTION cuts it.
"""

import sys
from math import atan2, cos, hypot, pi, sin

from inp import elements_of, lines, surface

SECTORS = 8
BORE, PIPE, RIM = 40, 50, 110  # radii of the pipe and the flange
INNER, CIRCLE, OUTER = 62, 80, 98  # the bolts are on a circle, within a ring of the flange
HOLE, SHANK, HEAD = 9, 8, 13  # radii of the hole, the bolt and its heads
FLANGE, LENGTH, HEIGHT = 16, 60, 10  # thickness, end of the pipe, height of the heads
HALF = pi / SECTORS


def polar(r, angle):
    return (r * cos(angle), r * sin(angle))


def between(a, b, s):
    return tuple(x + s * (y - x) for x, y in zip(a, b))


def grid(rows):
    """The quadrilaterals between rows of points, each as its four corners."""
    return [(a[i], a[i + 1], b[i + 1], b[i]) for a, b in zip(rows, rows[1:]) for i in range(len(a) - 1)]


def around(n=4):
    """Points of the edge of the square [-1, 1]^2, n a side, in a circle; the first is also the last."""
    side = [-1 + 2 * i / n for i in range(n)]
    return ([(-1, -s) for s in side] + [(s, -1) for s in side] + [(1, s) for s in side] + [(-s, 1) for s in side] +
            [(-1, 1)])


def flange():
    """The section of a flange across its axis: sectors of rings, and one with a hole."""
    angles = lines(-HALF, (HALF, 4))
    ring = lambda radii: grid([[polar(r, a) for a in reversed(angles)] for r in radii])
    edge = [polar((INNER + OUTER) / 2 + x * (OUTER - INNER) / 2, y * HALF) for x, y in around()]
    direction = [atan2(y, x) for x, y in around()]
    circle = lambda r: [(CIRCLE + r * cos(a), r * sin(a)) for a in direction]
    outermost = circle(HEAD)
    hole = [circle(r) for r in lines(HOLE, (HEAD, 2))] + [
        [between(a, b, s) for a, b in zip(outermost, edge)] for s in (1 / 3, 2 / 3, 1)]
    return ring(lines(BORE, (PIPE, 2), (INNER, 2))) + ring(lines(OUTER, (RIM, 2))) + grid(hole), ring(
        lines(BORE, (PIPE, 2)))


def bolt():
    """The sections of the shank, and of the ring of the head around it."""
    square = [[(CIRCLE + SHANK / 2 * x, SHANK / 2 * y) for x in lines(-1, (1, 4))] for y in lines(-1, (1, 4))]
    edge = [(CIRCLE + SHANK / 2 * x, SHANK / 2 * y) for x, y in around()]
    direction = [atan2(y, x) for x, y in around()]
    circle = lambda r: [(CIRCLE + r * cos(a), r * sin(a)) for a in direction]
    rings = [[between(a, b, s) for a, b in zip(edge, circle(SHANK))] for s in (0, 0.5, 1)]
    return grid(square) + grid(rings), grid([circle(SHANK), circle((SHANK + HEAD) / 2), circle(HEAD)])


class Part:
    """Hexahedra over quadrilaterals, layer by layer."""

    def __init__(self, name, first):
        self.name, self.first, self.nodes, self.elements = name, first, {}, {}

    def node(self, x):
        return self.nodes.setdefault(tuple(round(c, 8) + 0. for c in x), self.first + len(self.nodes))

    def add(self, quadrilaterals, z):
        for low, high in zip(z, z[1:]):
            for quadrilateral in quadrilaterals:
                (ax, ay), (bx, by), (cx, cy), _ = quadrilateral
                if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0:
                    quadrilateral = quadrilateral[::-1]
                self.elements[self.first + len(self.elements)] = [
                    self.node((*corner, height)) for height in (low, high) for corner in quadrilateral]

    FACES = ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))

    def faces(self, on):
        """Element and label of all faces all of whose corners `on` says; faces between cells have two."""
        place = {number: x for x, number in self.nodes.items()}
        for element, nodes in self.elements.items():
            for label, face in enumerate(self.FACES):
                if all(on(*place[nodes[i]]) for i in face):
                    yield element, label + 1


def main():
    section, wall = flange()
    shank, head = bolt()
    upper, lower, bolted = Part("upper", 1), Part("lower", 10001), Part("bolt", 20001)
    upper.add(section, lines(0, (FLANGE, 3)))
    upper.add(wall, lines(FLANGE, (LENGTH, 6)))
    lower.add(section, lines(-FLANGE, (0, 3)))
    lower.add(wall, lines(-LENGTH, (-FLANGE, 6)))
    end = FLANGE + HEIGHT
    bolted.add(shank, lines(-end, (-FLANGE, 2), (0, 4), (FLANGE, 4), (end, 2)))
    bolted.add(head, lines(-end, (-FLANGE, 2)))
    bolted.add(head, lines(FLANGE, (end, 2)))

    near = lambda a, b: abs(a - b) < 1e-6
    on_cut = lambda sign: lambda x, y, z: near(atan2(y, x), sign * HALF)
    height = lambda h: lambda x, y, z: near(z, h)
    washer = lambda x, y: HOLE - 1e-6 < hypot(x - CIRCLE, y) < HEAD + 1e-6
    ring = lambda h: lambda x, y, z: near(z, h) and washer(x, y)
    under = lambda h: lambda x, y, z: near(z, h) and hypot(x - CIRCLE, y) > SHANK - 1e-6
    surfaces = []
    for part, sign in ((upper, 1), (lower, -1)):
        surfaces += [(part.name + "_left", part, on_cut(1)), (part.name + "_right", part, on_cut(-1)),
                     (part.name + "_joint", part, height(0)), (part.name + "_washer", part, ring(sign * FLANGE)),
                     (part.name + "_end", part, height(sign * LENGTH))]
    surfaces += [("head", bolted, under(FLANGE)), ("nut", bolted, under(-FLANGE))]
    text = "*HEADING\nA sector of two flanges with a bolt\n*NODE\n"
    for part in (upper, lower, bolted):
        text += "".join(f"{n}, " + ", ".join(f"{c:.10g}" for c in x) + "\n" for x, n in part.nodes.items())
    reference = 30001
    text += f"{reference}, {CIRCLE}, 0, 0\n"
    text += elements_of((upper, lower, bolted), "C3D8")
    text += "".join(surface(name, part.faces(on)) for name, part, on in surfaces)
    text += surface("section", [face for face in bolted.faces(height(0)) if face[1] == 2])
    text += f"*PRE-TENSION SECTION, SURFACE=section, NODE={reference}\n0, 0, 1\n"
    with open(sys.argv[1], "w") as file:
        file.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    main()
