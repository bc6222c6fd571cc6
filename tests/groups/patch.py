# SPDX-License-Identifier: Apache-2.0
"""Patch tests: uniform pressure by contact segments, on meshes that do not match, from either side."""

import csv
from pathlib import Path

from case import SCENES, VARIED, Case, Failed, method, short

EXACT = {"patch-2d": 115.7407407407, "patch-3d": 103.7037037037, "patch-overhang-2d": 10, "patch-overhang-3d": 10}
SWAPPED = ["Contact pairs/interface/Slave=lower.top", "Contact pairs/interface/Master=upper.bottom"]


def uniform(scene, sets, pressure, exact=1e-6, spread=1e-9, penetrates=False, ranks=1):
    """The pressure is the same at all points up to `spread`, relative, and right up to `exact`; the gap is zero, or for
    methods that penetrate the same negative number."""
    def body(test):
        results = test.results(SCENES / f"{scene}.prm", [*sets, "Newton/Tolerance=1e-12"], ranks)
        with open(Path(results["output_directory"]) / "profiles" / "interface.csv") as file:
            rows = list(csv.DictReader(file))
        if not rows:
            raise Failed("the profile has no points")
        p, gap = ([float(row[key]) for row in rows] for key in ("pressure", "gap"))
        mean = sum(p) / len(p)
        varies, error = (max(p) - min(p)) / mean, abs(mean / pressure - 1)
        test.print(f"{len(rows)} points, pressure {mean:.12g}, error {error:.1e}, spread {varies:.1e}, "
                   f"gap from {min(gap):.3e} to {max(gap):.3e}")
        test.check(varies <= spread, f"the pressure varies by {varies:.1e}, more than {spread:g}")
        test.check(error <= exact, f"the pressure is off by {error:.1e}, more than {exact:g}")
        if penetrates:
            test.check(max(gap) < 0 and min(gap) / max(gap) - 1 <= spread, "the penetration is not uniform")
        else:
            test.check(max(map(abs, gap)) <= 1e-10, "the gap is not closed")
    return body


