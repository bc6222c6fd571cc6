#!/usr/bin/env python3
"""Write bracket-tetrahedra.msh and bracket-hexahedra.msh: an angle bracket and the bolt through its foot, a half of the whole.

    make-bracket.py FOLDER [SIZE]          needs gmsh's Python package (pip install gmsh)

The foot, 50 x 30 x 8, lies on z = 0, the wall stands at x = 0 and is 58 high, the plane of symmetry is y = 0. The bolt has a shank
of radius 4 in a hole of radius 4.5 and a head of radius 7 on the foot. Elements are of second order, of about SIZE (default 5)
and half of it at the bolt; the hexahedra are extruded from quadrilaterals of the same size.
"""

import os
import sys

import gmsh

HEIGHT, LENGTH, WIDTH, THICK = 58, 50, 30, 8
CENTER, HOLE, SHANK, HEAD, HEAD_HEIGHT, DEPTH = (30, 15), 4.5, 4, 7, 5, 12
E = 1e-3

occ = gmsh.model.occ


def extruded(surfaces, height, size, hexahedra):
    layers = [max(2, round(abs(height) / size))] if hexahedra else []
    made = occ.extrude([(2, s) for s in surfaces], 0, 0, height, layers, recombine=hexahedra)
    return [tag for dim, tag in made if dim == 3]


def body(inner, outer, above, below, size, hexahedra):
    """Of a plan at z = THICK: what is in `inner`, and what of `outer` is not, each extruded up or down by `above`, `below`."""
    _, (first, second) = occ.fragment([(2, inner)], [(2, outer)])
    inner, outer = [s for _, s in first], [s for _, s in second if (2, s) not in first]
    occ.synchronize()
    if hexahedra:
        for s in inner + outer:
            gmsh.model.mesh.setRecombine(2, s)
    volumes = []
    for surfaces, height in ((inner + outer if above[1] else inner, above[0]), (inner + outer if below[1] else inner, -below[0])):
        volumes += extruded(surfaces, height, size, hexahedra)
    return volumes


def bracket(size, hexahedra):
    wall = occ.addRectangle(0, 0, THICK, THICK, WIDTH)
    foot = occ.addRectangle(THICK, 0, THICK, LENGTH - THICK, WIDTH)
    foot = occ.cut([(2, foot)], [(2, disk(HOLE))])[0][0][1]
    return body(wall, foot, (HEIGHT - THICK, False), (THICK, True), size / 2, hexahedra)


def bolt(size, hexahedra):
    return body(disk(SHANK), disk(HEAD), (HEAD_HEIGHT, True), (DEPTH + THICK, False), size / 2, hexahedra)


def disk(radius):
    return occ.addDisk(*CENTER, THICK, radius, radius)


def united(volumes):
    """For tetrahedra nothing inside of a body has to be kept."""
    made, _ = occ.fuse([(3, volumes[0])], [(3, v) for v in volumes[1:]])
    occ.synchronize()
    return [tag for _, tag in made]


def name_faces(volumes, name, planes):
    """`planes`: name -> (axis, value); the rest of the surface has no name."""
    group = gmsh.model.addPhysicalGroup(3, volumes)
    gmsh.model.setPhysicalName(3, group, name)
    faces = [tag for _, tag in gmsh.model.getBoundary([(3, v) for v in volumes], oriented=False)]
    for what, (axis, value, inside) in planes.items():
        members = []
        for face in faces:
            box = gmsh.model.getBoundingBox(2, face)
            if abs(box[axis] - value) < E and abs(box[axis + 3] - value) < E and inside(box):
                members.append(face)
        assert members, what
        gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, members), what)


def make(file, size, hexahedra):
    gmsh.model.add(file)
    first, second = bracket(size, hexahedra), bolt(size, hexahedra)
    if not hexahedra:
        first, second = united(first), united(second)
    occ.synchronize()
    always = lambda box: True
    name_faces(first, "bracket", {"bottom": (2, 0, always), "symmetry": (1, 0, always), "wall_top": (2, HEIGHT, always),
                                  "seat": (2, THICK, lambda box: box[3] > LENGTH - 1)})
    name_faces(second, "bolt", {"head": (2, THICK, always), "end": (2, -DEPTH, always)})
    field = gmsh.model.mesh.field
    field.add("Cylinder", 1)
    for key, value in (("XCenter", CENTER[0]), ("YCenter", CENTER[1]), ("ZAxis", 4 * HEIGHT), ("Radius", HEAD + 1),
                       ("VIn", size / 2), ("VOut", size)):
        field.setNumber(1, key, value)
    field.setAsBackgroundMesh(1)
    for option, value in (("MeshSizeExtendFromBoundary", 0), ("MeshSizeFromPoints", 0), ("ElementOrder", 2),
                          ("SecondOrderIncomplete", hexahedra), ("HighOrderOptimize", 1), ("MshFileVersion", 4.1), ("Binary", 0),
                          ("Algorithm", 8 if hexahedra else 5),
                          ("RecombinationAlgorithm", 2)):
        gmsh.option.setNumber("Mesh." + option, value)
    gmsh.model.mesh.generate(3)
    gmsh.write(file)
    shorten(file)
    gmsh.model.remove()


def shorten(file):
    """Ten digits of coordinates will do."""
    with open(file) as text:
        lines = text.read().split("\n")
    begin, end = lines.index("$Nodes"), lines.index("$EndNodes")
    lines[begin:end] = [" ".join(f"{float(word):.10g}" if "." in word else word for word in line.split())
                        for line in lines[begin:end]]
    with open(file, "w") as text:
        text.write("\n".join(lines))


def main():
    size = float(sys.argv[2]) if len(sys.argv) > 2 else 5
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    for name, hexahedra in (("tetrahedra", False), ("hexahedra", True)):
        make(os.path.join(sys.argv[1], f"bracket-{name}.msh"), size, hexahedra)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__.strip())
    main()
