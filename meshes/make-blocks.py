#!/usr/bin/env python3
"""Write the meshes of blocks in formats of other programs.

    make-blocks.py FOLDER

blocks.inp, blocks-2d.inp (Abaqus, CalculiX) and blocks.vtu (VTK): see README.md.
"""

import itertools
import os
import sys


class Block:
    """A box of cells in lexicographic order, the first coordinate fastest."""

    def __init__(self, low, high, cells, first_node=1, first_element=1, wavy=0):
        self.dim = len(cells)
        self.cells, self.first_node, self.first_element = cells, first_node, first_element
        self.points = {}
        for index in itertools.product(*(range(n + 1) for n in reversed(cells))):
            index = index[::-1]
            inside = all(0 < i < n for i, n in zip(index, cells))
            shift = wavy * (-1) ** sum(index) if inside else 0
            x = [a + (b - a) * i / n + shift * (b - a) / n for a, b, i, n in zip(low, high, index, cells)]
            self.points[self.node(index)] = x
        self.elements = {}
        for number, index in enumerate(itertools.product(*(range(n) for n in reversed(cells)))):
            around = [(0, 0), (1, 0), (1, 1), (0, 1)]
            corners = [c + (z,) for z in (0, 1) for c in around] if self.dim == 3 else around
            self.elements[first_element + number] = [
                self.node([i + c for i, c in zip(index[::-1], corner)]) for corner in corners]

    def node(self, index):
        number, stride = self.first_node, 1
        for i, n in zip(index, self.cells):
            number, stride = number + i * stride, stride * (n + 1)
        return number

    def layer(self, axis, last):
        """Elements at one side of the box."""
        def index(number):
            rest = number - self.first_element
            for n in self.cells[:axis]:
                rest //= n
            return rest % self.cells[axis]
        return [e for e in self.elements if index(e) == (self.cells[axis] - 1 if last else 0)]

    def nodes_at(self, axis, value):
        return [n for n, x in self.points.items() if abs(x[axis] - value) < 1e-9]


def numbers(values, a_line=12):
    values = [str(v) for v in values]
    return ",\n".join(", ".join(values[i:i + a_line]) for i in range(0, len(values), a_line)) + "\n"


def nodes_text(block):
    return "".join(f"{n}, " + ", ".join(f"{x:.10g}" for x in p) + "\n" for n, p in block.points.items())


def elements_text(block):
    return "".join(f"{e}, " + ", ".join(map(str, nodes)) + "\n" for e, nodes in block.elements.items())


TAIL = """**
** Materials, supports and steps are for other programs.
*MATERIAL, NAME=stiff
*ELASTIC
200000., 0.3
*MATERIAL, NAME=soft
*ELASTIC
70000., 0.33
*SOLID SECTION, ELSET=lower, MATERIAL=stiff
*SOLID SECTION, ELSET=upper, MATERIAL=soft
*SURFACE INTERACTION, NAME=hard
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
1e8
*CONTACT PAIR, INTERACTION=hard, TYPE=SURFACE TO SURFACE
upper_bottom, lower_top
"""


def blocks_3d():
    lower = Block((0, 0, 0), (10, 10, 5), (4, 3, 2), wavy=0.1)
    upper = Block((0, 0, 5), (10, 10, 10), (3, 4, 2), 1001, 1001, wavy=0.1)
    bottom = upper.layer(2, False)
    text = """*HEADING
Two blocks, one on the other: patch test
** The nodes of both blocks, and all of them in one set
*NODE, NSET=Nall
""" + nodes_text(lower) + nodes_text(upper)
    text += "*ELEMENT, TYPE=C3D8, ELSET=lower\n" + elements_text(lower)
    text += "*Element, type=C3D8R, elset=upper\n" + elements_text(upper)
    text += "**\n** sets of elements at the interface, and surfaces of their faces\n"
    text += f"*ELSET, ELSET=lower_last, GENERATE\n{min(lower.layer(2, True))}, {max(lower.elements)}, 1\n"
    text += "*SURFACE, NAME=lower_top, TYPE=ELEMENT\nlower_last, S2\n"
    text += "*SURFACE, NAME=upper_bottom\n" + "".join(f"{e}, S1\n" for e in bottom)
    text += "**\n** sets of nodes for supports\n"
    for name, axis, value in (("x0", 0, 0), ("y0", 1, 0)):
        text += f"*NSET, NSET={name}\n" + numbers(lower.nodes_at(axis, value) + upper.nodes_at(axis, value))
    text += "*NSET, NSET=base\n" + numbers(lower.nodes_at(2, 0))
    text += "*NSET, NSET=press\n" + numbers(upper.nodes_at(2, 10))
    text += TAIL + """*STEP
*STATIC
*BOUNDARY
x0, 1, 1
y0, 2, 2
base, 3, 3
press, 3, 3, -0.01
*NODE PRINT, NSET=base, TOTALS=ONLY
RF
*END STEP
"""
    return text


def blocks_2d():
    lower = Block((0, 0), (10, 5), (7, 3), wavy=0.1)
    upper = Block((0, 5), (10, 10), (5, 2), 101, 101, wavy=0.1)
    text = "*Heading\n two blocks, plane strain\n*Node\n" + nodes_text(lower) + nodes_text(upper)
    text += "*Element, type=CPE4, elset=lower\n" + elements_text(lower)
    text += "*Element, type=CPE4R, elset=upper\n" + elements_text(upper)
    for name, block, axis, last, label in (
            ("lower_top", lower, 1, True, "S3"), ("lower_bottom", lower, 1, False, "S1"),
            ("lower_left", lower, 0, False, "S4"), ("upper_bottom", upper, 1, False, "S1"),
            ("upper_top", upper, 1, True, "S3"), ("upper_left", upper, 0, False, "S4")):
        text += f"*Elset, elset=_{name}_{label}, internal\n" + numbers(block.layer(axis, last))
        text += f"*Surface, type=ELEMENT, name={name}\n_{name}_{label}, {label}\n"
    return text + TAIL


def array(name, kind, values, components=1):
    text = " ".join(f"{v:.10g}" if isinstance(v, float) else str(v) for v in values)
    extra = f' NumberOfComponents="{components}"' if components > 1 else ""
    return f'        <DataArray type="{kind}" Name="{name}"{extra} format="ascii">\n          {text}\n        </DataArray>\n'


def blocks_vtu():
    lower = Block((0, 0, 0), (10, 10, 5), (4, 3, 2), 0, 0)
    upper = Block((0, 0, 5), (10, 10, 10), (3, 4, 2), len(lower.points), len(lower.elements))
    points = [float(x) for block in (lower, upper) for p in block.points.values() for x in p]
    cells = [nodes for block in (lower, upper) for nodes in block.elements.values()]
    body = [1] * len(lower.elements) + [2] * len(upper.elements)
    return ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">\n'
            f'  <UnstructuredGrid>\n    <Piece NumberOfPoints="{len(points) // 3}" NumberOfCells="{len(cells)}">\n'
            "      <Points>\n" + array("Points", "Float64", points, 3) + "      </Points>\n      <Cells>\n"
            + array("connectivity", "Int64", [n for cell in cells for n in cell])
            + array("offsets", "Int64", range(8, 8 * len(cells) + 1, 8))
            + array("types", "UInt8", [12] * len(cells))
            + '      </Cells>\n      <CellData Scalars="body">\n' + array("body", "Int32", body)
            + "      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n")


def main():
    folder = sys.argv[1]
    for name, text in (("blocks.inp", blocks_3d()), ("blocks-2d.inp", blocks_2d()), ("blocks.vtu", blocks_vtu())):
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    main()
