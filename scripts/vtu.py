# SPDX-License-Identifier: Apache-2.0
"""Read the VTU files of the program, without VTK: only NumPy and the standard library are needed."""

import base64
import zlib
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

# Corners of a cell by its VTK type: lines, quadrilaterals and hexahedra, plain (3, 9, 12) or Lagrange cells of higher order
# (68, 70, 72). The latter begin with their corners as well, and corners suffice for a picture.
CORNERS = {3: range(2), 68: range(2), 9: range(4), 70: range(4), 12: range(8), 72: range(8)}
# Triangles and tetrahedra (5 and 10, of second order 22 and 24) become cells with corners that coincide.
CORNERS |= dict.fromkeys((5, 22, 69), (0, 1, 2, 2)) | dict.fromkeys((10, 24, 71), (0, 1, 2, 2, 3, 3, 3, 3))
# Quadrilaterals and hexahedra of second order (28 and 29) are cut into 4 and 8: the numbers of their nodes by row and layer.
LATTICES = {28: np.array([0, 4, 1, 7, 8, 5, 3, 6, 2]).reshape(1, 3, 3),
            29: np.array([0, 8, 1, 11, 24, 9, 3, 10, 2, 16, 22, 17, 20, 26, 21, 19, 23, 18, 4, 12, 5, 15, 25, 13, 7, 14, 6]).reshape(3, 3, 3)}


def parts_of(kind):
    """The corners of the parts of a cell, by its VTK type."""
    if kind not in LATTICES:
        return np.array([CORNERS[kind]])
    lattice, around = LATTICES[kind], ((0, 0), (0, 1), (1, 1), (1, 0))
    layers = (0, 1) if kind == 29 else (0,)
    return np.array([[lattice[k + z, j + y, i + x] for z in layers for y, x in around]
                     for k in layers for j in (0, 1) for i in (0, 1)])


@dataclass
class Mesh:
    points: np.ndarray  # (n, 3), reference positions; each cell has its own copies of its points
    cells: np.ndarray  # (m, 4) in 2D, (m, 8) in 3D, (m, 2) or (m, 4) for surfaces, indices of points in VTK's order
    fields: dict  # name -> (n,) or (n, components)
    names: dict = field(default_factory=dict)  # "body" or "pair" -> what the numbers in that field stand for

    @property
    def dimension(self):
        return 2 if self.cells.shape[1] == 4 else 3

    def field(self, name):
        """The field of that name, or a component: stress_xy, displacement_x. 'von Mises' and 'von_mises' are the same."""
        name = name.lower().replace(" ", "_")
        plain = {key.lower().replace(" ", "_"): key for key in self.fields}
        if name in plain:
            return self.fields[plain[name]]
        whole, _, axes = name.rpartition("_")
        if whole in plain and axes and set(axes) <= set("xyz"):
            values = self.fields[plain[whole]]
            if values.ndim == 2 and values.shape[1] == 3 ** len(axes):
                return values[:, sum("xyz".index(axis) * 3**i for i, axis in enumerate(reversed(axes)))]
        raise SystemExit(f"There is no field '{name}'; there are: {', '.join(sorted(self.fields))}, and components of vectors "
                         "and tensors, like displacement_x and stress_xy.")


def steps(path):
    """The files of a .pvd file with their times, in the order of the load steps."""
    path = Path(path)
    entries = ElementTree.parse(path).getroot().findall("Collection/DataSet")
    return [(float(entry.get("timestep")), path.parent / entry.get("file")) for entry in entries]


def read(path):
    """The mesh in a .vtu, in all pieces of a .pvtu, or in the last step of a .pvd file."""
    path = Path(path)
    root = ElementTree.parse(path).getroot()
    if root.get("type") == "Collection":
        return read(steps(path)[-1][1])
    if root.get("type") == "PUnstructuredGrid":
        return merge([read(path.parent / piece.get("Source")) for piece in root.iter("Piece")])
    mesh = merge([read_piece(piece, root) for piece in root.iter("Piece")])
    for array in root.findall("UnstructuredGrid/FieldData/DataArray[@type='String']"):
        words = bytes(int(code) for code in array.text.split()).decode().split("\0")
        mesh.names[array.get("Name").removesuffix("_names")] = words[:-1]
    return mesh


def merge(meshes):
    # A rank without cells writes an empty piece, which lacks most arrays.
    meshes = [mesh for mesh in meshes if len(mesh.cells)] or meshes[:1]
    first_point = np.cumsum([0] + [len(mesh.points) for mesh in meshes])
    return Mesh(
        points=np.concatenate([mesh.points for mesh in meshes]),
        cells=np.concatenate([mesh.cells + first for mesh, first in zip(meshes, first_point)]),
        fields={name: np.concatenate([mesh.fields[name] for mesh in meshes]) for name in meshes[0].fields},
        names=meshes[0].names,
    )


def read_piece(piece, root):
    if int(piece.get("NumberOfCells")) == 0:
        return Mesh(np.empty((0, 3)), np.empty((0, 4), int), {})
    arrays = {array.get("Name"): read_array(array, root) for array in piece.find("Cells")}
    starts = np.concatenate([[0], arrays["offsets"][:-1].astype(int)])
    cells, owner = [], []
    for kind in np.unique(arrays["types"]):
        of_kind, parts = np.flatnonzero(arrays["types"] == kind), parts_of(kind)
        cells.append((starts[of_kind, None, None] + parts).reshape(-1, parts.shape[1]))
        owner.append(np.repeat(of_kind, len(parts)))
    corners, owner = arrays["connectivity"].astype(int)[np.concatenate(cells)], np.concatenate(owner)

    # Each cell gets copies of its points, so that fields of cells can be given there too.
    points = read_array(piece.find("Points")[0], root)[corners.ravel()]
    fields = {array.get("Name"): read_array(array, root)[corners.ravel()] for array in piece.findall("PointData/DataArray")}
    for array in piece.findall("CellData/DataArray"):
        fields[array.get("Name")] = np.repeat(read_array(array, root)[owner], corners.shape[1], axis=0)
    return Mesh(points, np.arange(corners.size).reshape(corners.shape), fields)


def read_array(array, root):
    """One DataArray, as text or as zlib-compressed blocks in base64."""
    number = np.dtype(array.get("type").lower())
    text = "".join((array.text or "").split()) if array.get("format") == "binary" else array.text or ""
    if array.get("format") != "binary":
        values = np.array(text.split(), number)
    else:
        # The header (number of blocks, size of a block, size of the last block, compressed size of each block) is
        # encoded apart from the blocks, so it ends at a multiple of four characters.
        word = np.dtype(root.get("header_type", "UInt32").lower())
        n_blocks = int(np.frombuffer(base64.b64decode(text[:12]), word, 1)[0])
        length = -(-(3 + n_blocks) * word.itemsize // 3) * 4
        sizes = np.frombuffer(base64.b64decode(text[:length]), word)[3:]
        data, blocks, start = base64.b64decode(text[length:]), [], 0
        for size in sizes.astype(int):
            blocks.append(zlib.decompress(data[start : start + size]))
            start += size
        values = np.frombuffer(b"".join(blocks), number)
    components = int(array.get("NumberOfComponents", 1))
    return values.reshape(-1, components) if components > 1 else values