def uniform_ring(degree):
    """Where cells hang on curved edges of larger ones, the cells leave no space: linear displacements are solutions."""
    def body(test):
        strain_x, strain_y, half_shear, modulus, nu = 0.01, -0.003, 0.003, 1, 0.3
        mu, lame = modulus / (2 + 2 * nu), modulus * nu / ((1 + nu) * (1 - 2 * nu))
        volume = lame * (strain_x + strain_y)
        x, y, z, xy = volume + 2 * mu * strain_x, volume + 2 * mu * strain_y, volume, 2 * mu * half_shear
        wanted = (((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2 + 3 * xy ** 2) ** 0.5
        results = test.results(VARIED / "uniform-ring.prm", [f"Mesh/Degree={degree}"])
        found = results["load_steps"][-1]["bodies"]["ring"]["largest"]["von_mises"]["value"]
        test.print(f"largest von Mises stress {found:.12g}, {found / wanted - 1:.1e} off")
        test.check(abs(found / wanted - 1) <= 1e-9, f"{found:.12g} instead of {wanted:.12g}")
    return body


def exact_methods():
    for basis in ("standard", "dual"):
        multiplier = [*method("Lagrange multiplier"), f"Contact method/Pressure basis={basis}"]
        yield f"multiplier-{basis}", multiplier
        yield f"multiplier-{basis}-swapped", multiplier + SWAPPED
    yield "augmented", method("augmented Lagrangian")
    yield "augmented-newton", method("augmented Lagrangian", Scheme="Newton")
    for theta in (1, 0, -1):
        yield f"nitsche-theta={theta}", method("Nitsche", Theta=theta)
    yield "nitsche-swapped", method("Nitsche") + SWAPPED
    yield "nitsche-unbiased", method("Nitsche", Unbiased="yes")


def cases():
    for scene, pressure in EXACT.items():
        for degree in (1, 2):
            for name, sets in exact_methods():
                yield Case("patch/exact", f"{scene}/degree-{degree}/{name}",
                           uniform(scene, sets + [f"Mesh/Degree={degree}"], pressure))
    yield from penalties_and_elimination()
    yield from loaded()
    for degree in (1, 2):
        yield Case("patch/hanging", f"ring/degree-{degree}", uniform_ring(degree))
    # Bodies of different degree.
    for scene, pressure in EXACT.items():
        for i, body in enumerate(("lower", "upper")):
            for j, name in enumerate(("Lagrange multiplier", "augmented Lagrangian", "Nitsche")):
                ranks = 2 if j == (i + len(scene)) % 3 else 1
                yield Case("patch/mixed-degree", f"{scene}/degree-2-{body}/{short(name)}",
                           uniform(scene, method(name) + [f"Bodies/{body}/Degree=2"], pressure, ranks=ranks), ranks)
    # A penalty of 1e8 E/h multiplies the rounding of the gap; the solution is reached up to that.
    for name in ("penalty", "augmented Lagrangian"):
        yield Case("patch/exact", f"patch-3d/factor-1e8/{short(name)}",
                   uniform("patch-3d", method(name, Factor=1e8), EXACT["patch-3d"], spread=1e-6))
    # On distorted faces the error of the rule remains, and falls with its order.
    for points, spread in ((2, 3e-3), (3, 1e-4), (4, 3e-6), (7, 5e-8)):
        yield Case("patch/distorted", f"{points}-points",
                   uniform("patch-3d-distorted", [f"Contact method/Quadrature points={points}"], EXACT["patch-3d"],
                           exact=1e-5, spread=spread))
    yield from solvers()


def penalties_and_elimination():
    """The penalty yields by p/eps: p = p0 / (1 + p0 / (eps 0.01)), eps = 1000 / (h/E + h/E) with the depths h of the cells
    of both sides."""
    for scene, pressure, matching in (("patch-2d", 115.6817661, "4,3"), ("patch-3d", 103.6518778, "4,3,2")):
        for degree in (1, 2):
            for name, sets in (("penalty", method("penalty")), ("perturbed", method("perturbed Lagrangian")),
                               ("perturbed-condensed", method("perturbed Lagrangian", System="condensed"))):
                yield Case("patch/exact", f"{scene}/degree-{degree}/{name}",
                           uniform(scene, sets + [f"Mesh/Degree={degree}"], pressure, exact=2e-8, penetrates=True))
            # Where nodes match, elimination is exact too.
            yield Case("patch/exact", f"{scene}/degree-{degree}/elimination",
                       uniform(scene, method("direct elimination") +
                               [f"Mesh/Degree={degree}", f"Bodies/lower/Subdivisions={matching}",
                                f"Bodies/upper/Subdivisions={matching}"], EXACT[scene]))


def loaded():
    """Loads on the surfaces that touch, which vary in time: with q_u = 20 t^2 on the upper one and q_l = 12 t on the lower one,
    the upper body bears p + q_u, the lower one p + q_l, and together they are as short as without, under p0 in both: with
    heights over moduli l and u, p = p0 - (q_l l + q_u u)/(l + u)."""
    for scene, up, size, pressure in (("patch-2d", "0; ", 10, 97.8472222222), ("patch-3d", "0; 0; ", 100, 85.7777777778)):
        loads = ["Load steps/Number=2", "Loads/Names=on upper, on lower",
                 "Loads/on upper/Boundaries=upper.bottom", "Loads/on upper/Pressure=20*t^2",
                 "Loads/on lower/Boundaries=lower.top", f"Loads/on lower/Traction={up}-8*t",
                 f"Loads/on lower/Total force={up}{-4 * size}*t"]
        for name, sets in exact_methods():
            if "nitsche" in name or name == "multiplier-dual":
                for degree in (1, 2) if scene == "patch-2d" else (1,):
                    yield Case("patch/loaded", f"{scene}/degree-{degree}/{name}",
                               uniform(scene, sets + loads + [f"Mesh/Degree={degree}"], pressure))
    for name in ("Lagrange multiplier", "Nitsche"):
        for ranks in (1, 2):
            yield Case("patch/loaded", f"finite/{short(name)}/ranks-{ranks}", loaded_cubes(name, ranks), ranks)


def loaded_cubes(name, ranks):
    """Cubes of any deformation, force and area as in finite-stack-3d.prm: of the force in them, contact bears what a pressure
    on the surfaces as they are, and a traction on them as they were, leave."""
    def body(test):
        force, pressure = 0.40523042431, 0.33012140865
        sets = [*method(name), "Loads/Names=on upper, on lower", "Loads/on upper/Boundaries=upper.bottom",
                "Loads/on upper/Pressure=0.1*t", "Loads/on upper/Traction=0; 0; 0.05", "Loads/on lower/Boundaries=lower.top",
                "Loads/on lower/Pressure=0.1*t", "Loads/on lower/Traction=0; 0; -0.05"]
        results = test.results(SCENES / "finite-stack-3d.prm", sets, ranks)
        found, wanted = results["load_steps"][-1]["pairs"]["joint"]["force"][2], force - 0.1 * force / pressure - 0.05
        test.print(f"force {found:.10g}, {wanted:.10g} expected")
        test.check(abs(found / wanted - 1) < 1e-6, "the force is wrong")
    return body


def solvers():
    """The saddle point is solved by each of them."""
    def solved(name, *sets):
        return Case("patch/solver", name, uniform("patch-3d", list(sets), EXACT["patch-3d"], ranks=2), ranks=2)

    for one in ("interface multigrid:CG", "interface multigrid:FGMRES", "block diagonal:MINRES", "block diagonal:FGMRES",
                "block triangular:FGMRES", "SIMPLE:FGMRES", "direct:auto"):
        preconditioner, krylov = one.split(":")
        yield solved(one, f"Solver/Preconditioner={preconditioner}", f"Solver/Krylov method={krylov}")
    for one in ("block triangular:diagonal", "block triangular:mass", "block triangular:interface", "block triangular:multigrid",
                "block diagonal:diagonal", "block diagonal:mass", "SIMPLE:diagonal", "SIMPLE:multigrid"):
        preconditioner, schur = one.split(":")
        yield solved(one, f"Solver/Preconditioner={preconditioner}", f"Solver/Schur complement={schur}")
    yield solved("augmented", "Solver/Preconditioner=block triangular", "Solver/Augmentation=1")
