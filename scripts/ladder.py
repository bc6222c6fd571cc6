# SPDX-License-Identifier: Apache-2.0
"""The two scenes that studies of cost refine: their file, and the keys of size n."""


def block_cells(n):
    """Of the lower and the upper block."""
    return (n, n, (n + 1) // 2), 3 * (round(2 * n / 3),)


def block(n):
    """n cells along the lower block, 2n/3 along the upper. As few coarse cells as these numbers allow: each rank holds
    all of those."""
    sets = {}
    for body, cells in zip(("lower", "upper"), block_cells(n)):
        halvings = min((c & -c).bit_length() - 1 for c in cells)
        sets[f"Bodies/{body}/Subdivisions"] = ",".join(str(c >> halvings) for c in cells)
        sets[f"Bodies/{body}/Refinements"] = halvings
    return "prm/block-on-block.prm", sets


def ball(n, cycles=0):
    """The initial mesh refined n times. cycles: how many of these come with a solution of their own, to start from."""
    return "prm/ball-on-block.prm", {"Mesh/Refinements": n - cycles, "Accuracy/Refinement cycles": cycles,
                                     "Accuracy/Refine fraction": 1, "Accuracy/Coarsen fraction": 0}


SCENES = {"block": block, "ball": ball}
