# SPDX-License-Identifier: Apache-2.0
"""Large deformation: what must not depend on how it was reached, nor on how it was computed; and what the program refuses."""

from case import SCENES, VARIED, Case, force_of, method

RING, CYLINDER, PUNCH = (SCENES / f"finite-{name}.prm" for name in ("o-ring", "half-cylinder", "punch"))
HERTZ = SCENES / "hertz-2d.prm"
COARSE_RING = ["Mesh/Degree=1"]
COARSE_CYLINDER = ["Bodies/disc/Refinements=2", "Bodies/block/Subdivisions=12,8"]


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


def held_together(test):
    """A pair that never separates closes its gap in both theories, however little moves: of the support's 0.001 each block has a half."""
    for deformation in ("small", "finite"):
        pressure = test.results(VARIED / "small-overlap.prm", [
            f"Deformation={deformation}", "Bodies/upper/Corners=0,1.01*a : a,2.01*a", "Contact pairs/joint/Separation=none",
            "Contact pairs/joint/Search distance=0.02", "Supports/top/Type=displacement", "Supports/top/Displacement=free; -0.001"])
        pressure = pressure["load_steps"][-1]["pairs"]["joint"]["max_pressure"]
        test.check(abs(2000 * pressure - 1) <= 1e-3, f"{deformation}: a pressure of {pressure:.6g} instead of 5e-4")


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
    test.check(run.code == 2 and "Linear reference = yes: is not available with Deformation = finite" in run.err, "that is not refused by name")


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
                          "Contact pairs/contact/Slave choice=as named"]}
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
        test.check(results["load_steps"][-1]["tangent_positive_definite"] is stable, f"at a stretch of {stretch} 'definite' is {not stable}")
        warned = any(check["check"] == "tangent definiteness" and check["outcome"] == "warned" for check in results["verdict"]["checks"])
        test.check(warned is not stable, f"at a stretch of {stretch} the verdict says the contrary")
    # What cannot be compressed wrinkles from a stretch of 0.5437 on (Biot, Mechanics of Incremental Deformations, 1965).
    for stretch, stable in ((0.6, True), (0.56, True), (0.53, False)):
        results = test.results(scene, [f"Obstacles/plate/Displacement=0; {stretch - 1}*t", "Bodies/block/Poisson's ratio=0.5",
                                       "Bodies/block/Subdivisions=8,8", "Load steps/Number=3"])
        test.check(results["load_steps"][-1]["tangent_positive_definite"] is stable, f"mixed, at a stretch of {stretch} 'definite' is {not stable}")


def snap_through(test):
    """A shallow arch under a force: where it snaps through is said, and so it is if cut-backs end before the other side is found."""
    def run_of(force, number, cuts=8):
        return VARIED / "arch.prm", [f"Obstacles/roller/Force=0; -{force}*t", f"Load steps/Number={number}", f"Load steps/Cut-backs={cuts}"]

    def warnings(results):
        return {check["check"]: check["time"] for check in results["verdict"]["checks"] if check["outcome"] == "warned"}

    held = test.results(*run_of(0.3, 5))
    test.check(not warnings(held).keys() & {"snap-through ratio", "tangent definiteness"}, f"warned below the load: {warnings(held)}")
    snapped = test.results(*run_of(2.5, 10))
    moved = [step["obstacles"]["roller"]["displacement"][1] for step in snapped["load_steps"]]
    far = max(range(1, len(moved)), key=lambda i: moved[i - 1] - moved[i])
    time = snapped["load_steps"][far]["time"]
    test.print(f"at a force of {2.5 * time:g} from {moved[far - 1]:.4g} to {moved[far]:.4g}")
    test.check(warnings(snapped).get("snap-through ratio") == time, f"it jumps at t = {time}, warned of {warnings(snapped)}")
    scene, sets = run_of(2.5, 10, 0)
    run = test.run(scene, [*sets, "Newton/Maximum steps=6"])
    test.check(run.code == 3 and "the last converged load step ends at t = 0.1" in run.err + run.out and
               "snap-through" in run.err + run.out, f"exit code {run.code}: {run.err[-500:]}")


def operators(test):
    """Tangents without a matrix: the same forces, in no more iterations than with one, on refined meshes and of degree two."""
    for sets in (["Mesh/Degree=1", "Mesh/Refinement regions/Names=edges", "Mesh/Refinement regions/edges/Inside=0.2 - abs(z - 0.5)"], ["Mesh/Degree=2"]):
        small = ["Bodies/lower/Subdivisions=6,6,3", "Bodies/upper/Subdivisions=4,4,4"] + sets
        results = [test.results(PUNCH, small + [f"Solver/Operator={form}"], 2) for form in ("assembled", "matrix-free")]
        (a, b), cycles = ([force_of(r, "joint") for r in results], [r["load_steps"][-1]["multigrid_cycles"] for r in results])
        test.print(f"{sets[0]}: force {a:.10g} and {b:.10g}, cycles {cycles[0]} and {cycles[1]}")
        test.check(results[1]["preflight"]["operator"] == "matrix-free", "there was a matrix")
        test.check(abs(b / a - 1) <= 1e-8, f"the force is {b:.12g} instead of {a:.12g}")
        test.check(cycles[1] <= 1.2 * cycles[0], f"{cycles[1]} instead of {cycles[0]} cycles")


SLENDER = [
    "Bodies/beam/Corners=0,0 : 2,0.05",
    "Bodies/beam/Subdivisions=80,4",
    "Obstacles/roller/Center=1.8, 0.25",
    "Obstacles/roller/Displacement=0; -0.4*t",
]


