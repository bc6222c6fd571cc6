#!/usr/bin/env python3
"""Write a binary STL file of hills z(x, y) <= 0 over -5 <= x, y <= 5, for the obstacle shape STL.

    make-terrain-stl.py FILE
"""

import math
import struct
import sys

CELLS, HALF = 24, 5.0


def height(x, y):
    """Two waves across each other and a broader one, about 1 from the deepest valley to the summits."""
    waves = math.cos(1.3 * x + 0.4) * math.cos(1.1 * y - 0.3) + 0.5 * math.cos(0.6 * x - 0.9 * y + 1)
    return 0.34 * waves


def main():
    step = 2 * HALF / CELLS
    at = [[(-HALF + i * step, -HALF + j * step) for i in range(CELLS + 1)] for j in range(CELLS + 1)]
    summit = max(height(x, y) for row in at for x, y in row if max(abs(x), abs(y)) <= 4)
    at = [[(x, y, height(x, y) - summit) for x, y in row] for row in at]
    triangles = []
    for j in range(CELLS):
        for i in range(CELLS):
            a, b, c, d = at[j][i], at[j][i + 1], at[j + 1][i + 1], at[j + 1][i]
            triangles += [(a, b, c), (a, c, d)]
    with open(sys.argv[1], "wb") as file:
        file.write(b"terrain".ljust(80) + struct.pack("<I", len(triangles)))
        for a, b, c in triangles:
            u, v = [[q - p for p, q in zip(a, other)] for other in (b, c)]
            normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            length = math.sqrt(sum(n * n for n in normal))
            file.write(struct.pack("<12fH", *(n / length for n in normal), *a, *b, *c, 0))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
