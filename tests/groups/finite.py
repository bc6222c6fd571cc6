"""Large deformation: what must not depend on how it was reached, nor on how it was computed; and what the program refuses."""

from case import SCENES, Case

RING, CYLINDER, PUNCH, FOLD = (SCENES / f"finite-{name}.prm" for name in ("o-ring", "half-cylinder", "punch", "fold"))
HERTZ = SCENES / "hertz-2d.prm"
COARSE_RING = ["Mesh/Degree=1"]
COARSE_CYLINDER = ["Bodies/disc/Refinements=2", "Bodies/block/Subdivisions=12,8"]


def force_of(results, pair="contact"):
    return results["load_steps"][-1]["pairs"][pair]["normal_force"]


def same_in_steps(scene, sets, tolerance, numbers, most, pair="contact"):
    """The path does not matter: so does not the number of load steps. The last number of them starts from where the ones before lead
    to, and takes no more than `most` steps of Newton's method in all."""
    def body(test):
        results = [test.results(scene, sets + [f"Load steps/Number={n}"]) for n in numbers]
        forces = [force_of(one, pair) for one in results]
        newton = [step["newton_iterations"] for step in results[-1]["load_steps"]]
        test.print(f"steps of Newton's method in {numbers[-1]} load steps: {newton}")
        test.check(sum(newton) <= most, f"{newton} steps of Newton's method")
        test.print(", ".join(f"{n}: {force:.12g}" for n, force in zip(numbers, forces)))
        for n, force in zip(numbers, forces):
            test.check(abs(force / forces[0] - 1) <= tolerance, f"{force:.12g} in {n} steps, {forces[0]:.12g} in one")
    return body


def second_order(test):
    """Segments end where the master's faces do, at the edges of the punch too: what is out of balance where surfaces are placed falls
    by second order."""
    rows = [line.split() for line in test.run(PUNCH).out.splitlines()]
    first = [float(row[3]) for row in rows if len(row) == 7 and row[0] == "0"]
    test.print(" ".join(f"{x:.1e}" for x in first))
    test.check(len(first) <= 9, f"{len(first)} placements")
    near = [(a, b) for a, b in zip(first, first[1:]) if 1e-7 < a < 1e-2]
    test.check(near and all(b <= 0.1 * a for a, b in near), "that does not fall by second order")


def first_touch(test):
    """From far away in one step: the same as from where it touches."""
    near = force_of(test.results(RING, COARSE_RING))
    far = force_of(test.results(RING, COARSE_RING + ["Obstacles/plate/Point=0,3", "Obstacles/plate/Displacement=0; -2.25*t"]))
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


def write(test, name, text):
    """A file beside the runs of a test."""
    test.directory.mkdir(parents=True, exist_ok=True)
    file = test.directory / name
    file.write_text(text)
    return file


def slits(test):
    """A surface that touches itself in directions at a right angle, with the same forces as pairs of its sides."""
    mesh = write(test, "slits.inp", mesh_of_slits())

    def forces(name, **pairs):
        sections = "".join(f"  subsection {pair}\n    set Slave = block.{slave}\n    set Master = block.{master}\n"
                           "    set Sides = as named\n  end\n" for pair, (slave, master) in pairs.items())
        text = SLITS.format(mesh=mesh, pairs=", ".join(pairs), sections=sections)
        return test.results(write(test, f"slits-{name}.prm", text))

    itself, apart = forces("itself", slit=("slit", "slit")), forces("apart", across=("up", "down"), along=("east", "west"))
    a = force_of(itself, "slit")
    across, along = (force_of(apart, pair) for pair in ("across", "along"))
    test.print(f"{a:.6g} against itself, {across:.6g} + {along:.6g} of its sides")
    test.check(min(across, along) > 0.05 * a, "it does not touch itself in both directions")
    test.check(abs(a / (across + along) - 1) <= 5e-3, f"{a:.6g} against itself, {across + along:.6g} of its sides")
    test.check(not unseen(itself), f"{unseen(itself)} of a surface that is seen")


