# SPDX-License-Identifier: Apache-2.0
"""The axes of scripts/extremes with Coulomb friction.

Most scenes are two layers, or one on a rigid plane, that are pressed by p and moved tangentially by u p/k with the stiffness
1/k = sum(height / shear modulus). Pressures on the sides make up for Poisson's ratio, so that stress is uniform whatever the
moduli and meshes, and the traction over p is that of radial return, t = Pi(t + du), in the load steps that the program took.
Other scenes have given resultants, or are images of each other: scaled, turned, mirrored, sides exchanged, on more ranks.
"""

import itertools
import math
import re
from dataclasses import dataclass

import program

METHODS = {
    "penalty": {"Method": "penalty"},
    "Lagrange multiplier": {"Method": "Lagrange multiplier"},
    "augmented Lagrangian": {"Method": "augmented Lagrangian"},
    "augmented Lagrangian, Newton": {"Method": "augmented Lagrangian", "augmented Lagrangian/Scheme": "Newton"},
    "perturbed Lagrangian": {"Method": "perturbed Lagrangian"},
    "perturbed Lagrangian, condensed": {"Method": "perturbed Lagrangian", "perturbed Lagrangian/System": "condensed"},
    "direct elimination": {"Method": "direct elimination"},
}
FEW = ("penalty", "Lagrange multiplier", "augmented Lagrangian")
MORTAR = tuple(name for name in METHODS if name != "direct elimination")
# Compliant methods have an elastic slip of about 1/1000 of the motion.
TOLERANCE = {name: 5e-3 if name.startswith(("penalty", "perturbed")) else 1e-6 for name in METHODS}
MU = (0.0, 1e-6, 0.01, 0.3, 1.0, 3.0, 10.0)


def dot(matrix, vector):
    return [sum(a * b for a, b in zip(row, vector)) for row in matrix]


def transposed(matrix):
    return [list(column) for column in zip(*matrix)]


def unit(dim):
    return [[float(i == j) for j in range(dim)] for i in range(dim)]


def turn(dim, degrees, axis=2):
    """A rotation of the plane, or about an axis."""
    c, s = (round(math.cos(math.radians(degrees)), 15), round(math.sin(math.radians(degrees)), 15))
    result = unit(dim)
    i, j = (0, 1) if dim == 2 else [k for k in range(3) if k != axis]
    result[i][i] = result[j][j] = c
    result[i][j], result[j][i] = -s, s
    return result


def multiply(a, b):
    columns = transposed(b)
    return [[sum(x * y for x, y in zip(row, column)) for column in columns] for row in a]


def combination(factors, terms):
    """A formula: the sum of terms (formulas) with factors."""
    parts = [f"{factor!r}*({term})" for factor, term in zip(factors, terms) if factor != 0 and term != "0"]
    return " + ".join(parts) or "0"


def section(path, **values):
    """Text of a section, of which `path` has the names of all sections around it."""
    names = path.split("/")
    lines = ["  " * depth + f"subsection {name}" for depth, name in enumerate(names)]
    lines += ["  " * len(names) + f"set {key.replace('_', ' ')} = {value}" for key, value in values.items()]
    lines += ["  " * depth + "end" for depth in reversed(range(len(names)))]
    return "\n".join(lines) + "\n"


def chosen(method):
    """Sections that choose a contact method."""
    text = ""
    for key, value in METHODS[method].items():
        path = ("Contact method/" + key).rsplit("/", 1)
        text += section(path[0], **{path[1]: value})
    return text


