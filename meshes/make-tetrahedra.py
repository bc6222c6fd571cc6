#!/usr/bin/env python3
"""Write meshes of tetrahedra, wedges, pyramids and triangles.

    make-tetrahedra.py FOLDER

tetrahedra.inp (Abaqus, CalculiX) and triangles.msh (Gmsh): see README.md.
"""

import itertools
import os
import random
import sys

# Corners of the cell (ix, iy, iz) as bits x + 2 y + 4 z. Neighbours fit: all diagonals go from the lower to the upper corner.
TETRAHEDRA = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)]
TRIANGLES = [(0, 1, 3), (0, 3, 2)]
EDGES = {3: [(0, 1), (1, 2), (2, 0)], 4: [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]}
FACES = {3: [(0, 1), (1, 2), (2, 0)], 4: [(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)]}  # S1, S2, ...


class Block:
    """A box of simplices with nodes numbered from `first`, those inside shifted at random; of second order if wanted."""

    def __init__(self, low, high, cells, first, first_element, order, seed):
        self.dim, self.low, self.high = len(low), low, high
        shift = random.Random(seed)
        self.points, numbers = {}, {}
        for index in itertools.product(*(range(n + 1) for n in cells)):
            inside = all(0 < i < n for i, n in zip(index, cells))
            wobble = [shift.uniform(-0.15, 0.15) if inside else 0 for _ in index]
            numbers[index] = first + len(numbers)
            self.points[numbers[index]] = [
                a + (b - a) * (i + w) / n for a, b, i, w, n in zip(low, high, index, wobble, cells)]
        self.elements = {}
        for index in itertools.product(*(range(n) for n in cells)):
            for simplex in TETRAHEDRA if self.dim == 3 else TRIANGLES:
                corners = [numbers[tuple(i + (c >> d & 1) for d, i in enumerate(index))] for c in simplex]
                self.elements[first_element + len(self.elements)] = corners
        if order == 2:
            self.add_middles(first + len(numbers))

    def add_middles(self, number):
        middles = {}
        for corners in self.elements.values():
            for a, b in EDGES[len(corners)]:
                edge = frozenset((corners[a], corners[b]))
                if edge not in middles:
                    middles[edge] = number
                    self.points[number] = [(p + q) / 2 for p, q in zip(self.points[corners[a]], self.points[corners[b]])]
                    number += 1
            corners += [middles[frozenset((corners[a], corners[b]))] for a, b in EDGES[len(corners)]]

    def nodes_at(self, axis, value):
        return [n for n, x in self.points.items() if abs(x[axis] - value) < 1e-9]

    def faces_at(self, axis, value):
        """(element, number of its face from 1) at a side of the box."""
        there = set(self.nodes_at(axis, value))
        for element, nodes in self.elements.items():
            for face, corners in enumerate(FACES[self.dim + 1], 1):
                if all(nodes[c] in there for c in corners):
                    yield element, face


def numbers(values, a_line=12):
    values = [str(v) for v in values]
    return ",\n".join(", ".join(values[i:i + a_line]) for i in range(0, len(values), a_line)) + "\n"


def lines(table, separator=", "):
    return "".join(separator.join([str(n)] + [f"{v:.10g}" for v in values]) + "\n" for n, values in table.items())


def tetrahedra():
    lower = Block((0, 0, 0), (10, 10, 5), (3, 3, 2), 1, 1, 1, 1)
    upper = Block((0, 0, 5), (10, 10, 10), (2, 3, 2), 1001, 1001, 2, 2)
    text = "*HEADING\nTwo blocks of tetrahedra, one on the other: patch test\n*NODE, NSET=Nall\n"
    text += lines(lower.points) + lines(upper.points)
    text += "*ELEMENT, TYPE=C3D4, ELSET=lower\n" + lines(lower.elements)
    text += "*ELEMENT, TYPE=C3D10, ELSET=upper\n" + lines(upper.elements)
    for name, block, z in (("lower_top", lower, 5), ("upper_bottom", upper, 5)):
        text += f"*SURFACE, NAME={name}\n" + "".join(f"{e}, S{face}\n" for e, face in block.faces_at(2, z))
    for name, axis in (("x0", 0), ("y0", 1)):
        text += f"*NSET, NSET={name}\n" + numbers(lower.nodes_at(axis, 0) + upper.nodes_at(axis, 0))
    text += "*NSET, NSET=base\n" + numbers(lower.nodes_at(2, 0))
    text += "*NSET, NSET=press\n" + numbers(upper.nodes_at(2, 10))
    return text


def triangles():
    lower = Block((0, 0), (10, 5), (7, 3), 1, 1, 1, 1)
    upper = Block((0, 5), (10, 10), (5, 2), 1001, 1001, 2, 2)
    names = [(2, 1, "lower"), (2, 2, "upper")]
    elements = [(e, 2, 1, nodes) for e, nodes in lower.elements.items()]
    elements += [(e, 9, 2, nodes) for e, nodes in upper.elements.items()]
    number = 10001
    for tag, name, block, axis, value in (
            (11, "lower_bottom", lower, 1, 0), (12, "lower_top", lower, 1, 5), (13, "lower_left", lower, 0, 0),
            (21, "upper_bottom", upper, 1, 5), (22, "upper_top", upper, 1, 10), (23, "upper_left", upper, 0, 0)):
        names.append((1, tag, name))
        for element, face in block.faces_at(axis, value):
            nodes = block.elements[element]
            line = [nodes[c] for c in FACES[3][face - 1]] + ([nodes[2 + face]] if len(nodes) == 6 else [])
            elements.append((number, 8 if len(line) == 3 else 1, tag, line))
            number += 1
    points = {n: p + [0] for n, p in {**lower.points, **upper.points}.items()}
    text = f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{len(names)}\n"
    text += "".join(f'{d} {tag} "{name}"\n' for d, tag, name in sorted(names)) + "$EndPhysicalNames\n"
    text += f"$Nodes\n{len(points)}\n" + lines(points, " ") + f"$EndNodes\n$Elements\n{len(elements)}\n"
    text += "".join(f"{e} {kind} 2 {tag} {tag} {' '.join(map(str, nodes))}\n" for e, kind, tag, nodes in elements)
    return text + "$EndElements\n"


def main():
    for name, text in (("tetrahedra.inp", tetrahedra()), ("triangles.msh", triangles())):
        with open(os.path.join(sys.argv[1], name), "w") as file:
            file.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    main()