def unseen(results):
    """What the verdict says of contact that no pair looks for."""
    found = [check for check in results["verdict"]["checks"] if check["check"] == "unseen contact"]
    return found[0]["what"] if found[0]["outcome"] != "passed" else ""


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
            ("with its pair", FOLD, [], ""),
            ("a fold", FOLD, far, "'fold.outside' goes through 'fold.outside'"),
            ("half of a fold", FOLD, half + far, "'fold.outside' goes through the plane of symmetry 'fold.top'"),
            ("a block", block, [], ""),
            ("a block beside a wall", block, wall, "'block.right' goes through the obstacle 'wall'"),
            ("a block beside another", block, beside, "'block.right' goes through 'post.left'"),
            ("a block of small strain", block, small, ""),
            ("a block of small strain beside a wall", block, small + wall, "'block.right' goes through the obstacle 'wall'"),
            ("a block of small strain beside another", block, small + beside, "'block.right' goes through 'post.left'")):
        for ranks in (1, 2):
            found = unseen(test.results(scene, sets, ranks))
            test.check(found.startswith(expected) and bool(found) == bool(expected), f"{what}, {ranks} ranks: {found or 'nothing'}")


def moved(test):
    """Far from where they were at rest, bodies have the same forces, and the same pressures, which are not uniform."""
    def solved(way):
        return test.results(CYLINDER, ["Mesh/Degree=2", *COARSE_CYLINDER, f"Supports/base/Displacement=free; {way}*t",
                                       f"Supports/top/Displacement=free; ({way}-0.2)*t"])["load_steps"][-1]["pairs"]["contact"]
    here, there = solved(0), solved(3)
    for quantity, tolerance in (("normal_force", 1e-8), ("max_pressure", 1e-6), ("area", 1e-6)):
        a, b = here[quantity], there[quantity]
        test.check(abs(b / a - 1) <= tolerance, f"{quantity}: {a:.10g}, moved by three radii {b:.10g}")
    mean = here["normal_force"] / here["area"]
    test.check(mean < here["max_pressure"] < 2 * mean, f"a largest pressure of {here['max_pressure']:.6g} with a mean of {mean:.6g}")


def automatic_steps(test):
    """Steps that are cut and grow end where others do."""
    sets = ["Bodies/disc/Refinements=3", "Bodies/block/Subdivisions=24,16"]
    one, many = (force_of(test.results(CYLINDER, [*sets, f"Load steps/Number={n}"])) for n in (5, "automatic"))
    test.check(abs(many / one - 1) <= 1e-8, f"{one:.12g} in five load steps, {many:.12g} in automatic ones")


def automatic_deformation(test):
    """Small where that is enough, with the same result; else finite, likewise, with what small strain cannot have refused by name."""
    auto = "Deformation=automatic"
    small, same = (test.results(HERTZ, sets) for sets in ([], [auto]))
    a, b = (results["load_steps"][-1]["pairs"]["contact"]["normal_force"] for results in (small, same))
    test.check(same["deformation"]["finite"] is False and 0 < same["deformation"]["neglected_work"] < 0.01, "Hertz' is not small")
    test.check(a == b, f"{a:.12g} with small, {b:.12g} with automatic deformation")
    gentle, strong = ([*COARSE_CYLINDER, f"Supports/top/Displacement=free; -{depth}*t"] for depth in (1e-4, 0.1))
    results = test.results(CYLINDER, [*gentle, auto, "Contact method/Contact geometry=updated"])
    test.check(results["deformation"]["finite"] is False, "a displacement of 1e-4 is not small")
    results = test.results(CYLINDER, [*strong, auto])
    finite, other = force_of(test.results(CYLINDER, strong)), force_of(results)
    test.check(results["deformation"]["finite"] and results["deformation"]["neglected_work"] > 0.01, "a tenth of the radius is small")
    test.check(abs(other / finite - 1) <= 1e-8, f"{finite:.12g} with finite, {other:.12g} with automatic deformation")
    run = test.run(CYLINDER, [*strong, auto, "Output/Linear reference=yes"])
    test.check(run.code == 2 and "Linear reference = yes: nothing is linear" in run.err, "that is not refused by name")


