# SPDX-License-Identifier: Apache-2.0
"""Friction: what load steps must follow, and what the verdict says of them if they do not."""

import math

from case import SCENES, VARIED, Case, number

LAYER = VARIED / "friction-layer.prm"


def warnings(results):
    return {check["check"] for check in results["verdict"]["checks"] if check["outcome"] == "warned"}


def layer(test, sets, method="Lagrange multiplier"):
    return test.results(LAYER, [*sets, f"Contact method/Method={method}"])


def ramp(end):
    """The ground moves after the layer has been pressed."""
    return f"Definitions/ground={end}*max(t-1,0)"


def falling(test):
    """A coefficient that falls with the slip: s = (U - 0.06)/0.28 follows from 50 (U - s) = 6 (0.5 - 6 s)."""
    sets = ["Contact pairs/foot/Friction=table(slip, 0,0.5, 0.06,0.14)"]
    end = 0.0685
    exact = 8 * 50 * (end - (end - 0.06) / 0.28)
    results = layer(test, [*sets, ramp(end), "Load steps/Number=automatic"])
    force = number(results, "pairs/foot/friction_force/0")
    test.print(f"force {force:.6g} for {exact:.6g}, {len(results['load_steps'])} load steps")
    test.check(abs(force / exact - 1) <= 0.02, f"the force is {force:.6g} instead of {exact:.6g}")
    results = layer(test, ["Contact pairs/foot/Friction=table(slip, 0,0.5, 0.2,0.1)", ramp(0.24)])
    test.check("friction coefficient within a load step" in warnings(results), "a coefficient of the past is not warned of")


def stick(test):
    """Where all points stick, the work of friction is rounding, which no load step makes more accurate."""
    for method in ("Lagrange multiplier", "penalty"):
        results = layer(test, [ramp(0.02), "Load steps/Number=automatic"], method)
        n, force = len(results["load_steps"]), number(results, "pairs/foot/friction_force/0")
        test.check(n <= 16 and "path error" not in warnings(results), f"{method}: {n} load steps, warned of {warnings(results)}")
        test.check(method == "penalty" or abs(force / 8 - 1) <= 1e-8, f"the force is {force:.10g} instead of 8")


def zero_pressure(test):
    """A layer that moves along the ground before it is pressed has not slipped, nor has the ground below it."""
    common = ["Definitions/pressed=table(t, 1,0, 2,1)", "Load steps/Times=1,2,3", "Contact pairs/foot/Friction=table(slip, 0,0.5, 0.009,0.1)"]
    for moving, sign in (("moved", -1), ("ground", 1)):
        for method in ("Lagrange multiplier", "penalty"):
            results = layer(test, [*common, f"Definitions/{moving}=table(t, 0,0, 1,0.04, 2,0.04, 3,0.06)"], method)
            force, normal = (number(results, f"pairs/foot/{entry}") for entry in ("friction_force/0", "normal_force"))
            test.check(abs(sign * force / 8 - 1) <= 2e-3 and abs(normal / 48 - 1) <= 2e-3,
                       f"{moving}, {method}: forces {force:.8g} and {normal:.8g} instead of {8 * sign} and 48")
            test.check(results["verdict"]["outcome"] != "failed", f"{moving}, {method}: the verdict is failed")


def detours(test):
    """Loads that return within a load step are warned of; those that advance at another speed are not."""
    check = "loads within a load step"
    for ground, detour in (("0.05*sin(2*pi*max(t-1,0))", True), ("0.05*sin(pi*max(t-1,0))", True), ("0.05*sin(pi/2*max(t-1,0))", False),
                           ("0.05*max(t-1,0)^3", False)):
        found = warnings(layer(test, [f"Definitions/ground={ground}"]))
        test.check((check in found) is detour, f"ground = {ground}: warned of {found}")


def grid(corner, size, cells, first):
    """Nodes and elements of a rectangle in the words of a deck."""
    n = [count + 1 for count in cells]
    nodes = [f"{first + i + n[0] * j}, {corner[0] + size[0] * i / cells[0]}, {corner[1] + size[1] * j / cells[1]}"
             for j in range(n[1]) for i in range(n[0])]
    quads = [[first + i + n[0] * j, first + i + 1 + n[0] * j, first + i + 1 + n[0] * (j + 1), first + i + n[0] * (j + 1)]
             for j in range(cells[1]) for i in range(cells[0])]
    return nodes, quads