@dataclass
class Layers:
    """@param path of (time, press, u, v): fraction of the pressure and motions in units of p/k, linear between; @param times of
    the ends of load steps, or their number, or "automatic"; @param law coefficient of friction: a formula, and the function of
    (time, pressure, slip length) that it means; @param limit in units of p; @param base None: a rigid plane; @param lift of
    (time, distance): the upper layer is taken off; @param force the top is driven by a force u p instead"""
    path: tuple = ((1, 1, 0), (2, 1, 0.15), (3, 1, 0.6), (4, 1, -0.3))
    times: object = None
    mu: float = 0.3
    law: tuple = None
    limit: float = math.inf
    dim: int = 2
    model: str = "plane strain"
    cells: tuple = (3, 4)
    across: tuple = None
    moduli: tuple = (1000.0, 1000.0)
    nu: float = 0.3
    heights: tuple = (1.0, 1.0)
    degree: int = 1
    closing: float = 1e-3
    length: float = 1.0
    plane: bool = False
    plane_moves: bool = True
    rotation: list = None
    swap: bool = False
    lift: tuple = ()
    force: bool = False
    separates: bool = True
    geometry: str = "reference"
    levels: int = 0
    place: tuple = (0.37,)
    distortion: float = 0.0
    extra: str = ""
    method: str = "Lagrange multiplier"

    def __post_init__(self):
        if self.plane:
            self.heights, self.moduli, self.cells = (0.0, self.heights[1]), (self.moduli[1],) * 2, (1, self.cells[1])
        self.rotation = self.rotation or unit(self.dim)
        nu = self.nu
        share = {"plane stress": nu}.get(self.model, nu / (1 - nu))
        factor = 1 / (1 - nu ** 2) if self.model == "plane stress" else (1 - nu) / ((1 + nu) * (1 - 2 * nu))
        self.confined = [modulus * factor for modulus in self.moduli]
        self.side_pressure = share
        self.total = [height * self.length for height in self.heights]
        self.p = self.closing * self.length / sum(h / m for h, m in zip(self.total, self.confined))
        self.k = 1 / sum(h / (m / 2 / (1 + nu)) for h, m in zip(self.total, self.moduli))
        self.area = self.length ** (self.dim - 1)
        self.ends = [time for time, *_ in self.path] if self.times is None else self.times

    def table(self, column):
        points = [(0.0, 0.0)] + [(row[0], row[column] if column < len(row) else 0.0) for row in self.path]
        return "table(t, " + ", ".join(f"{time!r},{value!r}" for time, value in points) + ")"

    def at(self, time):
        """Press and motion."""
        points = [(0.0, 0.0, 0.0, 0.0)] + [(*row, 0.0)[:4] for row in self.path]
        for before, after in zip(points, points[1:]):
            if time <= after[0]:
                share = (time - before[0]) / (after[0] - before[0])
                values = [a + share * (b - a) for a, b in zip(before, after)]
                return values[1], values[2:]
        return points[-1][1], list(points[-1][2:])

    def is_open(self, time):
        if not self.lift:
            return False
        points = [(0.0, 0.0), *self.lift]
        for before, after in zip(points, points[1:]):
            if time <= after[0]:
                return before[1] + (time - before[0]) / (after[0] - before[0]) * (after[1] - before[1]) > 0
        return points[-1][1] > 0

    def scene(self):
        dim, names = self.dim, ("low", "up")
        sides = ("left", "right") if dim == 2 else ("left", "right", "front", "back")
        axes = "xyz"[:dim]
        home = [combination(row, axes) for row in transposed(self.rotation)]
        is_turned = self.rotation != unit(dim)
        p, unit_motion = self.p, self.p / self.k
        text = f"set Dimension = {dim}\nset Model = {self.model if dim == 2 else 'solid'}\n"
        text += section("Definitions", press=self.table(1), ux=combination([unit_motion], [self.table(2)]),
                        uy=combination([unit_motion], [self.table(3)]),
                        lift=combination([self.length],
                                         ["table(t, 0,0, " + ", ".join(f"{a!r},{b!r}" for a, b in self.lift) + ")"])
                        if self.lift else "0", h=home[-1])
        present = names[1:] if self.plane else names
        text += section("Bodies", Names=", ".join(present))
        start = 0.0
        shortening = ("0", "0")
        for i, name in enumerate(names):
            if name not in present:
                continue
            across = self.across[i] if self.across else self.cells[i]
            low, high = [0.0] * (dim - 1) + [start], [self.length] * (dim - 1) + [start + self.total[i]]
            values = {"Corners": ",".join(map(repr, low)) + " : " + ",".join(map(repr, high)),
                      "Subdivisions": ",".join([str(self.cells[i])] * (dim - 1) + [str(across)])}
            shape = list(axes)
            if self.distortion:
                shape[0] = f"x + {self.distortion!r}*sin(2*pi*x)*sin(pi*{axes[-1]})"
            if is_turned or self.distortion:
                values["Transformation"] = "; ".join(combination(row, shape) for row in self.rotation)
            values["Young's modulus"], values["Poisson's ratio"] = repr(self.moduli[i]), repr(self.nu)
            text += section(f"Bodies/{name}", **values)
            start += self.total[i]
        motions = {"low": f"-{p / self.confined[0]!r}*h*press",
                   "up": f"-({p * self.total[0] / self.confined[0]!r} + {p / self.confined[1]!r}*(h - {self.total[0]!r}))*press + lift"}
        up = [row[-1] for row in self.rotation]
        text += section("Supports", Names=", ".join([*(f"{name} sides" for name in present),
                                                     *(["base"] if not self.plane else []), "top"]))
        for name in present:
            boundaries = ", ".join(f"{name}.{side}" for side in sides)
            if is_turned:
                text += section(f"Supports/{name} sides", Boundaries=boundaries, Type="roller", Direction=",".join(map(repr, up)),
                                Normal_displacement=motions[name])
            else:
                text += section(f"Supports/{name} sides", Boundaries=boundaries,
                                Displacement="free; " * (dim - 1) + motions[name])
        if not self.plane:
            text += section("Supports/base", Boundaries="low.bottom", Displacement="; ".join("0" * dim))
        closing = f"-{self.closing * self.length!r}*press + lift"
        tangential = ["ux", "uy"][:dim - 1]
        by_plane = self.plane and self.plane_moves
        if self.force:
            text += section("Supports/top", Boundaries="up.top", Displacement="free; " * (dim - 1) + closing)
        else:
            motion = [*(["0"] * (dim - 1) if by_plane else tangential), closing]
            text += section("Supports/top", Boundaries="up.top",
                            Displacement="; ".join(combination(row, motion) for row in self.rotation))
        text += section("Loads", Names="around" + (", drive" if self.force else ""))
        text += section("Loads/around", Boundaries=", ".join(f"{name}.{side}" for name in present for side in sides),
                        Pressure=f"{self.side_pressure * p!r}*press")
        if self.force:
            text += section("Loads/drive", Boundaries="up.top",
                            Traction="; ".join([f"{self.k!r}*{one}" for one in tangential] + ["0"]))
        if self.plane:
            motion = [*(f"-{one}" for one in tangential), "0"] if by_plane else ["0"] * dim
            text += section("Obstacles", Names="ground")
            text += section("Obstacles/ground", Shape="plane", Point=",".join("0" * dim), Normal=",".join(map(repr, up)),
                            Displacement="; ".join(combination(row, motion) for row in self.rotation))
        slave, master = ("low.top", "up.bottom") if self.swap else ("up.bottom", "ground" if self.plane else "low.top")
        values = {"Slave": slave, "Master": master, "Friction": self.law[0] if self.law else repr(self.mu)}
        if not self.separates:
            values["Separation"] = "none"
        if self.limit < math.inf:
            values["Friction limit"] = repr(self.limit * p)
        text += section("Contact pairs", Names="p0") + section("Contact pairs/p0", **values)
        text += section("Mesh", Degree=self.degree)
        if self.levels:
            text += section("Mesh/Refinement regions", Names="corner")
            text += section("Mesh/Refinement regions/corner", Levels=self.levels,
                            Inside=f"{0.2 * self.length!r} - sqrt((h - {self.total[0]!r})^2" +
                            "".join(f" + ({axis} - {one * self.length!r})^2" for axis, one in zip(axes, self.place)) + ")")
        steps = {"End time": repr(float(self.path[-1][0])), "Number": self.ends} if isinstance(self.ends, (int, str)) else \
            {"Times": ", ".join(map(repr, self.ends))}
        text += section("Load steps", **steps) + section("Contact method", **{"Contact geometry": self.geometry})
        text += section("Output/Probes", Names=", ".join(present))
        start = 0.0
        for name, height in zip(names, self.total):
            if name in present:
                place = dot(self.rotation, [0.47 * self.length] * (dim - 1) + [start + 0.47 * height])
                text += section(f"Output/Probes/{name}", Body=name, Point=",".join(map(repr, place)))
            start += height
        return text + chosen(self.method) + self.extra

    def states(self, times):
        """Radial return: (press, traction, slip, length of slip, work) in units of p and p/k at these times."""
        halves = self.ends == "automatic"
        mu = self.law[1] if self.law else lambda *_: self.mu
        traction, slip, length, work, last, before = [0.0, 0.0], [0.0, 0.0], 0.0, 0.0, [0.0, 0.0], 0.0
        # The work of a load step is that of the mean bound (doc/theory, (2.30)), unless the one before is not known.
        loaded = self.at(0.0)[0] != 0 or any(self.at(0.0)[1])
        by_time = bool(self.law and re.search(r"\bt\b", self.law[0]))
        bound_before = None if loaded else 0.0
        result = []
        for end in times:
            for time in ((before + end) / 2, end) if halves else (end,):
                press, motion = self.at(time)
                if self.force:
                    traction = motion
                    continue
                if self.is_open(time) or press == 0:  # without pressure contact begins anew
                    traction, slip, last, bound_before = [0.0, 0.0], [0.0, 0.0], motion, 0.0
                    continue
                trial = [t + m - l for t, m, l in zip(traction, motion, last)]
                bound = max(0.0, min(mu(time, press * self.p, length * self.p / self.k) * press, self.limit))
                size = math.hypot(*trial)
                new = [t * min(1, bound / size) if size > 0 else 0.0 for t in trial]
                step = [a - b for a, b in zip(trial, new)]
                slip = [a + b for a, b in zip(slip, step)]
                length += math.hypot(*step)
                known = bound_before is not None and bound > 0 and not by_time
                work += (0.5 * (1 + bound_before / bound) if known else 1) * sum(a * b for a, b in zip(new, step))
                bound_before = bound
                traction, last = new, motion
            result.append((0.0 if self.is_open(end) else self.at(end)[0], traction, slip, length, work))
            before = end
        return result

    def error(self, results):
        """Of normal force, friction force, stresses, slip and work, over all load steps."""
        steps = results["load_steps"]
        states = self.states([step["time"] for step in steps])
        dim, sign = self.dim, 1 if self.swap else -1
        largest = max(max(math.hypot(*state[1]) for state in states), 1e-3 * max(state[0] for state in states), 1e-300)
        # A penetration disturbs the uniform stress by a share of p, not of the traction.
        shear = max(largest, max(state[0] for state in states)) if TOLERANCE[self.method] > 1e-4 else largest
        moved = max(max(math.hypot(*self.at(step["time"])[1]) for step in steps), 1e-3 * max(state[0] for state in states), 1e-300)
        # So do elastic slips with the work; those of exact methods are 1e-10 of it in each load step.
        work_scale = max(max(abs(state[4]) for state in states), (1 if TOLERANCE[self.method] > 1e-4 else 0.05) * largest * moved)
        back = transposed(self.rotation)
        worst = ("", 0.0)

        def compare(name, value, reference, scale):
            nonlocal worst
            error = abs(value - reference) / scale
            worst = max(worst, (name, error), key=lambda one: one[1] if one[1] == one[1] else math.inf)

        for step, (press, traction, slip, length, work) in zip(steps, states):
            pair, at = step["pairs"]["p0"], f" at {step['time']:g}"
            compare("normal force" + at, pair["normal_force"] / (self.p * self.area), press, max(state[0] for state in states))
            force = dot(back, pair.get("friction_force", [0.0] * dim))
            for d in range(dim - 1):
                compare("friction force" + at, force[d] / (self.p * self.area), sign * traction[d], largest)
            compare("friction force across" + at, force[-1] / (self.p * self.area), 0.0, largest)
            if "total_friction_work" in pair:
                if not self.force:
                    compare("work" + at, pair["total_friction_work"] / (self.p ** 2 / self.k * self.area), work, work_scale)
                    if not self.is_open(step["time"]) and press > 0:
                        compare("slip" + at, pair["max_slip_since_contact"] / (self.p / self.k), math.hypot(*slip), moved)
            for name, probe in step["probes"].items():
                stress = probe["stress"]
                tensor = [[stress["".join(sorted((a, b)))] for b in "xyz"[:dim]] for a in "xyz"[:dim]]
                tensor = multiply(multiply(back, tensor), self.rotation)
                compare(f"stress of {name}" + at, tensor[-1][-1] / self.p, -press, max(state[0] for state in states))
                for d in range(dim - 1):
                    compare(f"shear of {name}" + at, tensor[d][-1] / self.p, traction[d], shear)
        return worst[1], worst[0]