def contrast(test):
    """A disc and a block whose moduli differ by factors of up to a thousand either way; in the end one of them is rigid."""
    auto, forces = "Load steps/Number=automatic", {}
    for ratio in (1e-3, 1e-2, 1e2, 1e3):
        forces[ratio] = force_of(test.results(CYLINDER, [*COARSE_CYLINDER, f"Bodies/disc/Young's modulus={ratio}", auto]))
    test.print(", ".join(f"{ratio:g}: {force:.6g}" for ratio, force in forces.items()))
    test.check(abs(forces[1e-3] / forces[1e-2] / 0.1 - 1) <= 0.03, "a block that is a hundred times as stiff is not nearly rigid")
    test.check(0 < forces[1e3] / forces[1e2] - 1 <= 0.03, "a disc that is a hundred times as stiff is not nearly rigid")


def penalties(test):
    """Penalties of any size: the stiffer, the nearer to multipliers, from below."""
    exact = force_of(test.results(CYLINDER, COARSE_CYLINDER))
    errors = []
    for factor in (1, 10, 1e2, 1e4, 1e6):
        force = force_of(test.results(CYLINDER, [*COARSE_CYLINDER, "Contact method/Method=penalty",
                                                 f"Contact method/penalty/Factor={factor:g}"]))
        errors.append(1 - force / exact)
    test.print(" ".join(f"{error:.1e}" for error in errors))
    test.check(all(0.5 * a >= b > -1e-7 for a, b in zip(errors, errors[1:])), "errors do not fall with stiffer penalties")
    test.check(errors[0] < 0.2 and abs(errors[-1]) < 1e-5, "they are too large")


def meshes(test):
    """Coarse against fine either way, and slave and master exchanged."""
    sets = {"fine block": ["Bodies/block/Subdivisions=48,32"], "coarse block": ["Bodies/block/Subdivisions=7,5"],
            "exchanged": ["Contact pairs/contact/Slave=block.top", "Contact pairs/contact/Master=disc.arc",
                          "Contact pairs/contact/Sides=as named"]}
    for name, changes in sets.items():
        force = 2 * abs(test.results(CYLINDER, changes)["load_steps"][-1]["pairs"]["contact"]["force"][1])
        test.check(abs(force / 0.24125 - 1) <= 0.01, f"{name}: {force:.6g} instead of 0.24125")


def compressed(test):
    """To half of the height and less, in automatic steps; exact forces of the nominal stress at that stretch."""
    for stretch, exact in ((0.6, 0.62434856875), (0.4, 1.4192582282)):
        results = test.results(SCENES / "finite-stack-3d.prm", [f"Supports/top/Displacement=free; free; {2 * (stretch - 1)}*t",
                                                                "Load steps/Number=automatic"])
        force = force_of(results, "joint")
        test.check(abs(force / exact - 1) <= 1e-8, f"at a stretch of {stretch} {force:.10g} instead of {exact}")
        test.check(len(results["load_steps"]) <= 10, f"{len(results['load_steps'])} load steps")


def refined(test):
    """Hanging nodes, and displacements that are carried over to them."""
    results = test.results(CYLINDER, ["Accuracy/Refinement cycles=2"], 2)
    force = 2 * results["load_steps"][-1]["pairs"]["contact"]["force"][1]
    test.print(f"{force:.6g}")
    test.check(abs(force / 0.24125 - 1) <= 2e-3, f"the force is {force:.6g} instead of 0.24125")


def linear_limit(model):
    """Of small loads both theories say the same, up to the strain."""
    def body(test):
        small = 1e-4
        sets = [f"Model={model}", f"Obstacles/plate/Displacement=0; -{small}*t"] + COARSE_RING
        a, b = (test.results(RING, sets + [f"Deformation={word}", "Contact method/Contact geometry=updated"])
                for word in ("small", "finite"))
        fa, fb = force_of(a), force_of(b)
        test.check(fa > 0 and abs(fb / fa - 1) <= 30 * small, f"small {fa:.8g}, finite {fb:.8g}")
    return body