def pieces(test):
    """Two pieces of one body touch each other from the start: self-contact is as the contact of two bodies."""
    (lower, cells), (upper, more) = grid((0, -2), (6, 2), (8, 2), 1), grid((1, 0), (2, 1), (3, 2), 101)
    elements = [f"{k + 1}, {', '.join(map(str, quad))}" for k, quad in enumerate(cells + more)]
    sides = {"BASE": [f"{k + 1}, S1" for k in range(8)], "PUSH": [f"{k + 1}, S3" for k in range(19, 22)],
             "JOINT": [f"{k + 1}, S3" for k in range(8, 16)] + [f"{k + 1}, S1" for k in range(16, 19)]}
    deck = ["*NODE", *lower, *upper, "*ELEMENT, TYPE=CPE4, ELSET=ALL", *elements]
    for name, faces in sides.items():
        deck += [f"*SURFACE, NAME={name}", *faces]
    test.write("pieces.inp", "\n".join(deck) + "\n")
    drive = """
subsection Supports
  set Names = base, push
  subsection base
    set Boundaries   = {base}
    set Displacement = 0; 0
  end
  subsection push
    set Boundaries   = {push}
    set Displacement = 0.5*max(t-1,0); -0.02*min(t,1)
  end
end
subsection Contact pairs
  set Names = joint
  subsection joint
    set Slave    = {slave}
    set Master   = {master}
    set Friction = 0.35
  end
end
subsection Load steps
  set Times = 1,2,3
end
"""
    material = "    set Young's modulus = 1000\n    set Poisson's ratio = 0\n"
    one = (f"set Dimension = 2\nset Deformation = finite\nsubsection Bodies\n  set Names = b\n  subsection b\n    set Mesh = file\n"
           f"    set File = pieces.inp\n    set Coinciding nodes = keep\n{material}  end\nend\n"
           + drive.format(base="b.BASE", push="b.PUSH", slave="b.JOINT", master="b.JOINT"))
    two = (f"set Dimension = 2\nset Deformation = finite\nsubsection Bodies\n  set Names = lower, upper\n  subsection lower\n"
           f"    set Corners = 0,-2 : 6,0\n    set Subdivisions = 8,2\n{material}  end\n  subsection upper\n"
           f"    set Corners = 1,0 : 3,1\n    set Subdivisions = 3,2\n{material}  end\nend\n"
           + drive.format(base="lower.bottom", push="upper.top", slave="upper.bottom", master="lower.top"))
    found = [[number(test.results(test.write(f"{name}.prm", text)), f"pairs/joint/{entry}")
              for entry in ("normal_force", "total_friction_work")] for name, text in (("one", one), ("two", two))]
    test.print(f"normal force and work {found[0]}, of two bodies {found[1]}")
    test.check(all(math.isclose(a, b, rel_tol=1e-6) and b > 0 for a, b in zip(*found)), f"{found[0]} instead of {found[1]}")


def newton_steps(results):
    return [step["newton_iterations"] for step in results["load_steps"]]


def bar(test):
    """Slip spreads along a thin bar in few steps on any mesh, and under reversed forces; the end moves as shear-lag theory says."""
    scene = VARIED / "friction-bar.prm"
    for cells in (200, 400):
        for method in ("Lagrange multiplier", "penalty", "Nitsche"):
            results = test.results(scene, [f"Bodies/bar/Subdivisions={cells},2", f"Contact method/Method={method}"])
            steps = newton_steps(results)
            moves = [number(results, f"load_steps/{n}/probes/end/displacement/0") for n in (1, 2, 3)]
            test.print(f"{method}, {cells} cells: {steps} Newton steps, moved by {moves}")
            test.check(max(steps) <= 12, f"{method}, {cells} cells: {steps} Newton steps")
            # The length of the zone where the tension enters the bar is about its thickness, 2 % of the length that slips.
            test.check(all(abs(move / wanted - 1) <= 0.01 for move, wanted in zip(moves, (0.09, -0.09, 0.09))),
                       f"{method}, {cells} cells: the end is moved by {moves} instead of 0.09, -0.09, 0.09")


