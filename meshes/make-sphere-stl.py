#!/usr/bin/env python3
"""Write sphere-cap.stl, a binary STL file: see README.md.

    make-sphere-stl.py FILE

A dish of triangles on the sphere of radius 1 about the origin, around the lowest point (0,0,-1), up to 30 degrees from
it: hexagonal rings, outside below.
"""

import math
import struct
import sys

RINGS = 10
ANGLE = math.radians(30)


def point(ring, i):
    if ring == 0:
        return (0.0, 0.0, -1.0)
    theta, phi = ANGLE * ring / RINGS, 2 * math.pi * (i % (6 * ring)) / (6 * ring)
    return (math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), -math.cos(theta))


def triangles():
    for ring in range(RINGS):
        for sector in range(6):
            for i in range(ring + 1):
                inner, outer = sector * ring + i, sector * (ring + 1) + i
                yield point(ring, inner), point(ring + 1, outer + 1), point(ring + 1, outer)
                if i < ring:
                    yield point(ring, inner), point(ring, inner + 1), point(ring + 1, outer + 1)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    facets = list(triangles())
    with open(sys.argv[1], "wb") as file:
        file.write(b"dish of the unit sphere".ljust(80) + struct.pack("<I", len(facets)))
        for corners in facets:
            file.write(struct.pack("<12fH", 0, 0, 0, *(x for p in corners for x in p), 0))


if __name__ == "__main__":
    main()
