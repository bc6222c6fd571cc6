# SPDX-License-Identifier: Apache-2.0
"""Scenes with a known answer, for scripts/accuracy."""

import math
import re
import sys
from dataclasses import dataclass, field, replace
from pathlib import Path

import friction_cases
import program

TARGETS = (5e-2, 1e-2, 2e-3)
SCENES = program.ROOT / "tests" / "scenes"
SMALL, FINITE, INCOMPRESSIBLE, SIMPLICES, TIES = "small strain", "finite strain", "incompressible", "simplices", "ties"
FRICTION, GALLERY = "friction", "gallery"
KINDS = (SMALL, FINITE, INCOMPRESSIBLE, SIMPLICES, TIES, FRICTION, GALLERY)


@dataclass
class Case:
    kind: str
    scene: str  # in tests/scenes, or the text of a scene
    keys: dict
    quantities: dict  # reference; with friction {time: reference, or (reference, known_to as a number)}
    known_to: float = 0  # of the references, relative
    targets: tuple = TARGETS  # None: without a target
    grid: callable = None  # of simplices: (keys of a body, order, factor) -> its Grid
    meshes: tuple = ()  # of simplices, in place of targets: (order, factor)
    parabolas: float = 0  # relative difference between circles and edges of second order, with factor 1: of the order h^4


# ---------------------------------------------------------------- closed forms

@dataclass
class Lame:
    """A ring in plane strain, small strain: s_r = a - b/r^2, hoop a + b/r^2."""
    E: float
    nu: float
    inner: float
    outer: float
    pressures: tuple = (0, 0)

    def constants(self):
        squares, (p, q) = (self.inner**2, self.outer**2), self.pressures
        return (p * squares[0] - q * squares[1]) / (squares[1] - squares[0]), (p - q) * squares[0] * squares[1] / (squares[1] - squares[0])

    def moved(self, r):
        a, b = self.constants()
        return (1 + self.nu) / self.E * ((1 - 2 * self.nu) * a * r + b / r)

    def stresses(self, r):
        """Radial, hoop, axial."""
        a, b = self.constants()
        return a - b / r**2, a + b / r**2, 2 * self.nu * a

    def energy(self, angle):
        return angle / 2 * (self.pressures[0] * self.moved(self.inner) * self.inner - self.pressures[1] * self.moved(self.outer) * self.outer)


def lame_fit(inner, outer, bore=0):
    """Both rings in contact, with the same force on both circles, which may overlap or have a clearance."""
    def loaded(force):
        return replace(inner, pressures=(bore, force / inner.outer)), replace(outer, pressures=(force / outer.inner, 0))

    def overlap(force):
        first, second = loaded(force)
        return inner.outer + first.moved(inner.outer) - outer.inner - second.moved(outer.inner)
    force = overlap(0) / (overlap(0) - overlap(1))
    return force, *loaded(force)


def von_mises(a, b, c):
    return math.sqrt(((a - b)**2 + (b - c)**2 + (c - a)**2) / 2)


@dataclass
class Layer:
    """Of a tube (m = 1, plane strain) or spherical shell (m = 2), finite strain: W = mu/2 (I1 - 3) - mu ln J + lambda/2 ln(J)^2."""
    E: float
    nu: float
    inner: float
    outer: float

    @property
    def mu(self):
        return self.E / (2 * (1 + self.nu))

    @property
    def bulk(self):  # lambda
        return self.E * self.nu / ((1 + self.nu) * (1 - 2 * self.nu)) if self.nu < 0.5 else math.inf

    def stretch(self, P, around, m):
        """Across, where the nominal stress across is P."""
        if self.nu == 0.5:
            return around**-m
        y = -m * math.log(around) * self.bulk / (self.bulk + 2 * self.mu)
        for _ in range(60):
            l = math.exp(y)
            step = (self.mu * (l * l - 1) + self.bulk * (y + m * math.log(around)) - P * l) / (2 * self.mu * l * l + self.bulk - P * l)
            y -= max(-0.5, min(0.5, step))
            if abs(step) < 1e-15:
                break
        return math.exp(y)

    def stresses(self, R, r, P, m):
        """Radial, hoop, axial Cauchy stress (shell: hoop again)."""
        around = r / R
        across = self.stretch(P, around, m)
        J = across * around**m
        radial = P / around**m
        return radial, radial + self.mu * (around**2 - across**2) / J, radial + self.mu * ((1 if m == 1 else around**2) - across**2) / J

    def rates(self, R, state, m):
        r, P, _ = state
        around, across = r / R, self.stretch(P, r / R, m)
        J = across * around**m
        log = 0 if self.nu == 0.5 else math.log(J)
        energy = self.mu / 2 * (across**2 + m * around**2 - 1 - m) - self.mu * log + (self.bulk / 2 * log**2 if log else 0)
        return across, -m * (P - self.stresses(R, r, P, m)[1] * J / around) / R, energy * R**m

    def march(self, r, P, energy, m, n=100):
        """Radial equilibrium from the inner to the outer radius: dP/dR + m (P - P_hoop)/R = 0, by Runge and Kutta."""
        R, state, h = self.inner, (r, P, energy), (self.outer - self.inner) / n
        for _ in range(n):
            k = [self.rates(R, state, m)]
            for share in (0.5, 0.5, 1):
                k.append(self.rates(R + share * h, tuple(s + share * h * rate for s, rate in zip(state, k[-1])), m))
            state = tuple(s + h / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, *k))
            R += h
        return state


