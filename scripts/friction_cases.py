# SPDX-License-Identifier: Apache-2.0
"""The reference cases of Coulomb friction: scenes, quantities, references. scripts/measure-friction runs them.

References: closed forms (Cattaneo and Mindlin, Nowell and Hills, Spence, Ciavarella, Euler and Eytelwein, Lame), published benchmarks
(M. Raous et al. 1988; NAFEMS CGS-4 and contact benchmark 1, A. Konter 2006; SSNV503), and other finite elements of degree 2 where the size
of a body matters ("box").
"""

import math
from dataclasses import dataclass, field

import vtu


@dataclass
class Quantity:
    name: str
    reference: float
    value: object  # function of a Solution
    tolerance: float = 0.01  # relative; of the reference or its mesh, for multipliers


@dataclass
class Run:
    """A scene (the name of one of tests/scenes, or sections as dictionaries), with keys that are changed, and what it has to give."""
    case: str
    label: str
    scene: object
    quantities: list
    keys: dict = field(default_factory=dict)
    fields: bool = False  # whether quantities need the files of Output/VTU
    slow: bool = False


class Solution:
    """What a run left: results.json, and contact_*.vtu of its load steps."""

    def __init__(self, results, folder):
        self.results, self.folder, self.steps = results, folder, results["load_steps"]

    def at(self, time):
        return min(self.steps, key=lambda step: abs(step["time"] - time))

    def pair(self, name, time=math.inf):
        return (self.steps[-1] if time == math.inf else self.at(time))["pairs"][name]

    def probe(self, name, time=math.inf):
        return (self.steps[-1] if time == math.inf else self.at(time))["probes"][name]

    def work(self, pair, after):
        return sum(step["pairs"][pair]["friction_work"] for step in self.steps if step["time"] > after + 1e-9)

    def traction(self, axis, time, x=0.0):
        """Tangential traction at the point of contact.pvd that is nearest to x, of the load step that ends at a time."""
        files = vtu.steps(self.folder / "contact.pvd")
        file = min(files, key=lambda entry: abs(entry[0] - time))[1]
        points, values = surface(file, "tangential_traction")
        return values[abs(points[:, 0] - x).argmin(), axis]


def surface(path, name):
    """Points of a .pvtu of lines, and a field there."""
    import numpy
    from xml.etree import ElementTree
    root = ElementTree.parse(path).getroot()
    pieces = [path.parent / piece.get("Source") for piece in root.iter("Piece")] if root.get("type").startswith("P") else [path]
    points, values = [], []
    for file in pieces:
        piece_root = ElementTree.parse(file).getroot()
        for piece in piece_root.iter("Piece"):
            if int(piece.get("NumberOfCells")):
                points.append(vtu.read_array(piece.find("Points")[0], piece_root))
                arrays = {array.get("Name"): array for array in piece.findall("PointData/DataArray")}
                values.append(vtu.read_array(arrays[name], piece_root))
    return numpy.concatenate(points), numpy.concatenate(values)


# Scenes as dictionaries: a dictionary is a section.


def named(**sections):
    """A section of sections with names of their own; _ in a name stands for a space."""
    sections = {name.replace("_", " "): section for name, section in sections.items()}
    return {"Names": ", ".join(sections), **sections}


def text(scene, depth=0):
    """The .prm text of a scene."""
    lines = []
    for key, value in scene.items():
        if isinstance(value, dict):
            lines += [f"subsection {key}", text(value, depth + 1).rstrip("\n"), "end"]
        else:
            lines.append(f"set {key} = {value}")
    return "".join(f"{'  ' if depth else ''}{line}\n" for block in lines for line in block.split("\n"))


def box(corners, cells, youngs_modulus, poissons_ratio, **more):
    return {"Mesh": "box", "Corners": corners, "Subdivisions": cells, "Young's modulus": youngs_modulus, "Poisson's ratio": poissons_ratio,
            **{key.replace("_", " "): value for key, value in more.items()}}


def squares(x, y, size, least, levels, name="near"):
    """Refinement regions about (x, y), one a level: squares of half-width size, half of it, ..., but not below the least."""
    widths = [max(size / 2**n, least) for n in range(levels)]
    return {f"{name}_{n}": {"Inside": f"if(max(abs(x - {x!r}), abs(y - {y!r})) < {width!r}, 1, -1)", "Levels": 1}
            for n, width in enumerate(widths)}


def numbered(times):
    return {"Times": ", ".join(f"{time:g}" for time in times)}


def in_words(number):
    """Of load steps."""
    return f"{number} step{'' if number == 1 else 's'}"


# PF-01, 02, 04, 13, 14, 16: the scenes of the tests.


