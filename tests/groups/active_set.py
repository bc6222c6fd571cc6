# SPDX-License-Identifier: Apache-2.0
"""The active set is found in a few Newton steps by every method, from a cold start and when contact closes and opens."""

import math

from case import SCENES, VARIED, Case, force_of, method

MOST = 10

METHODS = {
    "multiplier": method("Lagrange multiplier"),
    "multiplier-standard": method("Lagrange multiplier") + ["Contact method/Pressure basis=standard"],
    "augmented": method("augmented Lagrangian"),
    "augmented-newton": method("augmented Lagrangian", Scheme="Newton"),
    "perturbed": method("perturbed Lagrangian"),
    "perturbed-condensed": method("perturbed Lagrangian", System="condensed"),
    "penalty": method("penalty"),
    "penalty-1e6": method("penalty", Factor="1e6"),
    "penalty-pointwise": method("penalty", Weighting="pointwise", Factor=10),
    "elimination": method("direct elimination"),
    "nitsche-theta=1": method("Nitsche", Theta=1),
    "nitsche-theta=0": method("Nitsche", Theta=0),
    "nitsche-theta=-1": method("Nitsche", Theta=-1),
    "nitsche-unbiased": method("Nitsche", Unbiased="yes"),
}

# Of the cells alone, where no force is what is expected.
REST = ["Expected results/force/Value=1 + f", "Expected results/force/Reference=1"]


def newton_steps(step):
    """From one solution to the next; of methods that augment, those of each augmentation."""
    before = step["newton_iterations_before_augmentations"]
    return [*before, step["newton_iterations"] - sum(before)]


def check_mirrored(test, steps):
    """The second half of the load steps goes back the way of the first: steps 1 ... n-1 of 2n stand for the same states
    as 2n-1 ... n+1, and without friction the forces must be the same."""
    forces = [[pair["force"] for pair in step["pairs"].values()] for step in steps]
    half = len(steps) // 2
    largest = max(math.hypot(*force) for force in forces[half - 1])
    for k in range(half - 1):
        for up, down in zip(forces[k], forces[2 * half - 2 - k]):
            test.check(math.dist(up, down) <= 1e-7 * largest, f"forces on the way there and back differ: {up}, {down}")


def found_soon(scene, sets, most=MOST, mirrored=False):
    def body(test):
        steps = test.results(SCENES / f"{scene}.prm", sets)["load_steps"]
        for step in steps:
            counts = newton_steps(step)
            test.print(f"t = {step['time']:<8g} {step['active_points']:6} active points, Newton steps: "
                       + " + ".join(map(str, counts)))
            test.check(max(counts) <= most, f"more than {most} Newton steps: {counts}")
        if mirrored:
            check_mirrored(test, steps)
    return body


def settles(scene, sets, force):
    """Sets that come out wrong of rough linear solves come to rest by finer ones, whatever the bodies are like."""
    def body(test):
        found = force_of(test.results(VARIED / f"{scene}.prm", sets))
        test.check(abs(found / force - 1) <= 2e-4, f"{found:.8g} instead of {force:.8g}")
    return body


def back_to_touching(sets):
    """Blocks that overlap less and less, until they touch and nothing is left of the force."""
    def body(test):
        history = ["Contact pairs/joint/Interference ramp=1-t", "Load steps/Number=2"]
        results = test.results(VARIED / "small-overlap.prm", [*sets, *history])
        first, *_, last = (step["pairs"]["joint"]["max_pressure"] for step in results["load_steps"])
        test.check(abs(first * 4000 - 1) <= 1e-3, f"{first:.6g} instead of 2.5e-4")
        test.check(abs(last) <= 1e-11, f"{last:.6g} where the blocks only touch")
        test.check(results["verdict"]["outcome"] == "passed", f"the verdict is {results['verdict']['outcome']}")
    return body