def radial(layers, start, m=1, following=0):
    """Layers in contact or tied, under a following pressure in the bore, free outside: what is known of them. start: ratio of the
    radii of the bore, about."""
    def solve(x):
        bore = first = layers[0].inner * x
        state, places = (bore, -following * x**m, 0), []
        for layer in layers:
            R = layer.inner
            if places:
                s = state[1] / (state[0] / places[-1])**m
                state = (state[0], s * (state[0] / R)**m, state[2])
            first = (R, state[0], state[1])
            state = layer.march(*state, m)
            places.append(layer.outer)
            inner_values.append(layer.stresses(*first, m))
            radii.append((first[1], state[0]))
        return state
    a, b = start, start + 1e-3
    for _ in range(40):
        inner_values, radii = [], []
        fa = solve(a)[1]
        inner_values, radii = [], []
        fb = solve(b)[1]
        if abs(b - a) < 1e-12 or fa == fb:
            break
        a, b = b, b - fb * (b - a) / (fb - fa)
    inner_values, radii = [], []
    end = solve(b)
    return {"bore": radii[0][0] - layers[0].inner, "rim": end[0] - layers[-1].outer, "energy": end[2],
            "stresses": inner_values, "pressure": -inner_values[-1][0], "radius": radii[-1][0]}


def tubes(layers, start, m, angle, following=0, pair="fit"):
    """Quantities of a quarter of tubes or shells; angle: pi/2 for the tube, 2 pi for the hemisphere of shells."""
    found = radial(layers, start, m, following)
    area = angle * found["radius"]**m
    stresses = found["stresses"][0]
    return {f"normal force of {pair}": found["pressure"] * area, f"largest pressure of {pair}": found["pressure"],
            f"contact area of {pair}": area, "displacement x of bore": found["bore"], "displacement x of rim": found["rim"],
            "stress yy of bore": stresses[1], "von Mises of bore": von_mises(*stresses), "energy": found["energy"] * angle}


def without(quantities, *words):
    return {name: value for name, value in quantities.items() if not any(word in name for word in words)}


def nu_of(bodies, ratio):
    return {f"Bodies/{body}/Poisson's ratio": ratio for body in bodies}


def probe(**points):
    """Output/Probes of bodies: name = (body, point); body "=pair" for a contact pair."""
    keys = {"Output/Probes/Names": ", ".join(points)}
    for name, (body, point) in points.items():
        keys |= {f"Output/Probes/{name}/{'Pair' if body[0] == '=' else 'Body'}": body.strip("="), f"Output/Probes/{name}/Point": point}
    return keys


RINGS = ("inner", "outer")
SPATIAL = {"Dimension": 3, "Supports/Names": "symmetry x, symmetry y, ends", "Supports/symmetry x/Displacement": "0; free; free",
           "Supports/symmetry y/Displacement": "free; 0; free", "Supports/ends/Type": "symmetry",
           "Supports/ends/Boundaries": ", ".join(f"{ring}.{end}" for ring in RINGS for end in ("bottom", "top"))}


def lame_quantities(force, inner, outer, height=1, pair="fit"):
    angle = math.pi / 2
    stresses = inner.stresses(inner.inner)
    return {f"normal force of {pair}": force * angle * height, "displacement x of bore": inner.moved(inner.inner),
            "displacement x of rim": outer.moved(outer.outer), "stress yy of bore": stresses[1], "von Mises of bore": von_mises(*stresses),
            "energy": (inner.energy(angle) + outer.energy(angle)) * height}


def shrink_fit(nu, nu_outer):
    return lame_quantities(*lame_fit(Lame(2e5, nu, 20, 30.06), Lame(2e5, nu_outer, 30, 45)))


def tube_clearance(nu, nu_outer):
    return lame_quantities(*lame_fit(Lame(2e5, nu, 20, 30), Lame(2e5, nu_outer, 30.06, 45), 600))


def tied_rings(nu, height=1):
    return lame_quantities(*lame_fit(Lame(2e5, nu, 20, 30), Lame(2e5, nu, 30, 45), 600), height)


