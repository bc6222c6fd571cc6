# SPDX-License-Identifier: Apache-2.0
"""Large deformation: contact is found where bodies and obstacles have come to, and what nothing finds is said."""

from case import SCENES, VARIED, Case, force_of

FOLD, RING = SCENES / "finite-fold.prm", SCENES / "finite-o-ring.prm"


def first_touch(test):
    """From far away in one step: the same as from where it touches."""
    coarse = ["Mesh/Degree=1"]
    near = force_of(test.results(RING, coarse))
    far = force_of(test.results(RING, coarse + ["Obstacles/plate/Point=0,3", "Obstacles/plate/Displacement=0; -2.25*t"]))
    test.check(abs(far / near - 1) <= 1e-8, f"{far:.12g} from afar, {near:.12g} from near")


def fold(test):
    """A surface that touches itself presses as its half does against a plane of symmetry; in any number of load steps, and on any side."""
    half = ["Bodies/fold/File=../../meshes/bellows-half-wave.inp", "Contact pairs/flanks/Master=plane",
            "Supports/upper/Displacement=free; 0"]
    for refinements, tolerance in ((0, 1.5e-3), (1, 4e-4)):
        finer = [f"Bodies/fold/Refinements={refinements}"]
        a, b = (force_of(test.results(FOLD, finer + sets), "flanks") for sets in ([], half))
        test.check(abs(a / b - 1) <= tolerance, f"{a:.6g} against itself, {b:.6g} against a plane")
    one, three = (force_of(test.results(FOLD, [f"Load steps/Number={n}"]), "flanks") for n in (1, 3))
    test.check(abs(three / one - 1) <= 1e-8, f"{one:.12g} in one load step, {three:.12g} in three")


SLITS = """
set Dimension   = 2
set Deformation = finite
subsection Bodies
  set Names = block
  subsection block
    set Mesh = file
    set File = {mesh}
    set Young's modulus = 1
    set Poisson's ratio = 0.3
  end
end
subsection Supports
  set Names = left, bottom, right, top
  subsection left
    set Boundaries = block.left
    set Displacement = 0; free
  end
  subsection bottom
    set Boundaries = block.bottom
    set Displacement = free; 0
  end
  subsection right
    set Boundaries = block.right
    set Displacement = -0.5*t; free
  end
  subsection top
    set Boundaries = block.top
    set Displacement = free; -0.5*t
  end
end
subsection Contact pairs
  set Names = {pairs}
{sections}end
subsection Load steps
  set Number = automatic
end
"""


def mesh_of_slits():
    """A block of 4 x 4 with a slit like an L, 0.3 wide."""
    cells, corners, surfaces = [], {}, {}
    is_void = lambda i, j: (8 <= i < 20 and 19 <= j < 22) or (17 <= i < 20 and 22 <= j < 32)
    is_cell = lambda i, j: 0 <= i < 40 and 0 <= j < 40 and not is_void(i, j)
    for i in range(40):
        for j in range(40):
            if not is_cell(i, j):
                continue
            square = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            cells.append([corners.setdefault(corner, len(corners) + 1) for corner in square])
            for side, (di, dj, outside) in enumerate(((0, -1, "bottom"), (1, 0, "right"), (0, 1, "top"), (-1, 0, "left")), 1):
                if not is_cell(i + di, j + dj):
                    inside = 0 <= i + di < 40 and 0 <= j + dj < 40
                    for name in ("slit", {1: "down", 2: "east", 3: "up", 4: "west"}[side]) if inside else (outside,):
                        surfaces.setdefault(name, []).append(f"{len(cells)}, S{side}")
    lines = ["*NODE", *(f"{n}, {x / 10}, {y / 10}" for (x, y), n in corners.items()), "*ELEMENT, TYPE=CPE4, ELSET=ALL",
             *(f"{n}, " + ", ".join(map(str, cell)) for n, cell in enumerate(cells, 1))]
    for name, faces in surfaces.items():
        lines += [f"*SURFACE, NAME={name}, TYPE=ELEMENT", *faces]
    return "\n".join(lines) + "\n"


def slits(test):
    """A surface that touches itself in directions at a right angle, with the same forces as pairs of its sides."""
    mesh = test.write("slits.inp", mesh_of_slits())

    def forces(name, **pairs):
        sections = "".join(f"  subsection {pair}\n    set Slave = block.{slave}\n    set Master = block.{master}\n"
                           "    set Slave choice = as named\n  end\n" for pair, (slave, master) in pairs.items())
        text = SLITS.format(mesh=mesh, pairs=", ".join(pairs), sections=sections)
        return test.results(test.write(f"slits-{name}.prm", text))

    itself, apart = forces("itself", slit=("slit", "slit")), forces("apart", across=("up", "down"), along=("east", "west"))
    a = force_of(itself, "slit")
    across, along = (force_of(apart, pair) for pair in ("across", "along"))
    test.print(f"{a:.6g} against itself, {across:.6g} + {along:.6g} of its sides")
    test.check(min(across, along) > 0.05 * a, "it does not touch itself in both directions")
    test.check(abs(a / (across + along) - 1) <= 5e-3, f"{a:.6g} against itself, {across + along:.6g} of its sides")
    test.check(not unseen(itself), f"{unseen(itself)} of a surface that is seen")