def patches():
    turned = {"x": (0, -0.04807692308 * math.cos(math.pi / 6)), "y": (1, -0.04807692308 * 0.5), "z": (2, 0.240005381988)}
    return [
        Run("PF-01", "patch, turn of slip, 1 step a leg", "friction-patch",
            [Quantity("traction x", 0.27570607, lambda s: s.pair("interface")["friction_force"][0], 1e-6),
             Quantity("traction y", -0.53290352, lambda s: s.pair("interface")["friction_force"][1], 1e-6),
             Quantity("traction x, second leg", -0.51961524, lambda s: s.pair("interface", 3)["friction_force"][0], 1e-6),
             Quantity("traction y, second leg", -0.3, lambda s: s.pair("interface", 3)["friction_force"][1], 1e-6)]),
        Run("PF-01", "patch, turn of slip, 20 steps a leg", "friction-patch",
            [Quantity("traction x", 0.3144143229, lambda s: s.pair("interface")["friction_force"][0], 1e-6),
             Quantity("traction y", -0.5110221459, lambda s: s.pair("interface")["friction_force"][1], 1e-6),
             Quantity("work", 0.0013114987, lambda s: s.pair("interface")["total_friction_work"], 0.01)], {"Load steps/Number": 80}),
        Run("PF-01", "patch, turn of slip, automatic steps", "friction-patch",
            [Quantity("traction x", 0.3208384848, lambda s: s.pair("interface")["friction_force"][0], 0.02),
             Quantity("traction y", -0.5070134778, lambda s: s.pair("interface")["friction_force"][1], 0.02),
             Quantity("work", 0.0013114987, lambda s: s.pair("interface")["total_friction_work"], 0.02)],
            {"Load steps/Number": "automatic"}),
        Run("PF-02", "finite, sheared and turned by 360 degrees", "friction-turned",
            [Quantity(f"force {name}", reference, lambda s, axis=axis: s.pair("interface")["force"][axis], 1e-6)
             for name, (axis, reference) in turned.items()] +
            [Quantity("largest slip", 0, lambda s: s.pair("interface")["max_slip_since_contact"], 1e-6)]),
        Run("PF-04", "layer, one and a half cycles", "friction-cycles",
            [Quantity("force x", 90, lambda s: s.pair("foot")["friction_force"][0], 1e-6),
             Quantity("force y", 120, lambda s: s.pair("foot")["friction_force"][1], 1e-6),
             Quantity("work", 16.875, lambda s: s.pair("foot")["total_friction_work"], 1e-6)]),
    ]


def incline():
    """PF-03: a block of weight 100 on a slope of tan a = 0.1, at rest, pulled along the slope, pushed horizontally (NAFEMS CGS-4)."""
    cosine, sine = 1 / math.sqrt(1.01), 0.1 / math.sqrt(1.01)
    block = box("-10,0 : 10,4", "10,2", 1e5, 0.3, Transformation=f"x*{cosine!r} - y*{sine!r}; x*{sine!r} + y*{cosine!r}")

    def scene(supports):
        return {
            "Dimension": 2, "Title": "block on an incline", "Bodies": named(block=block),
            "Obstacles": named(slope={"Shape": "plane", "Point": "0,0", "Normal": f"{-sine!r},{cosine!r}"}),
            "Loads": named(weight={"Bodies": "block", "Body force": "0; -100/80"}),
            **({"Supports": supports} if supports else {}),
            "Contact pairs": named(foot={"Slave": "block.bottom", "Master": "slope", "Friction": 0.3}),
        }

    def pulled(x, y, way):
        return scene(named(pull={"Boundaries": "block.top", "Type": "roller", "Direction": f"{x!r},{y!r}",
                                 "Normal displacement": f"{way}*t"}))

    def reaction(s):
        return math.hypot(*s.steps[-1]["supports"]["pull"]["reaction"])

    runs = [Run("PF-03", "at rest, held by friction alone", scene(None), [
        Quantity("normal force", 99.50371902, lambda s: s.pair("foot")["normal_force"], 1e-6),
        Quantity("friction force", 9.950371902, lambda s: math.hypot(*s.pair("foot")["friction_force"]), 1e-6)])]
    for label, x, y, way, force in (("pulled up", cosine, sine, 0.01, 39.80148761), ("let down", cosine, sine, -0.01, 19.9007438),
                                    ("pushed up horizontally, CGS-4", 1.0, 0.0, 0.01, 41.2371134),
                                    ("pushed down horizontally", 1.0, 0.0, -0.01, 19.41747573)):
        runs.append(Run("PF-03", label, pulled(x, y, way), [Quantity("force", force, reaction, 1e-6)]))
    runs.append(Run("PF-03", "pulled up, 5 steps", pulled(cosine, sine, 0.01), [Quantity("force", 39.80148761, reaction, 1e-6)],
                    {"Load steps/Number": 5}))
    return runs