def layers(runs, axis, value, method, ranks=1, tolerance=None, exists=True, **parameters):
    """Runs layers if it is their turn."""
    if not runs.skip(axis):
        case = Layers(method=method, **parameters)
        judge(runs, axis, value, method, case.scene(), case.error, tolerance or TOLERANCE[method], ranks, exists)


def judge(runs, axis, value, method, scene, error_of, tolerance, ranks=1, exists=True, excused=True):
    """Runs a scene. @param error_of function of the results: error, and of what; @param exists: a static solution;
    @param excused: by a warning

    A compliant method that is off by up to 0.05 is right if a hundred times the stiffness leaves a twentieth of that.
    """
    code, reason, results = runs.start(scene, {}, ranks)
    facts = {"scene": scene, "ranks": ranks, "exists": exists, "newton": None, "steps": None}
    if results and results["load_steps"]:
        facts["newton"] = max(step["newton_iterations"] for step in results["load_steps"])
        facts["steps"] = len(results["load_steps"])
    if code in (2, 3) and reason and "internal" not in reason:
        return runs.add(axis, value, method, "refused", None, reason, **facts)
    if code != 0 or results is None:
        return runs.add(axis, value, method, "wrong", None, f"exit code {code}: {reason}", **facts)
    error, what = error_of(results)
    if not exists and error > 1e-9:
        return runs.add(axis, value, method, "wrong", error, "no static solution exists", **facts)
    if error <= tolerance:
        return runs.add(axis, value, method, "right", error, **facts)
    if excused and TOLERANCE[method] > 1e-4 and error <= 0.05:
        stiffer = {f"Contact method/{METHODS[method]['Method']}/Factor": "1e5"}
        code, _, results = runs.start(scene, stiffer, ranks)
        if code == 0 and error_of(results)[0] <= error / 20:
            return runs.add(axis, value, method, "right", error, f"{what}: off by {error:.2g}, by compliance", **facts)
    warnings = [one for one in results["verdict"]["checks"] if one["outcome"] == "warned"]
    enough = [one for one in warnings
              if one["check"] != "penetration / deformation" or one["value"] >= min(1, error) / 2]
    words = "; ".join(one["check"] for one in warnings)
    return runs.add(axis, value, method, "warned" if enough and excused else "wrong", error,
                    f"{what}: off by {error:.2g}; {words or 'no warning'}",
                    **facts)


def fitting(methods, cells):
    """Of these methods those that take meshes which do not match."""
    return [method for method in methods if cells[0] == cells[1] or method != "direct elimination"]


# The axes:


def coefficients(runs):
    for mu, method in itertools.product(MU, METHODS):
        for dim in (2, 3) if method in FEW else (2,):
            size = max(mu, 0.01)
            cells = (2, 2) if method == "direct elimination" else (3, 4) if dim == 2 else (2, 3)
            path = ((1, 1, 0), (2, 1, 0.5 * size, 0.2 * size), (3, 1, 2 * size, 0.5 * size), (4, 1, -size, 0.9 * size))
            layers(runs, "friction: coefficient", f"{mu:g}, {dim}D", method, mu=mu, dim=dim, cells=cells,
                   path=path if dim == 3 else [row[:3] for row in path])
    for mu, method in itertools.product((0.3, 10.0), METHODS):
        layers(runs, "friction: coefficient", f"{mu:g} on a plane, degree 2", method, mu=mu, plane=True, degree=2, cells=(2, 2),
               path=((1, 1, 0), (2, 1, 0.5 * mu), (3, 1, 2 * mu), (4, 1, -mu)))


def limits(runs):
    for limit, method in itertools.product((1e-9, 1e-3, 0.1, 0.3, 0.31, 1e3, 1e30), FEW):
        layers(runs, "friction: Friction limit", f"{limit:g} p", method, limit=limit)
    for method in METHODS:
        layers(runs, "friction: Friction limit", "0.2 p while p changes", method, limit=0.2, cells=(3, 3),
               path=((1, 1, 0), (2, 1, 0.6), (3, 0.5, 0.6), (4, 2, 0.6), (5, 2, 0.9)))


def load_steps(runs):
    for n, method in itertools.product((1, 2, 5, 20, 100), METHODS):
        layers(runs, "friction: load steps", f"{n}, press and motion together", method, cells=(2, 2), times=n,
               path=((1, 1, 0.6),))
        if n < 100 or method in FEW:
            legs = [(leg + (i + 1) / n) for leg in range(4) for i in range(n)]
            layers(runs, "friction: load steps", f"{n} a leg, turning, 3D", method, dim=3, cells=(2, 2),
                   times=[*legs[n - 1:]], path=((1, 1, 0), (2, 1, 0.15, 0.0866), (3, 1, 0.4, 0.23), (4, 1, -0.12, 0.48)))
    for method in FEW:
        layers(runs, "friction: load steps", "automatic, there and back", method, times="automatic", cells=(2, 3),
               path=((1, 1, 0), (2.1, 1, 0.6), (3.05, 1, -0.6), (4, 1, 0.6)))
        layers(runs, "friction: load steps", "automatic, turning, 3D", method, times="automatic", cells=(1, 2), dim=3,
               path=((1, 1, 0), (2.1, 1, 0.6), (4, 1, -0.3, 0.5)))


def contrast(runs):
    for exponent, swap, cells in itertools.product((-4, -2, -1, 1, 2, 4), (False, True), ((3, 7), (7, 3))):
        for method in FEW:
            layers(runs, "friction: modulus ratio",
                   f"1e{exponent}, {'lower' if swap else 'upper'} slave, {cells[0]}:{cells[1]} cells",
                   method, moduli=(1000.0, 1000.0 * 10 ** exponent), swap=swap, cells=cells)
    for exponent, method in itertools.product((-4, 4), METHODS):
        layers(runs, "friction: modulus ratio", f"1e{exponent}, matching", method, moduli=(1000.0, 1000.0 * 10 ** exponent),
               cells=(3, 3))


def poisson(runs):
    for nu, degree, method in itertools.product((-0.9, 0.0, 0.45, 0.4999), (1, 2), FEW):
        layers(runs, "friction: Poisson's ratio", f"{nu:g}, degree {degree}", method, nu=nu, degree=degree,
               closing=1e-3 * (1 - 2 * nu) / (1 - nu))


def meshes(runs):
    # Slaves of one face are refused: supports hold all of their nodes.
    for cells, swap, degree in itertools.product(((2, 2), (2, 14), (5, 2), (16, 17)), (False, True), (1, 2)):
        for method in fitting(METHODS if degree == 1 else FEW, cells):
            layers(runs, "friction: mesh ratio", f"{cells[0]}:{cells[1]}, degree {degree}, {'lower' if swap else 'upper'} slave",
                   method, cells=cells, across=(2, 2), swap=swap, degree=degree)
    for cells, swap, method in itertools.product(((2, 9), (5, 2)), (False, True), FEW):
        layers(runs, "friction: mesh ratio", f"{cells[0]}:{cells[1]}, 3D, {'lower' if swap else 'upper'} slave", method,
               cells=cells,
               across=(1, 1), swap=swap, dim=3, path=((1, 1, 0), (2, 1, 0.15, 0.1), (3, 1, 0.6, 0.1), (4, 1, -0.3, 0.4)))
    for levels, degree, method in itertools.product((1, 3), (1, 2), METHODS):
        layers(runs, "friction: hanging nodes", f"{levels} levels, 2D, degree {degree}", method, levels=levels, cells=(4, 4),
               degree=degree,
               across=(2, 2))
    # Also at edges of the interface whose normal displacement is prescribed on both sides.
    for (name, place), degree, mu, method in itertools.product((("inside", (0.5, 0.5)), ("at an edge", (0.5, 0.0))), (1, 2),
                                                               (0.0, 0.3),
                                                               ("penalty", "Lagrange multiplier", "augmented Lagrangian",
                                                                "direct elimination")):
        layers(runs, "friction: hanging nodes", f"3D, degree {degree}, {name}, mu {mu:g}", method, levels=1, cells=(6, 6), dim=3,
               degree=degree,
               across=(2, 2), mu=mu, place=place, path=((1, 1, 0), (2, 1, 0.15), (3, 1, 0.6)))
    for method in FEW:
        layers(runs, "friction: distortion", "0.1, matching", method, distortion=0.1, cells=(6, 6), tolerance=0.01)