def unseen(results):
    """What the verdict says of contact that no pair looks for."""
    found = [check for check in results["verdict"]["checks"] if check["check"] == "undetected contact"]
    return found[0]["message"] if found[0]["outcome"] != "passed" else ""


def unseen_contact(test):
    """Who goes through what, where no pair looks for contact."""
    half = ["Bodies/fold/File=../../meshes/bellows-half-wave.inp", "Supports/upper/Displacement=free; 0"]
    far = ["Contact pairs/flanks/Master=plane", "Obstacles/plane/Point=0, 100"]
    block = SCENES / "finite-block.prm"
    wall = ["Obstacles/Names=plate, wall", "Obstacles/wall/Shape=plane", "Obstacles/wall/Point=1.05, 0", "Obstacles/wall/Normal=-1, 0"]
    beside = ["Bodies/Names=block, post", "Bodies/post/Mesh=box", "Bodies/post/Corners=1.05,0 : 2,0.6", "Bodies/post/Subdivisions=3,3",
              "Bodies/post/Young's modulus=1", "Bodies/post/Poisson's ratio=0.3",
              "Supports/Names=base, side, foot", "Supports/foot/Boundaries=post.bottom",
              "Supports/foot/Displacement=0; 0"]
    small = ["Deformation=small"]
    for what, scene, sets, expected in (
            ("with its pair", FOLD, ["Obstacles/Names="], ""),
            ("a fold", FOLD, far, "'fold.outside' penetrates 'fold.outside'"),
            ("half of a fold", FOLD, half + far, "'fold.outside' penetrates the plane of symmetry 'fold.top'"),
            ("a block", block, [], ""),
            ("a block beside a wall", block, wall, "'block.right' penetrates the obstacle 'wall'"),
            ("a block beside another", block, beside, "'block.right' penetrates 'post.left'"),
            ("a block of small strain", block, small, ""),
            ("a block of small strain beside a wall", block, small + wall, "'block.right' penetrates the obstacle 'wall'"),
            ("a block of small strain beside another", block, small + beside, "'block.right' penetrates 'post.left'")):
        for ranks in (1, 2):
            found = unseen(test.results(scene, sets, ranks))
            test.check(found.startswith(expected) and bool(found) == bool(expected), f"{what}, {ranks} ranks: {found or 'nothing'}")


def thin_wall(test):
    """A roller that would be on the other side of a wall after one load step does not get there."""
    scene = VARIED / "wall.prm"
    many, auto = (test.results(scene, [f"Load steps/Number={n}"]) for n in (10, "automatic"))
    a, b = force_of(many), force_of(auto)
    test.print(f"{a:.10g} in 10 load steps, {b:.10g} in {len(auto['load_steps'])} of their own")
    test.check(a > 0 and abs(b / a - 1) <= 1e-8, f"{a:.10g} in 10 load steps, {b:.10g} in {len(auto['load_steps'])}")
    run = test.run(scene, ["Load steps/Number=1", "Load steps/Cut-backs=0"])
    test.check(run.code == 3 and "would pass through 'ring.outer' in one load step" in run.out + run.err, f"exit code {run.code}")


def led_without_force(test):
    """Bodies that are led about meet no force at first, or at last: no reason not to solve that."""
    scene = VARIED / "led.prm"
    for sets in ([], ["Mesh/Degree=2"], ["Bodies/block/Young's modulus=2e5"], ["Contact method/Method=penalty"]):
        one, many = (force_of(test.results(scene, [*sets, f"Load steps/Number={n}"]), "p") for n in (1, 3))
        test.check(one > 0.1 and abs(many / one - 1) <= 1e-8, f"{sets}: {one:.10g} in one load step, {many:.10g} in three")
    away = force_of(test.results(scene, ["Supports/top/Displacement=0; -1.2*t*(1-t)", "Load steps/Number=4"]), "p")
    test.check(abs(away) <= 1e-12, f"a force of {away:.3g} is left")


def to_the_middle(test):
    """A roller that comes with its middle to a surface in one load step, from where that sees nothing of it."""
    scene = VARIED / "beam.prm"
    many, one = (force_of(test.results(scene, [f"Load steps/Number={n}"])) for n in (20, 1))
    test.print(f"{many:.10g} in 20 load steps, {one:.10g} in one that is cut")
    test.check(many > 1e-4 and abs(one / many - 1) <= 1e-8, f"{many:.10g} in 20 load steps, {one:.10g} in one")