def bar():
    """PF-05: a bar, 60 long and 1 high, is pressed on a rough plane and pulled at its end, and relieved; then cycles of +-60."""
    def scene(cells, pull, times):
        return {
            "Dimension": 2, "Title": "bar on a rough foundation", "Definitions": {"pull": pull},
            "Bodies": named(bar=box("0,0 : 60,1", cells, 1e5, 0, Degree=2)),
            "Obstacles": named(ground={"Shape": "plane", "Point": "0,0", "Normal": "0,1"}),
            "Supports": named(end={"Boundaries": "bar.right", "Displacement": "0; free"}, corner={"Point": "60,0", "Displacement": "0; 0"}),
            "Loads": named(above={"Boundaries": "bar.top", "Pressure": "5*min(t, 1)"},
                           pull={"Boundaries": "bar.left", "Traction": "-pull; 0"}),
            "Contact pairs": named(foot={"Slave": "bar.bottom", "Master": "ground", "Friction": 0.4}),
            "Load steps": numbered(times),
            "Output": {"Probes": named(face={"Point": "0,0", "End": "0,1", "Points": 41})},
        }

    def face(s, time):
        values = [point["displacement"][0] for point in s.probe("face", time)]
        return sum((1 if n in (0, 40) else 4 if n % 2 else 2) * value for n, value in enumerate(values)) / 120

    once, cycle = "60*table(t, 1,0, 2,1, 3,0)", "60*table(t, 1,0, 2,1, 3,0, 4,-1, 5,0, 6,1)"
    runs = []
    for cells in ("120,4", "240,6"):
        runs.append(Run("PF-05", f"bar, {cells} cells, load and unload", scene(cells, once, (1, 2, 3)), [
            Quantity("end displacement", -0.0088877, lambda s: face(s, 2) - face(s, 1), 2e-3),
            Quantity("after unloading", -0.0043778, lambda s: face(s, 3) - face(s, 1), 4e-3),
            Quantity("slip length (bar theory)", 30, lambda s: s.pair("foot", 2)["slip_area"], 0.06),
            Quantity("reversed slip length (bar theory)", 15, lambda s: s.pair("foot", 3)["slip_area"], 0.06)]))
    runs.append(Run("PF-05", "bar, 120,4 cells, cycle", scene("120,4", cycle, (1, 2, 3, 4, 5, 6)), [
        Quantity("work of a cycle (bar theory)", 0.72, lambda s: s.work("foot", 2), 0.05)]))
    return runs


# PF-06, 07, 08, 12: two equal blocks, of which one has a curved surface, as a gap.


def blocks(gap, levels, supports, loads, load_steps, definitions, zone=1.3, title="partial slip"):
    """As tests/scenes/friction-mindlin.prm: cells of 2 / 2^(2 + levels) at the contact."""
    scene = {
        "Dimension": 2, "Title": title, "Definitions": definitions,
        "Bodies": named(lower=box("-20,-20 : 20,0", "20,10", 2e5, 0.3), upper=box("-20,0 : 20,20", "20,10", 2e5, 0.3)),
        "Mesh": {"Degree": 2, "Refinement regions": named(
            near={"Inside": "if(max(abs(x), abs(y)) < 4, 1, -1)", "Levels": 2},
            contact={"Inside": f"if(max(abs(x), abs(y)) < {zone}, 1, -1)", "Levels": levels})},
        "Supports": supports, "Loads": loads,
        "Contact pairs": named(interface={"Slave": "upper.bottom", "Master": "lower.top", "Initial gap": gap, "Search distance": 1,
                                          "Friction": 0.3}),
        "Load steps": load_steps,
    }
    return {key: value for key, value in scene.items() if value}


def mindlin():
    runs = []
    for levels in (3, 4):
        runs.append(Run("PF-06", f"Mindlin in a box, {levels} levels", "friction-mindlin", [
            Quantity("P", 600, lambda s: s.pair("interface", 2)["force"][1], 1e-3),
            Quantity("Q", 90, lambda s: -s.pair("interface", 2)["force"][0], 1e-3),
            Quantity("p0", 374.43915, lambda s: s.pair("interface", 1)["max_pressure"], 1e-3),
            Quantity("q(0)", 32.965214, lambda s: abs(s.traction(0, 2)), 5e-3),
            Quantity("Q back", 0, lambda s: s.pair("interface", 3)["force"][0] / 90, 1e-3),
            Quantity("q(0) back", 2.787365, lambda s: abs(s.traction(0, 3)), 0.02),
            Quantity("a (half-plane)", 1.0211676, lambda s: s.pair("interface", 1)["area"] / 2, 0.01),
            Quantity("c (half-plane)", 0.7220745, lambda s: s.pair("interface", 2)["stick_area"] / 2, 0.01),
            Quantity("c back (half-plane)", 0.884357, lambda s: s.pair("interface", 3)["stick_area"] / 2, 0.01),
            Quantity("work of a cycle", 0.010594703, lambda s: s.work("interface", 2), 0.01)],
            {"Mesh/Refinement regions/contact/Levels": levels}, fields=True))
    return runs