def stack(test):
    """Near the limit beyond which bodies slide as a whole, few load steps are divided, and methods agree."""
    works = []
    for method in ("Lagrange multiplier", "penalty"):
        results = test.results(VARIED / "friction-stack.prm", [f"Contact method/Method={method}"])
        steps = newton_steps(results)
        works.append(number(results, "pairs/lower/total_friction_work"))
        test.print(f"{method}: {steps} Newton steps, work {works[-1]:.6g}")
        test.check(len(steps) <= 10 and sum(steps) <= 120, f"{method}: {steps} Newton steps")
    test.check(math.isclose(*works, rel_tol=2e-3), f"works of friction {works}")


def corner(test):
    """A point of two pairs that neither sticks nor opens slips: Newton's method ends, and methods agree."""
    forces = []
    for method in ("Lagrange multiplier", "augmented Lagrangian", "penalty"):
        results = test.results(VARIED / "friction-corner.prm", [f"Contact method/Method={method}"])
        steps = newton_steps(results)
        forces.append([number(results, f"pairs/{pair}/normal_force") for pair in ("g", "w")])
        test.print(f"{method}: {steps} Newton steps, forces {forces[-1]}")
        test.check(len(steps) == 5 and max(steps) <= (20 if method == "penalty" else 12), f"{method}: {steps} Newton steps")
    test.check(all(math.isclose(a, b, rel_tol=5e-3) for other in forces[1:] for a, b in zip(forces[0], other)), f"forces {forces}")


def rest(test):
    """Bodies at rest do not creep, and what does not slip sticks: loads that stay, then vanish, with all methods."""
    sets = ["Loads/pull/Traction=5*table(t, 1,0, 2,3, 12,3, 13,0); 0", "Load steps/Times=1,2,3,4,5,6,7,8,9,10,11,12,13"]
    for name, theta in (("Lagrange multiplier", 1), ("penalty", 1), ("Nitsche", 1), ("Nitsche", 0), ("Nitsche", -1)):
        results = test.results(VARIED / "friction-bar.prm", [*sets, f"Contact method/Method={name}", f"Contact method/Nitsche/Theta={theta}"])
        first, last = (number(results, f"load_steps/{n}/probes/end/displacement/0") for n in (1, 11))
        still = max(number(results, f"load_steps/{n}/pairs/foot/slip_area") for n in range(2, 12))
        back = number(results, "pairs/foot/slip_area")
        test.print(f"{name}, theta {theta}: moved by {first:.10g}, later {last:.10g}, slip area at rest {still}, after the force {back}")
        test.check(math.isclose(first, last, rel_tol=1e-7) and still == 0, f"{name}, theta {theta}: {first} becomes {last}, slip area {still}")
        # Without the force slip returns over half of the length.
        test.check(abs(back / 6 - 1) <= 0.06, f"{name}, theta {theta}: slip returns over {back} instead of 6")


def rotation(test):
    """Rotations whose square is not small beside the strains are warned of at small strain."""
    scene = SCENES / "friction-turn-bodies.prm"
    sets = ["Supports/hub/Displacement=(cos(0.05*t)-1)*x-sin(0.05*t)*y; sin(0.05*t)*x+(cos(0.05*t)-1)*y", "Contact method/Contact geometry=updated"]
    small, finite = (warnings(test.results(scene, [*sets, f"Deformation={model}"])) for model in ("small", "finite"))
    for check in ("rotation / strain", "rotation / friction"):
        test.check(check in small and check not in finite, f"warned of {small} and {finite}")


def work(test):
    """In one load step work is exact: pressure and slip that grow together, and pressure that is there before. The slip is 0.2 - 0.06."""
    full = 8 * 3 * 0.14
    for what, pressed, ground, times, exact in (("together", "min(t,1)", "0.2*t", "1", full / 2), ("from the start", "1", "0.2*t", "1", full),
                                                ("before", "min(t,1)", "0.2*max(t-1,0)", "1,2", full)):
        for method in ("Lagrange multiplier", "penalty", "Nitsche"):
            results = layer(test, [f"Definitions/pressed={pressed}", f"Definitions/ground={ground}", f"Load steps/Times={times}"], method)
            found = number(results, "pairs/foot/total_friction_work")
            test.check(math.isclose(found, exact, rel_tol=1e-3), f"pressed {what}, {method}: the work is {found:.6g} instead of {exact:.6g}")


def cases():
    for body in (bar, corner, rest, stack):
        yield Case("friction/newton", body.__name__, body)
    yield Case("friction/steps", "rotation", rotation)
    for body in (falling, stick, zero_pressure, detours, pieces, work):
        yield Case("friction/steps", body.__name__.replace("_", "-"), body)