TIED_RINGS = {"Contact pairs/fit/Law": "tied", "Bodies/inner/Outer radius": 30, "Bodies/outer/Inner radius": 30,
              "Loads/fluid/Pressure": 600, "Load steps/Number": 1, "Load steps/End time": 1, "Mesh/Refinements": 0}
LAST = {"Load steps/Number": 1, "Load steps/End time": 3, "Mesh/Refinements": 0}


def hertz(nu, radius, depth, approach, mean, way):
    """A block between rollers: of the same E/(1 - nu^2) all is the same but its uniform compression."""
    def compliance(nu):
        return (1 + nu) * (1 - 2 * nu) / (1 - nu) / (2e5 / 0.91 * (1 - nu**2))
    approach += mean * depth * (compliance(nu) - compliance(0.3))
    return {"Bodies/block/Poisson's ratio": nu, "Bodies/block/Young's modulus": 2e5 / 0.91 * (1 - nu**2),
            f"Obstacles/{way}/Displacement": f"0; {-approach!r}"}


def smooth(nu):
    """The force of incompressible-smooth, and what its solution says of the point (0.4, 0.6)."""
    A, B, m0, mu, c, x, y = 0.002, 0.001, -0.03, 1 / (2 * (1 + nu)), (1 + nu) * (1 - 2 * nu) / nu, 0.4, 0.6
    sx, cx, sy, cy = math.sin(3 * x), math.cos(3 * x), math.sin(2 * y), math.cos(2 * y)
    px, qx, py, qy = math.sin(2 * x), math.cos(2 * x), math.sin(3 * y), math.cos(3 * y)
    m = -13 * B * qx * qy + m0
    xx = 2 * mu * (6 * A * cx * cy + c * (-4 * B * qx * qy + m0 / 2)) + m
    yy = 2 * mu * (-6 * A * cx * cy + c * (-9 * B * qx * qy + m0 / 2)) + m
    xy = mu * (-4 * A * sx * sy + 9 * A * sx * sy + 12 * c * B * px * py)
    plane = math.sqrt(von_mises(xx, yy, m)**2 + 3 * xy**2)
    return {"force of foot": 2 * mu * (2 * A * math.sin(3) + c * (9 * B * math.sin(2) / 2 - m0 / 2)) + 13 * B * math.sin(2) / 2 - m0,
            "displacement y of q": -3 * A * cx * sy + c * (-3 * B * qx * py + m0 * y / 2), "stress xx of q": xx, "von Mises of q": plane}


BEAM = "../varied/tied-beam"


def beam(nu):
    k, xx = nu / (1 - nu), 6
    return {"displacement y of tip": -1e-3 * (8**3 / 3 + (1 + k) * 8), "reaction y of wall": 2 / 3, "force y of bond": 2 / 3,
            "stress xx of q": xx, "von Mises of q": von_mises(xx, 0, nu * xx), "pressure of bond": -2,
            "energy": 1e-3 * (8**3 / 3 * 2 / 3 / 2 + (1 + k) / 4 * 8 * 16 / 15)}


def kirsch():
    """tied-hole: the energy is the work of the stresses on the rim r = 3, and the axial stress of plane strain counts in von Mises."""
    n, r, E, nu, S, work = 720, 3, 1000, 0.3, 10, 0
    mu, kappa = E / (2 * (1 + nu)), 3 - 4 * nu
    for i in range(n):
        t = 2 * math.pi * i / n
        u = S / (8 * mu) * (r * (kappa - 1 + 2 * math.cos(2 * t)) + 2 / r * (1 + (kappa + 1) * math.cos(2 * t) - math.cos(2 * t) / r**2))
        v = S / (8 * mu) * (-2 * r + 2 / r * (1 - kappa - 1 / r**2)) * math.sin(2 * t)
        radial = S / 2 * (1 - 1 / r**2) + S / 2 * (1 - 4 / r**2 + 3 / r**4) * math.cos(2 * t)
        shear = -S / 2 * (1 + 2 / r**2 - 3 / r**4) * math.sin(2 * t)
        work += (radial * u + shear * v) / 2 * r * 2 * math.pi / n
    return {"stress xx of top": 3 * S, "von Mises of top": von_mises(3 * S, 0, nu * 3 * S), "energy": work,
            "displacement x of side": 6.5e-3 * 1 * (0.4 + 1 + 3.8 - 1), "normal force of bond": -5 * (1 - 1 / 1.7**2) * 2 * math.pi * 1.7}


# ---------------------------------------------------------------- simplices

def simplices():
    """The modules of the tests that write files of triangles and tetrahedra."""
    sys.path += [str(program.ROOT / "tests"), str(program.ROOT / "tests" / "groups")]
    import tetrahedra
    import triangles
    return triangles, tetrahedra


class Folder:
    """Where with_triangles() writes."""

    def __init__(self, path):
        self.path = Path(path)

    def write(self, name, text):
        (self.path / name).write_text(text)
        return self.path / name