def units(test):
    """In millimetres and megapascals, or metres and pascals."""
    one = force_of(test.results(RING, COARSE_RING))
    other = force_of(test.results(RING, COARSE_RING + ["Bodies/ring/Young's modulus=1e6"]))
    test.check(abs(other / (1e6 * one) - 1) <= 1e-8, f"{other:.12g} instead of {1e6 * one:.12g}")


def law(name, *keys):
    """All materials solve the ring, and are the same in the limit: forces differ by strains, not by moduli."""
    def body(test):
        sets = [*COARSE_RING, f"Bodies/ring/Law={name}", *keys]
        results = test.results(RING, sets + ["Obstacles/plate/Displacement=0; -1e-4*t"])
        reference = test.results(RING, [*COARSE_RING, "Obstacles/plate/Displacement=0; -1e-4*t"])
        a, b = force_of(results), force_of(reference)
        test.check(abs(a / b - 1) <= 1e-2, f"{a:.8g} instead of {b:.8g}")
        large = force_of(test.results(RING, sets))
        test.check(0.2 < 2 * large < 0.7, f"squeezed by a quarter: {2 * large:.6g}")
    return body


def stability(test):
    """Half of a block loses the definiteness of its tangent at a stretch of 0.510, by linear algebra of its modes; the homogeneous
    solution goes on."""
    scene = SCENES / "finite-block.prm"
    for stretch, force, stable in ((0.6, 0.7146352056, True), (0.53, None, True), (0.49, None, False), (0.4, 1.66828436, False)):
        results = test.results(scene, [f"Obstacles/plate/Displacement=0; {stretch - 1}*t", "Load steps/Number=3",
                                       "Bodies/block/Subdivisions=8,8"])
        found = force_of(results, "top")
        test.check(force is None or abs(found / force - 1) <= 1e-7, f"{found:.10g} instead of {force}")
        test.check(results["load_steps"][-1]["definite"] is stable, f"at a stretch of {stretch} 'definite' is {not stable}")
        warned = any(check["check"] == "definiteness" and check["outcome"] == "warned" for check in results["verdict"]["checks"])
        test.check(warned is not stable, f"at a stretch of {stretch} the verdict says the contrary")
    # What cannot be compressed wrinkles from a stretch of 0.5437 on (Biot, Mechanics of Incremental Deformations, 1965).
    for stretch, stable in ((0.6, True), (0.56, True), (0.53, False)):
        results = test.results(scene, [f"Obstacles/plate/Displacement=0; {stretch - 1}*t", "Bodies/block/Poisson's ratio=0.5",
                                       "Bodies/block/Subdivisions=8,8", "Load steps/Number=3"])
        test.check(results["load_steps"][-1]["definite"] is stable, f"mixed, at a stretch of {stretch} 'definite' is {not stable}")


ARCH = """
set Dimension   = 2
set Deformation = finite
subsection Bodies
  set Names = arch
  subsection arch
    set Mesh = box
    set Corners = -10,0 : 10,0.5
    set Subdivisions = 30,2
    set Transformation = x; y + 1.5*(1-x^2/100)
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
  end
end
subsection Obstacles
  set Names = roller
  subsection roller
    set Shape = sphere
    set Center = 0,4
    set Radius = 2
    set Force = 0; -F*t
    set Displacement = 0; free
  end
end
subsection Supports
  set Names = ends
  subsection ends
    set Boundaries = arch.left, arch.right
    set Displacement = 0; 0
  end
end
subsection Contact pairs
  set Names = top
  subsection top
    set Slave = arch.top
    set Master = roller
  end
end
subsection Mesh
  set Degree = 2
end
subsection Load steps
  set Number = {number}
  set Cut-backs = {cuts}
end
"""