def bulk_tension():
    """PF-07: as PF-06, while the lower block is stretched by 9.1e-5 (20 / E (1 - nu^2)) together with Q; its surface keeps its height."""
    shift = {"d": "0.01280281", "s": "max(t - 1, 0)"}
    stretched = {"base": {"Boundaries": "lower.bottom", "Displacement": "9.1e-5*x*s; 3.9e-5*20*s"},
                 "top": {"Boundaries": "upper.top", "Displacement": "0.002905292*s; -d*min(t, 1)"}}
    loads = named(right={"Boundaries": "lower.right", "Traction": "20*s; 0"}, left={"Boundaries": "lower.left", "Traction": "-20*s; 0"})
    runs = []
    for steps in (1, 4):
        scene = blocks("x^2/300", 3, named(**stretched), loads, numbered([1] + [1 + (n + 1) / steps for n in range(steps)]), shift)
        runs.append(Run("PF-07", f"bulk tension, {in_words(steps)}", scene, [
            Quantity("P", 600, lambda s: s.pair("interface")["force"][1], 2e-3),
            Quantity("Q", 90, lambda s: -s.pair("interface")["force"][0], 5e-3),
            Quantity("stick from", -0.6765745, lambda s: s.pair("interface")["stick_from"][0], 0.015),
            Quantity("stick to", 0.7675745, lambda s: s.pair("interface")["stick_to"][0], 0.015),
            Quantity("c", 0.7220745, lambda s: s.pair("interface")["stick_area"] / 2, 0.01)]))
    return runs


BY_FORCE = {"top": {"Boundaries": "upper.top", "Traction": "Q/40; -P/40 + 3*Q/800*x"}}  # through the middle of the contact, y = 0


def by_forces(load_steps, normal, tangential, gap="x^2/300", levels=3, zone=1.3):
    """Forces P and Q through the middle of the contact, as formulas of time."""
    return blocks(gap, levels, named(base={"Boundaries": "lower.bottom", "Displacement": "0; 0"}), named(**BY_FORCE), load_steps,
                  {"P": normal, "Q": tangential}, zone)


def together():
    """PF-08: P = 600 and Q = 90 in proportion: nothing slips, q = 0.15 p. Implicit steps slip at the edge of the contact that grows; what n
    exact ones give is known for forces (those of the box; displacements that belong to them are in the tables). The approach of the box is
    that of a line contact, t (A - B log t)."""
    tables = {1: ((1, 0.012802779, 0.002905260),), 2: ((0.5, 0.0070024044, 0.0015426433), (1, 0.012802779, 0.0029732907)),
              5: ((0.2, 0.0031193623, 0.00066477896), (0.4, 0.0057568547, 0.0012845609), (0.6, 0.0082128952, 0.0018807179),
                  (0.8, 0.0105514966, 0.0024606916), (1, 0.012802779, 0.0030285330))}
    base = {"base": {"Boundaries": "lower.bottom", "Displacement": "0; 0"}}
    moved = {**base, "top": {"Boundaries": "upper.top", "Displacement": "q; -d"}}
    limits = {1: 32.9626, 2: 38.36612, 5: 44.089, 20: 49.73706, "automatic": 56.0}
    line = {"log_t": "log(max(t, 1e-9))", "d": "t*(0.0128028 - 0.00173813*log_t)", "q": "t*(0.0030849 - 0.15*0.00173813*log_t)"}

    def rows(number):
        return [Quantity("P", 600, lambda s: s.pair("interface")["force"][1], 1e-3),
                Quantity("Q", 90, lambda s: -s.pair("interface")["force"][0], 2.5e-3),
                Quantity("q(0)", limits[number], lambda s: abs(s.traction(0, 1)), 0.03 if number == "automatic" else 5e-3)]

    runs = []
    for number in (1, 2, 5, "automatic"):
        definitions = line
        if number in tables:
            columns = {"d": 1, "q": 2}
            definitions = {name: "table(t, 0,0, " + ", ".join(f"{row[0]},{row[column]}" for row in tables[number]) + ")"
                           for name, column in columns.items()}
        scene = blocks("x^2/300", 3, named(**moved), None, {"Number": number}, definitions)
        runs.append(Run("PF-08", f"together, given motion, {in_words(number)}", scene, rows(number), fields=True,
                        slow=number == "automatic"))
    for number in (1, 5, 20, "automatic"):
        scene = by_forces({"Number": number}, "600*t", "90*t")
        runs.append(Run("PF-08", f"together, given forces, {in_words(number)}", scene, rows(number), fields=True,
                        slow=number in (20, "automatic")))
    platen = blocks("x^2/300", 3, named(**base), None, {"Number": 5}, {"P": "600*t", "Q": "90*t"})
    platen["Obstacles"] = named(platen={"Shape": "plane", "Point": "0,20", "Normal": "0,-1", "Displacement": "free; free",
                                        "Force": "Q; -P"})
    platen["Contact pairs"] = {**platen["Contact pairs"], "Names": "interface, head",
                               "head": {"Slave": "upper.top", "Master": "platen", "Separation": "none", "Friction": 100}}
    runs.append(Run("PF-08", "together, forces on a platen, 5 steps", platen, rows(5), fields=True))
    return runs