def graded(s):
    return 10 * (0.1 * s + 0.9 * s**3)


def graded_triangles(keys, order, factor):
    triangles, _ = simplices()
    return triangles.Grid(4 * factor, 4 * factor, lambda s, t: (graded(s), -graded(1 - t)), order) if "Corners" in keys else None


def graded_tetrahedra(keys, order, factor):
    _, tetrahedra = simplices()
    return tetrahedra.Grid((3 * factor,) * 3, lambda s, t, w: (graded(s), graded(t), -graded(1 - w)), order) if "Corners" in keys else None


def flat(keys, order, factor):
    return simplices()[0].grid_of(keys, order, factor)


def spatial_ring(keys, order, factor):
    triangles, tetrahedra = simplices()
    if "Cells around" not in keys:
        return None
    plane = triangles.ring(keys, 1, factor / 2)
    return tetrahedra.Grid((plane.nx, plane.ny, max(1, factor // 2)), lambda s, t, w: (*plane.at(s, t), 5 * w), order,
                           ("inner", "outer", "symmetry_y", "symmetry_x", "bottom", "top"))


def scene_of(case, folder, mesh):
    """The path of the scene, which is written if need be."""
    path = SCENES / f"{case.scene}.prm"
    if "\n" in case.scene:
        path = Folder(folder).write("scene.prm", case.scene)
    if mesh:
        triangles, _ = simplices()
        path = triangles.with_triangles(Folder(folder), path, *mesh, grid_of=case.grid)
        path.write_text(re.sub(" *set Grading .*\n", "", path.read_text()))
    return path


# ---------------------------------------------------------------- table

RING = 30 * math.pi / 2  # quarter of the circumference
CASES = {
    "PUB-02": Case(SMALL, "gap-wall-2d", {"Load steps/End time": 2}, {"force x of block end": -16.483516484}),
    "PUB-03": Case(SMALL, "shrink-fit", {}, {"normal force of fit": 84.717379 * RING, "displacement x of bore": -0.0276099298}),
    "PUB-04": Case(SMALL, "hertz-2d", {}, {"force of contact": 300, "largest pressure of contact": 374.3187, "contact area of contact": 1.020446}),
    "PUB-05": Case(SMALL, "hertz-axisymmetric", {}, {"force of contact": 1000, "largest pressure of contact": 470.1859,
                                                     "contact area of contact": math.pi * 1.007711**2}),
    "PUB-06": Case(SMALL, "hertz-half-space", {}, {"force of contact": 1000, "largest pressure of contact": 470.0515,
                                                   "displacement x of surface": -4.008691e-4}),
    # The reference is that of a half-plane: 3e-4 more than that of the scene's block.
    "PUB-07": Case(SMALL, "wavy", {"Bodies/block/Corners": "0,0 : 5,20"}, {"largest pressure of contact": 195.2916, "contact area of contact": 2.5}),
    "PUB-08": Case(SMALL, "punch-axisymmetric", {}, {"force of contact": 460.396, "reaction y of sides": 460.396}),
    "PUB-09": Case(SMALL, "layer", {}, {"largest pressure of contact": 7.895882, "contact area of contact": 10.07782}),
    "PUB-10": Case(SMALL, "tube-clearance", {}, {"normal force of fit": 2995.87093 * math.pi / 2, "displacement x of bore": 0.132645089}),
    "PUB-11": Case(SMALL, "polynomial", {}, {"force of foot": 1 / 120}),
}

FS2 = [Layer(1, 0.3, 1, 1.8), Layer(2, 0.35, 1.5, 2.4)]
FS4 = [Layer(1, 0.3, 1, 1.4), Layer(2, 0.3, 1.5, 2.2)]
FS2_AXIAL = {"Bodies/inner/Corners": "1,0 : 1.8,0.4", "Bodies/outer/Corners": "1.5,0 : 2.4,0.4", "Bodies/inner/Young's modulus": 1,
             "Bodies/outer/Young's modulus": 2, "Bodies/outer/Poisson's ratio": 0.35, "Bodies/inner/Subdivisions": "4,2", "Deformation": "finite",
             "Loads/fluid/Pressure": 0, "Load steps/Times": "", "Load steps/Number": 1, "Load steps/End time": 1,
             **probe(bore=("inner", "1,0.2"), rim=("outer", "2.4,0.2"))}


def soft(layers, ratio):
    return [replace(layer, nu=ratio) for layer in layers]


def around(quantities, height):
    """Of a quarter circle, as the axisymmetric model has them; hoop stresses are zz there."""
    per = {"normal force": 4 * height, "contact area": 4 * height, "energy": 4 * height}
    return {name.replace("stress yy", "stress zz"): value * next((factor for word, factor in per.items() if name.startswith(word)), 1)
            for name, value in quantities.items()}


CASES |= {
    "block": Case(FINITE, "finite-block", {}, {"force of top": 0.45842392321, "energy": 0.060942479343, "reaction y of base": 0.45842392321}),
    "stack": Case(FINITE, "finite-stack-3d", {}, {"force of joint": 0.40523042431, "energy": 2 * 0.054405375129}),
    "ramp": Case(FINITE, "finite-ramp", {}, {"normal force of foot": 0.27415643833}),
    "tubes": Case(FINITE, "finite-shrink-fit", {}, tubes(FS2, 0.84, 1, math.pi / 2)),
    "tubes, degree 2": Case(FINITE, "finite-shrink-fit", {"Mesh/Degree": 2}, tubes(FS2, 0.84, 1, math.pi / 2)),
    "tubes, axial": Case(FINITE, "tube-axisymmetric", FS2_AXIAL, around(tubes(FS2, 0.84, 1, math.pi / 2), 0.4)),
    "tubes, 3D": Case(FINITE, "finite-shrink-fit", {**SPATIAL, "Bodies/inner/Height": 0.4, "Bodies/outer/Height": 0.4,
                                                    **probe(bore=("inner", "1,0,0.2"), rim=("outer", "2.4,0,0.2"))},
                      {name: value * (0.4 if name.startswith(("normal", "contact", "energy")) else 1)
                       for name, value in without(tubes(FS2, 0.84, 1, math.pi / 2), "von").items()}, targets=(5e-2, 1e-2)),
    "shells": Case(FINITE, "finite-shell-fit", {}, tubes(FS2, 0.84, 2, 2 * math.pi)),
    "inflated": Case(FINITE, "finite-inflated-tube", {}, tubes(FS4, 1.2, 1, math.pi / 2, 0.08)),
    "inflated 0.25": Case(FINITE, "finite-inflated-tube", {"Loads/gas/Pressure": "0.25*t", "Load steps/Number": "automatic"},
                          tubes(FS4, 1.7, 1, math.pi / 2, 0.25)),
    "cavity": Case(FINITE, "finite-cavity", {"Bodies/soft/Refinements": 1, **probe(q=("soft", "0.3,0.2"))},
                   {"normal force of fit": 0.61864822953 * 0.8 * math.pi / 2, "largest pressure of fit": 0.61864822953,
                    "stress xx of q": -0.61864822953, "displacement x of q": -0.06,
                    "energy": math.pi / 4 * ((2 * 0.64 - 2) / 5.2 - math.log(0.64) / 2.6 + 0.3 / 0.52 / 2 * math.log(0.64)**2)}),
    "strip": Case(FINITE, "finite-wrapped-strip", {}, {"normal force of wrap": 0.055255525702 * math.pi / 4,
                                                       "displacement y of outside": -0.0359084017, "largest pressure of wrap": 0.055255525702}),
    "half cylinder": Case(FINITE, "finite-half-cylinder", {"Bodies/disc/Refinements": 2, "Bodies/block/Subdivisions": "6,4"},
                          {"force y of contact": 0.24125 / 2, "reaction y of base": 0.24125 / 2}, 2e-4),
    "half cylinder, 10": Case(FINITE, "finite-half-cylinder", {"Bodies/block/Young's modulus": 10, "Bodies/disc/Refinements": 2,
                                                               "Bodies/block/Subdivisions": "6,4"}, {"force y of contact": 0.4877 / 2}, 1e-3),
    "o-ring": Case(FINITE, "finite-o-ring", {"Bodies/ring/Refinements": 2},
                   {"force of contact": 0.43515 / 2, "reaction y of base": 0.43515 / 2}, 1e-4),
    "o-ring, displacement": Case(FINITE, "finite-o-ring", {"Bodies/ring/Refinements": 2, "Bodies/ring/Formulation": "displacement"},
                                 {"force of contact": 0.43515 / 2}, 1e-4),
    "punch": Case(FINITE, "finite-punch", {"Bodies/lower/Subdivisions": "6,6,3", "Bodies/upper/Subdivisions": "3,3,3"}, {"force of joint": 60.2},
                  5e-3, (5e-2, 1e-2)),
}
for ratio in (0.4999, 0.5):
    CASES |= {
        f"smooth {ratio}": Case(INCOMPRESSIBLE, "incompressible-smooth",
                                {"Definitions/nu": ratio, "Mesh/Refinements": 1, **probe(q=("square", "0.4,0.6"))}, smooth(ratio)),
        f"rings {ratio}": Case(INCOMPRESSIBLE, "shrink-fit", nu_of(RINGS, ratio), shrink_fit(ratio, ratio)),
        f"inner ring {ratio}": Case(INCOMPRESSIBLE, "shrink-fit", nu_of(["inner"], ratio), shrink_fit(ratio, 0.3)),
        f"clearance {ratio}": Case(INCOMPRESSIBLE, "tube-clearance", {**LAST, **nu_of(["outer"], ratio)}, tube_clearance(0.3, ratio)),
        f"hertz {ratio}": Case(INCOMPRESSIBLE, "hertz-2d", hertz(ratio, 300, 20, 0.006324108, 15, "cylinder"),
                               {"force of contact": 300, "largest pressure of contact": 374.3187, "half-width of contact": 1.020446 / 2}),
        f"sphere {ratio}": Case(INCOMPRESSIBLE, "hertz-axisymmetric", hertz(ratio, 300, 10, 0.003180527, 1000 / (100 * math.pi), "sphere"),
                                {"force of contact": 1000, "largest pressure of contact": 470.1859, "contact radius of contact": 1.007711}),
        f"tubes {ratio}": Case(INCOMPRESSIBLE, "finite-shrink-fit", nu_of(RINGS, ratio), tubes(soft(FS2, ratio), 0.84, 1, math.pi / 2)),
        f"shells {ratio}": Case(INCOMPRESSIBLE, "finite-shell-fit", nu_of(RINGS, ratio), tubes(soft(FS2, ratio), 0.84, 2, 2 * math.pi)),
        f"inflated {ratio}": Case(INCOMPRESSIBLE, "finite-inflated-tube", nu_of(RINGS, ratio), tubes(soft(FS4, ratio), 1.2, 1, math.pi / 2, 0.08)),
    }
PLANE_MESHES = tuple((order, factor) for order in (1, 2) for factor in (1, 2, 4))
CASES |= {
    "sphere, triangles": Case(SIMPLICES, "hertz-axisymmetric", {"Mesh/Refinement regions/Names": ""},
                              {"force of contact": 1000, "largest pressure of contact": 470.1859, "contact radius of contact": 1.007711},
                              grid=graded_triangles, meshes=tuple((order, factor) for order in (1, 2) for factor in (2, 4, 8))),
    "rings, triangles": Case(SIMPLICES, "shrink-fit", {}, shrink_fit(0.3, 0.3), grid=flat, meshes=PLANE_MESHES, parabolas=2.4e-4),
    "tubes, triangles": Case(SIMPLICES, "finite-shrink-fit", {}, tubes(FS2, 0.84, 1, math.pi / 2), grid=flat, meshes=PLANE_MESHES),
    "rings 0.4999, triangles": Case(SIMPLICES, "shrink-fit", nu_of(RINGS, 0.4999), shrink_fit(0.4999, 0.4999), grid=flat, meshes=PLANE_MESHES[3:],
                                   parabolas=2.4e-4),
    "beam, triangles": Case(SIMPLICES, BEAM, {}, beam(0.3), grid=flat, meshes=PLANE_MESHES),
    "sphere, tetrahedra": Case(SIMPLICES, "hertz-quarter", {"Mesh/Refinement regions/Names": ""},
                               {"force of contact": 250, "largest pressure of contact": 470.1859}, grid=graded_tetrahedra,
                               meshes=((1, 2), (1, 4), (2, 2), (2, 3))),
    "rings, tetrahedra": Case(SIMPLICES, "shrink-fit", {**SPATIAL, **probe(bore=("inner", "20,0,2.5"), rim=("outer", "45,0,2.5"))},
                              {name: value * (5 if name.startswith(("normal", "energy")) else 1) for name, value in shrink_fit(0.3, 0.3).items()},
                              grid=spatial_ring, meshes=((1, 4), (2, 1), (2, 2)), parabolas=3.8e-3),
    "tied rings": Case(TIES, "tube-clearance", TIED_RINGS, tied_rings(0.3)),
    "tied rings 0.5": Case(TIES, "tube-clearance", {**TIED_RINGS, **nu_of(RINGS, 0.5)}, tied_rings(0.5)),
    "tied rings, 3D": Case(TIES, "tube-clearance", {**TIED_RINGS, **SPATIAL, "Bodies/inner/Height": 5, "Bodies/outer/Height": 5,
                                                    "Bodies/inner/Cells around": 6, "Bodies/outer/Cells around": 8,
                                                    **probe(bore=("inner", "20,0,2.5"), rim=("outer", "45,0,2.5"))},
                           tied_rings(0.3, 5), targets=(5e-2, 1e-2)),
    "tied tubes": Case(TIES, "finite-inflated-tube", {"Contact pairs/fit/Law": "tied", "Bodies/inner/Outer radius": 1.5,
                                                               "Bodies/outer/Young's modulus": 1},
                       without(tubes([Layer(1, 0.3, 1, 1.5), Layer(1, 0.3, 1.5, 2.2)], 1.15, 1, math.pi / 2, 0.08), "contact area")),
    "tied beam": Case(TIES, BEAM, {}, beam(0.3)),
    "tied beam 0.5": Case(TIES, BEAM, {"Definitions/nu": 0.5}, beam(0.5)),
    "hole": Case(TIES, "tied-hole", {**probe(top=("inner", "0,1"), side=("inner", "1,0")), "Mesh/Refinements": 0}, kirsch()),
}


# ---------------------------------------------------------------- friction

REFERENCE = {"Contact method/Contact geometry": "reference"}
PLAIN = (None, 5e-2, 1e-2)


def of_pair(pair, **quantities):
    return {f"{name.replace('_', ' ')} of {pair}": references for name, references in quantities.items()}


def frictional(scene, keys, quantities, known_to=0, targets=PLAIN):
    scene = friction_cases.text(scene) if isinstance(scene, dict) else scene
    return Case(FRICTION, scene, {**REFERENCE, **keys}, quantities, known_to, targets)


def coarse(**levels):
    return {f"Mesh/Refinement regions/{name}/Levels": number for name, number in levels.items()}


def punch(model, size, regions, obstacle=friction_cases.FLAT, number=1):
    return friction_cases.indented(model, size, 10, regions, obstacle, {"Number": number})


def by_forces(number):
    return friction_cases.by_forces({"Number": number}, "600*t", "90*t")


def near(size, levels):
    return friction_cases.squares(0.0, 0.0, size, 1.5, levels)


# Own runs: the scene with degree 2, with cells of a quarter to a sixteenth of those of the start and 8 to 64 load steps a leg;
# known_to: the difference of two such meshes, or to the half-plane.
# PF-06: work of the box by other elements (a quarter of a cycle a way), and of the half-plane times the same ratio; the zones and
# slips of the half-plane, which differ from the box by less than known_to; force by own runs with 3 and 4 levels
# and with a uniform refinement, extrapolated for the corners of the blocks.
MINDLIN = {**coarse(contact=1), "Load steps/Times": "1, 2, 3, 4"}
MINDLIN_FORCE = {2: (89.92, 0.012), 3: (0.0, 0.005), 4: (89.92, 0.012)}
MINDLIN_REST = of_pair("interface", stick_area={2: 1.444149, 3: 1.768714, 4: 1.444149},
                       largest_slip={2: 2.778185e-4, 3: 1.234928e-4, 4: 2.778185e-4},
                       friction_work={2: 0.00264868, 3: 0.0032056, 4: 0.00794603})
MINDLIN_END = of_pair("interface", friction_force={4: (89.92, 0.012)}, stick_area={4: 1.444149}, largest_slip={4: 2.778185e-4},
                      friction_work={4: 0.00794603})
TOGETHER = of_pair("interface", friction_force={1: 90}, stick_area={1: 2.0423}, largest_slip={1: (0.0, 1e-9)}, friction_work={1: (0.0, 1e-9)})
BAR = friction_cases.bar()[0].scene
CASES |= {
    "Mindlin": frictional("friction-mindlin", MINDLIN, MINDLIN_REST, 4e-3),
    "Mindlin, end": frictional("friction-mindlin", {**MINDLIN, "Accuracy/Load steps": "last"}, MINDLIN_END, 4e-3),
    "Mindlin, force": frictional("friction-mindlin", MINDLIN, of_pair("interface", friction_force=MINDLIN_FORCE)),
    # PF-07: as before, slip and work of the half-plane; force by own runs.
    "bulk tension": frictional(friction_cases.bulk_tension()[0].scene, coarse(contact=1),
                               of_pair("interface", friction_force={2: (89.856, 0.012)}, stick_area={2: 1.444149},
                                       largest_slip={2: 3.464147e-4}, friction_work={2: 0.0028336}), 4e-3),
    # PF-08: nothing slips.
    **{f"together {number}": frictional(by_forces(number), coarse(contact=1), TOGETHER, 4e-3) for number in (1, 5, "automatic")},
    # PF-10: in a large body that of the half-space, and own runs; the normal force of the cylinder says its half-width.
    "punch, half-space": frictional(punch("plane strain", 2000, near(1000, 12)), {}, {
        "normal force of foot": {1: (1.11339e-4, 1e-8)}, **of_pair("foot", friction_force={1: 2.2156e-5}, stick_area={1: 0.6897},
                                                                  largest_slip={1: (1.938e-5, 1e-7)}, friction_work={1: 6.2533e-11})}, 1e-3),
    "punch, box": frictional(punch("plane strain", 10, near(4, 2)), {}, {
        "normal force of foot": {1: (3.4837e-4, 1e-7)}, **of_pair("foot", friction_force={1: 5.6612e-5}, stick_area={1: 0.8330},
                                                                  friction_work={1: 3.0050e-10})}, 1.5e-3),
    **{f"cylinder {number}": frictional(punch("plane strain", 2000, near(1000, 10), friction_cases.parabola(0.0065), number), {}, {
        "normal force of foot": {1: (6.98207e-4, 1e-7)}, "contact area of foot": {1: (1.2422, 1.5e-3)},
        "stick area of foot": {1: (0.8563, 2e-3)}}) for number in (1, 5)},
    # PF-11
    "punch, axisymmetric": frictional(punch("axisymmetric", 40, near(20, 5)), {}, {
        "normal force of foot": {1: (2.2977e-3, 7e-7)}, **of_pair("foot", stick_area={1: 2.5224}, largest_slip={1: (5.224e-5, 5e-7)},
                                                                  friction_work={1: (2.942e-9, 4e-12)})}, 5e-4),
    # The block is 2 % stiffer than the half-space: contact of the sphere by its force, (3 R F / (4 E* 1.04426))^(2/3) pi.
    "sphere": frictional(punch("axisymmetric", 40, near(20, 6), friction_cases.parabola(1.0194849e-3)), {}, {
        "normal force of foot": {1: (1.5615e-3, 3e-7)},
        "contact area of foot": {1: (3.1848, 4e-3)}, "stick area of foot": {1: (2.5565, 6e-3)}}),
    # PF-05: own runs of 120 x 4 and 240 x 8 cells.
    "bar": frictional(BAR, {"Bodies/bar/Subdivisions": "60,2", "Bodies/bar/Degree": 1, **probe(q=("bar", "0,0.5"))}, {
        **of_pair("foot", friction_force={2: 60}, stick_area={2: (30.64, 0.1), 3: (45.73, 0.07)},
                  largest_slip={2: (8.8512e-3, 4e-6), 3: (4.39046e-3, 2e-6)}, friction_work={2: (0.179633, 5e-5), 3: (0.222493, 3e-5)}),
        "displacement x of q": {2: (8.8907e-3, 4e-7), 3: (4.3759e-3, 4e-7)}}),
    # PF-01, 04, 13, 14: exact. The slip of the patch is a vector.
    "patch": frictional("friction-patch", {}, {"friction force x of interface": {2: 0.28867513, 3: 0.51961524, 4: 0.3208384848},
                                               "friction force y of interface": {2: 0.16666667, 3: 0.3, 4: 0.5070134778},
                                               **of_pair("interface", largest_slip={3: 0.00084},
                                                         friction_work={3: 0.000504, 4: 0.0013114987})}, 1e-6),
    "cycles": frictional("friction-cycles", {}, of_pair("foot", friction_force={4: 150},
                                                        friction_work={2: 3.375, 3: 10.125, 4: 16.875}), 1e-6),
    "ring": frictional("friction-ring", {"Bodies/inner/Cells around": 12, "Bodies/outer/Cells around": 16}, {
        "normal force of fit": {1: 84.53085 * 60 * math.pi, 3: 84.53085 * 60 * math.pi},
        **of_pair("fit", stick_area={3: 60 * math.pi}, largest_slip={2: 30 * 1.511905e-4, 3: 30 * 1.511905e-4},
                  friction_work={2: 71701.61 * 1.511905e-4, 3: 71701.61 * 1.511905e-4})}, 1e-4),
    "pull": frictional("friction-pull", {"Bodies/inner/Subdivisions": "2,2", "Bodies/outer/Subdivisions": "3,3", "Mesh/Degree": 1}, {
        **of_pair("fit", friction_force={2: 15496.242, 3: 21749.49}, largest_slip={3: 0.003192934},
                  friction_work={3: 21749.49 * 0.003192934})}, 1e-6),
    # Euler and Eytelwein, with the tension in the middle of the thickness.
    "strap": frictional("friction-strap", {"Bodies/strap/Cells around": 20},
                        {"force x of wrap": {2: 2 * math.exp(-0.3 * math.pi / 2 * 10 / 10.1)}}, 1e-3),
    # PF-16: published.
    "plate": frictional("friction-plate", {"Bodies/plate/Subdivisions": "8,8"}, {
        "friction force of foot": {1: 1405473}, "displacement x of A": {1: 2.860232e-5}, "displacement x of E": {1: 1.541348e-5}}, 1e-4),
}
# Scenes of the gallery, with what a newcomer would ask for.
GALLERY_SCENES = {
    "ball-on-block": ({}, ("force of interface",)),
    "block-on-block": ({}, ("force of interface",)),
    "hub-on-shaft": ({}, ("normal force of fit", "displacement x of rim")),
    "leaf-spring": ({}, ("force of tip",)),
    "pin-in-hole": ({}, ("largest pressure of fit", "contact area of fit")),
    "receding-layer": ({}, ("largest pressure of contact", "contact area of contact")),
    "rounded-punch": ({}, ("motion y of punch", "contact radius of contact")),
    "tilted-punch": ({}, ("motion y of punch",)),
}
CASES |= {name: Case(GALLERY, f"../../prm/{name}", keys, dict.fromkeys(quantities)) for name, (keys, quantities) in GALLERY_SCENES.items()}