def snap_through(test):
    """A shallow arch under a force: where it snaps through is said, and so it is if cut-backs end before the other side is found."""
    def scene(force, number, cuts=8):
        text = ARCH.format(number=number, cuts=cuts).replace("F*t", f"{force}*t")
        return write(test, f"arch-{force}-{number}-{cuts}.prm", text)

    def warnings(results):
        return {check["check"]: check["time"] for check in results["verdict"]["checks"] if check["outcome"] == "warned"}

    held = test.results(scene(0.3, 5))
    test.check(not warnings(held).keys() & {"jump", "definiteness"}, f"warned below the load: {warnings(held)}")
    snapped = test.results(scene(2.5, 10))
    moved = [step["obstacles"]["roller"]["displacement"][1] for step in snapped["load_steps"]]
    far = max(range(1, len(moved)), key=lambda i: moved[i - 1] - moved[i])
    time = snapped["load_steps"][far]["time"]
    test.print(f"at a force of {2.5 * time:g} from {moved[far - 1]:.4g} to {moved[far]:.4g}")
    test.check(warnings(snapped).get("jump") == time, f"it jumps at t = {time}, warned of {warnings(snapped)}")
    run = test.run(scene(2.5, 30, 0))
    test.check(run.code == 3 and "the last load that was solved is that of t = 0.1" in run.err + run.out and
               "snap through" in run.err + run.out, f"exit code {run.code}: {run.err[-500:]}")


WALL = """
set Dimension   = 2
set Deformation = finite
subsection Bodies
  set Names = ring
  subsection ring
    set Mesh = ring
    set Inner radius = 0.8
    set Outer radius = 1
    set Part = lower half
    set Cells around = 40
    set Cells through = 3
    set Young's modulus = 1
    set Poisson's ratio = 0.3
  end
end
subsection Obstacles
  set Names = roller
  subsection roller
    set Shape = sphere
    set Center = 0,-1.4
    set Radius = 0.3
    set Displacement = 0; 0.7*t
  end
end
subsection Supports
  set Names = ends
  subsection ends
    set Boundaries = ring.symmetry_y
    set Displacement = 0; 0
  end
end
subsection Contact pairs
  set Names = contact
  subsection contact
    set Slave = ring.outer
    set Master = roller
  end
end
"""


def thin_wall(test):
    """A roller that would be on the other side of a wall after one load step does not get there."""
    scene = write(test, "wall.prm", WALL)
    many, auto = (test.results(scene, [f"Load steps/Number={n}"]) for n in (10, "automatic"))
    a, b = force_of(many), force_of(auto)
    test.print(f"{a:.10g} in 10 load steps, {b:.10g} in {len(auto['load_steps'])} of their own")
    test.check(a > 0 and abs(b / a - 1) <= 1e-8, f"{a:.10g} in 10 load steps, {b:.10g} in {len(auto['load_steps'])}")
    run = test.run(scene, ["Load steps/Number=1", "Load steps/Cut-backs=0"])
    test.check(run.code == 3 and "would go through 'ring.outer' in one load step" in run.out + run.err, f"exit code {run.code}")


def operators(test):
    """Tangents without a matrix: the same forces, in no more iterations than with one, on refined meshes and of degree two."""
    for sets in (["Mesh/Degree=1", "Mesh/Zones/Names=edges", "Mesh/Zones/edges/Where=0.2 - abs(z - 0.5)"], ["Mesh/Degree=2"]):
        small = ["Bodies/lower/Subdivisions=6,6,3", "Bodies/upper/Subdivisions=4,4,4"] + sets
        results = [test.results(PUNCH, small + [f"Solver/Operator={form}"], 2) for form in ("assembled", "matrix-free")]
        (a, b), cycles = ([force_of(r, "joint") for r in results], [r["load_steps"][-1]["multigrid_cycles"] for r in results])
        test.print(f"{sets[0]}: force {a:.10g} and {b:.10g}, cycles {cycles[0]} and {cycles[1]}")
        test.check(results[1]["preflight"]["operator"] == "matrix-free", "there was a matrix")
        test.check(abs(b / a - 1) <= 1e-8, f"the force is {b:.12g} instead of {a:.12g}")
        test.check(cycles[1] <= 1.2 * cycles[0], f"{cycles[1]} instead of {cycles[0]} cycles")