def rounded_half_width(load):
    """Of the contact of a flat half-width 1 with edges of radius 100 under a load: P = E*/R (a^2/2 acos(1/a) - sqrt(a^2 - 1)/2)."""
    low, high = 1.0, 10.0
    for _ in range(60):
        a = 0.5 * (low + high)
        low, high = (a, high) if 2e5 / 1.82 / 100 * (a * a / 2 * math.acos(1 / a) - math.sqrt(a * a - 1) / 2) < load else (low, a)
    return low


def rounded():
    """PF-12: a flat punch with rounded edges on an equal body, P = 500, then Q = 75."""
    runs = []
    for levels in (2, 3):
        scene = by_forces({"Times": "1, 2"}, "500*min(t, 1)", "75*max(t - 1, 0)", "max(0, abs(x) - 1)^2/200", levels, 1.8)
        runs.append(Run("PF-12", f"rounded punch, {levels} levels", scene, [
            Quantity("a", 1.5519079, lambda s: s.pair("interface")["area"] / 2, 0.01),
            Quantity("c", 1.3596781, lambda s: s.pair("interface")["stick_area"] / 2, 0.01),
            Quantity("largest pressure", 243.26688, lambda s: s.pair("interface")["max_pressure"], 0.03),
            Quantity("q(0)", 16.370906, lambda s: abs(s.traction(0, 2)), 0.02)], fields=True))
    return runs


def sphere():
    """PF-09: equal half-spaces of E = 1, nu = 0 (blocks of 20 a, half model), relative radius 1, mu = 0.4; references by the forces that
    result. The blocks are softer than half-spaces by a few percent."""
    def scene(levels):
        widths = [max(0.6 / 2**n, 0.13) for n in range(levels)]
        near = {f"near_{n}": {"Inside": f"if(max(max(abs(x), y), abs(z)) < {width!r}, 1, -1)", "Levels": 1}
                for n, width in enumerate(widths)}
        return {
            "Dimension": 3, "Title": "Mindlin's sphere", "Definitions": {"d": 0.0126, "q": "0.0019*table(t, 1,0, 2,1, 3,0.0568)"},
            "Bodies": named(lower=box("-1.2,0,-1.2 : 1.2,1.2,0", "6,3,3", 1, 0), upper=box("-1.2,0,0 : 1.2,1.2,1.2", "6,3,3", 1, 0)),
            "Mesh": {"Degree": 2, "Refinement regions": named(**near)},
            "Supports": named(base={"Boundaries": "lower.bottom", "Displacement": "0; 0; 0"},
                              top={"Boundaries": "upper.top", "Displacement": "q; 0; -d*min(t, 1)"},
                              middle={"Boundaries": "lower.front, upper.front", "Type": "symmetry"}),
            "Contact pairs": named(interface={"Slave": "upper.bottom", "Master": "lower.top", "Initial gap": "(x^2 + y^2)/2",
                                              "Search distance": 0.3, "Friction": 0.4}),
            "Contact method": {"Contact geometry": "reference"},
            "Load steps": {"Times": "1, 2, 3"},
        }

    def forces(s, time):
        force = s.pair("interface", time)["force"]
        return 2 * abs(force[2]), 2 * abs(force[0])

    def radius(s):
        return (0.75 * forces(s, 1)[0] / 0.5) ** (1 / 3)

    def stick(s):
        normal, tangential = forces(s, 2)
        return math.sqrt(s.pair("interface", 2)["stick_area"] / s.pair("interface", 2)["area"]) / (1 - tangential / 0.4 / normal) ** (1 / 3)

    def shift(s):
        normal, tangential = forces(s, 2)
        return 0.0019 / (3 * 0.4 * normal / (16 * radius(s) * 0.125) * (1 - (1 - tangential / 0.4 / normal) ** (2 / 3)))

    def peak(s):
        return s.pair("interface", 1)["max_pressure"] * 2 * math.pi * radius(s)**2 / 3 / forces(s, 1)[0]

    return [Run("PF-09", f"sphere, {levels} levels", scene(levels), [
                Quantity("P", 1e-3, lambda s: forces(s, 1)[0], 0.1), Quantity("Q", 2e-4, lambda s: forces(s, 2)[1], 0.1),
                Quantity("a / a(P)", 1, lambda s: math.sqrt(2 * s.pair("interface", 1)["area"] / math.pi) / radius(s), 0.01),
                Quantity("p0 / p0(P)", 1, peak, 0.01),
                Quantity("c/a / (c/a)(P, Q)", 1, stick, 0.01), Quantity("shift / shift(P, Q)", 1, shift, 0.05)], slow=levels > 3)
            for levels in (3, 4)]


# PF-10, 11: indentation with friction of a block of L x L (half model), of which nodes at the contact have a distance of size / 2^levels.