def starts_warm(scene, sets, ranks, most=4):
    """On the last of three meshes, from what the second one knew of the pressure."""
    def body(test):
        results = test.results(SCENES / f"{scene}.prm", sets + ["Accuracy/Refinement cycles=2"], ranks)
        counts = newton_steps(results["load_steps"][0])
        test.print(f"Newton steps: {[cycle['newton_iterations'] for cycle in results['cycles']]}, at last {counts}")
        test.check(max(counts) <= most, f"more than {most} Newton steps: {counts}")
    return body


def cases():
    for name, sets in METHODS.items():
        for ranks in (1, 2):
            yield Case("active-set/warm", f"hertz-2d/{name}/np{ranks}", starts_warm("hertz-2d", sets, ranks), ranks, labels={"full"})
    for name in ("multiplier", "penalty", "penalty-pointwise", "nitsche-theta=1"):
        yield Case("active-set/warm", f"hertz-3d/{name}/np2", starts_warm("hertz-3d", METHODS[name], 2), 2, labels={"full"})
    for scene in ("gap-wall-2d", "tube-clearance", "hertz-2d", "hertz-3d"):
        for name, sets in METHODS.items():
            yield Case("active-set/cold", f"{scene}/{name}", found_soon(scene, sets), labels={"full"})
    for name, sets in METHODS.items():
        history = ["Load steps/Number=20", "Load steps/End time=2"]
        yield Case("active-set/up-and-down", f"hertz-2d/{name}", found_soon("hertz-2d", sets + history, mirrored=True),
                   labels={"full"})
    # Zones whose size nobody knows before: a plate that lifts off, tips pressed in by a force.
    # Without symmetry the sets of Nitsche's method alternate until linear solves have more digits, which are as many as chance has it.
    for name, sets in METHODS.items():
        most = 13 if name in ("nitsche-theta=0", "nitsche-theta=-1") else MOST
        yield Case("active-set/cold", f"receding-plate/{name}", found_soon("receding-plate", sets, most), labels={"full"})
    for scene in ("ellipsoid-force", "cone-force"):
        for name in ("multiplier", "penalty", "nitsche-theta=1"):
            yield Case("active-set/cold", f"{scene}/{name}", found_soon(scene, METHODS[name], most=8), labels={"full"})
    # One cell a body: all is contact zone, and contact alone stops the upper one; without loads, there is nothing to do.
    for scene in ("two-cells", "two-cells-2d"):
        for degree in (1, 2):
            for name, sets in METHODS.items():
                sets = sets + [f"Mesh/Degree={degree}"]
                yield Case("active-set/cells", f"{scene}/degree-{degree}/{name}", found_soon(scene, sets, most=6))
                yield Case("active-set/cells", f"{scene}/degree-{degree}/{name}/no-load",
                           found_soon(scene, [*sets, "Loads/press/Pressure=0", *REST], most=2))
    for name, sets in METHODS.items():
        if name != "penalty-1e6":  # sheets move so far that no digit is left of where they are
            yield Case("active-set/thin", f"two-sheets/{name}", settles("two-sheets", sets, 0.04))
        yield Case("active-set/thin", f"thin-fit/{name}", settles("thin-fit", sets, 37.009))
        if name not in ("elimination", "penalty-pointwise", "penalty-1e6"):  # those that pass the patch test, to the last digits
            for deformation in ("small", "finite"):
                yield Case("active-set/touching", f"{deformation}/{name}", back_to_touching([*sets, f"Deformation={deformation}"]))
    # Where neither gap nor pressure is, rounding alone says which points are active: no reason for more than one step.
    yield Case("active-set/cold", "undecided",
               found_soon("patch-2d", ["Bodies/lower/Poisson's ratio=0", "Bodies/upper/Poisson's ratio=0",
                                       "Supports/press/Displacement=free; 0", "Loads/Names=pull",
                                       "Loads/pull/Boundaries=lower.right", "Loads/pull/Traction=100; 0"], most=1))
