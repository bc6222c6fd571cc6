#!/usr/bin/env python3
"""Write a rubber bellows (Abaqus, axisymmetric): some waves of a wall; see README.md.

    make-bellows.py FILE [FIRST LAST CELLS]

x is the radius, y the axis. The middle of the wall is x = 20 - 4 cos(2 pi s/10), y = s + 0.9 sin(4 pi s/10) from s = FIRST to
LAST (0 to 25), so that waves bulge; the wall is 1.6 thick, and has that many CELLS (100) along it.
"""

import math
import sys

LENGTH, RADIUS, HEIGHT, BULGE, THICKNESS, THROUGH = 10, 20, 4, 0.9, 1.6, 3


def middle(s):
    """Place and unit normal (outwards) of the middle of the wall."""
    phase = 2 * math.pi * s / LENGTH
    x, y = RADIUS - HEIGHT * math.cos(phase), s + BULGE * math.sin(2 * phase)
    tangent = (HEIGHT * math.sin(phase) * 2 * math.pi / LENGTH, 1 + BULGE * math.cos(2 * phase) * 4 * math.pi / LENGTH)
    size = math.hypot(*tangent)
    return (x, y), (tangent[1] / size, -tangent[0] / size)


def equidistant(first, last, n):
    """n + 1 values of s that are equally far apart along the wall."""
    fine = [first + (last - first) * k / 20000 for k in range(20001)]
    lengths = [0.0]
    for a, b in zip(fine, fine[1:]):
        (xa, ya), (xb, yb) = middle(a)[0], middle(b)[0]
        lengths.append(lengths[-1] + math.hypot(xb - xa, yb - ya))
    result, at = [], 0
    for k in range(n + 1):
        while at < len(fine) - 1 and lengths[at] < lengths[-1] * k / n:
            at += 1
        result.append(fine[at])
    return result


def main(file_name, first=0, last=25, along=100):
    number = lambda i, j: 1 + i * (THROUGH + 1) + j
    text = "*HEADING\nA rubber bellows, axisymmetric\n*NODE\n"
    for i, s in enumerate(equidistant(first, last, along)):
        (x, y), (nx, ny) = middle(s)
        for j in range(THROUGH + 1):
            t = THICKNESS * (j / THROUGH - 0.5)
            text += f"{number(i, j)}, {x + t * nx:.10g}, {y + t * ny:.10g}\n"
    text += "*ELEMENT, TYPE=CAX4, ELSET=bellows\n"
    element = lambda i, j: 1 + i * THROUGH + j
    for i in range(along):
        for j in range(THROUGH):
            corners = number(i, j), number(i, j + 1), number(i + 1, j + 1), number(i + 1, j)
            text += f"{element(i, j)}, " + ", ".join(map(str, corners)) + "\n"
    faces = {"bottom": [(element(0, j), 1) for j in range(THROUGH)],
             "top": [(element(along - 1, j), 3) for j in range(THROUGH)],
             "outside": [(element(i, THROUGH - 1), 2) for i in range(along)],
             "inside": [(element(i, 0), 4) for i in range(along)]}
    for name, sides in faces.items():
        text += f"*SURFACE, NAME={name}, TYPE=ELEMENT\n" + "".join(f"{e}, S{side}\n" for e, side in sides)
    with open(file_name, "w") as file:
        file.write(text)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 5):
        sys.exit(__doc__.strip())
    main(sys.argv[1], *(float(s) for s in sys.argv[2:4]), *(int(n) for n in sys.argv[4:]))