LED = """
set Dimension = 2
set Model = plane strain
set Deformation = finite
subsection Bodies
 set Names = block
 subsection block
  set Mesh = box
  set Corners = 0,0 : 1,1
  set Subdivisions = 4,4
  set Young's modulus = 1
  set Poisson's ratio = 0.3
 end
end
subsection Obstacles
 set Names = floor
 subsection floor
  set Shape = plane
  set Point = 0,-0.2
  set Normal = 0,1
 end
end
subsection Supports
 set Names = top
 subsection top
  set Boundaries = block.top
  set Displacement = 0; -0.3*t
 end
end
subsection Contact pairs
 set Names = p
 subsection p
  set Slave = block.bottom
  set Master = floor
 end
end
"""


def led_without_force(test):
    """Bodies that are led about meet no force at first, or at last: no reason not to solve that."""
    scene = write(test, "led.prm", LED)
    for sets in ([], ["Mesh/Degree=2"], ["Bodies/block/Young's modulus=2e5"], ["Contact method/Method=penalty"]):
        one, many = (force_of(test.results(scene, [*sets, f"Load steps/Number={n}"]), "p") for n in (1, 3))
        test.check(one > 0.1 and abs(many / one - 1) <= 1e-8, f"{sets}: {one:.10g} in one load step, {many:.10g} in three")
    away = force_of(test.results(scene, ["Supports/top/Displacement=0; -1.2*t*(1-t)", "Load steps/Number=4"]), "p")
    test.check(abs(away) <= 1e-12, f"a force of {away:.3g} is left")


BEAM = """
set Dimension = 2
set Deformation = finite
subsection Bodies
  set Names = beam
  subsection beam
    set Mesh = box
    set Corners = 0,0 : 2,0.3
    set Subdivisions = 24,5
    set Young's modulus = 1
    set Poisson's ratio = 0.3
  end
end
subsection Obstacles
  set Names = roller
  subsection roller
    set Shape = cylinder
    set Center = 1.8, 0.5
    set Radius = 0.2
    set Displacement = 0; -0.2*t
  end
end
subsection Supports
  set Names = root
  subsection root
    set Boundaries = beam.left
    set Displacement = 0; 0
  end
end
subsection Contact pairs
  set Names = contact
  subsection contact
    set Slave = beam.top
    set Master = roller
  end
end
"""


def to_the_middle(test):
    """A roller that comes with its middle to a surface in one load step, from where that sees nothing of it."""
    scene = write(test, "beam.prm", BEAM)
    many, one = (force_of(test.results(scene, [f"Load steps/Number={n}"])) for n in (20, 1))
    test.print(f"{many:.10g} in 20 load steps, {one:.10g} in one that is cut")
    test.check(many > 1e-4 and abs(one / many - 1) <= 1e-8, f"{many:.10g} in 20 load steps, {one:.10g} in one")


SLENDER = [
    "Bodies/beam/Corners=0,0 : 2,0.05",
    "Bodies/beam/Subdivisions=80,4",
    "Obstacles/roller/Center=1.8, 0.25",
    "Obstacles/roller/Displacement=0; -0.4*t",
]


def slender(test):
    """What turns stretches as well: full steps of Newton's method lead far off, and need load steps without number."""
    scene = write(test, "beam.prm", BEAM)
    forces = {}
    for method, nu, n, most in (
        ("penalty", 0.3, 1, 120),
        ("penalty", 0.3, 5, 70),
        ("Lagrange multiplier", 0.3, 1, 70),
        ("Lagrange multiplier", 0.3, 5, 70),
        ("Lagrange multiplier", 0.49, 5, 100),
    ):
        sets = SLENDER + [f"Contact method/Method={method}", f"Bodies/beam/Poisson's ratio={nu}", f"Load steps/Number={n}"]
        results = test.results(scene, sets)
        steps = sum(step["newton_iterations"] for step in results["load_steps"])
        force = force_of(results)
        test.print(f"{method}, nu = {nu}, {n} load steps: force {force:.10g}, {steps} Newton steps")
        test.check(steps <= most, f"{steps} Newton steps, at most {most}")
        # The tolerance of Newton's method, 1e-10, of forces that are (length / thickness)^2 as large as those of bending.
        test.check(abs(forces.setdefault((method, nu), force) / force - 1) <= 2e-7, "the same force in all numbers of load steps")