def indented(model, size, cells, regions, obstacle, load_steps, friction=0.3):
    middle = {} if model == "axisymmetric" else {"middle": {"Boundaries": "block.left", "Type": "symmetry"}}
    return {
        "Dimension": 2, "Model": model, "Title": "indentation with friction",
        "Bodies": named(block=box(f"0,{-size} : {size},0", f"{cells},{cells}", 1.0, 0.3)),
        "Mesh": {"Degree": 2, "Refinement regions": named(**regions)},
        "Obstacles": named(punch=obstacle),
        "Supports": named(base={"Boundaries": "block.bottom", "Displacement": "0; 0"}, **middle),
        "Contact pairs": named(foot={"Slave": "block.top", "Master": "punch", "Friction": friction}),
        "Load steps": load_steps,
    }


FLAT = {"Shape": "punch", "Normal": "0,-1", "Radius": 1, "Displacement": "0; -0.001*t"}


def parabola(depth):
    return {"Shape": "paraboloid", "Normal": "0,-1", "Radius": 1000, "Displacement": f"0; -{depth}*t"}


def ratio(s):
    """Half-width, or radius, of the stick zone over that of the contact."""
    share = s.pair("foot")["stick_area"] / s.pair("foot")["area"]
    return math.sqrt(share) if s.results["preflight"]["model"].startswith("axi") else share


def in_plane():
    runs = []
    for levels in (4, 6):
        for steps in (1, 4):
            regions = {**squares(0.0, 0.0, 4, 1.5, 3), **squares(1.0, 0.0, 0.5, 0.01, levels, "edge")}
            runs.append(Run("PF-10", f"flat punch, box, {levels} levels, {in_words(steps)}",
                            indented("plane strain", 10, 10, regions, FLAT, {"Number": steps}),
                            [Quantity("c/a (box)", 0.833, ratio, 0.01), Quantity("a", 1, lambda s: s.pair("foot")["area"], 0.005)]))
    regions = {**squares(0.0, 0.0, 1000, 1.5, 12), **squares(1.0, 0.0, 0.5, 0.01, 4, "edge")}
    runs.append(Run("PF-10", "flat punch, half-space", indented("plane strain", 2000, 10, regions, FLAT, {"Number": 1}),
                    [Quantity("c/a", 0.6890884, ratio, 0.015)]))
    for number, reference in ((1, 0.2963401), (5, 0.6890884), (20, 0.6890884), ("automatic", 0.6890884)):
        scene = indented("plane strain", 2000, 10, squares(0.0, 0.0, 1000, 1.5, 12), parabola(0.0065), {"Number": number})
        runs.append(Run("PF-10", f"cylinder, half-space, {in_words(number)}", scene, [Quantity("c/a", reference, ratio, 0.02)],
                        slow=number in (20, "automatic")))
    return runs


def axisymmetric():
    """PF-11. A body of 40 a is 2.04 % stiffer than a half-space, as it is without friction."""
    def force(s):
        return -s.pair("foot")["force"][1] / 1.0204

    runs = []
    for levels in (3, 5):
        regions = {**squares(0.0, 0.0, 20, 1.5, 6), **squares(1.0, 0.0, 0.4, 0.01, levels, "edge")}
        for friction, reference in ((0.3, 1.0242969), (0, 1)):
            rows = [Quantity("force / (2 a E* depth) / 1.0204", reference, lambda s: force(s) / (0.002 / 0.91), 2e-3)]
            if friction:
                rows.insert(0, Quantity("c/a", 0.8959472, ratio, 0.005))
            runs.append(Run("PF-11", f"flat punch, {levels} levels, friction {friction}",
                            indented("axisymmetric", 40, 10, regions, FLAT, {"Number": 1}, friction), rows))
    for number, reference in ((1, 0.5185449), (5, 0.8959472), (20, 0.8959472), ("automatic", 0.8959472)):
        rows = [Quantity("c/a", reference, ratio, 0.01)]
        if number != 1:
            rows.append(Quantity("force / 1.0204", 1.0442551538 * 4 / 3 / 0.91 / 1000, force, 2e-3))
        runs.append(Run("PF-11", f"sphere, {in_words(number)}",
                        indented("axisymmetric", 40, 10, squares(0.0, 0.0, 20, 1.3, 7), parabola(1.0194849e-3), {"Number": number}), rows))
    return runs


def full_turn(degrees):
    """PF-13: the rim is turned as a whole, by 360 degrees with finite strain: the torque stays that of slip (to delta/b = 0.2 %)."""
    turn = {"Deformation": "finite", "Definitions/phi": f"{degrees}/180*pi*max(t - 1, 0)",
            "Load steps/Times": ", ".join(f"{1 + n / 24:.10g}" for n in range(25)),
            "Supports/rim/Displacement": "cos(phi)*x*(1 + press*uc/r) - sin(phi)*y*(1 + press*uc/r) - x; "
                                         "sin(phi)*x*(1 + press*uc/r) + cos(phi)*y*(1 + press*uc/r) - y"}

    def torques(s):
        return [abs(step["pairs"]["fit"]["moment"][0]) for step in s.steps if step["time"] > 1.01]

    return Run("PF-13", f"shrink fit, turned by {degrees} degrees", "friction-ring", [
        Quantity("largest torque", 71701.61, lambda s: max(torques(s)), 5e-3),
        Quantity("least torque", 71701.61, lambda s: min(torques(s)), 5e-3)],
        turn, slow=True)


