#!/usr/bin/env python3
"""Write bolted-joint.inp (Abaqus, axisymmetric): a bolt with head and nut, and two plates; see README.md.

    make-bolted-joint.py FILE

x is the radius, y the axis; the joint of the plates is y = 0. *PRE-TENSION SECTION cuts the bolt in its middle.
"""

import sys

from inp import elements_of, lines, surface

UPPER, LOWER = 8, 12  # thickness of the plates


class Part:
    """The cells of a grid of lines x and y that `keep` says, by their corners."""

    def __init__(self, name, x, y, first, keep=lambda x, y: True):
        self.name, self.nodes, self.elements = name, {}, {}
        node = {}
        for j in range(len(y) - 1):
            for i in range(len(x) - 1):
                if not keep((x[i] + x[i + 1]) / 2, (y[j] + y[j + 1]) / 2):
                    continue
                corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                for corner in corners:
                    node.setdefault(corner, first + len(node))
                    self.nodes[node[corner]] = (x[corner[0]], y[corner[1]])
                self.elements[first + len(self.elements)] = [node[corner] for corner in corners]

    def faces(self, on):
        """Element and number of the side of all sides whose middle `on` says; side 1 joins the first two corners."""
        for number, corners in self.elements.items():
            for side in range(4):
                a, b = (self.nodes[corners[(side + k) % 4]] for k in (0, 1))
                if on((a[0] + b[0]) / 2, (a[1] + b[1]) / 2):
                    yield number, side + 1


def main():
    head, nut = UPPER, -LOWER
    middle = (head + nut) / 2
    bolt = Part("bolt", lines(0, (5, 5), (5.5, 1), (8, 3)),
                lines(nut - 8, (nut, 6), (middle, 9), (head, 9), (head + 6.4, 5)), 1,
                lambda x, y: x < 5 or not nut < y < head)
    radii = lines(5.5, (8, 3), (14, 6), (30, 8))
    upper = Part("upper", radii, lines(0, (UPPER, 7)), 1001)
    lower = Part("lower", radii, lines(-LOWER, (0, 10)), 2001)

    surfaces = [("head", bolt, lambda x, y: x > 5 and y == head), ("nut", bolt, lambda x, y: x > 5 and y == nut),
                ("axis", bolt, lambda x, y: x == 0),
                ("upper_top", upper, lambda x, y: y == UPPER), ("upper_joint", upper, lambda x, y: y == 0),
                ("upper_rim", upper, lambda x, y: x == 30),
                ("lower_bottom", lower, lambda x, y: y == -LOWER), ("lower_joint", lower, lambda x, y: y == 0),
                ("lower_rim", lower, lambda x, y: x == 30)]
    text = "*HEADING\nTwo plates clamped by a bolt, axisymmetric\n*NODE\n"
    for part in (bolt, upper, lower):
        text += "".join(f"{n}, {x:.10g}, {y:.10g}\n" for n, (x, y) in part.nodes.items())
    text += elements_of((bolt, upper, lower), "CAX4")
    text += "".join(surface(name, part.faces(on)) for name, part, on in surfaces)
    text += surface("section", [face for face in bolt.faces(lambda x, y: y == middle) if face[1] == 3])
    text += f"*NODE\n3001, 0, {middle:g}\n*PRE-TENSION SECTION, SURFACE=section, NODE=3001\n0, 1\n"
    with open(sys.argv[1], "w") as file:
        file.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    main()
