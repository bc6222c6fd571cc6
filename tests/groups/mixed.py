# SPDX-License-Identifier: Apache-2.0
"""Nearly and fully incompressible bodies, whose bulk stress is a field of its own: orders, patch tests and iterations do not
know Poisson's ratio; bodies of both formulations meet; what the program refuses."""

import csv
from pathlib import Path

from case import SCENES, Case, method, short

from convergence import converges
from patch import EXACT, uniform

RATIOS = (0.3, 0.49, 0.4999, 0.5)
SMOOTH, HERTZ, RING = "incompressible-smooth", SCENES / "hertz-half-space.prm", SCENES / "finite-o-ring.prm"


def mixed(*bodies):
    return [line for body in bodies for line in (f"Bodies/{body}/Formulation=mixed", f"Bodies/{body}/Degree=2")]


def orders():
    """Second order of stress and bulk stress, third of the displacement, whatever nu is."""
    for ratio in RATIOS:
        for quantity, least in (("energy", 1.9), ("volumetric_stress", 1.9), ("displacement", 2.8), ("pressure", 1.4)):
            yield Case("mixed/orders", f"nu={ratio}/{quantity}", labels={"full"}, body=converges(
                SMOOTH, range(1, 5), f"errors/{quantity}", least, sets=[f"Definitions/nu={ratio}"]))


def hertz(ratio):
    """The peak pressure of Hertz' theory to 0.2 %, and pressures that fall from there to the rim without a wave."""
    def body(test):
        results = test.results(HERTZ, [f"Definitions/nu={ratio}", "Mesh/Degree=2", "Mesh/Refinements=1", *method("Lagrange multiplier")])
        radius = (3 * 1000 * 300 * (1 - ratio**2) / (4 * 200000)) ** (1 / 3)
        peak = 3 * 1000 / (2 * 3.141592653589793 * radius**2)
        found = results["load_steps"][-1]["pairs"]["contact"]
        test.check(abs(found["max_pressure"] / peak - 1) <= 2e-3, f"the peak is {found['max_pressure']:.6g} instead of {peak:.6g}")
        test.check(abs(found["force"][1] / -1000 - 1) <= 1e-3, f"the force is {found['force'][1]:.6g} instead of -1000")
        with open(Path(results["output_directory"]) / "profiles" / "contact.csv") as file:
            rows = sorted((float(row["x"]), float(row["pressure"])) for row in csv.DictReader(file))
        wave = max((after - before for (_, before), (_, after) in zip(rows, rows[1:])), default=0) / peak
        test.print(f"peak {found['max_pressure']:.6g}, {peak:.6g} by theory; rises by {wave:.1e} of it on the way out")
        test.check(wave <= 5e-3, f"the pressure rises by {wave:.1e} of the peak on the way to the rim")
    return body


def iterations(scene, sets, most):
    """Of the linear solves, from 0.49 to 0.5, within ten per cent."""
    def body(test):
        counts = {}
        for ratio in (0.49, 0.499, 0.4999, 0.49999, 0.5):
            results = test.results(SCENES / f"{scene}.prm", [*sets, f"Definitions/nu={ratio}"])
            counts[ratio] = max(results["load_steps"][-1]["krylov_iterations"])
        test.print(", ".join(f"{ratio}: {count}" for ratio, count in counts.items()))
        low, high = min(counts.values()), max(counts.values())
        test.check(high <= 1.1 * low + 1, f"from {low} to {high} iterations")
        test.check(high <= most, f"{high} iterations, at most {most} are expected")
    return body


def thermal(scene, *bodies):
    """What scenes expect of displacements they expect of mixed bodies too: with thermal strain."""
    def body(test):
        test.results(SCENES / f"{scene}.prm", mixed(*bodies), ranks=2, missed=False)
    return body


def steps(test):
    """Rubber squeezed by a quarter: the same in one load step and in three, and what two other programs agree on."""
    forces = [test.results(RING, ["Mesh/Degree=2", f"Load steps/Number={n}"])["load_steps"][-1]["pairs"]["contact"]["normal_force"]
              for n in (1, 3)]
    test.print(f"{forces[0]:.12g} in one step, {forces[1]:.12g} in three")
    test.check(abs(forces[1] / forces[0] - 1) <= 1e-7, "the number of load steps matters")
    test.check(abs(2 * forces[0] / 0.43515 - 1) <= 5e-4, f"the force is {2 * forces[0]:.6g} instead of 0.43515")


def same_law(test):
    """Far from the limit both formulations converge to the same: of a curved contact, within what meshes leave."""
    sets = ["Definitions/nu=0.3", "Mesh/Degree=2", "Mesh/Refinements=1"]
    a, b = (test.results(HERTZ, sets + [f"Bodies/block/Formulation={word}"])["load_steps"][-1]["pairs"]["contact"]["force"][1]
            for word in ("displacement", "mixed"))
    test.check(abs(b / a - 1) <= 2e-4, f"{b:.8g} mixed, {a:.8g} by displacements")


def patches():
    for scene, pressure in EXACT.items():
        for bodies in (("lower",), ("upper",), ("lower", "upper")):
            for one in ("Lagrange multiplier", "augmented Lagrangian", "Nitsche"):
                yield Case("mixed/patch", f"{scene}/{'+'.join(bodies)}/{short(one)}",
                           uniform(scene, [*method(one), *mixed(*bodies)], pressure, ranks=2 if len(bodies) == 2 else 1))


def cases():
    yield from orders()
    yield from patches()
    for ratio in (0.4999, 0.5):
        yield Case("mixed/hertz", f"nu={ratio}", hertz(ratio))
    for one in ("Lagrange multiplier", "penalty", "Nitsche"):
        yield Case("mixed/iterations", short(one),
                   iterations("hertz-half-space", ["Mesh/Degree=2", "Bodies/block/Formulation=mixed", *method(one)], 45), labels={"full"})
    yield Case("mixed/limits", "same-law", same_law)
    yield Case("mixed/limits", "steps", steps)
    for scene, *bodies in (("thermal-patch-2d", "lower", "upper"), ("thermal-lift", "block"), ("thermal-rings-axisymmetric", "inner", "outer")):
        yield Case("mixed/thermal", scene, thermal(scene, *bodies), ranks=2)
