# SPDX-License-Identifier: Apache-2.0
"""Nearly and fully incompressible bodies, whose bulk stress is a field of its own: orders, patch tests and iterations do not
know Poisson's ratio; bodies of both formulations meet; what the program refuses."""

import csv
import itertools
from pathlib import Path

from case import SCENES, Case, method, short

import tetrahedra
import triangles
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


# Two layers of one body, whose sides do not move: both have the stress s in y, and the bulk stress s lambda/(lambda + 2 mu) jumps.
LAYERS = """set Dimension = 2
subsection Bodies
  set Names = body
  subsection body
    set Mesh            = file
    set File            = layers.inp
    set Cells           = as in file
    set Young's modulus = 1
    set Poisson's ratio = 0.49
    subsection Materials
      set Names = upper
      subsection upper
        set Cells           = UPPER
        set Young's modulus = 100
        set Poisson's ratio = 0.48
      end
    end
  end
end
subsection Supports
  set Names = base, sides
  subsection base
    set Boundaries   = body.bottom
    set Displacement = free; 0
  end
  subsection sides
    set Boundaries   = body.left, body.right
    set Displacement = 0; free
  end
end
subsection Loads
  set Names = lid
  subsection lid
    set Boundaries = body.top
    set Traction   = 0; -0.01
  end
end
subsection Output
  subsection Probes
    set Names = below, above
    subsection below
      set Body  = body
      set Point = 0.3, 0.49
    end
    subsection above
      set Body  = body
      set Point = 0.3, 0.51
    end
  end
end
"""


def layers(test):
    """Bulk stresses of triangles jump between materials of one body, and are exact where they are uniform in each."""
    grid = triangles.Grid(2, 2, lambda x, y: (x, y))
    test.write("layers.inp", grid.text() + "*ELSET, ELSET=UPPER\n5, 6, 7, 8\n")
    probes = test.results(test.write("layers.prm", LAYERS), [], 2)["load_steps"][-1]["probes"]
    for name, ratio in (("below", 0.49), ("above", 0.48)):
        wanted = -0.01 * ratio / (1 - ratio)
        found = probes[name]["stress"]["xx"]
        test.check(abs(found / wanted - 1) <= 1e-9, f"{name}: {found:.12g} instead of {wanted:.12g}")


CAVITY = """set Dimension = 3
subsection Bodies
  set Names = body
  subsection body
    set Mesh            = file
    set File            = cavity.inp
    set Young's modulus = 1
    set Poisson's ratio = 0.5
  end
end
subsection Supports
  set Names = walls
  subsection walls
    set Boundaries   = body.bottom, body.left, body.right, body.front, body.back
    set Displacement = 0; 0; 0
  end
end
subsection Loads
  set Names = lid
  subsection lid
    set Boundaries = body.top
    set Traction   = 0; 0; -0.01
  end
end
subsection Output
  subsection Probes
    set Names = corner, rim, middle
    subsection corner
      set Body  = body
      set Point = 0.01, 0.01, 0.01*HEIGHT
    end
    subsection rim
      set Body  = body
      set Point = 0.03, 0.03, 0.97*HEIGHT
    end
    subsection middle
      set Body  = body
      set Point = 0.5, 0.5, 0.5*HEIGHT
    end
  end
end
"""


class Fives(tetrahedra.Grid):
    """Five tetrahedra in each cell, mirrored in turn: that of a corner touches the surface with three faces."""

    def corners_of_cells(self):
        for cell in itertools.product(*map(range, self.n)):
            flip = sum(cell) % 2
            for four in ("100 010 001 111", "000 100 010 001", "110 010 100 111", "101 001 111 100", "011 111 001 010"):
                corners = [tuple(2 * (c + ((int(x) + flip) % 2 if d == 0 else int(x))) for d, (c, x) in enumerate(zip(cell, one)))
                           for one in four.split()]
                yield corners if not flip else [corners[1], corners[0], *corners[2:]]


def held(test):
    """Water in a cavity: one pressure, also in cells that have few nodes that are not held, or none. In flat cavities of rubber the
    stress in corners is lower; hexahedra have -0.0085 in the last one."""
    for i, (n, height, ratio, most) in enumerate((((2, 2, 2), 1, 0.5, 1e-4), ((2, 2, 2), 1, 0.4999999, 1e-4), ((1, 1, 1), 1, 0.5, 1e-4),
                                                  ((3, 3, 2), 0.001, 0.5, 1e-4), ((3, 3, 2), 0.1, 0.49, 0.3))):
        test.write(f"cavity-{i}.inp", Fives(n, lambda x, y, z, height=height: (x, y, height * z)).text())
        scene = test.write(f"cavity-{i}.prm", CAVITY.replace("cavity.inp", f"cavity-{i}.inp").replace("HEIGHT", str(height)))
        probes = test.results(scene, [f"Bodies/body/Poisson's ratio={ratio}"])["load_steps"][-1]["probes"]
        for name in ("corner", "rim", "middle"):
            found = probes[name]["stress"]["zz"]
            test.check(abs(found / -0.01 - 1) <= most, f"{n}, {height}, {ratio}, {name}: {found:.9g} instead of -0.01")


def simplices():
    """Taylor and Hood's triangles and tetrahedra: the orders of quadrilaterals, patch tests, temperature, finite strain."""
    for ratio in (0.3, 0.5):
        for quantity, least in (("energy", 1.9), ("volumetric_stress", 1.9), ("displacement", 2.8), ("pressure", 1.4)):
            yield Case("mixed/triangles", f"nu={ratio}/{quantity}", labels={"full"}, body=triangles.converges(
                triangles.finer(SMOOTH, 2), (2, 4, 8), f"errors/{quantity}", least,
                sets=[f"Definitions/nu={ratio}", *method("Lagrange multiplier")]))
    for kind, patch in (("triangles", triangles.patch), ("tetrahedra", tetrahedra.patch)):
        for i, (order, one, bodies) in enumerate(((1, "Lagrange multiplier", None), (2, "augmented Lagrangian", ["lower"]),
                                                  (2, "Nitsche", ["upper"]), (2, "Nitsche", None))):
            yield Case("mixed/simplices", f"{kind}-{order}/{short(one)}/{'-'.join(bodies or ['all'])}",
                       patch(order, bodies, [*method(one), *mixed("lower", "upper")], 1 + i % 2), 1 + i % 2)
    for with_simplices, scene, *bodies in ((triangles.with_triangles, "thermal-patch-2d", "lower", "upper"),
                                           (triangles.with_triangles, "thermal-rings-axisymmetric", "inner", "outer"),
                                           (tetrahedra.with_tetrahedra, "thermal-finite", "block")):
        yield Case("mixed/simplices", scene, triangles.same_expected(
            lambda test, make=with_simplices, scene=scene: make(test, SCENES / f"{scene}.prm", 2), 2, mixed(*bodies)), 2)
    yield Case("mixed/simplices", "layers", layers, 2)
    yield Case("mixed/simplices", "held", held)


def cases():
    yield from orders()
    yield from simplices()
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