PRESSED = """
set Dimension = 2
set Deformation = finite
subsection Bodies
  set Names = block
  subsection block
    set Mesh = box
    set Corners = -{width},0 : {width},1
    set Subdivisions = {cells},10
    set Young's modulus = 1
    set Poisson's ratio = 0.3
  end
end
subsection Obstacles
  set Names = tip
  subsection tip
    {shape}
    set Displacement = 0; -{depth}*t
  end
end
subsection Supports
  set Names = held
  subsection held
    set Boundaries = {held}
    set Displacement = 0; 0
  end
end
subsection Contact pairs
  set Names = contact
  subsection contact
    set Slave = block.top
    set Master = tip
  end
end
"""


def cylinder(center, radius):
    return f"set Shape = cylinder\nset Center = {center}\nset Radius = {radius}"


def gap_function(gap):
    return f"set Shape = gap function\nset Normal = 0, -1\nset Gap = {gap}"


def obstacle_inside(test):
    """A small obstacle gets into a body between the points of its surface, where contact finds nothing of it; or a part of an obstacle
    does while another part has pressure."""
    def scene(name, **keys):
        return write(test, f"{name}.prm", PRESSED.format(**dict(dict(width=1, cells=20, depth=0.5, held="block.left, block.right"), **keys)))

    roller = scene("roller", shape=cylinder("0.03, 1.1", 0.1))
    found = force_of(test.results(roller, ["Load steps/Number=5"]))
    fine = force_of(test.results(roller, ["Load steps/Number=5", "Bodies/block/Subdivisions=40,20"]))
    test.print(f"a roller as wide as two faces: {found:.6g}, {fine:.6g} on finer faces")
    test.check(abs(found / fine - 1) <= 0.01, f"{found:.6g} and {fine:.6g}")
    lobes = gap_function("1.01 - y + min(100*(x + 1.02)^2, (x - 1)^2)")
    for name, keys in (("pin", dict(shape=cylinder("0.03, 1.02", 0.02))),
                       ("lobes", dict(shape=lobes, width=2, cells=40, depth=0.4, held="block.bottom"))):
        run = test.run(scene(name, **keys), ["Load steps/Cut-backs=2"])
        test.check(run.code == 3 and "has got through the obstacle 'tip'" in run.out, f"{name}: exit code {run.code}: {run.out[-500:]}")
    # The formula of a gap says little far from where it is zero, but it knows on which side.
    steep = test.results(scene("steep", shape=gap_function("1 - y + 20*(x - 1)^2"), width=2, cells=48, depth=0.3, held="block.bottom"))
    test.check(not unseen(steep), f"a surface that is not in the obstacle at all is warned of: {unseen(steep)}")


THROUGH = """
set Dimension = 2
set Deformation = finite
subsection Bodies
 set Names = lower, upper
 subsection lower
  set Mesh = box
  set Corners = 0,0 : 3,1
  set Subdivisions = 24,8
  set Young's modulus = 1000
  set Poisson's ratio = 0.3
 end
 subsection upper
  set Mesh = box
  set Corners = 1.03,1.3 : 1.97,2.3
  set Subdivisions = 8,8
  set Young's modulus = 1000
  set Poisson's ratio = 0.3
 end
end
subsection Obstacles
 set Names = floor
 subsection floor
  set Shape = plane
  set Point = 0,0
  set Normal = 0,1
 end
end
subsection Supports
 set Names = side, top
 subsection side
  set Type = symmetry
  set Boundaries = lower.left
 end
 subsection top
  set Boundaries = upper.top
  set Displacement = 0; -0.9*t
 end
end
subsection Loads
 set Names = w
 subsection w
  set Bodies = lower
  set Body force = 0; -1
 end
end
subsection Contact pairs
 set Names = foot
 subsection foot
  set Slave = lower.bottom
  set Master = floor
 end
end
"""