def obstacle_inside(test):
    """A small obstacle gets into a body between the points of its surface, where contact finds nothing of it; or a part of an obstacle
    does while another part has pressure."""
    roller, lobes = VARIED / "pressed.prm", VARIED / "lobes.prm"
    one, five, fine = (force_of(test.results(roller, sets)) for sets in (
        [], ["Load steps/Number=5"], ["Load steps/Number=5", "Bodies/block/Subdivisions=40,20"]))
    test.print(f"a roller as wide as two faces: {one:.10g} in one load step, {five:.10g} in five, {fine:.6g} on finer faces")
    # Several solutions are near each other, and rounding chooses: the surface may bend to the one side of the roller or the other.
    test.check(abs(five / one - 1) <= 0.05, f"{one:.10g} in one load step, {five:.10g} in five")
    # With three faces across, pressures are known to a tenth.
    test.check(abs(five / fine - 1) <= 0.1, f"{five:.6g}, {fine:.6g} on finer faces")
    pin = ["Obstacles/tip/Center=0.03, 1.02", "Obstacles/tip/Radius=0.02"]
    for name, scene, sets in (("pin", roller, pin), ("lobes", lobes, [])):
        run = test.run(scene, [*sets, "Load steps/Cut-backs=2"])
        test.check(run.code == 3 and "has passed through the obstacle 'tip'" in run.out, f"{name}: exit code {run.code}: {run.out[-500:]}")
    # The formula of a gap says little far from where it is zero, but it knows on which side.
    steep = test.results(lobes, ["Bodies/block/Subdivisions=48,10", "Obstacles/tip/Displacement=0; -0.3*t", "Obstacles/tip/Gap=1 - y + 20*(x - 1)^2"])
    test.check(not unseen(steep), f"a surface that is not in the obstacle at all is warned of: {unseen(steep)}")


def passed_through(test):
    """Flat faces that have gone through each other by more than half a cell, so that no surface is near."""
    scene = VARIED / "through.prm"
    for depth in (0.06, 0.15, 0.6):
        for ranks in (1, 2):
            found = unseen(test.results(scene, [f"Supports/top/Displacement=0; -{0.3 + depth}*t"], ranks))
            test.check("'upper." in found, f"by {depth}, {ranks} ranks: {found or 'nothing'}")
    found = unseen(test.results(scene, ["Supports/top/Displacement=0; -0.2*t"]))
    test.check(not found, found)


def pulled(test):
    """A uniform tension is exact, and no pressure that alternates."""
    scene = VARIED / "pulled.prm"
    for degree in (1, 2):
        results = test.results(scene, [f"Mesh/Degree={degree}"])
        force = force_of(results, "c")
        exact = -2 * 500 * (1.1 - 1 / 1.1)  # neo-Hooke of nu = 0, stretched by 1.1, on a width of 2
        test.check(abs(force / exact - 1) <= 1e-8, f"degree {degree}: {force:.10g} instead of {exact:.10g}")
        test.check(results["verdict"]["outcome"] == "passed", f"degree {degree}: {results['verdict']}")


def gaps_at_rest(test):
    """Checks of initial overlaps and of the path of friction see the undeformed bodies with any contact geometry."""
    kinds = (["Contact method/Contact geometry=reference"], ["Contact method/Contact geometry=updated"], ["Deformation=finite"])

    def checked(name, ranks, sets):
        checks = test.results(SCENES / name, sets, ranks)["verdict"]["checks"]
        return {(one["check"], one["where"]): one for one in checks}
    for ranks, sets in enumerate(kinds, 1):
        checks = checked("deep-overlap.prm", ranks, sets)
        for pair, overlap in (("blocks", 2), ("foot", 1.6)):
            one = checks["initial overlap / face size", f"pair {pair}"]
            test.check(one["outcome"] == "warned" and abs(one["value"] - overlap) <= 1e-9, f"{sets}: {one}")
    for sets in kinds[:2]:  # at finite strain the program takes two load steps
        one = checked("hertz-2d.prm", 1, [*sets, "Contact pairs/contact/Friction=0.3"])["load steps of the path", "pair contact"]
        test.check(one["outcome"] == "warned", f"{sets}: {one}")


def cases():
    yield Case("moving", "first touch", first_touch)
    yield Case("moving", "fold", fold)
    yield Case("moving", "slits", slits)
    yield Case("moving", "undetected contact", unseen_contact, ranks=2)
    yield Case("moving", "thin wall", thin_wall)
    yield Case("moving", "led", led_without_force)
    yield Case("moving", "to the middle", to_the_middle)
    yield Case("moving", "obstacle inside", obstacle_inside)
    yield Case("moving", "passed through", passed_through, ranks=2)
    yield Case("moving", "pulled", pulled)
    yield Case("moving", "gaps at rest", gaps_at_rest, ranks=2)