def reversals(runs):
    for size, method in itertools.product((0.29, 0.3, 0.31, 1.0, 30.0), METHODS):
        path = ((1, 1, 0), *((2 + i, 1, size * (-1) ** i) for i in range(8)))
        layers(runs, "friction: reversal", f"by {size:g} p/k at every step", method, path=path, cells=(2, 2))
    for n, method in itertools.product((40, 400), METHODS):
        layers(runs, "friction: reversal", f"by 0.29 p/k at each of {n} steps", method, cells=(2, 2),
               path=((1, 1, 0), *((2 + i, 1, 0.29 * (-1) ** i) for i in range(n))))
    for method in FEW:
        path = ((1, 1, 0), *((2 + i, 1 if i % 2 else 0.1, 0.2 * (-1) ** (i // 2)) for i in range(8)))
        layers(runs, "friction: reversal", "of pressure and motion in turns", method, path=path, cells=(2, 3))
        path = ((1, 1, 0), *((2 + i, 1, 2 * math.cos(2.4 * i), 2 * math.sin(2.4 * i)) for i in range(8)))
        layers(runs, "friction: reversal", "turns of 137 degrees, 3D", method, path=path, cells=(1, 2), dim=3)


def formulas(runs):
    for method in FEW:
        def check(value, law, method=method, **parameters):
            parameters = {"cells": (3, 4), "plane": True, **parameters}
            layers(runs, "friction: formula", value, method, law=law, **parameters)

        p = Layers(plane=True).p
        unit_slip = p / Layers(plane=True).k
        path = ((1, 1, 0), (2, 1, 0.2), (3, 1, 0.6), (4, 1, 1.0), (5, 1, 0.7))
        check("of time, falls while it sticks", ("0.5 - 0.1*t", lambda t, p, s: 0.5 - 0.1 * t),
              path=((1, 1, 0), (2, 1, 0.25), (3, 1, 0.25), (4, 1, 0.25)))
        check("of time, jumps", ("if(t < 2.5, 0.3, 0.1)", lambda t, p, s: 0.3 if t < 2.5 else 0.1), path=path)
        check("of time, zero at last", ("max(0, 0.3 - 0.1*t)", lambda t, p, s: max(0, 0.3 - 0.1 * t)), path=path)
        for drop in (1.0, 0.1, 1e-3, 1e-9):
            check(f"of slip, 0.4 to 0.1 over {drop:g} p/k", (f"table(slip, 0,0.4, {drop * unit_slip!r},0.1)",
                                                            lambda t, p, s,
                                                            drop=drop: 0.4 - 0.3 * min(1, s / (drop * unit_slip))),
                  path=path, times=[1, 2, 2.2, 2.4, 2.7, 3, 3.5, 4, 5])
        check("of slip, jumps to 0", (f"if(slip > {0.1 * unit_slip!r}, 0, 0.3)", lambda t, p, s: 0 if s > 0.1 * unit_slip
                                      else 0.3), path=path)
        for size in (0.1, 1.0, 10.0):
            check(f"of pressure, exp(-p/({size:g} p0))", (f"0.6*exp(-pressure/{size * p!r})", lambda t, q, s,
                                                          size=size: 0.6 * math.exp(-q / (size * p))),
                  path=((1, 1, 0), (2, 1, 0.6), (3, 0.5, 0.6), (4, 2, 0.6), (5, 2, -0.6)))
        check("of pressure, 0.3/pressure", (f"{0.3 * p!r}/max(pressure, {1e-9 * p!r})", lambda t, q,
                                            s: 0.3 * p / max(q, 1e-9 * p)), path=path)
        check("of pressure, jumps", (f"if(pressure > {0.75 * p!r}, 0.1, 0.3)", lambda t, q, s: 0.1 if q > 0.75 * p else 0.3),
              path=((1, 1, 0), (2, 1, 0.6), (3, 0.5, 0.6), (4, 0.5, 0.9), (5, 1, 0.9)))
        check("of pressure and two bodies", (f"0.6*exp(-pressure/{p!r})", lambda t, q, s: 0.6 * math.exp(-q / p)), plane=False,
              closing=2e-3, path=path)
        for value, text in (("negative", "-0.3"), ("negative at last", "0.3 - 0.2*t"), ("no number", "log(-1)"),
                            ("infinite", "1/(x - x)"),
                            ("negative by slip", f"0.3 - slip/{0.1 * unit_slip!r}"),
                            ("negative by pressure", f"0.3 - pressure/{p!r}")):
            check(value, (text, lambda *_: math.nan), path=path, exists=False)
        # Slip along x, a coefficient that depends on y: p stays uniform, and the friction force is its mean times p.
        for name, text in (("linear across", "0.1 + 0.4*y"), ("jumps within faces across", "if(y < 0.5, 0.1, 0.5)")):
            for motion, mean in ((20.0, 0.3), (0.05, 0.05)):
                if runs.skip("friction: formula"):
                    continue
                case = Layers(law=(text, None), dim=3, cells=(3, 3), path=((1, 1, 0), (2, 1, motion)), method=method,
                              closing=1e-3)

                def error_of(results, case=case, mean=mean):
                    pair = results["load_steps"][-1]["pairs"]["p0"]
                    return max(abs(pair["friction_force"][0] / case.p + mean) / mean,
                               abs(pair["friction_force"][1]) / case.p / mean,
                               abs(pair["normal_force"] / case.p - 1)), "forces"

                # Shear stresses between the halves act on the sides.
                judge(runs, "friction: formula", f"{name}, motion {motion:g}", method,
                      case.scene().replace("= free; free;", "= free; 0;"), error_of,
                      TOLERANCE[method])


def loads(runs):
    for closing, method in itertools.product((1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 5e-2), METHODS):
        layers(runs, "friction: load", f"closing {closing:g}", method, closing=closing, cells=(3, 3),
               path=((1, 1, 0), (2, 1, 0.15), (3, 1, 0.6)))
    for motion, method in itertools.product((1e-9, 1e-6, 1e3, 1e6), METHODS):
        layers(runs, "friction: load", f"motion {motion:g} p/k", method, closing=1e-3 if motion < 1 else 1e-2 / motion,
               cells=(3, 3),
               path=((1, 1, 0), (2, 1, motion), (3, 1, 0)))


def sliding(runs):
    """At the limit of sliding, by motion and by force: beyond it there is no static solution under a force."""
    for factor, plane, method in itertools.product((0.99, 1 - 1e-6, 1.0, 1 + 1e-6, 1.01, 1e4), (False, True), METHODS):
        layers(runs, "friction: limit of sliding", f"motion {factor:.9g}, {'plane' if plane else 'bodies'}", method, plane=plane,
               cells=(3, 3), path=((1, 1, 0), (2, 1, 0.3 * factor)), closing=1e-3 if factor < 2 else 1e-5)
    for factor, plane, method in itertools.product((0.5, 0.99, 1 - 1e-6, 1 - 1e-9, 1.0, 1 + 1e-6, 1.01, 2.0), (False, True),
                                                   METHODS):
        layers(runs, "friction: limit of sliding", f"force {factor:.10g}, {'plane' if plane else 'bodies'}", method, plane=plane,
               cells=(3, 3), force=True, path=((1, 1, 0), (2, 1, 0.3 * factor)),
               exists=factor <= (1 - 5e-4 if TOLERANCE[method] > 1e-4 else 1))  # a penetration makes p smaller
    for factor, method in itertools.product((0.99, 1.01), METHODS):
        layers(runs, "friction: limit of sliding", f"force {factor:g}, together with the press", method, cells=(3, 3), force=True,
               path=((1, 1, 0.3 * factor),), exists=factor <= 1)
        layers(runs, "friction: limit of sliding", f"force {factor:g}, 3D, across the axes", method,
               cells=(2, 2) if method == "direct elimination" else (2, 3), force=True, dim=3,
               path=((1, 1, 0), (2, 1, 0.18 * factor, 0.24 * factor)), exists=factor <= 1)


def lifts(runs):
    """Taken off and put down elsewhere: the traction begins anew."""
    for height, method in itertools.product((1e-9, 1e-4, 0.02), METHODS):
        for plane in (False, True):
            layers(runs, "friction: lift", f"by {height:g}, {'plane' if plane else 'bodies'}", method, plane=plane, cells=(3, 3),
                   path=((1, 1, 0), (2, 1, 0.2), (3, 0, 0.2), (4, 0, 0.2), (5, 0, -0.5), (6, 0, -0.5), (7, 1, -0.5), (8, 1, -0.3),
                         (9, 1, 0.3)),
                   lift=((3, 0), (4, height), (5, height), (6, 0), (9, 0)))
    for method in METHODS:
        layers(runs, "friction: lift", "never separates, to tension and back", method, cells=(3, 3), separates=False,
               path=((1, 1, 0), (2, 1, 0.2), (3, -1, 0.2), (4, -1, 0.5), (5, 1, 0.5), (6, 1, 0.6)))
        layers(runs, "friction: lift", "to a pressure of zero, and again", method, cells=(3, 3),
               path=((1, 1, 0), (2, 1, 0.2), (3, 0, 0.2), (4, 1, 0.2), (5, 1, 0.4)))


def models(runs):
    for model, degree, plane in itertools.product(("plane stress", "plane strain"), (1, 2), (False, True)):
        for method in METHODS:
            layers(runs, "friction: model", f"{model}, degree {degree}, {'plane' if plane else 'bodies'}", method, model=model,
                   degree=degree, plane=plane, cells=(3, 3))
    for degree, plane, method in itertools.product((1, 2), (False, True), METHODS):
        layers(runs, "friction: model", f"3D, degree {degree}, {'plane' if plane else 'bodies'}", method, dim=3, degree=degree,
               plane=plane,
               cells=(2, 2), path=((1, 1, 0), (2, 1, 0.15, 0.1), (3, 1, 0.6, 0.1), (4, 1, -0.3, 0.4)))


def rotations(runs):
    """The whole scene turned."""
    for degrees, plane, method in itertools.product((30, 90, 137, 180), (False, True), METHODS):
        if method in FEW or degrees == 30:
            layers(runs, "friction: rotation", f"{degrees} degrees, {'plane' if plane else 'bodies'}", method, plane=plane,
                   cells=(3, 3),
                   rotation=turn(2, degrees))
    tilted = multiply(turn(3, 40, 0), multiply(turn(3, 25, 1), turn(3, 70, 2)))
    for (name, rotation), plane, method in itertools.product((("tilted", tilted), ("90 about x", turn(3, 90, 0)),
                                                              ("180 about y", turn(3, 180, 1))),
                                                             (False, True), FEW):
        layers(runs, "friction: rotation", f"3D, {name}, {'plane' if plane else 'bodies'}", method, plane=plane, cells=(2, 2)
               if plane else (2, 3),
               dim=3, rotation=rotation, path=((1, 1, 0), (2, 1, 0.15, 0.1), (3, 1, 0.6, 0.1), (4, 1, -0.3, 0.4)))


def scales(runs):
    """Layers in any units."""
    for (length, stress), method in itertools.product(((1e3, 1e-3), (1e6, 1e-6), (1e-3, 1e6), (1e-6, 1e9), (1e-9, 1.0),
                                                       (1.0, 1e12), (1e4, 1e-9)),
                                                      METHODS):
        layers(runs, "friction: units", f"layers, length {length:g}, stress {stress:g}", method, length=length, cells=(3, 3),
               moduli=(1000.0 * stress, 1000.0 * stress))


def stacks(runs):
    """Aspect: thin and thick layers."""
    for heights, method in itertools.product(((1e-3, 1.0), (1.0, 1e-3), (1e-3, 1e-3), (100.0, 100.0)), FEW):
        layers(runs, "friction: aspect", f"heights {heights[0]:g} and {heights[1]:g}", method, heights=heights, across=(2, 2),
               closing=1e-3 * sum(heights) / 2)


def ranks(runs):
    for n, dim, method in itertools.product((2, 3), (2, 3), ("penalty", "Lagrange multiplier", "augmented Lagrangian",
                                                             "direct elimination")):
        cells = (3, 3) if method == "direct elimination" else (3, 4)
        layers(runs, "friction: ranks", f"{n}, {dim}D", method, ranks=n, dim=dim, cells=cells)
    layers(runs, "friction: ranks", "3, lift", "Lagrange multiplier", ranks=3,
           path=((1, 1, 0), (2, 1, 0.2), (3, 0, 0.2), (4, 0, 0.2), (5, 0, -0.5), (6, 0, -0.5), (7, 1, -0.5), (8, 1, -0.3)),
           lift=((3, 0), (4, 0.01), (5, 0.01), (6, 0), (8, 0)))


def series(runs):
    """A layer that only friction holds, between another one that is moved and a plane: the weaker of both surfaces slips."""
    for above, below, (dim, cells), method in itertools.product((0.1, 0.3, 3.0), (1e-3, 0.1, 0.3, 3.0),
                                                                ((2, (3, 4)), (2, (3, 3)), (3, (2, 3))), METHODS):
        # Of equal surfaces either may slip.
        if method not in fitting(METHODS if dim == 2 else FEW,
                                 cells) or cells == (3, 3) and method != "direct elimination" or above == below:
            continue
        if runs.skip("friction: series"):
            continue
        mu = min(above, below)
        case = Layers(mu=mu, dim=dim, cells=cells, method=method,
                      path=((1, 1, 0), (2, 1, 0.5 * mu), (3, 1, 3 * mu), (4, 1, 0.5 * mu)))
        scene = case.scene()
        base = scene.index("subsection Supports\n  subsection base")
        scene = scene[:base] + scene[scene.index("subsection Supports\n  subsection top"):]
        scene = scene.replace(", base, top", ", top").replace("set Names = p0",
                                                              "set Names = p0, p1").replace(f"Friction = {mu!r}", f"Friction = {above!r}")
        scene += section("Obstacles", Names="ground") + section("Obstacles/ground", Shape="plane")
        scene += section("Contact pairs/p1", Slave="low.bottom", Master="ground", Friction=repr(below))

        def error_of(results, case=case, mu=mu):
            worst = (0.0, "")
            for step, state in zip(results["load_steps"], case.states([step["time"] for step in results["load_steps"]])):
                for name, pair in step["pairs"].items():
                    for d, reference in enumerate([-one for one in state[1]][:case.dim - 1]):
                        worst = max(worst, (abs(pair["friction_force"][d] / case.p - reference) / mu,
                                            f"friction force of {name} at {step['time']:g}"))
                    worst = max(worst, (abs(pair["normal_force"] / case.p - state[0]),
                                        f"normal force of {name} at {step['time']:g}"))
            return worst

        judge(runs, "friction: series", f"{above:g} on {below:g}, {dim}D", method, scene, error_of, TOLERANCE[method])


def driven(runs):
    """A layer that is pressed on a plane which a force moves."""
    for factor, method in itertools.product((0.5, 0.99, 1.0, 1.01), METHODS):
        for dim in (2, 3) if method in FEW else (2,):
            if runs.skip("friction: driven plane"):
                continue
            case = Layers(dim=dim, cells=(3, 3), plane=True, plane_moves=False, force=True, method=method,
                          path=((1, 1, 0), (2, 1, 0.3 * factor)))
            scene = case.scene().replace("set Names = around, drive", "set Names = around")
            begin = scene.index("subsection Loads\n  subsection drive")
            scene = scene[:begin] + scene[scene.index("subsection Obstacles", begin):]
            free, zeros = "; ".join(["free"] + ["0"] * (dim - 1)), "; ".join(["0"] * (dim - 1))
            scene = scene.replace(f"    set Displacement = {zeros}; 0\n  end\nend\nsubsection Contact pairs",
                                  f"    set Displacement = {free}\n    set Force = -{case.k!r}*ux; {zeros}\n  end\nend\nsubsection Contact pairs")
            held_top = "free; " * (dim - 1) + f"-{case.closing * case.length!r}*press + lift"
            assert held_top in scene and "set Force" in scene
            scene = scene.replace("Displacement = " + held_top, "Displacement = " + held_top.replace("free", "0"))
            judge(runs, "friction: driven plane", f"force {factor:g}, {dim}D", method, scene, case.error, TOLERANCE[method],
                  exists=factor <= (1 - 5e-4 if TOLERANCE[method] > 1e-4 else 1))


# Scenes that are not uniform:


def blocks(dim=2, length=1.0, stress=1.0, motion=0.012, rotation=None, swap=False, cells=(12, 12), degree=1,
           method="Lagrange multiplier",
           flipped=False, moduli=(1000.0, 1000.0), mu=0.3, times="1, 2, 3, 4"):
    """Two blocks with a gap as that of a cylinder or a ball, pressed, moved there and back with partial slip.

    @param flipped: turned upside down, the gap and the motions too, so that with `swap` all is a mirror image
    """
    rotation = rotation or unit(dim)
    home = [combination(row, "xyz"[:dim]) for row in transposed(rotation)]
    square = " + ".join(f"({one})^2" for one in home[:-1])
    text = f"set Dimension = {dim}\n" + section("Definitions", q=f"{motion * length!r}*table(t, 1,0, 2,1, 3,0.5, 4,-1)",
                                                d=f"{0.02 * length!r}*min(t, 1)", w=f"{0.1 / length!r}*({square})")
    text += section("Bodies", Names="low, up")
    sign = -1 if flipped else 1
    for name, n, (bottom, top), modulus in zip(("low", "up"), cells, ((-1, 0), (0, 1)), moduli):
        bottom, top = sorted((sign * bottom, sign * top))
        side = [length] * (dim - 1)
        corners = ",".join(map(repr,
                               [-one for one in side] + [bottom * length])) + " : " + ",".join(map(repr, side + [top * length]))
        values = {"Corners": corners, "Subdivisions": ",".join([str(n)] * (dim - 1) + [str(max(1, n // 3))])}
        if rotation != unit(dim):
            values["Transformation"] = "; ".join(combination(row, "xyz"[:dim]) for row in rotation)
        text += section(f"Bodies/{name}", **{**values, "Young's modulus": repr(modulus * stress), "Poisson's ratio": 0.3})
    faces = {name: ("bottom", "top") if name == ("low" if not flipped else "up") else ("top", "bottom") for name in ("low", "up")}
    outer, inner = {name: one[0] for name, one in faces.items()}, {name: one[1] for name, one in faces.items()}
    motions = [["q"] + ["0"] * (dim - 2) + [f"{-sign}*d"], ["0"] * dim]
    text += section("Supports", Names="base, top")
    text += section("Supports/base", Boundaries=f"low.{outer['low']}", Displacement="; ".join("0" * dim))
    text += section("Supports/top", Boundaries=f"up.{outer['up']}",
                    Displacement="; ".join(combination(row, motions[0]) for row in rotation))
    slave, master = ("low", "up") if swap else ("up", "low")
    text += section("Contact pairs", Names="p0")
    text += section("Contact pairs/p0", Slave=f"{slave}.{inner[slave]}", Master=f"{master}.{inner[master]}", Initial_gap="w",
                    Friction=mu,
                    Slave_choice="as named")
    text += section("Mesh", Degree=degree) + section("Load steps", Times=times)
    return text + section("Contact method", **{"Contact geometry": "reference"}) + chosen(method)


def numbers(results, rotation, length, stress, mirrored=1.0, dim=2, swap=False):
    """What images of a scene must share, in its own units: of all load steps, each relative to its scale."""
    rows = []
    for step in results["load_steps"]:
        pair = step["pairs"]["p0"]
        force, area = stress * length ** (dim - 1), length ** (dim - 1)
        sides = -1 if swap else 1
        friction = [sides * one / force for one in dot(transposed(rotation), pair["friction_force"])]
        rows.append([pair["normal_force"] / force, friction[0] * mirrored * 3, *(one * 3 for one in friction[1:-1]),
                     pair["max_pressure"] / stress / 2,
                     pair["total_friction_work"] / force / length * 100, pair["max_slip_since_contact"] / length * 1e3,
                     pair["stick_area"] / area * 10])
    return rows


def images(runs):
    """A scene with partial slip against scaled, turned, mirrored, exchanged and distributed ones."""
    for dim, method in itertools.product((2, 3), METHODS):
        if dim == 3 and method not in FEW:
            continue
        cells = (6, 6) if dim == 3 else (12, 12) if method == "direct elimination" else (12, 17)
        same = (12, 12) if dim == 2 else (6, 6)
        cases = [(f"length {length:.3g}, stress {stress:.3g}", dict(length=length, stress=stress), 1)
                 for length, stress in ((2.0 ** -30, 2.0 ** 37), (2.0 ** 20, 2.0 ** -40), (1e-6, 1e6), (1e3, 1e9))]
        cases += [("mirrored", dict(motion=-0.012), 1)]
        cases += [(f"turned by {degrees}", dict(rotation=turn(dim, degrees)), 1) for degrees in (90, 45, 200)] if dim == 2 else \
            [("turned by 90 about z", dict(rotation=turn(3, 90, 2)), 1),
             ("turned by 50 about x", dict(rotation=turn(3, 50, 0)), 1)]
        cases += [("exchanged", dict(flipped=True, swap=True, cells=same), 1), ("2 ranks", {}, 2), ("3 ranks", {}, 3)]
        bases = {}
        for name, parameters, number in cases:
            if runs.skip("friction: images"):
                continue
            parameters = {"cells": cells, **parameters}
            key = parameters["cells"]
            if key not in bases:
                code, reason, results = runs.start(blocks(dim=dim, method=method, cells=key), {})
                bases[key] = numbers(results, unit(dim), 1.0, 1.0, dim=dim) if code == 0 else None
                if code != 0:
                    runs.add("friction: images", f"{dim}D, at rest", method, "refused" if code in (2, 3) else "wrong", None,
                             reason,
                             scene=blocks(dim=dim, method=method, cells=key), ranks=1, exists=True, newton=None, steps=None)
            if bases[key] is None:
                continue
            base = bases[key]

            def error_of(results, base=base, parameters=parameters):
                rows = numbers(results, parameters.get("rotation") or unit(dim), parameters.get("length", 1.0),
                               parameters.get("stress", 1.0),
                               -1.0 if parameters.get("motion", 1) < 0 else 1.0, dim, parameters.get("swap", False))
                if len(rows) != len(base):
                    return 1.0, f"{len(rows)} load steps instead of {len(base)}"
                names = ("normal force", "friction force", *(["friction force y"] if dim == 3 else []), "pressure", "work",
                         "slip", "stick area")
                scales = [max(abs(row[i]) for row in base) or 1.0 for i in range(len(names))]
                if dim == 3:
                    scales[2] = scales[1]
                return max((abs(a - b) / scale, f"{name} at step {i + 1}") for i, (row, of_base) in enumerate(zip(rows, base))
                           for name, a, b, scale in zip(names, row, of_base, scales))

            judge(runs, "friction: images", f"{dim}D, {name}", method, blocks(dim=dim, method=method, **parameters), error_of,
                  1e-7, number,
                  excused=False)


def fixed(name, method, replacements=(), folder="scenes"):
    """A scene of the tests with some lines exchanged."""
    scene = (program.ROOT / "tests" / folder / f"{name}.prm").read_text()
    scene = scene[:scene.index("subsection Expected results")] if "subsection Expected results" in scene else scene
    for before, after in replacements:
        if before not in scene:
            raise SystemExit(f"{name}.prm has no '{before}'")
        scene = scene.replace(before, after)
    return scene + chosen(method)


def rings(runs):
    """Shrink fits under torque (stick: 4.818348e8 phi; slip: 2 pi 30^2 mu p) and under axial pull, by Lame and torsion of rings."""
    pressure, stiffness = 84.53085, 4.818348e8
    ends = (("outer slave", ()), ("inner slave", (("= outer.inner", "= inner.outer#"), ("= inner.outer\n", "= outer.inner\n"),
                                                  ("outer#", "outer"))))
    cells = (("24:32", ()), ("24:24", (("Cells around    = 32", "Cells around = 24"),)),
             ("24:168", (("Cells around    = 32", "Cells around = 168"),)))
    for mu, (side, exchange), (mesh, around) in itertools.product((1e-6, 0.15, 3.0), ends, cells):
        for method in FEW if mesh != "24:24" else METHODS:
            if method == "direct elimination" and mesh != "24:24":
                continue
            if runs.skip("friction: rings"):
                continue
            sign = 1 if side == "outer slave" else -1

            def error_of(results, mu=mu, sign=sign):
                limit, worst, torque, last = 2 * math.pi * 900 * mu * pressure, (0.0, ""), 0.0, 0.0
                for step in results["load_steps"]:
                    t = step["time"]
                    phi = max(0, (t - 1) * 3e-4) if t <= 2 else 3e-4 - (t - 2) * 2e-4
                    torque = max(-limit, min(limit, torque + stiffness * (phi - last)))
                    last = phi
                    scale = max(min(limit, stiffness * 3e-4), 2 * math.pi * 900 * pressure * 1e-3)
                    moment = step["pairs"]["fit"]["moment"][0]
                    worst = max(worst, (abs(-sign * moment - torque) / scale, f"torque at {t:g}"))
                return worst

            judge(runs, "friction: rings", f"mu {mu:g}, {mesh} cells, {side}", method,
                  fixed("friction-ring", method, ((" = 0.15", f" = {mu!r}"), *exchange, *around)), error_of,
                  max(1e-3, TOLERANCE[method]))
    for mu, (mesh, lengths), (side, exchange) in itertools.product(
            (1e-6, 0.15, 3.0), (("4:5", ()), ("5:5", (("= 6,4", "= 6,5"),)), ("1:7", (("= 6,4", "= 6,1"), ("= 8,5", "= 8,7")))),
            (("outer slave", ()), ("inner slave", (("= outer.left", "= inner.right#"), ("= inner.right\n", "= outer.left\n"),
                                                   ("right#", "right"))))):
        for method in FEW if mesh != "5:5" else METHODS:
            if runs.skip("friction: axisymmetric"):
                continue
            sign = 1 if side == "outer slave" else -1

            def error_of(results, mu=mu, sign=sign):
                limit, worst, pull, last = 2 * math.pi * 300 * mu * 76.92308, (0.0, ""), 0.0, 0.0
                for step in results["load_steps"]:
                    t = step["time"]
                    w = max(0, (t - 1) * 0.002) if t <= 2 else 0.002 + (t - 2) * 0.004
                    pull = max(-limit, min(limit, pull + 7748121 * (w - last)))
                    last = w
                    force = step["pairs"]["fit"]["friction_force"][1]
                    # The fields of Lame are not those of the elements: shear stresses of 1e-8 of the pressure.
                    scale = max(min(limit, 7748121 * 0.006), 2 * math.pi * 300 * 76.92308 * 1e-3)
                    worst = max(worst, (abs(sign * force - pull) / scale, f"pull at {t:g}"))
                return worst

            judge(runs, "friction: axisymmetric", f"mu {mu:g}, {mesh} cells, {side}", method,
                  fixed("friction-pull", method, ((" = 0.15", f" = {mu!r}"), *lengths, *exchange)), error_of,
                  max(2e-4, TOLERANCE[method]))


BOX = ("subsection Bodies\n  set Names = up\n  subsection up\n    set Corners = {corners}\n    set Subdivisions = {cells}\n    set Young's modulus = 1000\n"
       "    set Poisson's ratio = 0.3\n  end\nend\n")


def incline(slope, mu, dim, method, axis=0, degree=1):
    """A plate under its weight on an inclined plane."""
    size = math.hypot(1, slope)
    corners = "-2,0 : 2,1" if dim == 2 else "-2,-2,0 : 2,2,1"
    force = [0.0] * dim
    force[axis], force[-1] = slope / size, -1 / size
    text = f"set Dimension = {dim}\n" + BOX.format(corners=corners, cells="8,2" if dim == 2 else "4,4,1")
    text += section("Loads", Names="weight") + section("Loads/weight", Bodies="up", Body_force="; ".join(map(repr, force)))
    text += section("Obstacles", Names="ground") + section("Obstacles/ground", Shape="plane",
                                                           Normal=",".join(["0"] * (dim - 1) + ["1"]))
    text += section("Contact pairs", Names="p0") + section("Contact pairs/p0", Slave="up.bottom", Master="ground",
                                                           Friction=repr(mu))
    return text + section("Mesh", Degree=degree) + chosen(method)


def clamped(weight, mu, dim, method):
    """A cube between jaws that friction alone keeps from falling."""
    corners = "0,0 : 1,1" if dim == 2 else "0,0,0 : 1,1,1"
    zeros, ones = ["0"] * (dim - 1), ["1"] + ["0"] * (dim - 1)
    text = f"set Dimension = {dim}\n" + BOX.format(corners=corners, cells=",".join(["4"] * dim))
    text += section("Loads", Names="weight")
    text += section("Loads/weight", Bodies="up", Body_force="; ".join(zeros + [f"-{weight!r}*max(0, t - 1)"]))
    text += section("Obstacles", Names="j0, j1")
    text += section("Obstacles/j0", Shape="plane", Normal=",".join(ones), Displacement="; ".join(["0.005*min(t, 1)"] + zeros))
    text += section("Obstacles/j1", Shape="plane", Point=",".join(ones), Normal="-" + ",".join(ones),
                    Displacement="; ".join(["-0.005*min(t, 1)"] + zeros))
    text += section("Contact pairs", Names="p0, p1")
    for i, side in enumerate(("left", "right")):
        text += section(f"Contact pairs/p{i}", Slave=f"up.{side}", Master=f"j{i}", Friction=repr(mu))
    return text + section("Load steps", Times="1, 2") + chosen(method)


def held(runs):
    """Bodies that friction alone holds: resultants by equilibrium."""
    def forces(expected, scale):
        def error_of(results):
            pairs = results["load_steps"][-1]["pairs"].values()
            total = [sum(pair["force"][d] for pair in pairs) for d in range(len(expected))]
            return max(abs(a - b) for a, b in zip(total, expected)) / scale, "force"
        return error_of

    for ratio, mu, method in itertools.product((0.0, 0.5, 0.9, 0.99, 0.999, 1.01, 2.0), (0.1, 0.5), METHODS):
        if runs.skip("friction: incline"):
            continue
        slope = ratio * mu
        size = math.hypot(1, slope)
        judge(runs, "friction: incline", f"slope {ratio:g} mu, mu {mu:g}", method, incline(slope, mu, 2, method),
              forces([-4 * slope / size, 4 / size], 4.0), 1e-6, exists=ratio <= 1)
    for ratio, axis, degree, method in itertools.product((0.5, 0.9, 1.01), (0, 1), (1, 2), FEW):
        if runs.skip("friction: incline"):
            continue
        slope = ratio * 0.3
        size = math.hypot(1, slope)
        expected = [0.0, 0.0, 16 / size]
        expected[axis] = -16 * slope / size
        judge(runs, "friction: incline", f"slope {ratio:g} mu along {'xy'[axis]}, 3D, degree {degree}", method,
              incline(slope, 0.3, 3, method, axis, degree), forces(expected, 16.0), 1e-6, exists=ratio <= 1)
    for weight, mu, dim, method in itertools.product((0.1, 2.0, 4.0, 50.0), (0.3, 3.0), (2, 3), METHODS):
        if dim == 3 and method not in FEW or runs.skip("friction: clamp"):
            continue
        # The normal force of a side is between those of free and of confined cross-sections, 10 and 13.5.
        most = 2 * mu * 13.5
        judge(runs, "friction: clamp", f"weight {weight:g}, mu {mu:g}, {dim}D", method, clamped(weight, mu, dim, method),
              forces([0.0] * (dim - 1) + [weight], weight), 1e-6, exists=weight < most)


def finite(shear, turn_by, steps, dim, mu, method, degree=1, plane="xz"):
    """Neo-Hookean blocks, pressed and sheared with their ends held, then turned as a whole."""
    text = f"set Dimension = {dim}\nset Deformation = finite\n"
    last = "y" if dim == 2 else "z"
    text += section("Definitions", L="0.1*min(t, 1)", U=f"{shear!r}*min(max(t - 1, 0), 1)", a=f"{turn_by!r}*pi/180*max(t - 2, 0)",
                    b=f"if({last} > 1, 1, 0)")
    text += section("Bodies", Names="low, up")
    for name, bottom, n in (("low", 0, 4), ("up", 1, 4 if method == "direct elimination" else 3)):
        low, high = ["0"] * (dim - 1) + [str(bottom)], ["1"] * (dim - 1) + [str(bottom + 1)]
        cells = [str(n if dim == 2 else n - 1)] * (dim - 1) + ["2"]
        text += section(f"Bodies/{name}", Corners=",".join(low) + " : " + ",".join(high), Subdivisions=",".join(cells),
                        **{"Young's modulus": 1, "Poisson's ratio": 0.3})
    # Places before the turn.
    places = ["(x + b*U)", f"({last} - b*L)"] if dim == 2 else ["(x + b*U)", "y", "(z - b*L)"]
    i, j = (0, 1) if dim == 2 else {"xz": (0, 2), "xy": (0, 1), "yz": (1, 2)}[plane]
    turned = list(places)
    turned[i], turned[j] = f"cos(a)*{places[i]} - sin(a)*{places[j]}", f"sin(a)*{places[i]} + cos(a)*{places[j]}"
    text += section("Supports", Names="ends")
    text += section("Supports/ends", Boundaries="low.bottom, up.top",
                    Displacement="; ".join(f"{one} - {axis}" for one, axis in zip(turned, "xyz")))
    text += section("Contact pairs", Names="p0") + section("Contact pairs/p0", Slave="up.bottom", Master="low.top",
                                                           Friction=repr(mu))
    times = [0.5, 1, 1.5, 2] + [2 + (k + 1) / steps for k in range(steps)]
    text += section("Mesh", Degree=degree) + section("Load steps", Times=", ".join(map(repr, times)))
    return text + chosen(method)


def turns(runs):
    """Bodies turned as a whole: forces turn with them, slip and work stay."""
    cases = [(angle, steps, 2, 1, "xy") for angle, steps in ((90, 1), (90, 4), (180, 2), (180, 8), (360, 8), (-720, 16))]
    cases += [(90, 2, 2, 2, "xy"), (90, 4, 3, 1, "xz"), (180, 4, 3, 1, "yz"), (180, 4, 3, 1, "xy")]
    for (angle, steps, dim, degree, plane), (shear,
                                             mu), method in itertools.product(cases, ((0.01, 0.3), (0.06, 0.3), (0.06, 0.05), (0.06, 3.0)), METHODS):
        if method not in FEW and (angle, steps) not in ((90, 4), (180, 2)) or runs.skip("friction: turn"):
            continue

        def error_of(results, angle=angle, dim=dim, plane=plane):
            base, worst = None, (0.0, "")
            i, j = (0, 1) if dim == 2 else {"xz": (0, 2), "xy": (0, 1), "yz": (1, 2)}[plane]
            for step in results["load_steps"]:
                pair, t = step["pairs"]["p0"], step["time"]
                if t < 2 - 1e-9:
                    continue
                a = math.radians(angle) * (t - 2)
                force, friction = list(pair["force"]), list(pair["friction_force"])
                for one in (force, friction):
                    one[i], one[j] = math.cos(a) * one[i] + math.sin(a) * one[j], math.cos(a) * one[j] - math.sin(a) * one[i]
                now = {**{f"force {d}": (force[d], 1) for d in range(dim)},
                       **{f"friction force {d}": (friction[d], 2) for d in range(dim)},
                       "pressure": (pair["max_pressure"], 3), "slip": (pair["max_slip_since_contact"], 4),
                       "work": (pair["total_friction_work"], 5)}
                if base is None:
                    base = now
                    size = math.hypot(*force)
                    scales = {1: size, 2: size, 3: pair["max_pressure"], 4: 0.06, 5: size * 0.06}
                for name, (value, kind) in now.items():
                    worst = max(worst, (abs(value - base[name][0]) / scales[kind], f"{name} at {t:g}"))
            return worst

        judge(runs, "friction: turn",
              f"{angle} degrees in {steps} steps, {dim}D, degree {degree}, {plane}, shear {shear:g}, mu {mu:g}", method,
              finite(shear, angle, steps, dim, mu, method, degree, plane), error_of, 1e-6, excused=False)


def obstacles(runs):
    """A plane that moves far, in small and large deformation; other shapes; turning cylinders."""
    for distance, n, geometry, dim, method in itertools.product((1.0, 1e3), (1, 10), ("reference", "updated"), (2, 3),
                                                                FEW + ("direct elimination",)):
        motion = distance / (Layers(plane=True).p / Layers(plane=True).k)
        path = ((1, 1, 0), (2, 1, motion), (3, 1, 0.0))
        times = [1, *(1 + (i + 1) / n for i in range(2 * n))]
        layers(runs, "friction: obstacle", f"plane, {dim}D, {geometry}, moves by {distance:g} in {n}", method, plane=True,
               dim=dim, cells=(2, 2),
               path=path if dim == 2 else [(*row, 0.75 * row[2]) for row in path], times=times, geometry=geometry)
    for method in METHODS:
        # A gap function that is a plane.
        if not runs.skip("friction: obstacle"):
            case = Layers(plane=True, cells=(3, 3), method=method)
            scene = case.scene().replace("    set Shape = plane\n    set Point = 0,0\n",
                                         "    set Shape = gap function\n    set Gap = y\n")
            judge(runs, "friction: obstacle", "gap function", method, scene, case.error, TOLERANCE[method])
    # A ring on a shaft that turns: torsion, then 2 pi r^2 mu p.
    for hollow, mu, finite_turn, method in itertools.product((False, True), (0.15, 1.0), (False, True), METHODS):
        if runs.skip("friction: shaft"):
            continue
        judge(runs, "friction: shaft", f"{'hollow' if hollow else 'full'}, mu {mu:g}{', turned by 2 pi' if finite_turn else ''}",
              method,
              *shaft(hollow, mu, finite_turn, method), max(1e-3, TOLERANCE[method]))


def shaft(hollow, mu, finite_turn, method):
    """A ring 1 < r < 2 whose bore is held by a rigid shaft (or whose outer side by a rigid seat) that is too large (small)."""
    overlap, modulus, nu = 1e-5, 1000.0, 0.3
    g = modulus / 2 / (1 + nu)
    radius, other = (2.0, 1.0) if hollow else (1.0, 2.0)
    # u_r = A r + B/r: given at the radius, no stress at the other one (plane strain).
    # sigma_r = 2 g (A/(1 - 2 nu) - B/r^2)
    ratio = other ** 2 / (1 - 2 * nu)  # B = ratio A
    a = (-overlap if hollow else overlap) / (radius + ratio / radius)
    pressure = -2 * g * (a / (1 - 2 * nu) - ratio * a / radius ** 2)
    free = a * other + ratio * a / other
    stiffness = 4 * math.pi * g / (1 - 0.25)
    limit = 2 * math.pi * radius ** 2 * mu * pressure
    slips = limit / stiffness
    last = 2 * math.pi if finite_turn else 3 * slips
    text = "set Dimension = 2\n" + section("Definitions",
                                           phi=f"table(t, 1,0, 2,{0.5 * slips!r}, 3,{last!r}, 4,{last - 1.5 * slips!r})",
                                           r="sqrt(x^2 + y^2)")
    text += section("Bodies", Names="ring")
    text += section("Bodies/ring", Mesh="ring", Inner_radius=1, Outer_radius=2, Cells_around=24, Cells_through=4,
                    **{"Young's modulus": modulus, "Poisson's ratio": nu})
    text += section("Supports", Names="far")
    text += section("Supports/far", Boundaries="ring.inner" if hollow else "ring.outer",
                    Displacement=f"{free!r}*min(t, 1)*x/r; {free!r}*min(t, 1)*y/r")
    text += section("Obstacles", Names="shaft")
    text += section("Obstacles/shaft", Shape="cylinder", Radius=radius + (-overlap if hollow else overlap), Hollow="yes"
                    if hollow else "no",
                    Rotation="phi")
    text += section("Contact pairs", Names="fit")
    text += section("Contact pairs/fit", Slave="ring.outer" if hollow else "ring.inner", Master="shaft", Friction=mu,
                    Interference_ramp="min(t, 1)")
    text += section("Mesh", Degree=2) + section("Load steps", Times="1, 2, 3, 4") + chosen(method)

    def error_of(results):
        worst, torque, before = (0.0, ""), 0.0, 0.0
        for step in results["load_steps"]:
            t = step["time"]
            phi = (0.0 if t <= 1 else (t - 1) * 0.5 * slips if t <= 2 else 0.5 * slips + (t - 2) * (last - 0.5 * slips) if t <= 3
                   else last - (t - 3) * 1.5 * slips)
            torque = max(-limit, min(limit, torque + stiffness * (phi - before)))
            before = phi
            pair = step["pairs"]["fit"]
            worst = max(worst, (abs(pair["moment"][0] - torque) / limit, f"torque at {t:g}"),
                        (abs(pair["normal_force"] / (2 * math.pi * radius * pressure * min(t, 1)) - 1), f"normal force at {t:g}"))
        return worst

    return text, error_of


AXES = (coefficients, limits, load_steps, contrast, poisson, meshes, reversals, formulas, loads, sliding, lifts, models,
        rotations,
        scales, stacks, ranks, series, driven, images, rings, held, turns, obstacles)