def passed_through(test):
    """Flat faces that have gone through each other by more than half a cell, so that no surface is near."""
    scene = write(test, "through.prm", THROUGH)
    for depth in (0.06, 0.15, 0.6):
        for ranks in (1, 2):
            found = unseen(test.results(scene, [f"Supports/top/Displacement=0; -{0.3 + depth}*t"], ranks))
            test.check("'upper." in found, f"by {depth}, {ranks} ranks: {found or 'nothing'}")
    found = unseen(test.results(scene, ["Supports/top/Displacement=0; -0.2*t"]))
    test.check(not found, found)


def yeoh_volume(test):
    """The same law, mixed or not: squeezed between walls, by what Poisson's ratio is at the border of the two."""
    text = (SCENES / "finite-block.prm").read_text().replace("set Young's modulus = 1\n", "set Law = Yeoh\n")
    scene = write(test, "yeoh.prm", text)
    forces = [force_of(test.results(scene, ["Bodies/block/Coefficients=0.2, -0.01, 0.002", f"Bodies/block/Formulation={form}",
                                            "Bodies/block/Poisson's ratio=0.3", "Mesh/Degree=2"]), "top")
              for form in ("displacement", "mixed")]
    test.check(abs(forces[1] / forces[0] - 1) <= 1e-6, f"{forces[0]:.10g} and {forces[1]:.10g} mixed")


def cases():
    yield Case("finite", "led", led_without_force)
    yield Case("finite", "to the middle", to_the_middle)
    yield Case("finite", "slender", slender)
    yield Case("finite", "obstacle inside", obstacle_inside)
    yield Case("finite", "passed through", passed_through, ranks=2)
    yield Case("finite", "Yeoh's volume", yeoh_volume)
    yield Case("finite", "operators", operators, ranks=2)
    yield Case("finite", "thin wall", thin_wall)
    yield Case("finite", "snap-through", snap_through)
    yield Case("finite", "stability", stability)
    yield Case("finite", "steps/o-ring", same_in_steps(RING, COARSE_RING, 1e-8, (1, 2, 5), 23))
    yield Case("finite", "steps/half cylinder", same_in_steps(CYLINDER, COARSE_CYLINDER, 1e-8, (1, 2, 5), 36))
    yield Case("finite", "steps/punch", same_in_steps(PUNCH, [], 1e-8, (1, 2, 5), 20, "joint"))
    yield Case("finite", "second order", second_order)
    yield Case("finite", "first touch", first_touch)
    yield Case("finite", "fold", fold)
    yield Case("finite", "slits", slits)
    yield Case("finite", "unseen contact", unseen_contact, ranks=2)
    yield Case("finite", "moved", moved)
    yield Case("finite", "steps/automatic", automatic_steps)
    yield Case("finite", "automatic", automatic_deformation)
    yield Case("finite", "contrast", contrast)
    yield Case("finite", "penalties", penalties)
    yield Case("finite", "meshes", meshes)
    yield Case("finite", "compressed", compressed)
    yield Case("finite", "refined", refined, ranks=2)
    for model in ("plane strain", "plane stress", "axisymmetric"):
        yield Case("finite", f"limit/{model}", linear_limit(model))
    yield Case("finite", "units", units)
    mu = 1 / (2 * 1.49)  # of E = 1, nu = 0.49
    yield Case("finite", "law/Hencky", law("Hencky"))
    yield Case("finite", "law/Saint Venant-Kirchhoff", law("Saint Venant-Kirchhoff"))
    yield Case("finite", "law/Mooney-Rivlin", law("Mooney-Rivlin", f"Bodies/ring/Coefficients={0.4 * mu:.12g}, {0.1 * mu:.12g}"))
    yield Case("finite", "law/Yeoh", law("Yeoh", f"Bodies/ring/Coefficients={0.5 * mu:.12g}, {0.01 * mu:.12g}, 0"))
    yield Case("finite", "law/Ogden", law("Ogden", f"Bodies/ring/Coefficients={0.8 * mu:.12g}, 2, {-0.2 * mu:.12g}, -2"))