def fits():
    """PF-13, 14: shrink fit under torque and pull, as in the tests."""
    return [full_turn(360)] + [
        Run("PF-13", f"shrink fit under torque, mesh of {around}", "friction-ring", [
            Quantity("pressure", 84.53085, lambda s: s.pair("fit", 1)["normal_force"] / s.pair("fit", 1)["area"], 2e-4),
            Quantity("torque while slipping", 71701.61, lambda s: abs(s.pair("fit", 2)["moment"][0]), 5e-4),
            Quantity("torque, turned back", 24665.35, lambda s: s.pair("fit")["moment"][0], 2e-3),
            Quantity("slip", 30 * (3e-4 - 1.488095e-4), lambda s: s.pair("fit", 2)["max_slip_since_contact"], 2e-3),
            Quantity("work", 71701.61 * (3e-4 - 1.488095e-4), lambda s: s.pair("fit")["total_friction_work"], 1e-3)],
            {"Bodies/inner/Cells around": around, "Bodies/outer/Cells around": around * 4 // 3}) for around in (12, 24, 48)] + [
        Run("PF-14", "shrink fit under pull", "friction-pull", [
            Quantity("pressure", 76.92308, lambda s: s.pair("fit")["max_pressure"], 1e-5),
            Quantity("pull", 21749.49, lambda s: s.pair("fit")["friction_force"][1], 1e-5),
            Quantity("slip", 0.006 - 0.002807066, lambda s: s.pair("fit")["max_slip"], 1e-4),
            Quantity("pull before slip", 774812.1 * 0.002 * 10, lambda s: s.pair("fit", 2)["friction_force"][1], 1e-4)])]


def belt():
    """PF-15: a belt of thickness 0.8 over a quarter of a drum of radius 40; tension 20 at one end first without friction, then 26 at the
    other end, or a motion of that end until all slips. The references are estimates: those of a thin belt with the thickness at the mean
    line (2 % of the motion), and 0.0019 for the 0.63 of the belt that the first tension has pulled beyond the quarter, where it is free."""
    def scene(cells, supports, loads, times):
        return {
            "Dimension": 2, "Deformation": "finite", "Title": "belt on a drum",
            "Definitions": {"s": "min(max(t - 1, 0), 1)", "p": "min(t, 1)/0.8"},
            "Bodies": named(belt={"Mesh": "ring", "Inner radius": 40, "Outer radius": 40.8, "Part": "upper right quarter",
                                  "Cells around": cells, "Degree": 2, "Young's modulus": 2500, "Poisson's ratio": 0}),
            "Obstacles": named(drum={"Shape": "cylinder", "Center": "0,0", "Radius": 40}),
            "Supports": supports, "Loads": loads,
            "Contact pairs": named(wrap={"Slave": "belt.inner", "Master": "drum", "Friction": "if(t > 1 + 1e-6, 0.3, 0)"}),
            "Load steps": numbered(times),
            "Output": {"Probes": named(end={"Point": "40.4,0"})},
        }

    def motion(s):
        return s.probe("end")["displacement"][1] - s.probe("end", 1)["displacement"][1]

    runs = []
    for cells in (24, 48):
        partial = scene(cells, named(held={"Boundaries": "belt.symmetry_x", "Displacement": "0; free"}),
                        named(tight={"Boundaries": "belt.symmetry_y", "Traction": "0; -(20 + 6*s)*p"}), (0.5, 1, 1.5, 2))
        sliding = scene(cells, named(moved={"Boundaries": "belt.symmetry_y", "Displacement": "free; -0.4*s"}),
                        named(slack={"Boundaries": "belt.symmetry_x", "Traction": "-20*p; 0"}), (0.5, 1, 1.25, 1.5, 2))
        runs += [Run("PF-15", f"belt, {cells} cells, partial slip", partial, [
                     Quantity("slip angle", 50.609, lambda s: 90 - math.degrees(s.pair("wrap")["stick_area"] / 40), 0.02),
                     Quantity("motion of the end", -0.0531, motion, 0.02)]),
                 Run("PF-15", f"belt, {cells} cells, sliding", sliding, [
                     Quantity("tension", -31.8904, lambda s: s.steps[-1]["supports"]["moved"]["reaction"][1], 0.01),
                     Quantity("tension half-way", -31.8904, lambda s: s.at(1.5)["supports"]["moved"]["reaction"][1], 0.01)])]
    return runs


def plate():
    """PF-16: the plate of Raous."""
    points = {"A": 2.860232, "B": 2.722503, "C": 2.286765, "D": 1.980702, "E": 1.541348}
    def rows(cells):
        tolerance = 5e-4 * max(1, 32 / cells)**2
        return [*(Quantity(f"u_x {name} (1e-5)", value, lambda s, name=name: 1e5 * s.probe(name)["displacement"][0], tolerance)
                  for name, value in points.items()),
                Quantity("friction force", -1405473, lambda s: s.pair("foot")["friction_force"][0], tolerance)]

    return [Run("PF-16", f"plate, {cells} x {cells} cells, {in_words(steps)}", "friction-plate", rows(cells),
                {"Bodies/plate/Subdivisions": f"{cells},{cells}", "Load steps/Number": steps})
            for cells, steps in ((8, 1), (16, 1), (32, 1), (32, 5), (64, 1))]


def cylinder():
    """PF-17: NAFEMS contact benchmark 1 (half model), a cylinder of steel on a block of aluminium. By symmetry q(0) = 0."""
    def scene(levels, deformation, friction):
        return {
            "Dimension": 2, "Deformation": deformation, "Title": "cylinder on a block, NAFEMS",
            "Bodies": named(cylinder={"Mesh": "disc", "Center": "0,50", "Radius": 50, "Part": "right half", "Young's modulus": 210000,
                                      "Poisson's ratio": 0.3, "Law": "Saint Venant-Kirchhoff"},
                            block=box("0,-200 : 100,0", "8,16", 70000, 0.3, Law="Saint Venant-Kirchhoff")),
            "Mesh": {"Degree": 2, "Refinement regions": named(**squares(0.0, 0.0, 60, 12, levels))},
            "Supports": named(base={"Boundaries": "block.bottom", "Displacement": "0; 0"},
                              middle={"Boundaries": "cylinder.symmetry, block.left", "Type": "symmetry"}),
            "Loads": named(force={"Point": "0,100", "Force": "0; -17500*t"}),
            "Contact pairs": named(contact={"Slave": "block.top", "Master": "cylinder.arc", "Friction": friction}),
            "Load steps": {"Number": 5},
            "Output": {"Probes": named(B={"Body": "block", "Point": "0,0"})},
        }

    return [Run("PF-17", f"NAFEMS cylinder, {levels} levels", scene(levels, "finite", 0.1), [
                Quantity("u_y B", -1.302636, lambda s: s.probe("B")["displacement"][1], 0.01),
                Quantity("sigma_yy B", -3542.688, lambda s: s.probe("B")["stress"]["yy"], 0.01),
                Quantity("q(0) / (mu p0)", 0, lambda s: s.traction(0, 1) / 0.1 / s.pair("contact")["max_pressure"], 0.05)],
                fields=True) for levels in (4, 5)]


def skate():
    """PF-18: a block under N = 12000 on a plane turned by 30 degrees, pushed from the side with 0.99 and 1.01 mu N, the latter against a
    soft bar for a spring. Small motion: contact on undeformed surfaces."""
    turn = "x*cos(pi/6) - y*sin(pi/6); x*sin(pi/6) + y*cos(pi/6)"

    def scene(share, soft):
        bodies = {"skate": box("0,0 : 20,20", "8,8", 2.1e5, 0, Transformation=turn)}
        pairs = {"foot": {"Slave": "skate.bottom", "Master": "ground", "Friction": 0.3}}
        supports = {}
        if soft:
            bodies["bar"] = box("20,0 : 40,20", "8,8", 360, 0, Transformation=turn)
            supports = {"Supports": named(end={"Boundaries": "bar.right", "Displacement": "0; 0"})}
            pairs["side"] = {"Slave": "bar.left", "Master": "skate.right"}
        return {
            "Dimension": 2, "Title": "skate", "Bodies": named(**bodies),
            "Obstacles": named(ground={"Shape": "plane", "Point": "0,0", "Normal": "-0.5,sqrt(3)/2"}), **supports,
            "Loads": named(weight={"Boundaries": "skate.top", "Pressure": "600*min(t, 1)"},
                           push={"Boundaries": "skate.left", "Pressure": f"{share}*180*max(t - 1, 0)"}),
            "Contact pairs": named(**pairs), "Contact method": {"Contact geometry": "reference"}, "Load steps": {"Times": "1, 2"},
        }

    normal = Quantity("N", 12000, lambda s: s.pair("foot")["normal_force"], 1e-6)
    return [Run("PF-18", "skate, 0.99 mu N, sticks", scene(0.99, False), [
                normal, Quantity("friction force", 3564, lambda s: math.hypot(*s.pair("foot")["friction_force"]), 1e-6)]),
            Run("PF-18", "skate, 1.01 mu N, slides against a bar", scene(1.01, True), [
                normal, Quantity("friction force", 3600, lambda s: math.hypot(*s.pair("foot")["friction_force"]), 1e-6),
                Quantity("force of the bar", 36, lambda s: s.pair("side")["normal_force"], 1e-4)])]


def runs():
    cases = (patches, incline, bar, mindlin, bulk_tension, together, sphere, in_plane, axisymmetric, rounded, fits, belt, plate, cylinder,
             skate)
    return sorted((run for case in cases for run in case()), key=lambda run: run.case)