def slender(test):
    """What turns stretches as well: full steps of Newton's method lead far off, and need load steps without number."""
    forces = {}
    for method, nu, n, most in (
        ("penalty", 0.3, 1, 120),
        ("penalty", 0.3, 5, 70),
        ("Lagrange multiplier", 0.3, 1, 70),
        ("Lagrange multiplier", 0.3, 5, 70),
        ("Lagrange multiplier", 0.49, 5, 100),
    ):
        sets = SLENDER + [f"Contact method/Method={method}", f"Bodies/beam/Poisson's ratio={nu}", f"Load steps/Number={n}"]
        results = test.results(VARIED / "beam.prm", sets)
        steps = sum(step["newton_iterations"] for step in results["load_steps"])
        force = force_of(results)
        test.print(f"{method}, nu = {nu}, {n} load steps: force {force:.10g}, {steps} Newton steps")
        test.check(steps <= most, f"{steps} Newton steps, at most {most}")
        # The tolerance of Newton's method, 1e-10, of forces that are (length / thickness)^2 as large as those of bending.
        test.check(abs(forces.setdefault((method, nu), force) / force - 1) <= 2e-7, "the same force in all numbers of load steps")


def yeoh_volume(test):
    """The same law, mixed or not: squeezed between walls, by what Poisson's ratio is at the border of the two."""
    text = (SCENES / "finite-block.prm").read_text().replace("set Young's modulus = 1\n", "set Law = Yeoh\n")
    scene = test.write("yeoh.prm", text)
    forces = [force_of(test.results(scene, ["Bodies/block/Coefficients=0.2, -0.01, 0.002", f"Bodies/block/Formulation={form}",
                                            "Bodies/block/Poisson's ratio=0.3", "Mesh/Degree=2"]), "top")
              for form in ("displacement", "mixed")]
    test.check(abs(forces[1] / forces[0] - 1) <= 1e-6, f"{forces[0]:.10g} and {forces[1]:.10g} mixed")


def turned(scene, sets):
    """A rigid rotation changes nothing but directions, of curved surfaces neither, whose cells are flat between their nodes."""
    def body(test):
        steps = test.results(VARIED / f"{scene}.prm", sets)["load_steps"]
        forces = [step["pairs"]["fit"]["normal_force"] for step in steps]
        test.print(", ".join(f"{force:.12g}" for force in forces))
        test.check(forces[0] > 0, "nothing touches")
        for force in forces:
            test.check(abs(force / forces[0] - 1) <= 1e-8, f"{force:.12g}, before it was turned {forces[0]:.12g}")
    return body


def cases():
    yield Case("finite", "slender", slender)
    yield Case("finite", "Yeoh's volume", yeoh_volume)
    yield Case("finite", "operators", operators, ranks=2)
    yield Case("finite", "snap-through", snap_through)
    yield Case("finite", "stability", stability)
    yield Case("finite", "steps/o-ring", same_in_steps(RING, COARSE_RING, 1e-8, (1, 2, 5), 23))
    yield Case("finite", "steps/half cylinder", same_in_steps(CYLINDER, COARSE_CYLINDER, 1e-8, (1, 2, 5), 36))
    yield Case("finite", "steps/punch", same_in_steps(PUNCH, [], 1e-8, (1, 2, 5), 20, "joint"))
    yield Case("finite", "second order", second_order)
    yield Case("finite", "moved", moved)
    yield Case("finite", "held together", held_together)
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
    by_a_cell = "Load steps/Times=1, 1.0416666666666667"
    exchanged = ["Contact pairs/fit/Slave=o.inner", "Contact pairs/fit/Master=i.outer"]
    # Finer cells within a circle, and in a part: edges hang on circles, and on spheres, of the surface of contact too.
    hangs = ["Mesh/Refinement regions/Names=fine", "Mesh/Refinement regions/fine/Inside=1.1 - sqrt(x^2 + y^2)"]
    hangs_3d = ["Mesh/Refinement regions/Names=fine", "Mesh/Refinement regions/fine/Inside=z + 0.6", "Mesh/Refinement regions/fine/Bodies=o", "Load steps/Times=1, 1.05, 1.3"]
    for name, scene, sets in (
            ("whole", "turned-fit", method("penalty")),
            ("whole, sides exchanged", "turned-fit", [*exchanged, *method("Lagrange multiplier")]),
            ("whole, degree 2", "turned-fit", [by_a_cell, "Mesh/Degree=2", *method("Nitsche")]),
            ("inner ring", "turned-fit", [by_a_cell, "Definitions/share=0", *method("Nitsche")]),
            ("inner ring, sides exchanged", "turned-fit", ["Definitions/share=0", *exchanged, *method("Lagrange multiplier")]),
            ("shells", "turned-fit-3d", method("Lagrange multiplier")),
            ("hanging", "turned-fit", [*hangs, *exchanged, *method("penalty")]),
            ("hanging, degree 2", "turned-fit", [*hangs, *exchanged, by_a_cell, "Mesh/Degree=2", *method("Nitsche")]),
            ("shells, hanging", "turned-fit-3d", [*hangs_3d, *method("Lagrange multiplier")]),
            ("shells, hanging, degree 2", "turned-fit-3d", [*hangs_3d, "Load steps/Times=1, 1.05", "Mesh/Degree=2", *method("penalty")])):
        yield Case("finite", f"turned/{name}", turned(scene, sets), ranks=2 if "shells" in name else 1)
